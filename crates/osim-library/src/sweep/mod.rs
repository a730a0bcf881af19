//! Writes a sweep to the disk: a folder of variants of one model, and a table of the variants.

mod tables;

use std::collections::{HashMap, HashSet};
use std::ffi::OsString;
use std::path::{Path, PathBuf};

use osim_model::FileId;
use osim_model::files::Failure;
use osim_model::messages::{Input, Verb, phrase};
use osim_planning::SweepPlan;
use osim_requests::options::SetFiles;
use osim_requests::{RequestError, RequestFault, SweepRequest, verb_takes};
use osim_view::report::results::SweepRecord;

use crate::fault::{Context, LibraryFault, Result};
use crate::file_access::{self, sha256};
use crate::partial::PartialFile;
use crate::paths::{Resolver, resolved};
use crate::source::{LoadedModel, ModelOrigin, ModelSource, SWEEP_FOLDER_ENDING};
use crate::sweep::tables::{SweepTables, WrittenFiles, csv_line};
use crate::workers::{thread_count, work_in_order};
use crate::write::exchange::has_bytes;
use crate::write::{OutputFolders, PendingFile, WriteMode};

/// A sweep whose request was checked; nothing is written yet.
pub struct SweepRun<'s> {
    request: &'s SweepRequest,
    pub plan: SweepPlan<'s>,
    origin: ModelOrigin,
    /// The folder for the variants.
    pub folder: PathBuf,
}

/// How a sweep ended: its table, and how many variants had which outcome.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct SweepEnd {
    /// The table of the variants of this run, if the run made any.
    pub manifest: Option<PathBuf>,
    pub made: usize,
    /// Variants that an earlier sweep has made.
    pub earlier: usize,
    /// Variants with errors or warnings that the original does not have.
    pub worse: usize,
    /// Variants whose contacts are equal to those of another variant of this run.
    pub same: SameContacts,
    /// Models of other sweeps in the folder; only counted if this run makes all variants.
    pub others: OtherModels,
    /// How many variants could not be made.
    pub failed: usize,
    pub not_begun: usize,
}

/// The outcome for one variant of a sweep.
enum VariantOutcome {
    /// The variant is written, and `row` is its line in the table.
    Row { row: Vec<u8>, number: usize, contacts: String, earlier: bool, worse: bool },
    /// The variant cannot be made, for this reason.
    Failed(Failure),
    /// The sweep was interrupted before the variant.
    NotBegun,
}

impl<'s> SweepRun<'s> {
    /// Reads the model and checks the request.
    ///
    /// # Errors
    /// The request is wrong, or the model cannot be read.
    pub fn new(request: &'s SweepRequest) -> Result<Self, RequestError> {
        let Some(model) = &request.model else { return Err(RequestFault::Missing { field: "model" }.into()) };
        request.check_axes()?;
        if model.as_os_str() == "-" || model.is_dir() {
            return Err(RequestFault::general("a sweep makes variants of one model: name its file").into());
        }
        request.check()?;
        let plan = || -> Result<_, RequestError> {
            let source = ModelSource::file(model);
            let LoadedModel { files, origin } = LoadedModel::read(&source, &SetFiles::default())?;
            Ok((SweepPlan::new(request, files)?, origin))
        };
        let (plan, origin) = plan().map_err(|mut error| {
            if let RequestError::Failure(failure) = &mut error {
                failure.message.choose_alternatives(&|input| verb_takes(Verb::Sweep, input));
            }
            error
        })?;
        let beside = || {
            let mut name = model.file_stem().unwrap_or_default().to_owned();
            name.push(SWEEP_FOLDER_ENDING);
            model.with_file_name(name)
        };
        let folder = request.output_dir.clone().unwrap_or_else(beside);
        Ok(Self { request, plan, origin, folder })
    }

    /// The number of variants that this run makes.
    pub fn count(&self) -> usize {
        self.plan.indices().len()
    }

    /// The name of the variant's file, if the request names one point.
    pub fn point_file(&self) -> Option<String> {
        self.request.point.map(|point| self.plan.file_name(point.saturating_sub(1)))
    }

    /// The record of this sweep after its `end`, or of what it would make.
    pub fn record(&self, end: Option<&SweepEnd>) -> SweepRecord {
        let manifest = end.and_then(|end| end.manifest.as_deref());
        let record = SweepRecord::new(self.plan.model().name(), &self.folder, manifest);
        let (points, file) = (self.plan.count(), self.point_file());
        let planned = (self.count(), 0, 0);
        let (models, done_before, failed) =
            end.map_or(planned, |end| (end.made + end.earlier, end.earlier, end.failed));
        SweepRecord { points, file, models, done_before, failed, ..record }
    }

    /// Makes the variants of this run. Calls `report` for each variant in order, on this thread, with a failure if the variant could not
    /// be made. `is_interrupted` ends the sweep early. `variant_done` is called on the threads that do the work, after each variant, with
    /// whether it failed.
    ///
    /// # Errors
    /// A file of a variant exists already, or the table cannot be written.
    pub fn run(
        &self,
        is_interrupted: impl Fn() -> bool + Sync,
        variant_done: impl Fn(bool) + Sync,
        mut report: impl FnMut(Option<Failure>),
    ) -> Result<SweepEnd> {
        let mut end = SweepEnd::default();
        if self.count() == 0 {
            // There are more shards than points.
            return Ok(end);
        }
        let tables = SweepTables::new(&self.folder, &self.plan);
        tables.refuse_if_in_use()?;
        self.refuse_existing_files(&tables)?;
        let files = WrittenFiles::begin(&tables, self.request.resume)?;
        // Removes temporary files of a run that was killed.
        OutputFolders::list(std::iter::once(tables.table_of_run()), true);
        let mut table = match PendingFile::begin(tables.table_of_run(), None, self.table_mode()) {
            Ok(table) => table,
            // Another run has ended in the meantime.
            Err(fault) => return files.finish(false).and(Err(fault)),
        };
        table.add_bytes(&csv_line(&self.plan.table_header())?)?;
        let work = |&index: &usize| {
            let made =
                if is_interrupted() { VariantOutcome::NotBegun } else { self.make_variant(index, &files) };
            variant_done(matches!(made, VariantOutcome::Failed(_)));
            made
        };
        // The number of the first variant for each digest of contacts.
        let mut first_numbers: HashMap<String, usize> = HashMap::new();
        let each = |_: &usize, made: VariantOutcome| -> Result<()> {
            match made {
                VariantOutcome::Row { row, number, contacts, earlier, worse } => {
                    let first = *first_numbers.entry(contacts).or_insert(number);
                    if first != number {
                        end.same.count += 1;
                        end.same.first.get_or_insert((number, first));
                    }
                    end.worse += usize::from(worse);
                    *if earlier { &mut end.earlier } else { &mut end.made } += 1;
                    table.add_bytes(&row)?;
                    report(None);
                }
                VariantOutcome::Failed(failure) => {
                    end.failed += 1;
                    report(Some(failure));
                }
                VariantOutcome::NotBegun => end.not_begun += 1,
            }
            Ok(())
        };
        let indices: Vec<usize> = self.plan.indices().collect();
        work_in_order(&indices, thread_count(self.request.jobs, self.count()), work, each)?;
        if end.made + end.earlier > 0 {
            table.commit()?;
            end.manifest = Some(tables.table_of_run().to_owned());
            if !tables.is_part() {
                end.others = OtherModels::find(&self.folder, &self.plan);
            }
        }
        files.finish(end.made + end.earlier == self.count())?;
        Ok(end)
    }

    /// Refuses to begin if a variant or a table exists already and may not be replaced.
    fn refuse_existing_files(&self, tables: &SweepTables<'_>) -> Result<()> {
        let names = self.plan.indices().map(|index| self.folder.join(self.plan.file_name(index)));
        let model = resolved(self.request.model.as_deref().unwrap_or(Path::new("")));
        let mut resolver = Resolver::default();
        let (mut first, mut existing) = (None, 0);
        let tables = || std::iter::once(tables.table_of_run()).chain(tables.replaced_tables());
        for path in names.chain(tables().map(Path::to_owned)) {
            if resolver.resolved(&path) == model {
                return Err(LibraryFault::new(phrase![
                    "a variant would replace the model itself: write into another folder with ",
                    Input::OutputDir.with_placeholder("DIR"),
                ]));
            }
            if path.exists() {
                existing += 1;
                first.get_or_insert(path);
            }
        }
        if self.table_mode() == WriteMode::Replace {
            return Ok(());
        }
        tables().try_for_each(PartialFile::refuse_leftover)?;
        match first {
            Some(first) => {
                let which = format!("{existing} of these files");
                Err(LibraryFault::results_exist(which, &first, Some(&phrase![Input::Resume])))
            }
            None => Ok(()),
        }
    }

    /// Whether the table may replace an existing file.
    fn table_mode(&self) -> WriteMode {
        if self.request.force || self.request.resume { WriteMode::Replace } else { WriteMode::New }
    }

    /// Makes and writes one variant.
    fn make_variant(&self, index: usize, files: &WrittenFiles) -> VariantOutcome {
        let name = self.plan.file_name(index);
        let path = self.folder.join(&name);
        let variant = match self.plan.make(index) {
            Ok(variant) => variant,
            Err(failure) => return VariantOutcome::Failed(failure),
        };
        let (operation, worse) = (variant.operation.clone(), variant.is_worse());
        let contacts = variant.contact_digest().to_owned();
        let digest = sha256(&variant.bytes);
        let written = self.write(&path, &variant.bytes, files, &name, &digest);
        match written.and_then(|earlier| Ok((csv_line(&variant.row(digest))?, earlier))) {
            Ok((row, earlier)) => VariantOutcome::Row { row, number: index + 1, contacts, earlier, worse },
            Err(fault) => {
                let mut failure = fault.into_failure(path.as_path(), "output");
                failure.message.push(format!(" ({operation})"));
                VariantOutcome::Failed(failure)
            }
        }
    }

    /// Writes a variant. Returns whether it existed already with the same bytes.
    fn write(
        &self,
        path: &Path,
        bytes: &[u8],
        files: &WrittenFiles,
        name: &str,
        digest: &str,
    ) -> Result<bool> {
        self.origin.refuse_output_without_includes(path)?;
        let mode = self.mode_for_variant(path, bytes, |existing| files.was_written(name, existing))?;
        files.about_to_finish(name, digest)?;
        let Some(mode) = mode else { return Ok(true) };
        match self.write_file(path, bytes, mode) {
            Ok(()) => Ok(false),
            // Another run made it in the meantime.
            Err(_) if self.table_mode() == WriteMode::Replace && has_bytes(path, &[bytes]) => Ok(true),
            Err(fault) => Err(fault),
        }
    }

    /// Writes the file of one variant.
    fn write_file(&self, path: &Path, bytes: &[u8], mode: WriteMode) -> Result<()> {
        let prepared = PendingFile::new(path, bytes, self.origin.stamp_of(FileId::MAIN), mode)?;
        if prepared.replaces() {
            prepared.sync()?;
        }
        prepared.commit().map_err(|fault| fault.with_context("not written"))
    }

    /// How a variant may be written; `None` if its file exists with the same bytes. `is_ours` says whether an earlier sweep wrote a file
    /// of this name with a given digest.
    fn mode_for_variant(
        &self,
        path: &Path,
        bytes: &[u8],
        is_ours: impl Fn(&str) -> Result<bool>,
    ) -> Result<Option<WriteMode>> {
        if !self.request.resume {
            return Ok(Some(self.table_mode()));
        }
        if !path.exists() {
            return Ok(Some(WriteMode::New));
        }
        let existing = file_access::read_ordinary(path).context(|| path.display())?;
        if existing == bytes {
            return Ok(None);
        }
        if self.request.force || is_ours(&sha256(&existing))? {
            return Ok(Some(WriteMode::Replace));
        }
        Err(LibraryFault::output_edited(path))
    }
}

/// Variants whose contacts are equal to those of an earlier variant.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct SameContacts {
    pub count: usize,
    /// The numbers (from 1) of the first such variant and of the variant whose contacts it repeats.
    pub first: Option<(usize, usize)>,
}

/// Models in the folder of a sweep whose names look like those of variants, but that the sweep does not make.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct OtherModels {
    pub count: usize,
    /// The first name of the other models.
    pub first: Option<String>,
}

impl OtherModels {
    /// Finds models in `folder` whose names look like those of variants that this sweep does not make.
    fn find(folder: &Path, plan: &SweepPlan<'_>) -> Self {
        let is_like = |name: &OsString| name.to_str().is_some_and(|name| plan.is_like_file_name(name));
        let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
        let existing: HashSet<OsString> = entries.map(|entry| entry.file_name()).filter(is_like).collect();
        let own_names: HashSet<OsString> =
            (0..plan.count()).map(|index| plan.file_name(index).into()).collect();
        let mut others: Vec<String> =
            existing.difference(&own_names).map(|name| name.to_string_lossy().into_owned()).collect();
        others.sort_unstable();
        Self { count: others.len(), first: others.into_iter().next() }
    }
}
