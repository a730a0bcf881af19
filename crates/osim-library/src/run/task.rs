//! One model and what is to be done with it: by which settings, where its results go, and whether paths of a run are in conflict.

use std::borrow::Cow;
use std::collections::HashMap;
use std::ffi::OsString;
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

use osim_model::files::Files;
use osim_model::messages::{Input, Phrase, phrase};
use osim_planning::PreparedChange;
use osim_requests::options::OutputOptions;

use crate::digest::{self, NameDigest, sha256};
use crate::fault::LibraryFault;
use crate::paths::Resolver;
use crate::source::{OrdinaryFiles, Source};

/// One model with its settings.
pub struct Task {
    pub source: Source,
    /// Where its result goes.
    pub destination: Destination,
    /// Where the changed geometry set of a standalone force set goes.
    pub geometry_output: Option<PathBuf>,
    /// Whether the output was asked for by name: then it is written even if nothing changes.
    pub(super) asked: bool,
    pub(super) settings: Arc<JobSettings>,
    /// Row of the manifest, from 1.
    pub row: Option<usize>,
    /// Columns of the manifest that are the user's own: name and text.
    pub remarks: Vec<(String, String)>,
}

impl Task {
    /// A model that is done by these settings.
    pub(super) fn new(source: Source, output: &OutputOptions, settings: Arc<JobSettings>) -> Self {
        let geometry = settings.change.set_files.geometry.as_deref();
        Self {
            destination: Destination::of(&source, output),
            geometry_output: geometry.map(|geometry| output.of_geometry(geometry)),
            asked: output.output.is_some() || output.output_dir.is_some(),
            source,
            settings,
            row: None,
            remarks: Vec::new(),
        }
    }

    /// As row `row` of a manifest.
    pub(super) fn of_row(self, row: usize) -> Self {
        Self { row: Some(row), ..self }
    }

    /// With columns of the user's own, which a summary copies.
    pub(super) fn with_remarks(self, remarks: Vec<(String, String)>) -> Self {
        Self { remarks, ..self }
    }

    /// The file that is written.
    pub fn output(&self) -> Option<&Path> {
        self.destination.path(&self.source)
    }

    /// As named in messages about several models.
    pub(super) fn owner(&self) -> PathOwner<'_> {
        PathOwner::Model(&self.source.path, self.row)
    }
}

/// What is done with a model: shared by all models of a call, or by like rows of a manifest.
pub(super) struct JobSettings {
    pub(super) change: Arc<PreparedChange>,
    pub(super) in_place: bool,
    pub(super) no_backup: bool,
    pub(super) force: bool,
    digest: OnceLock<String>,
}

impl JobSettings {
    /// What `change` plans, written as `output` says.
    pub(super) fn new(change: Arc<PreparedChange>, output: &OutputOptions) -> Self {
        let OutputOptions { in_place, no_backup, force, .. } = *output;
        Self { change, in_place, no_backup, force, digest: OnceLock::new() }
    }

    /// Digest of everything an output follows from except the model itself.
    pub(super) fn digest(&self) -> &str {
        self.digest.get_or_init(|| {
            let mut text = format!("{}\n", self.change.settings());
            for path in self.change.extra_files() {
                // What cannot be read fails later, with its name; a pipe can be read once only.
                let digest = OrdinaryFiles.read(path).map(|bytes| sha256(&bytes)).unwrap_or_default();
                text.push_str(&format!("{digest}\n"));
            }
            sha256(text.as_bytes())
        })
    }
}

/// Where one model's result goes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Destination {
    /// Standard output.
    Stdout,
    File(PathBuf),
    Itself,
}

impl Destination {
    /// The file that is written for `source`.
    pub fn path<'p>(&'p self, source: &'p Source) -> Option<&'p Path> {
        match self {
            Self::Stdout => None,
            Self::File(path) => Some(path),
            Self::Itself => Some(&source.path),
        }
    }

    /// Where the result of `source` goes.
    pub fn of(source: &Source, output: &OutputOptions) -> Self {
        if let Some(path) = &output.output {
            return if path.as_os_str() == "-" { Self::Stdout } else { Self::File(path.clone()) };
        }
        if source.is_stdin() {
            return match &output.output_dir {
                Some(folder) => Self::File(folder.join("stdin.osim")),
                None => Self::Stdout,
            };
        }
        if output.in_place {
            return Self::Itself;
        }
        match &output.output_dir {
            // A file goes to DIR/its name, a folder's files to DIR/their path below that folder.
            Some(folder) => Self::File(folder.join(source.below_folder())),
            None => Self::File(OutputOptions::beside(&source.path)),
        }
    }
}

/// For whom a file is written.
#[derive(Debug, Clone, Copy)]
pub enum PathOwner<'p> {
    /// A model, with its row of the manifest.
    Model(&'p Path, Option<usize>),
    /// Something else, in words.
    Other(&'static str),
}

impl From<&'static str> for PathOwner<'_> {
    fn from(name: &'static str) -> Self {
        Self::Other(name)
    }
}

impl fmt::Display for PathOwner<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Model(path, Some(row)) => write!(f, "row {row} ({})", path.display()),
            Self::Model(path, None) => path.display().fmt(f),
            Self::Other(name) => f.write_str(name),
        }
    }
}

/// Outputs and inputs of a whole run, compared before anything is written.
///
/// Of very many files it keeps digests of the names: the names themselves are in the tasks.
#[derive(Debug, Default)]
pub struct PathConflicts<'p> {
    resolver: Resolver,
    /// Files that are read, and for how many models.
    inputs: HashMap<NameDigest, (Cow<'p, Path>, usize)>,
    outputs: HashMap<NameDigest, PathOwner<'p>>,
}

impl<'p> PathConflicts<'p> {
    /// A file that is read: nothing may be written over it.
    pub fn read(&mut self, path: impl Into<Cow<'p, Path>>) {
        self.count(path.into(), 0);
    }

    /// Notes a file that would be another one if it were changed before it is read for this model.
    pub fn read_again(&mut self, path: impl Into<Cow<'p, Path>>) {
        self.count(path.into(), 1);
    }

    fn count(&mut self, path: Cow<'p, Path>, models: usize) {
        if path.as_os_str() != "-" {
            let real = self.without_case(&path);
            self.inputs.entry(real).or_insert((path, 0)).1 += models;
        }
    }

    /// A file that is to be written for `owner`.
    ///
    /// # Errors
    /// Another model has that output, or it is one of the files that are read; also where only the letters' case
    /// differs, because Windows and macOS see one file there.
    pub fn write(&mut self, path: &Path, owner: impl Into<PathOwner<'p>>) -> Result<(), LibraryFault> {
        let real = self.without_case(path);
        let owner = owner.into();
        if let Some((input, _)) = self.inputs.get(&real) {
            // Only a model can be changed itself: a report beside it needs a name of its own.
            let itself = phrase![", or change it with ", Input::InPlace];
            let itself = if matches!(owner, PathOwner::Model(..)) { itself } else { Phrase::default() };
            return Err(LibraryFault::new(phrase![
                format!(
                    "the output {} is an input of this run ({}): choose another name",
                    path.display(),
                    input.display()
                ),
                &itself,
            ]));
        }
        self.once(real, path, owner)
    }

    /// A file that is changed itself, for `owner`.
    ///
    /// # Errors
    /// It is changed, or read, for another one too.
    pub fn change(&mut self, path: &Path, owner: PathOwner<'p>) -> Result<(), LibraryFault> {
        let real = self.without_case(path);
        if self.inputs.get(&real).is_some_and(|(_, models)| *models > 1) {
            return Err(LibraryFault::new(format!(
                "{owner} would change {} itself, and another one reads it: give it an output of its own, or do one \
                 after the other",
                path.display()
            )));
        }
        self.once(real, path, owner)
    }

    fn once(&mut self, real: NameDigest, path: &Path, owner: PathOwner<'p>) -> Result<(), LibraryFault> {
        if let Some(other) = self.outputs.insert(real, owner) {
            return Err(LibraryFault::new(format!(
                "{other} and {owner} would both be written to {}: give them different names or folders",
                path.display()
            )));
        }
        Ok(())
    }

    /// Equal for names that Windows and macOS take for one. Names that are not UTF-8 have no known case.
    fn without_case(&mut self, path: &Path) -> NameDigest {
        let name: OsString = match self.resolver.resolved(path).into_os_string().into_string() {
            Ok(text) => text.to_lowercase().into(),
            Err(name) => name,
        };
        digest::digest_of_name(&name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn source(path: &str, folder: Option<&str>) -> Source {
        Source { path: path.into(), folder: folder.map(|folder| Path::new(folder).into()), named: true }
    }

    #[test]
    fn a_folder_keeps_its_shape() {
        assert_eq!(source("lib/a/x.osim", Some("lib")).below_folder(), Path::new("a/x.osim"));
        assert_eq!(source("lib/a/x.osim", None).below_folder(), Path::new("x.osim"));
    }

    #[test]
    fn equal_outputs_are_found_also_but_for_case() {
        let mut conflicts = PathConflicts::default();
        let owner = "a model";
        conflicts.read(Path::new("in/a.osim"));
        assert!(conflicts.write(Path::new("out/X.osim"), owner).is_ok());
        assert!(conflicts.write(Path::new("out/x.osim"), owner).is_err());
        assert!(conflicts.write(Path::new("out/../in/a.osim"), owner).is_err());
        assert!(conflicts.change(Path::new("in/a.osim"), owner.into()).is_ok());
        assert!(conflicts.change(Path::new("in/A.osim"), owner.into()).is_err());
        conflicts.read_again(Path::new("in/b.osim"));
        conflicts.read_again(Path::new("./in/b.osim"));
        assert!(conflicts.change(Path::new("in/b.osim"), owner.into()).is_err());
    }
}
