//! A cell of the table of models.

/// A cell of the table of models.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Cell {
    pub(super) text: String,
    /// A second line: the factor below old and new values.
    pub(super) below: String,
    /// A figure outside its limit.
    pub(super) outside: bool,
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self { text, ..Self::default() }
    }
}
