//! Lines where a law ends, and where contact begins.

use contact_plots::{Direction, Limit};
use contact_scaling::limits;
use osim_inspect::series::{self, IndentationUnit, SphereKind, Units};

/// The limit of the Hertz law, where the axis can show it for all bodies.
pub(super) fn hertz_limit(units: Units) -> Vec<Limit> {
    match units.indentation {
        IndentationUnit::Relative => vec![Limit {
            label: format!("x̂ = {}", limits::INDENTATION.value),
            at: limits::INDENTATION.value,
            direction: Direction::Vertical,
        }],
        // It is another length for each radius.
        IndentationUnit::Millimetre => vec![],
    }
}

/// Where the contact state is t and 1 − t (C.6).
pub(super) fn thresholds(kind: &SphereKind, units: Units) -> Vec<Limit> {
    let limit = |(state, at): (f64, f64)| Limit {
        label: format!("state {state}"),
        at,
        direction: Direction::Vertical,
    };
    series::thresholds(kind, units).into_iter().map(limit).collect()
}
