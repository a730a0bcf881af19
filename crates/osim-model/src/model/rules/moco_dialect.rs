//! The sphere's radius is inside the force, as in Moco 0.1 to 0.3.

use crate::model::contacts::Sphere;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};
use crate::model::typed_model::Model;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::MocoDialect,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: None,
    what: "The sphere's radius is inside the force, as in Moco 0.1 to 0.3.",
    why: "OpenSim 4.2 and later cannot read such forces; the model works in OpenSim Moco 0.1 to 0.3 only.",
    advice: "Take spheres and planes out of the forces; OpenSim 4.2 and later would drop them without a word when they save the model",
    repair: Repair::Command(
        "makes spheres and planes members of the ContactGeometrySet, with all numbers as they are",
    ),
    example: Example::Models { good: "format/v40000.osim", bad: "format/moco_sphere_in_force.osim" },
};

pub(super) fn find(model: &Model) -> Vec<Finding> {
    let inside = model.spheres().iter().filter(|sphere| sphere.is_inside_force());
    let finding = |sphere: &Sphere| {
        let text = format!("{} keeps its sphere inside: OpenSim 4.2 and later cannot read it", sphere.path);
        Finding::at(&RULE, sphere.line, text).about(&sphere.path)
    };
    inside.map(finding).collect()
}
