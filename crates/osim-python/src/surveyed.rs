//! What a survey knows of one model.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Mutex;

use osim_inspect::{CheckResult, Counts, Inspection};
use osim_library::page::Survey;
use osim_library::{Folders, LibraryFault, Loaded, Source, Sources, in_order, threads};
use osim_model::files::Failure;
use osim_model::messages::{Verb, harmless};
use osim_planning::Inspector;
use osim_requests::options::ReportOptions;
use osim_requests::{Jobs, Request};
use osim_view::html::Entry;
use osim_view::report::check::{self, LibraryTable};
use osim_view::report::inspection::{self, ModelsTable};
use osim_view::report::json::FailureRecord;
use osim_view::report::layout::Colour;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyDict;

use crate::files::{Memory, RequestFiles};
use crate::guard::{Watch, dictionary, fields_of, guarded};
use crate::planned::{WORDS, remedies};
use crate::problem::Problem;

/// What is known of a model; its findings also as requests that put them right.
pub(crate) enum Seen {
    /// And how much is wrong with it, where the text says that.
    Inspected(Box<Inspection>, Option<Counts>),
    Checked(Box<CheckResult>, Vec<Option<String>>),
    /// A folder's model without contacts: a library may have such.
    WithoutContacts,
    Failed(Box<Failure>),
}

// `inspect` and `check`: many models, on all processors.

/// A record and the requests of its findings; or, if there is no record, the exception.
type Row<'py> = (Option<Bound<'py, PyAny>>, Vec<Option<String>>, Option<Bound<'py, PyAny>>);

/// Inspects or checks the models of a request. Returns a row for each, remarks that come before them, and the text that the command
/// prints.
#[pyfunction]
pub(crate) fn survey<'py>(
    py: Python<'py>,
    fields: &Bound<'py, PyDict>,
    memory: BTreeMap<PathBuf, PyBackedBytes>,
    jobs: Option<usize>,
    call: String,
    callback: Option<Py<PyAny>>,
) -> PyResult<(Vec<Row<'py>>, Vec<String>, String)> {
    let fields = fields_of(fields)?;
    let (rows, remarks, text) = guarded(py, || {
        let files = RequestFiles::given(&memory, true);
        let (verb, models, inspector, report, is_in_full) = match Request::from_map(fields)? {
            Request::Inspect(request) => (
                Verb::Inspect,
                request.models.clone(),
                Inspector::of_inspect(&request, &files),
                request.report.clone(),
                // Factors of bodies have no room in a row.
                request.full || request.from.is_some(),
            ),
            Request::Check(request) => (
                Verb::Check,
                request.models.clone(),
                Inspector::of_check(&request, &files),
                request.report.clone(),
                false,
            ),
            other => return Err(Problem::defect(format!("a survey for {}", other.verb().name()))),
        };
        if let Some(failure) = inspector.generic_failure() {
            return Err(failure.clone().into());
        }
        let (inspector, report, files) = (&inspector, &report, &files);
        let work = Work { verb, models: &models, inspector, report, files, is_in_full };
        // Python checked it with its own name.
        work.done(jobs.and_then(|jobs| jobs.to_string().parse().ok()), call, &Watch::new(callback))
    })?;
    let rows = rows.into_iter().map(|seen| row(py, seen)).collect::<PyResult<_>>()?;
    Ok((rows, remarks, text))
}

struct Work<'w> {
    verb: Verb,
    models: &'w [PathBuf],
    inspector: &'w Inspector,
    report: &'w ReportOptions,
    files: &'w RequestFiles,
    /// Whether each model is printed in full, however many there are.
    is_in_full: bool,
}

impl Work<'_> {
    /// All models, in the order in which they were named.
    fn done(
        &self,
        jobs: Option<Jobs>,
        call: String,
        watch: &Watch,
    ) -> Result<(Vec<Seen>, Vec<String>, String), Problem> {
        let (mut sources, mut first) = (Sources::default(), Vec::new());
        for path in self.models {
            if self.files.in_memory(path).is_some() {
                sources.models.push(Source::file(path));
            } else {
                let mut found = Sources::find(std::slice::from_ref(path), None);
                sources.models.append(&mut found.models);
                sources.failures.append(&mut found.failures);
                sources.remarks.append(&mut found.remarks);
            }
        }
        let mut printed = self.printed(&sources);
        for failure in &sources.failures {
            if self.verb == Verb::Inspect {
                printed.add_failed(&failure.model.to_string(), failure.code);
            }
            first.push(Seen::Failed(Box::new(failure.clone())));
        }
        let survey = Survey {
            verb: self.verb,
            sources: &sources,
            inspector: self.inspector,
            report: self.report,
            words: WORDS,
        };
        let mut page = survey.begin_page(call)?;
        let with_page = page.is_some();
        // What is in memory is loaded here and taken by the thread that works on it.
        let loaded = |source: &Source| {
            let bytes = self.files.in_memory(&source.path)?;
            Some(Loaded::in_memory(&source.path, bytes.clone(), self.inspector.set_files(), self.files))
        };
        let item = |source| Item { source, loaded: Mutex::new(loaded(source)) };
        let items: Vec<Item<'_>> = sources.models.iter().map(item).collect();
        let folders = Folders::list(sources.models.iter().map(|source| source.path.as_path()), false);
        let mut rows = first;
        let how = How {
            verb: self.verb,
            inspector: self.inspector,
            survey: &survey,
            folders: &folders,
            memory: self.files.memory(),
            with_page,
            with_counts: matches!(printed, Printed::Models(_)),
        };
        let one = |item: &Item<'_>| {
            let loaded = item.loaded.lock().ok().and_then(|mut loaded| loaded.take());
            (!watch.is_stopped()).then(|| how.one(item.source, loaded))
        };
        let each = |item: &Item<'_>, seen: Option<(Seen, Option<Box<Entry>>)>| -> Result<(), LibraryFault> {
            let Some((seen, entry)) = seen else { return Ok(()) };
            if let Some(page) = &mut page {
                page.add(match (&seen, entry) {
                    (_, Some(entry)) => *entry,
                    (Seen::Failed(failure), None) => Entry::failed(failure, WORDS),
                    _ => Entry::without_contacts(&item.source.shown()),
                });
            }
            let failed = matches!(seen, Seen::Failed(_));
            match &seen {
                Seen::Failed(failure) => printed.add_failed(&item.source.shown(), failure.code),
                seen => printed.add(seen),
            }
            rows.push(seen);
            watch.one_more(failed);
            Ok(())
        };
        in_order(&items, threads(jobs, items.len()), one, each)?;
        watch.ended()?;
        page.map_or(Ok(()), osim_library::page::ReportPage::finish)?;
        Ok((rows, sources.remarks, printed.text()))
    }

    /// How the command prints these models.
    fn printed(&self, sources: &Sources) -> Printed {
        let (models, failures) = (sources.models.len(), sources.failures.len());
        match self.verb {
            Verb::Check if models > 1 => Printed::Library(LibraryTable::default()),
            Verb::Inspect if models + failures > 1 && !self.is_in_full => {
                Printed::Models(ModelsTable::default().without_full())
            }
            _ => Printed::InFull(String::new()),
        }
    }
}

/// A model, and its files where they are in memory.
struct Item<'i> {
    source: &'i Source,
    loaded: Mutex<Option<Result<Loaded, Failure>>>,
}

/// How each model is inspected, on any thread.
struct How<'h> {
    verb: Verb,
    inspector: &'h Inspector,
    survey: &'h Survey<'h>,
    folders: &'h Folders,
    /// What is not read from the disk.
    memory: &'h Memory,
    with_page: bool,
    /// Whether an inspection says how much is wrong with each model.
    with_counts: bool,
}

impl How<'_> {
    fn one(&self, source: &Source, loaded: Option<Result<Loaded, Failure>>) -> (Seen, Option<Box<Entry>>) {
        let is_check = self.verb == Verb::Check;
        let from_disk = loaded.is_none();
        let set_files = self.inspector.set_files();
        let loaded = loaded.unwrap_or_else(|| Loaded::read_beside(source, set_files, self.memory));
        let inspected = loaded.and_then(|loaded| self.survey.inspect_loaded(loaded));
        let inspected = inspected.and_then(|inspected| {
            if is_check && source.folder.is_some() {
                self.inspector.refuse_without_contacts(&inspected.opened, &inspected.inspection)?;
            }
            Ok(inspected)
        });
        let mut inspected = match inspected {
            Ok(inspected) => inspected,
            Err(failure) if is_check && source.is_skipped(&failure) => {
                return (Seen::WithoutContacts, None);
            }
            Err(failure) => return (Seen::Failed(Box::new(failure)), None),
        };
        let beside = from_disk.then(|| self.folders.compiled_beside(&source.path)).flatten();
        // A remedy may name what is in memory alone. What it reads is not kept.
        let files = || RequestFiles::new(self.memory.clone(), true);
        let wanted = is_check || self.with_page || self.with_counts;
        let found = wanted.then(|| self.survey.check(&mut inspected, beside.as_ref(), &files()));
        inspected.inspection.spell(WORDS);
        let entry = found
            .as_ref()
            .filter(|_| self.with_page)
            .map(|found| Box::new(self.survey.entry(&inspected, found)));
        let counts = found.as_ref().map(|found| found.counts);
        let seen = match found.filter(|_| is_check) {
            Some(found) => {
                let requests = remedies(&found);
                Seen::Checked(Box::new(found), requests)
            }
            None => Seen::Inspected(Box::new(inspected.inspection), counts),
        };
        (seen, entry)
    }
}

fn row(py: Python<'_>, seen: Seen) -> PyResult<Row<'_>> {
    Ok(match seen {
        Seen::Inspected(inspection, _) => (Some(dictionary(py, &*inspection)?), Vec::new(), None),
        Seen::Checked(found, requests) => (Some(dictionary(py, &*found)?), requests, None),
        Seen::WithoutContacts => (None, Vec::new(), None),
        Seen::Failed(failure) => {
            let record = dictionary(py, &FailureRecord::new(&failure, WORDS))?;
            let error = Problem::from(*failure).into_error(py);
            (Some(record), Vec::new(), Some(error.into_value(py).into_bound(py).into_any()))
        }
    })
}

// What `inspect` and `check` print: one model in full, several as one table, as the command decides it.

/// The text of a survey, as far as its models are known.
pub(crate) enum Printed {
    /// Each model by itself.
    InFull(String),
    /// A row for each model that was inspected.
    Models(ModelsTable),
    /// What was found in many models.
    Library(LibraryTable),
}

impl Printed {
    /// The next model.
    pub(crate) fn add(&mut self, seen: &Seen) {
        match (self, seen) {
            (Self::InFull(text), Seen::Inspected(inspected, _)) => {
                let gap = if text.is_empty() { "" } else { "\n" };
                text.push_str(gap);
                text.push_str(&inspection::text(inspected, WORDS, Colour::Plain));
            }
            (Self::InFull(text), Seen::Checked(found, _)) => {
                text.push_str(&check::text(found, WORDS.prompt(), Colour::Plain));
            }
            (Self::Models(table), Seen::Inspected(inspected, counts)) => {
                table.add(inspected, counts.unwrap_or_default());
            }
            (Self::Library(table), Seen::Checked(found, _)) => table.add(found),
            _ => {}
        }
    }

    /// A model that could not be read, by its name.
    pub(crate) fn add_failed(&mut self, model: &str, code: &str) {
        match self {
            Self::Models(table) => table.add_failed(model, code),
            Self::Library(table) => table.add_failed(model, code),
            Self::InFull(_) => {}
        }
    }

    /// All of it. Lines have no end, as in a file: a cell of a notebook can be scrolled.
    pub(crate) fn text(self) -> String {
        let text = match self {
            Self::InFull(text) => text,
            Self::Models(table) => table.text(None, WORDS, Colour::Plain),
            Self::Library(table) => table.text(true, WORDS, Colour::Plain),
        };
        harmless(&text).into_owned()
    }
}
