//! Errors in a model or a request. Each is data, from which the message is made.
//!
//! All messages follow one pattern: lower case, no full stop, what is wrong, what was expected, and advice if there is any. They never name
//! a file: the code that opened the file adds its name. They name no option either: an [`Input`](crate::messages::Input) in the message is
//! data, which each front end writes in its own way.

mod kind;
mod missing_fact;
mod reasons;
mod suspicion;

use std::ops::Range;

use crate::messages::Phrase;
use crate::xml::{LineIndex, TextPosition};
pub use kind::FaultKind;
pub use missing_fact::{CountedSpheres, ForcesOfAnimal, MissingFact};
pub use reasons::{GravityFor, NoteDoubt, RadiusChangeReason, UnknownFactors};
pub(crate) use suspicion::POUND_KG;
pub use suspicion::{
    MassMistake, MassesOfOtherRows, Suspicion, YesQuestion, advice_on_units, probable_units,
};

/// An error in a model or a request, with its place in a file.
///
/// ```
/// let fault = osim_model::Document::parse("<OpenSimDocument>").unwrap_err();
/// assert_eq!(fault.code(), "malformed-xml");
/// assert_eq!(fault.position.map(|place| (place.line, place.column)), Some((1, 1)));
/// ```
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{}", .kind.phrase())]
#[must_use]
pub struct Fault {
    pub kind: FaultKind,
    /// First byte of the place in the file `file`, from 0.
    pub offset: Option<usize>,
    /// The bytes to underline in the file `file`.
    pub span: Option<Range<usize>>,
    /// Line and column of `offset`, after [`Fault::located`].
    pub position: Option<TextPosition>,
    /// The line of text around the place, after [`Fault::located`].
    pub excerpt: Option<Excerpt>,
    /// Component path or tag of the element in question.
    pub element: Option<String>,
    /// The file of the model in which the place is.
    pub file: FileId,
}

/// What a model gives, or why it cannot.
pub type Result<T, E = Fault> = std::result::Result<T, E>;

/// A handle of one of the files that form a model: the main file, a file that it includes, or a file that the caller gave with it.
///
/// Handles of the other files come from [`Model::companions`](crate::model::Model::companions) and
/// [`ModelFiles::companions`](crate::model::files::ModelFiles::companions).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct FileId(usize);

impl FileId {
    /// The main file.
    pub const MAIN: Self = Self(0);

    /// The handle of companion file number `index`, from 0, in the order in which the files were given.
    pub(crate) const fn companion(index: usize) -> Self {
        Self(index + 1)
    }

    /// The number of the companion file, from 0; `None` for the main file.
    pub(crate) const fn companion_index(self) -> Option<usize> {
        self.0.checked_sub(1)
    }
}

impl Fault {
    /// A fault without a place.
    pub fn new(kind: impl Into<FaultKind>) -> Self {
        Self {
            kind: kind.into(),
            offset: None,
            span: None,
            position: None,
            excerpt: None,
            element: None,
            file: FileId::MAIN,
        }
    }

    /// A fault at the byte `offset`, from 0.
    pub fn at(kind: impl Into<FaultKind>, offset: usize) -> Self {
        Self { offset: Some(offset), ..Self::new(kind) }
    }

    /// A fault at the bytes `span` of the file.
    pub fn at_span(kind: impl Into<FaultKind>, span: Range<usize>) -> Self {
        Self { offset: Some(span.start), span: Some(span), ..Self::new(kind) }
    }

    /// An error for a request that makes no sense for this model. `text` names no input.
    pub fn refused(text: impl Into<String>) -> Self {
        Self::new(FaultKind::Refused(text.into()))
    }

    /// The fault with the file in which it is.
    pub fn in_file(mut self, file: FileId) -> Self {
        self.file = file;
        self
    }

    /// The fault with the name or path of the element in which it is.
    pub fn at_element(mut self, element: impl Into<String>) -> Self {
        self.element = Some(element.into());
        self
    }

    /// Adds line, column and the text of the line, from the `bytes` of the file.
    pub fn located(mut self, bytes: &[u8]) -> Self {
        if self.position.is_none() {
            self.position = self.offset.map(|offset| LineIndex::new(bytes).position(bytes, offset));
            let span = self.span.clone().or(self.offset.map(|at| at..at));
            self.excerpt = span.and_then(|span| Excerpt::of(bytes, span));
        }
        self
    }

    /// Stable short name of the kind of error, as in the JSON `code`.
    pub fn code(&self) -> &'static str {
        self.kind.code()
    }

    /// The message of the error. Inputs in it are data for a front end.
    pub fn phrase(&self) -> Phrase {
        self.kind.phrase()
    }
}

/// Bytes of a long line that a message shows before and after the marked place.
const CONTEXT_BYTES: usize = 200;

/// A line of a file and the place to underline in it. A long line is shortened to the part around the place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Excerpt {
    pub line: usize,
    /// The text of the line, without line end and byte order mark.
    pub text: String,
    pub marked: Range<usize>,
}

impl Excerpt {
    /// The line of `span` in `bytes`; `None` if there is no text to show (UTF-16, an image, only white space).
    pub fn of(bytes: &[u8], span: Range<usize>) -> Option<Self> {
        let start = bytes.get(..span.start)?.iter().rposition(|&byte| byte == b'\n').map_or(0, |at| at + 1);
        let end = bytes
            .get(span.start..)?
            .iter()
            .position(|&byte| byte == b'\n')
            .map_or(bytes.len(), |at| span.start + at);
        let line = bytes.get(start..end)?;
        let text = std::str::from_utf8(line)
            .ok()
            .filter(|text| !text.contains('\0') && !text.trim_ascii().is_empty())?;
        let text = text.trim_start_matches('\u{feff}');
        let shift = line.len() - text.len();
        let number = bytes.get(..start)?.iter().filter(|&&byte| byte == b'\n').count() + 1;
        let from = (span.start - start).checked_sub(shift)?;
        let to = span.end.min(end).checked_sub(start + shift)?.max(from);
        let text = text.strip_suffix('\r').unwrap_or(text);
        Some(Self::cut_around(number, text, from..to))
    }

    /// The part of a long line around the mark: some models have megabytes in one line.
    fn cut_around(line: usize, text: &str, marked: Range<usize>) -> Self {
        let end = marked.end.min(marked.start + CONTEXT_BYTES) + CONTEXT_BYTES;
        Self::part(line, text, marked.start.saturating_sub(CONTEXT_BYTES)..end, &marked)
    }

    /// The excerpt for lines of at most `columns`: of the text, the part around the beginning of the mark.
    pub fn fitted(&self, columns: usize) -> Self {
        // Before the text stand the number of the line, a bar and blanks.
        let columns = columns.saturating_sub(self.line.to_string().len() + 3);
        // No other letter than a tab has more columns than bytes.
        let text = self.text.replace('\t', " ");
        let beside = columns.saturating_sub(self.marked.len()) / 2;
        let start = self.marked.start.saturating_sub(beside).min(text.len().saturating_sub(columns));
        Self::part(self.line, &text, start..start + columns, &self.marked)
    }

    /// The whole letters of `text` in the range of bytes.
    fn part(line: usize, text: &str, bytes: Range<usize>, marked: &Range<usize>) -> Self {
        let start = text.ceil_char_boundary(bytes.start);
        let text = text.get(start..text.floor_char_boundary(bytes.end)).unwrap_or_default().to_owned();
        let within = |at: usize| at.saturating_sub(start).min(text.len());
        Self { line, marked: within(marked.start)..within(marked.end), text }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_of_a_place_is_shown_without_its_end() {
        let excerpt = Excerpt::of(b"<a>\r\n <b>x</b>\r\n</a>", 9..10).unwrap();
        assert_eq!((excerpt.line, excerpt.text.as_str(), excerpt.marked), (2, " <b>x</b>", 4..5));
    }

    #[test]
    fn a_long_line_is_cut_around_the_mark() {
        let bytes = format!("<a>{}<b>wrong</b>{}</a>", "ä".repeat(500_000), "ä".repeat(500_000));
        let at = bytes.find("wrong").unwrap();
        let excerpt = Excerpt::of(bytes.as_bytes(), at..at + 5).unwrap();
        assert_eq!(&excerpt.text[excerpt.marked.clone()], "wrong");
        assert!(excerpt.text.len() < 500, "{}", excerpt.text.len());
        let all = Excerpt::of(bytes.as_bytes(), 0..bytes.len()).unwrap();
        assert!(all.text.len() < 500 && all.marked == (0..all.text.len()), "{all:?}");
    }

    #[test]
    fn an_excerpt_fits_into_a_terminal() {
        let fitted = |text: &str, marked: Range<usize>| {
            let Excerpt { text, marked, .. } = Excerpt::of(text.as_bytes(), marked).unwrap().fitted(54);
            (text, marked)
        };
        let digits = "7".repeat(100);
        assert_eq!(fitted("\t<a>7</a>", 4..5), (" <a>7</a>".to_owned(), 4..5));
        assert_eq!(fitted(&format!("\t<a>{digits}</a>"), 4..104), ("7".repeat(50), 0..50));
        assert_eq!(fitted(&format!("{digits}x"), 100..101), (format!("{}x", "7".repeat(49)), 49..50));
        let wide = "\u{6570}";
        assert_eq!(fitted(&wide.repeat(50), 0..150), (wide.repeat(16), 0..48));
    }

    #[test]
    fn bytes_that_are_no_text_are_not_shown() {
        assert_eq!(Excerpt::of(b"\xFF\xFEa\0", 0..0), None);
        assert_eq!(Excerpt::of(b"  \n<a>", 0..0), None);
    }
}
