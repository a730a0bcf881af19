//! The directions for the views of a foot, and the outline of points.

use foldhash::{HashSet, HashSetExt};
use glam::{DVec2, DVec3};

use crate::feet::convex_hull::{convex_hull, distance, sort_and_dedup, twice_area};
use crate::model::Model;

/// The names of the three axes of a frame and of their opposite directions.
const AXIS_NAMES: [[&str; 2]; 3] = [["x", "−x"], ["y", "−y"], ["z", "−z"]];

/// Three directions of length 1 for the views of a foot. They are given in the frame in which the foot is drawn: ground, or a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViewAxes {
    /// Along x of the frame, but level; along y if x points up or down.
    pub forward: DVec3,
    /// The upward direction of the view, opposite to gravity.
    pub up: DVec3,
    /// The direction to the right: forward × up.
    pub right: DVec3,
}

impl ViewAxes {
    /// The directions for a model: up is opposite to its gravity.
    pub fn of(model: &Model) -> Self {
        Self::with_up(model.up())
    }

    /// The directions for a given `up`, which has length 1.
    pub fn with_up(up: DVec3) -> Self {
        let forward = if up.x.abs() > 0.9 { DVec3::Y } else { DVec3::X };
        let level = forward - forward.dot(up) * up;
        let forward = level / level.length();
        Self { forward, up, right: forward.cross(up) }
    }

    /// The coordinates of a point along the three directions: forward, up and right, m.
    pub fn coordinates(&self, point_m: DVec3) -> [f64; 3] {
        [self.forward, self.up, self.right].map(|axis| axis.dot(point_m))
    }

    /// Names of the three directions: `x`, `y` and `z` if gravity points along −y; words if a direction is not along an axis.
    pub fn names(&self) -> [&'static str; 3] {
        let axis = |direction: DVec3, word| {
            let name_along = |(i, [along, against]): (usize, [&'static str; 2])| match direction[i] {
                value if value > 1.0 - 1e-12 => Some(along),
                value if value < 1e-12 - 1.0 => Some(against),
                _ => None,
            };
            AXIS_NAMES.into_iter().enumerate().find_map(name_along).unwrap_or(word)
        };
        [axis(self.forward, "forward"), axis(self.up, "up"), axis(self.right, "right")]
    }
}

// The line around points.

/// An edge of an outline that is longer than this part of the outline's larger side is replaced by two edges through a point inside.
const LONGEST_EDGE_OF_OUTLINE: f64 = 0.06;
/// An edge is replaced only if it is also longer than this many times the mean distance of neighbouring points.
const LONGEST_EDGE_OVER_SPACING: f64 = 5.0;
/// Points inside the outline that are closer than this part of its size count as one point.
const ONE_POINT_SHARE: f64 = 1.0 / 150.0;
/// The largest number of corners of an outline; then no further edge is replaced.
const MOST_CORNERS: usize = 600;

/// The closed outline of points in a plane; the first point is not repeated at the end. Starts from the convex hull. The longest edge is
/// again and again replaced by two edges through a point inside, until no edge is longer than 6 % of the width or height, or a few times
/// the distance of points (the characteristic shape of Duckham, Kulik, Worboys and Galton, Pattern Recognition 41, 2008). No point is
/// outside, and the outline does not cross itself.
///
/// Empty for fewer than three points, or points on a straight line.
pub fn silhouette(points: &[DVec2]) -> Vec<DVec2> {
    if points.iter().any(|point| !point.is_finite()) {
        return Vec::new();
    }
    let mut sorted = points.to_vec();
    sort_and_dedup(&mut sorted);
    let hull = convex_hull(&sorted);
    if hull.len() < 3 {
        return Vec::new();
    }
    let corners = || hull.iter().copied();
    let span = corners().fold(DVec2::NEG_INFINITY, DVec2::max) - corners().fold(DVec2::INFINITY, DVec2::min);
    let size = span.max_element();
    let outline = Outline::new(points, hull, ONE_POINT_SHARE * size);
    let longest = (LONGEST_EDGE_OF_OUTLINE * size).max(LONGEST_EDGE_OVER_SPACING * outline.spacing());
    outline.with_short_edges(longest)
}

/// An outline while its long edges are being replaced.
struct Outline {
    line: Vec<DVec2>,
    inside: Vec<DVec2>,
}

impl Outline {
    /// The convex `hull` of `points` as a first outline; of the points inside, one in each square of the size `cell` is kept.
    fn new(points: &[DVec2], hull: Vec<DVec2>, cell: f64) -> Self {
        let cell_of = |point: &DVec2| ((point.x / cell).round() as i64, (point.y / cell).round() as i64);
        let mut taken: HashSet<(i64, i64)> = hull.iter().map(cell_of).collect();
        let inside = points.iter().filter(|point| taken.insert(cell_of(point))).copied().collect();
        Self { line: hull, inside }
    }

    /// The mean distance between neighbouring points, if the same number of points were spread evenly over the area of the outline.
    fn spacing(&self) -> f64 {
        let next = self.line.iter().cycle().skip(1);
        let area: f64 = self.line.iter().zip(next).map(|(a, b)| a.perp_dot(*b) / 2.0).sum();
        let count = (self.line.len() + self.inside.len()) as f64;
        (area.abs() / count).sqrt()
    }

    fn with_short_edges(mut self, longest: f64) -> Vec<DVec2> {
        let mut final_edges: HashSet<[u64; 4]> = HashSet::new();
        while let Some((index, from, to)) = self.longest_edge(longest, &final_edges) {
            match self.nearest_inside(from, to) {
                Some(place) if self.line.len() < MOST_CORNERS => {
                    let point = self.inside.swap_remove(place);
                    self.line.insert(index + 1, point);
                }
                _ => {
                    final_edges.insert(edge_key(from, to));
                }
            }
        }
        self.line
    }

    /// The longest edge that is longer than `least` and is not marked as final.
    fn longest_edge(&self, least: f64, final_edges: &HashSet<[u64; 4]>) -> Option<(usize, DVec2, DVec2)> {
        let next = self.line.iter().cycle().skip(1);
        let edges = self.line.iter().zip(next).enumerate().map(|(index, (&from, &to))| (index, from, to));
        edges
            .filter(|&(_, from, to)| distance(from, to) > least && !final_edges.contains(&edge_key(from, to)))
            .max_by(|a, b| distance(a.1, a.2).total_cmp(&distance(b.1, b.2)))
    }

    /// The index of the point inside that sees the edge under the largest angle. No other point is then in the circle through it and the
    /// ends of the edge. `None` if a corner of the outline sees the edge under a larger angle.
    fn nearest_inside(&self, from: DVec2, to: DVec2) -> Option<usize> {
        let seen = |point: &DVec2| {
            let area = twice_area(from, to, *point);
            let along = (from - *point).dot(to - *point);
            // The cotangent falls as the angle grows; points on the edge itself come first, those in its middle.
            let flat = 1e-9 * distance(from, to).powi(2);
            match area {
                _ if area > flat => Some(along / area),
                _ if area >= -flat && along < 0.0 => Some(1e30 * along / flat),
                _ => None,
            }
        };
        let best = |points: &[DVec2]| {
            let seen = points.iter().enumerate().filter_map(|(index, point)| Some((index, seen(point)?)));
            seen.min_by(|a, b| a.1.total_cmp(&b.1))
        };
        let (index, cotangent) = best(&self.inside)?;
        best(&self.line).is_none_or(|(_, other)| cotangent < other).then_some(index)
    }
}

fn edge_key(from: DVec2, to: DVec2) -> [u64; 4] {
    [from.x, from.y, to.x, to.y].map(f64::to_bits)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gravity_is_down_and_x_forward() {
        let axes = ViewAxes::with_up(DVec3::Y);
        assert_eq!(axes.coordinates(DVec3::new(1.0, 2.0, 3.0)), [1.0, 2.0, 3.0]);
        assert_eq!(axes.names(), ["x", "y", "z"]);
        // z up: the right side of one who looks along x is −y.
        let axes = ViewAxes::with_up(DVec3::Z);
        assert_eq!(axes.coordinates(DVec3::new(1.0, 2.0, 3.0)), [1.0, 3.0, -2.0]);
        assert_eq!(axes.names(), ["x", "z", "−y"]);
        // x up: y is forward.
        assert_eq!(ViewAxes::with_up(DVec3::X).names(), ["y", "x", "−z"]);
        // A slope of 3 to 4.
        let axes = ViewAxes::with_up(DVec3::new(-0.6, 0.8, 0.0));
        assert_eq!(axes.names(), ["forward", "up", "z"]);
        assert!(axes.forward.abs_diff_eq(DVec3::new(0.8, 0.6, 0.0), 1e-15));
    }

    /// Points on the edge of a bridge: 10 long, 4 high, with an opening of 6 by 2 below.
    fn edge_points_of_bridge() -> Vec<DVec2> {
        let across = (0..=200).map(|index| 0.05 * f64::from(index));
        let below = |x: f64| if (2.0..=8.0).contains(&x) { 2.0 } else { 0.0 };
        let mut points: Vec<DVec2> =
            across.flat_map(|x| [DVec2::new(x, 4.0), DVec2::new(x, below(x))]).collect();
        let up = |x: f64, to: f64| (0..=80).map(move |index| DVec2::new(x, to * f64::from(index) / 80.0));
        points.extend(up(0.0, 4.0).chain(up(10.0, 4.0)).chain(up(2.0, 2.0)).chain(up(8.0, 2.0)));
        points
    }

    /// Area inside a closed line, by Gauss's formula.
    fn area_inside(line: &[DVec2]) -> f64 {
        let next = line.iter().cycle().skip(1);
        line.iter().zip(next).map(|(a, b)| a.perp_dot(*b) / 2.0).sum()
    }

    fn contains(line: &[DVec2], point: DVec2) -> bool {
        let next = line.iter().cycle().skip(1);
        let edges = line.iter().zip(next);
        let on = |a: DVec2, b: DVec2| {
            twice_area(a, b, point).abs() < 1e-12 * distance(a, b) + 1e-12
                && distance(a, point) + distance(point, b) < distance(a, b) + 1e-9
        };
        let crosses = |a: DVec2, b: DVec2| {
            (a.y > point.y) != (b.y > point.y) && point.x < (b.x - a.x) * (point.y - a.y) / (b.y - a.y) + a.x
        };
        edges.clone().any(|(a, b)| on(*a, *b)) || edges.filter(|(a, b)| crosses(**a, **b)).count() % 2 == 1
    }

    #[test]
    fn the_silhouette_of_a_foot_keeps_hollows() {
        let line = silhouette(&edge_points_of_bridge());
        // 10 by 4 less 6 by 2; a convex hull would have 40. The two corners of the hollow may be cut by an edge of 1.6.
        let seen = area_inside(&line);
        assert!((seen - 28.0).abs() < 1.3, "{seen}: {line:?}");
    }

    #[test]
    fn no_point_is_outside_a_silhouette() {
        // A point that is left out because another one is close to it may be outside by a cell.
        let line = silhouette(&edge_points_of_bridge());
        for point in edge_points_of_bridge() {
            let near = line.iter().any(|corner| distance(*corner, point) < 0.1);
            assert!(near || contains(&line, point), "{point:?} is outside of {line:?}");
        }
    }

    #[test]
    fn the_silhouette_of_a_foot_keeps_toes_apart() {
        // Three rays from the origin, 10 long, 30 degrees apart, with points every 0.5 on both sides of each.
        let ray = |angle: f64| {
            (0..=20).flat_map(move |index| {
                let (r, (s, c)) = (0.5 * f64::from(index), angle.to_radians().sin_cos());
                [0.3, -0.3].map(|side| DVec2::new(r * c - side * s, r * s + side * c))
            })
        };
        let line = silhouette(&[-30.0, 0.0, 30.0].into_iter().flat_map(ray).collect::<Vec<_>>());
        // Between the tips there is nothing.
        for angle in [-15.0_f64, 15.0] {
            let (s, c) = angle.to_radians().sin_cos();
            assert!(!contains(&line, DVec2::new(9.0 * c, 9.0 * s)), "{line:?}");
        }
        assert!(contains(&line, DVec2::new(9.0, 0.0)));
    }

    #[test]
    fn points_in_a_line_have_no_line_around_them() {
        let corners = |points: &[(f64, f64)]| {
            silhouette(&points.iter().copied().map(DVec2::from).collect::<Vec<_>>()).len()
        };
        assert_eq!(corners(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)]), 0);
        assert_eq!((corners(&[(0.0, 0.0), (1.0, 1.0)]), corners(&[])), (0, 0));
        assert_eq!(corners(&[(f64::NAN, 0.0), (0.0, 1.0), (1.0, 0.0)]), 0);
        assert_eq!(corners(&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]), 3);
    }
}
