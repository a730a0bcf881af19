//! The note that the tool leaves in a model: which mass its contacts were made for, at which size of its bones, and by what.
//!
//! A model keeps it in `<credits>`, which every OpenSim from 1.9 to 4.6 copies when it saves or scales a model; comments are
//! lost then. Standalone sets have no credits and keep a comment.

mod content;
mod grammar;
mod since;

use std::ops::Range;

use crate::model::document::Document;
use crate::model::fault::{Fault, FaultKind};
use crate::model::note::content::{Unreadable, gravity_m_s2, mass_kg};
use crate::model::note::grammar::{BEGINS, ENDS, NAMES};
use crate::xml::opensim_text::{is_white, words};
use crate::xml::{ElementId, PieceKind};
pub use content::{BodySize, Note, NotedNames, NotedParts, Scope, Source, Step};
pub use since::{ChangedContacts, ChangedSinceNote};

/// Between what was there and the note, and between authors.
const AND: &str = "; ";
const CDATA: (&str, &str) = ("<![CDATA[", "]]>");

/// The `<credits>` of a model, where its note is, and its text: what comes in front of comments after it, without the white space
/// around it.
///
/// OpenSim takes one text or one CDATA section there, with comments before or after it, and refuses the model otherwise.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Credits<'d> {
    /// The element.
    pub element: ElementId,
    /// Where the text is; empty where there is none. Of an element `<credits/>` the place after it.
    pub span: Range<usize>,
    /// Its bytes.
    raw: &'d str,
    /// As OpenSim reads it: entities resolved, white space condensed.
    text: String,
}

impl<'d> Credits<'d> {
    /// The first `<credits>` of a model; `None` where it has none, or the document is not a model. Those of `<defaults>` do not
    /// count.
    ///
    /// # Errors
    /// Text, CDATA and comments in a mixture that OpenSim refuses ([`FaultKind::BrokenText`]).
    pub fn of(document: &'d Document) -> Result<Option<Self>, Fault> {
        let (tree, root) = (document.tree(), document.data_root());
        if tree.name(root) != "Model" {
            return Ok(None);
        }
        let Some(element) = tree.child(root, "credits") else { return Ok(None) };
        let read = tree.raw_text(element);
        let mut span = read.span;
        let mut raw = tree.slice(span.clone());
        let is_cdata = raw.starts_with(CDATA.0);
        let broken = !read.whole || (is_cdata && raw.matches(CDATA.1).count() > 1);
        if broken {
            let property = "credits".to_owned();
            let fault = Fault::over(FaultKind::BrokenText { property }, tree.span(element));
            return Err(fault.located(document.bytes()));
        }
        if let Some(inner) = raw.strip_prefix(CDATA.0).and_then(|rest| rest.strip_suffix(CDATA.1)) {
            let start = span.start + CDATA.0.len() + (inner.len() - inner.trim_ascii_start().len());
            raw = inner.trim_ascii();
            span = start..start + raw.len();
        }
        let text = condensed(&read.text);
        Ok(Some(Self { element, span, raw, text }))
    }

    /// The text as OpenSim reads it: entities resolved, white space condensed.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The note that ends the text, if something in it begins like one.
    fn note(&self) -> Option<Result<Note, Unreadable>> {
        let at = self.text.rfind(BEGINS)?;
        let note = self.text.get(at..)?;
        note.contains(NAMES).then(|| Note::parse(note).ok_or(Unreadable))
    }

    /// The bytes to replace, each with its text, so that `note` ends the credits instead of the note that is there. What
    /// others wrote is not among them, because its bytes need not be UTF-8.
    #[must_use]
    pub fn edits(&self, note: Option<&Note>) -> Vec<(Range<usize>, String)> {
        let mut edits = Vec::new();
        let mut end = self.span.start;
        let kept = self.kept();
        for part in &kept {
            let between = if end == self.span.start { "" } else { AND };
            edits.push((end..part.start, between.to_owned()));
            end = part.end;
        }
        let and = if kept.is_empty() { "" } else { AND };
        let last = note.map(|note| format!("{and}{}", note.text()));
        edits.push((end..self.span.end, last.unwrap_or_default()));
        edits.retain(|(span, text)| !(span.is_empty() && text.is_empty()));
        edits
    }

    /// The same so that `note` comes after everything that is there, another note too.
    #[must_use]
    pub fn edits_for_another(&self, note: &Note) -> Vec<(Range<usize>, String)> {
        let and = if self.raw.is_empty() { "" } else { AND };
        vec![(self.span.end..self.span.end, format!("{and}{}", note.text()))]
    }

    /// Whether nothing is left of the text without the note.
    #[must_use]
    pub fn is_note_only(&self) -> bool {
        self.kept().is_empty()
    }

    /// Where in the file is what comes before and after the note that is there.
    fn kept(&self) -> Vec<Range<usize>> {
        // People and their programs break lines where the note has a blank.
        let begins = |at: usize| self.raw.get(at..).is_some_and(begins_a_note);
        let found = self.raw.rmatch_indices('[').map(|(at, _)| at).find(|&at| begins(at));
        let around = found.and_then(|at| {
            let (before, rest) = self.raw.split_at(at);
            // Something else in square brackets is kept.
            let end = rest.find(ENDS).filter(|_| condensed(rest).contains(NAMES))? + ENDS.len();
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
    /// The note that is read where this one was written; `None` if it would not be read as one.
    pub(crate) fn as_read(&self) -> Option<Self> {
        Self::parse(&condensed(&self.text()))
    }
}

/// Whether `text` begins like a note, with any white space where the note has a blank. No more of it is read than that takes.
fn begins_a_note(text: &str) -> bool {
    let behind = BEGINS.chars().try_fold(text, |rest, letter| {
        if letter != ' ' {
            return rest.strip_prefix(letter);
        }
        let behind = rest.trim_start_matches(is_white);
        (behind.len() < rest.len()).then_some(behind)
    });
    behind.is_some_and(|behind| !behind.is_empty())
}

/// With single blanks, as OpenSim reads and writes it.
fn condensed(text: &str) -> String {
    words(text).collect::<Vec<_>>().join(" ")
}

// Notes in comments: those of standalone sets, and those that earlier versions left in models.

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
fn spans(document: &Document) -> impl Iterator<Item = Range<usize>> + '_ {
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

fn find(document: &Document) -> Option<Result<Note, Unreadable>> {
    let text = inner(document.tree().slice(spans(document).next()?));
    Some(Note::parse(text).or_else(|| Note::parse_earlier(text)).ok_or(Unreadable))
}

fn inner(comment: &str) -> &str {
    let text = comment.strip_prefix("<!--").unwrap_or(comment);
    text.strip_suffix("-->").unwrap_or(text).trim_ascii()
}

/// The notes of one document: a model can have one in its credits and one of an earlier version in a comment.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct NotesFound {
    /// In `<credits>`: `Err` where something begins like a note and cannot be read, or does not end the text.
    pub(crate) credits: Option<Result<Note, Unreadable>>,
    /// In a comment before the first child of the data root.
    pub(crate) comment: Option<Result<Note, Unreadable>>,
}

impl NotesFound {
    /// # Errors
    /// Credits that OpenSim refuses.
    pub(crate) fn of(document: &Document) -> Result<Self, Fault> {
        let credits = Credits::of(document)?.and_then(|credits| credits.note());
        Ok(Self { credits, comment: find(document) })
    }
}

impl Note {
    /// The note of `document`: in its credits, else in a comment before the first child of the data root. `None` where there
    /// is none or it cannot be read.
    #[must_use]
    pub fn find(document: &Document) -> Option<Self> {
        let found = NotesFound::of(document).ok()?;
        found.credits.or(found.comment)?.ok()
    }

    /// The bytes of the comments that begin like a note, of this version or an earlier one: the first counts.
    pub fn comment_spans(document: &Document) -> impl Iterator<Item = Range<usize>> + '_ {
        spans(document)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NOTE: &str = "[contacts made for 62 kg at 9.81 m/s2 (osim-contact-scale 0.1.0; all; by rescale; sizes none; \
                    digest 0123456789abcdef; places 0123456789abcdef; made -)]";

    fn document(credits: &str) -> Document {
        let text =
            format!("<OpenSimDocument Version='40000'><Model name='m'>{credits}</Model></OpenSimDocument>");
        Document::parse(text).unwrap()
    }

    /// What the element becomes with the same note for 70 kg.
    fn with_70_kg(credits: &str) -> String {
        let document = document(credits);
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
    fn a_note_ends_the_text() {
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
    fn a_note_takes_the_place_of_the_last() {
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
        let of = |credits: &str| Credits::of(&document(credits)).unwrap().unwrap().note();
        assert_eq!(of(&format!("<credits>A; {NOTE}</credits>")).map(|note| note.is_ok()), Some(true));
        // OpenSim condenses white space when it saves; people break lines.
        let broken = NOTE.replace("; digest", ";\n\t\tdigest");
        assert_eq!(of(&format!("<credits>{broken}\n</credits>")).map(|note| note.is_ok()), Some(true));
        assert_eq!(of(&format!("<credits>{NOTE} and me</credits>")), Some(Err(Unreadable)));
        assert_eq!(of(&format!("<credits>{NOTE} {}</credits>", &NOTE[..90])), Some(Err(Unreadable)));
        assert_eq!(of("<credits>A [contacts made for fun]</credits>"), None);
        assert_eq!(of("<credits/>"), None);
    }

    #[test]
    fn what_open_sim_refuses_is_refused() {
        for credits in [
            "<credits>A<![CDATA[B]]></credits>",
            "<credits><![CDATA[A]]>B</credits>",
            "<credits><![CDATA[A]]><![CDATA[B]]></credits>",
            "<credits>A<!-- c -->B</credits>",
            "<credits>A <b>B</b></credits>",
        ] {
            assert_eq!(Credits::of(&document(credits)).unwrap_err().code(), "broken-text", "{credits}");
        }
    }

    #[test]
    fn credits_of_defaults_do_not_count() {
        let document = document("<defaults><credits>A</credits></defaults>");
        assert_eq!(Credits::of(&document).unwrap(), None);
    }

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
