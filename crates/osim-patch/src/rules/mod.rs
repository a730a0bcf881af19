//! Rules about changes: a file for each.

pub(crate) mod already_at_target;
pub(crate) mod composite_surfaces;
pub(crate) mod factor_spread;
pub(crate) mod friction_not_similar;
pub(crate) mod nothing_to_change;
pub(crate) mod reference_without_smoothing;

use osim_model::Rule;

/// The rules of this crate.
pub const RULES: &[&Rule] = &[
    &already_at_target::RULE,
    &composite_surfaces::RULE,
    &factor_spread::RULE,
    &friction_not_similar::RULE,
    &nothing_to_change::RULE,
    &reference_without_smoothing::RULE,
];
