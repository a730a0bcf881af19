//! Compares the lines of an earlier summary with the present models, settings and outputs, for a run that resumes an earlier one.
//!
//! A line of the summary belongs to the file that it names, even if this run spells the name of the file in another way: from
//! another folder, absolutely, or through a link.

use std::cell::LazyCell;
use std::collections::HashSet;
use std::hash::{BuildHasher, BuildHasherDefault, DefaultHasher};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use osim_model::messages::{Input, phrase};
use osim_requests::options::RunOptions;

use crate::partial::PartialFile;
use crate::paths::{Resolver, folder_of, resolved};
use crate::run::summary_lines::{PreviousLines, SummaryFormat};
use crate::run::{Record, Status, Task};
use crate::{LibraryFault, Result, file_access, sha256};

/// The lines that earlier runs wrote into a summary. Only the place of each line is kept, so that a million lines need little memory.
#[derive(Default)]
pub(super) struct PreviousRun {
    /// The summary, then the partial summary, which is newer.
    files: Vec<PreviousLines>,
    /// The places of all lines, sorted by file; the latest line of a file is last. A file has several lines if a run was killed while it
    /// replaced the output of an earlier run.
    places: Vec<LinePlace>,
    folder: PathBuf,
    paths: Mutex<Resolver>,
}

/// The place of one line in the files of a summary.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct LinePlace {
    /// Hash of the file that the line is about. Several files may have the same hash; the line itself has the name.
    hash: u64,
    file: usize,
    offset: u64,
}

/// What an earlier run did with a model, compared with what this run would do.
pub(super) enum PreviousOutcome {
    /// The earlier run has no line about the model, or did not finish the model.
    Unknown,
    /// The model, the settings and the outputs have the digests in this record: nothing has to be done.
    UpToDate(Box<Record>),
    /// The output still has the bytes that an earlier run wrote, and this run would write other bytes.
    Outdated,
    /// An earlier run changed the model in place, and this run would change it again.
    ModelChanged,
    /// This output exists with other bytes than the earlier run wrote, so somebody edited it.
    OutputEdited(PathBuf),
}

impl PreviousRun {
    /// Reads the summary and the partial summary that a run resumes; `user_columns` are the user's own columns in this run, `None` if
    /// they are not known.
    ///
    /// # Errors
    /// The file is not a summary of this program.
    pub(super) fn read(options: &RunOptions, user_columns: Option<&[String]>) -> Result<Self> {
        let mut done = Self::default();
        let Some(path) = options.summary.as_ref().filter(|_| options.resume) else { return Ok(done) };
        let format = SummaryFormat::of_path(path)?;
        done.folder = resolved(folder_of(path));
        // Only the partial one may end in the middle of a line: a summary gets its name when it is complete.
        for (path, may_be_cut) in [(path.clone(), false), (PartialFile::path_for(path), true)] {
            if path.exists() {
                done.add_lines_of(&path, format, may_be_cut, user_columns)
                    .map_err(|fault| fault_of_summary(&path, &fault))?;
            }
        }
        Ok(done)
    }

    /// Adds the lines of a summary or partial summary.
    fn add_lines_of(
        &mut self,
        path: &Path,
        format: SummaryFormat,
        may_be_cut: bool,
        user_columns: Option<&[String]>,
    ) -> Result<()> {
        let mut lines = PreviousLines::open(path, format, may_be_cut)?;
        let file = self.files.len();
        let mut places = Vec::new();
        lines.for_each(user_columns, |offset, record| {
            places.push(LinePlace { hash: hash_of_path(&self.file_of_record(record)), file, offset });
        })?;
        self.places.append(&mut places);
        self.files.push(lines);
        self.places.sort_unstable();
        Ok(())
    }

    pub(super) fn is_empty(&self) -> bool {
        self.places.is_empty()
    }

    /// The file that a line of the summary is about: its output, or the model if nothing is written. (Rows of a manifest may move or get
    /// another model, but no two rows write one output.)
    fn file_of_record(&self, record: &Record) -> PathBuf {
        self.resolved_name(record, record.output.as_deref().unwrap_or(&record.model))
    }

    /// The absolute path of a file that a line of the summary names.
    fn resolved_name(&self, record: &Record, name: &str) -> PathBuf {
        let folder = record.folder.as_ref().map(|folder| self.folder.join(folder)).unwrap_or_default();
        let path = folder.join(name);
        self.paths.lock().map_or_else(|_| resolved(&path), |mut paths| paths.resolved(&path))
    }

    /// The earlier records about the same file as the record `now`, the latest last.
    fn records_of(&self, now: &Record) -> Result<Vec<Record>> {
        let file = self.file_of_record(now);
        let hash = hash_of_path(&file);
        let start = self.places.partition_point(|place| place.hash < hash);
        let same = self.places.iter().skip(start).take_while(|place| place.hash == hash);
        let mut records = Vec::new();
        for place in same {
            let Some(lines) = self.files.get(place.file) else { continue };
            let record = lines.record_at(place.offset)?;
            if self.file_of_record(&record) == file {
                records.push(record);
            }
        }
        Ok(records)
    }

    /// Copies the digests of an earlier output into the `record` of a model that this run did not write, so that a later resumed run
    /// still recognises the output.
    pub(super) fn keep_earlier_output(&self, record: &mut Record) {
        if let Some(wrote) = self.latest_with_output(record) {
            *record = wrote.with_outcome_of(record);
        }
    }

    /// Copies all digests of an earlier run into the `record` of a model whose change this run only shows.
    pub(super) fn keep_digests(&self, record: &mut Record) {
        if let Some(wrote) = self.latest_with_output(record) {
            record.sha256_input = wrote.sha256_input;
            record.sha256_output = wrote.sha256_output;
            record.sha256_geometry_output = wrote.sha256_geometry_output;
            record.sha256_settings = wrote.sha256_settings;
        }
    }

    /// The latest earlier record about the same file that has an output.
    fn latest_with_output(&self, now: &Record) -> Option<Record> {
        // A line that cannot be read again counts as none.
        let records = if self.is_empty() { Vec::new() } else { self.records_of(now).unwrap_or_default() };
        records.into_iter().rev().find(|record| record.sha256_output.is_some())
    }

    /// Calls `each` with the earlier records of models that are not in `tasks`, the latest last. Records of failures without an output
    /// are left out.
    pub(super) fn for_each_other_model(
        &self,
        tasks: &[Task],
        mut each: impl FnMut(Record) -> Result<()>,
    ) -> Result<()> {
        if self.is_empty() {
            return Ok(());
        }
        let hashes_of_tasks: HashSet<u64> =
            tasks.iter().map(|task| hash_of_path(&self.file_of_record(&Record::not_begun(task)))).collect();
        let mut others: Vec<LinePlace> =
            self.places.iter().filter(|place| !hashes_of_tasks.contains(&place.hash)).copied().collect();
        others.sort_unstable_by_key(|place| (place.file, place.offset));
        for place in others {
            let Some(lines) = self.files.get(place.file) else { continue };
            let record = lines.record_at(place.offset)?;
            let is_done = matches!(record.status, Status::Unchanged | Status::NoContacts);
            if is_done || record.sha256_output.is_some() {
                each(record)?;
            }
        }
        Ok(())
    }

    /// Compares the earlier records about `task` with the present digest `input` of the model, the settings in `now`, and the outputs.
    pub(super) fn compare(&self, task: &Task, input: &str, now: &Record) -> Result<PreviousOutcome> {
        let records = self.records_of(now)?;
        if records.is_empty() {
            return Ok(PreviousOutcome::Unknown);
        }
        // Existing outputs are read only if they decide.
        let existing = LazyCell::new(|| ExistingOutputs::of_task(task, input));
        let in_place = task.settings.in_place;
        let model = self.resolved_name(now, &now.model);
        let same_model = |record: &Record| self.resolved_name(record, &record.model) == model;
        let is_up_to_date = |record: &&Record| {
            let same_settings =
                record.sha256_settings == now.sha256_settings && record.tool_version == now.tool_version;
            let same_input = record.sha256_input.as_deref() == Some(input);
            same_settings
                && same_model(record)
                && match record.status {
                    Status::Unchanged | Status::NoContacts => same_input,
                    // A model that is changed in place is its own output, so its old digest cannot be compared. A line of a run
                    // that did not come to the model has the digest of the output that was written before.
                    _ => (same_input || in_place) && existing.match_record(record),
                }
        };
        let changed_itself =
            |record: &Record| record.sha256_output.as_deref() == Some(input) && same_model(record);
        Ok(match records.iter().rev().find(is_up_to_date) {
            Some(record) => {
                PreviousOutcome::UpToDate(Box::new(record.clone().with_names_of(now).into_written_record()))
            }
            None if in_place && records.iter().any(changed_itself) => PreviousOutcome::ModelChanged,
            None if in_place => PreviousOutcome::Unknown,
            None => match existing.first_edited(task, &records) {
                Some(path) => PreviousOutcome::OutputEdited(path.to_owned()),
                None => PreviousOutcome::Outdated,
            },
        })
    }
}

/// The fault that an earlier summary cannot be continued.
fn fault_of_summary(path: &Path, fault: &LibraryFault) -> LibraryFault {
    LibraryFault::new(phrase![
        "cannot continue with {}: give {} the file of the earlier run: {}";
        path.display().to_string(), Input::Summary, fault.phrase()
    ])
}

/// A number for a path, which takes less memory than the path.
fn hash_of_path(file: &Path) -> u64 {
    BuildHasherDefault::<DefaultHasher>::default().hash_one(file)
}

/// Digests of the existing files with the names of a task's outputs.
struct ExistingOutputs {
    model: Option<String>,
    geometry: Option<String>,
}

impl ExistingOutputs {
    /// The digests of the files that exist where the task would write; `input` is the model's.
    fn of_task(task: &Task, input: &str) -> Self {
        let digest = |path: &Path| file_access::read_ordinary(path).ok().map(|bytes| sha256(&bytes));
        let model =
            if task.settings.in_place { Some(input.to_owned()) } else { task.output().and_then(digest) };
        Self { model, geometry: task.geometry_output.as_deref().and_then(digest) }
    }

    /// Whether all outputs exist and have the digests in `record`.
    fn match_record(&self, record: &Record) -> bool {
        let geometry =
            record.sha256_geometry_output.is_none() || self.geometry == record.sha256_geometry_output;
        self.model.is_some() && self.model == record.sha256_output && geometry
    }

    /// The first existing output with other bytes than an earlier run wrote; `None` if replacing the outputs loses nobody's work.
    fn first_edited<'t>(&self, task: &'t Task, records: &[Record]) -> Option<&'t Path> {
        let was_written = |digest: fn(&Record) -> &Option<String>, existing: &Option<String>| {
            existing.is_none() || records.iter().any(|record| digest(record) == existing)
        };
        if !was_written(|record| &record.sha256_output, &self.model) {
            return task.output();
        }
        let geometry_was_written = was_written(|record| &record.sha256_geometry_output, &self.geometry);
        task.geometry_output.as_deref().filter(|_| !geometry_was_written)
    }
}
