//! Force against indentation.

use contact_plots::{ForceCurves, ForceFigure};
use osim_inspect::series::{self, Body, ForceSeries, Units};
use osim_model::files::Failure;

use super::axes::{force_axis, indentation_axis};
use super::limits::hertz_limit;
use super::names::title;

/// Force against indentation of every kind of sphere of `bodies`, from half a radius above the ground to a little more than
/// where they rest.
///
/// # Errors
/// In shares of the weight: what a body weighs is not known.
pub fn force(bodies: &[Body], units: Units, wanted_title: Option<&str>) -> Result<ForceFigure, Failure> {
    let depth = series::depth(bodies);
    let series = series::kinds(bodies).map(|(body, kind)| series::force(body, kind, units, depth));
    Ok(ForceFigure {
        title: title("Contact force", bodies, wanted_title),
        indentation: indentation_axis(units),
        force: force_axis(units),
        bodies: series.map(|one| one.map(curves)).collect::<Result<_, _>>()?,
        limits: hertz_limit(units),
    })
}

pub(super) fn curves(series: ForceSeries) -> ForceCurves {
    let ForceSeries { name, hertz, with_constant, own, rest } = series;
    ForceCurves { name, hertz, with_constant, own, rest }
}
