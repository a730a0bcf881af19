//! Which size the dissipation follows.

/// Which size α follows, (14).
///
/// Exhaustive: plans have a factor for each.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum DissipationBy {
    /// α ∝ R^{−1/2}, as in the paper's Table 1.
    #[default]
    Radius,
    /// α ∝ M^{−1/6}.
    Mass,
}
