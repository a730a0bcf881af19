//! Findings as CSV: one row each.

use anyhow::{Context, Result};
use csv::WriterBuilder;

use super::finding::Report;

const COLUMNS: [&str; 8] = ["model", "severity", "code", "place", "line", "spheres", "message", "command"];

/// The rows of one model, behind a header where `header`.
///
/// # Errors
/// None in practice: the rows are written into memory.
pub(super) fn rows(report: &Report, header: bool) -> Result<String> {
    let mut writer = WriterBuilder::new().from_writer(Vec::new());
    if header {
        writer.write_record(COLUMNS)?;
    }
    for finding in &report.findings {
        let line = finding.line.map(|line| line.to_string()).unwrap_or_default();
        writer.write_record([
            &report.model,
            finding.severity.as_str(),
            finding.code.as_str(),
            finding.place.as_deref().unwrap_or_default(),
            &line,
            &finding.spheres.join(" "),
            &finding.message,
            finding.command.as_deref().unwrap_or_default(),
        ])?;
    }
    let bytes = writer.into_inner().context("cannot make CSV")?;
    String::from_utf8(bytes).context("cannot make CSV")
}
