//! A compiled file, F_ and the name of the model, lies beside the output.

use std::path::Path;

use osim_model::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::CompiledModelBeside,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: None,
    what: "A compiled file, F_ and the name of the model, lies beside the output.",
    why: "PredSim and OpenCap compile a model to F_<name> and reuse it without looking at the model's content: the old contacts would stay in use.",
    advice: "Delete the compiled file, or write the model under a new name",
    repair: Repair::NotPossible("files of other programs are left alone"),
    example: Example::InWords {
        good: "`model.osim` is written to a folder of its own",
        bad: "`F_model.dll` lies in the folder that `model.osim` is written to",
    },
};

/// The compiled file `compiled` would be used instead of the output.
#[must_use]
pub fn of_file(compiled: &Path) -> Finding {
    let text =
        format!("{} lies beside the output: PredSim and OpenCap would go on using it", compiled.display());
    Finding::new(&RULE, text)
}
