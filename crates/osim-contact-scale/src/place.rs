//! Where results go, decided and checked for all models before anything is written.

use std::borrow::Cow;
use std::collections::HashMap;
use std::ffi::OsString;
use std::fmt;
use std::path::{Path, PathBuf};

use anyhow::{Result, bail};

use crate::args::OutputArgs;
use crate::digest::{self, NameDigest};
use crate::paths::Resolver;
use crate::sources::{OUTPUT_MARK, Source};

/// Where one model's result goes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Place {
    /// Standard output.
    Stdout,
    /// A file of its own.
    File(PathBuf),
    /// The model itself.
    Itself,
}

impl Place {
    /// The file that is written for `source`.
    pub(crate) fn path<'p>(&'p self, source: &'p Source) -> Option<&'p Path> {
        match self {
            Self::Stdout => None,
            Self::File(path) => Some(path),
            Self::Itself => Some(&source.path),
        }
    }
}

/// `NAME.scaled.osim` beside the model.
pub(crate) fn beside(path: &Path) -> PathBuf {
    let mut name = path.file_stem().unwrap_or_default().to_owned();
    name.push(OUTPUT_MARK);
    if let Some(extension) = path.extension() {
        name.push(".");
        name.push(extension);
    }
    path.with_file_name(name)
}

/// The place of `source`.
pub(crate) fn place(source: &Source, output: &OutputArgs) -> Place {
    if let Some(path) = &output.output {
        return if path.as_os_str() == "-" { Place::Stdout } else { Place::File(path.clone()) };
    }
    if source.is_stdin() {
        return match &output.output_dir {
            Some(folder) => Place::File(folder.join("stdin.osim")),
            None => Place::Stdout,
        };
    }
    if output.in_place {
        return Place::Itself;
    }
    match &output.output_dir {
        // A file goes to DIR/its name, a folder's files to DIR/their path below that folder.
        Some(folder) => Place::File(folder.join(source.below_folder())),
        None => Place::File(beside(&source.path)),
    }
}

/// Where the changed geometry set of a standalone force set goes.
pub(crate) fn geometry_place(geometry: &Path, output: &OutputArgs) -> PathBuf {
    match (&output.geometry_output, &output.output_dir) {
        _ if output.in_place => geometry.to_owned(),
        (Some(path), _) => path.clone(),
        (None, Some(folder)) => folder.join(geometry.file_name().unwrap_or_default()),
        (None, None) => beside(geometry),
    }
}

/// For whom a file is written.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Who<'p> {
    /// A model, with its row of the manifest.
    Model(&'p Path, Option<usize>),
    /// Something else.
    Other(&'static str),
}

impl From<&'static str> for Who<'_> {
    fn from(name: &'static str) -> Self {
        Self::Other(name)
    }
}

impl fmt::Display for Who<'_> {
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
/// Of very many files it keeps digests of the names: the names themselves stand in the tasks.
#[derive(Debug, Default)]
pub(crate) struct Ledger<'p> {
    resolver: Resolver,
    /// Files that are read, and for how many models.
    inputs: HashMap<NameDigest, (Cow<'p, Path>, usize)>,
    outputs: HashMap<NameDigest, Who<'p>>,
}

impl<'p> Ledger<'p> {
    /// A file that is read: nothing may be written over it.
    pub(crate) fn read(&mut self, path: impl Into<Cow<'p, Path>>) {
        self.count(path.into(), 0);
    }

    /// The same of a file that would be another one if it were changed before it is read for this model.
    pub(crate) fn read_again(&mut self, path: impl Into<Cow<'p, Path>>) {
        self.count(path.into(), 1);
    }

    fn count(&mut self, path: Cow<'p, Path>, models: usize) {
        if path.as_os_str() != "-" {
            let real = self.resolver.without_case(&path);
            self.inputs.entry(real).or_insert((path, 0)).1 += models;
        }
    }

    /// A file that is to be written for `who`.
    ///
    /// # Errors
    /// Another model has that output, or it is one of the files that are read; also where only the letters' case
    /// differs, because Windows and macOS see one file there.
    pub(crate) fn write(&mut self, path: &Path, who: impl Into<Who<'p>>) -> Result<()> {
        let real = self.resolver.without_case(path);
        if let Some((input, _)) = self.inputs.get(&real) {
            bail!(
                "the output {} is an input of this run ({}): choose another name, or change it with --in-place",
                path.display(),
                input.display()
            );
        }
        self.once(real, path, who.into())
    }

    /// A file that is changed itself, for `who`.
    ///
    /// # Errors
    /// It is changed, or read, for another one too.
    pub(crate) fn change(&mut self, path: &Path, who: Who<'p>) -> Result<()> {
        let real = self.resolver.without_case(path);
        if self.inputs.get(&real).is_some_and(|(_, models)| *models > 1) {
            bail!(
                "{who} would change {} itself, and another one reads it: give it an output of its own, or do one after \
                 the other",
                path.display()
            );
        }
        self.once(real, path, who)
    }

    fn once(&mut self, real: NameDigest, path: &Path, who: Who<'p>) -> Result<()> {
        if let Some(other) = self.outputs.insert(real, who) {
            bail!(
                "{other} and {who} would both be written to {}: give them different names or folders",
                path.display()
            );
        }
        Ok(())
    }
}

impl Resolver {
    /// Equal for names that Windows and macOS take for one. Names that are not UTF-8 have no case that anybody knows of.
    fn without_case(&mut self, path: &Path) -> NameDigest {
        let name: OsString = match self.resolved(path).into_os_string().into_string() {
            Ok(text) => text.to_lowercase().into(),
            Err(name) => name,
        };
        digest::of_name(&name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn source(path: &str, folder: Option<&str>) -> Source {
        Source { path: path.into(), folder: folder.map(|folder| Path::new(folder).into()) }
    }

    #[test]
    fn the_default_is_a_new_file_beside_the_model() {
        assert_eq!(beside(Path::new("a/human.osim")), Path::new("a/human.scaled.osim"));
        assert_eq!(beside(Path::new("set.xml")), Path::new("set.scaled.xml"));
    }

    #[test]
    fn a_folder_keeps_its_shape() {
        assert_eq!(source("lib/a/x.osim", Some("lib")).below_folder(), Path::new("a/x.osim"));
        assert_eq!(source("lib/a/x.osim", None).below_folder(), Path::new("x.osim"));
    }

    #[test]
    fn equal_outputs_are_found_also_but_for_case() {
        let mut ledger = Ledger::default();
        let who = "a model";
        ledger.read(Path::new("in/a.osim"));
        assert!(ledger.write(Path::new("out/X.osim"), who).is_ok());
        assert!(ledger.write(Path::new("out/x.osim"), who).is_err());
        assert!(ledger.write(Path::new("out/../in/a.osim"), who).is_err());
        assert!(ledger.change(Path::new("in/a.osim"), who.into()).is_ok());
        assert!(ledger.change(Path::new("in/A.osim"), who.into()).is_err());
        ledger.read_again(Path::new("in/b.osim"));
        ledger.read_again(Path::new("./in/b.osim"));
        assert!(ledger.change(Path::new("in/b.osim"), who.into()).is_err());
    }
}
