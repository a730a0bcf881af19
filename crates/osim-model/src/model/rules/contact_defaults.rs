//! The defaults of the document hold contact objects.

use crate::model::class::Class;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};
use crate::model::typed_model::Model;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::ContactDefaults,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: None,
    what: "The defaults of the document hold contact objects.",
    why: "OpenSim keeps the defaults of one model for every model loaded later in the same session, so another model can silently take these values.",
    advice: "Write the values into the forces themselves, or load the model in a fresh OpenSim",
    repair: Repair::NotPossible("<defaults> are left alone, because other models may depend on them"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/defaults_smooth.osim" },
};

pub(super) fn find(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    let document = model.document();
    let tree = document.tree();
    let Some(defaults) = document.defaults() else { return found };
    let classes = [
        Class::SmoothSphereHalfSpaceForce,
        Class::HuntCrossleyForce,
        Class::ContactParameters,
        Class::ContactSphere,
    ];
    for class in classes {
        if let Some(default) = tree.child(defaults, class.tag()) {
            // OpenSim itself writes defaults without content; those carry nothing.
            if tree.children(default).next().is_none() {
                continue;
            }
            let line = document.line(tree.span(default).start);
            let text =
                format!("<defaults> holds a {}: OpenSim keeps it for models loaded later", class.tag());
            found.push(Finding::at(&RULE, line, text));
        }
    }
    found
}
