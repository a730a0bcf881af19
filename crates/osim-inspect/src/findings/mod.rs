//! Checks whether contacts are right: findings, and the requests that correct them.

mod check;
mod check_result;
mod effects;
mod finding;
mod remedy;

pub use check::{all_findings, check_model, check_without_remedies};
pub use check_result::{
    CheckResult, ConsistencyRecord, CorrectedErrorRecord, Counts, JointMomentsRecord, ResidualRecord,
    RootResidualRecord, sort_findings,
};
pub use effects::without_effects;
pub use finding::{FindingIndex, FindingWithRemedy};
pub use remedy::ChangeableValues;
pub(crate) use remedy::{
    Remedies, constant_indentation_for_touching, exact_pattern, rounded_mass, transition_width_for,
};
