//! What is done with a model, apart from the model.

use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

use osim_model::files::Files;
use osim_planning::Planner;
use osim_requests::NoteDetails;
use osim_requests::options::{OutputOptions, SetFiles};

use crate::digest::sha256;
use crate::source::OrdinaryFiles;

/// What is done with a model: shared by all models of a call, or by like rows of a manifest.
pub(super) struct JobSettings {
    planner: Arc<dyn Planner>,
    pub(super) set_files: SetFiles,
    pub(super) in_place: bool,
    pub(super) no_backup: bool,
    pub(super) force: bool,
    no_note: bool,
    details: NoteDetails,
    digest: OnceLock<String>,
}

impl JobSettings {
    /// What `planner` plans and notes say, written as `output` says.
    pub(super) fn new(
        planner: Arc<dyn Planner>,
        set_files: SetFiles,
        details: NoteDetails,
        output: &OutputOptions,
    ) -> Self {
        Self {
            planner,
            set_files,
            details,
            in_place: output.in_place,
            no_backup: output.no_backup,
            force: output.force,
            no_note: output.no_note,
            digest: OnceLock::new(),
        }
    }

    pub(super) fn planner(&self) -> &dyn Planner {
        self.planner.as_ref()
    }

    /// What notes say of the request; `None` where there are to be none.
    pub(super) fn details(&self) -> Option<&NoteDetails> {
        Some(&self.details).filter(|_| !self.no_note)
    }

    /// Files that are read beside the models.
    pub(super) fn reads(&self) -> Vec<PathBuf> {
        self.set_files.paths().cloned().chain(self.planner.reads()).collect()
    }

    /// Digest of everything an output follows from except the model itself.
    pub(super) fn digest(&self) -> &str {
        self.digest.get_or_init(|| {
            let mut text = format!("{}\nno note: {}\n", self.planner.settings(), self.no_note);
            for path in self.reads() {
                // What cannot be read fails later, with its name; a pipe can be read once only.
                let digest = OrdinaryFiles.read(&path).map(|bytes| sha256(&bytes)).unwrap_or_default();
                text.push_str(&format!("{digest}\n"));
            }
            sha256(text.as_bytes())
        })
    }
}
