//! Contact state against indentation.

use contact_plots::{StateCurve, StateFigure};
use osim_inspect::series::{self, Body, Units};
use osim_model::files::Failure;
use osim_model::messages::Phrase;

use super::axes::indentation_axis;
use super::limits::thresholds;
use super::names::{failure, title};

/// Contact state against indentation of every kind of sphere of `bodies`, half a radius to either side unless the horizontal
/// axis has `limits`.
///
/// # Errors
/// No body has a smoothed law.
pub fn state(
    bodies: &[Body],
    units: Units,
    limits: Option<(f64, f64)>,
    wanted_title: Option<&str>,
) -> Result<StateFigure, Failure> {
    let mut curves = Vec::new();
    let mut marked = Vec::new();
    for (body, kind) in series::kinds(bodies) {
        let metres = |(from, to)| (units.metres(from, kind.radius_m), units.metres(to, kind.radius_m));
        if let Some(points) = series::state(body, kind, units, limits.map(metres))? {
            let name = series::name_of(body, kind, bodies.len() == 1);
            curves.push(StateCurve { name, points });
        }
        marked = thresholds(kind, units);
    }
    if curves.is_empty() {
        let why = "a HuntCrossleyForce has no contact state to draw: there, contact is a step; `plot kind=force` shows \
                   its law";
        return Err(failure(bodies, Phrase::template(why)));
    }
    // Thresholds are a contact's own; several would be too many lines.
    if curves.len() > 1 {
        marked.clear();
    }
    Ok(StateFigure {
        title: title("Contact state", bodies, wanted_title),
        indentation: indentation_axis(units),
        bodies: curves,
        limits: marked,
    })
}
