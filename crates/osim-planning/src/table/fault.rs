//! What is wrong with a row, and in which column.

use osim_model::messages::Phrase;

/// What is wrong with a row, and in which column.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct RowFault {
    /// Header of the column, where it is about one.
    pub column: Option<String>,
    /// What is wrong, and what to do.
    pub message: Phrase,
}

impl RowFault {
    /// A fault in a column.
    pub fn of(column: &str, message: impl Into<Phrase>) -> Self {
        Self { column: Some(column.to_owned()), message: message.into() }
    }

    /// A fault of the whole row.
    pub fn general(message: impl Into<Phrase>) -> Self {
        Self { column: None, message: message.into() }
    }
}
