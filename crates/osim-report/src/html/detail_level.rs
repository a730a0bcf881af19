//! How much of a model a page shows.

/// Models of a library that get plots, which are most of a page.
pub(super) const WITH_PLOTS: usize = 10;

/// How much of a model a page shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum DetailLevel {
    /// The page is about this model alone.
    Alone,
    /// One of many, with plots.
    WithPlots,
    /// One of many, without plots.
    WithoutPlots,
}

impl DetailLevel {
    /// That of the model at `index`, from 0: the first of many have plots.
    #[must_use]
    pub const fn of(index: usize, alone: bool) -> Self {
        match (alone, index < WITH_PLOTS) {
            (true, _) => Self::Alone,
            (false, true) => Self::WithPlots,
            (false, false) => Self::WithoutPlots,
        }
    }

    /// Whether there are plots.
    #[must_use]
    pub const fn has_plots(self) -> bool {
        !matches!(self, Self::WithoutPlots)
    }

    pub(super) const fn is_alone(self) -> bool {
        matches!(self, Self::Alone)
    }
}
