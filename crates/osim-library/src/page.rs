//! The page that reports a run over many models: what front ends with a disk share.
//!
//! [`entry`] is what a page shows of a model that was changed; [`ReportPage`] is the file.
//!
//! # What it will not do
//!
//! It knows no terminal and no Python: what is wrong is a [`LibraryFault`], which its caller spells.

use std::fs::File;
use std::io::{BufWriter, Read, Seek, SeekFrom, Write};
use std::path::Path;

use osim_model::messages::{Input, phrase};
use osim_planning::BeforeAfter;
use osim_requests::options::RunOptions;
use osim_requests::spell::FrontEnd;
use osim_view::html::{
    About, Changed, Columns, DeferredText, DetailLevel, EarlierRun, Entry, GENERATOR, Kept, NamedDigest,
    Page, RowError, RunRow,
};

use crate::run::{ChangedModel, Record, Run};
use crate::{Disk, LibraryFault, Mode, Prepared, folder_of, head, make_folder_of, reason, resolved};

/// Bytes in which a page says what wrote it.
const HEAD: usize = 1024;

/// What a page may take the place of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Replace {
    Never,
    /// Pages of this program: a resumed run writes its page again.
    Pages,
    Files,
}

/// A page that is being written. It takes its name only when it is whole.
pub struct ReportPage {
    prepared: Prepared,
    page: Page<'static, NamelessFile>,
}

impl ReportPage {
    /// Begins the page that `path` will hold.
    ///
    /// # Errors
    /// A name that is not a page's, a file that is there already, or a folder that cannot be written.
    pub fn begin(path: &Path, replace: Replace, about: About, words: Words) -> Result<Self, LibraryFault> {
        check_name(path)?;
        let replaces = match replace {
            Replace::Never => false,
            Replace::Pages => is_page(path),
            Replace::Files => true,
        };
        if path.exists() && !replaces {
            return Err(LibraryFault::new(phrase![
                format!(
                    "the report {} exists already: choose another name, or replace it with ",
                    path.display()
                ),
                Input::Force,
            ]));
        }
        make_folder_of(path)?;
        let mode = if replaces { Mode::Replace } else { Mode::New };
        let prepared = Prepared::begin(path, None, mode)?;
        let kept = Kept {
            failures: NamelessFile::beside(path)?,
            rows: NamelessFile::beside(path)?,
            details: NamelessFile::beside(path)?,
        };
        Ok(Self { prepared, page: Page::new(about, kept, words) })
    }

    /// Begins the page about a run, the call `asked`; what could not even be listed is on it already. `None` if no page is asked
    /// for.
    pub fn of_run(
        run: &Run<'_>,
        options: &RunOptions,
        asked: String,
        words: Words,
    ) -> Result<Option<Self>, LibraryFault> {
        let Some(path) = &options.report else { return Ok(None) };
        let request = run.request();
        let shown = || match (request.tasks.first(), request.failures.first()) {
            (Some(task), _) => task.source.shown(),
            (None, failure) => failure.map(|failure| failure.model.to_string()).unwrap_or_default(),
        };
        let about = About::new(request.verb, request.is_one().then(shown), Columns::Changes, asked);
        let replace = match (request.force, run.goes_on()) {
            (true, _) => Replace::Files,
            // A resumed run writes its page again, as it does its summary.
            (false, true) => Replace::Pages,
            (false, false) => Replace::Never,
        };
        let mut page = Self::begin(path, replace, about, words)?;
        request.failures.iter().for_each(|failure| page.add(Entry::failed(failure, words)));
        Ok(Some(page))
    }

    pub fn add(&mut self, entry: Entry) {
        self.page.add(entry);
    }

    /// Writes the page under its name.
    ///
    /// # Errors
    /// The disk refuses: no page is there then, or the old one.
    pub fn finish(self) -> Result<(), LibraryFault> {
        let Self { mut prepared, page } = self;
        page.finish(&mut prepared)
            .map_err(|error| LibraryFault::new(reason(&error)).within("cannot write the report"))?;
        prepared.commit()
    }
}

/// Whether this program wrote the page, which says so in its head.
fn is_page(path: &Path) -> bool {
    head(path, HEAD).is_ok_and(|head| memchr::memmem::find(&head, GENERATOR.as_bytes()).is_some())
}

fn check_name(path: &Path) -> Result<(), LibraryFault> {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    match ending.as_deref() {
        Some("html" | "htm") => Ok(()),
        _ => Err(LibraryFault::new(phrase![
            Input::Report,
            format!(" '{}': expected the name of a page, such as report.html", path.display()),
        ])),
    }
}

/// Bytes copied at once.
const CHUNK: usize = 1 << 16;

/// Text that waits in a nameless file until what is before it on the page is known.
struct NamelessFile(BufWriter<File>);

impl NamelessFile {
    /// On the disk that will hold `path`; the system removes the file, whatever happens.
    pub(crate) fn beside(path: &Path) -> Result<Self, LibraryFault> {
        let target = resolved(path);
        let folder = folder_of(&target);
        let file = tempfile::tempfile_in(folder).map_err(|error| {
            LibraryFault::new(reason(&error)).within(format!("cannot write into {}", folder.display()))
        })?;
        Ok(Self(BufWriter::new(file)))
    }
}

impl DeferredText for NamelessFile {
    fn add(&mut self, text: &str) -> std::io::Result<()> {
        self.0.write_all(text.as_bytes())
    }

    fn pour_into(&mut self, page: &mut dyn Write) -> std::io::Result<()> {
        self.0.flush()?;
        let file = self.0.get_mut();
        file.seek(SeekFrom::Start(0))?;
        let mut chunk = vec![0; CHUNK];
        loop {
            let read = file.read(&mut chunk)?;
            match chunk.get(..read) {
                Some(bytes) if read > 0 => page.write_all(bytes)?,
                _ => return Ok(()),
            }
        }
    }
}

/// A front end's words that every thread can use.
pub type Words = &'static (dyn FrontEnd + Sync);

// What a page shows of one model of a run.

/// What a page shows of a model that was changed, of both its states.
pub fn entry(changed: &ChangedModel<'_>, both: &BeforeAfter, detail: DetailLevel, words: Words) -> Entry {
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
    let files = osim_view::html::Files { inputs: inputs.collect(), result, outputs };
    let mut change = Changed::of_states(changed.plan, both, files);
    if let Some(feet) = change.feet.last_mut() {
        feet.add_bones(&changed.opened.model, &changed.task.source.path, None, &Disk);
    }
    let followed = both.recording.as_ref();
    change.recording = followed.map(|seen| osim_view::html::recording(&seen.0, &seen.1, words));
    change.in_file = !changed.written.paths().is_empty();
    let entry = osim_view::html::changed(&row(record), change, detail, words);
    if changed.earlier { entry.of_earlier_run() } else { entry }
}

/// A model with only its line in the summary.
pub fn bare_entry(record: &Record, earlier: bool) -> Entry {
    if !earlier {
        let error = record.error_code.as_ref().zip(record.error.as_ref());
        let error = error.map(|(code, message)| {
            RowError::new(code.as_str(), message.as_str()).at(record.line, record.column)
        });
        return Entry::of_row(&row(record), error.as_ref());
    }
    let left = EarlierRun {
        radius_factor: record.radius_factor,
        stiffness_factor: record.stiffness_factor,
        dissipation_factor: record.dissipation_factor,
        unequal_factors: record.unequal_factors.split(' ').map(str::to_owned).collect(),
        warnings: record.warnings.split_ascii_whitespace().count(),
    };
    Entry::left_by_earlier_run(&row(record), &left)
}

fn row(record: &Record) -> RunRow {
    let mut row = RunRow::new(record.model.as_str(), record.status.describe());
    row.row = record.row;
    row.output.clone_from(&record.output);
    row.contacts_mass_kg = record.contacts_mass_kg;
    row.target_mass_kg = record.target_mass_kg;
    row.changes = record.changes;
    row
}
