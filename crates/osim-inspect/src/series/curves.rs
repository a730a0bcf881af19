//! Points of curves, computed by the library of equations: the only place where a body becomes a figure's data.

use contact_scaling::drop_test::{DropReport, DropTest, DropValues};
use contact_scaling::{Law, Spheres, equilibrium, limits, restitution, smoothing};
use osim_model::files::Failure;

use super::body::{Body, SphereKind, Weight};
use super::units::{ForceUnit, Point, Units};
use crate::drop_height::DropHeight;

/// Force against indentation of one kind of sphere.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceSeries {
    /// Whose.
    pub name: String,
    /// By the Hertz law.
    pub hertz: Vec<Point>,
    /// With the constant indentation (C.1); empty for a `HuntCrossleyForce`.
    pub with_constant: Vec<Point>,
    /// By the smoothed law of the file at rest, (C.9) at speed 0; empty for a `HuntCrossleyForce`.
    pub own: Vec<Point>,
    /// Where it rests under its share of the body weight.
    pub rest: Option<Point>,
}

/// Contact state against indentation.
#[derive(Debug, Clone, PartialEq)]
pub struct StateSeries {
    /// Whose.
    pub name: String,
    /// The curve.
    pub points: Vec<Point>,
}

/// Force while a sphere goes in and out.
#[derive(Debug, Clone, PartialEq)]
pub struct LoopSeries {
    /// Speed and restitution.
    pub name: String,
    /// The curve.
    pub points: Vec<Point>,
}

/// Force over body weight in a fall, against time in s.
#[derive(Debug, Clone, PartialEq)]
pub struct DropSeries {
    /// Whose.
    pub name: String,
    /// The curve.
    pub points: Vec<Point>,
    /// √(R/g), s.
    pub time_unit_s: f64,
}

/// Points of a curve against indentation.
const STEPS: u32 = 160;
/// Share of the contact state that thresholds are drawn at (section C.2 uses it).
const THRESHOLD: f64 = limits::TRANSITION_THRESHOLD;
/// A drop is followed for so many √(R/g) where no duration is given.
const DROP_UNITS: f64 = 20.0;
/// Points of a drop for each √(R/g), and how many at least and at most.
const SAMPLES_PER_UNIT: f64 = 20.0;
const SAMPLES: (f64, f64) = (401.0, 2001.0);

/// The force of one sphere in N as the axis counts it: 1 N, or its share of the body weight.
fn force_unit(units: Units, body: &Body) -> Result<f64, Failure> {
    match units.force {
        ForceUnit::Newton => Ok(1.0),
        ForceUnit::WeightShare => Ok(body.weight()?.share_n()),
    }
}

/// The name of one kind of a body's spheres.
pub fn name_of(body: &Body, kind: &SphereKind) -> String {
    if kind.spheres.is_empty() { body.name.clone() } else { format!("{}: {}", body.name, kind.spheres) }
}

/// Every kind of sphere of every body.
pub fn kinds(bodies: &[Body]) -> impl Iterator<Item = (&Body, &SphereKind)> {
    bodies.iter().flat_map(|body| body.kinds.iter().map(move |kind| (body, kind)))
}

/// Indentations in m, from `from` to `to` radii; 0 is one of them, so that what is before contact ends there.
fn indentations(from: f64, to: f64, radius_m: f64) -> Vec<f64> {
    let steps = f64::from(STEPS);
    let before = (steps * (0.0 - from) / (to - from)).round().max(0.0);
    (0..=STEPS)
        .map(|step| {
            let step = f64::from(step);
            let relative = if step <= before && before > 0.0 {
                from * (1.0 - step / before)
            } else {
                to * (step - before) / (steps - before)
            };
            relative * radius_m
        })
        .collect()
}

/// How far a figure reaches into the ground, in radii: half a radius, or a little more than where a body rests.
pub fn depth(bodies: &[Body]) -> f64 {
    let rests = kinds(bodies)
        .filter_map(|(body, kind)| Some(rest(body.weight.as_ref().ok()?, kind)?.0 / kind.radius_m));
    rests.fold(0.5, |deepest: f64, rest| deepest.max(1.25 * rest))
}

/// Where one kind of sphere rests under its share of the body weight, by the law of the file: x in m, and the share in N.
fn rest(weight: &Weight, kind: &SphereKind) -> Option<Point> {
    let law = Law::of(&kind.contact, kind.radius_m).ok()?;
    let spheres = [Spheres::new(law, 1.0).ok()?];
    let share = weight.share_n();
    equilibrium::indentation(&spheres, share).ok().map(|x| (x, share))
}

/// Force against indentation, from half a radius above the ground to `depth` radii in it.
pub fn force(body: &Body, kind: &SphereKind, units: Units, depth: f64) -> Result<ForceSeries, Failure> {
    let law = law(body, kind)?;
    let unit = force_unit(units, body)?;
    let curve = |force: &dyn Fn(f64) -> f64| -> Vec<Point> {
        let places = indentations(-0.5, depth, kind.radius_m).into_iter();
        places.map(|x| (units.x(x, kind.radius_m), force(x) / unit)).collect()
    };
    let (with_constant, own) = match &law {
        Law::Smooth(law) => (curve(&|x| law.constant_indentation_force(x)), curve(&|x| law.rest_force(x))),
        // Without smoothing the force is Hertz's.
        _ => (vec![], vec![]),
    };
    let rest = body.weight.as_ref().ok().and_then(|weight| rest(weight, kind));
    Ok(ForceSeries {
        name: name_of(body, kind),
        hertz: curve(&|x| law.hertz().force(x)),
        with_constant,
        own,
        rest: rest.map(|(x, force)| (units.x(x, kind.radius_m), force / unit)),
    })
}

/// Contact state against indentation, half a radius to either side; `None` for a law without smoothing.
pub fn state(body: &Body, kind: &SphereKind, units: Units) -> Result<Option<StateSeries>, Failure> {
    let Law::Smooth(law) = law(body, kind)? else { return Ok(None) };
    let places = indentations(-0.5, 0.5, kind.radius_m).into_iter();
    let points = places.map(|x| (units.x(x, kind.radius_m), law.contact_state(x))).collect();
    Ok(Some(StateSeries { name: name_of(body, kind), points }))
}

/// Where the contact state is t and 1 − t (C.6): the state and the indentation; nothing for a law without smoothing.
#[must_use]
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
    let depth = loop_depth(body, kind)? / kind.radius_m;
    let places = indentations(0.0, depth, kind.radius_m).into_iter();
    Ok(places.map(|x| (units.x(x, kind.radius_m), law.rest_force(x) / unit)).collect())
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
    let moments = (0..=STEPS).map(|step| std::f64::consts::PI * f64::from(step) / f64::from(STEPS));
    let points = moments.map(|phase| {
        let x = depth * phase.sin();
        (units.x(x, kind.radius_m), law.force(x, speed_m_s * phase.cos()) / unit)
    });
    let restitution =
        restitution::exact(kind.contact.dissipation(), speed_m_s).map_err(|error| body.failure(&error))?;
    let name = format!("{speed_m_s:.3} m/s, restitution {restitution:.2}");
    Ok(LoopSeries { name, points: points.collect() })
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
    let time_unit_s = time_unit(body)?;
    let wanted = (SAMPLES_PER_UNIT * duration_s / time_unit_s).clamp(SAMPLES.0, SAMPLES.1);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between the two bounds")]
    let report = dropped(body, height, duration_s, wanted as usize)?;
    let points = report.series.iter().map(|sample| (sample.time_s, sample.force_n / report.body_weight_n));
    Ok(DropSeries { name: body.name.clone(), points: points.collect(), time_unit_s: report.reference_time_s })
}

/// The drop of a body.
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
