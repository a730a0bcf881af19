//! The one comment line the tool leaves in a model: the mass its contacts were made for.
//!
//! `<!-- osim-contact-scale 0.1.0: contacts stand for 500 kg; gravity 9.80665 m/s2; scope all; by rescale; digest 0123456789abcdef -->`

use std::ops::Range;

use crate::document::Document;
use crate::number::shortest;
use crate::xml::PieceKind;

const NAME: &str = "osim-contact-scale";

/// How much of the contacts a change covered: all or not all.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scope {
    /// Every default force and every default property.
    All,
    /// Something was left behind.
    Partial,
}

/// The contents of a note: what its contacts were made for, written into the file when they were changed.
///
/// ```
/// use osim_model::{Document, Note, Scope};
///
/// let text = r#"<OpenSimDocument Version="40000"><Model name="walker">
/// <!-- osim-contact-scale 0.1.0: contacts stand for 500 kg; gravity 9.81 m/s2; scope all; by rescale; digest 0123456789abcdef -->
/// </Model></OpenSimDocument>"#;
/// let note = Note::find(&Document::parse(text)?).expect("there is a note");
/// assert_eq!((note.mass_kg, note.gravity_m_s2, note.scope), (Some(500.0), Some(9.81), Scope::All));
/// // The comment is written as it was read.
/// assert!(text.contains(&note.comment()));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Note {
    /// Version of the tool that wrote it.
    pub version: String,
    /// Mass the contacts were made for, kg; `None` where nobody knew.
    pub mass_kg: Option<f64>,
    /// Gravity the contacts were made for, m/s²; `None` where the model has none.
    pub gravity_m_s2: Option<f64>,
    /// All contacts or only some.
    pub scope: Scope,
    /// What was done, for example `rescale` or `set stiffness=x2`.
    pub operation: String,
    /// Digest of all contact values as written: the first 16 digits of their SHA-256.
    pub digest: String,
}

impl Note {
    /// Finds the note of `document`: a comment before the first child of the data root. `None` where there is none or it
    /// cannot be read.
    #[must_use]
    pub fn find(document: &Document) -> Option<Self> {
        let span = Self::span(document)?;
        Self::parse(document.tree().slice(span))
    }

    /// Whether there is a comment that begins like a note, readable or not.
    pub(crate) fn is_there(document: &Document) -> bool {
        Self::span(document).is_some()
    }

    /// The bytes of the note's comment.
    #[must_use]
    pub fn span(document: &Document) -> Option<Range<usize>> {
        let tree = document.tree();
        let root = document.data_root();
        // The note is the first child; other comments may stand around it, elements may not stand before it.
        let end =
            tree.children(root).next().map_or(tree.close_span(root).start, |child| tree.span(child).start);
        tree.content(root)
            .take_while(|piece| piece.span.start < end)
            .filter(|piece| piece.kind == PieceKind::Comment)
            .find(|piece| {
                let text = piece.text.trim_start_matches("<!--").trim_start();
                text.strip_prefix(NAME).is_some_and(|rest| rest.starts_with(' '))
            })
            .map(|piece| piece.span)
    }

    fn parse(comment: &str) -> Option<Self> {
        let text = comment.strip_prefix("<!--")?.strip_suffix("-->")?.trim();
        let (version, rest) = text.strip_prefix(NAME)?.trim_start().split_once(": ")?;
        let mut fields = rest.split("; ");
        let mass_kg = match fields.next()?.strip_prefix("contacts stand for ")?.strip_suffix(" kg")? {
            "unknown" => None,
            text => Some(text.parse::<f64>().ok().filter(|mass| mass.is_finite() && *mass > 0.0)?),
        };
        let gravity = fields.next()?.strip_prefix("gravity ")?;
        let gravity_m_s2 = match gravity {
            "unknown" => None,
            text => Some(text.strip_suffix(" m/s2")?.parse().ok()?),
        };
        let scope = match fields.next()?.strip_prefix("scope ")? {
            "all" => Scope::All,
            "partial" => Scope::Partial,
            _ => return None,
        };
        let operation = fields.next()?.strip_prefix("by ")?.to_owned();
        let digest = fields.next()?.strip_prefix("digest ")?.to_owned();
        let version = version.to_owned();
        let note = Self { version, mass_kg, gravity_m_s2, scope, operation, digest };
        fields.next().is_none().then_some(note)
    }

    /// The comment as it is in the file: one line, no `--` inside.
    #[must_use]
    pub fn comment(&self) -> String {
        let gravity = self.gravity_m_s2.map_or("unknown".to_owned(), |g| format!("{} m/s2", shortest(g)));
        let scope = match self.scope {
            Scope::All => "all",
            Scope::Partial => "partial",
        };
        // An XML comment must not hold `--`, and `; ` stands between the fields.
        let operation = self.operation.replace("--", "").replace(';', ",");
        format!(
            "<!-- {NAME} {}: contacts stand for {} kg; gravity {gravity}; scope {scope}; by {operation}; digest {} -->",
            self.version,
            self.mass_kg.map_or("unknown".to_owned(), shortest),
            self.digest
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_note_reads_back_as_written() {
        let note = Note {
            version: "0.1.0".into(),
            mass_kg: Some(0.0209),
            gravity_m_s2: Some(9.80665),
            scope: Scope::Partial,
            operation: "set stiffness=x2".into(),
            digest: "0123456789abcdef".into(),
        };
        assert_eq!(Note::parse(&note.comment()), Some(note.clone()));
        let unknown = Note { gravity_m_s2: None, ..note };
        assert_eq!(Note::parse(&unknown.comment()), Some(unknown));
    }

    #[test]
    fn other_comments_are_not_notes() {
        for text in [
            "<!-- a -->",
            "<!-- osim-contact-scale -->",
            "<!-- osim-contact-scale 1: contacts stand for x kg -->",
        ] {
            assert_eq!(Note::parse(text), None);
        }
    }
}
