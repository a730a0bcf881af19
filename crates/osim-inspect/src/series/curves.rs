//! Points of curves, computed by the library of equations: the only place where a body becomes a figure's data.

use contact_scaling::drop_test::{DropReport, DropTest, DropValues, Sample};
use contact_scaling::{Law, Spheres, equilibrium, limits, restitution, smoothing};
use osim_model::files::Failure;
use osim_requests::DropHeight;

use crate::series::body::{Body, SphereKind, Weight};
use crate::series::sampling::{ForceUnit, Point, Units, breaks, sampled, thinned};

/// Force against indentation of one kind of sphere.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceSeries {
    /// By the Hertz law.
    pub hertz: Vec<Point>,
    /// With the constant indentation (C.1); empty for a `HuntCrossleyForce`.
    pub with_constant: Vec<Point>,
    /// By the smoothed law of the file at rest, (C.9) at speed 0; empty for a `HuntCrossleyForce`.
    pub own: Vec<Point>,
    /// Where it rests under its share of the body weight.
    pub rest: Option<Point>,
}

/// Force while a sphere goes in and out.
#[derive(Debug, Clone, PartialEq)]
pub struct LoopSeries {
    pub name: String,
    pub points: Vec<Point>,
}

/// Force over body weight in a fall, against time in s.
#[derive(Debug, Clone, PartialEq)]
pub struct DropSeries {
    pub name: String,
    pub points: Vec<Point>,
    /// √(R/g), s.
    pub time_unit_s: f64,
    /// From when on the force stays within 1 % of the body weight, s; the end where it does not.
    pub settled_s: f64,
}

/// Intervals of a curve that are looked at, to begin with.
const INTERVALS: u32 = 24;
/// Where curves begin, in radii: half a radius above the ground, where smoothed laws push already.
const ABOVE: f64 = 0.5;
/// No figure reaches deeper than a sphere's centre, in radii, unless somebody asks for it: the laws end long before.
const DEEPEST: f64 = 1.0;
/// How deep a figure reaches at least: a little more than the limit of the Hertz law, more where a body rests beyond it.
const LEAST_DEPTH: (f64, f64) = (0.25, 0.5);
/// How much deeper than where the deepest body rests.
const BELOW_REST: f64 = 1.25;
/// Share of the contact state that thresholds are drawn at (section C.2 uses it).
const THRESHOLD: f64 = limits::TRANSITION_THRESHOLD;
/// A drop is followed for so many √(R/g) where no duration is given.
const DROP_UNITS: f64 = 20.0;
/// Points for each of the shortest times in which the force of a drop rises and falls, and how many at least and at most:
/// enough to find its peaks to a ten-thousandth. Those that a straight line can do without are left out afterwards.
const SAMPLES_PER_IMPACT: f64 = 200.0;
const SAMPLES: (f64, f64) = (2001.0, 200_001.0);
/// A force this close to the body weight is at rest, in body weights.
const SETTLED: f64 = 0.01;

/// The force of one sphere in N as the axis counts it: 1 N, or its share of the body weight.
fn force_unit(units: Units, body: &Body) -> Result<f64, Failure> {
    match units.force {
        ForceUnit::Newton => Ok(1.0),
        ForceUnit::WeightShare => Ok(body.weight()?.share_n()),
    }
}

/// The name of one kind of a body's spheres; `alone`: there is no other body, so that its own name says nothing.
pub fn name_of(body: &Body, kind: &SphereKind, alone: bool) -> String {
    match (kind.spheres.as_str(), alone) {
        ("", _) => body.name.clone(),
        (spheres, true) => spheres.to_owned(),
        (spheres, false) => format!("{}: {spheres}", body.name),
    }
}

pub fn kinds(bodies: &[Body]) -> impl Iterator<Item = (&Body, &SphereKind)> {
    bodies.iter().flat_map(|body| body.kinds.iter().map(move |kind| (body, kind)))
}

/// From where to where curves go that nobody limits, in radii: from half a radius above the ground to a little more than where
/// the deepest body rests, but no deeper than a sphere's centre.
pub fn reach(bodies: &[Body]) -> (f64, f64) {
    let rests = kinds(bodies)
        .filter_map(|(body, kind)| Some(rest(body.weight.as_ref().ok()?, kind)?.0 / kind.radius_m));
    let deepest = rests.fold(None, |deepest: Option<f64>, rest| Some(deepest.map_or(rest, |d| d.max(rest))));
    let (least, usual) = LEAST_DEPTH;
    let depth = match deepest {
        Some(deepest) if deepest <= limits::INDENTATION.value => least,
        Some(deepest) => (BELOW_REST * deepest).clamp(usual, DEEPEST),
        None => usual,
    };
    (-ABOVE.min(depth), depth)
}

/// Where one kind of sphere rests under its share of the body weight, by the law of the file: x in m, and the share in N.
fn rest(weight: &Weight, kind: &SphereKind) -> Option<Point> {
    let law = Law::of(&kind.contact, kind.radius_m).ok()?;
    let spheres = [Spheres::new(law, 1.0).ok()?];
    let share = weight.share_n();
    equilibrium::indentation(&spheres, share).ok().map(|x| (x, share))
}

/// Force against indentation, between two indentations in m.
pub fn force(
    body: &Body,
    kind: &SphereKind,
    units: Units,
    (from_m, to_m): (f64, f64),
) -> Result<ForceSeries, Failure> {
    let law = law(body, kind)?;
    let unit = force_unit(units, body)?;
    // What is before contact ends at 0.
    let breaks = breaks(from_m, to_m, INTERVALS, 0.0);
    let curve = |force: &dyn Fn(f64) -> f64| -> Vec<Point> {
        sampled(|x| (units.x(x, kind.radius_m), force(x) / unit), &breaks)
    };
    let (with_constant, own) = match &law {
        Law::Smooth(law) => (curve(&|x| law.constant_indentation_force(x)), curve(&|x| law.rest_force(x))),
        // Without smoothing the force is Hertz's.
        _ => (vec![], vec![]),
    };
    let rest = body.weight.as_ref().ok().and_then(|weight| rest(weight, kind));
    Ok(ForceSeries {
        hertz: curve(&|x| law.hertz().force(x)),
        with_constant,
        own,
        rest: rest.map(|(x, force)| (units.x(x, kind.radius_m), force / unit)),
    })
}

/// Contact state against indentation, between two indentations in m (`None`: half a radius to either side); `None` for a law
/// without smoothing.
pub fn state(
    body: &Body,
    kind: &SphereKind,
    units: Units,
    reach_m: Option<(f64, f64)>,
) -> Result<Option<Vec<Point>>, Failure> {
    let Law::Smooth(law) = law(body, kind)? else { return Ok(None) };
    let (from_m, to_m) = reach_m.unwrap_or((-ABOVE * kind.radius_m, ABOVE * kind.radius_m));
    let curve = |x: f64| (units.x(x, kind.radius_m), law.contact_state(x));
    Ok(Some(sampled(curve, &breaks(from_m, to_m, INTERVALS, 0.0))))
}

/// Where the contact state is t and 1 − t (C.6): the state and the indentation; nothing for a law without smoothing.
pub fn thresholds(kind: &SphereKind, units: Units) -> Vec<Point> {
    let bd = kind.contact.smoothing().map(|smoothing| smoothing.hertz_smoothing);
    let at = bd.and_then(|bd| smoothing::threshold_indentation(THRESHOLD, bd, kind.radius_m).ok());
    let Some(at) = at.map(|relative| units.x(relative * kind.radius_m, kind.radius_m)) else { return vec![] };
    vec![(THRESHOLD, -at), (1.0 - THRESHOLD, at)]
}

/// The speed with which the bottoms reach the ground, √(2 g h), in m/s.
pub fn impact_speed(body: &Body, kind: &SphereKind, height: DropHeight) -> Result<f64, Failure> {
    Ok((2.0 * body.weight()?.gravity_m_s2 * height.metres(kind.radius_m)).sqrt())
}

/// Deepest indentation of a loop, in m: where twice the body weight would press the sphere by the Hertz law.
fn loop_depth(body: &Body, kind: &SphereKind) -> Result<f64, Failure> {
    let law = law(body, kind)?;
    law.hertz().indentation_from_force(2.0 * body.weight()?.share_n()).map_err(|error| body.failure(&error))
}

/// The force at rest on the way of a loop.
pub fn elastic(body: &Body, kind: &SphereKind, units: Units) -> Result<Vec<Point>, Failure> {
    let law = law(body, kind)?;
    let unit = force_unit(units, body)?;
    let breaks = breaks(0.0, loop_depth(body, kind)?, INTERVALS, 0.0);
    Ok(sampled(|x| (units.x(x, kind.radius_m), law.rest_force(x) / unit), &breaks))
}

/// Force against indentation while a sphere goes in and out in half a sine wave that begins with a speed (m/s).
pub fn hysteresis(
    body: &Body,
    kind: &SphereKind,
    units: Units,
    speed_m_s: f64,
) -> Result<LoopSeries, Failure> {
    let law = law(body, kind)?;
    let unit = force_unit(units, body)?;
    let depth = loop_depth(body, kind)?;
    let curve = |phase: f64| {
        let x = depth * phase.sin();
        (units.x(x, kind.radius_m), law.force(x, speed_m_s * phase.cos()) / unit)
    };
    let points = sampled(curve, &breaks(0.0, std::f64::consts::PI, INTERVALS, 0.0));
    let restitution =
        restitution::exact(kind.contact.dissipation(), speed_m_s).map_err(|error| body.failure(&error))?;
    let name = format!("{speed_m_s:.3} m/s, restitution {restitution:.2}");
    Ok(LoopSeries { name, points })
}

/// How long to follow bodies where no duration is given: 20 √(R/g) of the slowest.
pub fn duration(bodies: &[Body]) -> Result<f64, Failure> {
    let mut longest = 0.0_f64;
    for body in bodies {
        longest = longest.max(DROP_UNITS * time_unit(body)?);
    }
    Ok(longest)
}

fn time_unit(body: &Body) -> Result<f64, Failure> {
    let weight = body.weight()?;
    let on_ground = drop_test(body, 0.0, 1.0, 2)?;
    Ok((on_ground.reference_radius_m() / weight.gravity_m_s2).sqrt())
}

/// Force over body weight in a fall.
pub fn fall(body: &Body, height: DropHeight, duration_s: f64) -> Result<DropSeries, Failure> {
    let samples = samples(&dropped(body, height, duration_s, 2)?, body.weight()?, duration_s);
    let report = dropped(body, height, duration_s, samples)?;
    let force = |sample: &Sample| (sample.time_s, sample.force_n / report.body_weight_n);
    let series: Vec<Point> = report.series.iter().map(force).collect();
    let unsettled = series.iter().rposition(|(_, force)| (force - 1.0).abs() > SETTLED);
    let settled = unsettled.map_or(0, |last| last + 1);
    Ok(DropSeries {
        name: body.name.clone(),
        settled_s: series.get(settled).map_or(duration_s, |(time, _)| *time),
        points: thinned(&series),
        time_unit_s: report.reference_time_s,
    })
}

/// How many points show the peaks of a fall: so many for its first contact, or for half of an oscillation at rest, whichever is
/// shorter.
fn samples(report: &DropReport, weight: &Weight, duration_s: f64) -> usize {
    let contact_s = report.first_contact.and_then(|contact| contact.end).map(|end| end.contact_time_s);
    let stiffness_n_m = weight.sphere_count * report.equilibrium_stiffness_n_m;
    let oscillation_s = std::f64::consts::PI * (weight.mass_kg / stiffness_n_m).sqrt();
    let shortest_s = contact_s.unwrap_or(oscillation_s).min(oscillation_s);
    let wanted = (SAMPLES_PER_IMPACT * duration_s / shortest_s).clamp(SAMPLES.0, SAMPLES.1);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between the two bounds")]
    let samples = wanted as usize;
    samples
}

pub fn dropped(
    body: &Body,
    height: DropHeight,
    duration_s: f64,
    samples: usize,
) -> Result<DropReport, Failure> {
    let height_m = match height {
        DropHeight::Metres(metres) => metres,
        DropHeight::Radii(radii) => radii * drop_test(body, 0.0, 1.0, 2)?.reference_radius_m(),
    };
    let test = drop_test(body, height_m, duration_s, samples)?;
    test.run().map_err(|error| body.failure(&error))
}

fn drop_test(body: &Body, height_m: f64, duration_s: f64, samples: usize) -> Result<DropTest, Failure> {
    let weight = body.weight()?;
    let values = DropValues {
        mass_kg: weight.mass_kg,
        gravity_m_s2: weight.gravity_m_s2,
        height_m,
        duration_s,
        samples,
    };
    DropTest::new(weight.spheres.iter().copied(), values).map_err(|error| body.failure(&error))
}

fn law(body: &Body, kind: &SphereKind) -> Result<Law, Failure> {
    Law::of(&kind.contact, kind.radius_m).map_err(|error| body.failure(&error))
}
