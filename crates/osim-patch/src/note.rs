//! The one comment line the tool leaves in a model: what its contacts stand for.
//!
//! `<!-- osim-contact-scale 0.1.0: contacts stand for 500 kg; gravity 9.80665 m/s2; scope all; by rescale; digest 0123456789abcdef -->`

use std::ops::Range;

use sha2::{Digest, Sha256};

use crate::document::Document;
use crate::model::Model;
use crate::number::shortest;
use crate::property::Property;
use crate::xml::{ElementId, PieceKind};

const NAME: &str = "osim-contact-scale";

/// How much of the contacts a run covered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scope {
    /// Every default force and every default property.
    All,
    /// Something was left behind.
    Partial,
}

/// The contents of a note.
#[derive(Debug, Clone, PartialEq)]
pub struct Note {
    /// Version of the tool that wrote it.
    pub version: String,
    /// Mass the contacts stand for, kg; `None` where nobody knew.
    pub mass_kg: Option<f64>,
    /// Gravity the contacts stand for, m/s²; `None` where the model has none.
    pub gravity_m_s2: Option<f64>,
    /// All contacts or only some.
    pub scope: Scope,
    /// What was done, for example `rescale` or `set stiffness=x2`.
    pub operation: String,
    /// Digest of all contact values as written: the first 16 digits of their SHA-256.
    pub digest: String,
}

impl Note {
    /// Finds the note of `document`: a comment that is a child of the data root.
    #[must_use]
    pub fn find(document: &Document<'_>) -> Option<Self> {
        let span = Self::span(document)?;
        Self::parse(document.tree().slice(span))
    }

    /// Whether there is a comment that begins like a note, readable or not.
    pub(crate) fn is_there(document: &Document<'_>) -> bool {
        Self::span(document).is_some()
    }

    /// Why the note no longer speaks for the contacts of `model`, if it does not.
    pub(crate) fn doubt(&self, model: &Model<'_, '_>) -> Option<&'static str> {
        if self.digest != digest(model, |_| None) {
            Some("the values are no longer those the note was written for")
        } else if self.scope == Scope::Partial {
            Some("only some values were changed by the run that left the note")
        } else if self.mass_kg.is_none() {
            Some("the mass was not known when the note was written")
        } else {
            None
        }
    }

    /// The bytes of the note's comment.
    pub(crate) fn span(document: &Document<'_>) -> Option<Range<usize>> {
        let tree = document.tree();
        let root = document.data_root();
        // The note is the first child; other comments may stand around it, elements may not stand before it.
        let end =
            tree.children(root).next().map_or(tree.close_span(root).start, |child| tree.span(child).start);
        tree.content_pieces(root)
            .take_while(|&index| tree.piece_span(index).start < end)
            .filter(|&index| tree.pieces().get(index).is_some_and(|piece| piece.kind == PieceKind::Comment))
            .map(|index| tree.piece_span(index))
            .find(|span| {
                let text = tree.slice(span.clone()).trim_start_matches("<!--").trim_start();
                text.strip_prefix(NAME).is_some_and(|rest| rest.starts_with(' '))
            })
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

    /// The comment as it stands in the file: one line, no `--` inside.
    #[must_use]
    pub fn comment(&self) -> String {
        let gravity = self.gravity_m_s2.map_or("unknown".to_owned(), |g| format!("{} m/s2", shortest(g)));
        let scope = match self.scope {
            Scope::All => "all",
            Scope::Partial => "partial",
        };
        // An XML comment must not hold `--`, and the fields are parted by `; `.
        let operation = self.operation.replace("--", "").replace(';', ",");
        format!(
            "<!-- {NAME} {}: contacts stand for {} kg; gravity {gravity}; scope {scope}; by {operation}; digest {} -->",
            self.version,
            self.mass_kg.map_or("unknown".to_owned(), shortest),
            self.digest
        )
    }
}

/// Which number of the model: file, element, property.
pub(crate) type Key = (usize, ElementId, Property);

/// Digest of all contact values: parameters of every contact force and radii of their spheres.
///
/// `changed` gives the new value of those a plan changes. The same numbers have the same digest whatever their spelling
/// and wherever they stand in the file.
pub(crate) fn digest(model: &Model<'_, '_>, changed: impl Fn(Key) -> Option<f64>) -> String {
    let mut hash = Sha256::new();
    let mut feed = |path: &str, set: usize, property: Property, number: f64| {
        hash.update(path.as_bytes());
        hash.update([0]);
        hash.update((set as u64).to_le_bytes());
        hash.update(property.name().as_bytes());
        hash.update(number.to_bits().to_le_bytes());
    };
    for force in &model.forces {
        for (index, set) in force.sets.iter().enumerate() {
            for value in &set.values {
                let key = (force.file, set.element, value.property);
                feed(&force.path, index, value.property, changed(key).unwrap_or(value.number));
            }
        }
        let value = &force.transition_velocity;
        let key = (force.file, force.element, value.property);
        feed(&force.path, 0, value.property, changed(key).unwrap_or(value.number));
        for sphere in force.spheres().into_iter().filter_map(|sphere| model.spheres.get(sphere)) {
            let key = (sphere.file, sphere.element, Property::Radius);
            feed(&sphere.path, 0, Property::Radius, changed(key).unwrap_or(sphere.radius.number));
        }
    }
    hash.finalize().iter().take(8).map(|byte| format!("{byte:02x}")).collect()
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
