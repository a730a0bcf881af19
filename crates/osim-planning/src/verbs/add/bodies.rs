//! The names of bodies in a request, and the reasons why contacts cannot be added.

use std::path::Path;

use osim_model::feet::FeetFault;
use osim_model::files::{Failure, OpenModel};
use osim_model::messages::{Input, Phrase, phrase, readable, shown};
use osim_model::{Fault, FaultKind, MissingFact, nearest_names};
use osim_requests::RequestFault;
use osim_requests::values::typed_numbers::trimmed;

/// The beginning of the paths that OpenSim gives to bodies.
const BODY_SET_PATH: &str = "/bodyset/";

/// The names of bodies in `texts`, each name once. Commas, semicolons or blanks separate the names in one text.
///
/// # Errors
/// A name is missing.
pub(super) fn body_names(texts: &[String]) -> Result<Vec<String>, RequestFault> {
    let mut bodies: Vec<String> = Vec::new();
    for text in texts.iter().flat_map(|text| text.split([',', ';'])).map(trimmed) {
        if text.is_empty() {
            let message = phrase![
                "{}: a name is missing; expected the bodies that touch the ground with commas between them, as in {}";
                Input::Feet, Input::Feet.with_placeholder("calcn_r,calcn_l")
            ];
            return Err(RequestFault::refused(Input::Feet, message));
        }
        for body in text.split(' ').filter(|name| !name.is_empty()).map(name_without_path) {
            if !bodies.iter().any(|known| known == body) {
                bodies.push(body.to_owned());
            }
        }
    }
    Ok(bodies)
}

/// The name of a body, without OpenSim's path if there is one.
pub(super) fn name_without_path(body: &str) -> &str {
    body.strip_prefix(BODY_SET_PATH).unwrap_or(body)
}

/// The hint `: did you mean calcn_r?`, if one of `bodies` has nearly the same name as `body`.
pub(super) fn nearest_name_hint(body: &str, bodies: &[String]) -> String {
    let nearest = nearest_names(body, bodies.iter().map(String::as_str), 2);
    nearest.first().map(|known| format!(": did you mean {}?", shown(known))).unwrap_or_default()
}

/// The reason why contacts cannot be added to a model.
pub(super) enum AddFault {
    Model(Box<Fault>),
    /// A fault in a table, a mesh or an option, with the code of the fault.
    OutsideModel(&'static str, Phrase),
}

impl From<Fault> for AddFault {
    fn from(fault: Fault) -> Self {
        // The usual advice names the mass that old contacts were made for. New contacts were made for none.
        if let FaultKind::MissingFact(MissingFact::ModelMass { bodies, kg }) = fault.kind {
            let text = format!(
                "the {bodies} bodies weigh {} kg in all: give the mass of the model with ",
                readable(kg)
            );
            return Self::OutsideModel("no-mass", phrase![text, Input::Mass.with_placeholder("KG")]);
        }
        Self::Model(Box::new(fault))
    }
}

impl From<FeetFault> for AddFault {
    fn from(fault: FeetFault) -> Self {
        let (code, sentence) = (fault.code(), fault.phrase());
        let table = Input::Contacts.with_placeholder("TABLE");
        let message = match fault {
            FeetFault::Model(fault) => return Self::from(fault),
            FeetFault::NoBody { body, bodies } => phrase![&sentence, nearest_name_hint(&body, &bodies)],
            FeetFault::NoMesh { .. } => phrase![&sentence, ": ", table],
            FeetFault::MeshMissing { .. } => {
                phrase![&sentence, ": ", Input::GeometryDir.with_placeholder("DIR")]
            }
            FeetFault::TooManySpheres { .. } => {
                phrase![&sentence, " with ", Input::Count.with_placeholder("N")]
            }
            FeetFault::Pose(_) => phrase![&sentence, ": give the places in a table, ", table],
            FeetFault::Mesh { .. } | FeetFault::Unreadable { .. } | FeetFault::Factors { .. } => {
                phrase![&sentence, "; or give the places in a table: ", table]
            }
            _ => sentence,
        };
        Self::OutsideModel(code, message)
    }
}

impl AddFault {
    pub(super) fn into_fault(self) -> Fault {
        match self {
            Self::Model(fault) => *fault,
            Self::OutsideModel(_, message) => Fault::refused(message.to_string()),
        }
    }

    pub(super) fn into_failure(self, opened: &OpenModel) -> Failure {
        match self {
            Self::Model(fault) => opened.failure(*fault),
            Self::OutsideModel(code, message) => Failure::outside(opened.name(), code, message),
        }
    }
}

/// A fault in a table of contacts as a failure of the file at `path`.
pub(super) fn table_failure(path: &Path, fault: &crate::contact_table::TableFault) -> Failure {
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
            assert_eq!(body_names(&texts).unwrap(), ["calcn_r", "calcn_l"], "{texts:?}");
        }
        for texts in [&["calcn_r", ""][..], &[""], &["calcn_r,,calcn_l"], &[" "]] {
            let texts: Vec<String> = texts.iter().map(|text| (*text).to_owned()).collect();
            assert!(body_names(&texts).is_err(), "{texts:?}");
        }
        assert!(body_names(&[]).unwrap().is_empty());
    }

    #[test]
    fn names_that_are_nearly_right_are_proposed() {
        let bodies = ["pelvis", "calcn_r", "calcn_l"].map(str::to_owned);
        assert_eq!(nearest_name_hint("Calcn_R", &bodies), ": did you mean calcn_r?");
        assert_eq!(nearest_name_hint("calc_l", &bodies), ": did you mean calcn_l?");
        assert_eq!(nearest_name_hint("hoof_r", &bodies), "");
    }
}
