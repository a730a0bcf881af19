//! The note that this program writes into a model: the mass for which the contacts were made, the sizes of bones, and the changes.
//!
//! The note of a model is in `<credits>`, which every OpenSim from 1.9 to 4.6 keeps when it saves or scales a model; comments are lost
//! then. Sets in separate files have no credits: their note is a comment.

pub(super) mod content;
mod grammar;

use std::ops::Range;

use crate::model::note::content::UnreadableNote;
use crate::model::note::grammar::{NOTE_BEGIN, NOTE_END, PROGRAM_MARK};
use crate::model::{Document, Fault, FaultKind, MassRequest, Model, Property, Result, are_equal_masses};
use crate::xml::opensim_text::{is_white, words};
use crate::xml::{ElementId, PieceKind};

pub use content::{BodySize, Note, NotedNames, NotedParts, Scope, Source, Step};

/// The separator between other text in the credits and the note, and between authors.
const CREDITS_SEPARATOR: &str = "; ";
/// The texts before and after a CDATA section.
const CDATA_MARKS: (&str, &str) = ("<![CDATA[", "]]>");

/// The `<credits>` of a model with their text, up to the first comment after it, without white space around it. The note is part of this
/// text.
///
/// OpenSim reads one text or one CDATA section here, with comments before or after it; it refuses a model with other contents.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Credits<'d> {
    pub element: ElementId,
    /// Bytes of the text in the credits; empty if there is no text. For an element `<credits/>`, the place after the element.
    pub span: Range<usize>,
    raw: &'d str,
    /// The text as OpenSim reads it: entities resolved, white space reduced to single blanks.
    text: String,
}

impl<'d> Credits<'d> {
    /// The first `<credits>` of a model; `None` if it has none, or the document is not a model. Those in `<defaults>` are ignored.
    ///
    /// # Errors
    /// Text, CDATA and comments are mixed in a way that OpenSim refuses ([`FaultKind::BrokenText`]).
    pub fn of(document: &'d Document) -> Result<Option<Self>> {
        let (tree, root) = (document.tree(), document.data_root());
        if tree.name(root) != "Model" {
            return Ok(None);
        }
        let Some(element) = tree.child(root, "credits") else { return Ok(None) };
        let read = tree.raw_text(element);
        let mut span = read.span;
        let mut raw = tree.slice(span.clone());
        let is_cdata = raw.starts_with(CDATA_MARKS.0);
        let broken = !read.in_one_piece || (is_cdata && raw.matches(CDATA_MARKS.1).count() > 1);
        if broken {
            let property = "credits".to_owned();
            let fault = Fault::at_span(FaultKind::BrokenText { property }, tree.span(element));
            return Err(fault.located(document.bytes()));
        }
        if let Some(inner) = raw.strip_prefix(CDATA_MARKS.0).and_then(|rest| rest.strip_suffix(CDATA_MARKS.1))
        {
            let start = span.start + CDATA_MARKS.0.len() + (inner.len() - inner.trim_ascii_start().len());
            raw = inner.trim_ascii();
            span = start..start + raw.len();
        }
        let text = condensed(&read.text);
        Ok(Some(Self { element, span, raw, text }))
    }

    /// The text as OpenSim reads it: entities resolved, white space reduced to single blanks.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The note at the end of the text, if the text contains the beginning of a note.
    fn note(&self) -> Option<Result<Note, UnreadableNote>> {
        let at = self.text.rfind(NOTE_BEGIN)?;
        let note = self.text.get(at..)?;
        note.contains(PROGRAM_MARK).then(|| Note::parse(note).ok_or(UnreadableNote))
    }

    /// The edits after which the credits end with `note` instead of the old note. The text of other authors is not touched, because its
    /// bytes need not be UTF-8.
    pub fn edits(&self, note: Option<&Note>) -> Vec<(Range<usize>, String)> {
        let mut edits = Vec::new();
        let mut end = self.span.start;
        let kept = self.text_around_note();
        for part in &kept {
            let between = if end == self.span.start { "" } else { CREDITS_SEPARATOR };
            edits.push((end..part.start, between.to_owned()));
            end = part.end;
        }
        let and = if kept.is_empty() { "" } else { CREDITS_SEPARATOR };
        let last = note.map(|note| format!("{and}{}", note.text()));
        edits.push((end..self.span.end, last.unwrap_or_default()));
        edits.retain(|(span, text)| !(span.is_empty() && text.is_empty()));
        edits
    }

    /// The edits after which `note` is after all existing text, including another note.
    pub fn edits_for_another(&self, note: &Note) -> Vec<(Range<usize>, String)> {
        let and = if self.raw.is_empty() { "" } else { CREDITS_SEPARATOR };
        vec![(self.span.end..self.span.end, format!("{and}{}", note.text()))]
    }

    /// Whether the credits contain nothing except the note.
    pub fn is_note_only(&self) -> bool {
        self.text_around_note().is_empty()
    }

    /// Bytes of the credits before and after the note.
    fn text_around_note(&self) -> Vec<Range<usize>> {
        // People and their programs break lines where the note has a blank.
        let begins = |at: usize| self.raw.get(at..).is_some_and(begins_a_note);
        let found = self.raw.rmatch_indices('[').map(|(at, _)| at).find(|&at| begins(at));
        let around = found.and_then(|at| {
            let (before, rest) = self.raw.split_at(at);
            // Something else in square brackets is kept.
            let end =
                rest.find(NOTE_END).filter(|_| condensed(rest).contains(PROGRAM_MARK))? + NOTE_END.len();
            let behind = rest.get(end..)?;
            let before = before.trim_ascii_end();
            let behind = behind.trim_ascii_start();
            let behind = behind.strip_prefix(';').unwrap_or(behind).trim_ascii_start();
            Some((before.strip_suffix(';').unwrap_or(before).len(), behind.len()))
        });
        let (before, behind) = around.unwrap_or((self.raw.len(), 0));
        let (start, end) = (self.span.start, self.span.end);
        [start..start + before, end - behind..end].into_iter().filter(|part| !part.is_empty()).collect()
    }
}

impl Note {
    /// The note as a program would read it after writing; `None` if it could not be read.
    pub(crate) fn read_back(&self) -> Option<Self> {
        Self::parse(&condensed(&self.text()))
    }
}

/// Whether `text` begins like a note, with any white space in place of its blanks. Only the beginning of the text is read.
fn begins_a_note(text: &str) -> bool {
    let behind = NOTE_BEGIN.chars().try_fold(text, |rest, letter| {
        if letter != ' ' {
            return rest.strip_prefix(letter);
        }
        let behind = rest.trim_start_matches(is_white);
        (behind.len() < rest.len()).then_some(behind)
    });
    behind.is_some_and(|behind| !behind.is_empty())
}

/// `text` with single blanks, as OpenSim reads and writes it.
fn condensed(text: &str) -> String {
    words(text).collect::<Vec<_>>().join(" ")
}

// Where a note is: in the credits of a model, in a comment of a set.

impl Note {
    /// The XML comment with the note, for a document without credits: one line, no `--` inside.
    pub fn comment(&self) -> String {
        format!("<!-- {} -->", self.text())
    }

    /// The note of `document`: in the credits of a model; in a set, in a comment before the first child of the data root. `None` if there
    /// is none or it cannot be read.
    pub fn find(document: &Document) -> Option<Self> {
        Self::find_or_unreadable(document).ok()??.ok()
    }

    /// The note of `document`. `Err` inside if a text begins like a note and cannot be read, or if the credits do not end with it.
    pub(crate) fn find_or_unreadable(document: &Document) -> Result<Option<Result<Self, UnreadableNote>>> {
        if document.is_model() {
            return Ok(Credits::of(document)?.and_then(|credits| credits.note()));
        }
        let comment = Self::comment_spans(document).next();
        Ok(comment.map(|span| Self::parse(inner_text(document.tree().slice(span))).ok_or(UnreadableNote)))
    }

    /// The bytes of the comments in a set that begin like a note, before the first child of the data root. The first one is the note. A
    /// model has none.
    pub fn comment_spans(document: &Document) -> impl Iterator<Item = Range<usize>> + '_ {
        let tree = document.tree();
        let root = document.data_root();
        // Other comments may stand around it, elements may not stand before it.
        let end =
            tree.children(root).next().map_or(tree.close_span(root).start, |child| tree.span(child).start);
        tree.content(root)
            .take_while(move |piece| piece.span.start < end)
            .filter(|piece| {
                piece.kind == PieceKind::Comment && inner_text(piece.text).starts_with(NOTE_BEGIN)
            })
            .filter(|_| !document.is_model())
            .map(|piece| piece.span)
    }
}

fn inner_text(comment: &str) -> &str {
    let text = comment.strip_prefix("<!--").unwrap_or(comment);
    text.strip_suffix("-->").unwrap_or(text).trim_ascii()
}

/// The differences between a model and its note.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ChangedSinceNote {
    /// How the contacts differ from those that the note describes.
    pub contacts: ChangedContacts,
    /// Whether the mesh factors of bodies with spheres changed.
    pub sizes: bool,
    /// Mass of all bodies together when the note was written, and now, kg, if they differ.
    pub weight_kg: Option<(f64, f64)>,
}

/// The differences between contacts and their record in a note.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ChangedContacts {
    /// The recorded and the present number of spheres, if they differ. Then nothing else is compared.
    pub sphere_count: Option<(usize, usize)>,
    pub force_count: Option<(usize, usize)>,
    pub sphere_names: bool,
    pub force_names: bool,
    pub radii: bool,
    /// Whether places or bodies of spheres changed.
    pub places: bool,
    /// Properties of forces whose values changed.
    pub properties: Vec<Property>,
    /// Whether all values still exist, but at other contacts.
    pub exchanged: bool,
}

impl Model {
    /// The number of limbs that share the body weight, if the note has it.
    pub fn noted_stance_limbs(&self) -> Option<f64> {
        self.note.as_ref().and_then(|note| note.stance_limbs)
    }

    /// The differences between the model and its note; no differences without a note.
    pub fn changed_since_note(&self) -> ChangedSinceNote {
        let Some(note) = &self.note else { return ChangedSinceNote::default() };
        let weighs = MassRequest::default().bodies_kg(self);
        ChangedSinceNote {
            contacts: self.changed_contacts(note),
            sizes: self.bodies_have_other_sizes(note),
            weight_kg: note.weighed_kg.zip(weighs).filter(|&(then, now)| !are_equal_masses(then, now)),
        }
    }

    fn changed_contacts(&self, note: &Note) -> ChangedContacts {
        let radii = !self.has_radii_of(note);
        let places = self.has_places_of(note) == Some(false);
        let values = !self.has_values_of(note);
        let then = &note.parts;
        let now = self.noted_parts(|_| None);
        let counts = |then: &NotedNames, now: &NotedNames| {
            (then.count != now.count).then_some((then.count, now.count))
        };
        let (sphere_count, force_count) =
            (counts(&then.spheres, &now.spheres), counts(&then.forces, &now.forces));
        let comparable = sphere_count.is_none() && force_count.is_none();
        let differs = |property: &Property| then.properties.get(property) != now.properties.get(property);
        let properties: Vec<_> = Property::changeable().filter(|_| comparable).filter(differs).collect();
        ChangedContacts {
            sphere_names: comparable && then.spheres.digest != now.spheres.digest,
            force_names: comparable && then.forces.digest != now.forces.digest,
            radii: comparable && radii,
            places: comparable && places,
            exchanged: comparable && values && !radii && properties.is_empty(),
            properties,
            sphere_count,
            force_count,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NOTE: &str = "[contacts made for 62 kg at 9.81 m/s2 (osim-contact-scale 0.1.0; all; by rescale; sizes none; \
                    record 0123456789abcdef 01234567 01234567 1:01234567 1:01234567 0123.-.-.-.-.-.-.-.-; made -)]";

    fn document_with_credits(credits: &str) -> Document {
        let text =
            format!("<OpenSimDocument Version='40000'><Model name='m'>{credits}</Model></OpenSimDocument>");
        Document::parse(text).unwrap()
    }

    /// The text of the credits after a note for 70 kg was written into them.
    fn with_70_kg(credits: &str) -> String {
        let document = document_with_credits(credits);
        let found = Credits::of(&document).unwrap().unwrap();
        let note = Note::parse(&NOTE.replace("62 kg", "70 kg")).unwrap();
        let mut text = document.tree().slice(0..document.bytes().len()).to_owned();
        for (span, new) in found.edits(Some(&note)).into_iter().rev() {
            text.replace_range(span, &new);
        }
        let inner = text.split_once("<Model name='m'>").unwrap().1.split_once("</Model>").unwrap().0;
        inner.replace(&note.text(), "NOTE")
    }

    #[test]
    fn a_note_is_at_the_end_of_the_credits() {
        for (before, after) in [
            ("<credits>A. Author; B. Other</credits>", "<credits>A. Author; B. Other; NOTE</credits>"),
            ("<credits> A;\n\tB; \n</credits>", "<credits> A;\n\tB;; NOTE \n</credits>"),
            ("<credits></credits>", "<credits>NOTE</credits>"),
            ("<credits>  </credits>", "<credits>NOTE  </credits>"),
            ("<credits>A<!-- c --></credits>", "<credits>A; NOTE<!-- c --></credits>"),
            ("<credits><!-- c -->A</credits>", "<credits><!-- c -->A; NOTE</credits>"),
            ("<credits><!-- c --></credits>", "<credits>NOTE<!-- c --></credits>"),
            ("<credits><![CDATA[ A & B ]]></credits>", "<credits><![CDATA[ A & B; NOTE ]]></credits>"),
            ("<credits>A</credits><credits>B</credits>", "<credits>A; NOTE</credits><credits>B</credits>"),
            (
                "<credits>A [contacts made for fun]</credits>",
                "<credits>A [contacts made for fun]; NOTE</credits>",
            ),
        ] {
            assert_eq!(with_70_kg(before), after, "{before}");
        }
    }

    #[test]
    fn a_new_note_replaces_the_old_one() {
        for (before, after) in [
            (format!("<credits>{NOTE}</credits>"), "<credits>NOTE</credits>"),
            (format!("<credits>A &amp; B; {NOTE} </credits>"), "<credits>A &amp; B; NOTE </credits>"),
            (format!("<credits>A; {NOTE}; C. Later</credits>"), "<credits>A; C. Later; NOTE</credits>"),
            (format!("<credits>A;\n {}</credits>", NOTE.replace(' ', "\n\t")), "<credits>A; NOTE</credits>"),
            (format!("<credits><![CDATA[A; {NOTE}]]></credits>"), "<credits><![CDATA[A; NOTE]]></credits>"),
        ] {
            assert_eq!(with_70_kg(&before), after, "{before}");
        }
    }

    #[test]
    fn a_note_that_does_not_end_the_text_cannot_be_relied_on() {
        let note_in = |credits: &str| Credits::of(&document_with_credits(credits)).unwrap().unwrap().note();
        assert_eq!(note_in(&format!("<credits>A; {NOTE}</credits>")).map(|note| note.is_ok()), Some(true));
        // OpenSim condenses white space when it saves; people break lines.
        let broken = NOTE.replace("; digest", ";\n\t\tdigest");
        assert_eq!(note_in(&format!("<credits>{broken}\n</credits>")).map(|note| note.is_ok()), Some(true));
        assert_eq!(note_in(&format!("<credits>{NOTE} and me</credits>")), Some(Err(UnreadableNote)));
        assert_eq!(note_in(&format!("<credits>{NOTE} {}</credits>", &NOTE[..90])), Some(Err(UnreadableNote)));
        assert_eq!(note_in("<credits>A [contacts made for fun]</credits>"), None);
        assert_eq!(note_in("<credits/>"), None);
    }

    #[test]
    fn credits_that_opensim_refuses_are_refused() {
        for credits in [
            "<credits>A<![CDATA[B]]></credits>",
            "<credits><![CDATA[A]]>B</credits>",
            "<credits><![CDATA[A]]><![CDATA[B]]></credits>",
            "<credits>A<!-- c -->B</credits>",
            "<credits>A <b>B</b></credits>",
        ] {
            assert_eq!(
                Credits::of(&document_with_credits(credits)).unwrap_err().code(),
                "broken-text",
                "{credits}"
            );
        }
    }

    #[test]
    fn credits_of_defaults_do_not_count() {
        let document = document_with_credits("<defaults><credits>A</credits></defaults>");
        assert_eq!(Credits::of(&document).unwrap(), None);
    }

    #[test]
    fn a_comment_counts_in_a_set_only() {
        let note_in = |root: &str, comment: &str| {
            let text = format!(
                "<OpenSimDocument Version='40000'><{root} name='m'><!-- {comment} --></{root}></OpenSimDocument>"
            );
            Note::find_or_unreadable(&Document::parse(text).unwrap()).unwrap()
        };
        assert_eq!(note_in("ForceSet", NOTE).map(|note| note.unwrap().contacts_mass_kg), Some(Some(62.0)));
        assert_eq!(note_in("ForceSet", &NOTE[..90]), Some(Err(UnreadableNote)));
        assert_eq!(note_in("ForceSet", "a comment"), None);
        assert_eq!(note_in("Model", NOTE), None);
    }
}
