//! The columns of results.

/// A column of Table 1 that is computed; the others (mass, spheres, radius) are given.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Column {
    /// Composite modulus E*, MPa.
    CompositeModulus,
    /// Plane strain modulus E₁*, MPa: OpenSim's `stiffness` in its millions.
    PlaneStrainModulus,
    /// Dissipation α that is the same for all, s/m.
    BaseDissipation,
    /// Dissipation α ∝ R^(−1/2), s/m.
    ScaledDissipation,
    /// x̂ at the end of the drop test.
    FinalIndentation,
    /// Stiffness k of one sphere there, kN/m.
    ContactStiffness,
}

impl Column {
    /// All, in the order of the table.
    pub const ALL: [Self; 6] = [
        Self::CompositeModulus,
        Self::PlaneStrainModulus,
        Self::BaseDissipation,
        Self::ScaledDissipation,
        Self::FinalIndentation,
        Self::ContactStiffness,
    ];

    /// Its name for programs; it ends in the unit, where there is one.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::CompositeModulus => "composite_modulus_mpa",
            Self::PlaneStrainModulus => "stiffness_mpa",
            Self::BaseDissipation => "base_dissipation_s_m",
            Self::ScaledDissipation => "scaled_dissipation_s_m",
            Self::FinalIndentation => "final_relative_indentation",
            Self::ContactStiffness => "contact_stiffness_kn_m",
        }
    }

    /// What it is, in plain letters.
    #[must_use]
    pub const fn label(self) -> &'static str {
        match self {
            Self::CompositeModulus => "E*",
            Self::PlaneStrainModulus => "E1*",
            Self::BaseDissipation => "base alpha",
            Self::ScaledDissipation => "scaled alpha",
            Self::FinalIndentation => "final x/R",
            Self::ContactStiffness => "k of one sphere",
        }
    }

    /// The unit in which the paper prints it; empty for a pure number.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::CompositeModulus | Self::PlaneStrainModulus => "MPa",
            Self::BaseDissipation | Self::ScaledDissipation => "s/m",
            Self::FinalIndentation => "",
            Self::ContactStiffness => "kN/m",
        }
    }

    /// Number of the equation that gives it; empty where it is given, or the result of the drop test.
    #[must_use]
    pub const fn equation(self) -> &'static str {
        match self {
            Self::CompositeModulus => "A.4",
            Self::PlaneStrainModulus => "10",
            Self::ScaledDissipation => "14",
            Self::ContactStiffness => "B.2",
            Self::BaseDissipation | Self::FinalIndentation => "",
        }
    }
}
