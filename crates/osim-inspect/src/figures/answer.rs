//! The answer to the question for a figure.

/// A figure's value, or why there is none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Answer {
    Known(f64),
    /// Something that is needed for it is not known.
    Unknown,
    /// It would be beyond where its equation gives a number, so beyond its limit.
    Beyond,
}

impl From<Option<f64>> for Answer {
    fn from(value: Option<f64>) -> Self {
        value.map_or(Self::Unknown, Self::Known)
    }
}

impl Answer {
    pub(super) fn value(self) -> Option<f64> {
        match self {
            Self::Known(value) => Some(value),
            Self::Unknown | Self::Beyond => None,
        }
    }
}
