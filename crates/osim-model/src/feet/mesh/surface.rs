//! The surface of a mesh: its points and triangles; and the reasons why a mesh file cannot be read.

/// What a mesh file gives, or why it cannot be read.
pub(super) type Result<T, E = MeshFault> = std::result::Result<T, E>;

/// Why a mesh file cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum MeshFault {
    /// The ending of the file name is of no supported format.
    #[error("files of this kind are not read, expected .vtp, .stl or .obj")]
    UnknownKind,
    /// The bytes are not in the format that the file name says.
    #[error("{0}")]
    NotUnderstood(String),
    /// The file ends before everything that it announces.
    #[error("the file ends in the middle of {0}: it was cut off, copy it again")]
    Truncated(&'static str),
    /// The file uses a permitted feature of its format that is not supported here.
    #[error("{0}: save it as ASCII, for example with ParaView")]
    Unsupported(String),
    #[error("it has more than {most} points, reduce it first, for example with MeshLab")]
    TooManyPoints { most: usize },
    /// The mesh has more triangles than a picture of a bone needs.
    #[error("it has more than {most} triangles, reduce it first, for example with MeshLab")]
    TooManyTriangles { most: usize },
    /// A coordinate of a point, numbered from 1, is NaN, infinite, or too large for any unit of length.
    #[error("coordinate {axis} of point {point} is {value}, expected a number between -1e9 and 1e9")]
    Coordinate { point: usize, axis: char, value: String },
    #[error("it has {0} different points, expected at least four")]
    FewPoints(usize),
    #[error("all its points are in one line, expected the surface of a bone")]
    InOneLine,
    /// A point is far from all others. With it, a broken number would determine the sole. Nine of ten points are within `reach` of the middle.
    #[error(
        "point {point} is {distance} from the middle of the mesh, alone, where nine of ten points are within {reach}: its numbers are \
         broken, correct them or take it out of the file"
    )]
    StrayPoint { point: usize, distance: String, reach: String },
}

/// The largest number of triangles of a surface: more than a picture of a bone needs.
const MOST_TRIANGLES: usize = 400_000;

/// The surface of a mesh, for pictures.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct MeshSurface {
    /// Points of the surface, in file order.
    pub points: Vec<[f64; 3]>,
    /// Triangles, each as three indices of `points`. A face with more corners is divided into triangles.
    pub triangles: Vec<[u32; 3]>,
}

impl MeshSurface {
    /// A surface from `points`, of which each three in a row are one triangle.
    pub(super) fn of_corners(points: Vec<[f64; 3]>) -> Result<Self> {
        let mut surface = Self { points, triangles: Vec::new() };
        for first in (0..surface.points.len()).step_by(3) {
            surface.add_face(0, [first, first + 1, first + 2].map(Some))?;
        }
        Ok(surface)
    }

    /// Adds a face. Its `corners` are indices of points, counted from `start`. A face with a missing point is left out.
    pub(super) fn add_face(
        &mut self,
        start: usize,
        corners: impl IntoIterator<Item = Option<usize>>,
    ) -> Result<()> {
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

/// The largest number of points of a mesh.
pub(super) const MOST_POINTS: usize = 2_000_000;

/// The numbers in `words`, three for each point.
pub(super) fn number_triples<'t>(words: impl Iterator<Item = &'t str>) -> Result<Vec<[f64; 3]>> {
    let what = "the points";
    let mut points = Vec::new();
    let mut numbers = words.map(|word| parse_number(word, what));
    while let Some(first) = numbers.next() {
        let mut next = || numbers.next().ok_or(MeshFault::Truncated(what))?;
        add(&mut points, [first?, next()?, next()?])?;
    }
    Ok(points)
}

pub(super) fn parse_number(word: &str, what: &str) -> Result<f64> {
    let broken = || MeshFault::NotUnderstood(format!("{:?} among {what} is not a number", shortened(word)));
    word.parse().map_err(|_| broken())
}

/// The first letters of a word, for an error message.
pub(super) fn shortened(word: &str) -> String {
    word.chars().take(30).collect()
}

/// Adds a point, unless there are too many.
pub(super) fn add(points: &mut Vec<[f64; 3]>, point: [f64; 3]) -> Result<()> {
    points.push(point);
    check_point_count(points.len())
}

pub(super) fn check_point_count(points: usize) -> Result<()> {
    let most = MOST_POINTS;
    if points > most { Err(MeshFault::TooManyPoints { most }) } else { Ok(()) }
}
