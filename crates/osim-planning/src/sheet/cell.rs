//! Writes any text as a cell of a CSV table: in one line, without control characters, and so that no spreadsheet takes it for a formula.

use std::borrow::Cow;

use osim_model::messages::is_visible;

/// The apostrophe before a cell that spreadsheets have to read as text.
const TEXT_MARK: char = '\'';
/// The beginning of an escape, which writes a letter as its number, such as `\u{1b}`.
const ESCAPE_BEGIN: &str = "\\u{";

/// The text as a cell of CSV; [`from_cell`] reads it back.
///
/// Control characters, line ends and marks that change the direction of writing become escapes such as `\u{1b}`, so that they have
/// no effect in a terminal, and each record is one line. A `\` before something that looks like an escape becomes `\u{5c}`. A text
/// that spreadsheets would run as a formula gets a mark, see [`with_text_mark`].
///
/// ```
/// use osim_planning::sheet::{cell, from_cell};
///
/// assert_eq!(cell("a\u{1b}[2J.osim"), r"a\u{1b}[2J.osim");
/// assert_eq!(from_cell(r"a\u{1b}[2J.osim"), "a\u{1b}[2J.osim");
/// assert_eq!(cell("=HYPERLINK(\"http://a.example\")"), "'=HYPERLINK(\"http://a.example\")");
/// assert_eq!(from_cell("'=HYPERLINK(\"http://a.example\")"), "=HYPERLINK(\"http://a.example\")");
/// assert_eq!(cell(r"C:\models\heel_r.osim"), r"C:\models\heel_r.osim");
/// ```
pub fn cell(text: &str) -> Cow<'_, str> {
    match with_escapes(text) {
        Cow::Borrowed(text) => with_text_mark(text),
        Cow::Owned(text) => with_text_mark(&text).into_owned().into(),
    }
}

/// A text without control characters as a cell of CSV. Spreadsheets run a text that begins with `=`, `+`, `-`, `@`, a tab or a line
/// end as a formula; such a text gets an apostrophe before it. Numbers stay as they are.
///
/// ```
/// use osim_planning::sheet::with_text_mark;
///
/// assert_eq!(with_text_mark("=1+1"), "'=1+1");
/// assert_eq!(with_text_mark("-0.05"), "-0.05");
/// ```
pub fn with_text_mark(text: &str) -> Cow<'_, str> {
    match is_formula(text) && text.parse::<f64>().is_err() {
        true => format!("{TEXT_MARK}{text}").into(),
        false => text.into(),
    }
}

/// The text of a cell that [`with_text_mark`] wrote.
pub fn without_text_mark(cell: &str) -> &str {
    cell.strip_prefix(TEXT_MARK).filter(|text| is_formula(text)).unwrap_or(cell)
}

/// The text of a cell that [`cell`] wrote.
pub fn from_cell(cell: &str) -> Cow<'_, str> {
    let text = without_text_mark(cell);
    let mut pieces = text.split(ESCAPE_BEGIN);
    let first = pieces.next().unwrap_or_default();
    if first.len() == text.len() {
        return text.into();
    }
    let mut out = first.to_owned();
    for piece in pieces {
        if let Some((letter, rest)) = letter_of_escape(piece) {
            out.push(letter);
            out.push_str(rest);
        } else {
            out.push_str(ESCAPE_BEGIN);
            out.push_str(piece);
        }
    }
    out.into()
}

/// Whether a spreadsheet would run the text as a formula if the apostrophes before the text were removed.
fn is_formula(text: &str) -> bool {
    text.trim_start_matches(TEXT_MARK).starts_with(['=', '+', '-', '@', '\t', '\r', '\n'])
}

/// The text with an escape for each letter that controls a terminal.
fn with_escapes(text: &str) -> Cow<'_, str> {
    if !text.contains(controls_terminal) && !text.contains(ESCAPE_BEGIN) {
        return text.into();
    }
    let mut out = String::with_capacity(text.len() + 8);
    for (at, letter) in text.char_indices() {
        let is_like_an_escape = || text.get(at..).is_some_and(|rest| rest.starts_with(ESCAPE_BEGIN));
        if controls_terminal(letter) || is_like_an_escape() {
            out.extend(letter.escape_unicode());
        } else {
            out.push(letter);
        }
    }
    out.into()
}

/// Whether a letter has an effect when it is printed, such as ending the line or changing the direction of writing. Invisible letters
/// without such an effect, for example no-break spaces, do not count, because names of files have them.
fn controls_terminal(letter: char) -> bool {
    letter.is_control() || matches!(letter, '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// The letter that the escape at the beginning of `text` means, and the text after the escape; `None` if this letter is never escaped.
fn letter_of_escape(text: &str) -> Option<(char, &str)> {
    let (digits, rest) = text.split_once('}')?;
    let letter = char::from_u32(u32::from_str_radix(digits, 16).ok()?)?;
    (letter == '\\' || !is_visible(letter)).then_some((letter, rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_cell_is_a_formula_and_all_read_back() {
        for text in [
            "=1+1", "+1+1", "-a", "@SUM(A1)", "\t=1", "\r=1", "\n=1", "-", "'=1", "''=1", "'heel'", "", "a=b",
        ] {
            let written = cell(text);
            assert!(!written.starts_with(['=', '+', '-', '@', '\t', '\r', '\n']), "{written}");
            assert_eq!(from_cell(&written), text);
        }
        for number in ["-0.05", "+3", "1e-5", "-inf"] {
            assert_eq!(cell(number), number);
            assert_eq!(from_cell(number), number);
        }
    }

    #[test]
    fn no_cell_has_control_characters_and_all_read_back() {
        for text in [
            "a\u{1b}[2J",
            "=1\u{7}",
            "'\t=1",
            "two\nlines\r\n",
            "\u{9b}31m\u{7f}\0",
            "\u{202e}turned\u{2066}\u{2028}",
            // What looks like a letter of ours, whole and cut off.
            r"\u{1b}",
            r"\u{5c}u{1b}",
            r"\u{\u{1b}",
            r"\\u{1b",
            r"\u{41}",
            r"\u{}\u{zz}",
            "\\u{\u{1b}}",
        ] {
            let written = cell(text);
            assert!(
                !written.contains(|letter: char| letter.is_control() || letter == '\u{202e}'),
                "{written}"
            );
            assert_eq!(from_cell(&written), text, "{written}");
        }
        assert_eq!(cell("two\nlines\u{202e}"), r"two\u{a}lines\u{202e}");
        assert_eq!(cell(r"\u{1b}"), r"\u{5c}u{1b}");
    }

    #[test]
    fn names_without_control_characters_are_not_escaped() {
        for text in [
            r"C:\new\tab.osim",
            r"\\server\u\a.osim",
            "Füße\u{a0}5 kg",
            "ا\u{200c}ب",
            "左足",
            r"a\u{41}.osim",
        ] {
            let written = cell(text);
            assert!(written == text || text.contains("u{"), "{written}");
            assert_eq!(from_cell(&written), text);
        }
        // Nobody writes a letter that is seen by its number.
        assert_eq!(from_cell(r"a\u{41}.osim"), r"a\u{41}.osim");
        // A letter as messages show it.
        assert_eq!(from_cell(r"Ferse\u{a0}rechts"), "Ferse\u{a0}rechts");
    }
}
