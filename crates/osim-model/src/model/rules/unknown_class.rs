//! Contacts are in a component of a class that OpenSim does not know.

use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};
use crate::model::typed_model::Model;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::UnknownClass,
    severity: Severity::Error,
    seen: Seen::Model,
    verdict: None,
    what: "Contacts are in a component of a class that OpenSim does not know.",
    why: "OpenSim skips a component of a class it does not know, with everything in it, so these contacts do not exist for it; they were left alone. A plugin may know the class.",
    advice: "Move the contacts into the ForceSet, or out of the component of that class",
    repair: Repair::NotPossible("only numbers are changed, and the contacts have to move"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/components_unknown_class.osim" },
};

pub(super) fn find(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    let components = model.components();
    for &(file, element) in &components.tree.skipped {
        let document = components.document(file);
        let tree = document.tree();
        let inside = tree.slice(tree.span(element));
        if inside.contains("<HuntCrossleyForce ") || inside.contains("<SmoothSphereHalfSpaceForce ") {
            let line = document.line(tree.span(element).start);
            let text = format!(
                "contacts inside a <{}> are left alone: OpenSim does not know that class",
                tree.name(element)
            );
            found.push(Finding::at(&RULE, line, text));
        }
    }
    found
}
