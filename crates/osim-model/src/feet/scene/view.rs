//! How a foot is looked at: the axes forward, up and to the right, and the line around its points.

use foldhash::{HashSet, HashSetExt};

use crate::feet::vector::dot;
use crate::model::Model;

/// The names of a frame's axes, and of their opposites.
const NAMES: [[&str; 2]; 3] = [["x", "−x"], ["y", "−y"], ["z", "−z"]];

/// Three directions of length 1 in ground (or in the frame of a body that is drawn in its own).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViewAxes {
    /// x, level; y where x is up or down.
    pub forward: [f64; 3],
    /// Against gravity.
    pub up: [f64; 3],
    /// Forward × up.
    pub right: [f64; 3],
}

impl ViewAxes {
    /// The axes of a model: up is against its gravity.
    pub fn of(model: &Model) -> Self {
        Self::with_up(model.up())
    }

    /// The axes with this direction up, which has length 1.
    pub fn with_up(up: [f64; 3]) -> Self {
        let forward = if up[0].abs() > 0.9 { [0.0, 1.0, 0.0] } else { [1.0, 0.0, 0.0] };
        let rises = dot(forward, up);
        let level: [f64; 3] = std::array::from_fn(|i| forward[i] - rises * up[i]);
        let length = dot(level, level).sqrt();
        let forward = level.map(|value| value / length);
        let [a, b] = [forward, up];
        let right = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        Self { forward, up, right }
    }

    /// How far a point is forward, up and to the right, m.
    pub fn seen(&self, point_m: [f64; 3]) -> [f64; 3] {
        [dot(self.forward, point_m), dot(self.up, point_m), dot(self.right, point_m)]
    }

    /// What the three directions are called: `x`, `y` and `z` where gravity points along −y; words where none is an axis.
    pub fn names(&self) -> [&'static str; 3] {
        let axis = |direction: [f64; 3], word| {
            let of = |(i, [along, against]): (usize, [&'static str; 2])| match direction[i] {
                value if value > 1.0 - 1e-12 => Some(along),
                value if value < 1e-12 - 1.0 => Some(against),
                _ => None,
            };
            NAMES.into_iter().enumerate().find_map(of).unwrap_or(word)
        };
        [axis(self.forward, "forward"), axis(self.up, "up"), axis(self.right, "right")]
    }
}

// The line around points.

type Point = (f64, f64);

/// Lines longer than this share of the width or the height, whichever is larger, give way to points inside...
const LONGEST: f64 = 0.06;
/// ... and than this many times the distance that points have which are spread evenly over the hull.
const SPACINGS: f64 = 5.0;
/// Points inside that are closer than this share are taken as one.
const CELL: f64 = 1.0 / 150.0;
/// A line around more corners than this is not looked at further.
const MOST: usize = 600;

/// The line around points of a plane, closed, without its first point again. It is the convex hull, whose long lines give way to
/// points inside, longest first, until none is longer than 6 % of the width or the height, or than a few times the distance of
/// points (the characteristic shape of Duckham, Kulik, Worboys and Galton, Pattern Recognition 41, 2008). No point is outside,
/// and the line does not cross itself.
///
/// Fewer than three points, or points in a line, have no line around them.
pub fn silhouette(points: &[Point]) -> Vec<Point> {
    if points.iter().any(|point| !point.0.is_finite() || !point.1.is_finite()) {
        return Vec::new();
    }
    let hull = convex_hull(points);
    if hull.len() < 3 {
        return Vec::new();
    }
    let span = |of: fn(&Point) -> f64| {
        let ends =
            hull.iter().map(of).fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        ends.1 - ends.0
    };
    let size = span(|point| point.0).max(span(|point| point.1));
    let shape = Shape::new(points, hull, CELL * size);
    let longest = (LONGEST * size).max(SPACINGS * shape.spacing());
    shape.dug(longest)
}

/// Twice the area of a triangle, positive where it turns to the left.
fn turn(a: Point, b: Point, c: Point) -> f64 {
    (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0)
}

/// Andrew's monotone chain, turning to the left; points in a line are left out.
fn convex_hull(points: &[Point]) -> Vec<Point> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    sorted.dedup();
    let half = |points: &mut dyn Iterator<Item = Point>| {
        let mut chain: Vec<Point> = Vec::new();
        for point in points {
            while let [.., a, b] = chain[..]
                && turn(a, b, point) <= 0.0
            {
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut hull = half(&mut sorted.iter().copied());
    hull.extend(half(&mut sorted.iter().rev().copied()));
    hull
}

/// A line around points that becomes narrower.
struct Shape {
    line: Vec<Point>,
    inside: Vec<Point>,
}

impl Shape {
    fn new(points: &[Point], hull: Vec<Point>, cell: f64) -> Self {
        #[expect(clippy::cast_possible_truncation, reason = "some hundred cells")]
        let cell_of = |point: &Point| ((point.0 / cell).round() as i64, (point.1 / cell).round() as i64);
        let mut taken: HashSet<(i64, i64)> = hull.iter().map(cell_of).collect();
        let inside = points.iter().filter(|point| taken.insert(cell_of(point))).copied().collect();
        Self { line: hull, inside }
    }

    /// The distance of as many points that are spread evenly over the same area.
    fn spacing(&self) -> f64 {
        let next = self.line.iter().cycle().skip(1);
        let area: f64 = self.line.iter().zip(next).map(|(a, b)| (a.0 * b.1 - b.0 * a.1) / 2.0).sum();
        #[expect(clippy::cast_precision_loss, reason = "some thousand points")]
        let count = (self.line.len() + self.inside.len()) as f64;
        (area.abs() / count).sqrt()
    }

    fn dug(mut self, longest: f64) -> Vec<Point> {
        let mut whole: HashSet<[u64; 4]> = HashSet::new();
        while let Some((index, from, to)) = self.longest_edge(longest, &whole) {
            match self.nearest_inside(from, to) {
                Some(place) if self.line.len() < MOST => {
                    let point = self.inside.swap_remove(place);
                    self.line.insert(index + 1, point);
                }
                _ => {
                    whole.insert(key(from, to));
                }
            }
        }
        self.line
    }

    /// The longest edge that may still give way.
    fn longest_edge(&self, least: f64, whole: &HashSet<[u64; 4]>) -> Option<(usize, Point, Point)> {
        let next = self.line.iter().cycle().skip(1);
        let edges = self.line.iter().zip(next).enumerate().map(|(index, (&from, &to))| (index, from, to));
        edges
            .filter(|&(_, from, to)| distance(from, to) > least && !whole.contains(&key(from, to)))
            .max_by(|a, b| distance(a.1, a.2).total_cmp(&distance(b.1, b.2)))
    }

    /// The point from which an edge has the largest angle, so that no other one is in the circle around the three; `None` if
    /// that point is already on the line.
    fn nearest_inside(&self, from: Point, to: Point) -> Option<usize> {
        let seen = |point: &Point| {
            let area = turn(from, to, *point);
            let along = (from.0 - point.0) * (to.0 - point.0) + (from.1 - point.1) * (to.1 - point.1);
            // The cotangent falls as the angle grows; points on the edge itself come first, those in its middle.
            let flat = 1e-9 * distance(from, to).powi(2);
            match area {
                _ if area > flat => Some(along / area),
                _ if area >= -flat && along < 0.0 => Some(1e30 * along / flat),
                _ => None,
            }
        };
        let best = |points: &[Point]| {
            let seen = points.iter().enumerate().filter_map(|(index, point)| Some((index, seen(point)?)));
            seen.min_by(|a, b| a.1.total_cmp(&b.1))
        };
        let (index, cotangent) = best(&self.inside)?;
        best(&self.line).is_none_or(|(_, other)| cotangent < other).then_some(index)
    }
}

fn distance(a: Point, b: Point) -> f64 {
    (a.0 - b.0).hypot(a.1 - b.1)
}

fn key(from: Point, to: Point) -> [u64; 4] {
    [from.0, from.1, to.0, to.1].map(f64::to_bits)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gravity_is_down_and_x_forward() {
        let axes = ViewAxes::with_up([0.0, 1.0, 0.0]);
        assert_eq!(axes.seen([1.0, 2.0, 3.0]), [1.0, 2.0, 3.0]);
        assert_eq!(axes.names(), ["x", "y", "z"]);
        // z up: the right side of one who looks along x is −y.
        let axes = ViewAxes::with_up([0.0, 0.0, 1.0]);
        assert_eq!(axes.seen([1.0, 2.0, 3.0]), [1.0, 3.0, -2.0]);
        assert_eq!(axes.names(), ["x", "z", "−y"]);
        // x up: y is forward.
        assert_eq!(ViewAxes::with_up([1.0, 0.0, 0.0]).names(), ["y", "x", "−z"]);
        // A slope of 3 to 4.
        let axes = ViewAxes::with_up([-0.6, 0.8, 0.0]);
        assert_eq!(axes.names(), ["forward", "up", "z"]);
        let [x, y, z] = axes.forward;
        assert!((x - 0.8).abs() < 1e-15 && (y - 0.6).abs() < 1e-15 && z == 0.0);
    }

    /// Points on the edge of a bridge: 10 long, 4 high, with a hollow of 6 by 2 below.
    fn bridge() -> Vec<Point> {
        let across = (0..=200).map(|index| 0.05 * f64::from(index));
        let mut points: Vec<Point> =
            across.flat_map(|x| [(x, 4.0), (x, if (2.0..=8.0).contains(&x) { 2.0 } else { 0.0 })]).collect();
        let up = |x: f64, to: f64| (0..=80).map(move |index| (x, to * f64::from(index) / 80.0));
        points.extend(up(0.0, 4.0).chain(up(10.0, 4.0)).chain(up(2.0, 2.0)).chain(up(8.0, 2.0)));
        points
    }

    /// Gauss's formula.
    fn area(line: &[Point]) -> f64 {
        let next = line.iter().cycle().skip(1);
        line.iter().zip(next).map(|(a, b)| (a.0 * b.1 - b.0 * a.1) / 2.0).sum()
    }

    fn holds(line: &[Point], point: Point) -> bool {
        let next = line.iter().cycle().skip(1);
        let edges = line.iter().zip(next);
        let on = |a: Point, b: Point| {
            turn(a, b, point).abs() < 1e-12 * distance(a, b) + 1e-12
                && distance(a, point) + distance(point, b) < distance(a, b) + 1e-9
        };
        let crosses = |a: Point, b: Point| {
            (a.1 > point.1) != (b.1 > point.1) && point.0 < (b.0 - a.0) * (point.1 - a.1) / (b.1 - a.1) + a.0
        };
        edges.clone().any(|(a, b)| on(*a, *b)) || edges.filter(|(a, b)| crosses(**a, **b)).count() % 2 == 1
    }

    #[test]
    fn hollows_stay() {
        let line = silhouette(&bridge());
        // 10 by 4 less 6 by 2; a convex hull would have 40. The two corners of the hollow may be cut by an edge of 1.6.
        let seen = area(&line);
        assert!((seen - 28.0).abs() < 1.3, "{seen}: {line:?}");
    }

    #[test]
    fn no_point_is_outside() {
        // A point that is left out because another one is close to it may be outside by a cell.
        let line = silhouette(&bridge());
        for point in bridge() {
            let near = line.iter().any(|corner| distance(*corner, point) < 0.1);
            assert!(near || holds(&line, point), "{point:?} is outside of {line:?}");
        }
    }

    #[test]
    fn toes_are_toes() {
        // Three rays from the origin, 10 long, 30 degrees apart, with points every 0.5 on both sides of each.
        let ray = |angle: f64| {
            (0..=20).flat_map(move |index| {
                let (r, (s, c)) = (0.5 * f64::from(index), angle.to_radians().sin_cos());
                [0.3, -0.3].map(|side| (r * c - side * s, r * s + side * c))
            })
        };
        let line = silhouette(&[-30.0, 0.0, 30.0].into_iter().flat_map(ray).collect::<Vec<_>>());
        // Between the tips there is nothing.
        for angle in [-15.0_f64, 15.0] {
            let (s, c) = angle.to_radians().sin_cos();
            assert!(!holds(&line, (9.0 * c, 9.0 * s)), "{line:?}");
        }
        assert!(holds(&line, (9.0, 0.0)));
    }

    #[test]
    fn points_in_a_line_have_no_line_around_them() {
        assert!(silhouette(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)]).is_empty());
        assert!(silhouette(&[(0.0, 0.0), (1.0, 1.0)]).is_empty() && silhouette(&[]).is_empty());
        assert!(silhouette(&[(f64::NAN, 0.0), (0.0, 1.0), (1.0, 0.0)]).is_empty());
        assert_eq!(silhouette(&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]).len(), 3);
    }
}
