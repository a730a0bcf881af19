//! Rules about a model beside another one, or beside published ones: a file for each.

pub(crate) mod factors_disagree;
pub(crate) mod not_a_scaled_copy;
pub(crate) mod spheres_left_behind;
pub(crate) mod spheres_misplaced;
pub(crate) mod spheres_not_compared;

use crate::model::Rule;

/// The rules of this crate.
pub const RULES: &[&Rule] = &[
    &factors_disagree::RULE,
    &not_a_scaled_copy::RULE,
    &spheres_left_behind::RULE,
    &spheres_misplaced::RULE,
    &spheres_not_compared::RULE,
];
