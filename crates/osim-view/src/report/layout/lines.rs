//! Text in lines.

use osim_model::messages::{shown, shown_whole};
use textwrap::{Options, WordSeparator, WordSplitter};

use super::words;

/// Columns of an old terminal.
pub const WIDTH: usize = 80;

/// How text is broken into lines of at most [`WIDTH`] columns: so that they are about equally long.
pub(crate) fn options<'o>() -> Options<'o> {
    Options::new(WIDTH).word_separator(WordSeparator::Custom(words::find))
}

/// A paragraph with names from outside in it: no line ends of theirs, and none endless.
fn paragraph(text: &str) -> String {
    text.split(' ').map(|word| shown(word).to_string()).collect::<Vec<_>>().join(" ")
}

/// Text in lines of at most [`WIDTH`] columns. Line ends in it, which are in a name from outside, are escaped.
pub(crate) fn filled(text: &str) -> String {
    textwrap::fill(&paragraph(text), options())
}

/// Text in lines of at most [`WIDTH`] columns, the second and later ones after `indent`. Line ends in it are escaped.
#[must_use]
pub fn wrapped(text: &str, indent: &str) -> String {
    in_lines(&paragraph(text), indent)
}

/// The same for a text about a file: the reader has to find the file again, so its path is shown whole.
pub(crate) fn wrapped_with_path(path: &str, text: &str, indent: &str) -> String {
    in_lines(&format!("{}: {}", shown_whole(path), paragraph(text)), indent)
}

fn in_lines(text: &str, indent: &str) -> String {
    // Options of a command line are never broken at their hyphens.
    let options =
        options().subsequent_indent(indent).break_words(false).word_splitter(WordSplitter::NoHyphenation);
    format!("{}\n", textwrap::fill(text, options))
}
