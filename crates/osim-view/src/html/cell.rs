//! A cell of the table of models.

/// A cell of the table of models.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Cell {
    pub(super) text: String,
    /// A second line: the factor below old and new values.
    pub(super) below: String,
    /// Whether it is a figure outside its limit.
    pub(super) outside: bool,
    /// Whether it has words, not numbers.
    pub(super) words: bool,
}

impl Cell {
    /// Its class in the style sheet.
    pub(super) fn class(&self) -> Option<&'static str> {
        match (self.words, self.outside, self.text.contains(' ')) {
            (true, ..) => Some("words"),
            (false, true, _) => Some("values outside"),
            (false, false, true) => Some("values"),
            (false, false, false) => None,
        }
    }

    pub(super) fn of_words(text: String) -> Self {
        Self { text, words: true, ..Self::default() }
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self { text, ..Self::default() }
    }
}
