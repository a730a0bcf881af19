//! What can be wrong with the bytes of a mesh.

/// Why a mesh cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
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
    /// More points than a bone needs.
    #[error("it has more than {most} points, reduce it first, for example with MeshLab")]
    TooManyPoints {
        /// So many are read.
        most: usize,
    },
    /// More triangles than a picture of a bone needs.
    #[error("it has more than {most} triangles, reduce it first, for example with MeshLab")]
    TooManyTriangles {
        /// So many are shown.
        most: usize,
    },
    /// A coordinate of a point is NaN, infinite or larger than any unit of length makes it.
    #[error("coordinate {axis} of point {point} is {value}, expected a number between -1e9 and 1e9")]
    Coordinate {
        /// Which point, from 1.
        point: usize,
        /// x, y or z.
        axis: char,
        /// As it was read.
        value: String,
    },
    /// Too few points for an outline.
    #[error("it has {0} different points, expected at least four")]
    FewPoints(usize),
    /// All points are in one line.
    #[error("all its points are in one line, expected the surface of a bone")]
    InOneLine,
    /// A point is far from all others: a broken number would decide where the sole is.
    #[error(
        "point {point} is {distance} from the middle of the mesh, alone, where nine of ten points are within {reach}: its numbers are \
         broken, correct them or take it out of the file"
    )]
    StrayPoint {
        /// Which point, from 1.
        point: usize,
        /// How far it is from the middle, in the unit of the file.
        distance: String,
        /// How far nine of ten points are at most.
        reach: String,
    },
}
