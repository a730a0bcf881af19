//! Force in a fall.

use contact_plots::{DropCurve, DropEnd, DropFigure};
use osim_inspect::series::{self, Body, DropSeries};
use osim_model::files::Failure;
use osim_requests::DropHeight;

use super::names::title;

/// How much longer than until all are at rest a fall is drawn, if no duration is given.
const AFTER_REST: f64 = 1.15;

/// Force over body weight of bodies that fall from `height`, for `duration_s`. Without it they are followed for 20 √(R/g) of the
/// slowest, and the figure ends soon after all are at rest.
///
/// # Errors
/// What a body weighs is not known, or its contacts are so stiff that it cannot be followed.
pub fn drops(
    bodies: &[Body],
    height: DropHeight,
    duration_s: Option<f64>,
    wanted_title: Option<&str>,
) -> Result<DropFigure, Failure> {
    let followed_s = match duration_s {
        Some(duration_s) => duration_s,
        None => series::duration(bodies)?,
    };
    let falls = bodies.iter().map(|body| series::fall(body, height, followed_s));
    let falls: Vec<DropSeries> = falls.collect::<Result<_, _>>()?;
    let at_rest = |unit: &dyn Fn(&DropSeries) -> f64| {
        AFTER_REST * falls.iter().map(|fall| fall.settled_s / unit(fall)).fold(0.0, f64::max)
    };
    let shown = DropEnd { seconds: at_rest(&|_| 1.0), dimensionless: at_rest(&|fall| fall.time_unit_s) };
    let is_earlier = shown.seconds > 0.0 && shown.seconds < followed_s;
    Ok(DropFigure {
        title: title("Drop test", bodies, wanted_title),
        conditions: format!("They fall from {}.", height.describe("m", "sphere radii")),
        shown: (duration_s.is_none() && is_earlier).then_some(shown),
        bodies: falls.into_iter().map(curve).collect(),
    })
}

fn curve(series: DropSeries) -> DropCurve {
    let DropSeries { name, points, time_unit_s, .. } = series;
    DropCurve { name, points, time_unit_s }
}
