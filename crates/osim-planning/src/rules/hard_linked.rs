//! A model that is changed itself has other names too.

use std::path::Path;

use osim_model::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::HardLinked,
    severity: Severity::Warn,
    seen: Seen::Change,
    verdict: None,
    what: "A model that is changed itself has other names too.",
    why: "A changed model is a new file that takes the name of the old one, so that no moment is without a whole file. Hard links to the old one are names of the old file: they keep the old model.",
    advice: "Make the other names again, or change the model under one of its names into a file of its own",
    repair: Repair::NotPossible("only you know what the other names are for"),
    example: Example::InWords {
        good: "`model.osim` is the only name of its file",
        bad: "`model.osim` and `copy.osim` are two names of one file, and one of them is changed in place",
    },
};

/// The file `path` has `others` more names.
#[must_use]
pub fn of_file(path: &Path, others: u64) -> Finding {
    let names = if others == 1 { "one more name".to_owned() } else { format!("{others} more names") };
    let text = format!("{} has {names} (hard links), under which the old model stays", path.display());
    Finding::new(&RULE, text)
}
