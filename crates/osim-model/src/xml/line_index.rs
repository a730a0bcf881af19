//! Finds the line and the column of a byte.

/// A place in a file: byte, line and column.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TextPosition {
    /// Number of bytes of the file before the place.
    pub offset: usize,
    pub line: usize,
    /// Column in characters, counted from 1.
    pub column: usize,
}

/// In words, such as `line 12, column 5`.
impl std::fmt::Display for TextPosition {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "line {}, column {}", self.line, self.column)
    }
}

/// Finds line and column of a byte offset. What is before each block of a file is counted once, what is inside a block at each search.
///
/// Counting is much cheaper than storing every line end, because lines are asked for at few places only.
#[derive(Debug, Clone)]
pub struct LineIndex {
    blocks: Vec<BeforeBlock>,
}

/// What is before a block of a file: line ends, and letters after the last one.
#[derive(Debug, Clone, Copy, Default)]
struct BeforeBlock {
    line_ends: usize,
    /// Letters between the last line end and the block.
    letters: usize,
}

/// Bytes of a block. A search counts in half a block on average.
const LINE_BLOCK_BYTES: usize = 1 << 11;

impl LineIndex {
    /// Counts lines and letters of `bytes`. LF and CRLF end a line, CR alone does not.
    pub fn new(bytes: &[u8]) -> Self {
        let mut next = BeforeBlock::default();
        let blocks = bytes.chunks(LINE_BLOCK_BYTES).map(|block| {
            let before = next;
            next = before.after(block);
            before
        });
        Self { blocks: blocks.collect() }
    }

    /// Line and column of byte `offset` of `bytes`. These must be the bytes for which the index was built.
    pub fn position(&self, bytes: &[u8], offset: usize) -> TextPosition {
        let offset = offset.min(bytes.len());
        // The end of a file of whole blocks is in none of them.
        let block = (offset / LINE_BLOCK_BYTES).min(self.blocks.len().saturating_sub(1));
        let inside = bytes.get(block * LINE_BLOCK_BYTES..offset).unwrap_or_default();
        let before = self.blocks.get(block).copied().unwrap_or_default();
        let BeforeBlock { line_ends, letters } = before.after(inside);
        // A byte order mark takes no column.
        let mark = usize::from(line_ends == 0 && offset > 2 && bytes.starts_with(b"\xEF\xBB\xBF"));
        TextPosition { offset, line: line_ends + 1, column: letters - mark + 1 }
    }
}

impl BeforeBlock {
    /// The counts after `bytes`, which follow.
    fn after(self, bytes: &[u8]) -> Self {
        // The tail bytes of a UTF-8 character are no letters.
        let letters = |bytes: &[u8]| bytes.iter().filter(|&&byte| byte & 0xC0 != 0x80).count();
        match memchr::memrchr(b'\n', bytes) {
            Some(last) => Self {
                line_ends: self.line_ends + memchr::memchr_iter(b'\n', bytes).count(),
                letters: letters(bytes.get(last + 1..).unwrap_or_default()),
            },
            None => Self { letters: self.letters + letters(bytes), ..self },
        }
    }
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
    fn columns_are_counted_across_blocks() {
        // A line of two blocks and more, with letters of two bytes of which one is in two blocks.
        let text = format!("\u{feff}a\n{}b", "é1é".repeat(LINE_BLOCK_BYTES / 2));
        for (letter, (offset, _)) in text.char_indices().enumerate().skip(1) {
            let expected = if letter < 3 { (1, letter) } else { (2, letter - 2) };
            assert_eq!(line_and_column(&text, offset), expected, "{offset}");
        }
    }

    #[test]
    fn lines_are_counted_across_blocks() {
        // One line end in every eight bytes, and a file of exactly three blocks.
        let text = "1234567\n".repeat(3 * LINE_BLOCK_BYTES / 8);
        for offset in [
            0,
            7,
            8,
            LINE_BLOCK_BYTES - 1,
            LINE_BLOCK_BYTES,
            LINE_BLOCK_BYTES + 8,
            2 * LINE_BLOCK_BYTES + 1,
            3 * LINE_BLOCK_BYTES - 1,
            3 * LINE_BLOCK_BYTES,
        ] {
            assert_eq!(line_and_column(&text, offset).0, offset / 8 + 1, "{offset}");
        }
    }

    #[test]
    fn columns_are_characters_and_a_byte_order_mark_is_none() {
        assert_eq!(line_and_column("α<b", 2), (1, 2));
        assert_eq!(line_and_column("\u{feff}<b", 3), (1, 1));
    }
}
