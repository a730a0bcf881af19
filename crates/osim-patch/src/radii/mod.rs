//! New radii of the moving spheres, and what follows from them for a force.

mod rule;
mod spheres;
mod users;

pub use rule::RadiusRule;
pub(crate) use rule::SphereRule;
pub use spheres::moving_spheres;
pub(crate) use spheres::{Radii, root_mean_square};
pub(crate) use users::Users;
