//! What keeps contacts from being added: the model, or something beside it.

use std::path::Path;

use osim_model::feet::FeetFault;
use osim_model::files::{Failure, OpenModel};
use osim_model::messages::{Input, Phrase, phrase, readable};
use osim_model::{Fault, FaultKind, Needed};

use super::bodies::meant;

/// Why contacts cannot be added to a model.
pub(super) enum AddFault {
    /// The model, or what is asked of it.
    Model(Box<Fault>),
    /// Something beside the model: a table, a mesh.
    Beside(&'static str, Phrase),
}

impl From<Fault> for AddFault {
    fn from(fault: Fault) -> Self {
        // Contacts that are new were made for no mass before.
        if let FaultKind::Needed(Needed::ModelMass { bodies, kg }) = fault.kind {
            let text = format!(
                "the {bodies} bodies weigh {} kg in all: say what the model weighs with ",
                readable(kg)
            );
            return Self::Beside("no-mass", phrase![text, Input::Mass.like("KG")]);
        }
        Self::Model(Box::new(fault))
    }
}

impl From<FeetFault> for AddFault {
    fn from(fault: FeetFault) -> Self {
        let said = fault.phrase();
        match fault {
            FeetFault::Model(fault) => Self::from(fault),
            FeetFault::NoBody { body, bodies } => {
                Self::Beside("no-such-body", phrase![&said, meant(&body, &bodies)])
            }
            FeetFault::NoMesh { .. } => {
                Self::Beside("no-mesh", phrase![&said, ": ", Input::Contacts.like("TABLE")])
            }
            FeetFault::MeshMissing { .. } => {
                Self::Beside("mesh-missing", phrase![&said, ": ", Input::GeometryDir.like("DIR")])
            }
            FeetFault::TooManySpheres { .. } => {
                Self::Beside("too-many-spheres", phrase![&said, " with ", Input::Count.like("N")])
            }
            FeetFault::Pose(_) => {
                let way_out = ": give the places in a table, ";
                Self::Beside("unknown-pose", phrase![&said, way_out, Input::Contacts.like("TABLE")])
            }
            other @ (FeetFault::Mesh { .. } | FeetFault::Unreadable { .. } | FeetFault::Factors { .. }) => {
                let way_out = "; or give the places in a table: ";
                Self::Beside(other.code(), phrase![&said, way_out, Input::Contacts.like("TABLE")])
            }
            other => Self::Beside(other.code(), said),
        }
    }
}

impl AddFault {
    /// As a fault of the model.
    pub(super) fn fault(self) -> Fault {
        match self {
            Self::Model(fault) => *fault,
            Self::Beside(_, message) => Fault::refused(message.to_string()),
        }
    }

    /// As the failure of a model that was opened.
    pub(super) fn failure(self, opened: &OpenModel) -> Failure {
        match self {
            Self::Model(fault) => opened.failure(*fault),
            Self::Beside(code, message) => Failure::outside(opened.name(), code, message),
        }
    }
}

/// The failure of a file that is read once for all models.
pub(super) fn of_table(path: &Path, fault: &crate::contact_table::TableFault) -> Failure {
    let mut failure = Failure::outside(path, "table", fault.message.clone());
    failure.line = fault.line.and_then(|line| usize::try_from(line).ok());
    failure.column = fault.column;
    failure
}
