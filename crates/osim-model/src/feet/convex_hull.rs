//! The convex hull of points in a plane; also distances and areas of triangles.

use glam::DVec2;

pub(super) fn distance(a: DVec2, b: DVec2) -> f64 {
    libm::hypot(a.x - b.x, a.y - b.y)
}

/// Twice the area of a triangle; positive if the corners a, b, c run counterclockwise.
pub(super) fn twice_area(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

/// Sorts points by x, then y, and removes repeated points.
pub(super) fn sort_and_dedup(points: &mut Vec<DVec2>) {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
}

/// The corners of the convex hull, counterclockwise, beginning with the corner of least x. `points` are sorted and not repeated. Corners on
/// a straight line are left out. (Andrew, A. M. (1979): Another efficient algorithm for convex hulls in two dimensions.)
pub(super) fn convex_hull(points: &[DVec2]) -> Vec<DVec2> {
    if points.len() < 2 {
        return points.to_vec();
    }
    let mut corners = half_hull(points.iter().copied());
    corners.extend(half_hull(points.iter().rev().copied()));
    corners
}

/// One half of the hull without its last corner: the lower half for points from left to right, the upper half for points from right to
/// left.
fn half_hull(points: impl Iterator<Item = DVec2>) -> Vec<DVec2> {
    let mut chain: Vec<DVec2> = Vec::new();
    for point in points {
        while let [.., a, b] = chain[..]
            && twice_area(a, b, point) <= 0.0
        {
            chain.pop();
        }
        chain.push(point);
    }
    chain.pop();
    chain
}

#[cfg(test)]
mod tests {
    use super::*;

    fn places(points: &[[f64; 2]]) -> Vec<DVec2> {
        points.iter().copied().map(DVec2::from).collect()
    }

    #[test]
    fn the_hull_of_a_square_has_four_corners() {
        let square = [[0.0, 0.0], [0.0, 1.0], [0.0, 2.0], [0.5, 1.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0]];
        let corners = places(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
        assert_eq!(convex_hull(&places(&square)), corners);
    }

    #[test]
    fn points_on_a_line_have_a_hull() {
        assert_eq!(convex_hull(&[DVec2::ONE]), [DVec2::ONE]);
        let line = places(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]);
        assert_eq!(convex_hull(&line), places(&[[0.0, 0.0], [2.0, 2.0]]));
        assert!(convex_hull(&[]).is_empty());
    }
}
