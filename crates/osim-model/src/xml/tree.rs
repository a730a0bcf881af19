//! A flat tree of a file: pieces without gaps between them, and elements that refer to the pieces.

use std::borrow::Cow;
use std::ops::Range;

use quick_xml::events::attributes::{Attribute, Attributes};

pub(super) const BYTE_ORDER_MARK: &[u8] = b"\xEF\xBB\xBF";

/// What a piece of a file is: a tag, a text, or another part of XML.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PieceKind {
    ByteOrderMark,
    /// A start tag, `<tag …>`.
    Open,
    /// An end tag, `</tag>`.
    Close,
    /// A tag of an element without content, `<tag …/>`.
    Empty,
    Text,
    /// Text in `<![CDATA[…]]>`.
    CData,
    /// A reference such as `&name;`.
    Reference,
    Comment,
    /// An XML declaration, a processing instruction or a DOCTYPE.
    Other,
}

/// A piece of a file. The pieces of a file cover it without gaps or overlaps.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Piece<'t> {
    pub kind: PieceKind,
    /// Bytes of the piece in the file, from 0.
    pub span: Range<usize>,
    /// Text of the piece. A byte that is not UTF-8 is replaced by `?`.
    pub text: &'t str,
}

/// Handle of an element in a [`Tree`]. Elements are in file order; [`ElementId::ROOT`] is the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ElementId(u32);

impl ElementId {
    /// The first element, which contains all others.
    pub const ROOT: Self = Self(0);

    /// The index of the element in its file, from 0.
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// An element as the tree stores it: indices of its tags among the pieces, and of its parent and the end of its descendants among the
/// elements.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct StoredElement {
    /// Index of the piece that is the start tag (or the tag of an element without content).
    pub(super) open: u32,
    /// Index of the piece that is the end tag; equal to `open` for `<tag/>`.
    pub(super) close: u32,
    /// Index of the parent element; the root is its own parent.
    pub(super) parent: u32,
    /// Index of the first element after this element and all its descendants.
    pub(super) subtree_end: u32,
    /// The byte at which the tag name begins, after the `<`.
    pub(super) name_start: u32,
    pub(super) name_len: u32,
}

/// A file after the scan: its elements, and the pieces of which these consist. All spans are bytes of the file, from 0.
///
/// ```
/// use osim_model::xml::{ElementId, Tree};
///
/// let text = "<ContactSphere name='heel'><radius> 0.03 </radius></ContactSphere>";
/// let tree = Tree::scan(text).expect("it is well formed");
/// assert_eq!(tree.attribute(ElementId::ROOT, "name").as_deref(), Some("heel"));
/// let radius = tree.child(ElementId::ROOT, "radius").expect("it has a radius");
/// // What an edit would replace: the number without the blanks around it.
/// assert_eq!(&text[tree.raw_text(radius).span], "0.03");
/// assert_eq!(&text[tree.span(radius)], "<radius> 0.03 </radius>");
/// ```
#[derive(Debug, Clone)]
pub struct Tree {
    text: FileText,
    /// The byte at which each piece begins. It ends where the next one begins.
    pieces: Vec<u32>,
    elements: Vec<StoredElement>,
}

impl Tree {
    pub(super) fn new(text: FileText, pieces: Vec<u32>, elements: Vec<StoredElement>) -> Self {
        Self { text, pieces, elements }
    }

    /// Bytes of the file as it was read.
    pub fn bytes(&self) -> &[u8] {
        self.text.bytes()
    }

    /// Takes the bytes of the file, without a copy.
    pub fn into_bytes(self) -> Vec<u8> {
        self.text.into_bytes()
    }

    /// All pieces of the file, in order.
    pub fn pieces(&self) -> impl DoubleEndedIterator<Item = Piece<'_>> {
        (0..self.pieces.len()).filter_map(|index| self.piece(index))
    }

    /// Pieces between the tags of an element, including those of its child elements.
    pub fn content(&self, id: ElementId) -> impl DoubleEndedIterator<Item = Piece<'_>> {
        let element = self.element(id);
        let content = if element.open == element.close { 0..0 } else { element.open + 1..element.close };
        content.filter_map(|index| self.piece(index as usize))
    }

    pub(super) fn piece(&self, index: usize) -> Option<Piece<'_>> {
        self.pieces.get(index)?;
        let span = self.piece_span(index);
        let text = self.slice(span.clone());
        let kind = match text.as_bytes() {
            [b'<', b'/', ..] => PieceKind::Close,
            [b'<', b'!', b'-', ..] => PieceKind::Comment,
            [b'<', b'!', b'[', ..] => PieceKind::CData,
            [b'<', b'!' | b'?', ..] => PieceKind::Other,
            [b'<', .., b'/', b'>'] => PieceKind::Empty,
            [b'<', ..] => PieceKind::Open,
            // A text that begins with `&` has no `;` after it.
            [b'&', .., b';'] => PieceKind::Reference,
            BYTE_ORDER_MARK if index == 0 => PieceKind::ByteOrderMark,
            _ => PieceKind::Text,
        };
        Some(Piece { kind, text, span })
    }

    /// All elements of the file, in order.
    pub fn elements(&self) -> impl Iterator<Item = ElementId> + use<> {
        // Their number was counted in `u32`.
        (0..u32::try_from(self.elements.len()).unwrap_or(u32::MAX)).map(ElementId)
    }

    pub fn element_count(&self) -> usize {
        self.elements.len()
    }

    /// Bytes of piece `index`; empty if there is no such piece.
    pub(super) fn piece_span(&self, index: usize) -> Range<usize> {
        let end = self.text.as_str().len();
        let start = |index: usize| self.pieces.get(index).map_or(end, |&start| start as usize);
        start(index)..start(index + 1)
    }

    /// The text of the bytes `span`; empty if they do not begin and end between two letters of the file.
    #[inline]
    pub fn slice(&self, span: Range<usize>) -> &str {
        self.text.as_str().get(span).unwrap_or_default()
    }

    #[inline]
    pub(super) fn element(&self, id: ElementId) -> StoredElement {
        // Ids are only made by this tree; the fallback keeps a foreign id from panicking.
        self.elements.get(id.index()).copied().unwrap_or_default()
    }

    pub fn is_empty_tag(&self, id: ElementId) -> bool {
        let element = self.element(id);
        element.open == element.close
    }

    /// The bytes of an element, from the `<` of the start tag to the `>` of the end tag.
    pub fn span(&self, id: ElementId) -> Range<usize> {
        let element = self.element(id);
        self.piece_span(element.open as usize).start..self.piece_span(element.close as usize).end
    }

    /// Bytes of an element's start tag.
    pub fn open_span(&self, id: ElementId) -> Range<usize> {
        self.piece_span(self.element(id).open as usize)
    }

    /// Bytes of an element's end tag (of the whole tag for `<tag/>`).
    pub fn close_span(&self, id: ElementId) -> Range<usize> {
        self.piece_span(self.element(id).close as usize)
    }

    /// The tag name of an element.
    #[inline]
    pub fn name(&self, id: ElementId) -> &str {
        let StoredElement { name_start, name_len, .. } = self.element(id);
        self.slice(name_start as usize..name_start as usize + name_len as usize)
    }

    /// The decoded value of attribute `key`; `None` if the start tag does not have it.
    pub fn attribute(&self, id: ElementId, key: &str) -> Option<Cow<'_, str>> {
        let StoredElement { open, name_start, name_len, .. } = self.element(id);
        let behind_name = name_start as usize + name_len as usize;
        let attributes = self.slice(behind_name..self.piece_span(open as usize).end);
        if let Some(found) = plain_attribute(attributes, key) {
            return found.map(Cow::Borrowed);
        }
        let found = self.attributes(id).find(|attribute| attribute.key.as_ref() == key)?;
        Some(decode(found.value))
    }

    /// The names of the attributes of an element.
    pub fn attribute_names(&self, id: ElementId) -> impl Iterator<Item = &str> {
        self.attributes(id).map(|attribute| attribute.key.into_inner())
    }

    fn attributes(&self, id: ElementId) -> impl Iterator<Item = Attribute<'_>> {
        let tag = self.slice(self.open_span(id)).get(1..).unwrap_or_default();
        let body = tag.trim_end_matches('>').trim_end_matches('/');
        let mut attributes = Attributes::new(body, self.name(id).len());
        attributes.with_checks(false);
        attributes.flatten()
    }

    /// The parent element; `None` for the root.
    #[inline]
    pub fn parent(&self, id: ElementId) -> Option<ElementId> {
        (id != ElementId::ROOT).then(|| ElementId(self.element(id).parent))
    }

    /// Child elements of an element, in file order.
    #[inline]
    pub fn children(&self, id: ElementId) -> Children<'_> {
        let element = self.element(id);
        Children { tree: self, next: id.0.saturating_add(1), end: element.subtree_end }
    }

    /// Calls `visit` for `top` and the elements below it, in file order. The result of `visit` says whether the elements below an element
    /// are visited, too.
    pub fn walk(&self, top: ElementId, mut visit: impl FnMut(ElementId) -> bool) {
        let (mut next, end) = (top.0, self.element(top).subtree_end);
        while next < end {
            let id = ElementId(next);
            next = if visit(id) { next.saturating_add(1) } else { self.element(id).subtree_end };
        }
    }

    /// The first child element with this tag name. OpenSim reads only the first of several.
    #[inline]
    pub fn child(&self, id: ElementId, name: &str) -> Option<ElementId> {
        // Most names differ in their lengths.
        let has_length = |child: &ElementId| self.element(*child).name_len as usize == name.len();
        self.children(id).filter(has_length).find(|&child| self.name(child) == name)
    }
}

/// The value of `key` in attributes such as ` a="1" b='2'>`; `None` inside if there is no `key`. The outer `None` means that the attributes
/// are not plain: other text between them, or a reference in a value.
fn plain_attribute<'t>(attributes: &'t str, key: &str) -> Option<Option<&'t str>> {
    let mut rest = attributes.as_bytes();
    loop {
        let blanks = rest.iter().position(|&byte| !is_space(byte)).unwrap_or(rest.len());
        rest = rest.get(blanks..)?;
        if matches!(rest, b"" | b">" | b"/>") {
            return Some(None);
        }
        let (name, behind) = rest.split_at_checked(rest.iter().position(|&byte| !is_name_byte(byte))?)?;
        let [b'=', quote @ (b'"' | b'\''), value @ ..] = behind else { return None };
        let length = value.iter().position(|byte| byte == quote || *byte == b'&')?;
        if blanks == 0 || name.is_empty() || value.get(length) == Some(&b'&') {
            return None;
        }
        if name == key.as_bytes() {
            let start = attributes.len() - value.len();
            return attributes.get(start..start + length).map(Some);
        }
        rest = value.get(length + 1..)?;
    }
}

/// Iterates over the child elements of an element in file order: from [`Tree::children`].
#[derive(Debug, Clone)]
pub struct Children<'t> {
    tree: &'t Tree,
    next: u32,
    end: u32,
}

impl Iterator for Children<'_> {
    type Item = ElementId;

    #[inline]
    fn next(&mut self) -> Option<ElementId> {
        if self.next >= self.end {
            return None;
        }
        let id = ElementId(self.next);
        self.next = self.tree.element(id).subtree_end;
        Some(id)
    }
}

/// The text of a file as UTF-8. If the file is not UTF-8, each wrong byte is one `?` in the text, so that offsets are the same in text and
/// file.
#[derive(Debug, Clone)]
pub(crate) struct FileText {
    text: String,
    /// The bytes of the file, if they are not UTF-8.
    original: Option<Vec<u8>>,
}

impl FileText {
    /// Takes the bytes of a file. They are copied only if they are not UTF-8.
    pub(crate) fn new(bytes: Vec<u8>) -> Self {
        match String::from_utf8(bytes) {
            Ok(text) => Self { text, original: None },
            Err(error) => {
                let bytes = error.into_bytes();
                let mut text = String::with_capacity(bytes.len());
                for chunk in bytes.utf8_chunks() {
                    text.push_str(chunk.valid());
                    text.extend(chunk.invalid().iter().map(|_| '?'));
                }
                Self { text, original: Some(bytes) }
            }
        }
    }

    pub(crate) fn as_str(&self) -> &str {
        &self.text
    }

    /// Bytes of the file as it was read.
    pub(crate) fn bytes(&self) -> &[u8] {
        self.original.as_deref().unwrap_or(self.text.as_bytes())
    }

    /// Takes the bytes of the file, without a copy.
    pub(crate) fn into_bytes(self) -> Vec<u8> {
        self.original.unwrap_or(self.text.into_bytes())
    }
}

/// Resolves references to letters and to XML's predefined entities. An unknown reference is not changed.
pub(super) fn decode(raw: Cow<'_, str>) -> Cow<'_, str> {
    if !raw.contains('&') {
        return raw;
    }
    match quick_xml::escape::unescape(&raw) {
        Ok(text) => Cow::Owned(text.into_owned()),
        Err(_) => raw,
    }
}

/// Whether `byte` may be in an ASCII name of a tag or attribute.
pub(super) fn is_name_byte(byte: u8) -> bool {
    NAME_BYTES.get(byte as usize).is_some_and(|&plain| plain)
}

pub(super) fn is_space(byte: u8) -> bool {
    matches!(byte, b' ' | b'\n' | b'\t' | b'\r')
}

static NAME_BYTES: [bool; 256] = {
    let mut table = [false; 256];
    let mut byte = 0_u8;
    while byte < 128 {
        table[byte as usize] = byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'.' | b':' | b'-');
        byte += 1;
    }
    table
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stray_byte_keeps_all_offsets_and_the_file() {
        let text = FileText::new(b"<a>\x96<b>1</b></a>".to_vec());
        assert_eq!(text.as_str(), "<a>?<b>1</b></a>");
        assert_eq!(text.bytes(), b"<a>\x96<b>1</b></a>");
    }
}
