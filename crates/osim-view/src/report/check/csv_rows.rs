//! Findings as CSV: one row each.

use osim_inspect::CheckResult;

use crate::report::layout::csv_text;

const COLUMNS: [&str; 8] = ["model", "severity", "code", "place", "line", "spheres", "message", "command"];

/// The rows of one model, after a header where `header`. What was found is taken as it is spelled.
///
/// # Errors
/// None in practice: the rows are written into memory.
pub fn csv_rows(found: &CheckResult, header: bool) -> Result<String, csv::Error> {
    let header = header.then(|| COLUMNS.map(str::to_owned).to_vec());
    let rows = found.findings.iter().map(|finding| {
        vec![
            found.model.clone(),
            finding.severity.as_str().to_owned(),
            finding.code().as_str().to_owned(),
            finding.place.clone().unwrap_or_default(),
            finding.line.map(|line| line.to_string()).unwrap_or_default(),
            finding.spheres.join(" "),
            finding.message.to_string(),
            finding.command.clone().unwrap_or_default(),
        ]
    });
    csv_text(header.into_iter().chain(rows))
}
