//! Lines that say what should be known.

use osim_inspect::MassMismatch;
use osim_model::messages::{Dialect, one_line};
use osim_model::{Finding, FindingCode};

/// Findings, one line each: `warning: line 12: message [code]`.
pub(crate) fn finding_lines(findings: &[Finding]) -> String {
    let mut text = String::new();
    for finding in findings {
        let line = finding.line.map(|line| format!("line {line}: ")).unwrap_or_default();
        let severity = finding.severity.as_str();
        text.push_str(&format!("{severity}: {line}{} [{}]\n", finding.message, finding.code()));
    }
    text
}

/// A line about a model, called `name`, whose contacts carry a body of another mass.
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
