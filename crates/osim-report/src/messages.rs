//! Lines that say what should be known.

use osim_inspect::MassMismatch;
use osim_messages::{Dialect, one_line};
use osim_model::{Finding, FindingCode};

/// Warnings, one line each: `warning: line 12: message [code]`.
#[must_use]
pub fn warnings(warnings: &[Finding]) -> String {
    let mut text = String::new();
    for warning in warnings {
        let line = warning.line.map(|line| format!("line {line}: ")).unwrap_or_default();
        text.push_str(&format!("warning: {line}{} [{}]\n", warning.message, warning.code()));
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
