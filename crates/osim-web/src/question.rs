//! What the page may ask.

use serde::Deserialize;
use serde_json::{Map, Value};

/// The fields of a request, as `schemas/requests/` has them.
pub(crate) type Fields = Map<String, Value>;

/// A question of the page, in JSON: `{"do": "look", "model": "human.osim"}`.
#[derive(Debug, Deserialize)]
#[serde(tag = "do", rename_all = "lowercase", deny_unknown_fields)]
pub enum Question {
    /// What is in a model, and what is wrong with it.
    Look {
        /// Its file.
        model: String,
        /// Fields of a request to inspect; with `from`, of one to check.
        #[serde(default)]
        fields: Fields,
        /// The sections to make; `None` for all.
        #[serde(default)]
        parts: Option<Vec<String>>,
    },
    /// The bones of a model, as surfaces.
    Bones {
        /// Its file.
        model: String,
        /// Fields of a request to inspect.
        #[serde(default)]
        fields: Fields,
    },
    /// The model along a recording, frame by frame.
    Play {
        /// Its request: a motion, its plates.
        request: Fields,
    },
    /// What a change would do to one model. It is kept as the last change.
    Change {
        /// Its request, with its verb and one model.
        request: Fields,
        /// The sections to make; `None` for all.
        #[serde(default)]
        parts: Option<Vec<String>>,
    },
    /// The lines that the last change changes.
    Diff,
    /// Keep the files of the last change under their names.
    Keep,
    /// The report about a change, or about a model that is inspected.
    Report {
        /// Its request.
        request: Fields,
    },
    /// What `design` computes without a model.
    Calculate {
        /// Its request.
        request: Fields,
    },
    /// A request as calls that people can copy.
    Spell {
        /// The request.
        request: Fields,
    },
    /// Animals that fall on the contacts of a human, and on their own.
    Animals,
    /// An equation, a quantity or a code.
    Explain {
        /// Its number, name or code.
        topic: String,
    },
    /// The presets there are.
    Presets {
        /// Fields of a request for presets: a file with one's own.
        #[serde(default)]
        fields: Fields,
    },
}
