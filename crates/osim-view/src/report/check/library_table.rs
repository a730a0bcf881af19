//! The findings of many models as one table by code, with the commands that correct them.

use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use osim_inspect::{CheckResult, Counts};
use osim_model::messages::{Call, Input, Verb, counted, listed, one_line, shown_whole};
use osim_model::{Finding, FindingCode, Severity};
use osim_requests::options::OutputOptions;
use osim_requests::spell::FrontEnd;
use osim_requests::{CheckRequest, Request};
use textwrap::core::display_width;

use crate::report::extent::Layout;
use crate::report::layout::{cut_names, sign, table, wrapped_with_path};
use crate::report::messages::{NO_CONTACTS_CELL, failure_in_cell};

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
    result_folders: Vec<PathBuf>,
}

/// The models in which a code was found.
#[derive(Debug, Default)]
struct FoundInModels {
    models: usize,
    /// The worst of these models: whether the size of the fault has words, this size, and the number of its places; this size in words or
    /// empty; and the model's name. Only sizes with words have the same unit in all models, so they count before others.
    worst: ((bool, f64, usize), String, String),
}

/// The folder for results in a command that is proposed for many models, unless a folder of this name is there.
pub const RESULTS_FOLDER: &str = "RESULTS";

/// What to do where no command is proposed, because its results would need too many folders.
const EQUAL_NAMES: &str = "What to do: rename models, or check fewer at a time; results of models with the same name, \
                           in upper or lower case, do not fit into one folder";

impl LibraryTable {
    /// A table for the models of `call`. Proposed commands write into `result_folders`: one, or one for each path of the call. Without
    /// any, no command is proposed.
    pub fn new(call: CheckRequest, result_folders: Vec<PathBuf>) -> Self {
        Self { call, result_folders, ..Self::default() }
    }

    /// Adds the findings about the next model to the counts of the table.
    pub fn add(&mut self, found: &CheckResult) {
        let shown: Vec<_> = found.findings.iter().filter(|finding| !finding.is_as_published()).collect();
        // Findings are sorted, so that those of one code are together.
        for alike in shown.chunk_by(|a, b| (a.severity, a.code()) == (b.severity, b.code())) {
            let Some(first) = alike.first() else { continue };
            let kind = self.codes.entry((Reverse(first.severity), first.code())).or_default();
            kind.models += 1;
            let largest = Finding::largest_measure(alike.iter().map(|one| &one.finding));
            let (size, text) = largest.map_or((f64::NEG_INFINITY, ""), |one| (one.size, &one.text));
            let places = alike.iter().map(|one| one.paths().count().max(one.spheres.len())).sum::<usize>();
            let worst = (!text.is_empty(), size, places);
            if kind.models == 1 || worst > kind.worst.0 {
                kind.worst = (worst, text.to_owned(), found.model.clone());
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

    /// The table as text: the number of models with errors or warnings, and the commands that correct them; a row for each code; the files
    /// that could not be read.
    pub fn text(self, words: &dyn FrontEnd, layout: Layout) -> String {
        let folder = match self.call.models.as_slice() {
            [only] => only.display().to_string(),
            _ => String::new(),
        };
        // A call that corrects has done what can be done.
        let commands = if self.call.fix { Vec::new() } else { self.commands() };
        let mut head = self.headline();
        if !commands.is_empty() {
            let bad = self.counts.iter().filter(|counts| counts.error + counts.warning > 0).count();
            let what = if commands.len() > 1 { "these commands put" } else { "this command puts" };
            head.push_str(&format!("; {what} {} right:", part_of_all(self.corrected, bad)));
        }
        let mut text = match folder.as_str() {
            "" => layout.wrapped(&head, "  "),
            folder => wrapped_with_path(folder, &head, "  ", layout.width()),
        };
        for command in &commands {
            text.push_str(&format!("{}{}\n", words.prompt(), one_line(words.request(command))));
        }
        text.push('\n');
        if !self.codes.is_empty() {
            text.push_str(&self.table(&folder, layout));
        }
        if self.call.fix {
            let folder = self.call.output_dir.as_ref().map(|folder| format!(" into {}", folder.display()));
            let (written, all) = (self.written, counted(self.counts.len(), "model"));
            let line = format!("{written} of {all} changed and written{}", folder.unwrap_or_default());
            text.push_str(&layout.wrapped(&line, "  "));
        }
        text.push_str(&layout.wrapped(&self.unchecked_in_words(), "  "));
        if self.result_folders.is_empty() && !self.steps.is_empty() && !self.call.fix {
            text.push_str(&format!("\n{}", layout.wrapped(EQUAL_NAMES, "  ")));
        }
        let is_open = self.codes.keys().any(|(_, code)| *code == FindingCode::SpheresNotCompared);
        if is_open && self.call.from.is_none() {
            let call = Verb::Check.call_with_model().with_placeholder(Input::From, "GENERIC");
            let files = (!folder.is_empty()).then_some(folder).into_iter().collect();
            let call = words.command(&Call { files, ..call });
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

    /// The commands that correct all models which can be corrected: one for each folder of results.
    fn commands(&self) -> Vec<Request> {
        let (models, folders) = (&self.call.models, &self.result_folders);
        let parts = models.chunks(models.len().div_ceil(folders.len().max(1)).max(1));
        parts.zip(folders).filter_map(|(models, folder)| self.command(models, folder)).collect()
    }

    /// One command for the models at these paths of the call, with the folder for its results.
    fn command(&self, models: &[PathBuf], folder: &Path) -> Option<Request> {
        let first = self.steps.first()?;
        let output = OutputOptions { output_dir: Some(folder.to_owned()), ..OutputOptions::default() };
        let for_all = |steps: &[Request]| {
            let [only] = steps else { return None };
            let mut request = only.clone();
            *request.models_mut()? = models.to_owned();
            *request.output_mut()? = output.clone();
            Some(request)
        };
        let request = for_all(first);
        // A model that is right already stays as it is only where each gets its own steps.
        let is_for_all =
            self.steps.len() == self.counts.len() && self.steps.iter().all(|steps| for_all(steps) == request);
        request.filter(|_| is_for_all).or_else(|| {
            let CheckRequest { deny, format, report, .. } = CheckRequest::default();
            let (models, output_dir, call) = (models.to_owned(), output.output_dir, self.call.clone());
            let call = CheckRequest { models, output_dir, deny, format, report, ..call };
            Some(CheckRequest { fix: true, full: false, ..call }.into())
        })
    }

    /// The table. The worst model is beside its row, or below the severity if the line has no room: numbers and codes are never cut.
    fn table(&self, folder: &str, layout: Layout) -> String {
        let mut table = table(&["models", "finding", ""]);
        let mut names = Vec::new();
        for ((Reverse(severity), code), found) in &self.codes {
            table.add_row([&found.models.to_string(), severity.as_str(), code.as_str()]);
            let model = Path::new(&found.worst.2);
            names.push(one_line(model.strip_prefix(folder).unwrap_or(model).display().to_string()));
        }
        table.right_aligned(&[0]);
        let (table, columns) = (table.trim_fmt(), layout.columns.unwrap_or(usize::MAX));
        let mut rows = table.lines().map(|row| row.strip_prefix(' ').unwrap_or(row));
        let width = rows.clone().map(display_width).max().unwrap_or_default();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let names = cut_names(&names, columns.saturating_sub(8));
        let mut text = format!("{:width$}  worst\n", rows.next().unwrap_or_default());
        for ((((Reverse(severity), _), found), row), name) in self.codes.iter().zip(rows).zip(&names) {
            let size = &found.worst.1;
            let worst = if size.is_empty() { name.clone() } else { format!("{size}, {name}") };
            let row = match columns.saturating_sub(display_width(&worst)) {
                room if room >= width + 2 => format!("{row:width$}  {worst}\n"),
                room if room >= 8 || size.is_empty() => format!("{row}\n{:8}{worst}\n", ""),
                _ => format!("{row}\n{:8}{size},\n{:8}{name}\n", "", ""),
            };
            text.push_str(&row.replacen(severity.as_str(), &sign(*severity, layout.colour), 1));
        }
        text
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

/// "Some of all" findings or models in words: `a part`, `it`, `both`, `all 3` or `2 of 3`.
pub(super) fn part_of_all(some: usize, all: usize) -> String {
    match (some, all) {
        (0, _) => "a part".to_owned(),
        (_, 1) => "it".to_owned(),
        (2, 2) => "both".to_owned(),
        (some, all) if some == all => format!("all {all}"),
        (some, all) => format!("{some} of {all}"),
    }
}
