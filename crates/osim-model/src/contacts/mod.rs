//! Contact spheres and contact forces: every spelling of them becomes the same typed values.

mod force;
mod half_space;
mod ids;
mod read;
mod slot;
mod sphere;

pub use force::{Force, ForceKind, ParameterSet};
pub use half_space::HalfSpace;
pub use ids::{ForceId, SetId, SphereId};
pub(crate) use read::ContactReader;
pub use slot::Slot;
pub use sphere::Sphere;
