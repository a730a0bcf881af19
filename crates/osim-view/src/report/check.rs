//! What was found, as text.

use std::cmp::Reverse;
use std::collections::BTreeSet;

use osim_inspect::{CheckResult, Counts, FindingWithRemedy, Verdict};
use osim_model::messages::{Phrase, one_line};
use osim_model::{FindingCode, Severity};
use osim_requests::spell::FrontEnd;

use crate::report::extent::Extent;
use crate::report::layout::{Colour, clipped, csv_text, severity, sign, table, wrapped, wrapped_with_path};
use crate::report::messages::in_a_cell;
use crate::report::similarity;

/// Columns before the words of a verdict.
const INDENT: usize = 20;

/// A line for each verdict: its sign, what it is on, and the answer.
fn lines(verdicts: &[Verdict], colour: Colour) -> String {
    verdicts.iter().map(|verdict| line(verdict, colour)).collect()
}

fn line(verdict: &Verdict, colour: Colour) -> String {
    let word = verdict.sign.as_str();
    let head = format!("  {word:<8} {:<9}", verdict.on.as_str());
    let text = verdict.text.to_string();
    let place = verdict.place.as_deref().filter(|place| !text.contains(*place));
    let place = place.map(|place| format!(" ({place})")).unwrap_or_default();
    let line = wrapped(&format!("{head}{text}{place}"), &" ".repeat(INDENT));
    line.replacen(word, &sign(verdict.sign, colour), 1)
}

// Findings of one model, for people.

/// The verdicts, then every finding, worst first, with what to do. What was found is taken as it is spelled; `prompt` is before each remedy.
///
/// What was published so with known contacts is named once, and explained only in full, except that they may be for another mass.
pub fn text(found: &CheckResult, prompt: &str, colour: Colour, extent: Extent) -> String {
    let known = found.findings.iter().find(|finding| finding.code() == FindingCode::KnownContacts);
    let clean = known.filter(|_| found.counts.error + found.counts.warning == 0);
    let shown: Vec<&FindingWithRemedy> = found
        .findings
        .iter()
        .filter(|finding| {
            extent.is_full()
                || (!finding.is_published || is_of_another_mass(finding))
                    && clean.is_none_or(|known| known.code() != finding.code())
        })
        .collect();
    let published = published(found);
    let head = match clean {
        Some(known) if found.findings.iter().any(is_of_another_mass) => {
            let mass = "this body weighs something else: the contacts may be for another mass";
            format!("nothing is wrong for certain; {}, and {mass}{published}", known.message)
        }
        Some(known) => format!("nothing is wrong; {}{published}", known.message),
        None => found.counts.describe("nothing to say"),
    };
    let mut text = wrapped_with_path(&found.model, &head, "  ");
    text.push_str(&lines(&found.verdicts, colour));
    // What puts several findings right is not repeated with each.
    let mended: BTreeSet<FindingCode> =
        found.findings.iter().filter(|one| one.command.is_some()).map(|one| one.code()).collect();
    let at_end = found.commands.len() > 1 || mended.len() > 1;
    let mut rest = shown.as_slice();
    while let Some(first) = rest.first() {
        // The same trap in several places is explained once.
        let same = rest.iter().take_while(|finding| finding.code() == first.code()).count();
        let (alike, others) = rest.split_at(same);
        text.push('\n');
        let more = if first.code() == FindingCode::KnownContacts { published.as_str() } else { "" };
        text.push_str(&block(first, alike, more, colour, extent));
        if !at_end {
            text.push_str(&commands(alike.iter().filter_map(|finding| finding.command.as_ref()), prompt));
        }
        rest = others;
    }
    if at_end {
        let order = if found.commands.len() > 1 { ", one after the other" } else { "" };
        text.push_str(&format!("\nTo put it right{order}:\n"));
        text.push_str(&commands(&found.commands, prompt));
    }
    if let Some(list) = found.similarity.as_ref().filter(|list| extent.is_full() || list.is_worth_showing()) {
        text.push('\n');
        text.push_str(&similarity::text(list, extent));
    }
    text
}

/// Commands, each once and in a line of its own, never broken: they are there to be copied.
fn commands<'f>(commands: impl IntoIterator<Item = &'f String>, prompt: &str) -> String {
    let mut commands: Vec<&String> = commands.into_iter().collect();
    commands.dedup();
    commands.into_iter().map(|command| format!("  {prompt}{}\n", one_line(command.clone()))).collect()
}

/// Whether it is a doubt about the mass: that others published contacts so does not make them right for this body.
fn is_of_another_mass(finding: &FindingWithRemedy) -> bool {
    finding.code() == FindingCode::ContactsOfAnotherMass
}

/// The codes that are the published state of known contacts.
fn published(found: &CheckResult) -> String {
    let mut codes: Vec<&str> = found
        .findings
        .iter()
        .filter(|finding| finding.is_published && !is_of_another_mass(finding))
        .map(|finding| finding.code().as_str())
        .collect();
    codes.dedup();
    if codes.is_empty() {
        String::new()
    } else {
        format!(" (the published model has these findings, too: {})", codes.join(", "))
    }
}

fn block(
    first: &FindingWithRemedy,
    alike: &[&FindingWithRemedy],
    more: &str,
    colour: Colour,
    extent: Extent,
) -> String {
    let mut text = format!("{} {}\n", severity(first.severity, colour), first.code());
    for finding in alike {
        let line = finding.line.map(|line| format!("line {line}: ")).unwrap_or_default();
        let message = finding.message.to_string();
        let place = finding.place.as_deref().filter(|place| !message.contains(*place));
        let place = place.map(|place| format!("{place}: ")).unwrap_or_default();
        text.push_str(&wrapped(&format!("  {line}{place}{message}{more}"), "    "));
        if extent.is_full() && finding.spheres.len() > 1 {
            text.push_str(&wrapped(&format!("    spheres: {}", finding.spheres.join(", ")), "      "));
        }
    }
    text.push_str(&wrapped(&format!("  Why: {}", first.why), "       "));
    text.push_str(&wrapped(&format!("  Do:  {}.", first.advice), "       "));
    text
}

// Findings of many models as one table.

/// What was found in all models of a folder.
#[derive(Debug, Default)]
pub struct LibraryTable {
    /// Counts, or why there are none.
    models: Vec<(String, Result<Counts, &'static str>)>,
    /// For each code and severity, how many models, and the first of them.
    codes: Vec<(Severity, FindingCode, usize, String)>,
    /// What puts them right, model by model.
    commands: Vec<String>,
}

/// Commands that are listed; more are counted.
const LISTED: usize = 30;

impl LibraryTable {
    /// Adds what was found in the next model.
    pub fn add(&mut self, found: &CheckResult) {
        let mut seen: Option<(Severity, FindingCode)> = None;
        for finding in &found.findings {
            // Findings are sorted, so that those of one code are together.
            let kind = (finding.severity, finding.code());
            if seen.replace(kind) == Some(kind) {
                continue;
            }
            match self.codes.iter_mut().find(|(severity, code, ..)| (*severity, *code) == kind) {
                Some((_, _, models, _)) => *models += 1,
                None => self.codes.push((kind.0, kind.1, 1, found.model.clone())),
            }
        }
        self.models.push((found.model.clone(), Ok(found.counts)));
        self.commands.extend(found.commands.iter().cloned());
    }

    /// Adds a model that could not be checked, because of a failure with this code.
    pub fn add_failed(&mut self, model: &str, code: &str) {
        self.models.push((model.to_owned(), Err(in_a_cell(code))));
    }

    /// One row for each model, then one for each code, then the commands that put them right.
    ///
    /// Names are clipped where a line has an end; in a file or a pipe they are whole. `names_full`: the front end can ask for all models
    /// in full.
    pub fn text(
        mut self,
        whole_names: bool,
        words: &dyn FrontEnd,
        colour: Colour,
        names_full: bool,
    ) -> String {
        let shown = |name: &str, width| if whole_names { name.to_owned() } else { clipped(name, width) };
        let mut models = table(&["model", "errors", "warnings", "remarks"]);
        for (model, counts) in &self.models {
            let count = |count: usize| if count == 0 { "-".to_owned() } else { count.to_string() };
            let cells = match counts {
                Ok(counts) => [count(counts.error), count(counts.warning), count(counts.remark)],
                Err(why) => [*why, "", ""].map(str::to_owned),
            };
            models.add_row([vec![shown(model, 48)], cells.to_vec()].concat());
        }
        models.right_aligned(&[1, 2, 3]);
        let mut text = format!("{}\n", models.trim_fmt());
        if self.codes.is_empty() {
            return text;
        }
        self.codes.sort_by_key(|(severity, code, ..)| (Reverse(*severity), *code));
        let mut codes = table(&["", "finding", "models", "for example"]);
        for (severity, code, count, model) in &self.codes {
            let severity = severity.as_str().to_owned();
            codes.add_row(vec![severity, code.to_string(), count.to_string(), shown(model, 36)]);
        }
        codes.right_aligned(&[2]);
        let more = Phrase::template(if names_full {
            "In full, with commands that fix it: `check MODEL`; all of them: `full`. What one means: `explain topics=FINDING`"
        } else {
            "In full, with commands that fix it: `check MODEL`. What one means: `explain topics=FINDING`"
        });
        text.push_str(&format!("\n{}\n", codes.trim_fmt()));
        text = painted_rows(&text, colour);
        text.push_str(&self.to_put_right(words.prompt()));
        text.push_str(&format!("\n{}", wrapped(&more.spelled(words), "")));
        text
    }

    /// The commands, each in a line of its own; where there are too many, how many.
    fn to_put_right(&self, prompt: &str) -> String {
        let count = self.commands.len();
        if count == 0 {
            return String::new();
        }
        if count > LISTED {
            return format!("\n{count} commands put it right: each model by itself says them.\n");
        }
        let lines = self.commands.iter().map(|command| format!("  {prompt}{}\n", one_line(command.clone())));
        format!("\nTo put it right, for each model in this order:\n{}", lines.collect::<String>())
    }
}

/// Rows that begin with a severity, in its colour.
fn painted_rows(text: &str, colour: Colour) -> String {
    let mut out = String::new();
    for line in text.split_inclusive('\n') {
        let word = line.split_ascii_whitespace().next().unwrap_or_default();
        let found =
            [Severity::Error, Severity::Warning].into_iter().find(|severity| severity.as_str() == word);
        match found {
            Some(found) => out.push_str(&line.replacen(word, &severity(found, colour), 1)),
            None => out.push_str(line),
        }
    }
    out
}

// Findings as CSV: one row each.

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
