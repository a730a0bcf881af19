//! Is this word a model or a preset? One rule for all verbs.

use std::path::Path;

use contact_scaling::Preset;
use osim_model::files::{Beside, Failure, Files, InMemory, ModelFiles, OpenModel};
use osim_model::messages::{Input, phrase};
use osim_patch::{preset_model, presets_with_places};
use osim_requests::options::SetFiles;
use osim_requests::{RequestError, RequestFault};

use crate::opening::open_with;
use crate::presets::{find_preset, preset_names};

/// What a word names.
pub(crate) enum Named {
    Preset(Preset),
    /// A preset whose spheres differ in their numbers: a model of ours, which nothing but a model can say.
    Placed(Box<OpenModel>),
    /// A file, which may be missing.
    File,
}

impl Named {
    /// The preset of this name, also where a file is called so; else a file. `input` is the field of the word, for messages.
    ///
    /// # Errors
    /// It can be neither, or the file of presets cannot be read.
    pub(crate) fn find(
        word: &Path,
        input: Option<Input>,
        presets: Option<&Path>,
        files: &dyn Files,
    ) -> Result<Self, RequestError> {
        if let Some(preset) = find_preset(word, presets, files)? {
            return Ok(Self::Preset(preset));
        }
        if let Some(open) = placed_preset(word)? {
            return Ok(Self::Placed(Box::new(open)));
        }
        if may_be_file(word, files) {
            return Ok(Self::File);
        }
        let neither = format!(
            "'{}': there is no such file and no such preset, expected a model or one of: {}",
            word.display(),
            all_names(presets, files)
        );
        let fault = match input {
            Some(input) => RequestFault::refused(input, phrase![input, " ", neither]),
            None => RequestFault::general(neither),
        };
        Err(fault.into())
    }
}

/// The preset of this name that has places, as a model; also where a file is called so.
pub(crate) fn placed_preset(name: &Path) -> Result<Option<OpenModel>, Failure> {
    let Some(text) = name.to_str().and_then(preset_model) else { return Ok(None) };
    ModelFiles::read(name, text.into(), Beside::default(), &InMemory::default())?.open().map(Some)
}

/// All that may be named: presets, and those that only a model can say.
fn all_names(presets: Option<&Path>, files: &dyn Files) -> String {
    let mut names = preset_names(presets, files);
    for name in presets_with_places() {
        if !names.iter().any(|known| known == name) {
            names.push(name.to_owned());
        }
    }
    names.join(", ")
}

/// Whether `word` names a file: it is there, is standard input, or looks like the name of one.
pub fn may_be_file(word: &Path, files: &dyn Files) -> bool {
    files.exists(word) || looks_like_file(word)
}

/// Whether `word` looks like the name of a file, without a look at the files.
pub(crate) fn looks_like_file(word: &Path) -> bool {
    word.as_os_str() == "-" || word.components().count() > 1 || word.extension().is_some()
}

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
        Ok(match Named::find(path, None, presets, files)? {
            Named::Preset(preset) => Self::Preset(preset),
            Named::Placed(open) => Self::Model(open),
            Named::File => Self::Model(Box::new(open_with(path, set_files.beside(), files)?)),
        })
    }
}
