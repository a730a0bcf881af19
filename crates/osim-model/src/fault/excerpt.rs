//! The line of a file that a fault is about.

use std::ops::Range;

/// One line of a file, and what to underline in it.
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
        let text = text.trim_end_matches('\r').to_owned();
        Some(Self { line: number, text, marked: from..to })
    }
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
    fn what_is_no_text_is_not_shown() {
        assert_eq!(Excerpt::of(b"\xFF\xFEa\0", 0..0), None);
        assert_eq!(Excerpt::of(b"  \n<a>", 0..0), None);
    }
}
