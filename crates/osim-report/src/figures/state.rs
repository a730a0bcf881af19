//! Contact state against indentation.

use contact_plots::{StateCurve, StateFigure};
use osim_inspect::series::{self, Body, StateSeries, Units};
use osim_model::files::Failure;
use osim_model::wording::Phrase;

use super::axes::indentation_axis;
use super::limits::thresholds;
use super::names::{failure, title};

/// Contact state against indentation of every kind of sphere of `bodies`, half a radius to either side.
///
/// # Errors
/// No body has a smoothed law.
pub fn state(bodies: &[Body], units: Units, wanted_title: Option<&str>) -> Result<StateFigure, Failure> {
    let mut curves = Vec::new();
    let mut limits = Vec::new();
    for (body, kind) in series::kinds(bodies) {
        curves.extend(series::state(body, kind, units)?.map(curve));
        limits = thresholds(kind, units);
    }
    if curves.is_empty() {
        let why = "a HuntCrossleyForce has no contact state to draw: there, contact is a step; `plot kind=force` shows \
                   its law";
        return Err(failure(bodies, Phrase::template(why)));
    }
    // Thresholds are a contact's own; several would be a forest of lines.
    if curves.len() > 1 {
        limits.clear();
    }
    Ok(StateFigure {
        title: title("Contact state", bodies, wanted_title),
        indentation: indentation_axis(units),
        bodies: curves,
        limits,
    })
}

pub(super) fn curve(series: StateSeries) -> StateCurve {
    StateCurve { name: series.name, points: series.points }
}
