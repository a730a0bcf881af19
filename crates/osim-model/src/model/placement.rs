//! Where a frame is in another one, and how it moves there.

use glam::DVec3;

use crate::model::rotation::Rotation;

/// A frame in another one.
///
/// ```
/// use osim_model::{DVec3, Placement, Rotation};
///
/// // A quarter turn about z, 1 m up: x becomes y.
/// let quarter = Rotation::about(DVec3::Z, std::f64::consts::FRAC_PI_2);
/// let there = Placement { rotation: quarter, translation_m: DVec3::Y };
/// assert!(there.point(DVec3::X).abs_diff_eq(2.0 * DVec3::Y, 1e-15));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    pub rotation: Rotation,
    /// Where its origin is, m.
    pub translation_m: DVec3,
}

impl Placement {
    pub const IDENTITY: Self = Self { rotation: Rotation::IDENTITY, translation_m: DVec3::ZERO };

    /// From OpenSim's `orientation` (body-fixed angles about x, y, z, rad) and `translation` (m).
    pub(crate) fn of_triples(orientation: [f64; 3], translation_m: [f64; 3]) -> Self {
        Self { rotation: Rotation::body_fixed_xyz(orientation), translation_m: translation_m.into() }
    }

    /// A point of the frame, seen from the other one, m.
    pub fn point(&self, point_m: impl Into<DVec3>) -> DVec3 {
        self.translation_m + self.rotation.to_body(point_m)
    }

    /// A frame in this one, seen from where this one is seen.
    pub fn then(&self, inner: &Self) -> Self {
        Self {
            rotation: self.rotation.after(&inner.rotation),
            translation_m: self.point(inner.translation_m),
        }
    }

    /// The other frame, seen from this one.
    pub fn inverse(&self) -> Self {
        let rotation = self.rotation.inverse();
        Self { rotation, translation_m: -rotation.to_body(self.translation_m) }
    }

    /// The frame as OpenSim has it after it converted an old document, through text: its angles and its place with six digits.
    pub(crate) fn in_six_digits(&self) -> Self {
        let turned = self.rotation.to_body_fixed_xyz().map(six_digits);
        Self::of_triples(turned, self.translation_m.to_array().map(six_digits))
    }
}

/// As a C++ stream writes a number.
pub(crate) fn six_digits(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

/// A frame that moves in another one.
///
/// ```
/// use osim_model::{DVec3, MovingPlacement, Placement, Rotation};
///
/// // 1 m along x, and 2 rad/s about z: a point another metre out moves along y.
/// let there = Placement { rotation: Rotation::IDENTITY, translation_m: DVec3::X };
/// let turning = MovingPlacement { angular_velocity: 2.0 * DVec3::Z, ..MovingPlacement::still(there) };
/// assert_eq!(turning.velocity_of(DVec3::X), 2.0 * DVec3::Y);
/// // Seen from the frame, the other one turns back.
/// assert_eq!(turning.inverse().angular_velocity, -2.0 * DVec3::Z);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovingPlacement {
    pub at: Placement,
    /// How it turns, rad/s, seen from the other one.
    pub angular_velocity: DVec3,
    /// How its origin moves, m/s, seen from the other one.
    pub velocity_m_s: DVec3,
}

impl MovingPlacement {
    /// A frame that does not move.
    pub const fn still(at: Placement) -> Self {
        Self { at, angular_velocity: DVec3::ZERO, velocity_m_s: DVec3::ZERO }
    }

    /// How a point of the frame moves, m/s, seen from the other one.
    pub fn velocity_of(&self, point_m: impl Into<DVec3>) -> DVec3 {
        self.velocity_at_offset(self.at.rotation.to_body(point_m))
    }

    /// How a point of the frame moves (m/s) that is now at `point_m` of the other one.
    pub fn velocity_at(&self, point_m: DVec3) -> DVec3 {
        self.velocity_at_offset(point_m - self.at.translation_m)
    }

    /// How a point of the frame moves (m/s) that is `offset_m` away from its origin, along axes of the other one.
    fn velocity_at_offset(&self, offset_m: DVec3) -> DVec3 {
        self.velocity_m_s + self.angular_velocity.cross(offset_m)
    }

    /// A frame that moves in this one, seen from where this one is seen.
    pub fn then(&self, inner: &Self) -> Self {
        let rotation = self.at.rotation;
        Self {
            at: self.at.then(&inner.at),
            angular_velocity: self.angular_velocity + rotation.to_body(inner.angular_velocity),
            velocity_m_s: self.velocity_of(inner.at.translation_m) + rotation.to_body(inner.velocity_m_s),
        }
    }

    /// The other frame, seen from this one.
    pub fn inverse(&self) -> Self {
        let back = self.at.rotation.inverse();
        // d/dt(-Rt p) = Rt (w x p - v).
        let velocity = self.angular_velocity.cross(self.at.translation_m) - self.velocity_m_s;
        Self {
            at: self.at.inverse(),
            angular_velocity: -back.to_body(self.angular_velocity),
            velocity_m_s: back.to_body(velocity),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::rotation::Rotation;

    /// A frame that turns and moves, at a time.
    fn at(time_s: f64) -> Placement {
        Placement {
            rotation: Rotation::body_fixed_xyz([0.3 + 0.5 * time_s, -0.7 * time_s, 1.1 - 0.2 * time_s]),
            translation_m: DVec3::new(0.1 + time_s, 0.2 - 2.0 * time_s, -0.3 * time_s),
        }
    }

    /// Where it is, with its velocities at time 0, by the rates of its angles.
    fn moving() -> MovingPlacement {
        let angular_velocity = Rotation::body_fixed_velocity([0.3, 0.0, 1.1], [0.5, -0.7, -0.2]);
        MovingPlacement { at: at(0.0), angular_velocity, velocity_m_s: DVec3::new(1.0, -2.0, -0.3) }
    }

    #[track_caller]
    fn close(value: DVec3, expected: DVec3) {
        assert!(value.abs_diff_eq(expected, 1e-8), "{value:?} {expected:?}");
    }

    /// How a point that `place` gives at a time moves at time 0.
    fn by_places(place: impl Fn(f64) -> DVec3) -> DVec3 {
        let step = 1e-5;
        (place(step) - place(-step)) / (2.0 * step)
    }

    #[test]
    fn velocities_are_those_of_the_places() {
        let point = [0.4, -0.5, 0.6];
        close(moving().velocity_of(point), by_places(|time| at(time).point(point)));
        close(moving().velocity_at(at(0.0).point(point)), moving().velocity_of(point));
        close(moving().inverse().velocity_of(point), by_places(|time| at(time).inverse().point(point)));
        let twice = moving().then(&moving().inverse().then(&moving()));
        close(twice.velocity_of(point), moving().velocity_of(point));
        let chained = moving().then(&moving());
        close(chained.velocity_of(point), by_places(|time| at(time).then(&at(time)).point(point)));
    }
}
