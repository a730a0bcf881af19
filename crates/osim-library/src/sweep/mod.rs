//! A sweep on the disk: a folder of variants, and a table that says what is in which.

mod made;
mod table_row;

use std::path::{Path, PathBuf};

use osim_model::FileId;
use osim_model::files::{Failure, FileName};
use osim_model::wording::{Input, phrase};
use osim_requests::options::SetFiles;
use osim_requests::{RequestError, RequestFault, SweepPlan, SweepRequest};

use self::made::MadeFiles;
use self::table_row::line;
use crate::digest::sha256;
use crate::door;
use crate::fault::{Context, LibraryFault};
use crate::folders::Folders;
use crate::partial::Partial;
use crate::paths::{Resolver, resolved};
use crate::source::{FOLDER_MARK, Loaded, Origin, Source, Stamp};
use crate::workers::{in_order, threads};
use crate::write::{Mode, Prepared};

/// The caller of a sweep. Its methods are called on the threads that do the work.
pub trait SweepFrontEnd: Sync {
    /// Whether no further variant should be started.
    fn is_interrupted(&self) -> bool;

    /// One more variant is made.
    fn done(&self, failed: bool);
}

/// A sweep that was checked: nothing is written yet.
pub struct SweepRun<'s> {
    request: &'s SweepRequest,
    plan: SweepPlan<'s>,
    origin: Origin,
    folder: PathBuf,
}

/// How a sweep ended.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct SweepEnd {
    /// The table, where a model was made.
    pub manifest: Option<PathBuf>,
    /// Variants that were made.
    pub made: usize,
    /// Variants that an earlier sweep had made already.
    pub earlier: usize,
    /// Variants that could not be made.
    pub failed: usize,
    /// Variants that were not begun.
    pub not_begun: usize,
}

/// The outcome for a variant.
enum Made {
    /// Its row in the table, and whether an earlier sweep made it.
    Row(Vec<u8>, bool),
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
        let Loaded { files, origin } = Loaded::read(&Source::file(model), &SetFiles::default())?;
        let plan = SweepPlan::new(request, files)?;
        Ok(Self { request, plan, origin, folder: folder(request, model) })
    }

    /// How many variants.
    #[must_use]
    pub fn count(&self) -> usize {
        self.plan.count()
    }

    /// So many that they are made only where that was said.
    #[must_use]
    pub fn is_large(&self) -> bool {
        self.request.is_large()
    }

    /// The model, as it was named.
    #[must_use]
    pub fn model(&self) -> &FileName {
        self.plan.model().name()
    }

    /// Size of the model, in bytes.
    #[must_use]
    pub fn model_size(&self) -> usize {
        self.plan.model().bytes().len()
    }

    /// The folder that variants are written into.
    #[must_use]
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

    /// Makes all variants; `report` is called for each, in order, on this thread, with what went wrong where it could not be made.
    /// Who wants to end it early says so by [`SweepFrontEnd::is_interrupted`].
    ///
    /// # Errors
    /// Something is there already, or the table cannot be written.
    pub fn run<F: SweepFrontEnd>(
        &self,
        front_end: &F,
        mut report: impl FnMut(Option<Failure>),
    ) -> Result<SweepEnd, LibraryFault> {
        let manifest = self.folder.join(self.plan.table_name());
        self.check_new(&manifest)?;
        let files = MadeFiles::begin(&manifest, self.request.resume)?;
        // Files left behind by a run that was killed go first.
        Folders::list(std::iter::once(manifest.as_path()), true);
        let mut table = Prepared::begin(&manifest, None, self.mode())?;
        table.add(&line(&self.plan.table_header())?)?;
        let mut end = SweepEnd { manifest: None, made: 0, earlier: 0, failed: 0, not_begun: 0 };
        let work = |&index: &usize| {
            let made = self.make(index, &files, front_end);
            front_end.done(matches!(made, Made::Failed(_)));
            made
        };
        let each = |_: &usize, made: Made| -> Result<(), LibraryFault> {
            match made {
                Made::Row(row, earlier) => {
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
        let indices: Vec<usize> = (0..self.count()).collect();
        in_order(&indices, threads(self.request.jobs, self.count()), work, each)?;
        if end.made + end.earlier > 0 {
            table.commit()?;
            end.manifest = Some(manifest);
        }
        files.finish(end.made + end.earlier == self.count())?;
        Ok(end)
    }

    /// Nothing is replaced unasked, and that is known before the first file is written.
    fn check_new(&self, manifest: &Path) -> Result<(), LibraryFault> {
        let names = (0..self.count()).map(|index| self.folder.join(self.plan.file_name(index)));
        let model = resolved(self.request.model.as_deref().unwrap_or(Path::new("")));
        let mut resolver = Resolver::default();
        let (mut first, mut there) = (None, 0);
        for path in names.chain(std::iter::once(manifest.to_owned())) {
            if resolver.resolved(&path) == model {
                return Err(LibraryFault::new(phrase![
                    "a variant would replace the model itself: write into another folder with ",
                    Input::OutputDir.like("DIR"),
                ]));
            }
            if path.exists() {
                there += 1;
                first.get_or_insert(path);
            }
        }
        if self.mode() == Mode::Replace {
            return Ok(());
        }
        Partial::check_none_left(manifest)?;
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
                Input::OutputDir.like("DIR"),
            ])),
            None => Ok(()),
        }
    }

    /// Of the table.
    fn mode(&self) -> Mode {
        if self.request.force || self.request.resume { Mode::Replace } else { Mode::New }
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
        let operation = variant.operation.clone();
        let digest = sha256(&variant.bytes);
        let written = self.write(&path, &variant.bytes, files, (&name, &digest));
        match written.and_then(|earlier| Ok((line(&variant.row(digest))?, earlier))) {
            Ok((row, earlier)) => Made::Row(row, earlier),
            Err(fault) => {
                let mut failure = fault.of_model(path.as_path(), "output");
                failure.message.push(format!(" ({operation})"));
                Made::Failed(failure)
            }
        }
    }

    /// Writes a variant, with its name and digest; `true` where it was there already.
    fn write(
        &self,
        path: &Path,
        bytes: &[u8],
        files: &MadeFiles,
        (name, digest): (&str, &str),
    ) -> Result<bool, LibraryFault> {
        self.origin.find_included_from(path)?;
        let Some(mode) = self.mode_of(path, bytes, |there| files.knows(name, there))? else {
            files.about_to_finish(name, digest)?;
            return Ok(true);
        };
        let like = self.origin.stamp_of(FileId::MAIN).map(Stamp::metadata);
        let prepared = Prepared::new(path, bytes, like, mode)?;
        if prepared.replaces() {
            prepared.sync()?;
        }
        files.about_to_finish(name, digest)?;
        prepared.commit().map_err(|fault| fault.within("not written"))?;
        Ok(false)
    }

    /// How a variant may be written; none where it is there, byte for byte. `is_ours` knows digests of what earlier sweeps made
    /// under its name.
    fn mode_of(
        &self,
        path: &Path,
        bytes: &[u8],
        is_ours: impl Fn(&str) -> bool,
    ) -> Result<Option<Mode>, LibraryFault> {
        if !self.request.resume {
            return Ok(Some(self.mode()));
        }
        if !path.exists() {
            return Ok(Some(Mode::New));
        }
        let there = door::ordinary(path).context(|| path.display())?;
        if there == bytes {
            return Ok(None);
        }
        if self.request.force || is_ours(&sha256(&there)) {
            return Ok(Some(Mode::Replace));
        }
        Err(LibraryFault::edited(path))
    }
}

fn folder(request: &SweepRequest, model: &Path) -> PathBuf {
    let beside = || {
        let mut name = model.file_stem().unwrap_or_default().to_owned();
        name.push(FOLDER_MARK);
        model.with_file_name(name)
    };
    request.output_dir.clone().unwrap_or_else(beside)
}
