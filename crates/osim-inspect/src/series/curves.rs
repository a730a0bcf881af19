//! Computes points of curves with the library of equations: many points in bends and few on straight parts, so that straight lines between
//! the points look like the curve. Also the units of series.

use contact_scaling::drop_test::{DropReport, DropTest, DropValues, Sample};
use contact_scaling::{Law, Spheres, equilibrium, limits, restitution, smoothing};
use osim_model::files::Failure;
use osim_model::least_and_most;
use osim_requests::DropHeight;

use crate::series::body::{CarriedWeight, ContactBody, SphereKind};

/// Force against indentation of one kind of sphere.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceSeries {
    /// Force over indentation by the Hertz law.
    pub hertz: Vec<Point>,
    /// Force over indentation with the constant indentation (C.1); empty for a `HuntCrossleyForce`.
    pub with_constant: Vec<Point>,
    /// Force over indentation by the smoothed law of the file at rest, (C.9) at speed 0; empty for a `HuntCrossleyForce`.
    pub model_law: Vec<Point>,
    /// The point of equilibrium of the sphere under its share of the body weight.
    pub rest: Option<Point>,
}

/// Force while a sphere moves into the ground and out again.
#[derive(Debug, Clone, PartialEq)]
pub struct LoopSeries {
    pub name: String,
    pub points: Vec<Point>,
}

/// Force in body weights while a body falls, against time in s.
#[derive(Debug, Clone, PartialEq)]
pub struct DropSeries {
    pub name: String,
    pub points: Vec<Point>,
    /// Unit of time of dimensionless plots, √(R/g), s.
    pub time_unit_s: f64,
    /// The time after which the force stays within 1 % of the body weight, s; the end of the drop if it does not settle.
    pub settled_s: f64,
}

/// Number of intervals of a curve before some of them are divided.
const FIRST_INTERVALS: u32 = 24;
/// Curves begin this many radii above the ground, where smoothed laws already push.
const START_ABOVE_RADII: f64 = 0.5;
/// Curves end at the latest at this indentation, in radii, where the sphere is in the ground up to its centre, unless the caller wants
/// more. The laws are only valid for smaller indentations.
const DEEPEST_RADII: f64 = 1.0;
/// Curves reach at least this deep, in radii: a little beyond the limit of the Hertz law. The second number is for bodies whose equilibrium
/// is beyond that limit, or that have no equilibrium.
const LEAST_DEPTHS_RADII: (f64, f64) = (0.25, 0.5);
/// Curves reach this many times deeper than the equilibrium of the deepest body.
const DEPTH_OVER_REST_DEPTH: f64 = 1.25;
/// The contact states t and 1 − t at which thresholds are drawn, as in section C.2; this is t.
const CONTACT_STATE_THRESHOLD: f64 = limits::TRANSITION_SHARE;
/// The default duration of a drop, in √(R/g).
const DROP_TIME_UNITS: f64 = 20.0;
/// Number of samples in each shortest time in which the force of a drop rises and falls; `DROP_SAMPLES` are the least and largest number of
/// all samples. With these, peaks are found to a ten-thousandth. Samples on straight lines are left out afterwards.
const SAMPLES_PER_IMPACT: f64 = 200.0;
const DROP_SAMPLES: (f64, f64) = (2001.0, 200_001.0);
/// A force that differs from the body weight by at most this has settled, in body weights.
const SETTLED_BODY_WEIGHTS: f64 = 0.01;

/// The unit of the force axis, in N: 1 N, or the share of the body weight that one sphere carries.
fn force_unit(units: PlotUnits, body: &ContactBody) -> Result<f64, Failure> {
    match units.force {
        ForceUnit::Newton => Ok(1.0),
        ForceUnit::WeightShare => Ok(body.weight()?.share_n()),
    }
}

/// The name of the curve of one kind of sphere. If there is only one body, its name is left out.
pub fn curve_name(body: &ContactBody, kind: &SphereKind, is_only_body: bool) -> String {
    match (kind.spheres.as_str(), is_only_body) {
        ("", _) => body.name.clone(),
        (spheres, true) => spheres.to_owned(),
        (spheres, false) => format!("{}: {spheres}", body.name),
    }
}

/// Every kind of sphere of every body.
pub fn bodies_and_kinds(bodies: &[ContactBody]) -> impl Iterator<Item = (&ContactBody, &SphereKind)> {
    bodies.iter().flat_map(|body| body.kinds.iter().map(move |kind| (body, kind)))
}

/// The range of curves for which the caller gives no limits, in radii: from half a radius above the ground to a little deeper than the
/// equilibrium of the deepest body, but no deeper than the centre of a sphere.
pub fn default_range(bodies: &[ContactBody]) -> (f64, f64) {
    let rests = bodies_and_kinds(bodies)
        .filter_map(|(body, kind)| Some(point_at_rest(body.weight.as_ref().ok()?, kind)?.0 / kind.radius_m));
    let deepest = rests.fold(None, |deepest: Option<f64>, rest| Some(deepest.map_or(rest, |d| d.max(rest))));
    let (within_limit, otherwise) = LEAST_DEPTHS_RADII;
    let depth = match deepest {
        Some(deepest) if deepest <= limits::INDENTATION.value => within_limit,
        Some(deepest) => (DEPTH_OVER_REST_DEPTH * deepest).clamp(otherwise, DEEPEST_RADII),
        None => otherwise,
    };
    (-START_ABOVE_RADII.min(depth), depth)
}

/// The equilibrium of one kind of sphere under its share of the body weight, by the law of the file: x in m, and the share in N.
fn point_at_rest(weight: &CarriedWeight, kind: &SphereKind) -> Option<Point> {
    let law = Law::of(&kind.contact, kind.radius_m).ok()?;
    let spheres = [Spheres::new(law, 1.0).ok()?];
    let share = weight.share_n();
    equilibrium::indentation(&spheres, share).ok().map(|x| (x, share))
}

/// Force against indentation, between two indentations in m.
pub fn force(
    body: &ContactBody,
    kind: &SphereKind,
    units: PlotUnits,
    (from_m, to_m): (f64, f64),
) -> Result<ForceSeries, Failure> {
    let law = law_of_kind(body, kind)?;
    let unit = force_unit(units, body)?;
    // A break at 0, where the curve before contact ends.
    let breaks = equal_breaks(from_m, to_m, FIRST_INTERVALS, 0.0);
    let curve = |force: &dyn Fn(f64) -> f64| -> Vec<Point> {
        sample_curve(|x| (units.x(x, kind.radius_m), force(x) / unit), &breaks)
    };
    let (with_constant, model_law) = match &law {
        Law::Smooth(law) => (curve(&|x| law.constant_indentation_force(x)), curve(&|x| law.rest_force(x))),
        // Without smoothing the force is Hertz's.
        _ => (vec![], vec![]),
    };
    let rest = body.weight.as_ref().ok().and_then(|weight| point_at_rest(weight, kind));
    Ok(ForceSeries {
        hertz: curve(&|x| law.hertz().force(x)),
        with_constant,
        model_law,
        rest: rest.map(|(x, force)| (units.x(x, kind.radius_m), force / unit)),
    })
}

/// Contact state against indentation, between two indentations in m (`None`: half a radius above and below the floor); `None` for a law
/// without smoothing.
pub fn contact_state(
    body: &ContactBody,
    kind: &SphereKind,
    units: PlotUnits,
    range_m: Option<(f64, f64)>,
) -> Result<Option<Vec<Point>>, Failure> {
    let Law::Smooth(law) = law_of_kind(body, kind)? else { return Ok(None) };
    let (from_m, to_m) =
        range_m.unwrap_or((-START_ABOVE_RADII * kind.radius_m, START_ABOVE_RADII * kind.radius_m));
    let curve = |x: f64| (units.x(x, kind.radius_m), law.contact_state(x));
    Ok(Some(sample_curve(curve, &equal_breaks(from_m, to_m, FIRST_INTERVALS, 0.0))))
}

/// The two thresholds (C.6): contact states t and 1 − t with their indentations; empty for a law without smoothing.
pub fn thresholds(kind: &SphereKind, units: PlotUnits) -> Vec<Point> {
    let bd = kind.contact.smoothing().map(|smoothing| smoothing.hertz_smoothing);
    let at =
        bd.and_then(|bd| smoothing::threshold_indentation(CONTACT_STATE_THRESHOLD, bd, kind.radius_m).ok());
    let Some(at) = at.map(|relative| units.x(relative * kind.radius_m, kind.radius_m)) else { return vec![] };
    vec![(CONTACT_STATE_THRESHOLD, -at), (1.0 - CONTACT_STATE_THRESHOLD, at)]
}

/// The speed at which the bottoms of the spheres reach the ground after a fall, √(2 g h), in m/s.
pub fn impact_speed(body: &ContactBody, kind: &SphereKind, height: DropHeight) -> Result<f64, Failure> {
    Ok((2.0 * body.weight()?.gravity_m_s2 * height.metres(kind.radius_m)).sqrt())
}

/// The deepest indentation of a loop, m: the indentation under twice the body weight by the Hertz law.
fn loop_depth(body: &ContactBody, kind: &SphereKind) -> Result<f64, Failure> {
    let law = law_of_kind(body, kind)?;
    law.hertz().indentation_from_force(2.0 * body.weight()?.share_n()).map_err(|error| body.failure(&error))
}

/// The force at speed 0 against indentation, over the range of a loop.
pub fn force_at_rest(body: &ContactBody, kind: &SphereKind, units: PlotUnits) -> Result<Vec<Point>, Failure> {
    let law = law_of_kind(body, kind)?;
    let unit = force_unit(units, body)?;
    let breaks = equal_breaks(0.0, loop_depth(body, kind)?, FIRST_INTERVALS, 0.0);
    Ok(sample_curve(|x| (units.x(x, kind.radius_m), law.rest_force(x) / unit), &breaks))
}

/// Force against indentation while a sphere moves into the ground and out again in half a sine wave, which begins with the speed
/// `speed_m_s`.
pub fn hysteresis(
    body: &ContactBody,
    kind: &SphereKind,
    units: PlotUnits,
    speed_m_s: f64,
) -> Result<LoopSeries, Failure> {
    let law = law_of_kind(body, kind)?;
    let unit = force_unit(units, body)?;
    let depth = loop_depth(body, kind)?;
    let curve = |phase: f64| {
        let x = depth * phase.sin();
        (units.x(x, kind.radius_m), law.force(x, speed_m_s * phase.cos()) / unit)
    };
    let points = sample_curve(curve, &equal_breaks(0.0, std::f64::consts::PI, FIRST_INTERVALS, 0.0));
    let restitution =
        restitution::exact(kind.contact.dissipation(), speed_m_s).map_err(|error| body.failure(&error))?;
    let name = format!("{speed_m_s:.3} m/s, restitution {restitution:.2}");
    Ok(LoopSeries { name, points })
}

/// The default duration of a drop, s: 20 √(R/g) of the slowest body.
pub fn default_duration(bodies: &[ContactBody]) -> Result<f64, Failure> {
    let mut longest = 0.0_f64;
    for body in bodies {
        let from_ground = drop_test(body, 0.0, 1.0, 2)?;
        let time_unit_s = (from_ground.reference_radius_m() / body.weight()?.gravity_m_s2).sqrt();
        longest = longest.max(DROP_TIME_UNITS * time_unit_s);
    }
    Ok(longest)
}

/// Force over body weight against time in a drop.
pub fn drop_force(body: &ContactBody, height: DropHeight, duration_s: f64) -> Result<DropSeries, Failure> {
    let samples = sample_count(&run_drop_test(body, height, duration_s, 2)?, body.weight()?, duration_s);
    let report = run_drop_test(body, height, duration_s, samples)?;
    let force = |sample: &Sample| (sample.time_s, sample.force_n / report.body_weight_n);
    let series: Vec<Point> = report.series.iter().map(force).collect();
    let unsettled = series.iter().rposition(|(_, force)| (force - 1.0).abs() > SETTLED_BODY_WEIGHTS);
    let settled = unsettled.map_or(0, |last| last + 1);
    Ok(DropSeries {
        name: body.name.clone(),
        settled_s: series.get(settled).map_or(duration_s, |(time, _)| *time),
        points: thin_out(&series),
        time_unit_s: report.reference_time_s,
    })
}

/// The number of samples that show the peaks of a drop. It depends on the duration of the first contact, or on half an oscillation around
/// the equilibrium, whichever is shorter.
fn sample_count(report: &DropReport, weight: &CarriedWeight, duration_s: f64) -> usize {
    let contact_s = report.first_contact.and_then(|contact| contact.end).map(|end| end.contact_time_s);
    let stiffness_n_m = weight.sphere_count * report.equilibrium_stiffness_n_m;
    let oscillation_s = std::f64::consts::PI * (weight.mass_kg / stiffness_n_m).sqrt();
    let shortest_s = contact_s.unwrap_or(oscillation_s).min(oscillation_s);
    let wanted = (SAMPLES_PER_IMPACT * duration_s / shortest_s).clamp(DROP_SAMPLES.0, DROP_SAMPLES.1);
    wanted as usize
}

/// Computes the fall of a body from a height.
pub fn run_drop_test(
    body: &ContactBody,
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

/// The fall of a body from a height (m), not computed yet.
fn drop_test(
    body: &ContactBody,
    height_m: f64,
    duration_s: f64,
    samples: usize,
) -> Result<DropTest, Failure> {
    let &CarriedWeight { mass_kg, gravity_m_s2, ref spheres, .. } = body.weight()?;
    let values = DropValues { mass_kg, gravity_m_s2, height_m, duration_s, samples };
    DropTest::new(spheres.iter().copied(), values).map_err(|error| body.failure(&error))
}

/// The contact law of one kind of sphere.
fn law_of_kind(body: &ContactBody, kind: &SphereKind) -> Result<Law, Failure> {
    Law::of(&kind.contact, kind.radius_m).map_err(|error| body.failure(&error))
}

/// A point of a curve: x and y.
pub type Point = (f64, f64);

/// The unit of an axis of indentations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum IndentationUnit {
    /// Indentation as a fraction of the radius, x/R.
    Relative,
    Millimetre,
}

/// The unit of an axis of forces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ForceUnit {
    Newton,
    /// The share of the body weight that one sphere carries, M g / n.
    WeightShare,
}

/// The units of a plot's axes of indentation and of force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PlotUnits {
    pub indentation: IndentationUnit,
    pub force: ForceUnit,
}

impl PlotUnits {
    /// An indentation of a sphere in the unit of the axis.
    pub fn x(self, indentation_m: f64, radius_m: f64) -> f64 {
        match self.indentation {
            IndentationUnit::Relative => indentation_m / radius_m,
            IndentationUnit::Millimetre => indentation_m * 1e3,
        }
    }

    /// The indentation of a sphere, m, for the number `value` on the axis.
    pub fn metres(self, value: f64, radius_m: f64) -> f64 {
        match self.indentation {
            IndentationUnit::Relative => value * radius_m,
            IndentationUnit::Millimetre => value * 1e-3,
        }
    }
}

/// Lines between points stay closer to the curve than this share of the plot's height or width, about a hundredth of a millimetre.
const DISTANCE_FROM_CURVE: f64 = 2e-4;
/// The largest number of times that an interval is halved.
const MOST_HALVINGS: u32 = 10;

/// Points of a curve for parameters from the first to the last of `breaks`, which must rise. The curve must be smooth between neighbouring
/// breaks; each break is among the points.
pub(super) fn sample_curve(curve: impl Fn(f64) -> Point, breaks: &[f64]) -> Vec<Point> {
    let knots: Vec<(f64, Point)> = breaks.iter().map(|&at| (at, curve(at))).collect();
    let size =
        (extent_of_values(knots.iter().map(|(_, p)| p.0)), extent_of_values(knots.iter().map(|(_, p)| p.1)));
    let mut points: Vec<Point> = knots.first().map(|(_, point)| *point).into_iter().collect();
    for pair in knots.windows(2) {
        add_refined_interval(&curve, (pair[0], pair[1]), size, MOST_HALVINGS, &mut points);
    }
    points
}

/// Adds the points of an interval, halved where the curve bends. The first end is left out; the second end is the last point.
fn add_refined_interval(
    curve: &impl Fn(f64) -> Point,
    (from, to): ((f64, Point), (f64, Point)),
    size: (f64, f64),
    halvings_left: u32,
    points: &mut Vec<Point>,
) {
    let point_at = |share: f64| {
        let at = from.0 + share * (to.0 - from.0);
        (at, curve(at))
    };
    // Not only in the middle, where a curve that bends both ways may cross its line.
    let inner = [point_at(0.25), point_at(0.5), point_at(0.75)];
    let bends =
        inner.iter().any(|(_, point)| distance_to_line(*point, (from.1, to.1), size) > DISTANCE_FROM_CURVE);
    if halvings_left == 0 || !bends {
        points.push(to.1);
        return;
    }
    let [_, middle, _] = inner;
    add_refined_interval(curve, (from, middle), size, halvings_left - 1, points);
    add_refined_interval(curve, (middle, to), size, halvings_left - 1, points);
}

/// The difference between the largest and the smallest value; 1 if it is 0.
fn extent_of_values(values: impl Iterator<Item = f64>) -> f64 {
    let (low, high) = least_and_most(values);
    if high > low { high - low } else { 1.0 }
}

/// The distance from a point to the line between two others, as a share of the plot's size.
fn distance_to_line(point: Point, (from, to): (Point, Point), (width, height): (f64, f64)) -> f64 {
    let scaled = |(x, y): Point| (x / width, y / height);
    let ((px, py), (ax, ay), (bx, by)) = (scaled(point), scaled(from), scaled(to));
    let (dx, dy) = (bx - ax, by - ay);
    let length = dx * dx + dy * dy;
    let along = if length > 0.0 { (((px - ax) * dx + (py - ay) * dy) / length).clamp(0.0, 1.0) } else { 0.0 };
    (px - ax - along * dx).hypot(py - ay - along * dy)
}

/// The ends of `count` equal intervals from `from` to `to`, and also `extra` if it is between `from` and `to`.
pub(super) fn equal_breaks(from: f64, to: f64, count: u32, extra: f64) -> Vec<f64> {
    let equal = (0..=count).map(|step| from + (to - from) * f64::from(step) / f64::from(count));
    let mut breaks: Vec<f64> = equal.chain((from < extra && extra < to).then_some(extra)).collect();
    breaks.sort_by(f64::total_cmp);
    breaks.dedup();
    breaks
}

/// The points of a long series that are needed to draw it: its ends, its turning points, and points where it bends.
pub(super) fn thin_out(series: &[Point]) -> Vec<Point> {
    let value = |at: usize| series.get(at).copied().unwrap_or_default();
    let last = series.len().saturating_sub(1);
    let turns = (1..last).filter(|&at| {
        let (before, here, after) = (value(at - 1).1, value(at).1, value(at + 1).1);
        (here - before) * (after - here) <= 0.0 && (here != before || here != after)
    });
    let knots: Vec<f64> =
        std::iter::once(0).chain(turns).chain((last > 0).then_some(last)).map(|at| at as f64).collect();
    sample_curve(|at| interpolate(series, at), &knots)
}

/// The point of a series at a fractional index.
fn interpolate(series: &[Point], at: f64) -> Point {
    let before = at.floor() as usize;
    let from = series.get(before).or(series.last()).copied().unwrap_or_default();
    let to = series.get(before + 1).copied().unwrap_or(from);
    let share = at.fract();
    (from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest distance between a curve and the lines through `points`, in a plot of this width and height.
    fn largest_distance(points: &[Point], curve: impl Fn(f64) -> f64, (width, height): (f64, f64)) -> f64 {
        let mut farthest = 0.0_f64;
        for pair in points.windows(2) {
            let ((x0, y0), (x1, y1)) = (pair[0], pair[1]);
            let slope = (y1 - y0) / height / ((x1 - x0) / width);
            for share in (0..=20).map(|i| f64::from(i) / 20.0) {
                let above = curve(x0 + share * (x1 - x0)) - (y0 + share * (y1 - y0));
                farthest = farthest.max((above / height).abs() / slope.hypot(1.0));
            }
        }
        farthest
    }

    #[test]
    fn a_straight_line_has_no_points_between_its_breaks() {
        let points = sample_curve(|x| (x, 2.0 * x), &equal_breaks(0.0, 1.0, 4, 0.1));
        assert_eq!(points.iter().map(|p| p.0).collect::<Vec<_>>(), [0.0, 0.1, 0.25, 0.5, 0.75, 1.0]);
    }

    #[test]
    fn samples_follow_a_steep_step_of_a_curve() {
        let step = |x: f64| 0.5 + 0.5 * (300.0 * x).tanh();
        let points = sample_curve(|x| (x, step(x)), &equal_breaks(-0.5, 0.5, 24, 0.0));
        let farthest = largest_distance(&points, step, (1.0, 1.0));
        assert!(farthest < 5e-4, "{farthest}");
        assert!(points.len() < 200, "{}", points.len());
        assert!(points.contains(&(0.0, 0.5)));
    }

    #[test]
    fn a_thinned_series_keeps_its_peaks() {
        let wave = |t: f64| (-t).exp() * (9.0 * t).sin();
        let series: Vec<Point> = (0..=20_000).map(|i| f64::from(i) / 4000.0).map(|t| (t, wave(t))).collect();
        let points = thin_out(&series);
        assert!(points.len() < 600, "{}", points.len());
        let top = |points: &[Point]| points.iter().map(|p| p.1).fold(f64::NEG_INFINITY, f64::max);
        assert_eq!(top(&points), top(&series));
        let farthest = largest_distance(&points, wave, (5.0, 1.3));
        assert!(farthest < 5e-4, "{farthest}");
        assert_eq!((points.first(), points.last()), (series.first(), series.last()));
    }
}
