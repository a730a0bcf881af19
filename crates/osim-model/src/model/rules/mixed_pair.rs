//! A note of another output file was found that does not belong to this one.

use crate::model::fault::NoteDoubt;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::MixedPair,
    severity: Severity::Error,
    seen: Seen::Model,
    verdict: None,
    what: "A note of another output file was found that does not belong to this one.",
    why: "The force set and the geometry set carry notes of different runs: their stiffnesses and radii do not belong together.",
    advice: "Write both again in one run",
    repair: Repair::NotPossible("only you know which of the two files is the right one"),
    example: Example::InWords {
        good: "force set and geometry set as one run wrote them",
        bad: "the geometry set of another run, with a note of its own",
    },
};

pub(crate) fn found() -> Finding {
    Finding::new(&RULE, NoteDoubt::MixedPair.as_str())
}
