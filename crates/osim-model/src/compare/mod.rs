//! Compares two OpenSim models: the scale factors of their bodies, whether one model is a scaled copy of the other, and the right places of
//! the contact spheres in a scaled model.
//!
//! OpenSim's scaling leaves `ContactSphere` radius and location as they were. [`Factors`] gives the growth of each body, [`Follow`] the
//! right places of its spheres, and [`SpherePlacements`] checks the present places.
//!
//! ```
//! use std::collections::BTreeMap;
//! use osim_model::compare::Factors;
//! use osim_model::{Anatomy, Model};
//!
//! let bytes: &[u8] = include_bytes!("../../tests/data/one_foot.osim");
//! let anatomy = Anatomy::of(&Model::parse(bytes)?)?;
//! let given = BTreeMap::from([("foot_r".to_owned(), [1.2, 1.1, 1.0])]);
//! let factors = Factors::find(&anatomy, &anatomy, None, &given)?;
//! assert_eq!(factors.body_factors("foot_r")?, [1.2, 1.1, 1.0]);
//! # Ok::<(), osim_model::Fault>(())
//! ```
//!
//! # What it will not do
//!
//! This module makes plans and changes nothing. It knows no files, no options and no terminal.

mod follow;
mod similarity;
mod sphere_placements;

pub use follow::{
    AxisFactor, BodyFactors, CopyDifference, FactorSource, Factors, Follow, FollowRequest, FollowedSphere,
    OwnRadii, ScaleFile, bone_of_mesh,
};
pub use similarity::{
    ComparedFactors, LengthFrom, ModelSize, Similarity, SimilarityRow, SizeRatios, SizeVerdict, Spread,
    moco_bounds, refuse_without_moco_phase, similarity_formula,
};
pub use sphere_placements::{PlacedSphere, SpherePlacements, is_stretched};
