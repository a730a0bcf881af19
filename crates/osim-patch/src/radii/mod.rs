//! New radii of the moving spheres, and what follows from them for a force.

mod rule;
mod spheres;
mod users;

pub(crate) use rule::SphereRule;
pub(crate) use spheres::Radii;
pub(crate) use users::Users;
