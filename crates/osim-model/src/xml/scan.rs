//! Makes a [`Tree`] from bytes, or finds the first place at which the bytes are not one well-formed document.

use std::collections::HashSet;

use quick_xml::events::{BytesStart, Event};
use quick_xml::reader::Reader;

use super::plain_scan::scan_plain;
use super::tree::{BYTE_ORDER_MARK, FileText, StoredElement, Tree};

/// Why a file is not one well-formed XML document.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum SyntaxFault {
    /// There is no element, or text before the first element.
    #[error(
        "this is not XML, expected an OpenSim model that starts with <?xml ...> or <OpenSimDocument ...>"
    )]
    NotXml,
    #[error("this is a {0} archive, expected an OpenSim model: unpack it first")]
    Packed(&'static str),
    #[error("this is a motion or another table of OpenSim, expected a model: to compare the two, ")]
    Motion,
    /// The first line has a column `model`.
    #[error("this is a table, expected an OpenSim model: tables of models go with ")]
    Table,
    #[error("the file is empty, expected an OpenSim model: get it again from where it came")]
    Empty,
    /// The file is UTF-16, or another encoding with two bytes a letter.
    #[error("the file is UTF-16, which OpenSim cannot read: save it as UTF-8")]
    Utf16,
    /// The file begins with two byte order marks.
    #[error("the file starts with two byte order marks, expected one at most: remove the second")]
    SecondByteOrderMark,
    /// The file has a DOCTYPE with its own declarations, `<!DOCTYPE x […]>`.
    #[error("the DOCTYPE has an internal subset [...], which OpenSim cannot read: remove it")]
    DoctypeSubset,
    #[error("a second outermost element starts here, expected the end of the file")]
    SecondRoot,
    /// There is text before or after the root element.
    #[error("text outside the outermost element, expected the end of the file")]
    TextOutsideRoot,
    /// The file ends before an element is closed: this is the innermost one.
    #[error("<{tag}> is never closed: the file looks truncated, copy it again from where it came")]
    Unclosed { tag: String },
    /// An end tag has another name than its start tag.
    #[error("</{found}> closes <{expected}>, expected </{expected}>")]
    MismatchedEnd { expected: String, found: String },
    /// There is an end tag without a start tag.
    #[error("</{found}> closes nothing")]
    UnexpectedEnd { found: String },
    #[error("<{tag}>: {what}")]
    Attribute { tag: String, what: String },
    /// Any other error that the parser reports.
    #[error("{what}")]
    Malformed { what: String },
    /// The file ends inside a tag, comment or instruction.
    #[error("the file ends inside a tag or a comment: it looks truncated, copy it again from where it came")]
    Truncated { what: String },
    #[error("a zero byte is here: the file is damaged or not text, copy it again from where it came")]
    Nul,
    /// The file has more than 4 GiB, the most that this program reads.
    #[error("the file is larger than 4 GiB")]
    TooLarge,
}

/// The error that a file is not one well-formed document, and its first place.
#[derive(Debug)]
pub struct SyntaxError {
    pub fault: SyntaxFault,
    /// Byte offset of the error in the file, from 0.
    pub offset: usize,
    /// The text of the file, for messages that show the place.
    pub(crate) file: FileText,
}

impl SyntaxError {
    pub fn bytes(&self) -> &[u8] {
        self.file.bytes()
    }
}

// Plain files are scanned by [`scan_plain`]. For all others, quick-xml finds the pieces; what it lets pass (several roots, text
// outside the root, elements left open, a second byte order mark) is refused here. Its comment checks stay off: real models
// have `<!--` inside a comment.

/// How archives begin.
const ARCHIVES: [(&[u8], &str); 4] =
    [(b"PK\x03\x04", "ZIP"), (b"\x1F\x8B", "gzip"), (b"7z\xBC\xAF", "7z"), (b"Rar!", "RAR")];

type Fault = (SyntaxFault, usize);

impl Tree {
    /// Scans the bytes of a file. The meaning of elements does not matter.
    ///
    /// # Errors
    /// The bytes are not one well-formed document. The error has the byte at which this was noticed.
    pub fn scan(bytes: impl Into<Vec<u8>>) -> Result<Self, SyntaxError> {
        let file = FileText::new(bytes.into());
        match pieces_and_elements(&file) {
            Ok((pieces, elements)) => Ok(Self::new(file, pieces, elements)),
            Err((fault, offset)) => Err(SyntaxError { fault, offset, file }),
        }
    }
}

fn pieces_and_elements(file: &FileText) -> Result<(Vec<u32>, Vec<StoredElement>), Fault> {
    let (bytes, text) = (file.bytes(), file.as_str());
    refuse_foreign_encodings(bytes)?;
    let mark = if bytes.starts_with(BYTE_ORDER_MARK) { BYTE_ORDER_MARK.len() } else { 0 };
    match scan_plain(text, mark) {
        Some(found) => {
            debug_assert_eq!(Scanner::new(text, mark).run().ok().as_ref(), Some(&found));
            Ok(found)
        }
        None => Scanner::new(text, mark).run(),
    }
}

fn refuse_foreign_encodings(bytes: &[u8]) -> Result<(), Fault> {
    if u32::try_from(bytes.len()).is_err() {
        return Err((SyntaxFault::TooLarge, 0));
    }
    let utf16 = [&b"\xFF\xFE"[..], b"\xFE\xFF", b"<\0", b"\0<"];
    if utf16.iter().any(|start| bytes.starts_with(start)) {
        return Err((SyntaxFault::Utf16, 0));
    }
    if let Some(&(_, archive)) = ARCHIVES.iter().find(|(start, _)| bytes.starts_with(start)) {
        return Err((SyntaxFault::Packed(archive), 0));
    }
    if let Some(at) = memchr::memchr(0, bytes) {
        return Err((SyntaxFault::Nul, at));
    }
    let rest = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
    if bytes.len() != rest.len() && rest.starts_with(BYTE_ORDER_MARK) {
        return Err((SyntaxFault::SecondByteOrderMark, BYTE_ORDER_MARK.len()));
    }
    Ok(())
}

/// The state of the full scan of a file by quick-xml.
struct Scanner<'t> {
    text: &'t str,
    /// Length of the byte order mark. The parser quick-xml gets the text after it.
    base: usize,
    pieces: Vec<u32>,
    elements: Vec<StoredElement>,
    /// Indices of the elements that are still open, the outermost first.
    open: Vec<u32>,
}

impl<'t> Scanner<'t> {
    fn new(text: &'t str, base: usize) -> Self {
        // One pass over the `<` gives the tables their final size, so they never grow and move.
        let tags = memchr::memchr_iter(b'<', text.as_bytes()).count();
        let mut pieces = Vec::with_capacity(2 * tags + 2);
        if base > 0 {
            pieces.push(0);
        }
        Self { text, base, pieces, elements: Vec::with_capacity(tags / 2 + 1), open: Vec::new() }
    }

    fn run(mut self) -> Result<(Vec<u32>, Vec<StoredElement>), Fault> {
        let mut reader = Reader::from_str(self.text.get(self.base..).unwrap_or_default());
        reader.config_mut().allow_dangling_amp = true;
        // OpenSim refuses `</tag >`.
        reader.config_mut().trim_markup_names_in_closing_tags = false;
        loop {
            let start = self.base + offset(reader.buffer_position());
            let event = reader
                .read_event()
                .map_err(|error| self.syntax_fault(&error, offset(reader.error_position())))?;
            match event {
                Event::Eof => break,
                Event::Start(tag) => {
                    check_attributes(&tag, start)?;
                    self.enter(start, tag.name().as_ref().len())?;
                }
                Event::Empty(tag) => {
                    check_attributes(&tag, start)?;
                    self.enter(start, tag.name().as_ref().len())?;
                    self.leave();
                }
                Event::End(_) => {
                    self.push(start);
                    self.leave();
                }
                Event::Text(text) => {
                    if self.open.is_empty()
                        && let Some(at) = text.find(|c: char| !c.is_ascii_whitespace())
                    {
                        return Err(self.stray_text_fault(start + at));
                    }
                    self.push(start);
                }
                Event::CData(_) | Event::GeneralRef(_) if self.open.is_empty() => {
                    return Err(self.stray_text_fault(start));
                }
                Event::DocType(text) if text.contains('[') => {
                    return Err((SyntaxFault::DoctypeSubset, start));
                }
                _ => self.push(start),
            }
        }
        self.finish()
    }

    /// Stores the piece that begins at `start`.
    fn push(&mut self, start: usize) {
        // Offsets fit: the length was checked before scanning.
        self.pieces.push(start as u32);
    }

    /// Opens an element at the byte `start`.
    ///
    /// # Errors
    /// It is a second outermost element.
    fn enter(&mut self, start: usize, name_len: usize) -> Result<(), Fault> {
        if self.open.is_empty() && !self.elements.is_empty() {
            return Err((SyntaxFault::SecondRoot, start));
        }
        let open = self.pieces.len() as u32;
        self.push(start);
        let id = self.elements.len() as u32;
        let parent = self.open.last().copied().unwrap_or(0);
        let (name_start, name_len) = (start as u32 + 1, name_len as u32);
        let subtree_end = id + 1;
        self.elements.push(StoredElement { open, close: open, parent, subtree_end, name_start, name_len });
        self.open.push(id);
        Ok(())
    }

    fn leave(&mut self) {
        let (close, end) = (self.pieces.len() as u32 - 1, self.elements.len() as u32);
        if let Some(element) = self.open.pop().and_then(|id| self.elements.get_mut(id as usize)) {
            element.close = close;
            element.subtree_end = end;
        }
    }

    fn finish(self) -> Result<(Vec<u32>, Vec<StoredElement>), Fault> {
        if let Some(element) = self.open.last().and_then(|&id| self.elements.get(id as usize)) {
            let start = self.pieces.get(element.open as usize).map_or(0, |&start| start as usize);
            let tag = tag_name(self.text.get(start..).unwrap_or_default());
            return Err((SyntaxFault::Unclosed { tag }, start));
        }
        if self.elements.is_empty() {
            let is_empty = self.text.trim_start_matches('\u{feff}').trim_ascii().is_empty();
            return Err((if is_empty { SyntaxFault::Empty } else { SyntaxFault::NotXml }, 0));
        }
        Ok((self.pieces, self.elements))
    }

    fn stray_text_fault(&self, at: usize) -> Fault {
        let kind = match self.elements.is_empty() {
            true if self.text.contains("endheader") => SyntaxFault::Motion,
            true if has_model_column(self.text) => SyntaxFault::Table,
            true => SyntaxFault::NotXml,
            false => SyntaxFault::TextOutsideRoot,
        };
        (kind, at)
    }

    fn syntax_fault(&self, error: &quick_xml::Error, at: usize) -> Fault {
        use quick_xml::errors::{Error, IllFormedError};
        let kind = match error {
            Error::IllFormed(IllFormedError::MismatchedEndTag { expected, found }) => {
                SyntaxFault::MismatchedEnd { expected: expected.clone(), found: found.clone() }
            }
            Error::IllFormed(IllFormedError::UnmatchedEndTag(found)) => {
                SyntaxFault::UnexpectedEnd { found: found.clone() }
            }
            Error::Syntax(_) => SyntaxFault::Truncated { what: error.to_string() },
            other => SyntaxFault::Malformed { what: other.to_string() },
        };
        (kind, self.base + at)
    }
}

/// Converts a position of quick-xml from `u64`. It never exceeds the length of the bytes.
fn offset(position: u64) -> usize {
    usize::try_from(position).unwrap_or(usize::MAX)
}

/// Whether the first line of a text names the columns of a table, one of them `model`.
fn has_model_column(text: &str) -> bool {
    let first = text.lines().next().unwrap_or_default();
    first.split([',', ';', '\t']).any(|cell| cell.trim_matches(['"', '\u{feff}', ' ']) == "model")
}

fn tag_name(tag: &str) -> String {
    let end = tag.find(|c: char| c.is_ascii_whitespace() || c == '>' || c == '/').unwrap_or(tag.len());
    tag.get(1..end).unwrap_or_default().to_owned()
}

/// Checks that every attribute can be parsed and that no name is repeated. The time is linear even for a very large number of attributes.
fn check_attributes(tag: &BytesStart<'_>, start: usize) -> Result<(), Fault> {
    let name = tag.name();
    if tag.len() == name.as_ref().len() {
        return Ok(());
    }
    let mut attributes = tag.attributes();
    attributes.with_checks(false);
    let mut names: HashSet<&str> = HashSet::new();
    for attribute in attributes {
        let attribute = attribute.map_err(|error| {
            (SyntaxFault::Attribute { tag: name.as_ref().to_owned(), what: error.to_string() }, start)
        })?;
        let key = attribute.key.into_inner();
        if !names.insert(key) {
            let what = format!("attribute '{key}' appears twice");
            return Err((SyntaxFault::Attribute { tag: name.as_ref().to_owned(), what }, start));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::xml::tree::{ElementId, PieceKind};

    #[track_caller]
    fn fault_of_xml(bytes: &[u8]) -> (SyntaxFault, usize) {
        let error = Tree::scan(bytes.to_vec()).unwrap_err();
        (error.fault, error.offset)
    }

    #[test]
    fn pieces_tile_the_file() {
        let text =
            b"\xEF\xBB\xBF<?xml version='1.0'?>\r\n<a x='1'>t<!-- <!-- -->&amp;<b/><![CDATA[<]]></a>\n";
        let tree = Tree::scan(text.to_vec()).unwrap();
        let mut at = 0;
        for piece in tree.pieces() {
            assert_eq!(piece.span.start, at);
            assert!(piece.span.end > piece.span.start);
            at = piece.span.end;
        }
        assert_eq!(at, text.len());
        assert_eq!(kinds_of(&tree), kinds_by_parser(str::from_utf8(text).unwrap()));
    }

    fn kinds_of(tree: &Tree) -> Vec<PieceKind> {
        tree.pieces().map(|piece| piece.kind).collect()
    }

    /// The kinds of the pieces of `text`, as the parser names them.
    fn kinds_by_parser(text: &str) -> Vec<PieceKind> {
        let rest = text.trim_start_matches('\u{feff}');
        let mut kinds = vec![PieceKind::ByteOrderMark; usize::from(rest.len() < text.len())];
        let mut reader = Reader::from_str(rest);
        reader.config_mut().allow_dangling_amp = true;
        loop {
            kinds.push(match reader.read_event().unwrap() {
                Event::Eof => return kinds,
                Event::Start(_) => PieceKind::Open,
                Event::Empty(_) => PieceKind::Empty,
                Event::End(_) => PieceKind::Close,
                Event::Text(_) => PieceKind::Text,
                Event::CData(_) => PieceKind::CData,
                Event::GeneralRef(_) => PieceKind::Reference,
                Event::Comment(_) => PieceKind::Comment,
                Event::DocType(_) | Event::Decl(_) | Event::PI(_) => PieceKind::Other,
            });
        }
    }

    #[test]
    fn elements_know_their_children_and_spans() {
        let text = "<a><b n='1'><c/></b><d>x</d></a>";
        let tree = Tree::scan(text.as_bytes().to_vec()).unwrap();
        let names: Vec<_> = tree.children(ElementId::ROOT).map(|id| tree.name(id)).collect();
        assert_eq!(names, ["b", "d"]);
        let b = tree.child(ElementId::ROOT, "b").unwrap();
        assert_eq!(&text[tree.span(b)], "<b n='1'><c/></b>");
        assert_eq!(tree.attribute(b, "n").as_deref(), Some("1"));
        assert_eq!(tree.attribute(b, "m"), None);
        assert_eq!(tree.parent(b), Some(ElementId::ROOT));
    }

    #[test]
    fn bytes_that_are_not_one_document_are_refused_at_the_first_error() {
        assert_eq!(fault_of_xml(b""), (SyntaxFault::Empty, 0));
        assert_eq!(fault_of_xml(b" \r\n"), (SyntaxFault::Empty, 0));
        assert_eq!(fault_of_xml(b"mass 62"), (SyntaxFault::NotXml, 0));
        assert_eq!(fault_of_xml(b"#subject;\"model\"\n1;a.osim\n"), (SyntaxFault::Table, 0));
        assert_eq!(fault_of_xml(b"<a/><b/>"), (SyntaxFault::SecondRoot, 4));
        assert_eq!(fault_of_xml(b"<a/>x"), (SyntaxFault::TextOutsideRoot, 4));
        assert_eq!(fault_of_xml(b"<a><b></b>"), (SyntaxFault::Unclosed { tag: "a".into() }, 0));
        assert_eq!(fault_of_xml(b"\xFF\xFE<\0a\0"), (SyntaxFault::Utf16, 0));
        assert_eq!(fault_of_xml(b"\xEF\xBB\xBF\xEF\xBB\xBF<a/>"), (SyntaxFault::SecondByteOrderMark, 3));
        assert_eq!(fault_of_xml(b"<!DOCTYPE a [<!ENTITY b 'c'>]><a/>"), (SyntaxFault::DoctypeSubset, 0));
        assert!(matches!(fault_of_xml(b"<a></b>"), (SyntaxFault::MismatchedEnd { .. }, 3)));
        assert!(matches!(fault_of_xml(b"<a x='1' x='2'/>"), (SyntaxFault::Attribute { .. }, 0)));
        assert!(matches!(fault_of_xml(b"<a><b"), (SyntaxFault::Truncated { .. }, 3)));
    }

    /// Models with one changed byte: either both scans agree, or the plain scan leaves the file to the full scan.
    #[test]
    fn the_plain_scan_finds_what_the_full_scan_finds() {
        let text = "\u{feff}<?xml version='1.0'?>\r\n<a x='1' y=\"2 > 1\">t<!-- <!-- -->&amp;<b/>\n<c d='é' ><e>\
                </e></c ><![CDATA[<]]><f/ ></a>\n";
        let plain = "<?xml version=\"1.0\"?>\n<a x='1' y=\"2\">t > é<!-- <!-- -- -->\n<b/><c d='' ><e>1</e></c></a>\n";
        assert!(scan_plain(plain, 0).is_some());
        let mut left = 0;
        for text in [text, plain] {
            for at in 0..text.len() {
                for byte in *b"<>/&;'\"= \n!-?ax1:[]\x96\x0c" {
                    let mut bytes = text.as_bytes().to_vec();
                    bytes[at] = byte;
                    let file = FileText::new(bytes);
                    let text = file.as_str();
                    if let Ok(tree) = Tree::scan(text) {
                        assert_eq!(kinds_of(&tree), kinds_by_parser(text), "{text}");
                    }
                    match scan_plain(text, 0) {
                        Some(found) => assert_eq!(Scanner::new(text, 0).run(), Ok(found), "{text}"),
                        None => left += 1,
                    }
                }
                for bytes in [&text.as_bytes()[..at], &text.as_bytes()[at..]] {
                    let file = FileText::new(bytes.to_vec());
                    let text = file.as_str();
                    if let Some(found) = scan_plain(text, 0) {
                        assert_eq!(Scanner::new(text, 0).run(), Ok(found), "{text}");
                    }
                }
            }
        }
        assert!(left > 1000);
    }

    #[test]
    fn deep_elements_and_many_attributes_take_linear_time() {
        let deep = "<a>".repeat(100_000) + &"</a>".repeat(100_000);
        assert_eq!(Tree::scan(deep.into_bytes()).unwrap().element_count(), 100_000);
        let wide: String = (0..100_000).map(|i| format!(" a{i}='1'")).collect();
        assert!(Tree::scan(format!("<a{wide}/>").into_bytes()).is_ok());
    }
}
