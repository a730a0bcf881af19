//! Bodies as people write their names, and what keeps contacts from being added to them.

use std::path::Path;

use osim_model::feet::FeetFault;
use osim_model::files::{Failure, OpenModel};
use osim_model::messages::{Input, Phrase, phrase, readable, shown};
use osim_model::{Fault, FaultKind, Needed};
use osim_requests::RequestFault;
use osim_requests::values::typed::trimmed;

/// Where OpenSim has bodies, in its paths.
const BODY_SET: &str = "/bodyset/";
/// Names that differ in at most this many letters are probably one.
const NEAR: usize = 2;

/// The bodies of a list, each once: names with commas or semicolons between them, in one text or in several.
///
/// # Errors
/// A name is missing.
pub(super) fn listed(texts: &[String]) -> Result<Vec<String>, RequestFault> {
    let mut bodies: Vec<String> = Vec::new();
    for text in texts.iter().flat_map(|text| text.split([',', ';'])).map(trimmed) {
        if text.is_empty() {
            let message = phrase![
                Input::Feet,
                ": a name is missing; expected the bodies that touch the ground with commas between them, as in ",
                Input::Feet.with_placeholder("calcn_r,calcn_l"),
            ];
            return Err(RequestFault::refused(Input::Feet, message));
        }
        for body in text.split(' ').filter(|name| !name.is_empty()).map(plain) {
            if !bodies.iter().any(|known| known == body) {
                bodies.push(body.to_owned());
            }
        }
    }
    Ok(bodies)
}

/// The name of a body that is written with OpenSim's path.
pub(super) fn plain(body: &str) -> &str {
    body.strip_prefix(BODY_SET).unwrap_or(body)
}

/// `: did you mean calcn_r?`, where one of `bodies` is nearly called `body`.
pub(super) fn meant(body: &str, bodies: &[String]) -> String {
    let flat = |name: &str| name.to_lowercase();
    let apart = |known: &&String| strsim::osa_distance(&flat(known), &flat(body));
    match bodies.iter().min_by_key(apart).filter(|known| apart(known) <= NEAR) {
        Some(known) => format!(": did you mean {}?", shown(known)),
        None => String::new(),
    }
}

// What keeps contacts from being added: the model, or something beside it.

/// Why contacts cannot be added to a model.
pub(super) enum AddFault {
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
            return Self::Beside("no-mass", phrase![text, Input::Mass.with_placeholder("KG")]);
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
                Self::Beside("no-mesh", phrase![&said, ": ", Input::Contacts.with_placeholder("TABLE")])
            }
            FeetFault::MeshMissing { .. } => {
                Self::Beside("mesh-missing", phrase![&said, ": ", Input::GeometryDir.with_placeholder("DIR")])
            }
            FeetFault::TooManySpheres { .. } => {
                Self::Beside("too-many-spheres", phrase![&said, " with ", Input::Count.with_placeholder("N")])
            }
            FeetFault::Pose(_) => {
                let way_out = ": give the places in a table, ";
                Self::Beside(
                    "unknown-pose",
                    phrase![&said, way_out, Input::Contacts.with_placeholder("TABLE")],
                )
            }
            other @ (FeetFault::Mesh { .. } | FeetFault::Unreadable { .. } | FeetFault::Factors { .. }) => {
                let way_out = "; or give the places in a table: ";
                Self::Beside(other.code(), phrase![&said, way_out, Input::Contacts.with_placeholder("TABLE")])
            }
            other => Self::Beside(other.code(), said),
        }
    }
}

impl AddFault {
    pub(super) fn fault(self) -> Fault {
        match self {
            Self::Model(fault) => *fault,
            Self::Beside(_, message) => Fault::refused(message.to_string()),
        }
    }

    pub(super) fn failure(self, opened: &OpenModel) -> Failure {
        match self {
            Self::Model(fault) => opened.failure(*fault),
            Self::Beside(code, message) => Failure::outside(opened.name(), code, message),
        }
    }
}

/// The failure of a file that is read once for all models.
pub(super) fn failure_of_table(path: &Path, fault: &crate::contact_table::TableFault) -> Failure {
    let mut failure = Failure::outside(path, "table", fault.message.clone());
    failure.line = fault.line.and_then(|line| usize::try_from(line).ok());
    failure.column = fault.column;
    failure
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_are_listed_with_any_separator_and_each_once() {
        for texts in [
            &["calcn_r", "calcn_l"][..],
            &["calcn_r,calcn_l"],
            &["calcn_r, calcn_l"],
            &["calcn_r;calcn_l"],
            &["calcn_r calcn_l"],
            &["/bodyset/calcn_r", " calcn_l "],
            &["calcn_r", "calcn_r", "calcn_l"],
        ] {
            let texts: Vec<String> = texts.iter().map(|text| (*text).to_owned()).collect();
            assert_eq!(listed(&texts).unwrap(), ["calcn_r", "calcn_l"], "{texts:?}");
        }
        for texts in [&["calcn_r", ""][..], &[""], &["calcn_r,,calcn_l"], &[" "]] {
            let texts: Vec<String> = texts.iter().map(|text| (*text).to_owned()).collect();
            assert!(listed(&texts).is_err(), "{texts:?}");
        }
        assert!(listed(&[]).unwrap().is_empty());
    }

    #[test]
    fn names_that_are_nearly_right_are_proposed() {
        let bodies = ["pelvis", "calcn_r", "calcn_l"].map(str::to_owned);
        assert_eq!(meant("Calcn_R", &bodies), ": did you mean calcn_r?");
        assert_eq!(meant("calc_l", &bodies), ": did you mean calcn_l?");
        assert_eq!(meant("hoof_r", &bodies), "");
    }
}
