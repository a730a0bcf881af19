//! Writes the page of `--report` to a file ([`ReportPage`]), with an entry for each changed model ([`entry_of_change`]).
//!
//! # What it will not do
//!
//! The module writes nothing to a terminal and knows nothing of Python: its faults are [`LibraryFault`], which the caller spells.

use std::fs::File;
use std::io::{BufWriter, Seek, SeekFrom, Write};
use std::path::Path;

use osim_model::files::Failure;
use osim_model::messages::{Input, phrase};
use osim_planning::BeforeAfter;
use osim_requests::options::RunOptions;
use osim_requests::spell::FrontEnd;
use osim_view::html::{
    ChangedModelOnPage, Columns, DeferredParts, DeferredText, DetailLevel, Entry, GENERATOR, NamedDigest,
    Page, PageHead, RunRow,
};

use crate::file_access::read_head;
use crate::run::{ChangedModel, Record, Run};
use crate::{
    Disk, LibraryFault, PendingFile, Result, WriteMode, folder_of, make_folder_of, reason, resolved,
};

/// A report page names this program as its generator within this number of first bytes.
const SEARCHED_HEAD_BYTES: usize = 1024;

/// A report page that is being written. The file gets its final name when the page is complete.
pub struct ReportPage {
    prepared: PendingFile,
    page: Page<'static, NamelessFile>,
}

impl ReportPage {
    /// Begins the report page that becomes the file `path`, with the models that could not be listed. `may_replace` says whether it may
    /// replace an existing file.
    ///
    /// # Errors
    /// The name has another ending than `.html`, the file exists already, or the folder cannot be written.
    pub fn begin(
        path: &Path,
        may_replace: bool,
        head: PageHead,
        failures: &[Failure],
        words: Words,
    ) -> Result<Self> {
        check_name(path)?;
        if path.exists() && !may_replace {
            return Err(LibraryFault::file_exists(path, Input::Report));
        }
        make_folder_of(path)?;
        let mode = if may_replace { WriteMode::Replace } else { WriteMode::New };
        let prepared = PendingFile::begin(path, None, mode)?;
        let kept = DeferredParts {
            failures: NamelessFile::in_folder_of(path)?,
            rows: NamelessFile::in_folder_of(path)?,
            details: NamelessFile::in_folder_of(path)?,
        };
        let mut page = Page::new(head, kept, words);
        failures.iter().for_each(|failure| page.add(Entry::failed(failure, words)));
        Ok(Self { prepared, page })
    }

    /// Begins the report page about a run with the models that could not be listed. The page shows `call`. `None` if the options
    /// name no page.
    pub fn for_run(run: &Run<'_>, options: &RunOptions, call: String, words: Words) -> Result<Option<Self>> {
        let Some(path) = &options.report else { return Ok(None) };
        let request = &run.request;
        let shown = || match (request.tasks.first(), request.failures.first()) {
            (Some(task), _) => task.source.shown(),
            (None, failure) => failure.map(|failure| failure.model.to_string()).unwrap_or_default(),
        };
        let is_for_one_model = request.tasks.len() + request.failures.len() == 1;
        let model = is_for_one_model.then(shown);
        let head = PageHead { verb: request.verb, model, columns: Columns::Changes, call };
        // A resumed run writes its page again, as it does its summary.
        let is_report = |head: Vec<u8>| memchr::memmem::find(&head, GENERATOR.as_bytes()).is_some();
        let is_own = || read_head(path, SEARCHED_HEAD_BYTES).is_ok_and(is_report);
        let may_replace = request.force || run.is_resumed() && is_own();
        Self::begin(path, may_replace, head, &request.failures, words).map(Some)
    }

    /// Adds the entry of the next model.
    pub fn add(&mut self, entry: Entry) {
        self.page.add(entry);
    }

    /// Writes the page and gives it its name.
    ///
    /// # Errors
    /// The page cannot be written. An existing page stays as it is.
    pub fn finish(self) -> Result<()> {
        let Self { mut prepared, page } = self;
        page.finish(&mut prepared)
            .map_err(|error| LibraryFault::new(reason(&error)).with_context("cannot write the report"))?;
        prepared.commit()
    }
}

/// Refuses a page whose name does not end like that of an HTML file.
fn check_name(path: &Path) -> Result<()> {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    match ending.as_deref() {
        Some("html" | "htm") => Ok(()),
        _ => Err(LibraryFault::new(phrase![
            Input::Report,
            format!(" '{}': expected the name of a page, such as report.html", path.display()),
        ])),
    }
}

/// Text that is kept in a file without a name until the text before it on the page is complete.
struct NamelessFile(BufWriter<File>);

impl NamelessFile {
    /// A file on the disk of `path`. The system removes it when the process ends.
    pub(crate) fn in_folder_of(path: &Path) -> Result<Self> {
        let target = resolved(path);
        let folder = folder_of(&target);
        let file = tempfile::tempfile_in(folder).map_err(|error| {
            LibraryFault::new(reason(&error)).with_context(format!("cannot write into {}", folder.display()))
        })?;
        Ok(Self(BufWriter::new(file)))
    }
}

impl DeferredText for NamelessFile {
    fn add(&mut self, text: &str) -> std::io::Result<()> {
        self.0.write_all(text.as_bytes())
    }

    fn write_to(&mut self, page: &mut dyn Write) -> std::io::Result<()> {
        self.0.flush()?;
        let file = self.0.get_mut();
        file.seek(SeekFrom::Start(0))?;
        std::io::copy(file, page).map(drop)
    }
}

/// The front end that spells options and calls in messages. All threads can use it.
pub type Words = &'static (dyn FrontEnd + Sync);

/// The entry of a changed model on the report page, with `states` before and after the change.
pub fn entry_of_change(
    changed: &ChangedModel<'_>,
    states: &BeforeAfter,
    detail: DetailLevel,
    words: Words,
) -> Entry {
    let record = changed.record;
    let names = changed.opened.files().map(|(name, _)| name.to_owned());
    let inputs = names.zip(changed.inputs.iter().cloned()).map(|(name, sha256)| NamedDigest { name, sha256 });
    let digests = [&record.sha256_output, &record.sha256_geometry_output];
    let paths = changed.written.paths().iter().map(|path| path.display().to_string());
    let outputs = paths.zip(digests.into_iter().flatten().cloned());
    let outputs = outputs.map(|(name, sha256)| NamedDigest { name, sha256 }).collect();
    let result = match changed.earlier {
        true => record.status.describe().to_owned(),
        false => changed.written.describe(),
    };
    let files = osim_view::html::ListedFiles { inputs: inputs.collect(), result, outputs };
    let mut change = ChangedModelOnPage::new(changed.plan, states, files);
    if let Some(feet) = change.feet.last_mut() {
        feet.add_bones(&changed.opened.model, &changed.task.source.path, None, &Disk);
    }
    let followed = states.recording.as_ref();
    change.recording = followed.map(|seen| osim_view::html::recording(&seen.0, &seen.1, words));
    change.in_file = !changed.written.paths().is_empty();
    let entry = osim_view::html::entry_of_changed_model(&row_of_record(record), change, detail, words);
    if changed.earlier { entry.marked_as_earlier() } else { entry }
}

/// The entry on the report page of a model of which only its line in the summary is known.
pub fn entry_of_record(record: &Record, earlier: bool) -> Entry {
    let row = row_of_record(record);
    if earlier {
        let factors = [record.radius_factor, record.stiffness_factor, record.dissipation_factor];
        let findings = record.findings.split_ascii_whitespace().count();
        return Entry::of_earlier_run(&row, factors, &record.unequal_factors, findings);
    }
    match (&record.error_code, &record.error) {
        (Some(code), Some(error)) => Entry::failed_row(&row, code, error, (record.line, record.column)),
        _ => Entry::of_row(&row),
    }
}

/// The row of the page for a line of the summary.
fn row_of_record(record: &Record) -> RunRow {
    let mut row = RunRow::new(record.model.as_str(), record.status.describe());
    row.row = record.row;
    row.output.clone_from(&record.output);
    row.contacts_mass_kg = record.contacts_mass_kg;
    row.target_mass_kg = record.target_mass_kg;
    row.changes = record.changes;
    row
}
