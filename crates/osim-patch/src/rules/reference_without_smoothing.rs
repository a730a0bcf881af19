//! The reference has no smoothing parameters to give.

use osim_model::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::ReferenceWithoutSmoothing,
    severity: Severity::Warn,
    seen: Seen::Change,
    verdict: None,
    what: "The reference has no smoothing parameters to give.",
    why: "A HuntCrossleyForce has no constant_contact_force, hertz_smoothing or hunt_crossley_smoothing, so those of the model stay (or follow its own radii where these change).",
    advice: "Take the contacts from a model with SmoothSphereHalfSpaceForce, or check the smoothing with `inspect`",
    repair: Repair::NotPossible("only you know which smoothing is meant"),
    example: Example::Request {
        good: r#"{"verb": "transfer", "models": ["table1/human_62kg_smooth_sphere.osim"], "from": "table1/human_500kg_smooth_sphere.osim"}"#,
        bad: r#"{"verb": "transfer", "models": ["table1/human_62kg_smooth_sphere.osim"], "from": "table1/human_500kg_hunt_crossley.osim"}"#,
    },
};

pub(crate) fn of_reference(name: &str) -> Finding {
    Finding::new(&RULE, format!("{name} has no smoothing parameters: the model's own stay"))
}
