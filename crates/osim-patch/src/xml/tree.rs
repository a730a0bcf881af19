//! The flat tree: pieces that tile the file, and elements that point into them.

use std::borrow::Cow;
use std::ops::Range;

/// What a piece of the file is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum PieceKind {
    /// The byte order mark.
    ByteOrderMark,
    /// `<tag …>`
    Open,
    /// `</tag>`
    Close,
    /// `<tag …/>`
    Empty,
    /// Character data.
    Text,
    /// `<![CDATA[…]]>`
    CData,
    /// `&name;`
    Reference,
    /// `<!-- … -->`
    Comment,
    /// XML declaration, processing instruction or DOCTYPE.
    Other,
}

/// One piece of the file; it ends where the next one starts, so pieces cannot overlap or leave gaps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Piece {
    /// First byte.
    pub start: u32,
    /// What stands there.
    pub kind: PieceKind,
}

/// Index of an element; elements are numbered in document order, the root is 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ElementId(pub(crate) u32);

impl ElementId {
    /// The first element of the file.
    pub const ROOT: Self = Self(0);

    pub(crate) fn index(self) -> usize {
        self.0 as usize
    }
}

/// An element as indices: its tags among the pieces, its parent and the end of its subtree among the elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Element {
    /// Piece of the start tag (or of the empty-element tag).
    pub open: u32,
    /// Piece of the end tag; equal to `open` for `<tag/>`.
    pub close: u32,
    /// Parent element; the root is its own parent.
    pub parent: u32,
    /// First element after this one and all below it.
    pub subtree_end: u32,
    /// Length of the tag name, which starts one byte after the `<`.
    pub name_len: u32,
}

/// A scanned document.
///
/// `text` is the file as UTF-8; where the file is not UTF-8, each offending byte is replaced by one `?`, so offsets
/// in `text` and in the file are the same.
#[derive(Debug, Clone)]
pub struct Tree<'a> {
    pub(crate) text: Cow<'a, str>,
    pub(crate) pieces: Vec<Piece>,
    pub(crate) elements: Vec<Element>,
}

impl<'a> Tree<'a> {
    /// All pieces, in file order.
    #[must_use]
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Number of elements.
    #[must_use]
    pub fn element_count(&self) -> usize {
        self.elements.len()
    }

    /// Bytes of piece `index`; empty past the end.
    #[must_use]
    pub fn piece_span(&self, index: usize) -> Range<usize> {
        let end = self.text.len();
        let start = self.pieces.get(index).map_or(end, |piece| piece.start as usize);
        start..self.pieces.get(index + 1).map_or(end, |next| next.start as usize)
    }

    pub(crate) fn slice(&self, span: Range<usize>) -> &str {
        self.text.get(span).unwrap_or_default()
    }

    pub(crate) fn piece_text(&self, index: usize) -> &str {
        self.slice(self.piece_span(index))
    }

    fn element(&self, id: ElementId) -> Element {
        // Ids are only made by this tree; the fallback keeps a foreign id from panicking.
        self.elements.get(id.index()).copied().unwrap_or(Element {
            open: 0,
            close: 0,
            parent: 0,
            subtree_end: 0,
            name_len: 0,
        })
    }

    pub(crate) fn open_piece(&self, id: ElementId) -> usize {
        self.element(id).open as usize
    }

    /// Pieces strictly between the element's tags.
    pub(crate) fn content_pieces(&self, id: ElementId) -> Range<usize> {
        let element = self.element(id);
        if element.open == element.close {
            return 0..0;
        }
        element.open as usize + 1..element.close as usize
    }

    /// `true` for `<tag/>`.
    #[must_use]
    pub fn is_empty_tag(&self, id: ElementId) -> bool {
        let element = self.element(id);
        element.open == element.close
    }

    /// From the `<` of the start tag to the `>` of the end tag.
    #[must_use]
    pub fn span(&self, id: ElementId) -> Range<usize> {
        let element = self.element(id);
        self.piece_span(element.open as usize).start..self.piece_span(element.close as usize).end
    }

    /// The start tag.
    #[must_use]
    pub fn open_span(&self, id: ElementId) -> Range<usize> {
        self.piece_span(self.open_piece(id))
    }

    /// The end tag (the whole tag for `<tag/>`).
    #[must_use]
    pub fn close_span(&self, id: ElementId) -> Range<usize> {
        self.piece_span(self.element(id).close as usize)
    }

    /// The tag name, as written.
    #[must_use]
    pub fn name(&self, id: ElementId) -> &str {
        let element = self.element(id);
        let start = self.pieces.get(element.open as usize).map_or(0, |piece| piece.start as usize) + 1;
        self.slice(start..start + element.name_len as usize)
    }

    /// The decoded value of attribute `key`, if the start tag has it.
    #[must_use]
    pub fn attribute(&self, id: ElementId, key: &str) -> Option<Cow<'_, str>> {
        let tag = self.slice(self.open_span(id));
        let name = self.name(id);
        // `<name>` and `<name/>` have no attributes.
        if tag.len() <= name.len() + 3 {
            return None;
        }
        let body = tag.get(1..).unwrap_or_default().trim_end_matches('>').trim_end_matches('/');
        if body.len() == name.len() {
            return None;
        }
        let mut attributes = quick_xml::events::attributes::Attributes::new(body, name.len());
        attributes.with_checks(false);
        let found = attributes.flatten().find(|attribute| attribute.key.as_ref() == key)?;
        Some(super::value::decode(found.value))
    }

    /// The parent element; `None` for the root.
    #[must_use]
    pub fn parent(&self, id: ElementId) -> Option<ElementId> {
        (id != ElementId::ROOT).then(|| ElementId(self.element(id).parent))
    }

    /// Child elements in file order.
    #[must_use]
    pub fn children(&self, id: ElementId) -> Children<'_, 'a> {
        let element = self.element(id);
        Children { tree: self, next: id.0.saturating_add(1), end: element.subtree_end }
    }

    /// The first child element with this tag name: OpenSim reads the first of duplicates.
    #[must_use]
    pub fn child(&self, id: ElementId, name: &str) -> Option<ElementId> {
        self.children(id).find(|&child| self.name(child) == name)
    }
}

/// Iterator over child elements.
#[derive(Debug, Clone)]
pub struct Children<'t, 'a> {
    tree: &'t Tree<'a>,
    next: u32,
    end: u32,
}

impl Iterator for Children<'_, '_> {
    type Item = ElementId;

    fn next(&mut self) -> Option<ElementId> {
        if self.next >= self.end {
            return None;
        }
        let id = ElementId(self.next);
        self.next = self.tree.element(id).subtree_end;
        Some(id)
    }
}
