//! Something that was asked for changes nothing.

use osim_model::messages::readable;
use osim_model::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};

use crate::story::limbs;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::NothingToChange,
    severity: Severity::Info,
    seen: Seen::Change,
    verdict: None,
    what: "Something that was asked for changes nothing.",
    why: "A factor of exactly 1 leaves every byte as it is. With a radius that stays, dissipation and smoothing stay too (14, C.2, C.5, C.10).",
    advice: "Nothing, if that is meant; else say what should change",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Request {
        good: r#"{"verb": "set", "models": ["table1/human_62kg_smooth_sphere.osim"], "set": {"stiffness": 2000000}}"#,
        bad: r#"{"verb": "set", "models": ["table1/human_62kg_smooth_sphere.osim"], "set": {"stiffness": 1000000}}"#,
    },
};

pub(crate) fn by_design() -> Finding {
    Finding::new(&RULE, "nothing that is wanted applies to these forces, or every value is already as wanted")
}

pub(crate) fn by_note(contacts_mass_kg: f64) -> Finding {
    Finding::new(&RULE, format!("the note in the file says {} kg already", readable(contacts_mass_kg)))
}

pub(crate) fn by_stance_limbs(stance_limbs: f64) -> Finding {
    Finding::new(&RULE, format!("the note in the file says {} already", limbs(stance_limbs)))
}

pub(crate) fn by_rescale() -> Finding {
    let text = "every factor is exactly 1: the radius stays, so what follows the radius stays too";
    Finding::new(&RULE, text)
}

pub(crate) fn by_set() -> Finding {
    Finding::new(&RULE, "every value is already as wanted")
}

pub(crate) fn by_transfer() -> Finding {
    Finding::new(&RULE, "every value is already as the reference wants it")
}
