//! The extent of a text (brief or full), its width and its colours.

use osim_model::messages::{listed, shortest, shown_whole};

use crate::report::layout::{Colour, WIDTH, shorten, wrapped};

/// The amount of detail in a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Extent {
    /// Rounded numbers, the first names of a long list, and explanations of the faults that have to be corrected.
    #[default]
    Brief,
    /// All explanations, rows, names and digits.
    Full,
}

impl Extent {
    /// [`Extent::Full`] if the caller asked for a full text.
    pub const fn new(full: bool) -> Self {
        if full { Self::Full } else { Self::Brief }
    }

    pub const fn is_full(self) -> bool {
        matches!(self, Self::Full)
    }

    /// The number as `rounded` writes it; in full, the shortest digits that read back to the same number.
    pub(crate) fn number(self, value: f64, rounded: impl FnOnce(f64) -> String) -> String {
        if self.is_full() { shortest(value) } else { rounded(value) }
    }

    /// The first `most` names and the number of the others; in full, all names.
    pub(crate) fn names<S: AsRef<str>>(self, names: &[S], most: usize) -> String {
        listed(names, if self.is_full() { names.len() } else { most })
    }

    /// The name, cut to at most `width` columns; in full, the whole name.
    pub(crate) fn name(self, name: &str, width: usize) -> String {
        if self.is_full() { shown_whole(name).to_string() } else { shorten(name, width) }
    }
}

/// The layout of a text: its extent, width and colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Layout {
    /// Columns of the terminal; `None` for files and pipes, where the width of a table has no limit.
    pub columns: Option<usize>,
    pub colour: Colour,
    pub extent: Extent,
}

impl Layout {
    /// The width of a line of text in columns.
    pub(crate) fn width(self) -> usize {
        self.columns.unwrap_or(WIDTH)
    }

    /// The text in lines. The second and later lines begin with `indent`. Line ends in the text are escaped.
    pub(crate) fn wrapped(self, text: &str, indent: &str) -> String {
        wrapped(text, indent, self.width())
    }
}
