//! Points of a foot along the ground: forward, and outward from the middle of the animal.

use crate::model::{Side, cross};

/// Coordinates are multiples of this, m: those of a mirror image become the same numbers, whatever was rounded before.
const GRID: f64 = 1.0 / (1_u64 << 34) as f64;
/// A direction as close as this to an axis of ground is that axis.
const SAME_DIRECTION: f64 = 1e-9;
/// Limbs closer than this do not say what is right and left, m.
const APART: f64 = 1e-6;

/// A point of a bone in ground, and the place of its body among those of the foot.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point {
    pub at: [f64; 3],
    pub body: usize,
}

/// A point of a foot along the ground.
#[derive(Debug, Clone, Copy)]
pub(super) struct Flat {
    /// Forward and outward from the foot's own rearmost and innermost point, m.
    pub at: [f64; 2],
    /// Above the lowest point of the foot, m.
    pub height: f64,
    /// The place of its body among those of the foot.
    pub body: usize,
}

/// Directions in ground in which a foot is described.
#[derive(Debug, Clone, Copy)]
pub(super) struct Axes {
    pub up: [f64; 3],
    forward: [f64; 3],
    /// To the right of a right foot and to the left of a left one.
    outward: [f64; 3],
    /// Of the foot's points along the directions, the least.
    rearmost: f64,
    innermost: f64,
    pub lowest: f64,
}

impl Axes {
    /// Those of a foot with `points`. `across` is from the left to the right limb of a pair; without one, forward is x of ground.
    pub(super) fn of(up: [f64; 3], side: Option<Side>, points: &[Point], across: Option<[f64; 3]>) -> Self {
        let across = across.and_then(|across| along_ground(up, across, APART));
        let right = across.map(axis_of_ground).unwrap_or_else(|| {
            let ahead = along_ground(up, [1.0, 0.0, 0.0], 0.1).unwrap_or([0.0, 1.0, 0.0]);
            cross(ahead, up)
        });
        let outward = if side == Some(Side::Left) { right.map(|value| -value) } else { right };
        let forward = cross(up, right);
        let least =
            |direction| points.iter().map(|point| dot(point.at, direction)).fold(f64::INFINITY, f64::min);
        Self { up, forward, outward, rearmost: least(forward), innermost: least(outward), lowest: least(up) }
    }

    /// The points along these directions.
    pub(super) fn flat(&self, points: &[Point]) -> Vec<Flat> {
        let from = |point: &Point, direction, least| on_grid(dot(point.at, direction) - least);
        let flat = |point: &Point| Flat {
            at: [from(point, self.forward, self.rearmost), from(point, self.outward, self.innermost)],
            height: from(point, self.up, self.lowest),
            body: point.body,
        };
        points.iter().map(flat).collect()
    }

    /// The point in ground that is `at` along the ground and has the component `height` along up.
    pub(super) fn in_ground(&self, at: [f64; 2], height: f64) -> [f64; 3] {
        let [ahead, out] = [at[0] + self.rearmost, at[1] + self.innermost];
        std::array::from_fn(|i| ahead * self.forward[i] + out * self.outward[i] + height * self.up[i])
    }
}

fn on_grid(value: f64) -> f64 {
    (value / GRID).round() * GRID
}

/// The part of a vector along the ground, with length 1; `None` if it is shorter than `least`.
fn along_ground(up: [f64; 3], vector: [f64; 3], least: f64) -> Option<[f64; 3]> {
    let rise = dot(vector, up);
    let flat: [f64; 3] = std::array::from_fn(|i| vector[i] - rise * up[i]);
    let length = dot(flat, flat).sqrt();
    (length >= least).then(|| flat.map(|value| value / length))
}

fn axis_of_ground(direction: [f64; 3]) -> [f64; 3] {
    let rounded = direction.map(f64::round);
    let close = direction.iter().zip(rounded).all(|(value, axis)| (value - axis).abs() <= SAME_DIRECTION);
    if close { rounded } else { direction }
}

pub(super) fn dot([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
    a * x + b * y + c * z
}
