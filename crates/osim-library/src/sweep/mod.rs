//! A sweep on the disk: a folder of variants, and a table that says what is in which.

mod tables;

use std::collections::{HashMap, HashSet};
use std::ffi::OsString;
use std::path::{Path, PathBuf};

use osim_model::FileId;
use osim_model::files::{Failure, FileName};
use osim_model::messages::{Input, Verb, phrase};
use osim_planning::SweepPlan;
use osim_requests::options::SetFiles;
use osim_requests::{RequestError, RequestFault, SweepRequest, takes};

use crate::digest::sha256;
use crate::fault::{Context, LibraryFault};
use crate::file_access;
use crate::folders::OutputFolders;
use crate::partial::PartialFile;
use crate::paths::{Resolver, resolved};
use crate::source::{FOLDER_MARK, Loaded, Origin, Source, Stamp};
use crate::sweep::tables::{MadeFiles, Tables, line};
use crate::workers::{thread_count, work_in_order};
use crate::write::{PendingFile, WriteMode};

/// The caller of a sweep. Its methods are called on the threads that do the work.
pub trait SweepFrontEnd: Sync {
    /// Whether no further variant should be started.
    fn is_interrupted(&self) -> bool;

    /// One more variant is made.
    fn variant_done(&self, failed: bool);
}

/// A sweep that was checked: nothing is written yet.
pub struct SweepRun<'s> {
    request: &'s SweepRequest,
    plan: SweepPlan<'s>,
    origin: Origin,
    folder: PathBuf,
}

#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct SweepEnd {
    /// The table of what this run made, if it made something.
    pub manifest: Option<PathBuf>,
    pub made: usize,
    /// Variants that an earlier sweep had made already.
    pub earlier: usize,
    /// Variants with errors or warnings that the model itself has not.
    pub worse: usize,
    /// Variants with the contacts of an earlier one, among those of this run.
    pub same: SameContacts,
    /// Models of another sweep in the folder, which the table has not; looked for where this run makes the whole.
    pub others: OtherModels,
    /// Variants that could not be made.
    pub failed: usize,
    pub not_begun: usize,
}

enum Made {
    /// Its row in the table, whether an earlier sweep made it, and whether it is worse than the model.
    Row {
        row: Vec<u8>,
        /// Number of the variant, from 1, and the digest of its contacts.
        number: usize,
        contacts: String,
        earlier: bool,
        worse: bool,
    },
    Failed(Failure),
    NotBegun,
}

impl<'s> SweepRun<'s> {
    /// Reads the model and checks what is asked.
    ///
    /// # Errors
    /// Wrong usage, or a model that cannot be read.
    pub fn new(request: &'s SweepRequest) -> Result<Self, RequestError> {
        let Some(model) = &request.model else { return Err(RequestFault::Missing { field: "model" }.into()) };
        request.check_axes()?;
        if model.as_os_str() == "-" || model.is_dir() {
            return Err(RequestFault::general("a sweep makes variants of one model: name its file").into());
        }
        request.check()?;
        let (plan, origin) = Self::plan(request, model).map_err(|mut error| {
            if let RequestError::Failure(failure) = &mut error {
                failure.message.choose_alternatives(&|input| takes(Verb::Sweep, input));
            }
            error
        })?;
        Ok(Self { request, plan, origin, folder: folder(request, model) })
    }

    fn plan(request: &'s SweepRequest, model: &Path) -> Result<(SweepPlan<'s>, Origin), RequestError> {
        let Loaded { files, origin } = Loaded::read(&Source::file(model), &SetFiles::default())?;
        Ok((SweepPlan::new(request, files)?, origin))
    }

    /// How many variants this run makes: all, or those of its part.
    pub fn count(&self) -> usize {
        self.plan.indices().len()
    }

    /// How many variants there are, of all points of the grid or steps of the ladder.
    pub fn points(&self) -> usize {
        self.plan.count()
    }

    /// The file of the point that was asked for, by its name in the folder.
    pub fn point_file(&self) -> Option<String> {
        self.request.point.map(|point| self.plan.file_name(point.saturating_sub(1)))
    }

    /// Whether there are so many that they are made only if the user confirms it.
    pub fn is_large(&self) -> bool {
        self.request.is_large()
    }

    pub fn model(&self) -> &FileName {
        self.plan.model().name()
    }

    pub fn model_size(&self) -> usize {
        self.plan.model().bytes().len()
    }

    /// The folder that variants are written into.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// What a variant asks for may make no sense: that shows before anything is written.
    ///
    /// # Errors
    /// What is wrong, with the point.
    pub fn check_ends(&self) -> Result<(), RequestError> {
        self.plan.check_ends()
    }

    /// Makes all variants, or those of its part; `report` is called for each, in order, on this thread, with what went wrong if
    /// it could not be made. A caller that wants to end it early says so by [`SweepFrontEnd::is_interrupted`].
    ///
    /// # Errors
    /// Something is there already, or the table cannot be written.
    pub fn run<F: SweepFrontEnd>(
        &self,
        front_end: &F,
        mut report: impl FnMut(Option<Failure>),
    ) -> Result<SweepEnd, LibraryFault> {
        let mut end = SweepEnd::default();
        if self.count() == 0 {
            // There are more shares than points.
            return Ok(end);
        }
        let tables = Tables::new(&self.folder, &self.plan);
        tables.check_free()?;
        self.check_new(&tables)?;
        let files = MadeFiles::begin(&tables, self.request.resume)?;
        // Files left behind by a run that was killed go first.
        OutputFolders::list(std::iter::once(tables.own()), true);
        let mut table = PendingFile::begin(tables.own(), None, self.mode())?;
        table.add(&line(&self.plan.table_header())?)?;
        let work = |&index: &usize| {
            let made = self.make(index, &files, front_end);
            front_end.variant_done(matches!(made, Made::Failed(_)));
            made
        };
        let mut seen = Seen::default();
        let each = |_: &usize, made: Made| -> Result<(), LibraryFault> {
            match made {
                Made::Row { row, number, contacts, earlier, worse } => {
                    seen.add(contacts, number, &mut end.same);
                    end.worse += usize::from(worse);
                    *if earlier { &mut end.earlier } else { &mut end.made } += 1;
                    table.add(&row)?;
                    report(None);
                }
                Made::Failed(failure) => {
                    end.failed += 1;
                    report(Some(failure));
                }
                Made::NotBegun => end.not_begun += 1,
            }
            Ok(())
        };
        let indices: Vec<usize> = self.plan.indices().collect();
        work_in_order(&indices, thread_count(self.request.jobs, self.count()), work, each)?;
        if end.made + end.earlier > 0 {
            table.commit()?;
            end.manifest = Some(tables.own().to_owned());
            if !tables.is_part() {
                end.others = OtherModels::find(&self.folder, &self.plan);
            }
        }
        files.finish(end.made + end.earlier == self.count())?;
        Ok(end)
    }

    /// Nothing is replaced unasked, and that is known before the first file is written.
    fn check_new(&self, tables: &Tables<'_>) -> Result<(), LibraryFault> {
        let names = self.plan.indices().map(|index| self.folder.join(self.plan.file_name(index)));
        let model = resolved(self.request.model.as_deref().unwrap_or(Path::new("")));
        let mut resolver = Resolver::default();
        let (mut first, mut there) = (None, 0);
        let tables = || std::iter::once(tables.own()).chain(tables.replaced());
        for path in names.chain(tables().map(Path::to_owned)) {
            if resolver.resolved(&path) == model {
                return Err(LibraryFault::new(phrase![
                    "a variant would replace the model itself: write into another folder with ",
                    Input::OutputDir.with_placeholder("DIR"),
                ]));
            }
            if path.exists() {
                there += 1;
                first.get_or_insert(path);
            }
        }
        if self.mode() == WriteMode::Replace {
            return Ok(());
        }
        tables().try_for_each(PartialFile::refuse_leftover)?;
        match first {
            Some(first) => Err(LibraryFault::new(phrase![
                format!(
                    "{there} of these files exist already, such as {}: go on with them (",
                    first.display()
                ),
                Input::Resume,
                "), replace them (",
                Input::Force,
                "), or choose another folder with ",
                Input::OutputDir.with_placeholder("DIR"),
            ])),
            None => Ok(()),
        }
    }

    /// Of the table.
    fn mode(&self) -> WriteMode {
        if self.request.force || self.request.resume { WriteMode::Replace } else { WriteMode::New }
    }

    fn make(&self, index: usize, files: &MadeFiles, front_end: &impl SweepFrontEnd) -> Made {
        if front_end.is_interrupted() {
            return Made::NotBegun;
        }
        let name = self.plan.file_name(index);
        let path = self.folder.join(&name);
        let variant = match self.plan.make(index) {
            Ok(variant) => variant,
            Err(failure) => return Made::Failed(failure),
        };
        let (operation, worse) = (variant.operation.clone(), variant.is_worse());
        let contacts = variant.contact_digest().to_owned();
        let digest = sha256(&variant.bytes);
        let written = self.write(&path, &variant.bytes, files, &name, &digest);
        match written.and_then(|earlier| Ok((line(&variant.row(digest))?, earlier))) {
            Ok((row, earlier)) => Made::Row { row, number: index + 1, contacts, earlier, worse },
            Err(fault) => {
                let mut failure = fault.into_failure(path.as_path(), "output");
                failure.message.push(format!(" ({operation})"));
                Made::Failed(failure)
            }
        }
    }

    /// Writes a variant, with its name and digest. Returns whether it was there already.
    fn write(
        &self,
        path: &Path,
        bytes: &[u8],
        files: &MadeFiles,
        name: &str,
        digest: &str,
    ) -> Result<bool, LibraryFault> {
        self.origin.find_included_from(path)?;
        let mode = self.mode_of(path, bytes, |there| files.knows(name, there))?;
        files.about_to_finish(name, digest)?;
        let Some(mode) = mode else { return Ok(true) };
        match self.put(path, bytes, mode) {
            Ok(()) => Ok(false),
            // A run of another part made it in the meantime.
            Err(_) if self.mode() == WriteMode::Replace && is_there(path, bytes) => Ok(true),
            Err(fault) => Err(fault),
        }
    }

    /// Gives `bytes` the name `path`.
    fn put(&self, path: &Path, bytes: &[u8], mode: WriteMode) -> Result<(), LibraryFault> {
        let like = self.origin.stamp_of(FileId::MAIN).map(Stamp::metadata);
        let prepared = PendingFile::new(path, bytes, like, mode)?;
        if prepared.replaces() {
            prepared.sync()?;
        }
        prepared.commit().map_err(|fault| fault.within("not written"))
    }

    /// How a variant may be written; `None` if it is there, byte for byte. `is_ours` knows digests of what earlier sweeps made
    /// under its name.
    fn mode_of(
        &self,
        path: &Path,
        bytes: &[u8],
        is_ours: impl Fn(&str) -> Result<bool, LibraryFault>,
    ) -> Result<Option<WriteMode>, LibraryFault> {
        if !self.request.resume {
            return Ok(Some(self.mode()));
        }
        if !path.exists() {
            return Ok(Some(WriteMode::New));
        }
        let there = file_access::read_ordinary(path).context(|| path.display())?;
        if there == bytes {
            return Ok(None);
        }
        if self.request.force || is_ours(&sha256(&there))? {
            return Ok(Some(WriteMode::Replace));
        }
        Err(LibraryFault::output_edited(path))
    }
}

fn is_there(path: &Path, bytes: &[u8]) -> bool {
    file_access::read_ordinary(path).is_ok_and(|there| there == bytes)
}

fn folder(request: &SweepRequest, model: &Path) -> PathBuf {
    let beside = || {
        let mut name = model.file_stem().unwrap_or_default().to_owned();
        name.push(FOLDER_MARK);
        model.with_file_name(name)
    };
    request.output_dir.clone().unwrap_or_else(beside)
}

/// Variants whose contacts another one has already.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct SameContacts {
    pub count: usize,
    /// The first of them and the one that it is the same as, by their numbers from 1.
    pub first: Option<(usize, usize)>,
}

/// Contacts that were seen, by their digests, with the number of the variant.
#[derive(Debug, Default)]
struct Seen(HashMap<String, usize>);

impl Seen {
    /// Counts variant `number`, from 1, with this digest of its contacts.
    fn add(&mut self, digest: String, number: usize, same: &mut SameContacts) {
        match self.0.get(&digest) {
            Some(&earlier) => {
                same.count += 1;
                same.first.get_or_insert((number, earlier));
            }
            None => {
                self.0.insert(digest, number);
            }
        }
    }
}

/// Models in the folder of a sweep that are called like its own and are none of them.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct OtherModels {
    pub count: usize,
    /// The first of them by name.
    pub first: Option<String>,
}

impl OtherModels {
    fn find(folder: &Path, plan: &SweepPlan<'_>) -> Self {
        let is_like = |name: &OsString| name.to_str().is_some_and(|name| plan.is_like_file_name(name));
        let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
        let there: HashSet<OsString> = entries.map(|entry| entry.file_name()).filter(is_like).collect();
        let own: HashSet<OsString> = (0..plan.count()).map(|index| plan.file_name(index).into()).collect();
        let mut others: Vec<String> =
            there.difference(&own).map(|name| name.to_string_lossy().into_owned()).collect();
        others.sort_unstable();
        Self { count: others.len(), first: others.into_iter().next() }
    }
}
