//! Placements of frames in other frames: rotation, translation, and their velocities.

use glam::{DMat3, DVec3};

/// Rotation of a frame relative to its body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rotation(DMat3);

impl Rotation {
    /// No rotation.
    pub const IDENTITY: Self = Self(DMat3::IDENTITY);

    fn from_rows(rows: [[f64; 3]; 3]) -> Self {
        Self(DMat3::from_cols_array_2d(&rows).transpose())
    }

    /// The rotation that turns two axes of a frame, at right angles to each other, to the directions beside them.
    pub(crate) fn with_axes([(first, to_first), (second, to_second)]: [(DVec3, DVec3); 2]) -> Self {
        let frame = DMat3::from_cols(first, second, first.cross(second));
        Self(DMat3::from_cols(to_first, to_second, to_first.cross(to_second)) * frame.transpose())
    }

    /// The rotation of OpenSim's `orientation`: body-fixed angles about x, then y, then z, in rad.
    pub fn body_fixed_xyz([x, y, z]: [f64; 3]) -> Self {
        let (sx, cx) = (libm::sin(x), libm::cos(x));
        let (sy, cy) = (libm::sin(y), libm::cos(y));
        let (sz, cz) = (libm::sin(z), libm::cos(z));
        Self::from_rows([
            [cy * cz, -cy * sz, sy],
            [cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -sx * cy],
            [sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy],
        ])
    }

    /// The angular velocity (rad/s), in axes of the body, of a frame whose body-fixed `angles` about x, y and z (rad) change at `rates`
    /// (rad/s).
    pub(crate) fn body_fixed_velocity([x, y, _]: [f64; 3], rates: [f64; 3]) -> DVec3 {
        let (sx, cx) = (libm::sin(x), libm::cos(x));
        let (sy, cy) = (libm::sin(y), libm::cos(y));
        let [about_x, about_y, about_z] = rates;
        DVec3::new(about_x + sy * about_z, cx * about_y - sx * cy * about_z, sx * about_y + cx * cy * about_z)
    }

    /// The angles about x, then y, then z (rad) of this rotation, as in OpenSim's `orientation`.
    pub(crate) fn to_body_fixed_xyz(self) -> [f64; 3] {
        let [[xx, xy, xz], [_, _, yz], [_, _, zz]] = self.inverse().0.to_cols_array_2d();
        let cosine = libm::sqrt(xx * xx + xy * xy);
        [libm::atan2(-yz, zz), libm::atan2(xz, cosine), libm::atan2(-xy, xx)]
    }

    /// The rotation `first`, followed by this rotation: the product of their matrices.
    pub fn after(&self, first: &Self) -> Self {
        Self(self.0 * first.0)
    }

    /// R v: converts a vector from the frame to the body.
    pub fn to_body(&self, vector: impl Into<DVec3>) -> DVec3 {
        self.0 * vector.into()
    }

    /// Rotation by `angle` (rad) about `axis`, which may have any length: Rodrigues' formula, R v = v cos a + (u × v) sin a + u (u · v)(1 −
    /// cos a) with u = axis/|axis|. With an axis of length 0 or an angle of 0, nothing is turned.
    pub fn about(axis: impl Into<DVec3>, angle: f64) -> Self {
        let axis = axis.into();
        let length = axis.length();
        if angle == 0.0 || length == 0.0 {
            return Self::IDENTITY;
        }
        let DVec3 { x, y, z } = axis / length;
        let (s, c) = (libm::sin(angle), libm::cos(angle));
        let t = 1.0 - c;
        Self::from_rows([
            [t * x * x + c, t * x * y - s * z, t * x * z + s * y],
            [t * x * y + s * z, t * y * y + c, t * y * z - s * x],
            [t * x * z - s * y, t * y * z + s * x, t * z * z + c],
        ])
    }

    /// Rᵀ: the rotation that converts from the body to the frame.
    pub fn inverse(&self) -> Self {
        Self(self.0.transpose())
    }

    /// RᵀSR v: `vector` of a frame that is turned by R, after a scaling by `factors` (S) along the axes of the body.
    pub fn scaled_in_frame(&self, factors: [f64; 3], vector: [f64; 3]) -> [f64; 3] {
        let (factors, vector) = (DVec3::from(factors), DVec3::from(vector));
        if *self == Self::IDENTITY {
            return (factors * vector).to_array();
        }
        self.inverse().to_body(factors * self.to_body(vector)).to_array()
    }
}

/// Two axes are equally near to up if their cosines differ by at most this.
const EQUAL_AXES_TOLERANCE: f64 = 1e-9;

/// An axis of a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Axis {
    X,
    Y,
    Z,
}

impl Axis {
    /// The three axes, x first.
    const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    pub const fn index(self) -> usize {
        self as usize
    }

    /// The axis with the largest component of `vector`, whatever its sign. Another axis than `preferred` must be larger by more than `tie`.
    fn largest(vector: DVec3, preferred: Self, tie: f64) -> Self {
        let size = |axis: Self| vector[axis.index()].abs();
        Self::ALL
            .into_iter()
            .fold(preferred, |best, axis| if size(axis) > size(best) + tie { axis } else { best })
    }
}

/// The axis that points away from the ground when the foot lies flat.
///
/// ```
/// use osim_model::{Axis, LevelAxis};
///
/// // Gravity points along -z: up is z.
/// let up = LevelAxis::of_gravity(Some([0.0, 0.0, -9.81]));
/// assert_eq!((up.axis, up.down), (Axis::Z, false));
/// // A sphere grows from 0.03 m to 0.05 m: its centre rises by 0.02 m, and its bottom stays.
/// let [x, y, z] = up.levelled_centre([0.1, 0.0, 0.03], 0.03, 0.05, |bottom| bottom);
/// assert!(x == 0.1 && y == 0.0 && (z - 0.05).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LevelAxis {
    pub axis: Axis,
    /// Whether the axis points down. Its negative direction then points away from the ground.
    pub down: bool,
    /// Whether this is an axis of the body; each sphere's frame then uses its own axis that is nearest to it. Otherwise it is an axis of
    /// each sphere's own frame.
    pub of_body: bool,
}

impl LevelAxis {
    /// The axis of the body that is nearest to the direction opposite to `gravity` (m/s², in ground); y if a model has no gravity.
    pub fn of_gravity(gravity: Option<[f64; 3]>) -> Self {
        let gravity = gravity.unwrap_or([0.0, -1.0, 0.0]);
        let axis = Axis::largest(gravity.into(), Axis::Y, 0.0);
        Self { axis, down: gravity[axis.index()] > 0.0, of_body: true }
    }

    /// The nearest axis of a frame that is turned by `rotation` in its body.
    pub fn in_frame(self, rotation: &Rotation) -> Self {
        if !self.of_body {
            return self;
        }
        let sign = if self.down { -1.0 } else { 1.0 };
        // The body's axis in the frame: a row of its rotation. The body's own axis wins a tie.
        let turned = sign * rotation.0.row(self.axis.index());
        let axis = Axis::largest(turned, self.axis, EQUAL_AXES_TOLERANCE);
        Self { axis, down: turned[axis.index()] < 0.0, of_body: false }
    }

    fn up(self) -> DVec3 {
        let mut up = DVec3::ZERO;
        up[self.axis.index()] = if self.down { -1.0 } else { 1.0 };
        up
    }

    /// The new centre (m) of a sphere whose bottom stays on the sole. The function `scaled` moves the bottom with the body; the new radius
    /// is then added upwards. All places are in the sphere's frame, m.
    pub fn levelled_centre(
        self,
        centre: [f64; 3],
        old_radius: f64,
        new_radius: f64,
        scaled: impl Fn([f64; 3]) -> [f64; 3],
    ) -> [f64; 3] {
        let up = self.up();
        let bottom = scaled((DVec3::from(centre) - old_radius * up).to_array());
        (DVec3::from(bottom) + new_radius * up).to_array()
    }
}

// Where a frame is in another one, and how it moves there.

/// The placement of a frame in another frame: rotation and translation.
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
    /// The origin of the frame in the other frame, m.
    pub translation_m: DVec3,
}

impl Placement {
    /// The placement of a frame in itself.
    pub const IDENTITY: Self = Self { rotation: Rotation::IDENTITY, translation_m: DVec3::ZERO };

    /// The placement from OpenSim's `orientation` (body-fixed angles about x, y, z, rad) and `translation` (m).
    pub(crate) fn from_triples(orientation: [f64; 3], translation_m: [f64; 3]) -> Self {
        Self { rotation: Rotation::body_fixed_xyz(orientation), translation_m: translation_m.into() }
    }

    /// Converts a point of the frame to the other frame, m.
    pub fn point(&self, point_m: impl Into<DVec3>) -> DVec3 {
        self.translation_m + self.rotation.to_body(point_m)
    }

    /// The placement of a frame `inner`, whose placement in this frame is given, in the other frame.
    pub fn then(&self, inner: &Self) -> Self {
        Self {
            rotation: self.rotation.after(&inner.rotation),
            translation_m: self.point(inner.translation_m),
        }
    }

    /// The placement of the other frame in this frame.
    pub fn inverse(&self) -> Self {
        let rotation = self.rotation.inverse();
        Self { rotation, translation_m: -rotation.to_body(self.translation_m) }
    }

    /// The placement after OpenSim's conversion of an old document, which writes angles and places with six digits.
    pub(crate) fn in_six_digits(&self) -> Self {
        let turned = self.rotation.to_body_fixed_xyz().map(six_digits);
        Self::from_triples(turned, self.translation_m.to_array().map(six_digits))
    }
}

/// A number with six significant digits, as a C++ stream writes it.
pub(crate) fn six_digits(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

/// The placement of a frame in another frame, and its velocity.
///
/// ```
/// use osim_model::{DVec3, MovingPlacement, Placement, Rotation};
///
/// // 1 m along x, and 2 rad/s about z: a point another metre out moves along y.
/// let there = Placement { rotation: Rotation::IDENTITY, translation_m: DVec3::X };
/// let turning = MovingPlacement { angular_velocity: 2.0 * DVec3::Z, ..MovingPlacement::at_rest(there) };
/// assert_eq!(turning.velocity_of(DVec3::X), 2.0 * DVec3::Y);
/// // Seen from the frame, the other one turns back.
/// assert_eq!(turning.inverse().angular_velocity, -2.0 * DVec3::Z);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovingPlacement {
    pub at: Placement,
    /// Angular velocity of the frame, rad/s, in axes of the other frame.
    pub angular_velocity: DVec3,
    /// Velocity of the frame's origin, m/s, in axes of the other frame.
    pub velocity_m_s: DVec3,
}

impl MovingPlacement {
    /// The placement `at` with a velocity of 0.
    pub const fn at_rest(at: Placement) -> Self {
        Self { at, angular_velocity: DVec3::ZERO, velocity_m_s: DVec3::ZERO }
    }

    /// Velocity of a point of the frame, m/s, in axes of the other frame.
    pub fn velocity_of(&self, point_m: impl Into<DVec3>) -> DVec3 {
        self.velocity_at_offset(self.at.rotation.to_body(point_m))
    }

    /// Velocity (m/s) of the frame's point that is now at `point_m` of the other frame.
    pub fn velocity_at(&self, point_m: DVec3) -> DVec3 {
        self.velocity_at_offset(point_m - self.at.translation_m)
    }

    /// Velocity (m/s) of the frame's point that is `offset_m` away from its origin, along axes of the other frame.
    fn velocity_at_offset(&self, offset_m: DVec3) -> DVec3 {
        self.velocity_m_s + self.angular_velocity.cross(offset_m)
    }

    /// The placement and velocity in the other frame of a frame `inner`, which moves in this frame.
    pub fn then(&self, inner: &Self) -> Self {
        let rotation = self.at.rotation;
        Self {
            at: self.at.then(&inner.at),
            angular_velocity: self.angular_velocity + rotation.to_body(inner.angular_velocity),
            velocity_m_s: self.velocity_of(inner.at.translation_m) + rotation.to_body(inner.velocity_m_s),
        }
    }

    /// The placement and velocity of the other frame in this frame.
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

/// The smallest and the largest of the values; infinity and minus infinity if there are none.
pub fn least_and_most(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    let wider = |(least, most): (f64, f64), value: f64| (least.min(value), most.max(value));
    values.into_iter().fold((f64::INFINITY, f64::NEG_INFINITY), wider)
}

/// The angle between two vectors, rad, from 0 to π: atan2(|a × b|, a · b), which is exact near 0 and π, too.
pub fn angle_between(a: DVec3, b: DVec3) -> f64 {
    libm::atan2(a.cross(b).length(), a.dot(b))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

    use super::*;

    #[test]
    fn angles_do_not_depend_on_vector_lengths() {
        let at = DVec3::new;
        assert_eq!(angle_between(at(0.0, 2.0, 0.0), at(0.0, 3.0, 0.0)), 0.0);
        assert_eq!(angle_between(at(0.0, 2.0, 0.0), at(0.0, 0.0, -5.0)), FRAC_PI_2);
        assert_eq!(angle_between(at(0.0, 1.0, 0.0), at(0.0, -1.0, 0.0)), PI);
        assert!((angle_between(at(1.0, 1.0, 0.0), at(0.0, 7.0, 0.0)) - FRAC_PI_4).abs() < 1e-15);
        // 3 to 4: tan a = 3/4. Small angles keep their digits, which an arc cosine loses.
        assert!((angle_between(at(3.0, 4.0, 0.0), DVec3::Y) - 0.75_f64.atan()).abs() < 1e-15);
        assert!((angle_between(at(1e-9, 1.0, 0.0), DVec3::Y) - 1e-9).abs() < 1e-24);
    }

    #[test]
    fn scale_factors_turn_with_the_frame() {
        // A quarter turn about z: the frame's x is the body's y.
        let quarter = Rotation::body_fixed_xyz([0.0, 0.0, FRAC_PI_2]);
        let [x, y, z] = quarter.scaled_in_frame([2.0, 3.0, 5.0], [1.0, 1.0, 1.0]);
        assert!((x - 3.0).abs() < 1e-12 && (y - 2.0).abs() < 1e-12 && (z - 5.0).abs() < 1e-12);
        let unturned = Rotation::IDENTITY.scaled_in_frame([2.0, 3.0, 5.0], [0.1, 1.0, 1.0]);
        assert_eq!(unturned, [0.2, 3.0, 5.0]);
    }

    #[test]
    fn body_fixed_angles_follow_the_order_x_y_z() {
        // Rx(a) Ry(b) applied to the z axis: (sin b, -sin a cos b, cos a cos b).
        let (a, b) = (0.3_f64, 0.7_f64);
        let turned = Rotation::body_fixed_xyz([a, b, 0.0]);
        for (i, expected) in [b.sin(), -a.sin() * b.cos(), a.cos() * b.cos()].into_iter().enumerate() {
            assert!((turned.0.z_axis[i] - expected).abs() < 1e-15);
        }
    }

    #[test]
    fn body_fixed_angles_round_trip() {
        for angles in [[0.3, -0.7, 2.5], [-3.0, 1.2, 0.1], [0.0; 3]] {
            let back = Rotation::body_fixed_xyz(angles).to_body_fixed_xyz();
            assert!(back.into_iter().zip(angles).all(|(a, b)| (a - b).abs() < 1e-15), "{back:?}");
        }
    }

    #[test]
    fn turning_about_an_axis_is_turning_by_body_fixed_angles() {
        let quarter = FRAC_PI_2;
        // Right-handed: about z, x becomes y; about twice y, z becomes x.
        let DVec3 { x, y, z } = Rotation::about(DVec3::Z, quarter).to_body(DVec3::X);
        assert!(x.abs() < 1e-15 && (y - 1.0).abs() < 1e-15 && z == 0.0);
        let DVec3 { x, y, z } = Rotation::about([0.0, 2.0, 0.0], quarter).to_body(DVec3::Z);
        assert!((x - 1.0).abs() < 1e-15 && y == 0.0 && z.abs() < 1e-15);
        // A third of a turn about (1, 1, 1) carries x to y, y to z, z to x; its inverse carries back.
        let third = Rotation::about([1.0, 1.0, 1.0], std::f64::consts::TAU / 3.0);
        let turned = third.to_body([1.0, 2.0, 3.0]);
        assert!(turned.abs_diff_eq(DVec3::new(3.0, 1.0, 2.0), 1e-14));
        assert!(third.inverse().to_body(turned).abs_diff_eq(DVec3::new(1.0, 2.0, 3.0), 1e-14));
        assert_eq!(Rotation::about([0.0; 3], 1.0), Rotation::IDENTITY);
    }

    #[test]
    fn the_bottom_stays_on_the_sole() {
        let axis = LevelAxis::of_gravity(Some([0.0, -9.81, 0.0]));
        assert_eq!(axis, LevelAxis { axis: Axis::Y, down: false, of_body: true });
        // Bottom at -0.06; the sole is scaled by 2, the radius by 1.5: bottom at -0.12, centre 0.06 above.
        let [x, y, z] = axis.levelled_centre([0.1, -0.02, 0.0], 0.04, 0.06, |v| [v[0], 2.0 * v[1], v[2]]);
        assert!((x - 0.1).abs() < 1e-15 && (y + 0.06).abs() < 1e-15 && z == 0.0);
    }

    #[test]
    fn up_is_found_in_a_turned_frame() {
        let up = LevelAxis::of_gravity(None);
        // A quarter turn about z: the frame's x is the body's y; about x: its z is the body's -y.
        let about_z = Rotation::from_rows([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
        let about_x = Rotation::from_rows([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]]);
        assert_eq!(up.in_frame(&about_z), LevelAxis { axis: Axis::X, down: false, of_body: false });
        assert_eq!(up.in_frame(&about_x), LevelAxis { axis: Axis::Z, down: true, of_body: false });
        let given = LevelAxis { axis: Axis::Y, down: false, of_body: false };
        assert_eq!(given.in_frame(&about_z), given);
    }

    /// A frame that turns and moves, at a given time.
    fn placement_at(time_s: f64) -> Placement {
        Placement {
            rotation: Rotation::body_fixed_xyz([0.3 + 0.5 * time_s, -0.7 * time_s, 1.1 - 0.2 * time_s]),
            translation_m: DVec3::new(0.1 + time_s, 0.2 - 2.0 * time_s, -0.3 * time_s),
        }
    }

    /// The frame at time 0, with velocities from the rates of its angles and places.
    fn moving_frame() -> MovingPlacement {
        let angular_velocity = Rotation::body_fixed_velocity([0.3, 0.0, 1.1], [0.5, -0.7, -0.2]);
        MovingPlacement { at: placement_at(0.0), angular_velocity, velocity_m_s: DVec3::new(1.0, -2.0, -0.3) }
    }

    #[track_caller]
    fn assert_close(value: DVec3, expected: DVec3) {
        assert!(value.abs_diff_eq(expected, 1e-8), "{value:?} {expected:?}");
    }

    /// The velocity at time 0 of a point, as a difference quotient. `place` gives the point's place at a time.
    fn difference_quotient(place: impl Fn(f64) -> DVec3) -> DVec3 {
        let step = 1e-5;
        (place(step) - place(-step)) / (2.0 * step)
    }

    #[test]
    fn velocities_are_difference_quotients_of_places() {
        let point = [0.4, -0.5, 0.6];
        assert_close(
            moving_frame().velocity_of(point),
            difference_quotient(|time| placement_at(time).point(point)),
        );
        assert_close(
            moving_frame().velocity_at(placement_at(0.0).point(point)),
            moving_frame().velocity_of(point),
        );
        assert_close(
            moving_frame().inverse().velocity_of(point),
            difference_quotient(|time| placement_at(time).inverse().point(point)),
        );
        let twice = moving_frame().then(&moving_frame().inverse().then(&moving_frame()));
        assert_close(twice.velocity_of(point), moving_frame().velocity_of(point));
        let chained = moving_frame().then(&moving_frame());
        assert_close(
            chained.velocity_of(point),
            difference_quotient(|time| placement_at(time).then(&placement_at(time)).point(point)),
        );
    }
}
