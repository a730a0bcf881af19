//! Force against indentation.

use contact_plots::{ForceCurves, ForceFigure};
use osim_inspect::series::{self, Body, ForceSeries, IndentationUnit, Units};
use osim_model::files::Failure;

use super::axes::{force_axis, indentation_axis};
use super::limits::hertz_limit;
use super::names::title;

/// A vertical axis ends at this many times the weight's share of one sphere if curves go further: running animals push this hard,
/// and what happens at rest can still be seen.
const SHARES_SHOWN: f64 = 3.0;

/// Force against indentation of every kind of sphere of `bodies`. `limits` of the horizontal axis say from where to where;
/// without them from above the ground to a little more than where the bodies rest, and no deeper than a sphere's centre.
///
/// # Errors
/// In shares of the weight: what a body weighs is not known.
pub fn force(
    bodies: &[Body],
    units: Units,
    limits: Option<(f64, f64)>,
    wanted_title: Option<&str>,
) -> Result<ForceFigure, Failure> {
    let mut drawn = Vec::new();
    for (body, kind) in series::kinds(bodies) {
        let radius_m = kind.radius_m;
        let (from_m, to_m) = match limits {
            Some((from, to)) => (units.metres(from, radius_m), units.metres(to, radius_m)),
            None => {
                let (from, to) = series::reach(bodies);
                (from * radius_m, to * radius_m)
            }
        };
        let series = series::force(body, kind, units, (from_m, to_m))?;
        let name = series::name_of(body, kind, bodies.len() == 1);
        let outside = series.rest.map(|(x, _)| x).filter(|x| *x > units.x(to_m, radius_m));
        let remark = outside.map(|x| format!("rests at {}, outside the figure", rest_text(x, units)));
        drawn.push(ForceCurves { remark: remark.unwrap_or_default(), ..curves(name, series) });
    }
    Ok(ForceFigure {
        title: title("Contact force", bodies, wanted_title),
        indentation: indentation_axis(units),
        force: force_axis(units),
        top: limits.is_none().then(|| top(&drawn)).flatten(),
        bodies: drawn,
        limits: hertz_limit(units),
    })
}

/// Where the vertical axis ends, if the curves go much further than where the bodies rest.
fn top(drawn: &[ForceCurves]) -> Option<f64> {
    let rests: Option<Vec<f64>> = drawn.iter().map(|one| one.rest.map(|(_, force)| force)).collect();
    let top = SHARES_SHOWN * rests?.into_iter().fold(0.0, f64::max);
    let highest = drawn.iter().flat_map(|one| one.hertz.iter().chain(&one.own));
    let highest = highest.fold(0.0_f64, |most, (_, force)| most.max(*force));
    (highest > top && top > 0.0).then_some(top)
}

/// An indentation with its unit.
fn rest_text(x: f64, units: Units) -> String {
    match units.indentation {
        IndentationUnit::Relative => format!("x̂ = {x:.2}"),
        IndentationUnit::Millimetre => format!("{x:.1} mm"),
    }
}

pub(super) fn curves(name: String, series: ForceSeries) -> ForceCurves {
    let ForceSeries { hertz, with_constant, own, rest } = series;
    ForceCurves { name, hertz, with_constant, own, rest, remark: String::new() }
}
