//! Text from outside as a cell of a table, which spreadsheets must not take for a formula.

use std::borrow::Cow;

/// Marks a cell as text, as in spreadsheets themselves.
const TEXT_MARK: char = '\'';

/// The text as a cell of CSV. Spreadsheets run what begins with `=`, `+`, `-`, `@`, a tab or a line end; such a text gets an
/// apostrophe before it. Numbers stay as they are.
///
/// ```
/// use osim_requests::{cell, from_cell};
///
/// assert_eq!(cell("=HYPERLINK(\"http://a.example\")"), "'=HYPERLINK(\"http://a.example\")");
/// assert_eq!(from_cell("'=HYPERLINK(\"http://a.example\")"), "=HYPERLINK(\"http://a.example\")");
/// assert_eq!(cell("-0.05"), "-0.05");
/// assert_eq!(cell("heel_r"), "heel_r");
/// ```
#[must_use]
pub fn cell(text: &str) -> Cow<'_, str> {
    match is_formula(text) && text.parse::<f64>().is_err() {
        true => format!("{TEXT_MARK}{text}").into(),
        false => text.into(),
    }
}

/// The text of a cell that [`cell`] wrote.
#[must_use]
pub fn from_cell(cell: &str) -> &str {
    cell.strip_prefix(TEXT_MARK).filter(|text| is_formula(text)).unwrap_or(cell)
}

/// Whether a spreadsheet would run it, also after marks of its own: what is marked once more can be read back.
fn is_formula(text: &str) -> bool {
    text.trim_start_matches(TEXT_MARK).starts_with(['=', '+', '-', '@', '\t', '\r', '\n'])
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
}
