//! How much of a model a page shows.

/// Models of a library whose feet may be drawn: bones take most of the time and the room of a page.
const FEW: usize = 20;

/// How much of a model a page shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum DetailLevel {
    /// The page is about this model alone.
    Alone,
    /// One of few: its feet may be drawn.
    OneOfFew,
    /// One of many.
    OneOfMany,
}

impl DetailLevel {
    /// The level for each model on a page about this many.
    #[must_use]
    pub const fn of(models: usize) -> Self {
        match models {
            0 | 1 => Self::Alone,
            2..=FEW => Self::OneOfFew,
            _ => Self::OneOfMany,
        }
    }

    /// Whether feet may be drawn.
    #[must_use]
    pub const fn has_feet(self) -> bool {
        !matches!(self, Self::OneOfMany)
    }

    pub(super) const fn is_alone(self) -> bool {
        matches!(self, Self::Alone)
    }
}
