//! What all panels of a foot measure with.

use contact_plots::{Direction, Limit};
use contact_scaling::limits;
use osim_model::feet::dot;
use osim_motion::{FootSummary, Wrench};
use osim_planning::MotionResult;

/// The normal of the foot's floor.
pub(super) fn normal(result: &MotionResult, foot: &FootSummary) -> [f64; 3] {
    let first = foot.foot.pairs.first().and_then(|&pair| result.states.frame(0).get(pair));
    first.map_or([0.0, 1.0, 0.0], |state| state.normal)
}

/// The part of a force along that normal, body weights.
pub(super) fn along_normal(result: &MotionResult, foot: &FootSummary, wrench: &Wrench) -> f64 {
    dot(wrench.force_n, normal(result, foot)) / result.summary.weight_n
}

/// How deep the Hertz law holds.
pub(super) fn hertz_limit() -> Limit {
    Limit { label: "Hertz".to_owned(), at: limits::INDENTATION.value, direction: Direction::Horizontal }
}
