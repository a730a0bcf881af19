//! Outputs and inputs of a whole run, compared before anything is written.

use std::borrow::Cow;
use std::collections::HashMap;
use std::ffi::OsString;
use std::fmt;
use std::path::Path;

use osim_model::messages::{Input, Phrase, phrase};

use crate::digest::{self, NameDigest};
use crate::fault::LibraryFault;
use crate::paths::Resolver;

/// For whom a file is written.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
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

    /// The same of a file that would be another one if it were changed before it is read for this model.
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
        digest::of_name(&name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
