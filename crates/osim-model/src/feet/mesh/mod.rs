//! Reads the points and surfaces of mesh files.
//!
//! Numbers in text keep all their digits, because OpenSim reads them as doubles, whatever type the file declares. (The crates vtkio
//! 0.7.0-rc2 and stl_io 0.11 read them in single precision, an error of 5e-9 m at the tip of a foot. vtkio also needs quick-xml 0.36, which
//! has known flaws; [`crate::xml`] reads the XML here.) A size that a file declares is checked against the bytes that the file has, before
//! memory is reserved.

mod obj_and_stl;
mod surface;
mod vtp;

use foldhash::{HashSet, HashSetExt};
use glam::DVec3;

use crate::messages::three_significant;
use surface::Result;
pub use surface::{MeshFault, MeshSurface};

/// The largest allowed coordinate or scale factor, so that products of two stay finite.
const LARGEST_MESH_NUMBER: f64 = 1e9;
/// A point is on a straight line if its distance from the line is less than this part of the line's length: single precision has seven
/// digits.
const LARGEST_LINE_DEVIATION: f64 = 1e-6;

/// The points of the mesh file `name`, from its bytes, in the file's own units and frame. The ending of the name (.vtp, .stl, .obj) gives
/// the format. Repeated points are removed.
///
/// ```
/// let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n";
/// let points = osim_model::feet::mesh_points("toe.obj", triangle.as_bytes())?;
/// assert_eq!(points[3], [0.0, 0.0, 1.0]);
/// # Ok::<(), osim_model::feet::MeshFault>(())
/// ```
///
/// # Errors
/// The bytes are not in this format or are cut off. A point is not finite, or far from all others. There are fewer than four or too many
/// points, or all are on one line.
pub fn mesh_points(name: &str, bytes: &[u8]) -> Result<Vec<[f64; 3]>> {
    let ending = name.rsplit_once('.').map(|(_, ending)| ending.to_ascii_lowercase());
    let points = match ending.as_deref() {
        Some("vtp") => vtp::points(bytes),
        Some("stl") => obj_and_stl::stl_points(bytes),
        Some("obj") => obj_and_stl::obj_points(bytes),
        _ => Err(MeshFault::UnknownKind),
    }?;
    checked_points(points)
}

/// The surface in the mesh file `name`, in the file's own units and frame. The ending of the name (.vtp, .stl, .obj) gives the format.
/// Faces with missing points are left out.
///
/// ```
/// let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
/// let surface = osim_model::feet::mesh_surface("sole.obj", square.as_bytes())?;
/// assert_eq!(surface.triangles, [[0, 1, 2], [0, 2, 3]]);
/// # Ok::<(), osim_model::feet::MeshFault>(())
/// ```
///
/// # Errors
/// The bytes are not in this format or are cut off; a point is not finite; there are too many points or triangles.
pub fn mesh_surface(name: &str, bytes: &[u8]) -> Result<MeshSurface> {
    let ending = name.rsplit_once('.').map(|(_, ending)| ending.to_ascii_lowercase());
    let surface = match ending.as_deref() {
        Some("vtp") => vtp::surface(bytes),
        Some("stl") => obj_and_stl::stl_points(bytes).and_then(MeshSurface::of_corners),
        Some("obj") => obj_and_stl::obj_surface(bytes),
        _ => Err(MeshFault::UnknownKind),
    }?;
    refuse_large_coordinates(&surface.points)?;
    Ok(surface)
}

/// Whether a number can be a coordinate in any unit of length, or a scale factor.
pub(crate) fn is_length(value: f64) -> bool {
    value.abs() <= LARGEST_MESH_NUMBER
}

/// Refuses a coordinate that is too large for any unit of length.
fn refuse_large_coordinates(points: &[[f64; 3]]) -> Result<()> {
    for (index, point) in points.iter().enumerate() {
        if let Some((value, axis)) = point.iter().zip(['x', 'y', 'z']).find(|(value, _)| !is_length(**value))
        {
            return Err(MeshFault::Coordinate { point: index + 1, axis, value: value.to_string() });
        }
    }
    Ok(())
}

/// The points without repeats, if they can be the points of a surface.
fn checked_points(mut points: Vec<[f64; 3]>) -> Result<Vec<[f64; 3]>> {
    refuse_large_coordinates(&points)?;

    let mut seen = HashSet::with_capacity(points.len());
    // The place in the file of each point that stays.
    let (mut numbers, mut number) = (Vec::new(), 0);
    points.retain(|point| {
        number += 1;
        // -0 is 0.
        let is_new = seen.insert(point.map(|value| (value + 0.0).to_bits()));
        if is_new {
            numbers.push(number);
        }
        is_new
    });
    if points.len() < 4 {
        return Err(MeshFault::FewPoints(points.len()));
    }
    if are_in_one_line(&points) {
        return Err(MeshFault::InOneLine);
    }
    match stray_point(&points) {
        Some(stray) => Err(MeshFault::StrayPoint {
            point: numbers.get(stray.index).copied().unwrap_or_default(),
            distance: three_significant(stray.distance),
            reach: three_significant(stray.reach),
        }),
        None => Ok(points),
    }
}

/// Whether all points are nearly on the straight line through the first point and the point farthest from it.
fn are_in_one_line(points: &[[f64; 3]]) -> bool {
    let Some(&first) = points.first() else { return true };
    let from_first = || points.iter().map(|&point| DVec3::from(point) - DVec3::from(first));
    let farthest = from_first().max_by(|a, b| length(*a).total_cmp(&length(*b))).unwrap_or_default();
    let whole = length(farthest);
    from_first().all(|point| length(point.cross(farthest / whole)) <= LARGEST_LINE_DEVIATION * whole)
}

// A point that is far from all others: a broken number, and no part of a bone.

/// The least number of points at which a stray point can be recognised.
const LEAST_POINTS_FOR_STRAY: usize = 20;
/// The reach of a mesh is the distance from its middle within which this share of its points is.
const SHARE_IN_REACH: f64 = 0.9;
/// A stray point is farther from the middle than this many times the reach. In real bones (OpenSim's foot, toes and talus) and in
/// `fixtures/feet`, the farthest point is at 1.00 to 1.47 times the reach.
const STRAY_OVER_REACH: f64 = 2.0;
/// The distance, as a part of the reach, within which a stray point has few neighbours. In the meshes of `fixtures/feet`, each point has at
/// least three neighbours.
const NEIGHBOUR_DISTANCE: f64 = 0.5;
/// A stray point has fewer neighbours than this: several broken points may lie together.
const LEAST_NEIGHBOURS: usize = 3;
/// Only this many of the farthest points are compared pair by pair, so that the time does not grow with the square of all points.
const MOST_POINTS_COMPARED: usize = 16;

/// A point that is far from all other points, probably because of a broken number.
struct StrayPoint {
    /// Index of the stray point, from 0.
    index: usize,
    /// Distance of the stray point from the middle, in the unit of the points.
    distance: f64,
    /// Nine of ten points are at most this far from the middle.
    reach: f64,
}

/// The farthest stray point of `points`, which have no repeats.
fn stray_point(points: &[[f64; 3]]) -> Option<StrayPoint> {
    if points.len() < LEAST_POINTS_FOR_STRAY {
        return None;
    }
    let middle: [f64; 3] = std::array::from_fn(|axis| {
        quantile(&mut points.iter().map(|point| point[axis]).collect::<Vec<_>>(), 0.5)
    });
    let far: Vec<f64> = points.iter().map(|point| distance(*point, middle)).collect();
    let reach = quantile(&mut far.clone(), SHARE_IN_REACH);
    let mut farthest: Vec<usize> = (0..points.len())
        .filter(|&index| far.get(index).is_some_and(|far| *far > STRAY_OVER_REACH * reach))
        .collect();
    farthest.sort_by(|a, b| far.get(*b).partial_cmp(&far.get(*a)).unwrap_or(std::cmp::Ordering::Equal));
    let mut compared = farthest.into_iter().take(MOST_POINTS_COMPARED);
    let index = compared.find(|&index| is_alone(points, index, NEIGHBOUR_DISTANCE * reach))?;
    Some(StrayPoint { index, distance: *far.get(index)?, reach })
}

/// Whether the point has few neighbours within the distance `around`.
fn is_alone(points: &[[f64; 3]], index: usize, around: f64) -> bool {
    let Some(&point) = points.get(index) else { return false };
    // The point itself is one of those that are found.
    points.iter().filter(|other| distance(**other, point) <= around).take(LEAST_NEIGHBOURS + 1).count()
        <= LEAST_NEIGHBOURS
}

/// The value that the given share of `values` does not exceed.
fn quantile(values: &mut [f64], share: f64) -> f64 {
    let index = (share * values.len().saturating_sub(1) as f64).round() as usize;
    if index >= values.len() {
        return f64::NAN;
    }
    *values.select_nth_unstable_by(index, f64::total_cmp).1
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    length(DVec3::from(a) - DVec3::from(b))
}

/// The length of a vector of any size. Its parts are not squared, because very large or small numbers of a broken file would overflow.
pub(super) fn length(vector: DVec3) -> f64 {
    vector.x.hypot(vector.y).hypot(vector.z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_face_that_names_a_missing_point_is_left_out() {
        let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\nf 1 2 3\nf -3/1 -2//4 -1\nf 0 1 2\nv 0 0 1\n";
        let surface = mesh_surface("a.obj", text.as_bytes()).unwrap();
        assert_eq!(surface.triangles, [[0, 1, 2], [0, 1, 2]]);
    }

    #[test]
    fn three_points_of_an_stl_file_are_a_triangle() {
        let text = "solid a\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nvertex 1 0 1\nvertex 0 1 1\nendsolid";
        assert_eq!(mesh_surface("a.stl", text.as_bytes()).unwrap().triangles, [[0, 1, 2], [3, 4, 5]]);
    }

    #[test]
    fn a_point_with_an_infinite_coordinate_is_refused() {
        let fault = mesh_surface("a.obj", b"v 0 0 0\nv 1 inf 0\n").unwrap_err();
        assert_eq!(fault, MeshFault::Coordinate { point: 2, axis: 'y', value: "inf".into() });
    }

    /// The points of a box of 0.1 by 0.05 by 0.25, in a grid of 6 × 4 × 11.
    fn points_of_box() -> Vec<[f64; 3]> {
        let along = |count: i32, step: f64| (0..count).map(move |index| f64::from(index) * step);
        along(6, 0.02)
            .flat_map(|x| along(4, 0.05 / 3.0).flat_map(move |y| along(11, 0.025).map(move |z| [x, y, z])))
            .collect()
    }

    #[test]
    fn a_stray_point_is_found_and_a_whole_bone_has_none() {
        assert!(stray_point(&points_of_box()).is_none());
        for (index, broken) in [(7, [0.05, -0.4, 0.1]), (100, [12.0, 0.0, 0.1]), (200, [0.05, 0.02, 250.0])] {
            let mut points = points_of_box();
            points[index] = broken;
            let found = stray_point(&points).unwrap();
            assert_eq!(found.index, index);
            // The box reaches 0.138 from its middle: √(0.05² + 0.025² + 0.125²).
            assert!(found.reach > 0.08 && found.reach < 0.138 && found.distance > 2.0 * found.reach);
        }
    }

    #[test]
    fn stray_points_that_lie_together_are_found() {
        let mut points = points_of_box();
        (points[3], points[4]) = ([0.05, -1.0, 0.1], [0.05, -1.0, 0.101]);
        assert!(matches!(stray_point(&points), Some(StrayPoint { index: 3 | 4, .. })));
    }

    #[test]
    fn a_second_part_of_a_bone_is_not_a_stray_point() {
        // A toe of many points, far ahead.
        let toe = points_of_box().into_iter().take(30).map(|[x, y, z]| [x / 5.0, y / 5.0, 1.0 + z / 5.0]);
        let points: Vec<[f64; 3]> = points_of_box().into_iter().chain(toe).collect();
        assert!(stray_point(&points).is_none());
        // A cube has eight corners.
        assert!(stray_point(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 50.0]]).is_none());
    }
}
