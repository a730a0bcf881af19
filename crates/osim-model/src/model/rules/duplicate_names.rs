//! Two components have the same name.

use crate::model::class::Class;
use crate::model::components::{Component, ComponentId};
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};
use crate::model::typed_model::Model;

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

pub(super) fn of_component(model: &Model, id: ComponentId, object: &Component) -> Option<Finding> {
    let components = model.components();
    let tag = components.tag(id);
    let ours =
        ["Contact", "HuntCrossleyForce", "SmoothSphere", "Body"].iter().any(|class| tag.starts_with(class));
    let shared = object.shared.as_ref().filter(|_| ours && tag != Class::ContactParameters.tag())?;
    // What has no name is called after its class.
    let is_named = tag.ends_with("Set") || !components.name(id).is_empty();
    is_named.then(|| {
        let path = components.tree.path(id);
        let text = format!("'{shared}' appears twice: OpenSim calls this one {path}");
        Finding::at(&RULE, components.line(id), text).about(&path)
    })
}
