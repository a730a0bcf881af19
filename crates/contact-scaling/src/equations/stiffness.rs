//! Stiffness and natural frequency: appendix B.

use super::equation::{Equation, form};
use super::symbols::{E, ETA, F, F_C_ALL, F_N, F_N_EQ, G, K, K_HAT, M_ON_SPHERE, N, R, X, X_HAT, X_HAT_EQ};

pub(super) const ALL: &[Equation] = &[
    Equation {
        label: "B.1",
        aliases: &[],
        title: "Contact stiffness of one sphere",
        forms: &[form("", "k = 2 η √R E* √x", "Hertz::stiffness", "N/m")],
        symbols: &[K, ETA, R, E, X],
        source: "Van Bijlert (2026), appendix B; the slope of (1)",
    },
    Equation {
        label: "B.2",
        aliases: &[],
        title: "Contact stiffness by relative indentation",
        forms: &[
            form("", "k = 2 η R E* √x̂", "Hertz::stiffness_at_relative_indentation", "N/m"),
            form("for E*", "E* = k / (2 η R √x̂)", "design::composite_modulus_for_stiffness", "N/m²"),
            form("with (11)", "R = 3 F / (2 k x̂ n)", "design::radius_for_stiffness", "m"),
        ],
        symbols: &[K, ETA, R, E, X_HAT, F, N],
        source: "Van Bijlert (2026), appendix B; (B.1) with (2)",
    },
    Equation {
        label: "B.3",
        aliases: &[],
        title: "Dimensionless stiffness",
        forms: &[
            form("", "k̂ = k R n / F_c", "stiffness::dimensionless", "1"),
            form("Hertz", "k̂ = 3 / (2 x̂)", "stiffness::dimensionless_hertz", "1"),
        ],
        symbols: &[K_HAT, K, R, N, F_C_ALL, X_HAT],
        source: "Van Bijlert (2026), appendix B; Alexander et al. (1986). The second form follows from (B.2) and (3)",
    },
    Equation {
        label: "B.4",
        aliases: &[],
        title: "Natural frequency of one loaded sphere",
        forms: &[form("", "f_n = √(k / M) / (2π)", "stiffness::natural_frequency", "Hz")],
        symbols: &[F_N, K, M_ON_SPHERE],
        source: "Van Bijlert (2026), appendix B; for small oscillations without damping",
    },
    Equation {
        label: "B.5",
        aliases: &[],
        title: "Natural frequency at rest under body weight",
        forms: &[form("", "f_n,eq = √(3/2 · g / (x̂_eq R)) / (2π)", "stiffness::equilibrium_frequency", "Hz")],
        symbols: &[F_N_EQ, G, X_HAT_EQ, R],
        source: "Van Bijlert (2026), appendix B; (B.4) with (B.2) and (3)",
    },
];
