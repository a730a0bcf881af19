//! The exit status.

/// How a run ended, as the exit status.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Exit {
    /// All done.
    Done,
    /// A model failed.
    Failed,
    /// Wrong usage.
    Usage,
    /// Stopped by Ctrl-C.
    Interrupted,
}

impl Exit {
    pub(crate) fn and(self, other: Self) -> Self {
        if self == Self::Done || other == Self::Interrupted { other } else { self }
    }

    pub(crate) fn code(self) -> u8 {
        match self {
            Self::Done => 0,
            Self::Failed => 1,
            Self::Usage => 2,
            // As shells have it for a program that SIGINT ended.
            Self::Interrupted => 130,
        }
    }
}
