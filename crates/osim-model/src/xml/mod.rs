//! XML as a flat tree of elements. Each element knows its exact bytes in the file, which are never changed.
//!
//! This module knows nothing about models. [`Tree::scan`] cuts the bytes into [`Piece`]s without gaps, connects these into elements, and
//! refuses bytes that are not one well-formed document. [`RawText`] is the text of an element without child elements, and [`opensim_text`]
//! reads values from such texts as OpenSim does.
//!
//! ```
//! use osim_model::xml::{ElementId, Tree};
//!
//! fn main() {
//!     let tree = Tree::scan("<a><b>  1e6 </b></a>").expect("it is well formed");
//!     let b = tree.child(ElementId::ROOT, "b").expect("there is a <b>");
//!     let text = tree.raw_text(b);
//!     assert_eq!((&*text.text, text.span), ("1e6", 8..11));
//! }
//! ```
//!
//! # What it will not do
//!
//! This module decodes and encodes no document as a whole, supports no namespaces and no DTD, and reads no other file.

pub mod opensim_text;
mod plain_scan;
mod raw_text;
mod scan;
mod tree;

pub use raw_text::RawText;
pub use scan::{SyntaxError, SyntaxFault};
pub use tree::{Children, ElementId, Piece, PieceKind, Tree};

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TextPosition {
    /// Number of bytes of the file before the place.
    pub offset: usize,
    pub line: usize,
    /// Column in characters, counted from 1.
    pub column: usize,
}

/// Finds the line of a byte offset. The line ends before each block of a file are counted once, those inside a block at each search.
///
/// Counting is much cheaper than storing every line end, because lines are asked for at few places only.
#[derive(Debug, Clone)]
pub struct LineIndex {
    /// Number of line ends before each block.
    before: Vec<usize>,
}

/// Bytes of a block, for each of which the number of line ends before it is stored. A search counts line ends in half a block on average.
const LINE_BLOCK_BYTES: usize = 1 << 11;

impl LineIndex {
    /// Counts the line ends of `bytes`. LF and CRLF end a line, CR alone does not.
    pub fn new(bytes: &[u8]) -> Self {
        let mut lines = 0;
        let counted = bytes.chunks(LINE_BLOCK_BYTES).map(|block| {
            let before = lines;
            lines += line_ends(block);
            before
        });
        Self { before: counted.collect() }
    }

    /// The line (from 1) that contains byte `offset` of `bytes`. These must be the bytes for which the index was built.
    pub fn line(&self, bytes: &[u8], offset: usize) -> usize {
        let offset = offset.min(bytes.len());
        // The end of a file of whole blocks is in none of them.
        let block = (offset / LINE_BLOCK_BYTES).min(self.before.len().saturating_sub(1));
        let before = self.before.get(block).copied().unwrap_or_default();
        before + line_ends(bytes.get(block * LINE_BLOCK_BYTES..offset).unwrap_or_default()) + 1
    }

    /// Line and column of byte `offset` of `bytes`. These must be the bytes for which the index was built.
    pub fn position(&self, bytes: &[u8], offset: usize) -> TextPosition {
        let offset = offset.min(bytes.len());
        let line = self.line(bytes, offset);
        let head = bytes.get(..offset).unwrap_or_default();
        let start = memchr::memrchr(b'\n', head).map_or(0, |newline| newline + 1);
        let before = head.get(start..).unwrap_or_default();
        // A byte order mark takes no column, and the tail bytes of a UTF-8 character take none either.
        let before = if start == 0 { before.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(before) } else { before };
        let column = before.iter().filter(|&&byte| byte & 0xC0 != 0x80).count() + 1;
        TextPosition { offset, line, column }
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
