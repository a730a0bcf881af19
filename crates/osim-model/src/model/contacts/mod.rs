//! Contact spheres and contact forces: every spelling of them becomes the same typed values.

mod force;
mod half_space;
mod ids;
mod loaded_sphere;
mod moving;
mod orientation;
mod planes;
mod read;
mod slot;
mod sphere;
mod surfaces;

pub use force::{Force, ForceKind, ParameterSet};
pub use half_space::{FrameProperty, HalfSpace};
pub use ids::{ForceId, SetId, SphereId};
pub use loaded_sphere::{LoadedSphere, contact_of_pair, contact_of_set, loaded_spheres};
pub use moving::{moving_spheres, root_mean_square};
pub use orientation::Orientation;
pub(crate) use read::ContactReader;
pub use slot::Slot;
pub use sphere::Sphere;
pub use surfaces::{Surfaces, sphere_sets};
