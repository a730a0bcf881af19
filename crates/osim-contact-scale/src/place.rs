//! Where results go, decided and checked for all models before anything is written.

use std::collections::HashMap;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

use anyhow::{Result, bail};

use crate::args::OutputArgs;
use crate::paths::resolved;
use crate::sources::{OUTPUT_MARK, Source};

/// Where one model's result goes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Place {
    /// Standard output.
    Stdout,
    /// A file of its own.
    File(PathBuf),
    /// The model itself.
    Itself(PathBuf),
}

impl Place {
    pub(crate) fn path(&self) -> Option<&Path> {
        match self {
            Self::Stdout => None,
            Self::File(path) | Self::Itself(path) => Some(path),
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
        return Place::Itself(source.path.clone());
    }
    match &output.output_dir {
        Some(folder) => Place::File(folder.join(relative(source))),
        None => Place::File(beside(&source.path)),
    }
}

/// A file goes to DIR/its name, a folder's files to DIR/their path below that folder.
fn relative(source: &Source) -> PathBuf {
    let below = source.folder.as_ref().and_then(|folder| source.path.strip_prefix(folder).ok());
    match below {
        Some(path) => path.to_owned(),
        None => source.path.file_name().map(PathBuf::from).unwrap_or_default(),
    }
}

/// Outputs and inputs of a whole run, compared before anything is written.
#[derive(Debug, Default)]
pub(crate) struct Ledger {
    inputs: HashMap<PathBuf, String>,
    outputs: HashMap<OsString, String>,
}

impl Ledger {
    /// A file that is read: nothing may be written over it.
    pub(crate) fn read(&mut self, path: &Path) {
        if path.as_os_str() != "-" {
            self.inputs.insert(resolved(path), path.display().to_string());
        }
    }

    /// A file that is to be written for `source`.
    ///
    /// # Errors
    /// Another model has that output (also where only letters' case differs: Windows and macOS see one file there), or
    /// it is one of the files that are read.
    pub(crate) fn write(&mut self, path: &Path, source: &str) -> Result<()> {
        let real = resolved(path);
        if let Some(input) = self.inputs.get(&real) {
            bail!(
                "the output {} is an input of this run ({input}): choose another name, or change it with --in-place",
                path.display()
            );
        }
        let key = real.as_os_str().to_string_lossy().to_lowercase().into();
        if let Some(other) = self.outputs.insert(key, source.to_owned()) {
            bail!(
                "{other} and {source} would both be written to {}: give them different names or folders",
                path.display()
            );
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn source(path: &str, folder: Option<&str>) -> Source {
        Source { path: path.into(), folder: folder.map(Into::into) }
    }

    #[test]
    fn the_default_is_a_new_file_beside_the_model() {
        assert_eq!(beside(Path::new("a/human.osim")), Path::new("a/human.scaled.osim"));
        assert_eq!(beside(Path::new("set.xml")), Path::new("set.scaled.xml"));
    }

    #[test]
    fn a_folder_keeps_its_shape() {
        assert_eq!(relative(&source("lib/a/x.osim", Some("lib"))), Path::new("a/x.osim"));
        assert_eq!(relative(&source("lib/a/x.osim", None)), Path::new("x.osim"));
    }

    #[test]
    fn equal_outputs_are_found_also_but_for_case() {
        let mut ledger = Ledger::default();
        ledger.read(Path::new("in/a.osim"));
        assert!(ledger.write(Path::new("out/X.osim"), "a").is_ok());
        assert!(ledger.write(Path::new("out/x.osim"), "b").is_err());
        assert!(ledger.write(Path::new("out/../in/a.osim"), "c").is_err());
    }
}
