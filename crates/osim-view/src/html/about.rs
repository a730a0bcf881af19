//! What a page is about.

use osim_model::messages::Verb;

use super::models_table::Columns;
use super::values::file_name;

/// What a page is about.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct About {
    /// What was done.
    pub verb: Verb,
    /// The model, where it is one.
    pub model: Option<String>,
    /// Which table the models are in, where they are several.
    pub columns: Columns,
    /// What was asked, as the reader would ask for it again.
    pub asked: String,
}

impl About {
    /// A page about models to which `verb` was done; about one where `model` names it.
    pub fn new(verb: Verb, model: Option<String>, columns: Columns, asked: impl Into<String>) -> Self {
        Self { verb, model, columns, asked: asked.into() }
    }

    pub(super) fn title(&self, models: usize) -> String {
        let what = match self.verb {
            Verb::Rescale => "Rescaled contacts",
            Verb::Transfer => "Transferred contacts",
            Verb::Add => "Added contacts",
            Verb::Convert => "Converted contacts",
            Verb::Remove => "Removed contacts",
            Verb::Design => "Designed contacts",
            Verb::Note => "Noted contacts",
            Verb::Check => "Check of contacts",
            Verb::Inspect => "Contacts",
            _ => "Changed contacts",
        };
        match &self.model {
            Some(model) => format!("{what}: {}", file_name(model)),
            None => format!("{what}: {models} models"),
        }
    }
}
