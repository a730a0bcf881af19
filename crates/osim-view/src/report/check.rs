//! The findings of `check` as text: rows for one model, and a table by code for many models.

use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::path::Path;

use osim_inspect::{CheckResult, Counts, FindingWithRemedy, Sign};
use osim_model::messages::{Input, Verb, counted, listed, one_line, shown_whole};
use osim_model::{FindingCode, Severity};
use osim_requests::options::OutputOptions;
use osim_requests::spell::FrontEnd;
use osim_requests::{CheckRequest, Request};

use crate::report::extent::Layout;
use crate::report::layout::{csv_text, sign, table, wrapped_with_path};
use crate::report::messages::{NO_CONTACTS_CELL, failure_in_cell};
use crate::report::similarity;

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
            let rows_of_rule =
                if alike.len() > MOST_NAMES_LISTED { vec![alike] } else { alike.chunks(1).collect() };
            for findings in rows_of_rule {
                let Some(first) = findings.first() else { continue };
                let text = row_text(first.message.to_string(), first.place.as_deref(), findings);
                rows.bad.push(VerdictRow { sign: first.severity.into(), on: ROW_OF_FILE, text });
            }
        }
        rows.bad.sort_by_key(|row| match row.sign {
            Sign::Error => 0,
            Sign::Warning => 1,
            _ => 2,
        });
        rows
    }

    /// One row of the table with all topics whose verdict is good; `None` if there are none.
    fn good_in_words(&self) -> Option<String> {
        let good = self.good.iter().map(|row| row.on).filter(|on| !self.published.contains(on));
        let good: Vec<&str> = good.collect();
        let published = match self.published.as_slice() {
            [] => None,
            names => Some(format!("{} as published", names.join(", "))),
        };
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
        _ if text.ends_with(" more)") => text.push_str(&format!("; {}", counted(others, "other cause"))),
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

/// "Some of all" findings or models in words: `a part`, `it`, `both`, `all 3` or `2 of 3`.
fn part_of_all(some: usize, all: usize) -> String {
    match (some, all) {
        (0, _) => "a part".to_owned(),
        (_, 1) => "it".to_owned(),
        (2, 2) => "both".to_owned(),
        (some, all) if some == all => format!("all {all}"),
        (some, all) => format!("{some} of {all}"),
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

// Findings of many models as one table.

/// The results of checking all models of a call, collected for one table.
#[derive(Default)]
pub struct LibraryTable {
    call: CheckRequest,
    counts: Vec<Counts>,
    /// The models with each code, by severity and code.
    codes: BTreeMap<(Reverse<Severity>, FindingCode), FoundInModels>,
    /// For each model that can be corrected, the steps that correct it.
    steps: Vec<Vec<Request>>,
    /// The number of models that have no error or warning after their steps.
    corrected: usize,
    without_contacts: Vec<String>,
    not_read: Vec<String>,
    /// The number of models that the call corrected and wrote.
    pub written: usize,
}

/// The models in which a code was found.
#[derive(Debug, Default)]
struct FoundInModels {
    models: usize,
    /// The worst of these models: the size of the fault, this size in words if there are words for it, and the name of the model.
    worst: (f64, String, String),
}

/// The folder for results in a command that is proposed for many models.
const RESULTS_FOLDER: &str = "RESULTS";

impl LibraryTable {
    /// A table for the models of `call`.
    pub fn new(call: CheckRequest) -> Self {
        Self { call, ..Self::default() }
    }

    /// Adds the findings about the next model to the counts of the table.
    pub fn add(&mut self, found: &CheckResult) {
        let shown: Vec<_> = found.findings.iter().filter(|finding| !finding.is_as_published()).collect();
        // Findings are sorted, so that those of one code are together.
        for alike in shown.chunk_by(|a, b| (a.severity, a.code()) == (b.severity, b.code())) {
            let Some(first) = alike.first() else { continue };
            let kind = self.codes.entry((Reverse(first.severity), first.code())).or_default();
            kind.models += 1;
            let sizes = alike.iter().filter_map(|finding| finding.measure.as_ref());
            let largest = sizes.max_by(|a, b| a.size.total_cmp(&b.size));
            let (size, text) = largest.map_or((0.0, ""), |measure| (measure.size, &measure.text));
            if kind.models == 1 || size > kind.worst.0 {
                kind.worst = (size, text.to_owned(), found.model.clone());
            }
        }
        if found.findings.iter().any(|finding| finding.code() == FindingCode::BareModel) {
            self.add_without_contacts(&found.model);
        }
        self.counts.push(found.counts);
        if !found.steps.is_empty() {
            self.corrected += usize::from(found.corrected == found.counts.error + found.counts.warning);
            self.steps.push(found.steps.clone());
        }
    }

    /// Adds a model in a folder that has no contacts.
    pub fn add_without_contacts(&mut self, model: &str) {
        self.without_contacts.push(model.to_owned());
    }

    /// Adds a model that could not be checked, because of a failure with this code.
    pub fn add_failed(&mut self, model: &str, code: &str) {
        if failure_in_cell(code) == NO_CONTACTS_CELL {
            self.add_without_contacts(model);
        } else {
            self.not_read.push(model.to_owned());
        }
    }

    /// The table as text: the number of models with errors or warnings, and the command that corrects them; a row for each code; the files
    /// that could not be read.
    pub fn text(self, words: &dyn FrontEnd, layout: Layout) -> String {
        let folder = match self.call.models.as_slice() {
            [only] => only.display().to_string(),
            _ => String::new(),
        };
        // A call that corrects has done what can be done.
        let (command, mut head) = (self.command().filter(|_| !self.call.fix), self.headline());
        if command.is_some() {
            let bad = self.counts.iter().filter(|counts| counts.error + counts.warning > 0).count();
            head.push_str(&format!("; this command puts {} right:", part_of_all(self.corrected, bad)));
        }
        let mut text = match folder.as_str() {
            "" => layout.wrapped(&head, "  "),
            folder => wrapped_with_path(folder, &head, "  ", layout.width()),
        };
        text.extend(
            command.map(|command| format!("{}{}\n", words.prompt(), one_line(words.request(&command)))),
        );
        text.push('\n');
        if !self.codes.is_empty() {
            let table = self.table(&folder, layout);
            let rows = table.lines().map(|line| format!("{}\n", line.strip_prefix(' ').unwrap_or(line)));
            text.push_str(&painted_rows(&rows.collect::<String>(), layout));
        }
        if self.call.fix {
            let folder = self.call.output_dir.as_ref().map(|folder| format!(" into {}", folder.display()));
            let (written, all) = (self.written, counted(self.counts.len(), "model"));
            let line = format!("{written} of {all} changed and written{}", folder.unwrap_or_default());
            text.push_str(&layout.wrapped(&line, "  "));
        }
        text.push_str(&layout.wrapped(&self.unchecked_in_words(), "  "));
        let is_open = self.codes.keys().any(|(_, code)| *code == FindingCode::SpheresNotCompared);
        if is_open && self.call.from.is_none() {
            let call = Verb::Check.call_with_model().with_placeholder(Input::From, "GENERIC");
            let name = if folder.is_empty() { "MODEL".to_owned() } else { words.word(&folder) };
            let call = words.command(&call).replacen("MODEL", &name, 1);
            let what = format!("What to do: {call} compares each with the model that was scaled");
            text.push_str(&format!("\n{}", layout.wrapped(&what, "  ")));
        }
        text
    }

    fn headline(&self) -> String {
        let models = self.counts.len();
        let with = |has: fn(&Counts) -> bool, what: &str| {
            let count = self.counts.iter().filter(|counts| has(counts)).count();
            let count_text = if count == models && models > 1 { "all".to_owned() } else { count.to_string() };
            (count > 0).then(|| format!("{count_text} with {what}"))
        };
        let parts = [
            with(|counts| counts.error > 0, "errors"),
            with(|counts| counts.error == 0 && counts.warning > 0, "warnings"),
        ];
        let parts: Vec<String> = parts.into_iter().flatten().collect();
        match (models, parts.as_slice()) {
            (0, _) => "no model was checked".to_owned(),
            (_, []) => format!("{}, none with an error or a warning", counted(models, "model")),
            _ => format!("{}, {}", counted(models, "model"), parts.join(", ")),
        }
    }

    /// One command that corrects all models which can be corrected.
    fn command(&self) -> Option<Request> {
        let first = self.steps.first()?;
        let output = OutputOptions { output_dir: Some(RESULTS_FOLDER.into()), ..OutputOptions::default() };
        let for_all = |steps: &[Request]| match steps {
            [only] => {
                let mut request = only.clone();
                *request.models_mut()? = self.call.models.clone();
                *request.output_mut()? = output.clone();
                Some(request)
            }
            _ => None,
        };
        let request = for_all(first);
        // A model that is right already stays as it is only where each gets its own steps.
        let is_for_all =
            self.steps.len() == self.counts.len() && self.steps.iter().all(|steps| for_all(steps) == request);
        request.filter(|_| is_for_all).or_else(|| {
            let CheckRequest { deny, format, report, .. } = CheckRequest::default();
            let output_dir = Some(RESULTS_FOLDER.into());
            let call = self.call.clone();
            Some(CheckRequest { fix: true, output_dir, full: false, deny, format, report, ..call }.into())
        })
    }

    fn table(&self, folder: &str, layout: Layout) -> String {
        let mut table = table(&["models", "finding", "", "worst"]);
        for ((Reverse(severity), code), found) in &self.codes {
            let (_, size, model) = &found.worst;
            let model = Path::new(model).strip_prefix(folder).unwrap_or(Path::new(model)).display();
            let worst = if size.is_empty() { model.to_string() } else { format!("{size}, {model}") };
            table.add_row([&found.models.to_string(), severity.as_str(), code.as_str(), &worst]);
        }
        table.right_aligned(&[0]);
        table.into_lines(layout.columns.map(|columns| columns + 1))
    }

    /// A sentence about the models that were not checked.
    fn unchecked_in_words(&self) -> String {
        let names = |models: &[String]| {
            let names: Vec<String> = models.iter().map(|name| shown_whole(name).to_string()).collect();
            listed(&names, 10)
        };
        let without = match self.without_contacts.as_slice() {
            [] => "none is without contacts".to_owned(),
            models => format!("{} without contacts: {}", models.len(), names(models)),
        };
        match self.not_read.as_slice() {
            [] => format!("every file was read; {without}"),
            models => {
                let what = if self.call.fix { "not read or not corrected" } else { "not read" };
                format!("{} {what}: {}; {without}", models.len(), names(models))
            }
        }
    }
}

/// The rows with the words for severities in their colours.
fn painted_rows(text: &str, layout: Layout) -> String {
    let mut out = String::new();
    for line in text.split_inclusive('\n') {
        let word = line.split_ascii_whitespace().nth(1).unwrap_or_default();
        match [Severity::Error, Severity::Warning].into_iter().find(|level| level.as_str() == word) {
            Some(found) => out.push_str(&line.replacen(word, &sign(found, layout.colour), 1)),
            None => out.push_str(line),
        }
    }
    out
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
