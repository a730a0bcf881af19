//! What can be wrong with feet, and unknown about a pose.

use std::path::PathBuf;

use super::mesh::MeshFault;
use crate::messages::{Phrase, listed};
use crate::model::Fault;
use crate::model::files::FileError;

/// Why bones cannot be read or spheres not be laid.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FeetFault {
    #[error("there is no body {body}, the model has {}", listed_names(.bodies))]
    NoBody { body: String, bodies: Vec<String> },
    /// Nothing is known about the form of a body.
    #[error(
        "no mesh is attached to body {body}: name another body, or give the places of the spheres in a table"
    )]
    NoMesh { body: String },
    /// A file that is in none of the folders.
    #[error(
        "body {body} shows mesh {mesh}, which is in none of the folders {}: copy it there, or name the folder that has it",
        shown_paths(.folders)
    )]
    MeshMissing {
        body: String,
        /// The file as the model spells it.
        mesh: String,
        folders: Vec<PathBuf>,
    },
    /// A file that is there and cannot be opened.
    #[error("mesh {mesh} of body {body}, {}: {fault}", file.display())]
    Unreadable {
        body: String,
        /// The file as the model spells it.
        mesh: String,
        file: PathBuf,
        fault: FileError,
    },
    /// A file that is not the mesh of a bone.
    #[error("mesh {mesh} of body {body}, {}: {fault}", file.display())]
    Mesh {
        body: String,
        /// The file as the model spells it.
        mesh: String,
        file: PathBuf,
        /// Why the file cannot be read as a mesh.
        fault: MeshFault,
    },
    /// Scale factors that no bone can have.
    #[error("scale factors of mesh {mesh} of body {body} are {}, expected three numbers other than 0, at most 1e9", numbers(.factors))]
    Factors {
        body: String,
        /// The file as the model spells it.
        mesh: String,
        factors: [f64; 3],
    },
    /// The model has no gravity, so that no direction is up.
    #[error("the model has no gravity, so it is not known where its soles point: give its <gravity> a value")]
    NoGravity,
    /// A value of a request that is out of range.
    #[error("{what} is {value}, expected {expected}")]
    Request { what: &'static str, value: f64, expected: &'static str },
    /// Bottoms would be closer than 1 mm.
    #[error(
        "of {count} spheres under {} some would be closer than 1 mm, expected at most {fits}: ask for fewer",
        listed_names(.bodies)
    )]
    TooManySpheres {
        bodies: Vec<String>,
        count: usize,
        /// The number of spheres that fit.
        fits: usize,
    },
    /// The default pose of a body is not known.
    #[error(transparent)]
    Pose(#[from] PoseFault),
    #[error("{0}")]
    Model(#[from] Fault),
}

impl FeetFault {
    /// The message, on one line, with names from outside escaped.
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

/// Names that are shown at most, so that a message stays readable.
const MOST_NAMES_SHOWN: usize = 20;

fn listed_names(names: &[String]) -> String {
    listed(names, MOST_NAMES_SHOWN)
}

fn shown_paths(paths: &[PathBuf]) -> String {
    let shown = |path: &PathBuf| match path.to_string_lossy() {
        path if path.is_empty() => ".".to_owned(),
        path => path.into_owned(),
    };
    shown_list(paths.iter().map(shown))
}

fn shown_list(names: impl Iterator<Item = String>) -> String {
    names.collect::<Vec<_>>().join(", ")
}

fn numbers(values: &[f64; 3]) -> String {
    if values.iter().all(|value| value.is_nan()) {
        return "not three numbers".to_owned();
    }
    shown_list(values.iter().map(ToString::to_string))
}

/// Why it is not known where a body is at the default pose.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum PoseFault {
    /// No body of that name is joined to ground.
    #[error("no joints lead from ground to body {body}, so it is not known where it is at the default pose")]
    NotJoined { body: String },
    /// A joint, or a function of it, that is not understood.
    #[error(
        "it is not known how joint {joint}, a {class}, stands at the default pose: one of its functions, or the joint itself, is not understood"
    )]
    Joint { joint: String, class: String },
    #[error("coordinate {coordinate} of joint {joint} has no default value that can be read")]
    Coordinate { coordinate: String, joint: String },
    /// A constraint that may move bodies before anything else does.
    #[error(
        "constraint {constraint}, a {class}, may move bodies at the default pose, which is not computed: switch it off in a copy of the model"
    )]
    Constraint { constraint: String, class: String },
    /// Joints in a loop that does not close.
    #[error("joint {joint} closes a loop of joints that is open at the default pose")]
    Loop { joint: String },
}
