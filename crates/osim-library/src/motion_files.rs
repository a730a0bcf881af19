//! The files of a motion: ground reactions, and the corrected motion.

use std::path::{Path, PathBuf};

use osim_model::messages::{Input, phrase};
use osim_planning::{MotionResult, NextModels};
use osim_requests::MotionRequest;
use osim_view::report::results::{
    MOCO_FILES, NMSM_FILES, corrected_files, external_loads_xml, ground_reactions_sto, moco_files, nmsm_files,
};

use crate::paths::{make_folder_of, require_folder_of};
use crate::run::PathConflicts;
use crate::write::{WriteMode, write_files};
use crate::{LibraryFault, Result};

/// The files that a request for a motion names.
pub struct MotionFiles {
    /// The model's ground reactions and their `ExternalLoads`; the corrected motion, and the moved plates and their `ExternalLoads`, which
    /// a treadmill needs.
    paths: Vec<Option<PathBuf>>,
    /// Files in the folders for Moco and for NMSM.
    moco: Vec<PathBuf>,
    nmsm: Vec<PathBuf>,
    mode: WriteMode,
}

/// What messages call the files of a motion, in the order of `paths`.
const NAMES_OF_OUTPUTS: [&str; 5] = [
    "the ground reactions",
    "their ExternalLoads",
    "the corrected motion",
    "its plates",
    "the loads of its plates",
];

impl MotionFiles {
    /// The files that the request names, checked before anything is computed.
    ///
    /// # Errors
    /// A name does not have the ending of a table, or is the name of a file that is read.
    pub fn of(request: &MotionRequest) -> Result<Self> {
        let is_table = |path: &Path| {
            path.extension()
                .is_some_and(|ending| ["sto", "mot"].iter().any(|known| ending.eq_ignore_ascii_case(known)))
        };
        let (output, correct) = (request.output.as_deref(), request.correct.as_deref());
        for (input, path) in [(Input::Output, output), (Input::Correct, correct)] {
            if let Some(path) = path.filter(|path| !is_table(path)) {
                let path = path.display().to_string();
                let why = phrase!["{} '{}': expected a name that ends in .sto or .mot"; input, path];
                return Err(LibraryFault::new(why));
            }
            let folders = [&request.moco, &request.nmsm].into_iter().flatten().map(PathBuf::as_path);
            path.map_or(Ok(()), |path| require_folder_of(path, folders))?;
        }
        let with = |path: Option<&Path>, ending: &str| path.map(|path| path.with_extension(ending));
        let own = |path: Option<&Path>| path.map(Path::to_owned);
        let plates = [with(correct, "plates.sto"), with(correct, "plates.xml")];
        let paths = [[own(output), with(output, "xml"), own(correct)].as_slice(), &plates].concat();
        let mut conflicts = PathConflicts::default();
        let read = [&request.subject, &request.motion, &request.plates, &request.loads];
        for path in read.into_iter().flatten().chain(request.set_files.paths()) {
            conflicts.add_input(path);
        }
        for (path, owner) in paths.iter().zip(NAMES_OF_OUTPUTS) {
            path.iter().try_for_each(|path| conflicts.add_output(path, owner))?;
        }
        let in_folder = |folder: &Option<PathBuf>, names: &[&str]| -> Vec<PathBuf> {
            folder.iter().flat_map(|folder| names.iter().map(move |name| folder.join(name))).collect()
        };
        let (moco, nmsm) = (in_folder(&request.moco, &MOCO_FILES), in_folder(&request.nmsm, &NMSM_FILES));
        moco.iter().try_for_each(|path| conflicts.add_output(path, "the folder for Moco"))?;
        nmsm.iter().try_for_each(|path| conflicts.add_output(path, "the folder for NMSM"))?;
        let named = paths.iter().zip([Input::Output, Input::Output, Input::Correct]);
        let named = named.filter_map(|(path, option)| Some((path.as_ref()?, option)));
        let in_folders = moco.iter().map(|path| (path, Input::Moco));
        let in_folders = in_folders.chain(nmsm.iter().map(|path| (path, Input::Nmsm)));
        let mut existing = named.chain(in_folders).filter(|(path, _)| path.exists());
        if let Some((path, option)) = existing.next().filter(|_| !request.force) {
            return Err(LibraryFault::file_exists(path, option));
        }
        let mode = if request.force { WriteMode::Replace } else { WriteMode::New };
        Ok(Self { paths, moco, nmsm, mode })
    }

    /// Writes the files and returns their paths, with the models `next` in the folders. Plates are written for a treadmill only.
    ///
    /// # Errors
    /// As [`write_files`].
    pub fn write(&self, result: &MotionResult, next: &NextModels) -> Result<Vec<PathBuf>> {
        let name = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let mut files: Vec<(PathBuf, String)> = Vec::new();
        if let [Some(table), Some(loads), ..] = self.paths.as_slice() {
            files.push((table.clone(), ground_reactions_sto(result, &name(table))));
            files.push((loads.clone(), external_loads_xml(result, &name(table))));
        }
        if let Some(Some(motion)) = self.paths.get(2) {
            files.extend(corrected_files(result, motion));
        }
        let mut files: Vec<(PathBuf, Vec<u8>)> =
            files.into_iter().map(|(path, text)| (path, text.into_bytes())).collect();
        let folders = self
            .moco
            .iter()
            .zip(moco_files(result, next))
            .chain(self.nmsm.iter().zip(nmsm_files(result, next)));
        for (path, text) in folders {
            make_folder_of(path)?;
            files.push((path.clone(), text));
        }
        // All are complete before the first gets its name.
        write_files(files.iter().map(|(path, bytes)| (path.as_path(), bytes.as_slice())), self.mode)?;
        Ok(files.into_iter().map(|(path, _)| path).collect())
    }
}
