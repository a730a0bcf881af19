//! How much of a foot is near the ground, and how far it is from lying flat.

use super::axes::Flat;
use super::outline::hull;
use super::spread::{dot, extent, lengthwise};

/// A foot that lies flat covers this part of its length and of its width, or more.
pub(crate) const COVERED: f64 = 0.8;
/// One that covers less and is tilted by less than this is round, rad: 5 degrees.
const LEAST_TILT: f64 = 0.087;
/// One that is tilted by more than this does not lie flat, whatever it covers, rad: 10 degrees. Bones of human feet that do rise by up to
/// 4 degrees to the front and 8 to the side.
const MOST_TILT: f64 = 0.175;

/// How much of a foot is near the ground at the default pose, seen from above.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Footprint {
    /// The whole foot's length, m.
    pub length_m: f64,
    /// Of the foot's length, the part over which bone points near the ground reach: 1 is all of it.
    pub of_length: f64,
    /// The same of its width.
    pub of_width: f64,
    /// How far the front is up (below 0: down), seen from the side, rad: the slope of the line on which the bones would rest.
    pub pitch_rad: f64,
    /// How far the outer side is up, seen from the front, rad.
    pub roll_rad: f64,
}

impl Footprint {
    /// Whether the foot lies flat: points near the ground cover most of it, or it is round, and it is not tilted.
    #[must_use]
    pub fn is_flat(&self) -> bool {
        let flat = |share: f64, tilt: f64| {
            let most = if share >= COVERED { MOST_TILT } else { LEAST_TILT };
            tilt.abs() < most
        };
        flat(self.of_length, self.pitch_rad) && flat(self.of_width, self.roll_rad)
    }

    /// The footprint of all points of a foot; those `near` the ground are given, too.
    pub(super) fn of(flat: &[Flat], near: &[[f64; 2]]) -> Self {
        let mut whole: Vec<[f64; 2]> = flat.iter().map(|point| point.at).collect();
        whole.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
        whole.dedup();
        let ahead = lengthwise(&hull(&whole));
        let across = [-ahead[1], ahead[0]];
        let share = |direction| {
            let all = extent(&whole, direction);
            if all > 0.0 { extent(near, direction) / all } else { 1.0 }
        };
        let pitch = slope(flat.iter().map(|point| [dot(point.at, ahead), point.height]).collect());
        // Else what is only tilted to the front would look tilted to the side, too.
        let level = |point: &Flat| [dot(point.at, across), point.height - pitch * dot(point.at, ahead)];
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
fn slope(mut points: Vec<[f64; 2]>) -> f64 {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    points.dedup();
    let ends = points.first().zip(points.last());
    let middle = ends.map_or(0.0, |(first, last)| 0.5 * (first[0] + last[0]));
    // The lower side comes first, from the rear to the front.
    let below = hull(&points).windows(2).find_map(|pair| match pair {
        &[a, b] if a[0] <= middle && middle < b[0] => Some((b[1] - a[1]) / (b[0] - a[0])),
        _ => None,
    });
    below.unwrap_or(0.0)
}
