//! An object has a name with which OpenSim refuses the model.

use crate::model::components::{Component, ComponentId};
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};
use crate::model::object_name::refuse_name_in_paths;
use crate::model::typed_model::Model;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::RefusedName,
    severity: Severity::Error,
    seen: Seen::Model,
    verdict: None,
    what: "An object has a name with which OpenSim refuses the model.",
    why: "OpenSim finds objects by paths, in which a name must be one step: it has no blank and none of / * + and the backslash in it, and is neither . nor ..",
    advice: "Give the object another name, and write it wherever the old one is",
    repair: Repair::NotPossible("names are left alone: only numbers are changed"),
    example: Example::Models { good: "format/v40000.osim", bad: "bad/name_with_blank.osim" },
};

pub(super) fn of_component(model: &Model, id: ComponentId, object: &Component) -> Option<Finding> {
    object.parent?;
    let components = model.components();
    let in_paths = object.shared.as_ref().unwrap_or(&object.segment);
    // Joints of old documents call bodies by their names as they are written.
    let written = (components.tag(id) == "Body").then(|| components.name(id)).filter(|name| !name.is_empty());
    let why = refuse_name_in_paths(written.as_deref().unwrap_or(in_paths)).err()?;
    let path = components.tree.path(id);
    Some(Finding::at(&RULE, components.line(id), why.to_string()).about(&path))
}
