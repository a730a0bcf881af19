//! How much of what is known a text shows, and how wide and colourful it is.

use osim_model::messages::{listed, shortest, shown_whole};

use crate::report::layout::{Colour, WIDTH, clipped, wrapped};

/// How much a text of a result shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Extent {
    /// Rounded numbers, the first names of a long list, and explanations of what has to be put right.
    #[default]
    Brief,
    /// The text shows all explanations, rows, names and digits.
    Full,
}

impl Extent {
    /// [`Extent::Full`] if `full` was asked for.
    pub const fn new(full: bool) -> Self {
        if full { Self::Full } else { Self::Brief }
    }

    pub const fn is_full(self) -> bool {
        matches!(self, Self::Full)
    }

    /// `value` as `rounded` writes it; in full the shortest digits that read back to the same number.
    pub(crate) fn number(self, value: f64, rounded: impl FnOnce(f64) -> String) -> String {
        if self.is_full() { shortest(value) } else { rounded(value) }
    }

    /// The first `most` names and how many more there are; in full all names.
    pub(crate) fn names<S: AsRef<str>>(self, names: &[S], most: usize) -> String {
        listed(names, if self.is_full() { names.len() } else { most })
    }

    /// A name in at most `width` columns; in full all of it.
    pub(crate) fn name(self, name: &str, width: usize) -> String {
        if self.is_full() { shown_whole(name).to_string() } else { clipped(name, width) }
    }
}

/// How a text is laid out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Layout {
    /// Columns of the terminal; `None` for files and pipes, where a table is as wide as it is.
    pub columns: Option<usize>,
    pub colour: Colour,
    pub extent: Extent,
}

impl Layout {
    /// Columns of a line of text.
    pub(crate) fn width(self) -> usize {
        self.columns.unwrap_or(WIDTH)
    }

    /// Text in lines, the second and later ones after `indent`. Line ends in it are escaped.
    pub(crate) fn wrapped(self, text: &str, indent: &str) -> String {
        wrapped(text, indent, self.width())
    }
}
