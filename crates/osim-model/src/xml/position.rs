//! Byte offset → line and column, as an editor shows them.

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Position {
    /// Bytes before this place.
    pub offset: usize,
    /// Line, counted from 1.
    pub line: usize,
    /// Column in characters, counted from 1.
    pub column: usize,
}

/// Finds lines of byte offsets: it counts the line ends before each block of a file once, and those within a block at each look-up.
///
/// Counting is far cheaper than remembering every line end, and few places are ever asked for.
#[derive(Debug, Clone)]
pub struct LineIndex {
    /// How many lines end before each block.
    before: Vec<usize>,
}

/// Bytes of a block: a look-up counts half of one in the mean.
const BLOCK: usize = 1 << 11;

impl LineIndex {
    /// Counts the line ends of `bytes` (LF and CRLF alike; a lone CR does not end a line).
    pub fn new(bytes: &[u8]) -> Self {
        let mut lines = 0;
        let counted = bytes.chunks(BLOCK).map(|block| {
            let before = lines;
            lines += line_ends(block);
            before
        });
        Self { before: counted.collect() }
    }

    /// The line (from 1) on which byte `offset` of `bytes` stands, the same bytes this index was built from.
    pub fn line(&self, bytes: &[u8], offset: usize) -> usize {
        let offset = offset.min(bytes.len());
        // The end of a file of whole blocks is in none of them.
        let block = (offset / BLOCK).min(self.before.len().saturating_sub(1));
        let before = self.before.get(block).copied().unwrap_or_default();
        before + line_ends(bytes.get(block * BLOCK..offset).unwrap_or_default()) + 1
    }

    /// Line and column of byte `offset` of `bytes`, the same bytes this index was built from.
    pub fn position(&self, bytes: &[u8], offset: usize) -> Position {
        let offset = offset.min(bytes.len());
        let line = self.line(bytes, offset);
        let head = bytes.get(..offset).unwrap_or_default();
        let start = memchr::memrchr(b'\n', head).map_or(0, |newline| newline + 1);
        let before = head.get(start..).unwrap_or_default();
        // A byte order mark takes no column, and the tail bytes of a UTF-8 character take none either.
        let before = if start == 0 { before.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(before) } else { before };
        let column = before.iter().filter(|&&byte| byte & 0xC0 != 0x80).count() + 1;
        Position { offset, line, column }
    }
}

fn line_ends(bytes: &[u8]) -> usize {
    memchr::memchr_iter(b'\n', bytes).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn line_and_column(text: &str, offset: usize) -> (usize, usize) {
        let position = LineIndex::new(text.as_bytes()).position(text.as_bytes(), offset);
        (position.line, position.column)
    }

    #[test]
    fn lines_and_columns_count_from_one() {
        assert_eq!(line_and_column("ab\ncd", 0), (1, 1));
        assert_eq!(line_and_column("ab\ncd", 2), (1, 3));
        assert_eq!(line_and_column("ab\ncd", 3), (2, 1));
        assert_eq!(line_and_column("ab\r\ncd", 5), (2, 2));
        assert_eq!(line_and_column("ab", 99), (1, 3));
    }

    #[test]
    fn lines_are_counted_across_blocks() {
        // One line end in every eight bytes, and a file of exactly three blocks.
        let text = "1234567\n".repeat(3 * BLOCK / 8);
        for offset in [0, 7, 8, BLOCK - 1, BLOCK, BLOCK + 8, 2 * BLOCK + 1, 3 * BLOCK - 1, 3 * BLOCK] {
            assert_eq!(line_and_column(&text, offset).0, offset / 8 + 1, "{offset}");
        }
    }

    #[test]
    fn columns_are_characters_and_a_byte_order_mark_is_none() {
        assert_eq!(line_and_column("α<b", 2), (1, 2));
        assert_eq!(line_and_column("\u{feff}<b", 3), (1, 1));
    }
}
