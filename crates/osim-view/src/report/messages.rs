//! Lines that say what should be known.

use osim_inspect::MassMismatch;
use osim_model::messages::{Dialect, one_line};
use osim_model::{Finding, FindingCode, Severity};

/// Warnings, one line each: `warning: line 12: message [code]`. What is a remark in `check` is a note.
#[must_use]
pub fn warnings(warnings: &[Finding]) -> String {
    let mut text = String::new();
    for warning in warnings {
        let line = warning.line.map(|line| format!("line {line}: ")).unwrap_or_default();
        let word = if warning.severity == Severity::Info { "note" } else { "warning" };
        text.push_str(&format!("{word}: {line}{} [{}]\n", warning.message, warning.code()));
    }
    text
}

/// A line about a model, called `name`, whose contacts carry a body of another mass.
#[must_use]
pub fn mass_mismatch(name: &str, mismatch: &MassMismatch, dialect: &dyn Dialect) -> String {
    let message = mismatch.message().spelled(dialect);
    let line = format!("warning: {name}: {message} [{}]", FindingCode::MassSourcesDisagree);
    format!("{}\n", one_line(line))
}

/// In the row of a model that has nothing to show, because it has no contacts.
pub(crate) const NO_CONTACTS: &str = "no contacts";

/// Why the row of a model has nothing to show, by the code of its failure.
pub(crate) fn in_a_cell(code: &str) -> &'static str {
    match code {
        "no-contacts" => NO_CONTACTS,
        "no-models" => "no models",
        _ => "not read",
    }
}
