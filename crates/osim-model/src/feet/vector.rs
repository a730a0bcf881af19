//! Vectors in space.

use crate::model::cross;

/// a · b.
pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

/// The angle between two vectors, rad, from 0 to π: atan2(|a × b|, a · b), which is exact near 0 and π, too.
pub fn angle(a: [f64; 3], b: [f64; 3]) -> f64 {
    let across = cross(a, b);
    libm::atan2(dot(across, across).sqrt(), dot(a, b))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

    use super::*;

    #[test]
    fn angles_need_no_unit_vectors() {
        assert_eq!(angle([0.0, 2.0, 0.0], [0.0, 3.0, 0.0]), 0.0);
        assert_eq!(angle([0.0, 2.0, 0.0], [0.0, 0.0, -5.0]), FRAC_PI_2);
        assert_eq!(angle([0.0, 1.0, 0.0], [0.0, -1.0, 0.0]), PI);
        assert!((angle([1.0, 1.0, 0.0], [0.0, 7.0, 0.0]) - FRAC_PI_4).abs() < 1e-15);
        // 3 to 4: tan a = 3/4. Small angles keep their digits, which an arc cosine loses.
        assert!((angle([3.0, 4.0, 0.0], [0.0, 1.0, 0.0]) - 0.75_f64.atan()).abs() < 1e-15);
        assert!((angle([1e-9, 1.0, 0.0], [0.0, 1.0, 0.0]) - 1e-9).abs() < 1e-24);
    }
}
