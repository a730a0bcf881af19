//! Shows text from files and users so that it can do no harm in a terminal.
//!
//! Names in a model, file names and table cells can contain anything: escape sequences that recolour or clear a terminal, line ends that
//! imitate a line of this program, letters that reverse the direction of writing, megabytes of text. Messages never contain such text
//! unchanged. Only people read it: JSON and tables for programs have the whole text.

use std::borrow::Cow;
use std::fmt::{self, Display, Write};
use std::path::Path;

/// Most letters of a text from a file that a message shows.
pub(crate) const MOST_LETTERS_SHOWN: usize = 200;

/// Most letters of a sentence that contains names of several forces and files. No system has longer paths.
const MOST_LETTERS_OF_SENTENCE: usize = 5000;

/// Letters at the end of a shortened text that are kept: names often differ at the end.
const LETTERS_KEPT_AT_END: usize = 40;

/// Displays a text from a file on one line. Letters that are invisible or control a terminal (control characters, line ends, letters that
/// reverse the direction of writing, unusual blanks) become `\n` or `\u{1b}`. Of a long text, only the beginning and the end are shown.
///
/// ```
/// use osim_model::messages::shown;
///
/// assert_eq!(shown("heel_r").to_string(), "heel_r");
/// assert_eq!(shown("\u{1b}[31mred\n").to_string(), r"\u{1b}[31mred\n");
/// assert!(shown(&"a".repeat(5_000_000)).to_string().len() < 300);
/// ```
#[derive(Clone, Copy)]
pub struct Shown<'t> {
    text: &'t str,
    most: usize,
}

/// Shows `text` on one line in a message, shortened to 200 letters.
pub const fn shown(text: &str) -> Shown<'_> {
    Shown { text, most: MOST_LETTERS_SHOWN }
}

/// Shows `text` on one line, not shortened: for paths that the reader has to find again.
pub const fn shown_whole(text: &str) -> Shown<'_> {
    Shown { text, most: usize::MAX }
}

/// A sentence with names from files on one line, shortened if it is very long.
pub fn one_line(text: String) -> String {
    let plain =
        text.len() <= MOST_LETTERS_OF_SENTENCE && text.bytes().all(|byte| matches!(byte, b' '..=b'~'));
    if plain { text } else { Shown { text: &text, most: MOST_LETTERS_OF_SENTENCE }.to_string() }
}

/// Shows a path on one line, not shortened. Bytes that are not UTF-8 become `�`.
pub fn shown_path(path: &Path) -> String {
    shown_whole(&path.to_string_lossy()).to_string()
}

impl Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Few texts are long: the others are not counted.
        let letters = if self.text.len() <= self.most { 0 } else { self.text.chars().count() };
        if letters <= self.most {
            return write_visible(self.text, f);
        }
        let first: String = self.text.chars().take(self.most.saturating_sub(LETTERS_KEPT_AT_END)).collect();
        let skipped = letters.saturating_sub(LETTERS_KEPT_AT_END);
        let last: String = self.text.chars().skip(skipped).collect();
        write_visible(&first, f)?;
        f.write_str("...")?;
        write_visible(&last, f)?;
        write!(f, " ({letters} letters)")
    }
}

impl fmt::Debug for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\"{self}\"")
    }
}

fn write_visible(text: &str, f: &mut impl Write) -> fmt::Result {
    if text.bytes().all(|byte| matches!(byte, b' '..=b'~')) {
        return f.write_str(text);
    }
    text.chars().try_for_each(|letter| match is_visible(letter) {
        true => f.write_char(letter),
        false => write!(f, "{}", letter.escape_debug()),
    })
}

/// Whether a letter is visible and does not control a terminal. An accent alone counts as visible: it may belong to the letter before it.
pub fn is_visible(letter: char) -> bool {
    if letter.is_ascii() {
        return matches!(letter, ' '..='~');
    }
    let mut bytes = [0; 4];
    let escaped = letter.encode_utf8(&mut bytes).escape_debug().count() > 1;
    // The standard library escapes accents, but not after a letter.
    !escaped || format!("a{letter}").escape_debug().count() == 2
}

/// Makes text of many lines safe for a terminal: control characters from files are escaped; line ends, tabs and no-break spaces are kept.
///
/// [`shown`] has already escaped names. This function is the last check, for texts in which that was forgotten.
///
/// ```
/// use osim_model::messages::terminal_safe;
///
/// assert_eq!(terminal_safe("a\tb\r\nc\n"), "a\tb\r\nc\n");
/// assert_eq!(terminal_safe("\u{1b}]0;title\u{7}"), r"\u{1b}]0;title\u{7}");
/// ```
pub fn terminal_safe(text: &str) -> Cow<'_, str> {
    if text.bytes().all(|byte| matches!(byte, b' '..=b'~' | b'\n' | b'\t')) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len());
    let mut letters = text.chars().peekable();
    while let Some(letter) = letters.next() {
        let ends_line = letter == '\r' && letters.peek() == Some(&'\n');
        if ends_line || matches!(letter, '\n' | '\t' | '\u{a0}') || is_visible(letter) {
            out.push(letter);
        } else {
            out.extend(letter.escape_debug());
        }
    }
    Cow::Owned(out)
}

/// The first `most` of `names`, and the number of further names, so that a message stays readable.
///
/// ```
/// use osim_model::messages::listed;
///
/// assert_eq!(listed(&["heel_r", "heel_l", "toe_r"], 2), "heel_r, heel_l and 1 more");
/// assert_eq!(listed(&["heel_r", "heel_l"], 2), "heel_r, heel_l");
/// ```
pub fn listed<S: AsRef<str>>(names: &[S], most: usize) -> String {
    let first = names.iter().take(most).map(AsRef::as_ref).collect::<Vec<_>>().join(", ");
    match names.len().saturating_sub(most) {
        0 => first,
        more => format!("{first} and {more} more"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_of_all_languages_stay_as_they_are() {
        for text in ["heel_r", "Ferse (rechts), 5 N/m²", "左足", "x̂ = x / R", "E₁*", "Füße", "\"'\\"]
        {
            assert_eq!(shown(text).to_string(), text);
            assert_eq!(terminal_safe(text), text);
        }
    }

    #[test]
    fn nothing_that_steers_a_terminal_or_turns_a_line_is_printed() {
        // ESC, C1's CSI, bell, backspace, line and paragraph separators, direction marks, zero width, byte order mark.
        let hostile =
            "\u{1b}\u{9b}\u{7}\u{8}\u{2028}\u{2029}\u{202e}\u{2066}\u{200f}\u{200b}\u{feff}\u{7f}\r\n\0";
        for printed in [shown(hostile).to_string(), shown_whole(hostile).to_string()] {
            assert!(printed.bytes().all(|byte| matches!(byte, b' '..=b'~')), "{printed:?}");
        }
        assert_eq!(terminal_safe(hostile).matches(|letter: char| !matches!(letter, ' '..='~')).count(), 2);
    }

    /// Tables of this program use a no-break space between a number and its mark. In a name it would look like an ordinary blank.
    #[test]
    fn a_no_break_space_stays_in_text_and_is_escaped_in_a_name() {
        assert_eq!(terminal_safe("0.3533\u{a0}!"), "0.3533\u{a0}!");
        assert_eq!(shown("heel\u{a0}r").to_string(), r"heel\u{a0}r");
    }

    #[test]
    fn a_long_text_shows_both_ends_and_its_length() {
        let text = format!("begin{}end", "ä".repeat(1000));
        let printed = shown(&text).to_string();
        assert!(printed.starts_with("beginä") && printed.ends_with("end (1008 letters)"), "{printed}");
        assert!(printed.chars().count() < MOST_LETTERS_SHOWN + 30);
        assert_eq!(shown_whole(&text).to_string(), text);
        let just = "ä".repeat(MOST_LETTERS_SHOWN);
        assert_eq!(shown(&just).to_string(), just);
    }

    #[test]
    fn messages_show_paths_whole() {
        let path = format!("{}\u{1b}.osim", "folder/".repeat(100));
        assert_eq!(shown_path(Path::new(&path)), path.replace('\u{1b}', r"\u{1b}"));
    }
}
