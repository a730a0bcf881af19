//! Places names beside the elements that they name, so that no two names overlap.
//!
//! For each name, places around its point are tried, nearer places first. The cost of a place is its distance, plus costs for
//! everything that the name would hide; the cheapest place is taken. Boxes of names never overlap: there is always room further
//! up or down, because the view can grow.

use crate::figure::Point;
use crate::style::float;

/// Directions around a point in which places are tried: a circle in 16 parts. They are constants, so that a picture is the same
/// on every machine.
const LABEL_DIRECTIONS: [(f64, f64); 16] = [
    (1.0, 0.0),
    (-1.0, 0.0),
    (0.0, -1.0),
    (0.0, 1.0),
    (0.707, -0.707),
    (-0.707, -0.707),
    (0.707, 0.707),
    (-0.707, 0.707),
    (0.924, -0.383),
    (-0.924, -0.383),
    (0.924, 0.383),
    (-0.924, 0.383),
    (0.383, -0.924),
    (-0.383, -0.924),
    (0.383, 0.924),
    (-0.383, 0.924),
];
/// The smallest distance from a point to the nearest edge of its name.
const LEAST_DISTANCE_PT: f64 = 3.0;
/// Each further try places a name farther from its point by this distance, pt.
const DISTANCE_STEP_PT: f64 = 3.5;
/// The largest number of distances at which a place for a name is tried.
const MOST_DISTANCE_STEPS: u32 = 400;
/// Smallest distance between the boxes of two names.
const LABEL_GAP_PT: f64 = 1.0;
/// Distance of a name from its point above which a line connects them.
pub(super) const LEADER_PT: f64 = 5.0;
/// Number of rounds in which all names are placed again around the other names.
const PLACING_ROUNDS: usize = 3;

/// Cost of a place where a circle crosses the box of the name, in points of distance.
const COST_OF_CIRCLE: f64 = 3.0;
/// Cost of a place where a level line crosses the box of the name, in points of distance.
const COST_OF_LEVEL: f64 = 30.0;
/// Cost of a place where the box of the name hides a point, in points of distance.
const COST_OF_POINT: f64 = 60.0;
/// Cost of a place whose line to its point passes near another point, in points of distance.
const COST_OF_LEADER_NEAR_POINT: f64 = 20.0;
/// Cost of a place whose line to its point crosses the line of another name, in points of distance.
const COST_OF_CROSSING: f64 = 40.0;
/// Cost of a place where the line of one name crosses the box of another name, in points of distance.
const COST_OF_OVERLAP_WITH_NAME: f64 = 120.0;

/// A box on the page, in points; y grows downwards.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rect {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
}

impl Rect {
    /// A box of this width and height around its middle.
    fn around((x, y): Point, (width, height): (f64, f64)) -> Self {
        Self {
            left: x - width / 2.0,
            right: x + width / 2.0,
            top: y - height / 2.0,
            bottom: y + height / 2.0,
        }
    }

    /// Whether two boxes overlap or are closer than `apart`.
    pub(super) fn overlaps(&self, other: &Self, apart: f64) -> bool {
        self.left < other.right + apart
            && other.left < self.right + apart
            && self.top < other.bottom + apart
            && other.top < self.bottom + apart
    }

    fn contains_point(&self, (x, y): Point, margin: f64) -> bool {
        x > self.left - margin && x < self.right + margin && y > self.top - margin && y < self.bottom + margin
    }

    /// The point of the box that is nearest to `point`.
    pub(super) fn nearest(&self, (x, y): Point) -> Point {
        (x.clamp(self.left, self.right), y.clamp(self.top, self.bottom))
    }

    /// Whether the line between two points passes through the box (Liang and Barsky).
    fn is_crossed_by(&self, from: Point, to: Point) -> bool {
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        let sides = [
            (to.0 - from.0, self.left - from.0, self.right - from.0),
            (to.1 - from.1, self.top - from.1, self.bottom - from.1),
        ];
        for (along, low, high) in sides {
            if along == 0.0 {
                if low > 0.0 || high < 0.0 {
                    return false;
                }
                continue;
            }
            let (first, second) = (low / along, high / along);
            enter = enter.max(first.min(second));
            leave = leave.min(first.max(second));
        }
        enter < leave
    }
}

/// A name that has no place in the picture yet.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct NameToPlace {
    /// The point that the name is for.
    pub at: Point,
    /// Width and height of the name, pt.
    pub size: (f64, f64),
}

/// Shapes that names should not hide, in points on the page.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Obstacles {
    /// Marked points, which names should not cover.
    pub points: Vec<Point>,
    /// Circles that names should not cover, each with centre and radius.
    pub circles: Vec<(Point, f64)>,
    /// Vertical positions of horizontal lines that names should not cover.
    pub levels: Vec<f64>,
    /// Boxes of texts that are already placed.
    pub boxes: Vec<Rect>,
}

/// A box for each name, in the order of `names`; all boxes are between `left` and `right`, and as far up and down as needed.
pub(super) fn place_names(
    names: &[NameToPlace],
    (left, right): (f64, f64),
    obstacles: &Obstacles,
) -> Vec<Rect> {
    let mut order: Vec<usize> = (0..names.len()).collect();
    let key = |index: usize| names.get(index).map_or((0.0, 0.0), |name| name.at);
    order.sort_by(|&a, &b| key(a).0.total_cmp(&key(b).0).then(key(a).1.total_cmp(&key(b).1)));
    let mut places: Vec<Option<Rect>> = vec![None; names.len()];
    for _ in 0..PLACING_ROUNDS {
        for &index in &order {
            let Some(name) = names.get(index) else { continue };
            let others: Vec<(Point, Rect)> = names
                .iter()
                .zip(&places)
                .enumerate()
                .filter(|(other, _)| *other != index)
                .filter_map(|(_, (other, place))| Some((other.at, (*place)?)))
                .collect();
            let best = name.cheapest_place((left, right), obstacles, &others);
            // What is found later is kept only where it is free: it always is.
            if let Some(place) = places.get_mut(index) {
                *place = best.or(*place);
            }
        }
    }
    let fallback = |name: &NameToPlace| Rect::around(name.at, name.size);
    names.iter().zip(places).map(|(name, place)| place.unwrap_or_else(|| fallback(name))).collect()
}

impl NameToPlace {
    /// The free place with the least cost: distance from the point, and everything that the name or its line would hide. The
    /// place is between the edges `left` and `right` of the view; `others` are the points and the boxes of other names.
    fn cheapest_place(
        &self,
        (left, right): (f64, f64),
        obstacles: &Obstacles,
        others: &[(Point, Rect)],
    ) -> Option<Rect> {
        let (width, height) = self.size;
        let mut best: Option<(f64, Rect)> = None;
        for step in 0..MOST_DISTANCE_STEPS {
            let distance = LEAST_DISTANCE_PT + DISTANCE_STEP_PT * f64::from(step);
            if best.is_some_and(|(cost, _)| distance >= cost) {
                break;
            }
            for (rank, (x, y)) in (0_u32..).zip(LABEL_DIRECTIONS) {
                let along = (x * (distance + width / 2.0), y * (distance + height / 2.0));
                let place = Rect::around((self.at.0 + along.0, self.at.1 + along.1), self.size);
                // Moved sideways so that it is between the edges of the view.
                let by = (left - place.left).max(0.0) - (place.right - right).max(0.0);
                let place = Rect { left: place.left + by, right: place.right + by, ..place };
                let mut texts = others.iter().map(|(_, other)| other).chain(&obstacles.boxes);
                if texts.any(|other| place.overlaps(other, LABEL_GAP_PT)) {
                    continue;
                }
                // Among equal places the first direction wins.
                let cost = distance + self.cost(&place, obstacles, others) + 0.01 * f64::from(rank);
                if best.is_none_or(|(known, _)| cost < known) {
                    best = Some((cost, place));
                }
            }
        }
        best.map(|(_, place)| place)
    }

    /// Cost of a place, besides its distance: everything that the name or its line would hide or cross.
    fn cost(&self, place: &Rect, obstacles: &Obstacles, others: &[(Point, Rect)]) -> f64 {
        let end = place.nearest(self.at);
        let other_points = obstacles.points.iter().filter(|point| **point != self.at);
        let points = other_points.map(|&point| {
            if place.contains_point(point, 2.0) {
                COST_OF_POINT
            } else if distance_to_line(point, self.at, end) < 2.5 {
                COST_OF_LEADER_NEAR_POINT
            } else {
                0.0
            }
        });
        let over_own_point = if place.contains_point(self.at, 1.5) { COST_OF_POINT } else { 0.0 };
        let circles = obstacles.circles.iter().filter(|circle| circle_crosses_box(place, circle));
        let levels = obstacles.levels.iter().filter(|&&y| place.contains_point((place.left, y), 0.5));
        let names = others.iter().map(|(at, other)| {
            let their_end = other.nearest(*at);
            let crossing =
                if segments_cross((self.at, end), (*at, their_end)) { COST_OF_CROSSING } else { 0.0 };
            let over = other.is_crossed_by(self.at, end) || place.is_crossed_by(*at, their_end);
            crossing + if over { COST_OF_OVERLAP_WITH_NAME } else { 0.0 }
        });
        over_own_point
            + points.sum::<f64>()
            + COST_OF_CIRCLE * float(circles.count())
            + COST_OF_LEVEL * float(levels.count())
            + names.sum::<f64>()
    }
}

/// Whether the line of a circle passes through the box of a name.
fn circle_crosses_box(place: &Rect, &(centre, radius): &(Point, f64)) -> bool {
    let nearest = place.nearest(centre);
    let far = |low: f64, high: f64, at: f64| if (at - low).abs() > (high - at).abs() { low } else { high };
    let farthest = (far(place.left, place.right, centre.0), far(place.top, place.bottom, centre.1));
    distance(nearest, centre) < radius && radius < distance(farthest, centre)
}

fn distance(a: Point, b: Point) -> f64 {
    ((a.0 - b.0) * (a.0 - b.0) + (a.1 - b.1) * (a.1 - b.1)).sqrt()
}

fn distance_to_line(point: Point, from: Point, to: Point) -> f64 {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let length = dx * dx + dy * dy;
    let along =
        if length == 0.0 { 0.0 } else { ((point.0 - from.0) * dx + (point.1 - from.1) * dy) / length };
    let along = along.clamp(0.0, 1.0);
    distance(point, (from.0 + along * dx, from.1 + along * dy))
}

fn segments_cross((a, b): (Point, Point), (c, d): (Point, Point)) -> bool {
    let side = |p: Point, q: Point, r: Point| (q.0 - p.0) * (r.1 - p.1) - (q.1 - p.1) * (r.0 - p.0);
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(points: &[Point]) -> Vec<NameToPlace> {
        points.iter().map(|&at| NameToPlace { at, size: (40.0, 8.0) }).collect()
    }

    #[track_caller]
    fn assert_apart(places: &[Rect]) {
        for (index, first) in places.iter().enumerate() {
            assert!(first.left >= -1e-9 && first.right <= 200.0 + 1e-9, "{first:?}");
            assert!(places[..index].iter().all(|second| !first.overlaps(second, 0.0)), "{places:?}");
        }
    }

    #[test]
    fn a_single_name_is_right_of_its_point() {
        let places = place_names(&names(&[(50.0, 50.0)]), (0.0, 200.0), &Obstacles::default());
        assert_eq!(places, [Rect { left: 53.0, right: 93.0, top: 46.0, bottom: 54.0 }]);
    }

    #[test]
    fn names_at_an_edge_stay_inside() {
        let places = place_names(&names(&[(199.0, 50.0), (1.0, 50.0)]), (0.0, 200.0), &Obstacles::default());
        assert_apart(&places);
    }

    #[test]
    fn a_hundred_names_of_one_point_have_a_place_each() {
        assert_apart(&place_names(&names(&[(100.0, 50.0); 100]), (0.0, 200.0), &Obstacles::default()));
    }

    #[test]
    fn names_keep_off_lines_and_other_points() {
        let obstacles = Obstacles {
            points: vec![(50.0, 50.0), (60.0, 50.0)],
            levels: vec![52.0],
            ..Obstacles::default()
        };
        let places = place_names(&names(&[(50.0, 50.0), (60.0, 50.0)]), (0.0, 200.0), &obstacles);
        assert_apart(&places);
        for rect in places {
            assert!(!rect.contains_point((rect.left, 52.0), 0.0), "{rect:?}");
            assert!(obstacles.points.iter().all(|&point| !rect.contains_point(point, 0.0)), "{rect:?}");
        }
    }

    #[test]
    fn a_line_through_a_corner_is_seen() {
        let rect = Rect { left: 0.0, right: 10.0, top: 0.0, bottom: 10.0 };
        assert!(
            rect.is_crossed_by((-5.0, 5.0), (15.0, 6.0)) && !rect.is_crossed_by((-5.0, -1.0), (15.0, -1.0))
        );
        assert!(!rect.is_crossed_by((-5.0, 5.0), (-1.0, 5.0)) && rect.is_crossed_by((5.0, -3.0), (5.0, 3.0)));
    }
}
