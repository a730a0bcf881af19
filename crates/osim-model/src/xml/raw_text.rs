//! The text of an element without child elements, and the white space around the text.

use std::borrow::Cow;
use std::ops::Range;

use super::tree::{ElementId, PieceKind, StoredElement, Tree, decode};

/// The text between the tags of an element.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RawText<'t> {
    /// The text with entities and CDATA resolved, without comments, and without the white space around it, as OpenSim reads it. White space
    /// from CDATA or a reference is kept.
    pub text: Cow<'t, str>,
    /// The bytes of the text in the file, without the white space around it: an edit replaces these bytes. Empty, at the place where text
    /// would begin, if there is no text.
    pub span: Range<usize>,
    /// Whether the text is in one piece: plain text or one CDATA section, not both, without an element or a comment inside. For other text,
    /// OpenSim reports an error.
    pub in_one_piece: bool,
}

impl Tree {
    pub fn raw_text(&self, id: ElementId) -> RawText<'_> {
        if let Some((text, span)) = self.plain_text(id) {
            return RawText { text: Cow::Borrowed(text), span, in_one_piece: true };
        }
        let start = self.open_span(id).end;
        let mut text = String::new();
        let mut raw = RawText { text: Cow::Borrowed(""), span: start..start, in_one_piece: true };
        let (mut begun, mut interrupted, mut texts, mut sections) = (false, false, false, 0);
        // Where the text ends without white space that only lies between it and the tag.
        let mut end = 0;
        for piece in self.content(id) {
            let (source, mut span) = (piece.text, piece.span);
            match piece.kind {
                PieceKind::Text => {
                    let inner = trimmed(source);
                    let before = source.find(|letter| !is_white(letter)).unwrap_or(source.len());
                    text.push_str(if begun { source } else { source.get(before..).unwrap_or_default() });
                    if inner.is_empty() {
                        continue;
                    }
                    texts = true;
                    let behind = source.len() - before - inner.len();
                    (span.start, span.end) = (span.start + before, span.end - behind);
                    end = text.len() - behind;
                }
                PieceKind::CData => {
                    sections += 1;
                    let inner = source.strip_prefix("<![CDATA[").and_then(|s| s.strip_suffix("]]>"));
                    text.push_str(inner.unwrap_or_default());
                    end = text.len();
                }
                PieceKind::Reference => {
                    texts = true;
                    text.push_str(&decode(Cow::Borrowed(source)));
                    end = text.len();
                }
                PieceKind::Comment | PieceKind::Other => {
                    interrupted = begun;
                    continue;
                }
                // An element where text should be.
                _ => {
                    raw.in_one_piece = false;
                    continue;
                }
            }
            raw.in_one_piece &= !interrupted;
            raw.span = if begun { raw.span.start..span.end } else { span };
            begun = true;
        }
        text.truncate(end);
        raw.text = Cow::Owned(text);
        // OpenSim takes text or one section of CDATA.
        raw.in_one_piece &= sections == 0 || (sections == 1 && !texts);
        raw
    }

    /// The text of `id` and its bytes, if there is nothing but character data between the tags.
    fn plain_text(&self, id: ElementId) -> Option<(&str, Range<usize>)> {
        let StoredElement { open, close, .. } = self.element(id);
        let start = self.piece_span(open as usize).end;
        if close - open < 2 {
            return Some(("", start..start));
        }
        let piece = self.piece(open as usize + 1);
        let piece = piece.filter(|piece| piece.kind == PieceKind::Text && close - open == 2)?;
        let inner = inside_white(piece.text);
        Some((piece.text.get(inner.clone())?, start + inner.start..start + inner.end))
    }

    /// The text of `id`, for names and paths.
    pub fn text_of(&self, id: ElementId) -> Cow<'_, str> {
        self.raw_text(id).text
    }

    /// The text of `id`; `None` if OpenSim would report an error, because it is not [`in_one_piece`](RawText::in_one_piece).
    pub(crate) fn whole_text(&self, id: ElementId) -> Option<Cow<'_, str>> {
        let raw = self.raw_text(id);
        raw.in_one_piece.then_some(raw.text)
    }
}

// White space as C has it, which models are read with.

/// Whether the language C counts `letter` as white space.
pub const fn is_white(letter: char) -> bool {
    matches!(letter, ' ' | '\t'..='\r')
}

/// Whether a byte is white space in XML. This white space is ASCII, so text between such bytes consists of whole letters.
pub(super) const fn is_white_byte(byte: u8) -> bool {
    is_white(byte as char)
}

/// `text` without the white space around it.
pub fn trimmed(text: &str) -> &str {
    text.get(inside_white(text)).unwrap_or_default()
}

/// The bytes of `text` inside the white space around it; none, at the start, if there is nothing else.
fn inside_white(text: &str) -> Range<usize> {
    let is_letter = |byte: &u8| !is_white_byte(*byte);
    let start = text.as_bytes().iter().position(is_letter).unwrap_or_default();
    start..text.as_bytes().iter().rposition(is_letter).map_or(start, |last| last + 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::xml::tree::Tree;

    #[test]
    fn the_span_is_the_text_without_the_white_space_around_it() {
        for (xml, number) in [
            ("<a>  1e6 </a>", "1e6"),
            ("<a><!--x--> <![CDATA[2]]> </a>", "<![CDATA[2]]>"),
            ("<a>1&#46;5</a>", "1&#46;5"),
            ("<a>&#49;e6 <!--x--></a>", "&#49;e6"),
            ("<a>\u{b}1e6\u{c}</a>", "1e6"),
            ("<a>\u{a0}1e6</a>", "\u{a0}1e6"),
            ("<a>1e6&#32;</a>", "1e6&#32;"),
            ("<a></a>", ""),
        ] {
            let tree = Tree::scan(xml).unwrap();
            assert_eq!(&xml[tree.raw_text(ElementId::ROOT).span], number, "{xml}");
        }
    }

    #[test]
    fn white_space_around_a_text_is_left_out_as_opensim_does() {
        for (xml, text) in [
            ("<a>\u{b} 1 2\n</a>", "1 2"),
            ("<a><!-- x --> 1 <!-- y --> </a>", "1"),
            ("<a>&#32;1&#32; </a>", " 1 "),
            ("<a> <![CDATA[ 1 ]]> </a>", " 1 "),
            ("<a>1 &amp; 2</a>", "1 & 2"),
            ("<a>\u{a0}1</a>", "\u{a0}1"),
            ("<a> </a>", ""),
        ] {
            assert_eq!(Tree::scan(xml).unwrap().raw_text(ElementId::ROOT).text, text, "{xml}");
        }
    }

    #[test]
    fn a_value_may_be_one_cdata_section_but_not_two() {
        for (xml, whole) in [
            ("<a> <![CDATA[1]]> </a>", true),
            ("<a><![CDATA[1]]><![CDATA[2]]></a>", false),
            ("<a><![CDATA[1]]>2</a>", false),
            ("<a>&#49;<![CDATA[2]]></a>", false),
            ("<a>1<!-- x --> </a>", true),
            ("<a>1<!-- x -->2</a>", false),
        ] {
            assert_eq!(Tree::scan(xml).unwrap().raw_text(ElementId::ROOT).in_one_piece, whole, "{xml}");
        }
    }
}
