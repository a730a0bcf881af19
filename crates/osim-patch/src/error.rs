//! What can be wrong with a model or a request: data first, text second.
//!
//! Messages follow one pattern: lower case, no full stop, what is wrong, what was expected, and a way out where there
//! is one. They never name a file: whoever opened it adds that.

use std::ops::Range;

use crate::xml::{LineIndex, Position};

pub use crate::xml::value::NumberFault;

/// One thing that is wrong, and where.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{kind}")]
#[non_exhaustive]
pub struct Fault {
    /// What is wrong.
    pub kind: FaultKind,
    /// First byte of the place, in the file with number `source`.
    pub offset: Option<usize>,
    /// Bytes to underline.
    pub span: Option<Range<usize>>,
    /// Line and column of `offset`, once [`Fault::located`] was told the bytes.
    pub position: Option<Position>,
    /// Component path or tag of the element concerned.
    pub element: Option<String>,
    /// Which of the given files: 0 is the model itself.
    pub source_file: usize,
}

/// Kinds of fault.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FaultKind {
    /// Not one well-formed document.
    #[error(transparent)]
    Syntax(#[from] SyntaxFault),
    /// XML, but not an OpenSim document.
    #[error(
        "this is XML but not an OpenSim document: the outermost element is <{root}>, expected <OpenSimDocument>"
    )]
    NotOpenSim {
        /// Tag of the root element.
        root: String,
    },
    /// The `Version` attribute is missing or no number.
    #[error("<OpenSimDocument> has no readable Version (found '{found}'), expected a number like 40000")]
    NoVersion {
        /// The attribute as written.
        found: String,
    },
    /// An OpenSim document of another kind.
    #[error("the document holds a <{tag}>, expected a Model, a ForceSet or a ContactGeometrySet")]
    WrongDataRoot {
        /// Tag of the data root.
        tag: String,
    },
    /// The document is a set whose other half is needed.
    #[error("{0}")]
    Incomplete(String),
    /// A number that a strict reader and OpenSim do not read alike.
    #[error("{property} is '{text}', {}", number_hint(.fault))]
    Number {
        /// OpenSim's property name.
        property: String,
        /// As written.
        text: String,
        /// Why it is no plain number.
        fault: NumberFault,
    },
    /// A text that OpenSim refuses because something stands in the middle of it.
    #[error(
        "{property} has a comment or element in the middle of its text, which OpenSim cannot read: remove it"
    )]
    BrokenText {
        /// Tag of the element.
        property: String,
    },
    /// A number outside the domain in which the equations hold.
    #[error("{property} is {value}, expected {expected}")]
    Domain {
        /// OpenSim's property name.
        property: String,
        /// As OpenSim reads it.
        value: f64,
        /// The domain, in words.
        expected: &'static str,
    },
    /// A body's mass is needed and is not there.
    #[error(
        "body '{body}' has no mass (OpenSim reads NaN): give it a <mass>, or say what the model weighs with --mass KG"
    )]
    NoMass {
        /// Name of the body.
        body: String,
    },
    /// No contact forces in the model.
    #[error("there are no contacts to work on: {detail}")]
    NoContacts {
        /// What was looked for and what was found instead.
        detail: String,
    },
    /// A path or name that leads nowhere.
    #[error("{owner}: nothing called '{connectee}' is in the file, expected the {wanted}")]
    Unresolved {
        /// The component that points there.
        owner: String,
        /// The path or name as written.
        connectee: String,
        /// What should be there.
        wanted: &'static str,
    },
    /// A question that only the user can answer.
    #[error("{question}: {way_out}")]
    NeedsAnswer {
        /// Stable short name, used as the code of the error.
        code: &'static str,
        /// What is not known.
        question: String,
        /// What to say to the command.
        way_out: String,
    },
    /// A request that makes no sense for this model.
    #[error("{0}")]
    Refused(String),
    /// A quantity given by the caller is outside its domain.
    #[error(transparent)]
    Quantity(#[from] contact_scaling::DomainError),
    /// Edits that overlap: a defect of this crate, never of the file.
    #[error("internal error: two edits overlap at byte {at}; nothing was changed")]
    OverlappingEdits {
        /// Where.
        at: usize,
    },
}

/// Ways of not being one well-formed document.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SyntaxFault {
    /// No element at all, or text before the first one.
    #[error(
        "this is not XML, expected an OpenSim model that starts with <?xml ...> or <OpenSimDocument ...>"
    )]
    NotXml,
    /// UTF-16 (or something else with two bytes a character).
    #[error("the file is UTF-16, which OpenSim cannot read: save it as UTF-8")]
    Utf16,
    /// Two byte order marks in a row.
    #[error("the file starts with two byte order marks, expected one at most: remove the second")]
    SecondByteOrderMark,
    /// `<!DOCTYPE x […]>`
    #[error("the DOCTYPE has an internal subset [...], which OpenSim cannot read: remove it")]
    DoctypeSubset,
    /// A second element beside the root.
    #[error("a second outermost element starts here, expected the end of the file")]
    SecondRoot,
    /// Text before or after the root element.
    #[error("text outside the outermost element, expected the end of the file")]
    TextOutsideRoot,
    /// The file ends inside an element.
    #[error("<{tag}> is never closed: the file looks truncated, copy it again from where it came")]
    Unclosed {
        /// Tag of the innermost open element.
        tag: String,
    },
    /// An end tag of another name.
    #[error("</{found}> closes <{expected}>, expected </{expected}>")]
    MismatchedEnd {
        /// Tag that is open.
        expected: String,
        /// Tag of the end tag.
        found: String,
    },
    /// An end tag without a start.
    #[error("</{found}> closes nothing")]
    UnexpectedEnd {
        /// Tag of the end tag.
        found: String,
    },
    /// A bad attribute.
    #[error("<{tag}>: {what}")]
    Attribute {
        /// Tag of the element.
        tag: String,
        /// What the parser says.
        what: String,
    },
    /// Anything else the parser refuses.
    #[error("{what}")]
    Malformed {
        /// What the parser says.
        what: String,
    },
    /// The file ends inside a tag, comment or instruction.
    #[error("{what}: the file looks truncated, copy it again from where it came")]
    Truncated {
        /// What the parser says.
        what: String,
    },
    /// A zero byte.
    #[error("a zero byte stands here: the file is damaged or no text, copy it again from where it came")]
    Nul,
    /// More than 4 GiB.
    #[error("the file is larger than 4 GiB")]
    TooLarge,
}

fn number_hint(fault: &NumberFault) -> String {
    match fault {
        NumberFault::Empty => "expected a number: OpenSim silently takes its default here".to_owned(),
        NumberFault::Prefix { opensim_reads } => {
            format!(
                "expected one plain number like 1.5e6: OpenSim reads {opensim_reads} and ignores the rest"
            )
        }
        NumberFault::Unreadable => "expected a number: OpenSim silently takes its default instead".to_owned(),
        NumberFault::Interrupted => {
            "with a comment or element in the middle of it, expected one plain number".to_owned()
        }
    }
}

impl SyntaxFault {
    pub(crate) fn at(self, offset: usize) -> Fault {
        Fault::at(FaultKind::Syntax(self), offset)
    }
}

impl FaultKind {
    /// Stable short name, as in the JSON `code`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Syntax(SyntaxFault::NotXml) => "not-xml",
            Self::Syntax(SyntaxFault::Utf16 | SyntaxFault::SecondByteOrderMark) => "encoding",
            Self::Syntax(SyntaxFault::DoctypeSubset) => "doctype",
            Self::Syntax(_) => "malformed-xml",
            Self::NotOpenSim { .. } | Self::NoVersion { .. } | Self::WrongDataRoot { .. } => "not-opensim",
            Self::Incomplete(_) => "incomplete-set",
            Self::Number { .. } => "not-a-number",
            Self::BrokenText { .. } => "broken-text",
            Self::Domain { .. } => "out-of-domain",
            Self::NoMass { .. } => "no-mass",
            Self::NoContacts { .. } => "no-contacts",
            Self::Unresolved { .. } => "unresolved",
            Self::NeedsAnswer { code, .. } => code,
            Self::Refused(_) => "refused",
            Self::Quantity(_) => "out-of-range",
            Self::OverlappingEdits { .. } => "internal",
        }
    }
}

impl Fault {
    /// A fault without a place.
    #[must_use]
    pub fn new(kind: impl Into<FaultKind>) -> Self {
        Self { kind: kind.into(), offset: None, span: None, position: None, element: None, source_file: 0 }
    }

    pub(crate) fn at(kind: impl Into<FaultKind>, offset: usize) -> Self {
        Self { offset: Some(offset), ..Self::new(kind) }
    }

    pub(crate) fn over(kind: impl Into<FaultKind>, span: Range<usize>) -> Self {
        Self { offset: Some(span.start), span: Some(span), ..Self::new(kind) }
    }

    pub(crate) fn in_file(mut self, source_file: usize) -> Self {
        self.source_file = source_file;
        self
    }

    pub(crate) fn of(mut self, element: impl Into<String>) -> Self {
        self.element = Some(element.into());
        self
    }

    pub(crate) fn refused(text: impl Into<String>) -> Self {
        Self::new(FaultKind::Refused(text.into()))
    }

    /// Fills in line and column from the bytes the fault is about.
    #[must_use]
    pub fn located(mut self, bytes: &[u8]) -> Self {
        if self.position.is_none() {
            self.position = self.offset.map(|offset| LineIndex::new(bytes).position(bytes, offset));
        }
        self
    }

    /// Stable short name of the kind of fault.
    #[must_use]
    pub fn code(&self) -> &'static str {
        self.kind.code()
    }
}
