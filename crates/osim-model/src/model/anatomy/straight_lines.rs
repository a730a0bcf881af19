//! Straight lines between points.

/// The piece of a curve in which `x` is; the first or the last one outside.
pub(super) fn piece(xs: &[f64], x: f64) -> usize {
    let after = xs.partition_point(|&knot| knot <= x);
    after.saturating_sub(1).min(xs.len().saturating_sub(2))
}

/// Straight lines between points, the outer ones without an end: value and slope.
pub(super) fn straight(xs: &[f64], ys: &[f64], x: f64) -> (f64, f64) {
    let k = piece(xs, x);
    let (Some([x0, x1]), Some([y0, y1])) = (xs.get(k..k + 2), ys.get(k..k + 2)) else {
        return (ys.first().copied().unwrap_or_default(), 0.0);
    };
    (y0 + (x - x0) * (y1 - y0) / (x1 - x0), (y1 - y0) / (x1 - x0))
}

#[cfg(test)]
mod tests {
    use super::*;

    const XS: [f64; 5] = [-1.0, 0.0, 0.5, 2.0, 3.5];
    const YS: [f64; 5] = [0.2, 1.0, -0.3, 0.4, 2.0];

    #[test]
    fn straight_lines_go_on_outside() {
        for (x, expected, slope) in [
            (-2.0, -0.6, 0.8),
            (-0.5, 0.6, 0.8),
            (0.3, 0.22, -2.6),
            (2.0, 0.4, 1.6 / 1.5),
            (4.0, 2.0 + 1.6 / 3.0, 1.6 / 1.5),
        ] {
            let (value, its_slope) = straight(&XS, &YS, x);
            assert!((value - expected).abs() < 1e-15 && (its_slope - slope).abs() < 1e-15, "at {x}");
        }
    }
}
