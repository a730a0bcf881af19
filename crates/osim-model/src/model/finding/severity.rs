//! How bad something is, and where it shows.

/// How bad something is, from harmless to harmful.
///
/// Exhaustive: the JSON of a finding promises these three.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// Worth knowing; nothing is wrong.
    Info,
    /// Outside a limit of the paper, or a trap: look at it.
    Warn,
    /// OpenSim computes something else than the file seems to say, or nonsense.
    Error,
}

impl Severity {
    /// As in the JSON and on the command line.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Info => "info",
            Self::Warn => "warn",
            Self::Error => "error",
        }
    }
}

/// Where something shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Seen {
    /// In a model that is only looked at.
    Model,
    /// In a change alone.
    Change,
}
