//! Force in a fall.

use contact_plots::{DropCurve, DropFigure};
use osim_inspect::DropHeight;
use osim_inspect::series::{self, Body, DropSeries};
use osim_model::files::Failure;

use super::names::title;

/// Force over body weight of bodies that fall from `height`, for `duration_s` (`None`: 20 √(R/g) of the slowest).
///
/// # Errors
/// What a body weighs is not known, or its contacts are so stiff that it cannot be followed.
pub fn drops(
    bodies: &[Body],
    height: DropHeight,
    duration_s: Option<f64>,
    wanted_title: Option<&str>,
) -> Result<DropFigure, Failure> {
    let duration_s = match duration_s {
        Some(duration_s) => duration_s,
        None => series::duration(bodies)?,
    };
    let falls = bodies.iter().map(|body| series::fall(body, height, duration_s).map(curve));
    Ok(DropFigure {
        title: title("Drop test", bodies, wanted_title),
        conditions: format!("They fall from {}.", height.describe("m", "sphere radii")),
        bodies: falls.collect::<Result<_, _>>()?,
    })
}

fn curve(series: DropSeries) -> DropCurve {
    DropCurve { name: series.name, points: series.points, time_unit_s: series.time_unit_s }
}
