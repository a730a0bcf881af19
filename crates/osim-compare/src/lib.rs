//! Two OpenSim models compared: scale factors between their bodies, whether one is a scaled copy of the other, and where the
//! contact spheres of a scaled model belong.
//!
//! OpenSim's scaling leaves `ContactSphere` radius and location as they were. [`Factors`] says how much each body grew,
//! [`Follow`] where spheres then belong, [`Placement`] whether they are there.
//!
//! # What it will not do
//!
//! It plans and changes nothing, and knows no files, no options and no terminal.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod follow;
mod placement;
mod rules;
mod similarity;

pub use follow::{
    AxisFactor, BodyFactors, Difference, FactorSource, Factors, Follow, FollowRequest, Followed, OwnRadii,
    ScaleFile, SphereBodies, bone_of_mesh,
};
pub use placement::{Evidence, LayoutAnswer, PlacedSphere, Placement, Reach, is_stretched};
pub use rules::RULES;
pub use similarity::{
    ComparedFactors, LengthFrom, ModelSize, Similarity, SimilarityRow, SizeRatios, SizeVerdict, Spread,
    formula, moco_bounds, refuse_without_moco_phase,
};

/// The example of the README compiles.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
