//! Forward, up and to the right: the axes in which a foot is looked at.

use crate::model::Model;

use crate::feet::vector::dot;

/// The names of a frame's axes, and of their opposites.
const NAMES: [[&str; 2]; 3] = [["x", "−x"], ["y", "−y"], ["z", "−z"]];

/// Three directions of length 1 in ground (or in the frame of a body that is drawn in its own).
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
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
    #[must_use]
    pub fn of(model: &Model) -> Self {
        Self::with_up(model.up())
    }

    /// The axes with this direction up, which has length 1.
    #[must_use]
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
    #[must_use]
    pub fn seen(&self, point_m: [f64; 3]) -> [f64; 3] {
        [dot(self.forward, point_m), dot(self.up, point_m), dot(self.right, point_m)]
    }

    /// What the three directions are called: `x`, `y` and `z` where gravity points along −y; words where none is an axis.
    #[must_use]
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
}
