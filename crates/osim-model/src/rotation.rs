//! Rotations of frames, and the axis that points up in them.

/// Rotation of a frame in its body, row by row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rotation([[f64; 3]; 3]);

impl Rotation {
    /// No rotation.
    pub const IDENTITY: Self = Self([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);

    /// OpenSim's `orientation`: body-fixed X, then Y, then Z angles, rad.
    #[must_use]
    pub fn body_fixed_xyz([x, y, z]: [f64; 3]) -> Self {
        let (sx, cx) = (libm::sin(x), libm::cos(x));
        let (sy, cy) = (libm::sin(y), libm::cos(y));
        let (sz, cz) = (libm::sin(z), libm::cos(z));
        Self([
            [cy * cz, -cy * sz, sy],
            [cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -sx * cy],
            [sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy],
        ])
    }

    /// This rotation after `first`.
    #[must_use]
    pub fn after(&self, first: &Self) -> Self {
        let cell = |i: usize, j: usize| (0..3).map(|k| self.0[i][k] * first.0[k][j]).sum();
        Self(std::array::from_fn(|i| std::array::from_fn(|j| cell(i, j))))
    }

    /// R v: a vector of the frame, seen from the body.
    #[must_use]
    pub fn to_body(&self, vector: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| (0..3).map(|k| self.0[i][k] * vector[k]).sum())
    }

    /// RᵀSR v: a scaling along the body's axes, seen from a frame that is turned by R.
    #[must_use]
    pub fn scaled_in_frame(&self, factors: [f64; 3], vector: [f64; 3]) -> [f64; 3] {
        if *self == Self::IDENTITY {
            return times(factors, vector);
        }
        let scaled = times(factors, self.to_body(vector));
        std::array::from_fn(|i| (0..3).map(|k| self.0[k][i] * scaled[k]).sum())
    }
}

/// Axis by axis.
pub(crate) fn times(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

/// Two axes this close to up (difference of their cosines) are equally near.
const TIE: f64 = 1e-9;

/// The direction away from the ground, foot flat.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LevelAxis {
    /// 0, 1 or 2.
    pub axis: usize,
    /// The axis points down.
    pub down: bool,
    /// The axis is the body's: each sphere's frame has an axis of its own that is nearest to it.
    pub of_body: bool,
}

impl LevelAxis {
    /// The axis nearest to −gravity; y where a model has no gravity.
    #[must_use]
    pub fn of_gravity(gravity: Option<[f64; 3]>) -> Self {
        let gravity = gravity.unwrap_or([0.0, -1.0, 0.0]);
        let mut axis = 1;
        for (index, value) in gravity.iter().enumerate() {
            if value.abs() > gravity[axis].abs() {
                axis = index;
            }
        }
        Self { axis, down: gravity[axis] > 0.0, of_body: true }
    }

    /// The axis of a frame that is turned by `rotation` in its body.
    #[must_use]
    pub fn in_frame(self, rotation: &Rotation) -> Self {
        if !self.of_body {
            return self;
        }
        let sign = if self.down { -1.0 } else { 1.0 };
        // The body's axis in the frame: a row of its rotation. The body's own axis wins a tie.
        let turned: [f64; 3] = rotation.0[self.axis].map(|value| sign * value);
        let mut axis = self.axis;
        for (index, value) in turned.iter().enumerate() {
            if value.abs() > turned[axis].abs() + TIE {
                axis = index;
            }
        }
        Self { axis, down: turned[axis] < 0.0, of_body: false }
    }

    fn up(self) -> [f64; 3] {
        std::array::from_fn(|index| match index == self.axis {
            true if self.down => -1.0,
            true => 1.0,
            false => 0.0,
        })
    }

    /// Where the centre goes so that the bottom stays on the sole: the bottom point is scaled, the radius is added again.
    #[must_use]
    pub fn centre(
        self,
        centre: [f64; 3],
        old_radius: f64,
        new_radius: f64,
        scaled: impl Fn([f64; 3]) -> [f64; 3],
    ) -> [f64; 3] {
        let up = self.up();
        let bottom = std::array::from_fn(|i| centre[i] - old_radius * up[i]);
        let bottom = scaled(bottom);
        std::array::from_fn(|i| bottom[i] + new_radius * up[i])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scaling_turns_with_the_frame() {
        // A quarter turn about z: the frame's x is the body's y.
        let quarter = Rotation::body_fixed_xyz([0.0, 0.0, std::f64::consts::FRAC_PI_2]);
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
            assert!((turned.0[i][2] - expected).abs() < 1e-15);
        }
    }

    #[test]
    fn the_bottom_stays_on_the_sole() {
        let axis = LevelAxis::of_gravity(Some([0.0, -9.81, 0.0]));
        assert_eq!(axis, LevelAxis { axis: 1, down: false, of_body: true });
        // Bottom at -0.06; the sole is scaled by 2, the radius by 1.5: bottom at -0.12, centre 0.06 above.
        let [x, y, z] = axis.centre([0.1, -0.02, 0.0], 0.04, 0.06, |v| [v[0], 2.0 * v[1], v[2]]);
        assert!((x - 0.1).abs() < 1e-15 && (y + 0.06).abs() < 1e-15 && z == 0.0);
    }

    #[test]
    fn up_is_found_in_a_turned_frame() {
        let up = LevelAxis::of_gravity(None);
        // A quarter turn about z: the frame's x is the body's y; about x: its z is the body's -y.
        let about_z = Rotation([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
        let about_x = Rotation([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]]);
        assert_eq!(up.in_frame(&about_z), LevelAxis { axis: 0, down: false, of_body: false });
        assert_eq!(up.in_frame(&about_x), LevelAxis { axis: 2, down: true, of_body: false });
        let told = LevelAxis { axis: 1, down: false, of_body: false };
        assert_eq!(told.in_frame(&about_z), told);
    }
}
