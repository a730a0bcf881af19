//! The outline of a foot, the convex hull of its points along the ground, and where the bottoms of spheres are in it.

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
fn twice_area(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
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

// Where the bottoms of spheres are in an outline.

/// Bottoms closer than this are refused, m.
const CLOSEST: f64 = 1e-3;
/// The extremes cover this part of the outline's length and of its width.
const COVERED: f64 = 0.9;
/// Extremes are one where they are closer than this part of the length.
const ONE_PLACE: f64 = 0.15;
/// An outline that is this many times as long as wide has a direction of its own; a shorter one points forward.
const LONG: f64 = 1.5;
/// Directions in which the farthest corners of the outline are looked at.
const DIRECTIONS: u32 = 48;
/// What differs by less than this part is equal, and the first counts: bones that are their own mirror image have two of each.
const EQUAL: f64 = 1e-9;
/// How often spheres between the extremes are moved, at most.
const PASSES: usize = 20;

/// `count` bottoms: in the `corners` of the outline, and for the rest under some of the points that are `near` the ground.
///
/// # Errors
/// How many fit, where some would be closer than 1 mm.
pub(super) fn spread(corners: &[[f64; 2]], near: &[[f64; 2]], count: usize) -> Result<Vec<[f64; 2]>, usize> {
    if count == 1 {
        return middle(corners).map(|middle| vec![middle]).ok_or(0);
    }
    let mut bottoms = extremes(corners, count);
    if closest(&bottoms) < CLOSEST {
        return Err(1);
    }
    let fixed = bottoms.len();
    while bottoms.len() < count {
        match farthest(near, &bottoms) {
            Some((point, distance)) if distance >= CLOSEST => bottoms.push(point),
            _ => return Err(bottoms.len()),
        }
    }
    for _ in 0..PASSES {
        let before = bottoms.clone();
        for index in fixed..count {
            let moved = bottoms.remove(index);
            let own = distance_to(moved, &bottoms);
            let better = farthest(near, &bottoms).filter(|(_, distance)| *distance > own * (1.0 + EQUAL));
            bottoms.insert(index, better.map_or(moved, |(point, _)| point));
        }
        if bottoms == before {
            break;
        }
    }
    Ok(bottoms)
}

/// The corners under which the first two, three or four spheres stand.
fn extremes(corners: &[[f64; 2]], count: usize) -> Vec<[f64; 2]> {
    let far = farthest_corners(corners);
    let long = diameter(&far);
    match count {
        2 => long.to_vec(),
        3 => {
            let [_, rear, outer, inner] = towards(direction_of(&far, long));
            apart(corners, [rear, outer, inner], ONE_PLACE * length(long))
        }
        _ => {
            let own = four_extremes(corners, direction_of(&far, long), length(long));
            if covers(&own, corners) { own } else { four_extremes(corners, [1.0, 0.0], length(long)) }
        }
    }
}

/// The direction from the rear to the front of an outline, of length 1: its own if it is long, else forward.
pub(super) fn lengthwise(corners: &[[f64; 2]]) -> [f64; 2] {
    let far = farthest_corners(corners);
    direction_of(&far, diameter(&far))
}

fn direction_of(corners: &[[f64; 2]], long: [[f64; 2]; 2]) -> [f64; 2] {
    let whole = length(long);
    let [rear, front] = if long[0][0] <= long[1][0] { long } else { [long[1], long[0]] };
    let along = [(front[0] - rear[0]) / whole, (front[1] - rear[1]) / whole];
    if whole > 0.0 && whole >= LONG * extent(corners, [-along[1], along[0]]) { along } else { [1.0, 0.0] }
}

/// Forward, to the rear, outward and inward, where forward is a direction.
fn towards([x, y]: [f64; 2]) -> [[f64; 2]; 4] {
    [[x, y], [-x, -y], [-y, x], [y, -x]]
}

/// The corners that are farthest in the four directions; each place once, unless all are needed.
fn four_extremes(corners: &[[f64; 2]], forward: [f64; 2], length: f64) -> Vec<[f64; 2]> {
    let some = apart(corners, towards(forward), ONE_PLACE * length);
    if covers(&some, corners) { some } else { apart(corners, towards(forward), CLOSEST) }
}

/// The corners that are farthest in some directions, without those that are close to one before.
fn apart<const N: usize>(corners: &[[f64; 2]], directions: [[f64; 2]; N], least: f64) -> Vec<[f64; 2]> {
    let mut some: Vec<[f64; 2]> = Vec::new();
    for corner in directions.into_iter().filter_map(|direction| farthest_along(corners, direction)) {
        if distance_to(corner, &some) >= least {
            some.push(corner);
        }
    }
    some
}

/// Of `corners`, the one that is farthest along `direction`; of equal ones the first.
fn farthest_along(corners: &[[f64; 2]], direction: [f64; 2]) -> Option<[f64; 2]> {
    let mut best: Option<([f64; 2], f64)> = None;
    for &corner in corners {
        let along = dot(corner, direction);
        // Coordinates are multiples of a small length: what is equal is so.
        if best.is_none_or(|(_, most)| along > most + CLOSEST * EQUAL) {
            best = Some((corner, along));
        }
    }
    best.map(|(corner, _)| corner)
}

pub(super) fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// How far points reach along a direction of length 1.
pub(super) fn extent(points: &[[f64; 2]], direction: [f64; 2]) -> f64 {
    let along = |point: &[f64; 2]| dot(*point, direction);
    let least = points.iter().map(along).fold(f64::INFINITY, f64::min);
    points.iter().map(along).fold(f64::NEG_INFINITY, f64::max) - least
}

/// Whether `some` corners reach nearly as far as all of them, forward and outward.
fn covers(some: &[[f64; 2]], all: &[[f64; 2]]) -> bool {
    let covered = |direction| extent(some, direction) >= COVERED * extent(all, direction);
    covered([1.0, 0.0]) && covered([0.0, 1.0])
}

/// The corners that are farthest in some direction, in their order.
fn farthest_corners(corners: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let farthest = (0..DIRECTIONS).filter_map(|turn| farthest_along(corners, direction(turn)));
    let farthest: Vec<[f64; 2]> = farthest.collect();
    corners.iter().filter(|corner| farthest.contains(corner)).copied().collect()
}

fn direction(turn: u32) -> [f64; 2] {
    let angle = std::f64::consts::TAU * f64::from(turn) / f64::from(DIRECTIONS);
    [libm::cos(angle), libm::sin(angle)]
}

/// The two corners that are farthest apart.
fn diameter(corners: &[[f64; 2]]) -> [[f64; 2]; 2] {
    let first = corners.first().copied().unwrap_or_default();
    let mut long = [first, first];
    for (index, &a) in corners.iter().enumerate() {
        for &b in corners.iter().skip(index + 1) {
            if length([a, b]) > length(long) * (1.0 + EQUAL) {
                long = [a, b];
            }
        }
    }
    long
}

/// The point that is farthest from the nearest of `others`, and how far; of equal ones the first.
fn farthest(points: &[[f64; 2]], others: &[[f64; 2]]) -> Option<([f64; 2], f64)> {
    let mut best: Option<([f64; 2], f64)> = None;
    for &point in points {
        let distance = distance_to(point, others);
        if best.is_none_or(|(_, largest)| distance > largest * (1.0 + EQUAL)) {
            best = Some((point, distance));
        }
    }
    best
}

fn distance_to(point: [f64; 2], others: &[[f64; 2]]) -> f64 {
    others.iter().map(|&other| length([point, other])).fold(f64::INFINITY, f64::min)
}

fn closest(points: &[[f64; 2]]) -> f64 {
    let others = |index: usize| points.get(index + 1..).unwrap_or_default();
    let each = points.iter().enumerate().map(|(index, &point)| distance_to(point, others(index)));
    each.fold(f64::INFINITY, f64::min)
}

fn length([a, b]: [[f64; 2]; 2]) -> f64 {
    libm::hypot(a[0] - b[0], a[1] - b[1])
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
