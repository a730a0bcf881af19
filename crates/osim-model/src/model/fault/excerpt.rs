//! The line of a file that a fault is about.

use std::ops::Range;

/// Bytes of a long line that are shown before a place and after it.
const BESIDE_MARK: usize = 200;

/// One line of a file, and what to underline in it; of a long line the part around that.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Excerpt {
    /// Number of the line, from 1.
    pub line: usize,
    /// The line, without its end and without a byte order mark.
    pub text: String,
    /// Bytes of `text` to underline.
    pub marked: Range<usize>,
}

impl Excerpt {
    /// The line of `span` in `bytes`; `None` where there is nothing to show: no text (UTF-16, an image), or only white space.
    #[must_use]
    pub fn of(bytes: &[u8], span: Range<usize>) -> Option<Self> {
        let start = bytes.get(..span.start)?.iter().rposition(|&byte| byte == b'\n').map_or(0, |at| at + 1);
        let end = bytes
            .get(span.start..)?
            .iter()
            .position(|&byte| byte == b'\n')
            .map_or(bytes.len(), |at| span.start + at);
        let line = bytes.get(start..end)?;
        let text = std::str::from_utf8(line)
            .ok()
            .filter(|text| !text.contains('\0') && !text.trim_ascii().is_empty())?;
        let text = text.trim_start_matches('\u{feff}');
        let shift = line.len() - text.len();
        let number = bytes.get(..start)?.iter().filter(|&&byte| byte == b'\n').count() + 1;
        let from = (span.start - start).checked_sub(shift)?;
        let to = span.end.min(end).checked_sub(start + shift)?.max(from);
        let text = text.strip_suffix('\r').unwrap_or(text);
        Some(Self::around(number, text, from..to))
    }

    /// The part of a long line that is around the mark: some models have megabytes in one line.
    fn around(line: usize, text: &str, marked: Range<usize>) -> Self {
        let start = letter_at(text, marked.start.saturating_sub(BESIDE_MARK));
        let end = marked.end.min(marked.start + BESIDE_MARK) + BESIDE_MARK;
        let end = letter_at(text, end);
        let text = text.get(start..end).unwrap_or_default().to_owned();
        let within = |at: usize| at.saturating_sub(start).min(text.len());
        let marked = within(marked.start)..within(marked.end);
        Self { line, text, marked }
    }
}

/// Where the letter begins that byte `at` belongs to.
fn letter_at(text: &str, at: usize) -> usize {
    (0..=at.min(text.len())).rev().find(|&at| text.is_char_boundary(at)).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_of_a_place_is_shown_without_its_end() {
        let found = Excerpt::of(b"<a>\r\n <b>x</b>\r\n</a>", 9..10).unwrap();
        assert_eq!((found.line, found.text.as_str(), found.marked), (2, " <b>x</b>", 4..5));
    }

    #[test]
    fn of_a_long_line_the_part_around_the_mark_is_shown() {
        let bytes = format!("<a>{}<b>wrong</b>{}</a>", "ä".repeat(500_000), "ä".repeat(500_000));
        let at = bytes.find("wrong").unwrap();
        let found = Excerpt::of(bytes.as_bytes(), at..at + 5).unwrap();
        assert_eq!(&found.text[found.marked.clone()], "wrong");
        assert!(found.text.len() < 500, "{}", found.text.len());
        let all = Excerpt::of(bytes.as_bytes(), 0..bytes.len()).unwrap();
        assert!(all.text.len() < 500 && all.marked == (0..all.text.len()), "{all:?}");
    }

    #[test]
    fn what_is_no_text_is_not_shown() {
        assert_eq!(Excerpt::of(b"\xFF\xFEa\0", 0..0), None);
        assert_eq!(Excerpt::of(b"  \n<a>", 0..0), None);
    }
}
