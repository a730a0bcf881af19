//! Moduli of surfaces: appendix A.

use super::equation::{Equation, form};
use super::symbols::{ALPHA, ALPHA_1, ALPHA_2, E, E_1, E_2, P, POISSON, R_1, R_2, R_TWO, SHARE, YOUNG};

pub(super) const ALL: &[Equation] = &[
    Equation {
        label: "A.1",
        aliases: &[],
        title: "Plane strain modulus from Young's modulus",
        forms: &[form("", "E₁* = E₁ / (1 − ν₁²)", "modulus::plane_strain", "N/m²")],
        symbols: &[E_1, YOUNG, POISSON],
        source: "Van Bijlert (2026), appendix A; Johnson (1985)",
    },
    Equation {
        label: "A.2",
        aliases: &[],
        title: "Composite modulus, Johnson's rule",
        forms: &[form("", "E* = E₁* E₂* / (E₁* + E₂*)", "modulus::composite_johnson", "N/m²")],
        symbols: &[E, E_1, E_2],
        source: "Van Bijlert (2026), appendix A; Johnson (1985). OpenSim uses (A.3)",
    },
    Equation {
        label: "A.3",
        aliases: &[],
        title: "Composite modulus, the rule of Simbody and OpenSim",
        forms: &[form(
            "",
            "E* = (E₁*^(2/3) E₂*^(2/3) / (E₁*^(2/3) + E₂*^(2/3)))^(3/2)",
            "modulus::composite_sherman",
            "N/m²",
        )],
        symbols: &[E, E_1, E_2],
        source: "Van Bijlert (2026), appendix A; Sherman et al. (2011)",
    },
    Equation {
        label: "A.4",
        aliases: &[],
        title: "Modulus of one of two equal surfaces",
        forms: &[
            form("", "E₁* = 2^p E*", "modulus::of_equal_surfaces", "N/m²"),
            form("for E*", "E* = E₁* / 2^p", "modulus::composite_of_equal", "N/m²"),
        ],
        symbols: &[E_1, E, P],
        source: "Van Bijlert (2026), appendix A. OpenSim's stiffness is E₁*: 2^(3/2) times what the contact feels",
    },
    Equation {
        label: "A.5",
        aliases: &[],
        title: "A soft body on rigid ground",
        forms: &[
            form("", "E* → E₁* for E₂* → ∞", "modulus::stiffness_on_rigid_ground", "N/m²"),
            form(
                "to write",
                "stiffness = 2^(3/2) E₁ / (1 − ν₁²)",
                "modulus::stiffness_on_rigid_ground",
                "N/m²",
            ),
        ],
        symbols: &[E, E_1, E_2, YOUNG, POISSON],
        source: "Van Bijlert (2026), appendix A; with (A.1) and (A.4) it gives the stiffness to write in OpenSim",
    },
    Equation {
        label: "Simbody",
        aliases: &["mixed dissipation"],
        title: "Dissipation of two unlike surfaces",
        forms: &[form(
            "",
            "α = α₁ s₁ + α₂ (1 − s₁), s₁ = E₂*^(2/3) / (E₁*^(2/3) + E₂*^(2/3))",
            "modulus::mixed_dissipation",
            "s/m",
        )],
        symbols: &[ALPHA, ALPHA_1, ALPHA_2, SHARE, E_1, E_2],
        source: "not numbered in the paper: Simbody's HuntCrossleyForce (Sherman et al. 2011)",
    },
    Equation {
        label: "Johnson",
        aliases: &["composite radius"],
        title: "Composite radius of two spheres",
        forms: &[form("", "R = R₁ R₂ / (R₁ + R₂)", "modulus::composite_radius", "m")],
        symbols: &[R_TWO, R_1, R_2],
        source: "not numbered in the paper: Johnson (1985), as in section 2",
    },
];
