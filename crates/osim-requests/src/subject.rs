//! What drops and figures are about: a model, or a preset.

use std::path::Path;

use contact_scaling::Preset;
use osim_model::files::{Files, OpenModel};

use crate::fault::RequestError;
use crate::opening::open_with;
use crate::options::SetFiles;
use crate::presets::{find_preset, refuse_unknown_name};

/// A model, or a preset.
pub(crate) enum Subject {
    Model(Box<OpenModel>),
    Preset(Preset),
}

impl Subject {
    /// The preset of this name, else the model.
    ///
    /// # Errors
    /// There is neither, or the model cannot be read.
    pub(crate) fn find(
        path: &Path,
        presets: Option<&Path>,
        set_files: &SetFiles,
        files: &dyn Files,
    ) -> Result<Self, RequestError> {
        if let Some(preset) = find_preset(path, presets, files)? {
            return Ok(Self::Preset(preset));
        }
        refuse_unknown_name(path, presets, files)?;
        Ok(Self::Model(Box::new(open_with(path, set_files.beside(), files)?)))
    }
}
