//! The findings of `check` as text: rows for one model, and a table by code for many models.

mod library_table;

use std::cmp::Reverse;
use std::collections::BTreeMap;

use osim_inspect::{CheckResult, Counts, FindingWithRemedy, Sign};
use osim_model::messages::{Input, Verb, counted, one_line};
use osim_model::{FindingCode, Severity};
use osim_requests::spell::FrontEnd;

use crate::report::extent::Layout;
use crate::report::layout::{csv_text, sign, wrapped_with_path};
use crate::report::similarity;

use library_table::part_of_all;
pub use library_table::{LibraryTable, RESULTS_FOLDER};

/// Columns of a terminal before the words of a row.
const ROW_INDENT: usize = 18;

/// The word in the place of a topic, in rows of findings that belong to no topic.
const ROW_OF_FILE: &str = "file";

/// The largest number of findings of one rule that get a row each. If there are more, the text has their number.
const MOST_NAMES_LISTED: usize = 3;

// Findings of one model, for people.

/// The result of a check as text: the worst finding and the commands that correct it; a row for each topic without a good verdict, and
/// one row for the others; in full all findings with reasons and advice. The texts of `found` are already in the words of the front end.
pub fn text(found: &CheckResult, words: &dyn FrontEnd, layout: Layout) -> String {
    let rows = VerdictRows::of(found);
    let is_full = layout.extent.is_full();
    let mut text = wrapped_with_path(&found.model, &headline(found, &rows), "  ", layout.width());
    // These lines are never broken, so that commands can be copied.
    for command in &found.commands {
        text.push_str(&format!("{}{}\n", words.prompt(), one_line(command.clone())));
    }
    text.push('\n');
    for row in &rows.bad {
        text.push_str(&row.text(layout));
    }
    for (why, names) in &rows.unknown {
        text.push_str(&layout.wrapped(&format!("unknown  {}: {why}", names.join(", ")), "         "));
    }
    if is_full {
        rows.good.iter().for_each(|row| text.push_str(&row.text(layout)));
    } else if let Some(good) = rows.good_in_words() {
        text.push_str(&layout.wrapped(&format!("good     {good}"), "         "));
    }
    let Counts { error, warning, .. } = found.counts;
    let is_open = |finding: &&FindingWithRemedy| {
        finding.severity >= Severity::Warning
            && finding.command.is_none()
            && found.corrected < error + warning
    };
    if is_full {
        text.push_str(&explanations(found, layout));
        text.push_str(&beside_real_feet(&found.beside_real_feet, layout));
    } else if let Some(open) = found.findings.iter().find(is_open) {
        let what = match open.code() {
            // Only a mass is missing.
            FindingCode::MassUnknown | FindingCode::MassSourcesDisagree => open.advice.to_string(),
            code => words.command(&Verb::Explain.call().with_value(Input::Topics, code.as_str())),
        };
        text.push_str(&format!("\n{}", layout.wrapped(&format!("What to do: {what}"), "  ")));
    }
    if let Some(list) = found.similarity.as_ref().filter(|list| is_full || list.is_worth_showing()) {
        text.push('\n');
        text.push_str(&similarity::text(list, layout));
    }
    text
}

/// Sentences about contacts beside measured feet, under a heading; empty if there are none.
pub(super) fn beside_real_feet(sentences: &[String], layout: Layout) -> String {
    let lines: String = sentences.iter().map(|text| layout.wrapped(&format!("  {text}"), "    ")).collect();
    if lines.is_empty() { lines } else { format!("\nBeside measured feet:\n{lines}") }
}

/// A topic whose verdict is not good, or a finding that belongs to no topic.
struct VerdictRow<'c> {
    sign: Sign,
    on: &'c str,
    text: String,
}

impl VerdictRow<'_> {
    /// The row as text: severity, topic, and the worst finding.
    fn text(&self, layout: Layout) -> String {
        let word = self.sign.as_str();
        let text = format!("{word:<8} {:<8} {}", self.on, self.text);
        layout.wrapped(&text, &" ".repeat(ROW_INDENT)).replacen(word, &sign(self.sign, layout.colour), 1)
    }
}

/// The verdicts on all topics, sorted; the worst first.
#[derive(Default)]
struct VerdictRows<'c> {
    bad: Vec<VerdictRow<'c>>,
    /// Questions of the table, such as "does it stand?", whose answer is not known, by the reason.
    unknown: BTreeMap<String, Vec<&'c str>>,
    good: Vec<VerdictRow<'c>>,
    /// Questions all of whose findings the known contacts were published with.
    published: Vec<&'c str>,
}

impl<'c> VerdictRows<'c> {
    /// Sorts the verdicts of a check into good, bad and unknown ones.
    fn of(found: &'c CheckResult) -> Self {
        let mut rows = Self::default();
        for verdict in &found.verdicts {
            let on = verdict.on.as_str();
            let about = || found.findings.iter().filter(|finding| finding.rule.verdict == Some(verdict.on));
            let text = verdict.text.to_string();
            if about().next().is_some() && about().all(|finding| finding.is_as_published()) {
                rows.published.push(on);
                let text = format!("as published: {text}");
                rows.good.push(VerdictRow { sign: Sign::Good, on, text });
            } else if verdict.sign == Sign::Good {
                rows.good.push(VerdictRow { sign: Sign::Good, on, text });
            } else if verdict.sign == Sign::Unknown {
                rows.unknown.entry(text).or_default().push(on);
            } else {
                let mut findings: Vec<_> = about().filter(|finding| !finding.is_as_published()).collect();
                findings.sort_by_key(|own| verdict.codes.iter().position(|code| *code == own.code()));
                // The answer has the text of the worst finding, which may be as published.
                let other = findings.first().filter(|own| verdict.codes.first() != Some(&own.code()));
                let (sign, text, place) = match other {
                    Some(own) => (own.severity.into(), own.message.to_string(), own.place.as_deref()),
                    None => (verdict.sign, text, verdict.place.as_deref()),
                };
                rows.bad.push(VerdictRow { sign, on, text: row_text(text, place, &findings) });
            }
        }
        let files = found.findings.iter().filter(|finding| finding.rule.verdict.is_none());
        let files: Vec<_> = files.filter(|finding| !finding.is_as_published()).collect();
        for alike in files.chunk_by(|a, b| a.code() == b.code()) {
            // A few are told one by one: they may have nothing in common but the rule.
            let in_one_row = if alike.len() > MOST_NAMES_LISTED { alike.len() } else { 1 };
            for findings in alike.chunks(in_one_row) {
                let Some(first) = findings.first() else { continue };
                let text = row_text(first.message.to_string(), first.place.as_deref(), findings);
                rows.bad.push(VerdictRow { sign: first.severity.into(), on: ROW_OF_FILE, text });
            }
        }
        rows.bad.sort_by_key(|row| Reverse(row.sign));
        rows
    }

    /// One row of the table with all topics whose verdict is good; `None` if there are none.
    fn good_in_words(&self) -> Option<String> {
        let good = self.good.iter().map(|row| row.on).filter(|on| !self.published.contains(on));
        let good: Vec<&str> = good.collect();
        let published = self.published.join(", ");
        let published = (!published.is_empty()).then(|| format!("{published} as published"));
        let parts = [Some(good.join(", ")).filter(|text| !text.is_empty()), published];
        let parts: Vec<String> = parts.into_iter().flatten().collect();
        (!parts.is_empty()).then(|| parts.join("; "))
    }
}

/// The worst finding of a row, with its place, the number of findings, and all codes.
fn row_text(mut text: String, place: Option<&str>, findings: &[&FindingWithRemedy]) -> String {
    let name = place.and_then(|place| place.rsplit('/').next()).filter(|name| !text.contains(*name));
    // A message about spheres names the worst one, or says that it is about all.
    if let Some(name) = name.filter(|_| findings.first().is_none_or(|first| first.spheres.is_empty())) {
        text.push_str(&format!(" ({name})"));
    }
    let Some(first) = findings.first() else { return text };
    let others = findings.iter().filter(|finding| finding.code() == first.code()).count() - 1;
    match others {
        0 => {}
        // The message of the first counts the cases of its own cause.
        _ if text.contains(" more)") => text.push_str(&format!("; {}", counted(others, "other cause"))),
        _ => text.push_str(&format!(" (and {others} more)")),
    }
    let mut codes: Vec<&str> = findings.iter().map(|finding| finding.code().as_str()).collect();
    codes.dedup();
    let (code, others) = codes.split_first().unwrap_or((&"", &[]));
    let others = if others.is_empty() { String::new() } else { format!("; also {}", others.join(", ")) };
    format!("{text} [{code}{others}]")
}

/// The first line of the text: the counts of findings and the effect of the commands, or that nothing is wrong.
fn headline(found: &CheckResult, rows: &VerdictRows<'_>) -> String {
    let known = found.findings.iter().find(|finding| finding.code() == FindingCode::KnownContacts);
    let known = known.map(|known| format!("; {}", known.message)).unwrap_or_default();
    let Counts { error, warning, .. } = found.counts;
    if error + warning > 0 {
        let counts = Counts { remark: 0, ..found.counts }.describe("");
        let right = part_of_all(found.corrected, error + warning);
        return match found.commands.len() {
            0 => counts,
            1 => format!("{counts}; this command puts {right} right:"),
            _ => format!("{counts}; these commands, one after the other, put {right} right:"),
        };
    }
    let worst = |sign| rows.bad.iter().filter(|row| row.sign == sign).count();
    match (worst(Sign::Warning), worst(Sign::Remark)) {
        (0, 0) if rows.unknown.is_empty() => format!("nothing is wrong{known}"),
        (0, 0) => {
            let names: Vec<&str> = rows.unknown.values().flatten().copied().collect();
            format!("nothing was found, but not all is known: {}{known}", names.join(", "))
        }
        (0, remarks) => format!("{}{known}", counted(remarks, "remark")),
        (warnings, _) => format!("{}{known}", counted(warnings, "warning")),
    }
}

/// Each finding with its place, reason and advice. A finding that occurs in several places is explained once.
fn explanations(found: &CheckResult, layout: Layout) -> String {
    use FindingCode::{SpheresLeftBehind, SpheresMisplaced, SpheresNotCompared};
    let mut text = String::new();
    for alike in found.findings.chunk_by(|a, b| a.code() == b.code()) {
        let Some(first) = alike.first() else { continue };
        text.push_str(&format!("\n{} {}\n", sign(first.severity, layout.colour), first.code()));
        for finding in alike {
            let position = finding.position.map(|at| format!("{at}: ")).unwrap_or_default();
            let message = finding.message.to_string();
            let place = finding.place.as_deref().filter(|place| !message.contains(*place));
            let place = place.map(|place| format!("{place}: ")).unwrap_or_default();
            text.push_str(&layout.wrapped(&format!("  {position}{place}{message}"), "    "));
            for detail in &finding.details {
                text.push_str(&layout.wrapped(&format!("    {detail}"), "      "));
            }
            if finding.spheres.len() > 1 && finding.details.is_empty() {
                let spheres = format!("    spheres: {}", finding.spheres.join(", "));
                text.push_str(&layout.wrapped(&spheres, "      "));
            }
        }
        text.push_str(&layout.wrapped(&format!("  Why: {}", first.why), "       "));
        // The command above does it, and nobody is asked for the original that was given.
        let asks_for_original = found.similarity.is_some()
            && [SpheresLeftBehind, SpheresMisplaced, SpheresNotCompared].contains(&first.code());
        if first.command.is_none() && !asks_for_original {
            text.push_str(&layout.wrapped(&format!("  Do:  {}.", first.advice), "       "));
        }
    }
    text
}

// Findings as CSV: one row each.

/// The columns of findings as CSV.
const COLUMNS: [&str; 9] =
    ["model", "severity", "code", "place", "line", "column", "spheres", "message", "command"];

/// The rows of one model as CSV; with a header before them if `header` is true. The texts of `found` are already in the words of the front
/// end.
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
            finding.position.map(|at| at.line.to_string()).unwrap_or_default(),
            finding.position.map(|at| at.column.to_string()).unwrap_or_default(),
            finding.spheres.join(" "),
            finding.message.to_string(),
            finding.command.clone().unwrap_or_default(),
        ]
    });
    csv_text(header.into_iter().chain(rows))
}
