//! Writes a summary: one line for each model, in the order of the models. During the run, `FILE.partial` has the lines of finished
//! models.

use std::path::Path;
use std::sync::Mutex;

use osim_model::messages::{Input, phrase};
use osim_requests::options::RunOptions;

use crate::partial::PartialFile;
use crate::paths::{folder_of, make_folder_of, relative_path, resolved};
use crate::run::resume::PreviousRun;
use crate::run::summary_lines::SummaryFormat;
use crate::run::{Record, Task};
use crate::{LibraryFault, PendingFile, Result, WriteMode};

/// The summary of a run while it is written: a line for each model.
pub(super) struct SummaryWriter {
    format: SummaryFormat,
    /// The folder in which relative names in the lines begin, as a path from the folder of the summary.
    folder: Option<String>,
    /// Lines in the order in which models are finished.
    partial: Mutex<PartialFile>,
    /// Lines in the order of the models.
    summary: Mutex<OrderedLines>,
}

/// The lines of a summary in the order of the models.
struct OrderedLines {
    file: PendingFile,
    /// Names of the user's own columns; `None` before the first line.
    user_columns: Option<Vec<String>>,
    /// The reason why a line could not be written. No line is added after a fault.
    fault: Option<LibraryFault>,
}

impl OrderedLines {
    /// Adds the line of the next model; before the first line, the header.
    fn add_line(&mut self, format: SummaryFormat, record: &Record) -> Result<()> {
        let line = format.record_line(record, self.user_columns.is_none())?;
        let names = || record.user_columns.iter().map(|(name, _)| name.clone()).collect();
        self.user_columns.get_or_insert_with(names);
        self.file.add_bytes(&line)
    }
}

impl SummaryWriter {
    /// Begins the summary and its partial file; `None` if the options name no summary.
    ///
    /// # Errors
    /// The file exists, and the run neither resumes nor replaces it; or another run is writing it.
    pub(super) fn begin(options: &RunOptions, force: bool) -> Result<Option<Self>> {
        let Some(path) = &options.summary else { return Ok(None) };
        let format = SummaryFormat::of_path(path)?;
        make_folder_of(path)?;
        let replace = options.resume || force;
        let exists = || {
            LibraryFault::new(phrase![
                "{} exists already: continue it ({}), replace it ({}), or choose another name";
                path.display().to_string(), Input::Resume, Input::Force
            ])
        };
        if !replace && path.exists() {
            return Err(exists());
        }
        if !replace {
            PartialFile::refuse_leftover(path)?;
        }
        let mode = if replace { WriteMode::Replace } else { WriteMode::New };
        let summary =
            OrderedLines { file: PendingFile::begin(path, None, mode)?, user_columns: None, fault: None };
        let way_out = "give each run a summary of its own".into();
        let partial = PartialFile::open(path, options.resume, &way_out)?;
        if !replace && path.exists() {
            // Another run has ended in the meantime.
            partial.remove()?;
            return Err(exists());
        }
        let folder = relative_path(&resolved(folder_of(path)), &resolved(Path::new(".")));
        let folder = folder.to_str().map(str::to_owned);
        Ok(Some(Self { format, folder, partial: Mutex::new(partial), summary: Mutex::new(summary) }))
    }

    /// Writes the line of an output file that is complete and about to get its final name.
    pub(super) fn about_to_finish(&self, record: &Record) -> Result<()> {
        let mut partial = self.partial.lock().map_err(|_| LibraryFault::new("a thread ended early"))?;
        let line = self.format.record_line(&self.with_folder(record), partial.is_empty())?;
        partial.add_lines(&line)
    }

    /// Adds the line of the next model in order. A fault does not stop the run: [`finish`](Self::finish) returns it.
    pub(super) fn add_model(&self, record: &Record) {
        let Ok(mut summary) = self.summary.lock() else { return };
        if summary.fault.is_none() {
            summary.fault = summary.add_line(self.format, &self.with_folder(record)).err();
        }
    }

    /// The record with the folder in which its relative names begin.
    fn with_folder(&self, record: &Record) -> Record {
        Record { folder: self.folder.clone(), ..record.clone() }
    }

    /// Adds a line of an earlier run about a model that is not in this run.
    pub(super) fn add_earlier(&self, record: Record) -> Result<()> {
        let mut summary = self.summary.lock().map_err(|_| LibraryFault::new("a thread ended early"))?;
        // The number of its row is that of another table; and every line of a table has the same columns.
        let mut kept = Record { row: None, ..record };
        if let Some(names) = summary.user_columns.as_ref().filter(|_| self.format == SummaryFormat::Csv) {
            let text = |name: &String| {
                kept.user_columns.iter().find(|(other, _)| other == name).map(|(_, text)| text.clone())
            };
            kept.user_columns =
                names.iter().map(|name| (name.clone(), text(name).unwrap_or_default())).collect();
        }
        summary.add_line(self.format, &kept)
    }

    /// Gives the summary its name, and removes the partial summary.
    ///
    /// # Errors
    /// The summary could not be written. The partial summary stays.
    pub(super) fn finish(self, previous: PreviousRun, tasks: &[Task]) -> Result<()> {
        let kept = previous.for_each_other_model(tasks, |record| self.add_earlier(record));
        // Windows cannot replace a file that is open.
        drop(previous);
        let summary = self.summary.into_inner().map_err(|_| LibraryFault::new("a thread ended early"))?;
        let written = summary.fault.map_or(kept, Err).and_then(|()| summary.file.commit());
        written.map_err(|fault| {
            LibraryFault::new(phrase![
                "the summary is missing: make room for it, then continue with {}: {}";
                Input::Resume, fault.phrase()
            ])
        })?;
        self.partial.into_inner().map_err(|_| LibraryFault::new("a thread ended early"))?.remove()
    }
}
