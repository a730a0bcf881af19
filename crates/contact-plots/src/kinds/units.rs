//! What axes are measured in.

/// What the horizontal axis of an indentation is measured in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum IndentationAxis {
    /// x̂ = x/R.
    #[default]
    Relative,
    /// x in mm.
    Millimetre,
}

impl IndentationAxis {
    pub(super) fn label(self) -> &'static str {
        match self {
            Self::Relative => "relative indentation x̂ = x/R (–)",
            Self::Millimetre => "indentation x (mm)",
        }
    }
}

/// What a force is measured in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum ForceAxis {
    /// N, of one sphere.
    #[default]
    Newton,
    /// The share of the body weight that one sphere carries, M g / n.
    WeightShare,
}

impl ForceAxis {
    pub(super) fn label(self) -> &'static str {
        match self {
            Self::Newton => "force of one sphere (N)",
            Self::WeightShare => "force of one sphere / its share Mg/n (–)",
        }
    }
}

/// What time is measured in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum TimeAxis {
    /// s.
    Second,
    /// t / √(R/g).
    Dimensionless,
}

impl TimeAxis {
    pub(super) fn label(self) -> &'static str {
        match self {
            Self::Second => "time t (s)",
            Self::Dimensionless => "non-dimensional time t/√(R/g) (–)",
        }
    }
}
