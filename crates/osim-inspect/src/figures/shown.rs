//! Where a figure is shown.

/// Where a table or page shows a figure; JSON and CSV have all of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shown {
    /// Always.
    Always,
    /// Nowhere: the tables have it in another place.
    Nowhere,
    /// Where the model's law is not Hertz's.
    Smooth,
    /// Where spheres of a limb differ.
    Mixed,
    /// Where both are so.
    MixedSmooth,
}
