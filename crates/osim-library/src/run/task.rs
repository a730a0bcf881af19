//! One model of a run with its settings and outputs; and a search for paths that several models of a run use.

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

use crate::file_access::{NameDigest, digest_of_name, sha256};
use crate::paths::Resolver;
use crate::{LibraryFault, ModelSource, OrdinaryFiles, Result};

/// One model of a run, with the settings for its change and the places of its results.
pub struct Task {
    pub source: ModelSource,
    pub destination: ResultDestination,
    /// The file for the changed geometry set of a standalone force set.
    pub geometry_output: Option<PathBuf>,
    /// Whether the user named the output file. Then it is written even if nothing changes.
    pub(super) output_is_named: bool,
    pub(super) settings: Arc<JobSettings>,
    /// Row of the model in the manifest, from 1.
    pub row: Option<usize>,
    /// The user's own columns of the manifest: name and text.
    pub user_columns: Vec<(String, String)>,
}

impl Task {
    /// The task to change the model `source`, and to write the result as the output options say.
    pub(super) fn new(source: ModelSource, output: &OutputOptions, settings: Arc<JobSettings>) -> Self {
        let geometry = settings.change.set_files.geometry.as_deref();
        Self {
            destination: ResultDestination::of_source(&source, output),
            geometry_output: geometry.map(|geometry| output.of_geometry(geometry)),
            output_is_named: output.output.is_some() || output.output_dir.is_some(),
            source,
            settings,
            row: None,
            user_columns: Vec::new(),
        }
    }

    /// The file that the task writes the new model to; `None` if it writes none.
    pub fn output(&self) -> Option<&Path> {
        match &self.destination {
            ResultDestination::Stdout => None,
            ResultDestination::File(path) => Some(path),
            ResultDestination::InPlace => Some(&self.source.path),
        }
    }
}

/// The change of a model, and the options for writing the result. All models of a call share them, and so do equal rows of a manifest.
pub(super) struct JobSettings {
    pub(super) change: Arc<PreparedChange>,
    pub(super) in_place: bool,
    pub(super) no_backup: bool,
    pub(super) force: bool,
    digest: OnceLock<String>,
}

impl JobSettings {
    /// The settings of a change, and of the files that it writes.
    pub(super) fn new(change: Arc<PreparedChange>, output: &OutputOptions) -> Self {
        let OutputOptions { in_place, no_backup, force, .. } = *output;
        Self { change, in_place, no_backup, force, digest: OnceLock::new() }
    }

    /// Digest of all settings that the output depends on besides the model itself. A resumed run compares the digest with its own.
    pub(super) fn digest(&self) -> &str {
        self.digest.get_or_init(|| {
            let mut text = format!("{}\n", self.change.settings());
            for path in self.change.extra_files() {
                // A file that cannot be read is reported later; a pipe can be read only once.
                let digest = OrdinaryFiles.read(path).map(|bytes| sha256(&bytes)).unwrap_or_default();
                text.push_str(&format!("{digest}\n"));
            }
            sha256(text.as_bytes())
        })
    }
}

/// Where the result for one model is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ResultDestination {
    /// The result is written to standard output.
    Stdout,
    File(PathBuf),
    InPlace,
}

impl ResultDestination {
    /// Where the result for `source` is written, by the output options.
    pub(crate) fn of_source(source: &ModelSource, output: &OutputOptions) -> Self {
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
            return Self::InPlace;
        }
        match &output.output_dir {
            // A named file goes to DIR/NAME, a file of a folder to DIR/PATH-BELOW-THE-FOLDER.
            Some(folder) => Self::File(folder.join(source.below_folder())),
            None => Self::File(OutputOptions::result_beside(&source.path)),
        }
    }
}

/// The model or other thing that a file is written for, as messages name it.
#[derive(Debug, Clone, Copy)]
pub enum PathOwner<'p> {
    /// A model, with its row of the manifest.
    Model(&'p Path, Option<usize>),
    /// The file is written for something else than a model, with this name.
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

/// Finds conflicts between inputs and outputs of a run before anything is written.
///
/// It keeps digests of names instead of names, because there may be very many.
#[derive(Debug, Default)]
pub struct PathConflicts<'p> {
    resolver: Resolver,
    /// Input files, and the number of models that read each.
    inputs: HashMap<NameDigest, (Cow<'p, Path>, usize)>,
    outputs: HashMap<NameDigest, PathOwner<'p>>,
}

impl<'p> PathConflicts<'p> {
    /// Adds a file that is read before the first model is written.
    pub fn add_input(&mut self, path: impl Into<Cow<'p, Path>>) {
        self.count_input(path.into(), 0);
    }

    /// Adds a file that is read for one model, perhaps after other models were written.
    pub(crate) fn add_input_of_model(&mut self, path: impl Into<Cow<'p, Path>>) {
        self.count_input(path.into(), 1);
    }

    /// Counts how many models read a file.
    fn count_input(&mut self, path: Cow<'p, Path>, models: usize) {
        if path.as_os_str() != "-" {
            let real = self.digest_without_case(&path);
            self.inputs.entry(real).or_insert((path, 0)).1 += models;
        }
    }

    /// Adds a file that is written for `owner`.
    ///
    /// # Errors
    /// The file is also another model's output, or an input. Names that differ only in the letters' case count as equal, because
    /// Windows and macOS take them for one name.
    pub fn add_output(&mut self, path: &Path, owner: impl Into<PathOwner<'p>>) -> Result<()> {
        let real = self.digest_without_case(path);
        let owner = owner.into();
        if let Some((input, _)) = self.inputs.get(&real) {
            // Only a model can be changed in place, not a report.
            let itself = phrase![", or change it with ", Input::InPlace];
            let itself = if matches!(owner, PathOwner::Model(..)) { itself } else { Phrase::default() };
            return Err(LibraryFault::new(phrase![
                "the output {} is an input of this run ({}): choose another name{}";
                path.display().to_string(), input.display().to_string(), &itself
            ]));
        }
        self.add_output_once(real, path, owner)
    }

    /// Adds a file that is changed in place for `owner`.
    ///
    /// # Errors
    /// The file is changed or read for another model, too.
    pub(crate) fn add_changed_in_place(&mut self, path: &Path, owner: PathOwner<'p>) -> Result<()> {
        let real = self.digest_without_case(path);
        if self.inputs.get(&real).is_some_and(|(_, models)| *models > 1) {
            return Err(LibraryFault::new(format!(
                "{owner} would change {} in place, and another one reads it: write the result to another file, or run one after the other",
                path.display()
            )));
        }
        self.add_output_once(real, path, owner)
    }

    /// Adds a file that is written; refuses it if it is written for something else already.
    fn add_output_once(&mut self, real: NameDigest, path: &Path, owner: PathOwner<'p>) -> Result<()> {
        if let Some(other) = self.outputs.insert(real, owner) {
            let of_row = matches!(owner, PathOwner::Model(_, Some(_)));
            let column = if of_row { " in the column output" } else { "" };
            return Err(LibraryFault::new(format!(
                "{other} and {owner} would both be written to {}: give them different names or folders{column}",
                path.display()
            )));
        }
        Ok(())
    }

    /// A digest that is equal for paths which differ only in case. Names that are not UTF-8 keep their case.
    fn digest_without_case(&mut self, path: &Path) -> NameDigest {
        let name: OsString = match self.resolver.resolved(path).into_os_string().into_string() {
            Ok(text) => text.to_lowercase().into(),
            Err(name) => name,
        };
        digest_of_name(&name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn source(path: &str, folder: Option<&str>) -> ModelSource {
        ModelSource { path: path.into(), folder: folder.map(|folder| Path::new(folder).into()), named: true }
    }

    #[test]
    fn paths_below_a_folder_are_kept() {
        assert_eq!(source("lib/a/x.osim", Some("lib")).below_folder(), Path::new("a/x.osim"));
        assert_eq!(source("lib/a/x.osim", None).below_folder(), Path::new("x.osim"));
    }

    #[test]
    fn equal_outputs_are_found_also_if_their_case_differs() {
        let mut conflicts = PathConflicts::default();
        let owner = "a model";
        conflicts.add_input(Path::new("in/a.osim"));
        assert!(conflicts.add_output(Path::new("out/X.osim"), owner).is_ok());
        assert!(conflicts.add_output(Path::new("out/x.osim"), owner).is_err());
        assert!(conflicts.add_output(Path::new("out/../in/a.osim"), owner).is_err());
        assert!(conflicts.add_changed_in_place(Path::new("in/a.osim"), owner.into()).is_ok());
        assert!(conflicts.add_changed_in_place(Path::new("in/A.osim"), owner.into()).is_err());
        conflicts.add_input_of_model(Path::new("in/b.osim"));
        conflicts.add_input_of_model(Path::new("./in/b.osim"));
        assert!(conflicts.add_changed_in_place(Path::new("in/b.osim"), owner.into()).is_err());
    }
}
