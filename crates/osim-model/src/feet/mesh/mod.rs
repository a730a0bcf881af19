//! The points of mesh files.
//!
//! Numbers in text keep all their digits, because OpenSim reads them as doubles whatever type the file declares. (The crates
//! vtkio 0.7.0-rc2 and stl_io 0.11 read them in single precision, 5e-9 m off at the tip of a foot, and vtkio brings quick-xml
//! 0.36, which has known flaws; [`crate::xml`] scans the XML here.) Nothing is allocated because a file says so: sizes are checked
//! against the bytes that are there.

mod fault;
mod numbers;
mod obj;
mod stl;
mod stray;
mod surface;
mod vtk_array;
mod vtp;

use crate::messages::three_significant;
use foldhash::{HashSet, HashSetExt};

use self::stray::stray;
pub use fault::MeshFault;
pub use surface::Surface;

/// The largest coordinate or factor: products of these are finite.
const LARGEST: f64 = 1e9;
/// Points closer to a line than this part of its length are in it: single precision has seven digits.
const SAME_LINE: f64 = 1e-6;

/// The points of the mesh file `name` from its bytes, in the file's own units and frame: the ending of the name (.vtp, .stl,
/// .obj) says how they are written. Points that repeat are given once.
///
/// ```
/// let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n";
/// let points = osim_model::feet::mesh_points("toe.obj", triangle.as_bytes())?;
/// assert_eq!(points[3], [0.0, 0.0, 1.0]);
/// # Ok::<(), osim_model::feet::MeshFault>(())
/// ```
///
/// # Errors
/// Bytes that are not such a file, or are cut off; points that are not finite, fewer than four, too many, all in one line, or one far from
/// all others.
pub fn mesh_points(name: &str, bytes: &[u8]) -> Result<Vec<[f64; 3]>, MeshFault> {
    let ending = name.rsplit_once('.').map(|(_, ending)| ending.to_ascii_lowercase());
    let points = match ending.as_deref() {
        Some("vtp") => vtp::points(bytes),
        Some("stl") => stl::points(bytes),
        Some("obj") => obj::points(bytes),
        _ => Err(MeshFault::UnknownKind),
    }?;
    checked(points)
}

/// The surface that the mesh file `name` describes, in the file's own units and frame: the ending of the name (.vtp, .stl, .obj)
/// says how it is written. Faces that name points that are not there are left out.
///
/// ```
/// let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
/// let surface = osim_model::feet::mesh_surface("sole.obj", square.as_bytes())?;
/// assert_eq!(surface.triangles, [[0, 1, 2], [0, 2, 3]]);
/// # Ok::<(), osim_model::feet::MeshFault>(())
/// ```
///
/// # Errors
/// Bytes that are not such a file, or are cut off; a point that is not finite; too many points or triangles.
pub fn mesh_surface(name: &str, bytes: &[u8]) -> Result<Surface, MeshFault> {
    let ending = name.rsplit_once('.').map(|(_, ending)| ending.to_ascii_lowercase());
    let surface = match ending.as_deref() {
        Some("vtp") => vtp::surface(bytes),
        Some("stl") => stl::points(bytes).and_then(Surface::of_corners),
        Some("obj") => obj::surface(bytes),
        _ => Err(MeshFault::UnknownKind),
    }?;
    for (index, point) in surface.points.iter().enumerate() {
        if let Some((value, axis)) = point.iter().zip(['x', 'y', 'z']).find(|(value, _)| !is_length(**value))
        {
            return Err(MeshFault::Coordinate { point: index + 1, axis, value: value.to_string() });
        }
    }
    Ok(surface)
}

/// Whether a number can be a coordinate in some unit, or a factor of one.
pub(crate) fn is_length(value: f64) -> bool {
    value.abs() <= LARGEST
}

/// Points, each once, if they are those of a surface.
fn checked(mut points: Vec<[f64; 3]>) -> Result<Vec<[f64; 3]>, MeshFault> {
    for (index, point) in points.iter().enumerate() {
        if let Some((value, axis)) = point.iter().zip(['x', 'y', 'z']).find(|(value, _)| !is_length(**value))
        {
            return Err(MeshFault::Coordinate { point: index + 1, axis, value: value.to_string() });
        }
    }
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
    if in_one_line(&points) {
        return Err(MeshFault::InOneLine);
    }
    match stray(&points) {
        Some(stray) => Err(MeshFault::StrayPoint {
            point: numbers.get(stray.index).copied().unwrap_or_default(),
            distance: three_significant(stray.distance),
            reach: three_significant(stray.reach),
        }),
        None => Ok(points),
    }
}

/// Whether all points are as good as in the line through the first and the one farthest from it.
fn in_one_line(points: &[[f64; 3]]) -> bool {
    let Some(&first) = points.first() else { return true };
    let from_first = |point: &[f64; 3]| -> [f64; 3] { std::array::from_fn(|i| point[i] - first[i]) };
    let length = |[x, y, z]: [f64; 3]| x.hypot(y).hypot(z);
    let farthest = points.iter().map(from_first).max_by(|a, b| length(*a).total_cmp(&length(*b)));
    let along = farthest.unwrap_or_default();
    let whole = length(along);
    let [x, y, z] = along.map(|value| value / whole);
    points
        .iter()
        .map(from_first)
        .all(|[a, b, c]| length([b * z - c * y, c * x - a * z, a * y - b * x]) <= SAME_LINE * whole)
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
    fn corners_of_stl_are_triangles() {
        let text = "solid a\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nvertex 1 0 1\nvertex 0 1 1\nendsolid";
        assert_eq!(mesh_surface("a.stl", text.as_bytes()).unwrap().triangles, [[0, 1, 2], [3, 4, 5]]);
    }

    #[test]
    fn a_point_that_is_no_place_is_refused() {
        let fault = mesh_surface("a.obj", b"v 0 0 0\nv 1 inf 0\n").unwrap_err();
        assert_eq!(fault, MeshFault::Coordinate { point: 2, axis: 'y', value: "inf".into() });
    }
}
