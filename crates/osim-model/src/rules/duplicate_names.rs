//! Two components have the same name.

use crate::class::Class;
use crate::components::ComponentId;
use crate::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};
use crate::model::Model;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::DuplicateNames,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: None,
    what: "Two components have the same name.",
    why: "OpenSim renames the second one when it loads the model, so a path or a name means the first one only.",
    advice: "Give each a name of its own",
    repair: Repair::NotPossible("names are left alone: only numbers are changed"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/same_sphere_name_twice.osim" },
};

pub(super) fn of_component(model: &Model, id: ComponentId, segment: &str) -> Option<Finding> {
    let components = model.components();
    let (tag, name) = (components.tag(id), components.name(id));
    let ours = tag.starts_with("Contact") || tag == "HuntCrossleyForce" || tag.starts_with("SmoothSphere");
    (ours && tag != Class::ContactParameters.tag() && segment != name && !name.is_empty()).then(|| {
        let path = components.tree.path(id);
        let text = format!("'{name}' appears twice: OpenSim calls this one {path}");
        Finding::at(&RULE, components.line(id), text).about(&path)
    })
}
