//! The `<credits>` of a model, where its note is.
//!
//! OpenSim takes one text or one CDATA section there, with comments before or after it, and refuses the model otherwise.

use std::ops::Range;

use super::data::{Note, Unreadable};
use super::grammar::{BEGINS, ENDS, NAMES};
use crate::model::document::Document;
use crate::model::fault::{Fault, FaultKind};
use crate::xml::ElementId;
use crate::xml::opensim_text::{is_white, words};

/// Between what was there and the note, and between authors.
const AND: &str = "; ";
const CDATA: (&str, &str) = ("<![CDATA[", "]]>");

/// The element and its text: what comes in front of comments after it, without the white space around it.
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
    pub(super) fn note(&self) -> Option<Result<Note, Unreadable>> {
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
}
