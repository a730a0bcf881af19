//! What can be wrong with a recording.

/// What is wrong, where in the file, and what to do.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct MotionFault {
    /// The line in the file, from 1; `None` where the whole of it is meant.
    pub line: Option<usize>,
    /// In words; texts from the file are quoted in it.
    pub message: String,
    /// Whether the caller can say what the file does not: the unit of its angles.
    pub needs_angles: bool,
}

impl MotionFault {
    /// Something about the whole file.
    pub fn new(message: impl Into<String>) -> Self {
        Self { line: None, message: message.into(), needs_angles: false }
    }

    /// The unit of the angles is in doubt.
    pub(crate) fn of_angles(message: impl Into<String>) -> Self {
        Self { needs_angles: true, ..Self::new(message) }
    }

    /// Something about one of its lines.
    pub fn at(line: usize, message: impl Into<String>) -> Self {
        Self { line: Some(line), ..Self::new(message) }
    }
}
