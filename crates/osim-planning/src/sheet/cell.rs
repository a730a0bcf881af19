//! Text from outside as a cell of a table: no formula, nothing that steers a terminal, and one line.

use std::borrow::Cow;

use osim_model::messages::is_visible;

/// Marks a cell as text, as in spreadsheets themselves.
const TEXT_MARK: char = '\'';
/// How a letter begins that is written as its number.
const ESCAPE: &str = "\\u{";

/// The text as a cell of CSV, from which [`from_cell`] makes the text again.
///
/// Control characters, line ends and marks that turn the direction of writing are `\u{1b}`: those who print the table, with `cat`
/// for example, see them, and each record is one line. A text that would look like that itself begins with `\u{5c}`, which is the
/// `\`. What spreadsheets would run is [`marked`].
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
    match escaped(text) {
        Cow::Borrowed(text) => marked(text),
        Cow::Owned(text) => marked(&text).into_owned().into(),
    }
}

/// A text that is shown already, as a cell of CSV. Spreadsheets run what begins with `=`, `+`, `-`, `@`, a tab or a line end; such a
/// text gets an apostrophe before it. Numbers stay as they are.
///
/// ```
/// use osim_planning::sheet::marked;
///
/// assert_eq!(marked("=1+1"), "'=1+1");
/// assert_eq!(marked("-0.05"), "-0.05");
/// ```
pub fn marked(text: &str) -> Cow<'_, str> {
    match is_formula(text) && text.parse::<f64>().is_err() {
        true => format!("{TEXT_MARK}{text}").into(),
        false => text.into(),
    }
}

/// The text of a cell that [`marked`] wrote.
pub fn unmarked(cell: &str) -> &str {
    cell.strip_prefix(TEXT_MARK).filter(|text| is_formula(text)).unwrap_or(cell)
}

/// The text of a cell that [`cell`] wrote.
pub fn from_cell(cell: &str) -> Cow<'_, str> {
    let text = unmarked(cell);
    let mut pieces = text.split(ESCAPE);
    let first = pieces.next().unwrap_or_default();
    if first.len() == text.len() {
        return text.into();
    }
    let mut out = first.to_owned();
    for piece in pieces {
        if let Some((letter, rest)) = escaped_letter(piece) {
            out.push(letter);
            out.push_str(rest);
        } else {
            out.push_str(ESCAPE);
            out.push_str(piece);
        }
    }
    out.into()
}

/// Whether a spreadsheet would run it, also after marks of its own: what is marked once more can be read back.
fn is_formula(text: &str) -> bool {
    text.trim_start_matches(TEXT_MARK).starts_with(['=', '+', '-', '@', '\t', '\r', '\n'])
}

fn escaped(text: &str) -> Cow<'_, str> {
    if !text.contains(steers) && !text.contains(ESCAPE) {
        return text.into();
    }
    let mut out = String::with_capacity(text.len() + 8);
    for (at, letter) in text.char_indices() {
        let like_ours = || text.get(at..).is_some_and(|rest| rest.starts_with(ESCAPE));
        if steers(letter) || like_ours() {
            out.extend(letter.escape_unicode());
        } else {
            out.push(letter);
        }
    }
    out.into()
}

/// Whether printing a letter does something, such as ending the line or turning the direction of what follows. Other letters that
/// are not seen, such as a no-break space, stay: they belong to the names of files.
fn steers(letter: char) -> bool {
    letter.is_control() || matches!(letter, '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// The letter whose number begins `text`, and what follows; `None` if it is a letter that is never written so.
fn escaped_letter(text: &str) -> Option<(char, &str)> {
    let (digits, rest) = text.split_once('}')?;
    let letter = char::from_u32(u32::from_str_radix(digits, 16).ok()?)?;
    (letter == '\\' || !is_visible(letter)).then_some((letter, rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_text_begins_like_a_formula_and_all_read_back() {
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
    fn nothing_in_a_cell_steers_a_terminal_and_all_read_back() {
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
    fn names_that_steer_nothing_stay_as_they_are() {
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
