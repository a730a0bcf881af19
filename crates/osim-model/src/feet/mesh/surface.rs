//! The surface of a mesh: its points, the triangles between them, and what can be wrong with its bytes.

/// Why a mesh cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum MeshFault {
    /// The name ends in something that is not read.
    #[error("files of this kind are not read, expected .vtp, .stl or .obj")]
    UnknownKind,
    /// The bytes are not of the kind that the name says.
    #[error("{0}")]
    NotUnderstood(String),
    /// The file says that more follows than there is.
    #[error("the file ends in the middle of {0}: it was cut off, copy it again")]
    Truncated(&'static str),
    /// Something that is legal and not read here.
    #[error("{0}: save it as ASCII, for example with ParaView")]
    Unsupported(String),
    #[error("it has more than {most} points, reduce it first, for example with MeshLab")]
    TooManyPoints { most: usize },
    /// More triangles than a picture of a bone needs.
    #[error("it has more than {most} triangles, reduce it first, for example with MeshLab")]
    TooManyTriangles { most: usize },
    /// A coordinate of a point is NaN, infinite or larger than any unit of length makes it.
    #[error("coordinate {axis} of point {point} is {value}, expected a number between -1e9 and 1e9")]
    Coordinate {
        /// Number of the bad point, from 1.
        point: usize,
        /// The axis x, y or z of the bad number.
        axis: char,
        value: String,
    },
    #[error("it has {0} different points, expected at least four")]
    FewPoints(usize),
    #[error("all its points are in one line, expected the surface of a bone")]
    InOneLine,
    /// A point is far from all others: a broken number would decide where the sole is.
    #[error(
        "point {point} is {distance} from the middle of the mesh, alone, where nine of ten points are within {reach}: its numbers are \
         broken, correct them or take it out of the file"
    )]
    StrayPoint {
        /// Number of the bad point, from 1.
        point: usize,
        /// Distance of the point from the middle, in the unit of the file.
        distance: String,
        /// How far nine of ten points are at most.
        reach: String,
    },
}

/// Triangles that a surface may have at most: more than a picture of a bone needs.
const MOST_TRIANGLES: usize = 400_000;

/// The surface of a mesh, to be looked at.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Surface {
    /// Points of the surface, in the order of the file.
    pub points: Vec<[f64; 3]>,
    /// Three places among the points for each triangle. A face with more corners is several of them.
    pub triangles: Vec<[u32; 3]>,
}

impl Surface {
    /// A surface whose triangles are each three points in turn.
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

// Numbers in the text of meshes, and how many points there may be.

/// Points that a mesh may have at most.
pub(super) const MOST_POINTS: usize = 2_000_000;

/// Triples of numbers in text; `what` they are, for messages.
pub(super) fn triples<'t>(
    words: impl Iterator<Item = &'t str>,
    what: &'static str,
) -> Result<Vec<[f64; 3]>, MeshFault> {
    let mut points = Vec::new();
    let mut point = [0.0; 3];
    let mut filled = 0;
    for word in words {
        let value = number(word, what)?;
        if let Some(slot) = point.get_mut(filled) {
            *slot = value;
        }
        filled += 1;
        if filled == point.len() {
            add(&mut points, point)?;
            filled = 0;
        }
    }
    if filled == 0 { Ok(points) } else { Err(MeshFault::Truncated(what)) }
}

pub(super) fn number(word: &str, what: &str) -> Result<f64, MeshFault> {
    let broken = || MeshFault::NotUnderstood(format!("{:?} among {what} is not a number", shortened(word)));
    word.parse().map_err(|_| broken())
}

/// The start of a word, for messages.
pub(super) fn shortened(word: &str) -> String {
    word.chars().take(30).collect()
}

pub(super) fn add(points: &mut Vec<[f64; 3]>, point: [f64; 3]) -> Result<(), MeshFault> {
    points.push(point);
    check_point_count(points.len())
}

pub(super) fn check_point_count(points: usize) -> Result<(), MeshFault> {
    let most = MOST_POINTS;
    if points > most { Err(MeshFault::TooManyPoints { most }) } else { Ok(()) }
}
