//! How spheres follow bodies that were scaled: what a request can choose.

/// How a radius follows from three factors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum RadiusAxis {
    /// The factor along x.
    X,
    /// The factor along y.
    Y,
    /// The factor along z.
    Z,
    /// The cube root of the product of all three.
    #[default]
    GeometricMean,
    /// The smallest.
    Min,
    /// The largest.
    Max,
}

impl RadiusAxis {
    /// The ratio of radii, of the factors along x, y and z.
    #[must_use]
    pub fn of(self, [x, y, z]: [f64; 3]) -> f64 {
        match self {
            Self::X => x,
            Self::Y => y,
            Self::Z => z,
            // Three equal factors are their own mean, to the last bit.
            Self::GeometricMean if x == y && y == z => x,
            Self::GeometricMean => libm::cbrt(x * y * z),
            Self::Min => x.min(y).min(z),
            Self::Max => x.max(y).max(z),
        }
    }
}

/// What to do with spheres of the scaled model that were moved or resized already.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum MovedSpheres {
    /// Refuse, so that the caller decides ([`Needed::MovedSpheres`](crate::model::Needed::MovedSpheres)).
    #[default]
    Refuse,
    /// They are right: keep their location and radius.
    Keep,
    /// They are not: place them again from the reference.
    Replace,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn radii_follow_the_axis_asked_for() {
        let factors = [1.0, 2.0, 4.0];
        let of = |axis: RadiusAxis| axis.of(factors);
        assert_eq!((of(RadiusAxis::X), of(RadiusAxis::Y), of(RadiusAxis::Z)), (1.0, 2.0, 4.0));
        assert_eq!((of(RadiusAxis::Min), of(RadiusAxis::Max)), (1.0, 4.0));
        assert!((of(RadiusAxis::GeometricMean) - 2.0).abs() < 1e-15);
        assert_eq!(RadiusAxis::GeometricMean.of([1.3, 1.3, 1.3]), 1.3);
    }
}
