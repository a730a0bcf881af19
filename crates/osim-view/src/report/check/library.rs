//! Findings of many models as one table.

use std::cmp::Reverse;

use osim_inspect::{CheckResult, Counts};
use osim_model::messages::{Phrase, one_line};
use osim_model::{FindingCode, Severity};
use osim_requests::spell::FrontEnd;

use crate::report::layout::{Colour, clipped, severity, table};
use crate::report::messages::in_a_cell;

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
    /// Names are clipped where a line has an end; in a file or a pipe they are whole.
    #[must_use]
    pub fn text(mut self, whole_names: bool, words: &dyn FrontEnd, colour: Colour) -> String {
        let shown = |name: &str, width| if whole_names { name.to_owned() } else { clipped(name, width) };
        let mut models = table(&["model", "errors", "warnings", "remarks"]);
        for (model, counts) in &self.models {
            let count = |count: usize| if count == 0 { "-".to_owned() } else { count.to_string() };
            let cells = match counts {
                Ok(counts) => [count(counts.error), count(counts.warn), count(counts.info)],
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
        let more = Phrase::template(
            "In full, with commands that fix it: `check MODEL`. What one means: `explain topics=FINDING`",
        );
        text.push_str(&format!("\n{}\n", codes.trim_fmt()));
        text = painted_rows(&text, colour);
        text.push_str(&self.to_put_right(words.prompt()));
        text.push_str(&format!("\n{}\n", more.spelled(words)));
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
        let found = [Severity::Error, Severity::Warn].into_iter().find(|severity| severity.as_str() == word);
        match found {
            Some(found) => out.push_str(&line.replacen(word, &severity(found, colour), 1)),
            None => out.push_str(line),
        }
    }
    out
}
