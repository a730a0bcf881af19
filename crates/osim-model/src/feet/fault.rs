//! Errors about the bones and soles of feet, and about unknown poses.

use std::path::PathBuf;

use super::mesh::MeshFault;
use crate::messages::{Phrase, listed};
use crate::model::Fault;
use crate::model::files::FileError;

/// What feet give, or why they cannot.
pub(super) type Result<T, E = FeetFault> = std::result::Result<T, E>;

/// Why bones cannot be read or spheres cannot be placed under a foot.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FeetFault {
    #[error("there is no body {body}, the model has {}", quoted_names(.bodies))]
    NoBody { body: String, bodies: Vec<String> },
    /// The body has no mesh, so its form is unknown.
    #[error(
        "no mesh is attached to body {body}: name another body, or give the places of the spheres in a table"
    )]
    NoMesh { body: String },
    /// The mesh file, by its name in the model, is in none of the folders.
    #[error(
        "body {body} shows mesh {mesh}, which is in none of the folders {}: copy it there, or name the folder that has it",
        shown_paths(.folders)
    )]
    MeshMissing { body: String, mesh: String, folders: Vec<PathBuf> },
    /// The mesh file exists but cannot be opened.
    #[error("mesh {mesh} of body {body}, {}: {fault}", file.display())]
    Unreadable { body: String, mesh: String, file: PathBuf, fault: FileError },
    /// The file is not a mesh of a bone.
    #[error("mesh {mesh} of body {body}, {}: {fault}", file.display())]
    Mesh { body: String, mesh: String, file: PathBuf, fault: MeshFault },
    /// The mesh has scale factors that no bone can have.
    #[error("scale factors of mesh {mesh} of body {body} are {}, expected three numbers other than 0, at most 1e9", three_numbers_text(.factors))]
    Factors { body: String, mesh: String, factors: [f64; 3] },
    /// The model has no gravity, so no direction is up.
    #[error("the model has no gravity, so it is not known where its soles point: give its <gravity> a value")]
    NoGravity,
    /// A value in a request is out of its range.
    #[error("{what} is {value}, expected {expected}")]
    Request { what: &'static str, value: f64, expected: &'static str },
    /// The bottoms of some spheres would be closer than 1 mm. At most `fits` spheres are not.
    #[error(
        "of {count} spheres under {} some would be closer than 1 mm, expected at most {fits}: ask for fewer",
        quoted_names(.bodies)
    )]
    TooManySpheres { bodies: Vec<String>, count: usize, fits: usize },
    /// The place of a body at the default pose is not known.
    #[error(transparent)]
    Pose(#[from] PoseFault),
    #[error("{0}")]
    Model(#[from] Fault),
}

impl FeetFault {
    /// The message on one line. Names from files are escaped.
    pub fn phrase(&self) -> Phrase {
        match self {
            Self::Model(fault) => fault.phrase(),
            other => other.to_string().into(),
        }
    }

    /// Stable short name, as in the JSON `code`.
    pub fn code(&self) -> &'static str {
        match self {
            Self::NoBody { .. } => "no-such-body",
            Self::NoMesh { .. } => "no-mesh",
            Self::MeshMissing { .. } => "mesh-missing",
            Self::Unreadable { .. } => "unreadable",
            Self::Mesh { .. } | Self::Factors { .. } => "bad-mesh",
            Self::NoGravity | Self::Request { .. } => "refused",
            Self::TooManySpheres { .. } => "too-many-spheres",
            Self::Pose(_) => "unknown-pose",
            Self::Model(fault) => fault.code(),
        }
    }
}

/// The largest number of names in one message, to keep the message readable.
const MOST_NAMES_SHOWN: usize = 20;

fn quoted_names(names: &[String]) -> String {
    listed(names, MOST_NAMES_SHOWN)
}

fn shown_paths(paths: &[PathBuf]) -> String {
    let shown = |path: &PathBuf| match path.to_string_lossy() {
        path if path.is_empty() => ".".to_owned(),
        path => path.into_owned(),
    };
    paths.iter().map(shown).collect::<Vec<_>>().join(", ")
}

fn three_numbers_text(values: &[f64; 3]) -> String {
    if values.iter().all(|value| value.is_nan()) {
        return "not three numbers".to_owned();
    }
    values.map(|value| value.to_string()).join(", ")
}

/// Why the place of a body at the default pose is not known.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum PoseFault {
    /// No chain of joints leads from ground to the body.
    #[error("no joints lead from ground to body {body}, so it is not known where it is at the default pose")]
    NotJoined { body: String },
    /// The joint, or one of its functions, is not supported.
    #[error(
        "the default pose of joint {joint}, a {class}, cannot be computed: one of its functions, or the joint itself, is not understood"
    )]
    Joint { joint: String, class: String },
    #[error("coordinate {coordinate} of joint {joint} has no default value that can be read")]
    Coordinate { coordinate: String, joint: String },
    /// A constraint that is not supported may move bodies away from the default pose.
    #[error(
        "constraint {constraint}, a {class}, may move bodies at the default pose, which is not computed: switch it off in a copy of the model"
    )]
    Constraint { constraint: String, class: String },
    /// Joints form a loop that does not close.
    #[error("joint {joint} closes a loop of joints that is open at the default pose")]
    Loop { joint: String },
}
