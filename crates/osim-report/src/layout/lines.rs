//! Text in lines.

use textwrap::{Options, WordSeparator, WordSplitter};

use super::words;

/// Columns of an old terminal.
pub const WIDTH: usize = 80;

/// How text is broken into lines of at most [`WIDTH`] columns: so that they are about equally long.
pub(crate) fn options<'o>() -> Options<'o> {
    Options::new(WIDTH).word_separator(WordSeparator::Custom(words::find))
}

/// Text in lines of at most [`WIDTH`] columns.
pub(crate) fn filled(text: &str) -> String {
    textwrap::fill(text, options())
}

/// Text in lines of at most [`WIDTH`] columns, the second and later ones after `indent`.
#[must_use]
pub fn wrapped(text: &str, indent: &str) -> String {
    // Options of a command line are never broken at their hyphens.
    let options =
        options().subsequent_indent(indent).break_words(false).word_splitter(WordSplitter::NoHyphenation);
    format!("{}\n", textwrap::fill(text, options))
}
