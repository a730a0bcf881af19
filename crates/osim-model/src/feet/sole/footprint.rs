//! How much of a foot is near the ground, how far it is from lying flat, and its outline from below.

use glam::{DVec2, DVec3};

use crate::feet::convex_hull::{convex_hull, distance, sort_and_dedup, twice_area};
use crate::model::Side;

/// The bone points near the ground of a flat foot cover at least this part of its length and of its width.
pub(crate) const FLAT_SHARE: f64 = 0.8;
/// A foot that covers less counts as round, and flat, if it is tilted by less than this, rad: 5 degrees.
const LEAST_TILT: f64 = 0.087;
/// A foot that is tilted by more than this does not lie flat, whatever it covers, rad: 10 degrees. Bones of human feet that do rise by up to
/// 4 degrees to the front and 8 to the side.
const MOST_TILT_RAD: f64 = 0.175;

/// How much of a foot is near the ground at the default pose, seen from above.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Footprint {
    /// The whole foot's length, m.
    pub length_m: f64,
    /// The part of the foot's length over which bone points near the ground reach: 1 is all of it.
    pub share_of_length: f64,
    /// The part of the foot's width over which bone points near the ground reach.
    pub share_of_width: f64,
    /// How far the front is up (below 0: down), seen from the side, rad: the slope of the line on which the bones would rest.
    pub pitch_rad: f64,
    /// How far the outer side is up, seen from the front, rad.
    pub roll_rad: f64,
}

impl Footprint {
    /// Whether the foot lies flat: points near the ground cover most of it, or it is round, and it is not tilted.
    pub fn is_flat(&self) -> bool {
        let flat = |share: f64, tilt: f64| {
            let most = if share >= FLAT_SHARE { MOST_TILT_RAD } else { LEAST_TILT };
            tilt.abs() < most
        };
        flat(self.share_of_length, self.pitch_rad) && flat(self.share_of_width, self.roll_rad)
    }

    /// The footprint of all points of a foot; those `near` the ground are given, too.
    pub(super) fn of(flat: &[FlatPoint], near: &[DVec2]) -> Self {
        let mut whole: Vec<DVec2> = flat.iter().map(|point| point.at).collect();
        sort_and_dedup(&mut whole);
        let ahead = lengthwise(&convex_hull(&whole));
        let across = ahead.perp();
        let share = |direction| {
            let all = extent(&whole, direction);
            if all > 0.0 { extent(near, direction) / all } else { 1.0 }
        };
        let pitch =
            resting_slope(flat.iter().map(|point| DVec2::new(point.at.dot(ahead), point.height)).collect());
        // Else what is only tilted to the front would look tilted to the side, too.
        let level =
            |point: &FlatPoint| DVec2::new(point.at.dot(across), point.height - pitch * point.at.dot(ahead));
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

/// The slope of the line on which points rest, which are along the ground and above it: of the side of their convex hull below
/// their middle.
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

/// Coordinates are multiples of this, m: those of a mirror image become the same numbers, whatever was rounded before.
const GRID: f64 = 1.0 / (1_u64 << 34) as f64;
/// A direction as close as this to an axis of ground is that axis.
const SAME_DIRECTION: f64 = 1e-9;
/// If the limbs of a pair are closer than this, their places do not give the direction to the right, m.
const LEAST_LIMB_DISTANCE_M: f64 = 1e-6;

/// A point of a bone in ground, and the place of its body among those of the foot.
#[derive(Debug, Clone, Copy)]
pub(super) struct BonePoint {
    pub at: DVec3,
    pub body: usize,
}

/// A point of a foot along the ground.
#[derive(Debug, Clone, Copy)]
pub(super) struct FlatPoint {
    /// Forward and outward from the foot's own rearmost and innermost point, m.
    pub at: DVec2,
    /// Height above the lowest point of the foot, m.
    pub height: f64,
    /// The place of its body among those of the foot.
    pub body: usize,
}

/// Directions in ground in which a foot is described.
#[derive(Debug, Clone, Copy)]
pub(super) struct FootAxes {
    pub up: DVec3,
    forward: DVec3,
    /// Direction to the right of a right foot and to the left of a left one.
    outward: DVec3,
    /// The least value of the foot's points along the directions.
    rearmost: f64,
    innermost: f64,
    pub lowest: f64,
}

impl FootAxes {
    /// The axes of a foot with `points`. `across` is from the left to the right limb of a pair; without one, forward is x of ground.
    pub(super) fn of(up: DVec3, side: Option<Side>, points: &[BonePoint], across: Option<DVec3>) -> Self {
        let across = across.and_then(|across| along_ground(up, across, LEAST_LIMB_DISTANCE_M));
        let right = across.map(axis_of_ground).unwrap_or_else(|| {
            let ahead = along_ground(up, DVec3::X, 0.1).unwrap_or(DVec3::Y);
            ahead.cross(up)
        });
        let outward = if side == Some(Side::Left) { -right } else { right };
        let forward = up.cross(right);
        let least =
            |direction| points.iter().map(|point| point.at.dot(direction)).fold(f64::INFINITY, f64::min);
        Self { up, forward, outward, rearmost: least(forward), innermost: least(outward), lowest: least(up) }
    }

    /// The points projected onto these directions.
    pub(super) fn flat(&self, points: &[BonePoint]) -> Vec<FlatPoint> {
        let from = |point: &BonePoint, direction, least| on_grid(point.at.dot(direction) - least);
        let flat = |point: &BonePoint| FlatPoint {
            at: DVec2::new(
                from(point, self.forward, self.rearmost),
                from(point, self.outward, self.innermost),
            ),
            height: from(point, self.up, self.lowest),
            body: point.body,
        };
        points.iter().map(flat).collect()
    }

    /// The point in ground that is `at` along the ground and has the component `height` along up.
    pub(super) fn in_ground(&self, at: DVec2, height: f64) -> DVec3 {
        let (ahead, out) = (at.x + self.rearmost, at.y + self.innermost);
        ahead * self.forward + out * self.outward + height * self.up
    }
}

fn on_grid(value: f64) -> f64 {
    (value / GRID).round() * GRID
}

/// The part of a vector along the ground, with length 1; `None` if it is shorter than `least`.
fn along_ground(up: DVec3, vector: DVec3, least: f64) -> Option<DVec3> {
    let flat = vector - vector.dot(up) * up;
    let length = flat.length();
    (length >= least).then(|| flat / length)
}

fn axis_of_ground(direction: DVec3) -> DVec3 {
    let rounded = direction.round();
    if direction.abs_diff_eq(rounded, SAME_DIRECTION) { rounded } else { direction }
}

// The outline of a foot, the convex hull of its points along the ground, and where the bottoms of spheres are in it.

/// The middle of the area that `corners` enclose; if they enclose none, that of the corners.
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

/// Bottoms closer than this are refused, m.
const LEAST_BOTTOM_DISTANCE_M: f64 = 1e-3;
/// The extremes cover this part of the outline's length and of its width.
const EXTREMES_COVER: f64 = 0.9;
/// Extremes are one where they are closer than this part of the length.
const LEAST_EXTREME_DISTANCE: f64 = 0.15;
/// An outline that is this many times as long as wide has a direction of its own; a shorter one points forward.
const LEAST_ELONGATION: f64 = 1.5;
/// Directions in which the farthest corners of the outline are looked at.
const DIRECTIONS: u32 = 48;
/// Values that differ by less than this part are equal, and the first counts: bones that are their own mirror image have two of each.
const EQUALITY_TOLERANCE: f64 = 1e-9;
/// How often spheres between the extremes are moved, at most.
const MOST_SPREADING_PASSES: usize = 20;

/// `count` bottoms: in the `corners` of the outline, and for the rest under some of the points that are `near` the ground.
///
/// # Errors
/// How many fit, where some would be closer than 1 mm.
pub(super) fn spread_bottoms(corners: &[DVec2], near: &[DVec2], count: usize) -> Result<Vec<DVec2>, usize> {
    if count == 1 {
        return centroid(corners).map(|middle| vec![middle]).ok_or(0);
    }
    let mut bottoms = extremes(corners, count);
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

/// The corners under which the first two, three or four spheres stand.
fn extremes(corners: &[DVec2], count: usize) -> Vec<DVec2> {
    let far = farthest_corners(corners);
    let long = diameter(&far);
    match count {
        2 => long.to_vec(),
        3 => {
            let [_, rear, outer, inner] = four_directions(direction_of(&far, long));
            separate_extremes(corners, [rear, outer, inner], LEAST_EXTREME_DISTANCE * length(long))
        }
        _ => {
            let own_extremes = four_extremes(corners, direction_of(&far, long), length(long));
            if covers(&own_extremes, corners) {
                own_extremes
            } else {
                four_extremes(corners, DVec2::X, length(long))
            }
        }
    }
}

/// The direction from the rear to the front of an outline, of length 1: its own if it is long, else forward.
pub(super) fn lengthwise(corners: &[DVec2]) -> DVec2 {
    let far = farthest_corners(corners);
    direction_of(&far, diameter(&far))
}

fn direction_of(corners: &[DVec2], long: [DVec2; 2]) -> DVec2 {
    let whole = length(long);
    let [rear, front] = if long[0].x <= long[1].x { long } else { [long[1], long[0]] };
    let along = (front - rear) / whole;
    if whole > 0.0 && whole >= LEAST_ELONGATION * extent(corners, along.perp()) { along } else { DVec2::X }
}

/// Forward, to the rear, outward and inward, where forward is a direction.
fn four_directions(forward: DVec2) -> [DVec2; 4] {
    [forward, -forward, forward.perp(), -forward.perp()]
}

/// The corners that are farthest in the four directions; each place once, unless all are needed.
fn four_extremes(corners: &[DVec2], forward: DVec2, length: f64) -> Vec<DVec2> {
    let some = separate_extremes(corners, four_directions(forward), LEAST_EXTREME_DISTANCE * length);
    if covers(&some, corners) {
        some
    } else {
        separate_extremes(corners, four_directions(forward), LEAST_BOTTOM_DISTANCE_M)
    }
}

/// The corners that are farthest in some directions, without those that are close to one before.
fn separate_extremes<const N: usize>(corners: &[DVec2], directions: [DVec2; N], least: f64) -> Vec<DVec2> {
    let mut some: Vec<DVec2> = Vec::new();
    for corner in directions.into_iter().filter_map(|direction| farthest_along(corners, direction)) {
        if distance_to(corner, &some) >= least {
            some.push(corner);
        }
    }
    some
}

/// The one of `corners` that is farthest along `direction`; of equal ones the first.
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

/// How far points reach along a direction of length 1.
pub(super) fn extent(points: &[DVec2], direction: DVec2) -> f64 {
    let along = |point: &DVec2| point.dot(direction);
    let least = points.iter().map(along).fold(f64::INFINITY, f64::min);
    points.iter().map(along).fold(f64::NEG_INFINITY, f64::max) - least
}

/// Whether `some` corners reach nearly as far as all of them, forward and outward.
fn covers(some: &[DVec2], all: &[DVec2]) -> bool {
    let covered = |direction| extent(some, direction) >= EXTREMES_COVER * extent(all, direction);
    covered(DVec2::X) && covered(DVec2::Y)
}

/// The corners that are farthest in some direction, in their order.
fn farthest_corners(corners: &[DVec2]) -> Vec<DVec2> {
    let farthest = (0..DIRECTIONS).filter_map(|turn| farthest_along(corners, direction_at(turn)));
    let farthest: Vec<DVec2> = farthest.collect();
    corners.iter().filter(|corner| farthest.contains(corner)).copied().collect()
}

fn direction_at(turn: u32) -> DVec2 {
    let angle = std::f64::consts::TAU * f64::from(turn) / f64::from(DIRECTIONS);
    DVec2::new(libm::cos(angle), libm::sin(angle))
}

/// The two corners that are farthest apart.
fn diameter(corners: &[DVec2]) -> [DVec2; 2] {
    let first = corners.first().copied().unwrap_or_default();
    let mut long = [first, first];
    for (index, &a) in corners.iter().enumerate() {
        for &b in corners.iter().skip(index + 1) {
            if distance(a, b) > length(long) * (1.0 + EQUALITY_TOLERANCE) {
                long = [a, b];
            }
        }
    }
    long
}

/// The point that is farthest from the nearest of `others`, and how far; of equal ones the first.
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

fn length([a, b]: [DVec2; 2]) -> f64 {
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
