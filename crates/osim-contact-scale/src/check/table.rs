//! Findings for people: one model in full, a library as one table.

use osim_patch::{Severity, WarningCode};

use super::finding::{Counts, Finding, Report};
use crate::report::paint::severity;
use crate::report::{clipped, right, table, wrapped};

/// One model: every finding, worst first, with what to do.
pub(super) fn text(report: &Report) -> String {
    let mut text = wrapped(&format!("{}: {}", report.model, report.counts.told("nothing to say")), "  ");
    let mut rest = report.findings.as_slice();
    while let Some(first) = rest.first() {
        // The same trap in several places is explained once.
        let same = rest.iter().take_while(|finding| finding.code == first.code).count();
        let (alike, others) = rest.split_at(same);
        text.push('\n');
        text.push_str(&block(first, alike));
        rest = others;
    }
    text
}

fn block(first: &Finding, alike: &[Finding]) -> String {
    let mut text = format!("{} {}\n", severity(first.severity), first.code);
    for finding in alike {
        let line = finding.line.map(|line| format!("line {line}: ")).unwrap_or_default();
        let place = finding.place.as_deref().filter(|place| !finding.message.contains(*place));
        let place = place.map(|place| format!("{place}: ")).unwrap_or_default();
        text.push_str(&wrapped(&format!("  {line}{place}{}", finding.message), "    "));
    }
    text.push_str(&wrapped(&format!("  Why: {}", first.why), "       "));
    text.push_str(&wrapped(&format!("  Do:  {}.", first.remedy), "       "));
    // Never broken into lines: it is there to be copied.
    for command in alike.iter().filter_map(|finding| finding.command.as_ref()) {
        text.push_str(&format!("  $ {command}\n"));
    }
    text
}

/// All reports of a folder.
#[derive(Default)]
pub(super) struct Library {
    /// Counts; `None` for a model that could not be read.
    models: Vec<(String, Option<Counts>)>,
    /// Per code: how many models, and the first of them with what was found there.
    codes: Vec<(WarningCode, usize, String, Finding)>,
}

impl Library {
    pub(super) fn add(&mut self, report: Report) {
        let mut seen: Option<WarningCode> = None;
        for finding in report.findings {
            // Findings come sorted, so that one code stands together.
            if seen == Some(finding.code) {
                continue;
            }
            seen = Some(finding.code);
            match self.codes.iter_mut().find(|(code, ..)| *code == finding.code) {
                Some((_, models, ..)) => *models += 1,
                None => self.codes.push((finding.code, 1, report.model.clone(), finding)),
            }
        }
        self.models.push((report.model, Some(report.counts)));
    }

    pub(super) fn add_failed(&mut self, model: &str) {
        self.models.push((model.to_owned(), None));
    }

    /// One row per model, then one per code.
    ///
    /// Names are clipped where a line has an end; in a file or a pipe they are whole.
    pub(super) fn text(mut self, whole_names: bool) -> String {
        let shown = |name: &str, width| if whole_names { name.to_owned() } else { clipped(name, width) };
        let mut models = table(&["model", "errors", "warnings", "remarks"]);
        for (model, counts) in &self.models {
            let count = |count: usize| if count == 0 { "-".to_owned() } else { count.to_string() };
            let cells = match counts {
                Some(counts) => [count(counts.error), count(counts.warn), count(counts.info)],
                None => ["not read", "", ""].map(str::to_owned),
            };
            models.add_row([vec![shown(model, 48)], cells.to_vec()].concat());
        }
        right(&mut models, &[1, 2, 3]);
        let mut text = format!("{}\n", models.trim_fmt());
        if self.codes.is_empty() {
            return text;
        }
        self.codes.sort_by_key(|(code, ..)| (std::cmp::Reverse(code.severity()), *code));
        let mut codes = table(&["", "finding", "models", "for example"]);
        for (code, count, model, _) in &self.codes {
            let severity = code.severity().as_str().to_owned();
            codes.add_row(vec![severity, code.to_string(), count.to_string(), shown(model, 36)]);
        }
        right(&mut codes, &[2]);
        text.push_str(&format!("\n{}\n", codes.trim_fmt()));
        text.push_str("\nIn full, with commands that mend: check MODEL. What one means: explain FINDING\n");
        painted_rows(&text)
    }
}

/// Rows that begin with a severity, in its colour.
fn painted_rows(text: &str) -> String {
    let mut out = String::new();
    for line in text.split_inclusive('\n') {
        let word = line.split_whitespace().next().unwrap_or_default();
        let found = [Severity::Error, Severity::Warn].into_iter().find(|severity| severity.as_str() == word);
        match found {
            Some(found) => out.push_str(&line.replacen(word, &severity(found), 1)),
            None => out.push_str(line),
        }
    }
    out
}
