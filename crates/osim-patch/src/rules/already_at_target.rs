//! The contacts are already made for the target mass, so nothing was written.

use osim_model::messages::{Input, Verb, phrase, readable};
use osim_model::{Example, Finding, FindingCode, Mass, Repair, Rule, Seen, Severity};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::AlreadyAtTarget,
    severity: Severity::Warn,
    seen: Seen::Change,
    verdict: None,
    what: "The contacts are already made for the target mass, so nothing was written.",
    why: "The mass the contacts are made for is taken from the note in the file, else `mass`, else the sum of the bodies. A model that was scaled in OpenSim weighs its new mass already while its contacts are still those of the old one; the file does not show which.",
    advice: "Say what the contacts were made for with `contacts_mass=KG`, or take those of a known model with `transfer from=MODEL`",
    repair: Repair::NotPossible("only you know what the contacts were made for"),
    example: Example::Request {
        good: r#"{"verb": "rescale", "models": ["table1/human_62kg_smooth_sphere.osim"], "target_mass": 90}"#,
        bad: r#"{"verb": "rescale", "models": ["table1/human_62kg_smooth_sphere.osim"], "target_mass": 62}"#,
    },
};

pub(crate) fn of_mass(contacts_mass: &Mass) -> Finding {
    let message = phrase![
        format!("contacts are taken as made for {} kg already (", readable(contacts_mass.kg)),
        &contacts_mass.source.describe(),
        "); if they were made for another mass, say ",
        Input::ContactsMass.like("KG"),
        " or ",
        Verb::Transfer.call().with(Input::From, "MODEL"),
    ];
    Finding::new(&RULE, message)
}
