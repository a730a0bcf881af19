//! A summary: one line per model, in order; while the run lasts, `FILE.partial` in the order of the work; and what a run that resumes finds.

use std::cell::LazyCell;
use std::collections::HashSet;
use std::hash::{BuildHasher, BuildHasherDefault, DefaultHasher};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use osim_model::messages::{Input, phrase};
use osim_requests::options::RunOptions;

use crate::digest::sha256;
use crate::door;
use crate::fault::LibraryFault;
use crate::folders::make_folder_of;
use crate::partial::Partial;
use crate::paths::{Resolver, folder_of, resolved, way};
use crate::run::lines::{Form, PreviousLines};
use crate::run::record::{Record, Status};
use crate::run::task::Task;
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

// What a run that resumes an earlier one finds: what that has done, and whether that is still so.
//
// A line is known by the file that it is about, however that is spelled: from another folder, absolutely, through a link.

/// Records of earlier runs, for each only the place of its line: a million of them take little memory.
#[derive(Default)]
pub(super) struct PreviousRun {
    /// The summary and the partial one, oldest first.
    files: Vec<PreviousLines>,
    /// Sorted. Several of one file: a run that was killed while it replaced an output left what it was about to write beside
    /// what an earlier one wrote. The latest is last.
    places: Vec<LinePlace>,
    /// The folder of the summary.
    folder: PathBuf,
    paths: Mutex<Resolver>,
}

/// Where the line of a record is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct LinePlace {
    /// Of its file. Others may have the same: the line says whose it is.
    hash: u64,
    file: usize,
    offset: u64,
}

/// What an earlier run means for a model now.
pub(super) enum Previous {
    /// Nothing is known of it, or it was not finished.
    Unknown,
    /// All is as it was recorded.
    Holds(Box<Record>),
    /// The output is what that run wrote, but it would be another now.
    Outdated,
    /// The model was changed itself, and would be changed otherwise now.
    Changed,
    /// This output is there, and no run wrote it like that.
    Edited(PathBuf),
}

impl PreviousRun {
    /// Reads the summary, whole or partial, that a run resumes; `own` are the user's own columns in this run, `None` if not
    /// known.
    ///
    /// # Errors
    /// It is not a summary of this tool.
    pub(super) fn read(options: &RunOptions, own: Option<&[String]>) -> Result<Self, LibraryFault> {
        let mut done = Self::default();
        let Some(path) = options.summary.as_ref().filter(|_| options.resume) else { return Ok(done) };
        let form = Form::of(path)?;
        done.folder = resolved(folder_of(path));
        // Oldest first. Only the partial one may end in the middle of a line: a whole one gets its name in one step.
        for (path, may_be_cut) in [(path.clone(), false), (Partial::path_of(path), true)] {
            if path.exists() {
                done.add(&path, form, may_be_cut, own).map_err(|fault| cannot_go_on(&path, &fault))?;
            }
        }
        Ok(done)
    }

    fn add(
        &mut self,
        path: &Path,
        form: Form,
        may_be_cut: bool,
        own: Option<&[String]>,
    ) -> Result<(), LibraryFault> {
        let mut lines = PreviousLines::open(path, form, may_be_cut)?;
        let file = self.files.len();
        let mut places = Vec::new();
        lines.each(own, |offset, record| {
            places.push(LinePlace { hash: hash(&self.file_of(record)), file, offset });
        })?;
        self.places.append(&mut places);
        self.files.push(lines);
        self.places.sort_unstable();
        Ok(())
    }

    pub(super) fn is_empty(&self) -> bool {
        self.places.is_empty()
    }

    /// The file that a line is about: its output, or the model where nothing is written. Rows of a manifest may move and take
    /// other models, and no two of them write one output.
    fn file_of(&self, record: &Record) -> PathBuf {
        self.real(record, record.output.as_deref().unwrap_or(&record.model))
    }

    /// A file that is named in a line.
    fn real(&self, record: &Record, name: &str) -> PathBuf {
        let path = match &record.folder {
            Some(folder) => self.folder.join(folder).join(name),
            None => PathBuf::from(name),
        };
        self.paths.lock().map_or_else(|_| resolved(&path), |mut paths| paths.resolved(&path))
    }

    /// The records of the file of `now`, the latest last.
    fn records(&self, now: &Record) -> Result<Vec<Record>, LibraryFault> {
        let file = self.file_of(now);
        let hash = hash(&file);
        let start = self.places.partition_point(|place| place.hash < hash);
        let same = self.places.iter().skip(start).take_while(|place| place.hash == hash);
        let mut found = Vec::new();
        for place in same {
            let Some(lines) = self.files.get(place.file) else { continue };
            let record = lines.at(place.offset)?;
            if self.file_of(&record) == file {
                found.push(record);
            }
        }
        Ok(found)
    }

    /// Keeps in the `record` of a model that was not done what an earlier run left as its output: a later run that resumes still
    /// recognises it as ours.
    pub(super) fn left_behind(&self, record: &mut Record) {
        if let Some(wrote) = self.last_written(record) {
            *record = wrote.left_behind(record);
        }
    }

    /// Keeps the digests of a model whose change is only shown.
    pub(super) fn keep_digests(&self, record: &mut Record) {
        if let Some(wrote) = self.last_written(record) {
            record.sha256_input = wrote.sha256_input;
            record.sha256_output = wrote.sha256_output;
            record.sha256_geometry_output = wrote.sha256_geometry_output;
            record.sha256_settings = wrote.sha256_settings;
        }
    }

    fn last_written(&self, now: &Record) -> Option<Record> {
        // A line that was read once and cannot be read again counts as none.
        let records = if self.is_empty() { Vec::new() } else { self.records(now).unwrap_or_default() };
        records.into_iter().rev().find(|record| record.sha256_output.is_some())
    }

    /// Calls `each` with the records of files that are not those of `tasks`, the latest last. What failed and left nothing is
    /// forgotten.
    fn of_others(
        &self,
        tasks: &[Task],
        mut each: impl FnMut(Record) -> Result<(), LibraryFault>,
    ) -> Result<(), LibraryFault> {
        if self.is_empty() {
            return Ok(());
        }
        let here: HashSet<u64> =
            tasks.iter().map(|task| hash(&self.file_of(&Record::of_task(task)))).collect();
        let mut others: Vec<LinePlace> =
            self.places.iter().filter(|place| !here.contains(&place.hash)).copied().collect();
        others.sort_unstable_by_key(|place| (place.file, place.offset));
        for place in others {
            let Some(lines) = self.files.get(place.file) else { continue };
            let record = lines.at(place.offset)?;
            let left = matches!(record.status, Status::Unchanged | Status::NoContacts);
            if left || record.sha256_output.is_some() {
                each(record)?;
            }
        }
        Ok(())
    }

    /// What was recorded for `task`, compared with `now`: the model's digest and its settings.
    pub(super) fn of(&self, task: &Task, input: &str, now: &Record) -> Result<Previous, LibraryFault> {
        let records = self.records(now)?;
        if records.is_empty() {
            return Ok(Previous::Unknown);
        }
        // What is there is read only where it decides.
        let there = LazyCell::new(|| Outputs::of(task, input));
        let in_place = task.settings.in_place;
        let model = self.real(now, &now.model);
        let same_model = |record: &Record| self.real(record, &record.model) == model;
        let holds = |record: &&Record| {
            let same_settings =
                record.sha256_settings == now.sha256_settings && record.tool_version == now.tool_version;
            let same_input = record.sha256_input.as_deref() == Some(input);
            same_settings
                && same_model(record)
                && match record.status {
                    Status::Unchanged | Status::NoContacts => same_input,
                    // A model changed itself is its own output: what it was before is gone. A line of a run that did not
                    // come to a model says what was written before that.
                    _ => (same_input || in_place) && there.are_of(record),
                }
        };
        let changed_itself =
            |record: &Record| record.sha256_output.as_deref() == Some(input) && same_model(record);
        Ok(match records.iter().rev().find(holds) {
            Some(record) => Previous::Holds(Box::new(record.clone().named_as(now).still_written())),
            None if in_place && records.iter().any(changed_itself) => Previous::Changed,
            None if in_place => Previous::Unknown,
            None => match there.foreign(task, &records) {
                Some(path) => Previous::Edited(path.to_owned()),
                None => Previous::Outdated,
            },
        })
    }
}

fn cannot_go_on(path: &Path, fault: &LibraryFault) -> LibraryFault {
    let mut message = phrase![
        format!("cannot go on with {}: give ", path.display()),
        Input::Summary,
        " the file of the earlier run: ",
    ];
    message.push(fault.phrase());
    LibraryFault::new(message)
}

fn hash(file: &Path) -> u64 {
    BuildHasherDefault::<DefaultHasher>::default().hash_one(file)
}

/// Digests of the files that are there under the names of a task's outputs.
struct Outputs {
    model: Option<String>,
    geometry: Option<String>,
}

impl Outputs {
    fn of(task: &Task, input: &str) -> Self {
        let digest = |path: &Path| door::ordinary(path).ok().map(|bytes| sha256(&bytes));
        let model =
            if task.settings.in_place { Some(input.to_owned()) } else { task.output().and_then(digest) };
        Self { model, geometry: task.geometry_output.as_deref().and_then(digest) }
    }

    /// Whether they are complete, and what `record` says.
    fn are_of(&self, record: &Record) -> bool {
        let geometry =
            record.sha256_geometry_output.is_none() || self.geometry == record.sha256_geometry_output;
        self.model.is_some() && self.model == record.sha256_output && geometry
    }

    /// The file that is there and was not written by an earlier run. If there is none, replacing loses nobody's work.
    fn foreign<'t>(&self, task: &'t Task, records: &[Record]) -> Option<&'t Path> {
        let wrote = |digest: fn(&Record) -> &Option<String>, there: &Option<String>| {
            there.is_none() || records.iter().any(|record| digest(record) == there)
        };
        if !wrote(|record| &record.sha256_output, &self.model) {
            return task.output();
        }
        let ours = wrote(|record| &record.sha256_geometry_output, &self.geometry);
        task.geometry_output.as_deref().filter(|_| !ours)
    }
}
