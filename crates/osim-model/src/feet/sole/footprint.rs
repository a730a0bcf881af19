//! The footprint of a foot: the part near the ground, the tilt against the ground, and the outline from below. Also chooses the places of
//! sphere bottoms.

use glam::{DVec2, DVec3};

use crate::feet::convex_hull::{convex_hull, distance, sort_and_dedup, twice_area};
use crate::model::{Side, least_and_most};

/// A foot lies flat if its bone points near the ground cover at least this part of its length and width.
pub(crate) const FLAT_SIDE_SHARE: f64 = 0.8;
/// The largest tilt of a foot that covers less, but is round and so still counts as flat, rad: 5 degrees.
const MOST_TILT_OF_ROUND_FOOT_RAD: f64 = 0.087;
/// The largest tilt of a foot that lies flat, rad: 10 degrees. The bones of flat human feet rise by up to 4 degrees to the front and 8
/// degrees to the side.
const MOST_TILT_RAD: f64 = 0.175;

/// The part of a foot that is near the ground at the default pose, seen from above.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Footprint {
    /// Length of the whole foot, m.
    pub length_m: f64,
    /// The extent of bone points near the ground along the foot's length, as a part of this length: 1 is all of it.
    pub share_of_length: f64,
    /// The extent of bone points near the ground along the foot's width, as a part of this width.
    pub share_of_width: f64,
    /// How much the front of the foot is raised (below 0: lowered), as an angle, rad: the slope of the line on which the bones would stand.
    pub pitch_rad: f64,
    /// How much the outer side of the foot is raised, as an angle, rad.
    pub roll_rad: f64,
}

impl Footprint {
    /// Whether the foot lies flat. Points near the ground cover most of a flat foot and the tilt is small; if they cover less, the tilt
    /// must be very small.
    pub fn is_flat(&self) -> bool {
        let flat = |share: f64, tilt: f64| {
            let most = if share >= FLAT_SIDE_SHARE { MOST_TILT_RAD } else { MOST_TILT_OF_ROUND_FOOT_RAD };
            tilt.abs() < most
        };
        flat(self.share_of_length, self.pitch_rad) && flat(self.share_of_width, self.roll_rad)
    }

    /// The footprint of a foot. `flat` are all its points, `near` those near the ground.
    pub(super) fn around(flat: &[GroundPoint], near: &[DVec2]) -> Self {
        let mut whole: Vec<DVec2> = flat.iter().map(|point| point.at).collect();
        sort_and_dedup(&mut whole);
        // Along the longest diameter if that is long enough, else forward.
        let far = farthest_corners(&convex_hull(&whole));
        let ahead = direction_of(&far, farthest_pair(&far));
        let across = ahead.perp();
        let share = |direction| {
            let all = extent(&whole, direction);
            if all > 0.0 { extent(near, direction) / all } else { 1.0 }
        };
        let pitch =
            resting_slope(flat.iter().map(|point| DVec2::new(point.at.dot(ahead), point.height)).collect());
        // Else what is only tilted to the front would look tilted to the side, too.
        let level = |point: &GroundPoint| {
            DVec2::new(point.at.dot(across), point.height - pitch * point.at.dot(ahead))
        };
        let roll = resting_slope(flat.iter().map(level).collect());
        Self {
            length_m: extent(&whole, ahead),
            share_of_length: share(ahead),
            share_of_width: share(across),
            pitch_rad: libm::atan(pitch),
            roll_rad: libm::atan(roll),
        }
    }
}

/// The slope of the line on which points would stand if they were a rigid body. x of a point is along the ground, y its height. The line is
/// the side of the convex hull below the middle of the points.
fn resting_slope(mut points: Vec<DVec2>) -> f64 {
    sort_and_dedup(&mut points);
    let ends = points.first().zip(points.last());
    let middle = ends.map_or(0.0, |(first, last)| 0.5 * (first.x + last.x));
    // The lower side comes first, from the rear to the front.
    let below = convex_hull(&points).windows(2).find_map(|pair| match pair {
        &[a, b] if a.x <= middle && middle < b.x => Some((b.y - a.y) / (b.x - a.x)),
        _ => None,
    });
    below.unwrap_or(0.0)
}

// Points of a foot along the ground: forward, and outward from the middle of the animal.

/// Coordinates are rounded to multiples of this length, m, so that mirror images get exactly the same numbers.
const GRID_SIZE_M: f64 = 1.0 / (1_u64 << 34) as f64;
/// A direction is replaced by an axis of ground if it differs by less than this.
const AXIS_TOLERANCE: f64 = 1e-9;
/// If the limbs of a pair are closer than this, m, their places do not show the direction to the right.
const LEAST_LIMB_DISTANCE_M: f64 = 1e-6;

/// A point of a bone in ground, and the index of its body in the foot.
#[derive(Debug, Clone, Copy)]
pub(super) struct BonePoint {
    pub at: DVec3,
    pub body: usize,
}

/// A point of a bone in coordinates along the ground.
#[derive(Debug, Clone, Copy)]
pub(super) struct GroundPoint {
    /// Distances forward and outward from the foot's rearmost and innermost points, m.
    pub at: DVec2,
    /// Height above the lowest point of the foot, m.
    pub height: f64,
    /// The index of the point's body in the foot.
    pub body: usize,
}

/// The directions in ground that describe a foot: up, forward and outward.
#[derive(Debug, Clone, Copy)]
pub(super) struct FootAxes {
    pub up: DVec3,
    forward: DVec3,
    /// Direction away from the middle of the animal: to the right for a right foot, to the left for a left foot.
    outward: DVec3,
    /// The least component of all points of the foot along `forward`, m.
    rearmost: f64,
    innermost: f64,
    pub lowest: f64,
}

impl FootAxes {
    /// The directions of a foot with `points`. `across` points from the left to the right limb of a pair. Without a pair, forward is x of
    /// ground.
    pub(super) fn of(up: DVec3, side: Option<Side>, points: &[BonePoint], across: Option<DVec3>) -> Self {
        let across = across.and_then(|across| along_ground(up, across, LEAST_LIMB_DISTANCE_M));
        let right = across.map(snapped_to_ground_axis).unwrap_or_else(|| {
            let ahead = along_ground(up, DVec3::X, 0.1).unwrap_or(DVec3::Y);
            ahead.cross(up)
        });
        let outward = if side == Some(Side::Left) { -right } else { right };
        let forward = up.cross(right);
        let least =
            |direction| points.iter().map(|point| point.at.dot(direction)).fold(f64::INFINITY, f64::min);
        Self { up, forward, outward, rearmost: least(forward), innermost: least(outward), lowest: least(up) }
    }

    /// The points in coordinates along the ground.
    pub(super) fn points_along_ground(&self, points: &[BonePoint]) -> Vec<GroundPoint> {
        let from = |point: &BonePoint, direction: DVec3, least: f64| {
            ((point.at.dot(direction) - least) / GRID_SIZE_M).round() * GRID_SIZE_M
        };
        let flat = |point: &BonePoint| GroundPoint {
            at: DVec2::new(
                from(point, self.forward, self.rearmost),
                from(point, self.outward, self.innermost),
            ),
            height: from(point, self.up, self.lowest),
            body: point.body,
        };
        points.iter().map(flat).collect()
    }

    /// The point in ground with the coordinates `at` along the ground and the component `height` along `up`.
    pub(super) fn in_ground(&self, at: DVec2, height: f64) -> DVec3 {
        let (ahead, out) = (at.x + self.rearmost, at.y + self.innermost);
        ahead * self.forward + out * self.outward + height * self.up
    }
}

/// The horizontal part of a vector, made 1 long; `None` if it is shorter than `least`.
fn along_ground(up: DVec3, vector: DVec3, least: f64) -> Option<DVec3> {
    let flat = vector - vector.dot(up) * up;
    let length = flat.length();
    (length >= least).then(|| flat / length)
}

fn snapped_to_ground_axis(direction: DVec3) -> DVec3 {
    let rounded = direction.round();
    if direction.abs_diff_eq(rounded, AXIS_TOLERANCE) { rounded } else { direction }
}

// The outline of a foot, the convex hull of its points along the ground, and where the bottoms of spheres are in it.

/// The centroid of the area inside `corners`; if the area is 0, the centroid of the corners.
pub(super) fn centroid(corners: &[DVec2]) -> Option<DVec2> {
    let &first = corners.first()?;
    let (mut whole, mut sum) = (0.0, DVec2::ZERO);
    for pair in corners.windows(2) {
        let &[a, b] = pair else { continue };
        let area = twice_area(first, a, b);
        whole += area;
        sum += area * (first + a + b) / 3.0;
    }
    if whole > 0.0 {
        return Some(sum / whole);
    }
    let &last = corners.last()?;
    Some(0.5 * (first + last))
}

// Where the bottoms of spheres are in an outline.

/// Bottoms of spheres that are closer than this are refused, m.
const LEAST_BOTTOM_DISTANCE_M: f64 = 1e-3;
/// The spheres at the extreme corners have to reach over this part of the outline's length and width.
const LEAST_COVER_OF_EXTREMES: f64 = 0.9;
/// Extreme corners that are closer than this part of the outline's length count as one.
const LEAST_EXTREME_DISTANCE: f64 = 0.15;
/// An outline that is at least this many times as long as wide has its own lengthwise direction. A rounder one takes the forward direction.
const LEAST_ELONGATION: f64 = 1.5;
/// The number of directions in which the farthest corner of the outline is searched.
const SEARCH_DIRECTIONS: u32 = 48;
/// Values that differ by less than this (relative) are equal, and the first counts: symmetric bones have each value twice.
const EQUALITY_TOLERANCE: f64 = 1e-9;
/// Spheres between the extreme corners are moved apart in at most this many passes.
const MOST_SPREADING_PASSES: usize = 20;

/// Chooses the places of `count` sphere bottoms: first corners of the outline, then points `near` the ground.
///
/// # Errors
/// The number of bottoms that fit, if some would be closer than 1 mm.
pub(super) fn spread_bottoms(corners: &[DVec2], near: &[DVec2], count: usize) -> Result<Vec<DVec2>, usize> {
    if count == 1 {
        return centroid(corners).map(|middle| vec![middle]).ok_or(0);
    }
    let mut bottoms = extreme_corners(corners, count);
    if least_distance(&bottoms) < LEAST_BOTTOM_DISTANCE_M {
        return Err(1);
    }
    let fixed = bottoms.len();
    while bottoms.len() < count {
        match farthest(near, &bottoms) {
            Some((point, distance)) if distance >= LEAST_BOTTOM_DISTANCE_M => bottoms.push(point),
            _ => return Err(bottoms.len()),
        }
    }
    for _ in 0..MOST_SPREADING_PASSES {
        let before = bottoms.clone();
        for index in fixed..count {
            let moved = bottoms.remove(index);
            let distance_now = distance_to(moved, &bottoms);
            let better = farthest(near, &bottoms)
                .filter(|(_, distance)| *distance > distance_now * (1.0 + EQUALITY_TOLERANCE));
            bottoms.insert(index, better.map_or(moved, |(point, _)| point));
        }
        if bottoms == before {
            break;
        }
    }
    Ok(bottoms)
}

/// The corners for the first two, three or four spheres.
fn extreme_corners(corners: &[DVec2], count: usize) -> Vec<DVec2> {
    let far = farthest_corners(corners);
    let long = farthest_pair(&far);
    match count {
        2 => long.to_vec(),
        3 => {
            let [_, rear, outer, inner] = four_directions(direction_of(&far, long));
            separate_extremes(corners, [rear, outer, inner], LEAST_EXTREME_DISTANCE * length_of_line(long))
        }
        _ => {
            let own_extremes = four_extremes(corners, direction_of(&far, long), length_of_line(long));
            if reaches_nearly_as_far(&own_extremes, corners) {
                own_extremes
            } else {
                four_extremes(corners, DVec2::X, length_of_line(long))
            }
        }
    }
}

/// The direction from the rear to the front of an outline, of length 1.
fn direction_of(corners: &[DVec2], long: [DVec2; 2]) -> DVec2 {
    let whole = length_of_line(long);
    let [rear, front] = if long[0].x <= long[1].x { long } else { [long[1], long[0]] };
    let along = (front - rear) / whole;
    if whole > 0.0 && whole >= LEAST_ELONGATION * extent(corners, along.perp()) { along } else { DVec2::X }
}

/// The directions forward, to the rear, outward and inward for a given forward direction.
fn four_directions(forward: DVec2) -> [DVec2; 4] {
    [forward, -forward, forward.perp(), -forward.perp()]
}

/// The farthest corners in the four directions. Corners close together count as one, unless the rest would cover too little.
fn four_extremes(corners: &[DVec2], forward: DVec2, length: f64) -> Vec<DVec2> {
    let some = separate_extremes(corners, four_directions(forward), LEAST_EXTREME_DISTANCE * length);
    if reaches_nearly_as_far(&some, corners) {
        some
    } else {
        separate_extremes(corners, four_directions(forward), LEAST_BOTTOM_DISTANCE_M)
    }
}

/// The farthest corner in each direction, without corners closer than `least` to an earlier one.
fn separate_extremes<const N: usize>(corners: &[DVec2], directions: [DVec2; N], least: f64) -> Vec<DVec2> {
    let mut some: Vec<DVec2> = Vec::new();
    for corner in directions.into_iter().filter_map(|direction| farthest_along(corners, direction)) {
        if distance_to(corner, &some) >= least {
            some.push(corner);
        }
    }
    some
}

/// The corner that is farthest along `direction`; of equal ones the first.
fn farthest_along(corners: &[DVec2], direction: DVec2) -> Option<DVec2> {
    let mut best: Option<(DVec2, f64)> = None;
    for &corner in corners {
        let along = corner.dot(direction);
        // Coordinates are multiples of a small length: what is equal is so.
        if best.is_none_or(|(_, most)| along > most + LEAST_BOTTOM_DISTANCE_M * EQUALITY_TOLERANCE) {
            best = Some((corner, along));
        }
    }
    best.map(|(corner, _)| corner)
}

/// The extent of points along a direction of length 1.
pub(super) fn extent(points: &[DVec2], direction: DVec2) -> f64 {
    let (least, most) = least_and_most(points.iter().map(|point| point.dot(direction)));
    most - least
}

/// Whether the corners in `some` reach nearly as far as the corners in `all`, forward and outward.
fn reaches_nearly_as_far(some: &[DVec2], all: &[DVec2]) -> bool {
    let covered = |direction| extent(some, direction) >= LEAST_COVER_OF_EXTREMES * extent(all, direction);
    covered(DVec2::X) && covered(DVec2::Y)
}

/// The corners that are the farthest in at least one direction, in their order.
fn farthest_corners(corners: &[DVec2]) -> Vec<DVec2> {
    let farthest = (0..SEARCH_DIRECTIONS).filter_map(|turn| {
        let angle = std::f64::consts::TAU * f64::from(turn) / f64::from(SEARCH_DIRECTIONS);
        farthest_along(corners, DVec2::new(libm::cos(angle), libm::sin(angle)))
    });
    let farthest: Vec<DVec2> = farthest.collect();
    corners.iter().filter(|corner| farthest.contains(corner)).copied().collect()
}

/// The two of `corners` that are farthest apart.
fn farthest_pair(corners: &[DVec2]) -> [DVec2; 2] {
    let first = corners.first().copied().unwrap_or_default();
    let mut long = [first, first];
    for (index, &a) in corners.iter().enumerate() {
        for &b in corners.iter().skip(index + 1) {
            if distance(a, b) > length_of_line(long) * (1.0 + EQUALITY_TOLERANCE) {
                long = [a, b];
            }
        }
    }
    long
}

/// The point with the largest distance from its nearest one of `others`, and this distance; of equal ones the first.
fn farthest(points: &[DVec2], others: &[DVec2]) -> Option<(DVec2, f64)> {
    let mut best: Option<(DVec2, f64)> = None;
    for &point in points {
        let distance = distance_to(point, others);
        if best.is_none_or(|(_, largest)| distance > largest * (1.0 + EQUALITY_TOLERANCE)) {
            best = Some((point, distance));
        }
    }
    best
}

fn distance_to(point: DVec2, others: &[DVec2]) -> f64 {
    others.iter().map(|&other| distance(point, other)).fold(f64::INFINITY, f64::min)
}

fn least_distance(points: &[DVec2]) -> f64 {
    let others = |index: usize| points.get(index + 1..).unwrap_or_default();
    let each = points.iter().enumerate().map(|(index, &point)| distance_to(point, others(index)));
    each.fold(f64::INFINITY, f64::min)
}

fn length_of_line([a, b]: [DVec2; 2]) -> f64 {
    distance(a, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_centroid_is_that_of_an_area_or_of_a_line() {
        let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(DVec2::from);
        assert_eq!(centroid(&corners), Some(DVec2::ONE));
        assert_eq!(centroid(&[DVec2::ZERO, DVec2::new(2.0, 2.0)]), Some(DVec2::ONE));
        assert!(centroid(&[]).is_none());
    }
}
