//! The note in the file cannot be relied on.

use osim_model::{Example, Fault, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::StaleNote,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Mass),
    what: "The note that this program left in the file no longer fits its contacts.",
    why: "The note says which mass the contacts were made for. Contacts were changed after it was written, or only some of them were scaled, or the note is damaged.",
    advice: "Give the mass that the contacts are made for with `contacts_mass=KG`",
    repair: Repair::NotPossible("only you know what the contacts were made for"),
    example: Example::Models { good: "check/earlier_note.osim", bad: "check/stale_note.osim" },
};

/// Why a mass is not known, where it is the note's.
pub(crate) fn of_fault(fault: &Fault) -> Option<Finding> {
    (fault.code() == "stale-note").then(|| Finding::new(&RULE, fault.phrase()))
}
