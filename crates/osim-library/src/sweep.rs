//! A sweep on the disk: a folder of variants, and a table that says what is in which.

use std::path::{Path, PathBuf};

use osim_model::FileId;
use osim_model::files::{Failure, FileName};
use osim_model::wording::{Input, phrase};
use osim_requests::options::SetFiles;
use osim_requests::{RequestError, RequestFault, SweepPlan, SweepRequest, cell};

use crate::digest::sha256;
use crate::fault::LibraryFault;
use crate::folders::{Folders, make_folder_of};
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
    /// Variants that could not be made.
    pub failed: usize,
    /// Variants that were not begun.
    pub not_begun: usize,
}

/// The outcome for a variant.
enum Made {
    Row(Vec<u8>),
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

    /// Makes all variants; `failed` gets each that could not be made, in order, on this thread.
    ///
    /// # Errors
    /// Something is there already, the table cannot be written, or the first error of `failed`.
    pub fn run<F: SweepFrontEnd, E: From<LibraryFault>>(
        &self,
        front_end: &F,
        mut failed: impl FnMut(Failure) -> Result<(), E>,
    ) -> Result<SweepEnd, E> {
        let manifest = self.folder.join(self.plan.table_name());
        self.check_new(&manifest)?;
        make_folder_of(&manifest)?;
        // Files left behind by a run that was killed go first.
        Folders::list(std::iter::once(manifest.as_path()), true);
        let mut table = Prepared::begin(&manifest, None, self.mode())?;
        table.add(&line(&self.plan.table_header())?)?;
        let mut end = SweepEnd { manifest: None, made: 0, failed: 0, not_begun: 0 };
        let work = |&index: &usize| {
            let made = self.make(index, front_end);
            front_end.done(matches!(made, Made::Failed(_)));
            made
        };
        let each = |_: &usize, made: Made| match made {
            Made::Row(row) => table.add(&row).map_err(E::from),
            Made::Failed(failure) => {
                end.failed += 1;
                failed(failure)
            }
            Made::NotBegun => {
                end.not_begun += 1;
                Ok(())
            }
        };
        let indices: Vec<usize> = (0..self.count()).collect();
        in_order(&indices, threads(self.request.jobs, self.count()), work, each)?;
        end.made = self.count() - end.failed - end.not_begun;
        if end.made > 0 {
            table.commit()?;
            end.manifest = Some(manifest);
        }
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
        match first {
            Some(first) if !self.request.force => Err(LibraryFault::new(phrase![
                format!(
                    "{there} of these files exist already, such as {}: replace them with ",
                    first.display()
                ),
                Input::Force,
                ", or choose another folder with ",
                Input::OutputDir.like("DIR"),
            ])),
            _ => Ok(()),
        }
    }

    fn mode(&self) -> Mode {
        if self.request.force { Mode::Replace } else { Mode::New }
    }

    fn make(&self, index: usize, front_end: &impl SweepFrontEnd) -> Made {
        if front_end.is_interrupted() {
            return Made::NotBegun;
        }
        let path = self.folder.join(self.plan.file_name(index));
        let variant = match self.plan.make(index) {
            Ok(variant) => variant,
            Err(failure) => return Made::Failed(failure),
        };
        let operation = variant.operation.clone();
        let digest = sha256(&variant.bytes);
        let row = self.write(&path, &variant.bytes).and_then(|()| line(&variant.row(digest)));
        match row {
            Ok(row) => Made::Row(row),
            Err(fault) => {
                let mut failure = fault.of_model(path.as_path(), "output");
                failure.message.push(format!(" ({operation})"));
                Made::Failed(failure)
            }
        }
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> Result<(), LibraryFault> {
        self.origin.find_included_from(path)?;
        let like = self.origin.stamp_of(FileId::MAIN).map(Stamp::metadata);
        let prepared = Prepared::new(path, bytes, like, self.mode())?;
        if prepared.replaces() {
            prepared.sync()?;
        }
        prepared.commit().map_err(|fault| fault.within("not written"))
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

/// One row of the table.
fn line(cells: &[String]) -> Result<Vec<u8>, LibraryFault> {
    let said = |error: String| LibraryFault::new(error);
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer
        .write_record(cells.iter().map(|text| cell(text).into_owned()))
        .map_err(|error| said(error.to_string()))?;
    writer.into_inner().map_err(|error| said(error.to_string()))
}
