//! Curves of one contact: force and state against indentation, in and out, and in a fall.

use contact_plots::{
    DropCurve, DropEnd, DropFigure, ForceCurves, ForceFigure, LoopCurve, LoopFigure, StateCurve, StateFigure,
};
use osim_inspect::series::{
    self, Body, DropSeries, ForceSeries, IndentationUnit, LoopSeries, SphereKind, Units,
};
use osim_model::files::Failure;
use osim_model::messages::Phrase;
use osim_requests::DropHeight;

use crate::figures::axes::{failure, force_axis, hertz_limit, indentation_axis, thresholds, title};

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

// Force while a sphere goes in and out.

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

// Contact state against indentation.

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

// Force in a fall.

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
