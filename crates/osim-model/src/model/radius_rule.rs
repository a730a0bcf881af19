//! What happens to radii.

/// What happens to the radii of the moving spheres.
///
/// Exhaustive: plans have a formula for each.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RadiusRule {
    /// R ∝ M^{1/3}, with the linear dimensions of the body (8). In a transfer, as large against the body as the reference's.
    Isometric,
    /// They stay.
    Keep,
    /// All become this, in m.
    Metres(f64),
    /// All are multiplied by this.
    Factor(f64),
}
