//! Notes in comments: those of standalone sets, and those that earlier versions left in models.

use std::ops::Range;

use super::data::{Note, Scope, Unreadable};
use super::grammar::BEGINS;
use super::spelling::{gravity_m_s2, mass_kg};
use super::step::Step;
use crate::model::document::Document;
use crate::xml::PieceKind;

/// How the comments of earlier versions begin.
const EARLIER: &str = "osim-contact-scale ";

impl Note {
    /// The comment that holds the note in a document without credits: one line, no `--` inside.
    #[must_use]
    pub fn comment(&self) -> String {
        format!("<!-- {} -->", self.text())
    }

    /// Reads the comment of an earlier version: `<!-- osim-contact-scale 0.1.0: contacts stand for 500 kg; gravity 9.80665 m/s2;
    /// scope all; by rescale; digest 0123456789abcdef -->`.
    fn parse_earlier(text: &str) -> Option<Self> {
        let (version, rest) = text.strip_prefix(EARLIER)?.trim_ascii_start().split_once(": ")?;
        let mut fields = rest.split("; ");
        let contacts_mass_kg =
            mass_kg(fields.next()?.strip_prefix("contacts stand for ")?).or_else(|| {
                rest.split_once(';').and_then(|(mass, _)| mass.ends_with(" unknown kg").then_some(None))
            })?;
        let gravity_m_s2 = gravity_m_s2(fields.next()?.strip_prefix("gravity ")?)?;
        let scope = match fields.next()?.strip_prefix("scope ")? {
            "all" => Scope::All,
            "partial" => Scope::Partial,
            _ => return None,
        };
        let steps = vec![Step::new(fields.next()?.strip_prefix("by ")?)];
        let digest = fields.next()?.strip_prefix("digest ")?.to_owned();
        let (version, made) = (version.to_owned(), Self::nothing_made());
        let (sizes, radii, parts, places, added) = (Vec::new(), None, None, None, Vec::new());
        let (stance_limbs, weighed_kg) = (None, None);
        let note = Self {
            version,
            contacts_mass_kg,
            gravity_m_s2,
            scope,
            steps,
            stance_limbs,
            weighed_kg,
            sizes,
            digest,
            radii,
            parts,
            places,
            made,
            added,
        };
        fields.next().is_none().then_some(note)
    }
}

/// The comments before the first child of the data root that begin like a note.
pub(super) fn spans(document: &Document) -> impl Iterator<Item = Range<usize>> + '_ {
    let tree = document.tree();
    let root = document.data_root();
    // Other comments may stand around it, elements may not stand before it.
    let end = tree.children(root).next().map_or(tree.close_span(root).start, |child| tree.span(child).start);
    tree.content(root)
        .take_while(move |piece| piece.span.start < end)
        .filter(|piece| piece.kind == PieceKind::Comment)
        .filter(|piece| [EARLIER, BEGINS].iter().any(|begins| inner(piece.text).starts_with(begins)))
        .map(|piece| piece.span)
}

pub(super) fn find(document: &Document) -> Option<Result<Note, Unreadable>> {
    let text = inner(document.tree().slice(spans(document).next()?));
    Some(Note::parse(text).or_else(|| Note::parse_earlier(text)).ok_or(Unreadable))
}

fn inner(comment: &str) -> &str {
    let text = comment.strip_prefix("<!--").unwrap_or(comment);
    text.strip_suffix("-->").unwrap_or(text).trim_ascii()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_of_earlier_versions_are_read() {
        let text = "osim-contact-scale 0.1.0: contacts stand for 500 kg; gravity 9.80665 m/s2; scope all; by rescale; \
                    digest 0123456789abcdef";
        let note = Note::parse_earlier(text).unwrap();
        assert_eq!(
            (note.contacts_mass_kg, note.gravity_m_s2, note.scope),
            (Some(500.0), Some(9.80665), Scope::All)
        );
        assert_eq!((note.operation(), note.digest.as_str()), ("rescale", "0123456789abcdef"));
        assert_eq!((note.places, note.sizes), (None, vec![]));
        let unknown = text.replace("500 kg", "unknown kg").replace("9.80665 m/s2", "unknown");
        let note = Note::parse_earlier(&unknown).unwrap();
        assert_eq!((note.contacts_mass_kg, note.gravity_m_s2), (None, None));
    }

    #[test]
    fn other_comments_are_not_notes() {
        for text in ["a", "osim-contact-scale", "osim-contact-scale 1: contacts stand for x kg"] {
            assert_eq!(Note::parse_earlier(text), None);
        }
    }
}
