//! The folders that a run writes into, looked at once and not once per model.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use osim_model::Finding;
use osim_planning::rules::compiled_model_beside;

use crate::fault::{Context, LibraryFault};
use crate::paths::{folder_of, resolved};
use crate::write::{replaced, temporary};

/// What was in the folders when the run began.
#[derive(Debug, Default)]
pub struct Folders {
    compiled: HashMap<PathBuf, Vec<String>>,
    /// What a process left that was killed while it changed a model itself.
    replaced: Vec<PathBuf>,
}

impl Folders {
    /// Lists the folder of every output. With `tidy`, files that processes left behind when they were killed go.
    pub fn list<'p>(outputs: impl Iterator<Item = &'p Path>, tidy: bool) -> Self {
        let mut folders = Self::default();
        for output in outputs {
            folders.list_one(folder_of(output), tidy);
            // A file is replaced where it really is.
            if tidy && output.is_symlink() {
                folders.list_one(folder_of(&resolved(output)), tidy);
            }
        }
        folders
    }

    fn list_one(&mut self, folder: &Path, tidy: bool) {
        if !self.compiled.contains_key(folder) {
            let compiled = self.names_of_compiled(folder, tidy);
            self.compiled.insert(folder.to_owned(), compiled);
        }
    }

    /// Names in `folder` that may be compiled models; empty if it does not exist yet or cannot be read.
    fn names_of_compiled(&mut self, folder: &Path, tidy: bool) -> Vec<String> {
        let mut compiled = Vec::new();
        for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
            let name = entry.file_name();
            if name.as_encoded_bytes().starts_with(b"F_") {
                compiled.push(name.to_string_lossy().into_owned());
            } else if tidy && temporary::is_left_over(folder, &name) {
                // A user who may not remove it may not write here either, and gets that error.
                drop(std::fs::remove_file(entry.path()));
            } else if tidy && replaced::is_left_over(folder, &name) {
                self.replaced.push(entry.path());
            }
        }
        compiled.sort();
        compiled
    }

    /// Looks at what a process left that was killed while it changed a model itself. What may be another program's work becomes a
    /// further backup: a line for each.
    pub(crate) fn settle_replaced(&mut self) -> Vec<String> {
        let kept = |left: PathBuf| Some((replaced::settle(&left)?, left));
        let shown = |path: &Path| path.strip_prefix(".").unwrap_or(path).display().to_string();
        let line = |(kept, left): (PathBuf, PathBuf)| {
            let (left, kept) = (shown(&left), shown(&kept));
            format!(
                "{left} was left by a run that was killed and may be what another program saved: kept as {kept}"
            )
        };
        self.replaced.drain(..).filter_map(kept).map(line).collect()
    }

    /// A compiled copy of the model `output`, which PredSim and OpenCap would go on using.
    pub(crate) fn compiled_beside(&self, output: &Path) -> Option<Finding> {
        let compiled = self.compiled.get(folder_of(output)).filter(|compiled| !compiled.is_empty())?;
        let prefix = format!("F_{}.", output.file_stem()?.to_string_lossy());
        // The names are sorted: the first that is not before the prefix has it, or none does.
        let first = compiled.partition_point(|name| *name < prefix);
        let found = compiled.get(first).filter(|name| name.starts_with(&prefix))?;
        Some(compiled_model_beside(&folder_of(output).join(found)))
    }
}

/// Makes the folder of `path`, with those above it.
pub fn make_folder_of(path: &Path) -> Result<(), LibraryFault> {
    if folder_of(path).is_dir() {
        return Ok(());
    }
    let cannot = || format!("cannot make the folder {}", folder_of(path).display());
    match resolved(path).parent() {
        Some(folder) => std::fs::create_dir_all(folder).context(cannot),
        None => Ok(()),
    }
}
