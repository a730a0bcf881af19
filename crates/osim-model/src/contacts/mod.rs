//! Contact spheres and contact forces: every spelling of them becomes the same typed values.

mod force;
mod ids;
mod read;
mod slot;
mod sphere;

pub use force::{Force, ForceKind, ParameterSet};
pub use ids::{ForceId, SetId, SphereId};
pub(crate) use read::ContactReader;
pub use slot::Slot;
pub use sphere::Sphere;
