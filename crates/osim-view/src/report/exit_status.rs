//! Exit statuses of the command line program, and their meanings.

/// The way in which a run of the program ended.
///
/// ```
/// use osim_view::report::ExitStatus;
///
/// assert_eq!(ExitStatus::Failed.code(), 1);
/// // What came first counts, but for what ended the run.
/// assert_eq!(ExitStatus::Done.plus(ExitStatus::Failed).plus(ExitStatus::Done), ExitStatus::Failed);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExitStatus {
    Done,
    /// A model failed, or a result could not be written.
    Failed,
    Usage,
    /// Another run of the program is writing a file that this run has to write.
    Busy,
    /// Ctrl-C or a batch system stopped the run.
    Interrupted,
}

impl ExitStatus {
    pub const ALL: [Self; 5] = [Self::Done, Self::Failed, Self::Usage, Self::Busy, Self::Interrupted];

    pub const fn code(self) -> u8 {
        match self {
            Self::Done => 0,
            Self::Failed => 1,
            Self::Usage => 2,
            Self::Busy => 3,
            // As shells have it for a program that SIGINT ended.
            Self::Interrupted => 130,
        }
    }

    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Done => "all done, and check found no error",
            Self::Failed => {
                "a model failed or needs an answer, check found an error, or a result could not be written (full disk)"
            }
            Self::Usage => "the call is wrong: nothing was done",
            Self::Busy => {
                "another run is writing the same files: nothing was done, the same call may be right later"
            }
            Self::Interrupted => "stopped by Ctrl-C or by a batch system: what was begun is finished",
        }
    }

    /// The status of a run that has two parts, if the other part ended with `other`.
    pub fn plus(self, other: Self) -> Self {
        if self == Self::Done || other == Self::Interrupted { other } else { self }
    }
}
