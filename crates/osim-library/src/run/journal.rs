//! A summary: one line per model, in order; and while the run lasts, `FILE.partial` in the order of the work.
//!
//! A resumed run compares what the lines say with what is there.

use std::path::Path;
use std::sync::Mutex;

use osim_model::messages::{Input, phrase};
use osim_requests::options::RunOptions;

use super::form::Form;
use super::record::Record;
use super::resume::PreviousRun;
use super::task::Task;
use crate::fault::LibraryFault;
use crate::folders::make_folder_of;
use crate::partial::Partial;
use crate::paths::{folder_of, resolved, way};
use crate::write::{Mode, Prepared};

/// A summary that is being written.
#[derive(Debug)]
pub(super) struct Journal {
    form: Form,
    /// Where the names in its lines begin.
    folder: Option<String>,
    /// In the order of the work.
    partial: Mutex<Partial>,
    /// In the order of the models.
    summary: Mutex<Summary>,
}

#[derive(Debug)]
struct Summary {
    file: Prepared,
    /// Names of the user's own columns; none before the first line.
    remarks: Option<Vec<String>>,
    /// Why it is not whole; then nothing further is added.
    broken: Option<LibraryFault>,
}

impl Summary {
    fn add(&mut self, form: Form, record: &Record) -> Result<(), LibraryFault> {
        let line = form.line(record, self.remarks.is_none())?;
        let names = || record.remarks.iter().map(|(name, _)| name.clone()).collect();
        self.remarks.get_or_insert_with(names);
        self.file.add(&line)
    }
}

impl Journal {
    /// # Errors
    /// A summary of that name is there, and the run neither resumes nor replaces it; or another run is
    /// writing it.
    pub(super) fn begin(options: &RunOptions, force: bool) -> Result<Option<Self>, LibraryFault> {
        let Some(path) = &options.summary else { return Ok(None) };
        let form = Form::of(path)?;
        make_folder_of(path)?;
        let replace = options.resume || force;
        if !replace && path.exists() {
            return Err(LibraryFault::new(phrase![
                format!("{} exists already: go on with it (", path.display()),
                Input::Resume,
                "), replace it (",
                Input::Force,
                "), or choose another name",
            ]));
        }
        if !replace {
            Partial::check_none_left(path)?;
        }
        let mode = if replace { Mode::Replace } else { Mode::New };
        let summary = Summary { file: Prepared::begin(path, None, mode)?, remarks: None, broken: None };
        let way_out = "give each run a summary of its own".into();
        let partial = Mutex::new(Partial::open(path, options.resume, &way_out)?);
        let folder = way(&resolved(folder_of(path)), &resolved(Path::new(".")));
        Ok(Some(Self {
            form,
            folder: folder.to_str().map(str::to_owned),
            partial,
            summary: Mutex::new(summary),
        }))
    }

    /// An output is complete and about to take its name.
    pub(super) fn about_to_finish(&self, record: &Record) -> Result<(), LibraryFault> {
        let mut partial = self.partial.lock().map_err(|_| LibraryFault::new("a thread ended early"))?;
        let line = self.form.line(&self.here(record), partial.is_empty())?;
        partial.add(&line)
    }

    /// Adds the next model in order. [`finish`](Self::finish) says whether that went well: models do not wait for it.
    pub(super) fn add(&self, record: &Record) {
        let Ok(mut summary) = self.summary.lock() else { return };
        if summary.broken.is_none() {
            summary.broken = summary.add(self.form, &self.here(record)).err();
        }
    }

    /// With the folder where its names begin.
    fn here(&self, record: &Record) -> Record {
        Record { folder: self.folder.clone(), ..record.clone() }
    }

    /// A line of an earlier run about a model that is not in this one.
    ///
    /// # Errors
    /// The disk is full.
    pub(super) fn keep(&self, record: Record) -> Result<(), LibraryFault> {
        let mut summary = self.summary.lock().map_err(|_| LibraryFault::new("a thread ended early"))?;
        // A row of another table; and a table has the same columns in every line.
        let mut kept = Record { row: None, ..record };
        if let Some(names) = summary.remarks.as_ref().filter(|_| self.form == Form::Csv) {
            let text = |name: &String| {
                kept.remarks.iter().find(|(own, _)| own == name).map(|(_, text)| text.clone())
            };
            kept.remarks = names.iter().map(|name| (name.clone(), text(name).unwrap_or_default())).collect();
        }
        summary.add(self.form, &kept)
    }

    /// Ends the summary: it is whole, and the partial one is no longer needed.
    ///
    /// # Errors
    /// The summary could not be written. What is done stays in the partial one.
    pub(super) fn finish(self, previous: PreviousRun, tasks: &[Task]) -> Result<(), LibraryFault> {
        let kept = previous.of_others(tasks, |record| self.keep(record));
        // Windows puts no file into the place of one that is open.
        drop(previous);
        let summary = self.summary.into_inner().map_err(|_| LibraryFault::new("a thread ended early"))?;
        let written = summary.broken.map_or(kept, Err).and_then(|()| summary.file.commit());
        written.map_err(|fault| {
            let mut message =
                phrase!["the summary is missing: make room for it, then go on with ", Input::Resume, ": "];
            message.push(fault.phrase());
            LibraryFault::new(message)
        })?;
        self.partial.into_inner().map_err(|_| LibraryFault::new("a thread ended early"))?.remove()
    }
}
