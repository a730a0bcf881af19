//! Byte offset → line and column, as an editor shows them; and where elements are after an edit.

use std::ops::Range;

use super::tree::{ElementId, PieceKind, Tree};

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

/// How many lines end before each block of a file; built once, then a look-up counts within one block.
///
/// Counting is far cheaper than remembering every line end, and few places are ever asked for.
#[derive(Debug, Clone)]
pub struct LineIndex {
    /// Where each block begins, and how many lines end before it; the first begins at 0.
    blocks: Vec<(usize, usize)>,
}

/// Bytes of a block: a look-up counts half of one in the mean.
const BLOCK: usize = 1 << 11;

impl LineIndex {
    /// Counts the line ends of `bytes` (LF and CRLF alike; a lone CR does not end a line).
    #[must_use]
    pub fn new(bytes: &[u8]) -> Self {
        let mut lines = 0;
        let counted = bytes.chunks(BLOCK).enumerate().map(|(number, block)| {
            let before = lines;
            lines += line_ends(block);
            (number * BLOCK, before)
        });
        Self { blocks: counted.collect() }
    }

    /// That of `new`, which `edits` made of `old`: they say, by place, which bytes of `old` gave way to how many new ones. What stayed is
    /// not counted again.
    #[must_use]
    pub fn edited(&self, old: &[u8], new: &[u8], edits: &[(Range<usize>, usize)]) -> Self {
        let mut blocks = Vec::with_capacity(self.blocks.len());
        let mut kept = self.blocks.iter().copied().peekable();
        // How many bytes and lines there are more before what follows.
        let (mut bytes, mut lines) = (0_isize, 0_isize);
        let moved = |(start, before): (usize, usize), bytes: isize, lines: isize| {
            (start.saturating_add_signed(bytes), before.saturating_add_signed(lines))
        };
        for (span, length) in edits {
            blocks.extend(
                std::iter::from_fn(|| kept.next_if(|(start, _)| *start <= span.start))
                    .map(|block| moved(block, bytes, lines)),
            );
            // A block that began in what gave way is one with the block before.
            while kept.next_if(|(start, _)| *start < span.end).is_some() {}
            let start = span.start.saturating_add_signed(bytes);
            let came = new.get(start..start.saturating_add(*length)).unwrap_or_default();
            // A look-up must not count all of what came, where that is much.
            let (last, mut before) = blocks.last().copied().unwrap_or_default();
            if start.saturating_add(came.len()).saturating_sub(last) > BLOCK {
                before += line_ends(new.get(last..start).unwrap_or_default());
                for (number, block) in came.chunks(BLOCK).enumerate() {
                    blocks.push((start + number * BLOCK, before));
                    before += line_ends(block);
                }
            }
            bytes = bytes.saturating_add_unsigned(*length).saturating_sub_unsigned(span.len());
            lines = lines
                .saturating_add_unsigned(line_ends(came))
                .saturating_sub_unsigned(line_ends(old.get(span.clone()).unwrap_or_default()));
        }
        blocks.extend(kept.map(|block| moved(block, bytes, lines)));
        Self { blocks }
    }

    /// The line (from 1) on which byte `offset` of `bytes` stands, the same bytes this index was built from.
    #[must_use]
    pub fn line(&self, bytes: &[u8], offset: usize) -> usize {
        let offset = offset.min(bytes.len());
        let after = self.blocks.partition_point(|(start, _)| *start <= offset);
        let block = after.checked_sub(1).and_then(|last| self.blocks.get(last));
        let (start, before) = block.copied().unwrap_or_default();
        before + line_ends(bytes.get(start..offset).unwrap_or_default()) + 1
    }

    /// Line and column of byte `offset` of `bytes`, the same bytes this index was built from.
    #[must_use]
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

/// Where the elements of a file are in another one that edits made of it.
#[derive(Debug, Clone, Default)]
pub struct KeptElements {
    /// From which old element on they are how many places later.
    moves: Vec<(usize, u32)>,
}

impl KeptElements {
    /// Where an old element is in the new file.
    #[must_use]
    pub fn place(&self, old: ElementId) -> ElementId {
        let until = self.moves.partition_point(|(from, _)| *from <= old.index());
        let by = until.checked_sub(1).and_then(|last| self.moves.get(last)).map_or(0, |(_, by)| *by);
        old.later(by)
    }
}

impl Tree {
    /// Where the elements of this file are in `new`, which `edits` made of it: as for [`edited`](Self::edited). `None` unless each edit
    /// changed a text, or put in elements without children, both in an element that `may_change`.
    #[must_use]
    pub fn kept_elements(
        &self,
        new: &Self,
        edits: &[(Range<usize>, usize)],
        may_change: impl Fn(ElementId) -> bool,
    ) -> Option<KeptElements> {
        let (mut kept, mut shift, mut by) = (KeptElements::default(), 0_isize, 0);
        for (span, length) in edits {
            let (owner, next) = self.place_of(span)?;
            if !may_change(ElementId::ROOT.later(u32::try_from(owner).ok()?)) {
                return None;
            }
            let start = span.start.checked_add_signed(shift)?;
            let put_in = new.opening_in(&(start..start.checked_add(*length)?));
            let elements = new.stored_elements().get(put_in.clone())?;
            if !elements.iter().zip(put_in).all(|(element, index)| element.subtree_end as usize == index + 1)
            {
                return None;
            }
            if !elements.is_empty() {
                by += u32::try_from(elements.len()).ok()?;
                kept.moves.push((next, by));
            }
            shift += isize::try_from(*length).ok()?.checked_sub_unsigned(span.len())?;
        }
        (self.element_count() + by as usize == new.element_count()).then_some(kept)
    }

    /// The element in whose content `span` is, a part of a text or nothing, and the first element after it.
    fn place_of(&self, span: &Range<usize>) -> Option<(usize, usize)> {
        let pieces = self.stored_pieces();
        let after = pieces.partition_point(|piece| (piece.start as usize) < span.start);
        let starts_here = pieces.get(after).is_some_and(|piece| piece.start as usize == span.start);
        if span.is_empty() && starts_here {
            return self.place_among_elements(after);
        }
        let text = if starts_here { after } else { after.checked_sub(1)? };
        pieces.get(text).filter(|piece| piece.kind == PieceKind::Text)?;
        pieces.get(text + 1).filter(|next| span.end <= next.start as usize)?;
        self.place_among_elements(text + 1)
    }

    /// Numbers of the elements whose start tags begin in `span`.
    fn opening_in(&self, span: &Range<usize>) -> Range<usize> {
        let (pieces, elements) = (self.stored_pieces(), self.stored_elements());
        let [from, to] = [span.start, span.end].map(|at| {
            let piece = pieces.partition_point(|piece| (piece.start as usize) < at);
            elements.partition_point(|element| (element.open as usize) < piece)
        });
        from..to
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
    fn lines_are_counted_across_blocks() {
        // One line end in every eight bytes, and a file of exactly three blocks.
        let text = "1234567\n".repeat(3 * BLOCK / 8);
        for offset in [0, 7, 8, BLOCK - 1, BLOCK, BLOCK + 8, 2 * BLOCK + 1, 3 * BLOCK - 1, 3 * BLOCK] {
            assert_eq!(at(&text, offset).0, offset / 8 + 1, "{offset}");
        }
    }

    #[test]
    fn lines_of_an_edited_file_are_those_of_its_bytes() {
        let old = "1234567\n".repeat(3 * BLOCK / 8);
        let long = "12345\n".repeat(BLOCK);
        for (from, to, text) in [
            (0, 0, "\n\n"),
            (0, 0, &*long),
            (BLOCK + 5, BLOCK + 9, &long),
            (5, 5, "x"),
            (BLOCK, BLOCK, "\n"),
            (BLOCK - 3, 2 * BLOCK + 9, "a\nb"),
            (7, 8, ""),
        ] {
            let mut new = old.clone();
            new.replace_range(old.len() - 9..old.len() - 1, "\n\n");
            new.replace_range(from..to, text);
            let edits = [(from..to, text.len()), (old.len() - 9..old.len() - 1, 2)];
            let index = LineIndex::new(old.as_bytes()).edited(old.as_bytes(), new.as_bytes(), &edits);
            let whole = LineIndex::new(new.as_bytes());
            for offset in 0..=new.len() {
                let line = |index: &LineIndex| index.line(new.as_bytes(), offset);
                assert_eq!(line(&index), line(&whole), "{from}..{to} {offset}");
            }
        }
    }

    #[test]
    fn columns_are_characters_and_a_byte_order_mark_is_none() {
        assert_eq!(at("α<b", 2), (1, 2));
        assert_eq!(at("\u{feff}<b", 3), (1, 1));
    }

    const TEXT: &str = "<m><forces><f><a>1</a>\n</f><g/></forces><joints><j>2</j></joints></m>";

    /// The names of old elements with those at their new places.
    fn kept(edits: &[(&str, &str, &str)]) -> Option<Vec<(String, String)>> {
        let tree = Tree::scan(TEXT).unwrap();
        let (mut new, mut places) = (TEXT.to_owned(), Vec::new());
        for (before, gone, text) in edits {
            let at = TEXT.find(&format!("{before}{gone}")).unwrap() + before.len();
            places.push((at..at + gone.len(), text.len()));
        }
        for ((span, _), (_, _, text)) in places.iter().zip(edits).rev() {
            new.replace_range(span.clone(), text);
        }
        let new = Tree::scan(new).unwrap();
        let is_force = |id: ElementId| {
            std::iter::successors(Some(id), |&id| tree.parent(id)).any(|id| tree.name(id) == "forces")
        };
        let kept = tree.kept_elements(&new, &places, is_force)?;
        let named = |id| (tree.name(id).to_owned(), new.name(kept.place(id)).to_owned());
        Some(tree.elements().map(named).collect())
    }

    #[test]
    fn elements_after_new_leaves_are_found_again() {
        let all =
            kept(&[("<a>", "1", "0.25"), ("</a>\n", "", "<b>2</b><c/>\n"), ("</f>", "", "<h/>")]).unwrap();
        assert!(all.iter().all(|(old, new)| old == new) && all.len() == 7, "{all:?}");
        assert!(kept(&[]).is_some());
    }

    #[test]
    fn what_does_more_keeps_nothing() {
        // In a place that may not change, with a child, a tag that changes, a text that is cut by a tag.
        assert!(kept(&[("<j>", "2", "3")]).is_none());
        assert!(kept(&[("</a>\n", "", "<b><c/></b>")]).is_none());
        assert!(kept(&[("<", "g/", "h/")]).is_none());
        assert!(kept(&[("", "1</a>\n", "2</a>")]).is_none());
    }
}
