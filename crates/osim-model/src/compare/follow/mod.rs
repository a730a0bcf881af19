//! Contacts that follow a body which OpenSim has scaled: what its bones say about the factors, and where its spheres
//! belong.
//!
//! OpenSim's scaling leaves `ContactSphere` radius and location as they were. Comparing the scaled model with the generic
//! one it came from gives each body's factors ([`Factors`]); spheres of the same name then move and grow with their body
//! ([`Follow`]).

mod body_factors;
mod bones;
mod copy;
mod different;
mod distance;
mod factors;
mod scale_file;
mod sources;
mod sphere_bodies;
mod spheres;

pub use body_factors::{AxisFactor, BodyFactors, FactorSource};
pub use bones::bone_of_mesh;
pub use copy::Difference;
pub use factors::Factors;
pub use scale_file::ScaleFile;
pub use sphere_bodies::SphereBodies;
pub use spheres::{Follow, FollowRequest, Followed, OwnRadii};
