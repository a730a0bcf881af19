//! How much of a foot is near the ground, and how far it is from lying flat.

use glam::{DVec2, DVec3};

use super::outline::{extent, lengthwise};
use crate::feet::vector::{hull, sort_once};
use crate::model::Side;

/// A foot that lies flat covers this part of its length and of its width, or more.
pub(crate) const COVERED: f64 = 0.8;
/// One that covers less and is tilted by less than this is round, rad: 5 degrees.
const LEAST_TILT: f64 = 0.087;
/// One that is tilted by more than this does not lie flat, whatever it covers, rad: 10 degrees. Bones of human feet that do rise by up to
/// 4 degrees to the front and 8 to the side.
const MOST_TILT: f64 = 0.175;

/// How much of a foot is near the ground at the default pose, seen from above.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Footprint {
    /// The whole foot's length, m.
    pub length_m: f64,
    /// Of the foot's length, the part over which bone points near the ground reach: 1 is all of it.
    pub of_length: f64,
    pub of_width: f64,
    /// How far the front is up (below 0: down), seen from the side, rad: the slope of the line on which the bones would rest.
    pub pitch_rad: f64,
    /// How far the outer side is up, seen from the front, rad.
    pub roll_rad: f64,
}

impl Footprint {
    /// Whether the foot lies flat: points near the ground cover most of it, or it is round, and it is not tilted.
    pub fn is_flat(&self) -> bool {
        let flat = |share: f64, tilt: f64| {
            let most = if share >= COVERED { MOST_TILT } else { LEAST_TILT };
            tilt.abs() < most
        };
        flat(self.of_length, self.pitch_rad) && flat(self.of_width, self.roll_rad)
    }

    /// The footprint of all points of a foot; those `near` the ground are given, too.
    pub(super) fn of(flat: &[Flat], near: &[DVec2]) -> Self {
        let mut whole: Vec<DVec2> = flat.iter().map(|point| point.at).collect();
        sort_once(&mut whole);
        let ahead = lengthwise(&hull(&whole));
        let across = ahead.perp();
        let share = |direction| {
            let all = extent(&whole, direction);
            if all > 0.0 { extent(near, direction) / all } else { 1.0 }
        };
        let pitch = slope(flat.iter().map(|point| DVec2::new(point.at.dot(ahead), point.height)).collect());
        // Else what is only tilted to the front would look tilted to the side, too.
        let level =
            |point: &Flat| DVec2::new(point.at.dot(across), point.height - pitch * point.at.dot(ahead));
        let roll = slope(flat.iter().map(level).collect());
        Self {
            length_m: extent(&whole, ahead),
            of_length: share(ahead),
            of_width: share(across),
            pitch_rad: libm::atan(pitch),
            roll_rad: libm::atan(roll),
        }
    }
}

/// The slope of the line on which points rest, which are along the ground and above it: of the side of their convex hull below
/// their middle.
fn slope(mut points: Vec<DVec2>) -> f64 {
    sort_once(&mut points);
    let ends = points.first().zip(points.last());
    let middle = ends.map_or(0.0, |(first, last)| 0.5 * (first.x + last.x));
    // The lower side comes first, from the rear to the front.
    let below = hull(&points).windows(2).find_map(|pair| match pair {
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
/// Limbs closer than this do not say what is right and left, m.
const APART: f64 = 1e-6;

/// A point of a bone in ground, and the place of its body among those of the foot.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point {
    pub at: DVec3,
    pub body: usize,
}

/// A point of a foot along the ground.
#[derive(Debug, Clone, Copy)]
pub(super) struct Flat {
    /// Forward and outward from the foot's own rearmost and innermost point, m.
    pub at: DVec2,
    /// Above the lowest point of the foot, m.
    pub height: f64,
    /// The place of its body among those of the foot.
    pub body: usize,
}

/// Directions in ground in which a foot is described.
#[derive(Debug, Clone, Copy)]
pub(super) struct Axes {
    pub up: DVec3,
    forward: DVec3,
    /// To the right of a right foot and to the left of a left one.
    outward: DVec3,
    /// Of the foot's points along the directions, the least.
    rearmost: f64,
    innermost: f64,
    pub lowest: f64,
}

impl Axes {
    /// Those of a foot with `points`. `across` is from the left to the right limb of a pair; without one, forward is x of ground.
    pub(super) fn of(up: DVec3, side: Option<Side>, points: &[Point], across: Option<DVec3>) -> Self {
        let across = across.and_then(|across| along_ground(up, across, APART));
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

    /// The points along these directions.
    pub(super) fn flat(&self, points: &[Point]) -> Vec<Flat> {
        let from = |point: &Point, direction, least| on_grid(point.at.dot(direction) - least);
        let flat = |point: &Point| Flat {
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
