//! The text of a leaf element.

use std::borrow::Cow;
use std::ops::Range;

use super::decode::decode;
use super::tree::{ElementId, PieceKind, Tree};

/// The text between an element's tags.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct RawText {
    /// Entities and CDATA resolved, comments left out.
    pub text: String,
    /// The bytes that hold the text without the white space around it; what an edit replaces.
    /// Empty (at the place where text would start) when there is none.
    pub span: Range<usize>,
    /// `false` when a comment or an element is inside the text: OpenSim reads such a value as an error.
    pub whole: bool,
}

impl Tree {
    /// Reads the text of `id`.
    #[must_use]
    pub fn raw_text(&self, id: ElementId) -> RawText {
        let start = self.open_span(id).end;
        let mut raw = RawText { text: String::new(), span: start..start, whole: true };
        let (mut begun, mut interrupted, mut kinds) = (false, false, (false, false));
        for piece in self.content(id) {
            let (source, mut span) = (piece.text, piece.span);
            match piece.kind {
                PieceKind::Text => {
                    raw.text.push_str(source);
                    let inner = source.trim_ascii();
                    if inner.is_empty() {
                        continue;
                    }
                    kinds.0 = true;
                    span.start += source.len() - source.trim_ascii_start().len();
                    span.end -= source.len() - source.trim_ascii_end().len();
                }
                PieceKind::CData => {
                    kinds.1 = true;
                    let inner = source.strip_prefix("<![CDATA[").and_then(|s| s.strip_suffix("]]>"));
                    raw.text.push_str(inner.unwrap_or_default());
                }
                PieceKind::Reference => {
                    kinds.0 = true;
                    raw.text.push_str(&decode(Cow::Borrowed(source)));
                }
                PieceKind::Comment | PieceKind::Other => {
                    interrupted = begun;
                    continue;
                }
                // An element where text should be.
                _ => {
                    raw.whole = false;
                    continue;
                }
            }
            raw.whole &= !interrupted;
            raw.span = if begun { raw.span.start..span.end } else { span };
            begun = true;
        }
        // OpenSim takes text or CDATA, not both.
        raw.whole &= kinds != (true, true);
        raw
    }

    /// The trimmed text of `id`; for names, paths and flags.
    #[must_use]
    pub fn text_of(&self, id: ElementId) -> String {
        self.raw_text(id).text.trim().to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::super::tree::Tree;
    use super::*;

    #[test]
    fn the_span_is_the_number_without_its_surroundings() {
        for (xml, number) in [
            ("<a>  1e6 </a>", "1e6"),
            ("<a><!--x--> <![CDATA[2]]> </a>", "<![CDATA[2]]>"),
            ("<a>1&#46;5</a>", "1&#46;5"),
            ("<a>&#49;e6 <!--x--></a>", "&#49;e6"),
            ("<a></a>", ""),
        ] {
            let raw = Tree::scan(xml).unwrap().raw_text(ElementId::ROOT);
            assert_eq!(&xml[raw.span], number, "{xml}");
        }
    }
}
