//! The outline of a foot: the convex hull of its points along the ground.

/// The corners of the convex hull, the other way round than a clock goes, from the rearmost one on; `points` are sorted, each
/// once. Corners in a line are left out. (Andrew, A. M. (1979): Another efficient algorithm for convex hulls in two dimensions.)
pub(super) fn hull(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let lower = half(points.iter());
    let upper = half(points.iter().rev());
    let ends = |half: Vec<[f64; 2]>| half.len().saturating_sub(1);
    let [below, above] = [ends(lower.clone()), ends(upper.clone())];
    if below == 0 {
        return points.iter().take(1).copied().collect();
    }
    lower.into_iter().take(below).chain(upper.into_iter().take(above)).collect()
}

fn half<'p>(points: impl Iterator<Item = &'p [f64; 2]>) -> Vec<[f64; 2]> {
    let mut chain: Vec<[f64; 2]> = Vec::new();
    for &point in points {
        while let [.., a, b] = chain[..]
            && twice_area(a, b, point) <= 0.0
        {
            chain.pop();
        }
        chain.push(point);
    }
    chain
}

/// Twice the area of a triangle; positive if its corners go round the other way than a clock.
pub(super) fn twice_area(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// The middle of the area that `corners` enclose; if they enclose none, that of the corners.
pub(super) fn middle(corners: &[[f64; 2]]) -> Option<[f64; 2]> {
    let &first = corners.first()?;
    let (mut whole, mut sum) = (0.0, [0.0; 2]);
    for pair in corners.windows(2) {
        let &[a, b] = pair else { continue };
        let area = twice_area(first, a, b);
        whole += area;
        sum = std::array::from_fn(|i| sum[i] + area * (first[i] + a[i] + b[i]) / 3.0);
    }
    if whole > 0.0 {
        return Some(sum.map(|value| value / whole));
    }
    let &last = corners.last()?;
    Some(std::array::from_fn(|i| 0.5 * (first[i] + last[i])))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hull_of_a_square_has_four_corners() {
        let points = [[0.0, 0.0], [0.0, 1.0], [0.0, 2.0], [0.5, 1.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0]];
        assert_eq!(hull(&points), [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
        assert_eq!(middle(&hull(&points)), Some([1.0, 1.0]));
    }

    #[test]
    fn lines_and_points_have_hulls_too() {
        assert_eq!(hull(&[[1.0, 1.0]]), [[1.0, 1.0]]);
        assert_eq!(hull(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]), [[0.0, 0.0], [2.0, 2.0]]);
        assert_eq!(middle(&[[0.0, 0.0], [2.0, 2.0]]), Some([1.0, 1.0]));
        assert!(hull(&[]).is_empty() && middle(&[]).is_none());
    }
}
