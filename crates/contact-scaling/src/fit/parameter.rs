//! The parameters of a fit.

/// A fitted parameter, in the order of the covariance.
///
/// Exhaustive: code that writes the covariance needs a name for each row, and a new parameter must not go without one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parameter {
    /// E*, in N/m².
    CompositeModulus,
    /// α, in s/m.
    Dissipation,
    /// x₀, in m.
    Onset,
}

impl Parameter {
    /// What it is called in a sentence.
    #[must_use]
    pub const fn in_words(self) -> &'static str {
        match self {
            Self::CompositeModulus => "composite modulus",
            Self::Dissipation => "dissipation",
            Self::Onset => "contact onset",
        }
    }
}
