//! Contacts of a class that is not Hertz's.

use crate::model::components::ComponentId;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};
use crate::model::typed_model::Model;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::NotHertz,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: None,
    what: "Contacts of a class that is not Hertz's.",
    why: "ElasticFoundationForce, ExponentialContactForce and MeyerFregly2016Force do not follow the equations used here; they are left as they are.",
    advice: "Scale them by their own theory, or replace them",
    repair: Repair::NotPossible("the equations are not those of such a force"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/elastic_foundation.osim" },
};

const NOT_HERTZ: [&str; 3] = ["ElasticFoundationForce", "ExponentialContactForce", "MeyerFregly2016Force"];

pub(super) fn of_component(model: &Model, id: ComponentId) -> Option<Finding> {
    let components = model.components();
    let tag = components.tag(id);
    NOT_HERTZ.contains(&tag).then(|| {
        let path = components.tree.path(id);
        let text = format!("{path} is of the class {tag}: left as it is");
        Finding::at(&RULE, components.line(id), text).about(&path)
    })
}
