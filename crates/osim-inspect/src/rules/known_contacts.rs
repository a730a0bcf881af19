//! The contacts are known: somebody published them.

use osim_model::messages::readable;
use osim_model::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};

use crate::known::KnownContacts;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::KnownContacts,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: None,
    what: "The contacts are published ones, and are used as they were published.",
    why: "What is unusual about the published contacts is a remark here. A warning says what is wrong for this model.",
    advice: "Nothing, if you chose these contacts",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Models { good: "check/within_limits.osim", bad: "check/known_contacts.osim" },
};

pub(crate) fn of_contacts(known: KnownContacts) -> Finding {
    let text = format!(
        "the contact parameters are those of {} for a body of {} kg",
        known.title,
        readable(known.made_for_kg)
    );
    Finding::new(&RULE, text)
}
