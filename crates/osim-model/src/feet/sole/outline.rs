//! The outline of a foot, the convex hull of its points along the ground, and where the bottoms of spheres are in it.

use glam::DVec2;

use crate::feet::vector::{distance, twice_area};

/// The middle of the area that `corners` enclose; if they enclose none, that of the corners.
pub(super) fn middle(corners: &[DVec2]) -> Option<DVec2> {
    let &first = corners.first()?;
    let (mut whole, mut sum) = (0.0, DVec2::ZERO);
    for pair in corners.windows(2) {
        let &[a, b] = pair else { continue };
        let area = twice_area(first, a, b);
        whole += area;
        sum += area * (first + a + b) / 3.0;
    }
    if whole > 0.0 {
        return Some(sum / whole);
    }
    let &last = corners.last()?;
    Some(0.5 * (first + last))
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
pub(super) fn spread(corners: &[DVec2], near: &[DVec2], count: usize) -> Result<Vec<DVec2>, usize> {
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
fn extremes(corners: &[DVec2], count: usize) -> Vec<DVec2> {
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
            if covers(&own, corners) { own } else { four_extremes(corners, DVec2::X, length(long)) }
        }
    }
}

/// The direction from the rear to the front of an outline, of length 1: its own if it is long, else forward.
pub(super) fn lengthwise(corners: &[DVec2]) -> DVec2 {
    let far = farthest_corners(corners);
    direction_of(&far, diameter(&far))
}

fn direction_of(corners: &[DVec2], long: [DVec2; 2]) -> DVec2 {
    let whole = length(long);
    let [rear, front] = if long[0].x <= long[1].x { long } else { [long[1], long[0]] };
    let along = (front - rear) / whole;
    if whole > 0.0 && whole >= LONG * extent(corners, along.perp()) { along } else { DVec2::X }
}

/// Forward, to the rear, outward and inward, where forward is a direction.
fn towards(forward: DVec2) -> [DVec2; 4] {
    [forward, -forward, forward.perp(), -forward.perp()]
}

/// The corners that are farthest in the four directions; each place once, unless all are needed.
fn four_extremes(corners: &[DVec2], forward: DVec2, length: f64) -> Vec<DVec2> {
    let some = apart(corners, towards(forward), ONE_PLACE * length);
    if covers(&some, corners) { some } else { apart(corners, towards(forward), CLOSEST) }
}

/// The corners that are farthest in some directions, without those that are close to one before.
fn apart<const N: usize>(corners: &[DVec2], directions: [DVec2; N], least: f64) -> Vec<DVec2> {
    let mut some: Vec<DVec2> = Vec::new();
    for corner in directions.into_iter().filter_map(|direction| farthest_along(corners, direction)) {
        if distance_to(corner, &some) >= least {
            some.push(corner);
        }
    }
    some
}

/// Of `corners`, the one that is farthest along `direction`; of equal ones the first.
fn farthest_along(corners: &[DVec2], direction: DVec2) -> Option<DVec2> {
    let mut best: Option<(DVec2, f64)> = None;
    for &corner in corners {
        let along = corner.dot(direction);
        // Coordinates are multiples of a small length: what is equal is so.
        if best.is_none_or(|(_, most)| along > most + CLOSEST * EQUAL) {
            best = Some((corner, along));
        }
    }
    best.map(|(corner, _)| corner)
}

/// How far points reach along a direction of length 1.
pub(super) fn extent(points: &[DVec2], direction: DVec2) -> f64 {
    let along = |point: &DVec2| point.dot(direction);
    let least = points.iter().map(along).fold(f64::INFINITY, f64::min);
    points.iter().map(along).fold(f64::NEG_INFINITY, f64::max) - least
}

/// Whether `some` corners reach nearly as far as all of them, forward and outward.
fn covers(some: &[DVec2], all: &[DVec2]) -> bool {
    let covered = |direction| extent(some, direction) >= COVERED * extent(all, direction);
    covered(DVec2::X) && covered(DVec2::Y)
}

/// The corners that are farthest in some direction, in their order.
fn farthest_corners(corners: &[DVec2]) -> Vec<DVec2> {
    let farthest = (0..DIRECTIONS).filter_map(|turn| farthest_along(corners, direction(turn)));
    let farthest: Vec<DVec2> = farthest.collect();
    corners.iter().filter(|corner| farthest.contains(corner)).copied().collect()
}

fn direction(turn: u32) -> DVec2 {
    let angle = std::f64::consts::TAU * f64::from(turn) / f64::from(DIRECTIONS);
    DVec2::new(libm::cos(angle), libm::sin(angle))
}

/// The two corners that are farthest apart.
fn diameter(corners: &[DVec2]) -> [DVec2; 2] {
    let first = corners.first().copied().unwrap_or_default();
    let mut long = [first, first];
    for (index, &a) in corners.iter().enumerate() {
        for &b in corners.iter().skip(index + 1) {
            if distance(a, b) > length(long) * (1.0 + EQUAL) {
                long = [a, b];
            }
        }
    }
    long
}

/// The point that is farthest from the nearest of `others`, and how far; of equal ones the first.
fn farthest(points: &[DVec2], others: &[DVec2]) -> Option<(DVec2, f64)> {
    let mut best: Option<(DVec2, f64)> = None;
    for &point in points {
        let distance = distance_to(point, others);
        if best.is_none_or(|(_, largest)| distance > largest * (1.0 + EQUAL)) {
            best = Some((point, distance));
        }
    }
    best
}

fn distance_to(point: DVec2, others: &[DVec2]) -> f64 {
    others.iter().map(|&other| distance(point, other)).fold(f64::INFINITY, f64::min)
}

fn closest(points: &[DVec2]) -> f64 {
    let others = |index: usize| points.get(index + 1..).unwrap_or_default();
    let each = points.iter().enumerate().map(|(index, &point)| distance_to(point, others(index)));
    each.fold(f64::INFINITY, f64::min)
}

fn length([a, b]: [DVec2; 2]) -> f64 {
    distance(a, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_is_that_of_the_area_or_of_a_line() {
        let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(DVec2::from);
        assert_eq!(middle(&corners), Some(DVec2::ONE));
        assert_eq!(middle(&[DVec2::ZERO, DVec2::new(2.0, 2.0)]), Some(DVec2::ONE));
        assert!(middle(&[]).is_none());
    }
}
