//! Contacts that follow a body which OpenSim has scaled: what its bones say about the factors, and where its spheres
//! belong.
//!
//! OpenSim's scaling leaves `ContactSphere` radius and location as they were. Comparing the scaled model with the generic
//! one it came from gives each body's factors ([`Factors`]); spheres of the same name then move and grow with their body
//! ([`Follow`]).

mod factors;
mod spheres;

pub use factors::{AxisFactor, BodyFactors, FactorSource, Factors, ScaleFile};
pub use spheres::{Follow, FollowRequest, Followed, MovedSpheres, RadiusAxis};
