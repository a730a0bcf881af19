//! What a plan makes of one property, if it is the same everywhere.

use osim_model::Property;
use osim_patch::{Change, Plan};

/// Quotients of new and old values that differ by less than this (relative) differ by rounding only.
const ROUNDING: f64 = 1e-12;

/// Old value, new value and factor of a property.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Changed {
    /// The old value, if all that change had the same.
    pub(super) from: Option<f64>,
    /// The new value, if all that change get the same.
    pub(super) to: Option<f64>,
    /// New over old, if it is the same everywhere.
    pub(super) factor: Option<f64>,
    /// Whether the factor is not the same everywhere.
    pub(super) unequal: bool,
}

impl Changed {
    pub(super) fn of(plan: &Plan, property: Property) -> Self {
        let changes: Vec<&Change> =
            plan.changes.iter().filter(|change| change.property == property).collect();
        let Some(first) = changes.first() else { return Self::default() };
        let common = |value: fn(&Change) -> f64| {
            let first = value(first);
            changes.iter().all(|change| value(change) == first).then_some(first)
        };
        let factor = common_factor(&changes);
        Self {
            from: common(|change| change.from),
            to: common(|change| change.to),
            factor,
            unequal: factor.is_none(),
        }
    }
}

fn common_factor(changes: &[&Change]) -> Option<f64> {
    let factor = |change: &Change| change.factor.unwrap_or(change.to / change.from);
    let first = factor(changes.first()?);
    // A value that was 0 has no factor.
    let same = |change: &&Change| (factor(change) - first).abs() <= ROUNDING * first.abs();
    (first.is_finite() && changes.iter().all(same)).then_some(first)
}
