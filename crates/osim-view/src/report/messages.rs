//! Lines of messages about findings, masses and contacts.

use osim_inspect::MassMismatch;
use osim_model::messages::{Dialect, one_line};
use osim_model::{Finding, FindingCode, Severity};

/// The findings, one on each line: `warning: line 12, column 5: message [code]`. Findings that the model had before the change share one line with
/// their codes.
pub(crate) fn finding_lines(findings: &[Finding]) -> String {
    let mut text = String::new();
    let (before, new): (Vec<&Finding>, Vec<&Finding>) = findings.iter().partition(|one| one.had_before);
    for finding in new {
        let place = finding.position.map(|at| format!("{at}: ")).unwrap_or_default();
        let severity = finding.severity.as_str();
        text.push_str(&format!("{severity}: {place}{} [{}]\n", finding.message, finding.code()));
    }
    let severities = [Severity::Error, Severity::Warning, Severity::Remark];
    let of_severity = severities.into_iter().filter_map(|severity| {
        let mut codes: Vec<&str> =
            before.iter().filter(|one| one.severity == severity).map(|one| one.code().as_str()).collect();
        codes.dedup();
        (!codes.is_empty()).then(|| format!("{} {}", severity.as_str(), codes.join(", ")))
    });
    let as_before = of_severity.collect::<Vec<_>>().join("; ");
    if !as_before.is_empty() {
        text.push_str(&format!("as before: {as_before}\n"));
    }
    text
}

/// A line about a model, called `name`, whose contacts are made for another mass than the mass of its bodies.
pub fn mass_mismatch(name: &str, mismatch: &MassMismatch, dialect: &dyn Dialect) -> String {
    let message = mismatch.message().spelled(dialect);
    let line = format!("warning: {name}: {message} [{}]", FindingCode::MassSourcesDisagree);
    format!("{}\n", one_line(line))
}

/// The text in the row of a model that has no contacts, so that there is nothing to show.
pub(crate) const NO_CONTACTS_CELL: &str = "no contacts";

/// The text in the row of a model with a failure, by the code of the failure.
pub(crate) fn failure_in_cell(code: &str) -> &'static str {
    match code {
        "no-contacts" => NO_CONTACTS_CELL,
        "no-models" => "no models",
        _ => "not read",
    }
}
