//! The surface of a mesh: its points, and the triangles between them.

use super::fault::MeshFault;

/// Triangles that a surface may have at most: more than a picture of a bone needs.
const MOST_TRIANGLES: usize = 400_000;

/// The surface of a mesh, to be looked at.
#[derive(Debug, Clone, Default, PartialEq)]
#[non_exhaustive]
pub struct Surface {
    /// Its points, in the order of the file.
    pub points: Vec<[f64; 3]>,
    /// Three places among the points for each triangle. A face with more corners is several of them.
    pub triangles: Vec<[u32; 3]>,
}

impl Surface {
    /// Each three points are a triangle.
    pub(super) fn of_corners(points: Vec<[f64; 3]>) -> Result<Self, MeshFault> {
        let mut surface = Self { points, triangles: Vec::new() };
        for first in (0..surface.points.len()).step_by(3) {
            surface.add_face(0, [first, first + 1, first + 2].map(Some))?;
        }
        Ok(surface)
    }

    /// Adds a face with these corners, which count from `start`; one that names a point that is not there is left out.
    pub(super) fn add_face(
        &mut self,
        start: usize,
        corners: impl IntoIterator<Item = Option<usize>>,
    ) -> Result<(), MeshFault> {
        let known = |corner: Option<usize>| {
            let at = corner?.checked_add(start).filter(|at| *at < self.points.len())?;
            u32::try_from(at).ok()
        };
        let Some(corners) = corners.into_iter().map(known).collect::<Option<Vec<u32>>>() else {
            return Ok(());
        };
        let [first, others @ ..] = corners.as_slice() else { return Ok(()) };
        for pair in others.windows(2) {
            if let [second, third] = pair {
                self.triangles.push([*first, *second, *third]);
            }
        }
        if self.triangles.len() > MOST_TRIANGLES {
            return Err(MeshFault::TooManyTriangles { most: MOST_TRIANGLES });
        }
        Ok(())
    }
}
