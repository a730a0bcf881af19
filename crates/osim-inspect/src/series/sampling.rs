//! Units of series, and points of curves: many points in bends and few on straight parts, so that straight lines between the points look
//! like the curve.

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
    let (low, high) = values
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
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
