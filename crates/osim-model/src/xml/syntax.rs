//! What is not one well-formed document.

use super::file_text::FileText;

/// Ways of not being one well-formed document.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SyntaxFault {
    /// No element at all, or text before the first one.
    #[error(
        "this is not XML, expected an OpenSim model that starts with <?xml ...> or <OpenSimDocument ...>"
    )]
    NotXml,
    /// Nothing is in it, or white space alone.
    #[error("the file is empty, expected an OpenSim model: get it again from where it came")]
    Empty,
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
    #[error("the file ends inside a tag or a comment: it looks truncated, copy it again from where it came")]
    Truncated {
        /// What the parser says.
        what: String,
    },
    /// A zero byte.
    #[error("a zero byte is here: the file is damaged or not text, copy it again from where it came")]
    Nul,
    /// More than 4 GiB.
    #[error("the file is larger than 4 GiB")]
    TooLarge,
}

/// A file that is not one document, and where that shows.
#[derive(Debug)]
pub struct SyntaxError {
    /// What is wrong.
    pub fault: SyntaxFault,
    /// Byte of the file.
    pub offset: usize,
    /// The file, for code that shows the place.
    pub(crate) file: FileText,
}

impl SyntaxError {
    /// The file.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        self.file.bytes()
    }
}
