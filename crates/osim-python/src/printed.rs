//! What `inspect` and `check` print: one model in full, several as one table, as the command decides it.

use osim_model::messages::harmless;
use osim_view::report::check::LibraryTable;
use osim_view::report::inspection::ModelsTable;
use osim_view::report::layout::Colour;
use osim_view::report::{check, inspection};

use crate::planned::WORDS;
use crate::seen::Seen;

/// The text of a survey, as far as its models are known.
pub(crate) enum Printed {
    /// Each model by itself.
    InFull(String),
    /// A row for each model that was inspected.
    Models(ModelsTable),
    /// What was found in many models.
    Library(LibraryTable),
}

impl Printed {
    /// The next model.
    pub(crate) fn add(&mut self, seen: &Seen) {
        match (self, seen) {
            (Self::InFull(text), Seen::Inspected(inspected, _)) => {
                let gap = if text.is_empty() { "" } else { "\n" };
                text.push_str(gap);
                text.push_str(&inspection::text(inspected, WORDS, Colour::Plain));
            }
            (Self::InFull(text), Seen::Checked(found, _)) => {
                text.push_str(&check::text(found, WORDS.prompt(), Colour::Plain));
            }
            (Self::Models(table), Seen::Inspected(inspected, counts)) => {
                table.add(inspected, counts.unwrap_or_default());
            }
            (Self::Library(table), Seen::Checked(found, _)) => table.add(found),
            _ => {}
        }
    }

    /// A model that could not be read, by its name.
    pub(crate) fn add_failed(&mut self, model: &str, code: &str) {
        match self {
            Self::Models(table) => table.add_failed(model, code),
            Self::Library(table) => table.add_failed(model, code),
            Self::InFull(_) => {}
        }
    }

    /// All of it. Lines have no end, as in a file: a cell of a notebook can be scrolled.
    pub(crate) fn text(self) -> String {
        let text = match self {
            Self::InFull(text) => text,
            Self::Models(table) => table.text(None, WORDS, Colour::Plain),
            Self::Library(table) => table.text(true, WORDS, Colour::Plain),
        };
        harmless(&text).into_owned()
    }
}
