//! What the paper has no equation for.

use super::equation::{Equation, form};
use super::symbols::{
    ALPHA, C_EXACT, D, E_A, E_B, E_I, F_I, F_LOAD, G, H_I, IMPACT, K_HAT_A, K_HAT_B, N, R, R_EQUIVALENT, R_I,
    SPEED, U_V, V_T, X,
};

pub(super) const ALL: &[Equation] = &[
    Equation {
        label: "exact restitution",
        aliases: &["exact", "exact law"],
        title: "Coefficient of restitution, exact",
        forms: &[
            form("", "d − ln(1 + d) = −c d − ln(1 − c d), d = 3/2 α ẋ⁻", "restitution::exact", "1"),
            form("for α", "the same, solved for d", "restitution::exact_dissipation", "s/m"),
        ],
        symbols: &[D, C_EXACT, ALPHA, IMPACT],
        source: "beyond the paper: the integral of (12) over an impact without gravity",
    },
    Equation {
        label: "drop speed",
        aliases: &["impact speed"],
        title: "Impact speed of the paper's drop",
        forms: &[form("", "ẋ⁻ = √(2 g · R/4) = √(g R / 2)", "restitution::drop_speed", "m/s")],
        symbols: &[IMPACT, G, R],
        source: "the drops of Table 1: a fall from a quarter of the radius",
    },
    Equation {
        label: "rest by (1)",
        aliases: &["rest by Hertz"],
        title: "Indentation at rest by the Hertz law",
        forms: &[form("", "Σ 4/3 E*_i √R_i x^(3/2) = F", "equilibrium::hertz_indentation", "m")],
        symbols: &[E_I, R_I, X, F_LOAD],
        source: "beyond the paper: (1) summed over spheres whose bottoms are level",
    },
    Equation {
        label: "rest by (C.9)",
        aliases: &["rest by the model's law"],
        title: "Indentation at rest by the file's law",
        forms: &[form("", "Σ F_i(x, ẋ = 0) = F", "equilibrium::indentation", "m")],
        symbols: &[F_I, X, SPEED, F_LOAD],
        source: "beyond the paper: (C.9) at ẋ = 0 summed over spheres whose bottoms are level",
    },
    Equation {
        label: "rest at own heights",
        aliases: &["standing"],
        title: "Indentation of the lowest sphere, each at its own height",
        forms: &[
            form(
                "by (1)",
                "Σ 4/3 E*_i √R_i max(0, x − h_i)^(3/2) = F",
                "equilibrium::hertz_indentation_of_lowest",
                "m",
            ),
            form("by (C.9)", "Σ F_i(x − h_i, ẋ = 0) = F", "equilibrium::indentation_of_lowest", "m"),
        ],
        symbols: &[E_I, R_I, F_I, X, H_I, SPEED, F_LOAD],
        source: "beyond the paper: (1) and (C.9) summed over spheres whose bottoms are h_i above the lowest, as at the default pose",
    },
    Equation {
        label: "continuation",
        aliases: &["ladder"],
        title: "Modulus for a dimensionless stiffness",
        forms: &[form("", "E*_a / E*_b = (k̂_a / k̂_b)^(3/2)", "continuation::modulus_ratio", "1")],
        symbols: &[E_A, E_B, K_HAT_A, K_HAT_B],
        source: "(11) and (B.3) at one load; the steps of section 4.3",
    },
    Equation {
        label: "mixed radii",
        aliases: &["mean square"],
        title: "One radius for spheres of different size",
        forms: &[form("", "R² = Σ R_i² / n", "mixed_radii::mean_square", "m²")],
        symbols: &[R_EQUIVALENT, R_I, N],
        source: "beyond the paper: (3) summed over spheres of equal x̂ and E*",
    },
    Equation {
        label: "friction",
        aliases: &[],
        title: "How friction speeds follow body size",
        forms: &[
            form("", "transition_velocity ∝ √(g R)", "Ratios::transition_velocity", "1"),
            form("", "viscous_friction ∝ 1/√(g R)", "Ratios::viscous_friction", "1"),
        ],
        symbols: &[V_T, U_V, G, R],
        source: "beyond the paper: speeds grow as √(g R). The friction coefficients have no size and stay. The friction of SmoothSphereHalfSpaceForce is similar only in part",
    },
];
