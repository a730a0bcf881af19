//! Force while a sphere goes in and out.

use contact_plots::{LoopCurve, LoopFigure};
use osim_inspect::series::{self, Body, LoopSeries, SphereKind, Units};
use osim_model::files::Failure;
use osim_requests::DropHeight;

use super::axes::{force_axis, indentation_axis};
use super::limits::hertz_limit;
use super::names::title;

/// Force against indentation while spheres go in and out: one contact at a quarter, half and all of the speed of a fall from
/// `height`, beside its force at rest; several contacts each at that speed.
///
/// # Errors
/// What a body weighs is not known.
pub fn loops(
    bodies: &[Body],
    units: Units,
    height: DropHeight,
    wanted_title: Option<&str>,
) -> Result<LoopFigure, Failure> {
    let mut loops = Vec::new();
    let mut elastic = Vec::new();
    let only = series::kinds(bodies).count() == 1;
    for (body, kind) in series::kinds(bodies) {
        if !only {
            loops.push(named(
                &series::name_of(body, kind, bodies.len() == 1),
                impact(body, kind, units, height)?,
            ));
            continue;
        }
        let speed = series::impact_speed(body, kind, height)?;
        elastic = series::elastic(body, kind, units)?;
        for share in [0.25, 0.5, 1.0] {
            loops.push(named("", series::hysteresis(body, kind, units, share * speed)?));
        }
    }
    let from = height.describe("m", "R");
    let motion = format!(
        "Half a sine wave, as deep as twice the body weight presses by the Hertz law; it begins with the speed in the \
         legend, the largest of them that of a fall from {from}. The restitution is that of a free impact at that \
         speed, by the exact law."
    );
    Ok(LoopFigure { elastic, ..figure(title("Dissipation", bodies, wanted_title), motion, units, loops) })
}

/// Force against indentation while each kind of sphere of `bodies` goes in and out, beginning with the speed of a fall from
/// `height`. Names of bodies are there only where there are several.
///
/// # Errors
/// What a body weighs is not known.
pub fn impact_loops(
    bodies: &[Body],
    units: Units,
    height: DropHeight,
    wanted_title: Option<&str>,
) -> Result<LoopFigure, Failure> {
    let mut loops = Vec::new();
    for (body, kind) in series::kinds(bodies) {
        // One curve of one model needs no name.
        let named_alone = bodies.len() == 1 && kind.spheres.is_empty();
        let name = if named_alone { String::new() } else { series::name_of(body, kind, bodies.len() == 1) };
        loops.push(named(&name, impact(body, kind, units, height)?));
    }
    let from = match height {
        DropHeight::Radii(0.25) => "a quarter of the radius".to_owned(),
        other => other.describe("m", "R"),
    };
    let motion = format!(
        "Half a sine wave, as deep as twice the body weight presses by the Hertz law; it begins with the speed of a fall \
         from {from}."
    );
    Ok(figure(title("Dissipation", bodies, wanted_title), motion, units, loops))
}

fn figure(title: String, motion: String, units: Units, loops: Vec<LoopCurve>) -> LoopFigure {
    LoopFigure {
        title,
        motion,
        indentation: indentation_axis(units),
        force: force_axis(units),
        elastic: vec![],
        loops,
        limits: hertz_limit(units),
    }
}

/// The loop that begins with the speed of a fall.
fn impact(body: &Body, kind: &SphereKind, units: Units, height: DropHeight) -> Result<LoopSeries, Failure> {
    series::hysteresis(body, kind, units, series::impact_speed(body, kind, height)?)
}

fn named(name: &str, series: LoopSeries) -> LoopCurve {
    let name = if name.is_empty() { series.name } else { format!("{name}: {}", series.name) };
    LoopCurve { name, points: series.points }
}
