//! A bone as its mesh shows it.

use std::path::PathBuf;

/// The points of one mesh that is attached to a body, in the body's frame.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Bone {
    /// Name of the body.
    pub body: String,
    /// Name of the mesh file as the model spells it.
    pub mesh: String,
    /// Points of the mesh in the body's frame, with the model's scale factors, m.
    pub points_m: Vec<[f64; 3]>,
    /// The file that was read; empty where the points are from elsewhere.
    pub file: PathBuf,
    /// Whether the file is that of the other side: then its points were mirrored in z.
    pub mirrored: bool,
}

impl Bone {
    /// A bone from points that are in the body's frame already.
    pub fn new(body: impl Into<String>, mesh: impl Into<String>, points_m: Vec<[f64; 3]>) -> Self {
        Self { body: body.into(), mesh: mesh.into(), points_m, file: PathBuf::new(), mirrored: false }
    }
}
