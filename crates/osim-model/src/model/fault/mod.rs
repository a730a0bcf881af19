//! What can be wrong with a model or a request: data first, text second.
//!
//! Messages follow one pattern: lower case, no full stop, what is wrong, what was expected, and a way out where there is
//! one. They never name a file: the code that opened it adds that. They name no option either: what the reader can say is in
//! them as an [`Input`](crate::messages::Input), which each front end spells.

mod excerpt;
mod factor_question;
mod kind;
mod needed;
mod needs_answer;
mod note_doubt;
mod way_out;

use std::fmt;
use std::ops::Range;

use crate::messages::Phrase;
use crate::xml::{LineIndex, Position};

pub use excerpt::Excerpt;
pub use factor_question::FactorQuestion;
pub use kind::FaultKind;
pub use needed::{CountOf, Needed, TreeOfForces};
pub use needs_answer::{NeedsAnswer, Question, probable_units};
pub use note_doubt::NoteDoubt;
pub use way_out::{GravityFor, RadiusFrom};

/// One thing that is wrong, and where.
///
/// ```
/// let fault = osim_model::Document::parse("<OpenSimDocument>").unwrap_err();
/// assert_eq!(fault.code(), "malformed-xml");
/// assert_eq!(fault.position.map(|place| (place.line, place.column)), Some((1, 1)));
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Fault {
    /// What is wrong.
    pub kind: FaultKind,
    /// First byte of the place, from 0, in the file `file`.
    pub offset: Option<usize>,
    /// Bytes to underline, in the file `file`.
    pub span: Option<Range<usize>>,
    /// Line and column of `offset`, once [`Fault::located`] has seen the bytes.
    pub position: Option<Position>,
    /// The line around the place, likewise.
    pub excerpt: Option<Excerpt>,
    /// Component path or tag of the element concerned.
    pub element: Option<String>,
    /// Which of the files that make up the model.
    pub file: FileId,
}

/// One of the files that make up a model: the model itself, or one that it includes or that was given beside it.
///
/// Handles of the other files come from [`Model::companions`](crate::model::Model::companions) and
/// [`ModelFiles::companions`](crate::model::files::ModelFiles::companions).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct FileId(usize);

impl FileId {
    /// The model itself.
    pub const MAIN: Self = Self(0);

    /// Companion number `index`, from 0, in the order in which they were given.
    pub(crate) const fn companion(index: usize) -> Self {
        Self(index + 1)
    }

    /// Which companion it is, from 0; `None` for the model itself.
    pub(crate) const fn companion_index(self) -> Option<usize> {
        self.0.checked_sub(1)
    }
}

impl Fault {
    /// A fault without a place.
    #[must_use]
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
    #[must_use]
    pub fn at(kind: impl Into<FaultKind>, offset: usize) -> Self {
        Self { offset: Some(offset), ..Self::new(kind) }
    }

    /// A fault over the bytes `span`.
    #[must_use]
    pub fn over(kind: impl Into<FaultKind>, span: Range<usize>) -> Self {
        Self { offset: Some(span.start), span: Some(span), ..Self::new(kind) }
    }

    /// A request that makes no sense for this model. `text` names no input.
    #[must_use]
    pub fn refused(text: impl Into<String>) -> Self {
        Self::new(FaultKind::Refused(text.into()))
    }

    /// The same in file `file`.
    #[must_use]
    pub fn in_file(mut self, file: FileId) -> Self {
        self.file = file;
        self
    }

    /// The same about the component or element `element`.
    #[must_use]
    pub fn of(mut self, element: impl Into<String>) -> Self {
        self.element = Some(element.into());
        self
    }

    /// Fills in line, column and the line's text from the bytes the fault is about.
    #[must_use]
    pub fn located(mut self, bytes: &[u8]) -> Self {
        if self.position.is_none() {
            self.position = self.offset.map(|offset| LineIndex::new(bytes).position(bytes, offset));
            let span = self.span.clone().or(self.offset.map(|at| at..at));
            self.excerpt = span.and_then(|span| Excerpt::of(bytes, span));
        }
        self
    }

    /// The same with the bytes of whichever file the fault is about.
    #[must_use]
    pub fn located_in<'b>(self, bytes_of: impl FnOnce(FileId) -> &'b [u8]) -> Self {
        let file = self.file;
        self.located(bytes_of(file))
    }

    /// Stable short name of the kind of fault.
    #[must_use]
    pub fn code(&self) -> &'static str {
        self.kind.code()
    }

    /// What is wrong, with inputs as data.
    #[must_use]
    pub fn phrase(&self) -> Phrase {
        self.kind.phrase()
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.phrase().fmt(f)
    }
}

impl std::error::Error for Fault {}
