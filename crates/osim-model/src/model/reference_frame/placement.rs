//! Where a frame is in another one.

use crate::model::reference_frame::rotation::Rotation;

/// A frame in another one.
///
/// ```
/// use osim_model::{Placement, Rotation};
///
/// // A quarter turn about z, 1 m up: x becomes y.
/// let quarter = Rotation::about([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2);
/// let there = Placement { rotation: quarter, translation_m: [0.0, 1.0, 0.0] };
/// let [x, y, z] = there.point([1.0, 0.0, 0.0]);
/// assert!(x.abs() < 1e-15 && (y - 2.0).abs() < 1e-15 && z == 0.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    /// How it is turned.
    pub rotation: Rotation,
    /// Where its origin is, m.
    pub translation_m: [f64; 3],
}

impl Placement {
    /// The same frame.
    pub const IDENTITY: Self = Self { rotation: Rotation::IDENTITY, translation_m: [0.0; 3] };

    /// From OpenSim's `orientation` (body-fixed angles about x, y, z, rad) and `translation` (m).
    #[must_use]
    pub fn of_triples(orientation: [f64; 3], translation_m: [f64; 3]) -> Self {
        Self { rotation: Rotation::body_fixed_xyz(orientation), translation_m }
    }

    /// A point of the frame, seen from the other one, m.
    #[must_use]
    pub fn point(&self, point_m: [f64; 3]) -> [f64; 3] {
        let turned = self.rotation.to_body(point_m);
        std::array::from_fn(|i| self.translation_m[i] + turned[i])
    }

    /// A frame in this one, seen from where this one is seen.
    #[must_use]
    pub fn then(&self, inner: &Self) -> Self {
        Self {
            rotation: self.rotation.after(&inner.rotation),
            translation_m: self.point(inner.translation_m),
        }
    }

    /// The other frame, seen from this one.
    #[must_use]
    pub fn inverse(&self) -> Self {
        let rotation = self.rotation.inverse();
        let translation_m = rotation.to_body(self.translation_m).map(|value| -value);
        Self { rotation, translation_m }
    }

    /// The frame as OpenSim has it after it converted an old document, through text: its angles and its place with six digits.
    pub fn in_six_digits(&self) -> Self {
        let turned = self.rotation.to_body_fixed_xyz().map(six_digits);
        Self::of_triples(turned, self.translation_m.map(six_digits))
    }
}

/// As a C++ stream writes a number.
pub(crate) fn six_digits(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}
