//! Byte offset → line and column, as an editor shows them.

/// A place in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Position {
    /// Bytes before this place.
    pub offset: usize,
    /// Line, counted from 1.
    pub line: usize,
    /// Column in characters, counted from 1.
    pub column: usize,
}

/// Where the lines of a file start; built once, then every look-up is a binary search.
#[derive(Debug, Clone)]
pub struct LineIndex {
    newlines: Vec<u32>,
}

impl LineIndex {
    /// Finds all line ends of `bytes` (LF and CRLF alike; a lone CR does not end a line).
    #[must_use]
    pub fn new(bytes: &[u8]) -> Self {
        // A file longer than 4 GiB was refused before anybody asks for a line of it.
        let newlines = memchr::memchr_iter(b'\n', bytes).filter_map(|at| u32::try_from(at).ok()).collect();
        Self { newlines }
    }

    /// The line (from 1) on which byte `offset` stands.
    #[must_use]
    pub fn line(&self, offset: usize) -> usize {
        self.newlines.partition_point(|&newline| (newline as usize) < offset) + 1
    }

    /// Line and column of byte `offset` of `bytes`, the same bytes this index was built from.
    #[must_use]
    pub fn position(&self, bytes: &[u8], offset: usize) -> Position {
        let offset = offset.min(bytes.len());
        let line = self.line(offset);
        let start = match line.checked_sub(2).and_then(|before| self.newlines.get(before)) {
            Some(&newline) => newline as usize + 1,
            None => 0,
        };
        let before = bytes.get(start..offset).unwrap_or_default();
        // A byte order mark takes no column, and the tail bytes of a UTF-8 character take none either.
        let before = if start == 0 { before.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(before) } else { before };
        let column = before.iter().filter(|&&byte| byte & 0xC0 != 0x80).count() + 1;
        Position { offset, line, column }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn at(text: &str, offset: usize) -> (usize, usize) {
        let position = LineIndex::new(text.as_bytes()).position(text.as_bytes(), offset);
        (position.line, position.column)
    }

    #[test]
    fn lines_and_columns_count_from_one() {
        assert_eq!(at("ab\ncd", 0), (1, 1));
        assert_eq!(at("ab\ncd", 2), (1, 3));
        assert_eq!(at("ab\ncd", 3), (2, 1));
        assert_eq!(at("ab\r\ncd", 5), (2, 2));
        assert_eq!(at("ab", 99), (1, 3));
    }

    #[test]
    fn columns_are_characters_and_a_byte_order_mark_is_none() {
        assert_eq!(at("α<b", 2), (1, 2));
        assert_eq!(at("\u{feff}<b", 3), (1, 1));
    }
}
