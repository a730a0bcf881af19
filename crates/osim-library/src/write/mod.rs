//! Writes files so that no file is ever left half written, and none is lost.

#[cfg(target_os = "linux")]
mod access_list;
pub(crate) mod exchange;
mod in_place;
mod replace;
pub(crate) mod temporary;

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use osim_model::Finding;
use osim_planning::rules::compiled_model_beside;

use crate::Result;
use crate::paths::{folder_of, resolved};

pub(crate) use in_place::{ExchangedModel, ReplacementFile, hard_link_finding};
pub(crate) use replace::prepare_backup;
pub use replace::{PendingFile, WriteMode};

/// Writes several files. None gets its name before all are complete.
///
/// # Errors
/// A file exists and may not be replaced, or cannot be written.
pub fn write_files<'f>(files: impl IntoIterator<Item = (&'f Path, &'f [u8])>, mode: WriteMode) -> Result<()> {
    let pending = files.into_iter().map(|(path, bytes)| PendingFile::new(path, bytes, None, mode));
    let pending: Vec<PendingFile> = pending.collect::<Result<_, _>>()?;
    pending.into_iter().try_for_each(PendingFile::commit)
}

/// What the output folders had when the run began: compiled models, which other programs would use instead of the results, and files that
/// a killed run left.
#[derive(Debug, Default)]
pub struct OutputFolders {
    compiled_names: HashMap<PathBuf, Vec<String>>,
    /// Old files that a killed run in place displaced.
    displaced: Vec<PathBuf>,
}

impl OutputFolders {
    /// Lists the folder of every output. With `tidy`, temporary files of killed processes are removed.
    pub fn list<'p>(outputs: impl Iterator<Item = &'p Path>, tidy: bool) -> Self {
        let mut folders = Self::default();
        for output in outputs {
            folders.list_folder(folder_of(output), tidy);
            // If the output is a link, the file that it leads to is replaced.
            if tidy && output.is_symlink() {
                folders.list_folder(folder_of(&resolved(output)), tidy);
            }
        }
        folders
    }

    /// Lists a folder, unless it was listed already.
    fn list_folder(&mut self, folder: &Path, tidy: bool) {
        if !self.compiled_names.contains_key(folder) {
            let compiled_names = self.list_compiled_models(folder, tidy);
            self.compiled_names.insert(folder.to_owned(), compiled_names);
        }
    }

    /// Names in `folder` that may be compiled models; empty if the folder does not exist yet or cannot be read.
    fn list_compiled_models(&mut self, folder: &Path, tidy: bool) -> Vec<String> {
        let mut compiled_names = Vec::new();
        for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
            let name = entry.file_name();
            if name.as_encoded_bytes().starts_with(b"F_") {
                compiled_names.push(name.to_string_lossy().into_owned());
            } else if tidy && temporary::is_left_over(folder, &name) {
                // If the file may not be removed, the folder may not be written, and the user gets that error later.
                drop(std::fs::remove_file(entry.path()));
            } else if tidy && exchange::is_left_over(folder, &name) {
                self.displaced.push(entry.path());
            }
        }
        compiled_names.sort();
        compiled_names
    }

    /// Removes displaced files of killed runs, but keeps files that may be another program's work as further backups. Returns a sentence
    /// for each kept file.
    pub(crate) fn keep_displaced_files(&mut self) -> Vec<String> {
        let keep = |leftover: PathBuf| Some((exchange::settle_leftover(&leftover)?, leftover));
        let shown = |path: &Path| path.strip_prefix(".").unwrap_or(path).display().to_string();
        let line = |(kept, leftover): (PathBuf, PathBuf)| {
            let (leftover, kept) = (shown(&leftover), shown(&kept));
            format!(
                "{leftover} was left by a run that was killed and may be what another program saved: kept as {kept}"
            )
        };
        self.displaced.drain(..).filter_map(keep).map(line).collect()
    }

    /// The finding that PredSim and OpenCap would use a compiled file instead of the model `output`.
    pub(crate) fn compiled_model_beside_output(&self, output: &Path) -> Option<Finding> {
        let compiled_names =
            self.compiled_names.get(folder_of(output)).filter(|compiled_names| !compiled_names.is_empty())?;
        let prefix = format!("F_{}.", output.file_stem()?.to_string_lossy());
        // In sorted names, the first one that is not before the prefix begins with it, or no name does.
        let first = compiled_names.partition_point(|name| *name < prefix);
        let compiled_name = compiled_names.get(first).filter(|name| name.starts_with(&prefix))?;
        Some(compiled_model_beside(&folder_of(output).join(compiled_name)))
    }
}
