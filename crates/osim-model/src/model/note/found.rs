//! Where the notes of a document are.

use std::ops::Range;

use super::comment;
use super::credits::Credits;
use super::data::{Note, Unreadable};
use crate::model::document::Document;
use crate::model::fault::Fault;

/// The notes of one document: a model can have one in its credits and one of an earlier version in a comment.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct NotesFound {
    /// In `<credits>`: `Err` where something begins like a note and cannot be read, or does not end the text.
    pub(crate) credits: Option<Result<Note, Unreadable>>,
    /// In a comment before the first child of the data root.
    pub(crate) comment: Option<Result<Note, Unreadable>>,
}

impl NotesFound {
    /// # Errors
    /// Credits that OpenSim refuses.
    pub(crate) fn of(document: &Document) -> Result<Self, Fault> {
        let credits = Credits::of(document)?.and_then(|credits| credits.note());
        Ok(Self { credits, comment: comment::find(document) })
    }
}

impl Note {
    /// The note of `document`: in its credits, else in a comment before the first child of the data root. `None` where there
    /// is none or it cannot be read.
    #[must_use]
    pub fn find(document: &Document) -> Option<Self> {
        let found = NotesFound::of(document).ok()?;
        found.credits.or(found.comment)?.ok()
    }

    /// The bytes of the comments that begin like a note, of this version or an earlier one: the first counts.
    pub fn comment_spans(document: &Document) -> impl Iterator<Item = Range<usize>> + '_ {
        comment::spans(document)
    }
}
