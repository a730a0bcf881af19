//! A point that is far from all others: a broken number, and no part of a bone.

/// Of fewer points nobody can say which is usual.
const LEAST: usize = 20;
/// Nine of ten points are within the reach of a mesh.
const REACH: f64 = 0.9;
/// A stray point is farther from the middle than this many reaches. In real bones (the foot, the toes and the talus of OpenSim) and
/// in those of `fixtures/feet` the farthest point is at 1.00 to 1.47.
const FAR: f64 = 2.0;
/// And it has few neighbours within this part of the reach: in those meshes each point has at least three.
const AROUND: f64 = 0.5;
/// Broken numbers that lie together are still broken.
const FEW: usize = 3;
/// So many of the farthest points are looked at, so that the work grows with the points.
const LOOKED_AT: usize = 16;

/// A point that is far from all others.
pub(super) struct Stray {
    /// Which, from 0.
    pub(super) index: usize,
    /// How far it is from the middle, in the unit of the points.
    pub(super) distance: f64,
    /// Nine of ten points are not farther than this.
    pub(super) reach: f64,
}

/// The farthest point that is far from all others; `points` are each there once.
pub(super) fn stray(points: &[[f64; 3]]) -> Option<Stray> {
    if points.len() < LEAST {
        return None;
    }
    let middle: [f64; 3] = std::array::from_fn(|axis| {
        quantile(&mut points.iter().map(|point| point[axis]).collect::<Vec<_>>(), 0.5)
    });
    let far: Vec<f64> = points.iter().map(|point| distance(*point, middle)).collect();
    let reach = quantile(&mut far.clone(), REACH);
    let mut farthest: Vec<usize> =
        (0..points.len()).filter(|&index| far.get(index).is_some_and(|far| *far > FAR * reach)).collect();
    farthest.sort_by(|a, b| far.get(*b).partial_cmp(&far.get(*a)).unwrap_or(std::cmp::Ordering::Equal));
    let index =
        farthest.into_iter().take(LOOKED_AT).find(|&index| is_alone(points, index, AROUND * reach))?;
    Some(Stray { index, distance: *far.get(index)?, reach })
}

/// Whether the point has few others around it.
fn is_alone(points: &[[f64; 3]], index: usize, around: f64) -> bool {
    let Some(&point) = points.get(index) else { return false };
    // The point itself is one of those that are found.
    points.iter().filter(|other| distance(**other, point) <= around).take(FEW + 1).count() <= FEW
}

/// The value that this share of `values` does not exceed.
fn quantile(values: &mut [f64], share: f64) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "at most some million points")]
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and their count")]
    let index = (share * values.len().saturating_sub(1) as f64).round() as usize;
    if index >= values.len() {
        return f64::NAN;
    }
    *values.select_nth_unstable_by(index, f64::total_cmp).1
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let [x, y, z]: [f64; 3] = std::array::from_fn(|axis| a[axis] - b[axis]);
    x.hypot(y).hypot(z)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A box of 0.1 by 0.05 by 0.25 with 6 × 4 × 11 points.
    fn block() -> Vec<[f64; 3]> {
        let along = |count: i32, step: f64| (0..count).map(move |index| f64::from(index) * step);
        along(6, 0.02)
            .flat_map(|x| along(4, 0.05 / 3.0).flat_map(move |y| along(11, 0.025).map(move |z| [x, y, z])))
            .collect()
    }

    #[test]
    fn a_broken_number_is_found_and_a_bone_is_whole() {
        assert!(stray(&block()).is_none());
        for (index, broken) in [(7, [0.05, -0.4, 0.1]), (100, [12.0, 0.0, 0.1]), (200, [0.05, 0.02, 250.0])] {
            let mut points = block();
            points[index] = broken;
            let found = stray(&points).unwrap();
            assert_eq!(found.index, index);
            // The box reaches 0.138 from its middle: √(0.05² + 0.025² + 0.125²).
            assert!(found.reach > 0.08 && found.reach < 0.138 && found.distance > 2.0 * found.reach);
        }
    }

    #[test]
    fn broken_numbers_that_lie_together_are_found() {
        let mut points = block();
        (points[3], points[4]) = ([0.05, -1.0, 0.1], [0.05, -1.0, 0.101]);
        assert!(matches!(stray(&points), Some(Stray { index: 3 | 4, .. })));
    }

    #[test]
    fn a_second_part_is_no_broken_number() {
        // A toe of many points, far ahead.
        let toe = block().into_iter().take(30).map(|[x, y, z]| [x / 5.0, y / 5.0, 1.0 + z / 5.0]);
        let points: Vec<[f64; 3]> = block().into_iter().chain(toe).collect();
        assert!(stray(&points).is_none());
        // A cube has eight corners.
        assert!(stray(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 50.0]]).is_none());
    }
}
