//! The equations of the paper: force laws and how they scale, then its appendices A to C.

use super::equation::{Equation, form};
use super::symbols::{
    ALPHA, ALPHA_1, ALPHA_2, B_V, B_X, BD, BV, C_R, CF, E, E_1, E_2, E_A, E_B, ETA, F, F_C, F_C_ALL, F_CF,
    F_D, F_E, F_N, F_N_EQ, F_S, F_SMOOTH, G, IMPACT, K, K_HAT, M, M_A, M_B, M_ON_SPHERE, N, N_A, N_B, P,
    POISSON, R, R_1, R_2, R_A, R_B, R_TWO, REDUCED_WIDTH, S_C, SHARE, SIGMA, SPEED, SPEED_WIDTH, T, WIDTH, X,
    X_HAT, X_HAT_C, X_HAT_EQ, X_HAT_T, YOUNG,
};

pub(super) const LAWS: &[Equation] = &[
    Equation {
        label: "1",
        aliases: &[],
        title: "Hertz force of one sphere",
        forms: &[
            form("", "F_e = 4/3 η √R E* x^(3/2)", "Hertz::force", "N"),
            form("for x", "x = (F_e / (4/3 η √R E*))^(2/3)", "Hertz::indentation_from_force", "m"),
        ],
        symbols: &[F_E, ETA, R, E, X],
        source: "Van Bijlert (2026), section 2; Hertz's law as in Johnson (1985) and Sherman et al. (2011)",
    },
    Equation {
        label: "2",
        aliases: &[],
        title: "Relative indentation",
        forms: &[
            form("", "x̂ = x / R", "Hertz::relative_indentation", "1"),
            form("for x", "x = x̂ R", "Hertz::indentation", "m"),
        ],
        symbols: &[X_HAT, X, R],
        source: "Van Bijlert (2026), section 2",
    },
    Equation {
        label: "3",
        aliases: &[],
        title: "Hertz force by relative indentation",
        forms: &[form("", "F_e = 4/3 η R² E* x̂^(3/2)", "Hertz::force_at_relative_indentation", "N")],
        symbols: &[F_E, ETA, R, E, X_HAT],
        source: "Van Bijlert (2026), section 2; it is (1) with (2)",
    },
    Equation {
        label: "4",
        aliases: &[],
        title: "Body weight is shared equally by the spheres",
        forms: &[form("", "F_e ∝ M / n", "", "N")],
        symbols: &[F_E, M, N],
        source: "Van Bijlert (2026), section 2; a step to (8)",
    },
    Equation {
        label: "5",
        aliases: &[],
        title: "What the Hertz force grows with",
        forms: &[form("", "F_e ∝ R² E* x̂^(3/2)", "", "")],
        symbols: &[F_E, R, E, X_HAT],
        source: "Van Bijlert (2026), section 2; it is (3), a step to (8)",
    },
    Equation {
        label: "6",
        aliases: &[],
        title: "Load per sphere and indentation",
        forms: &[form("", "M / n ∝ E* x̂^(3/2) R²", "", "")],
        symbols: &[M, N, E, X_HAT, R],
        source: "Van Bijlert (2026), section 2; (4) with (5), a step to (8)",
    },
    Equation {
        label: "7",
        aliases: &[],
        title: "Load per sphere at the same relative indentation",
        forms: &[form("", "M / n ∝ E* R²", "", "")],
        symbols: &[M, N, E, R],
        source: "Van Bijlert (2026), section 2; a step to (8)",
    },
    Equation {
        label: "8",
        aliases: &[],
        title: "How the modulus grows with body size at the same relative indentation",
        forms: &[form("", "E* ∝ M / (n R²)", "Ratios::plane_strain_modulus", "1")],
        symbols: &[E, M, N, R],
        source: "Van Bijlert (2026), section 2. With geometric similarity R ∝ M^(1/3), so E* ∝ M^(1/3) too: this is what sets isometric radii",
    },
    Equation {
        label: "9",
        aliases: &[],
        title: "Ratio of the moduli of two animals",
        forms: &[form(
            "",
            "E*_b / E*_a = (M_b / M_a) (n_a / n_b) (R_a² / R_b²)",
            "Ratios::plane_strain_modulus",
            "1",
        )],
        symbols: &[E_B, E_A, M_B, M_A, N_A, N_B, R_A, R_B],
        source: "Van Bijlert (2026), section 2.1; it is (8) for a and b",
    },
    Equation {
        label: "10",
        aliases: &[],
        title: "The modulus of another animal",
        forms: &[form(
            "",
            "E*_b = (M_b / M_a) (n_a / n_b) (R_a² / R_b²) E*_a",
            "Ratios::plane_strain_modulus",
            "1",
        )],
        symbols: &[E_B, E_A, M_B, M_A, N_A, N_B, R_A, R_B],
        source: "Van Bijlert (2026), section 2.1. It holds for E₁* (OpenSim's stiffness) as well, since both surfaces are equal (A.4). With another gravity also × g_b / g_a (an extension)",
    },
    Equation {
        label: "11",
        aliases: &[],
        title: "The modulus for a wanted relative indentation under a known load",
        forms: &[
            form("", "E* = 3 F / (4 η R² x̂^(3/2) n)", "design::composite_modulus", "N/m²"),
            form("for x̂", "x̂ = (3 F / (4 η E* R² n))^(2/3)", "design::relative_indentation", "1"),
        ],
        symbols: &[E, F, ETA, R, X_HAT, N],
        source: "Van Bijlert (2026), section 2.2. Multiply by 2^(3/2) (A.4) to get OpenSim's stiffness",
    },
    Equation {
        label: "12",
        aliases: &[],
        title: "Hunt–Crossley dissipation",
        forms: &[
            form("", "F_d = 3/2 F_e α ẋ", "HuntCrossley::dissipative_force", "N"),
            form("the sum", "F_c = F_e (1 + 3/2 α ẋ)", "HuntCrossley::force", "N"),
        ],
        symbols: &[F_D, F_E, ALPHA, SPEED, F_C],
        source: "Van Bijlert (2026), section 2.3; Hunt and Crossley (1975)",
    },
    Equation {
        label: "13",
        aliases: &[],
        title: "Coefficient of restitution, approximate",
        forms: &[
            form("", "c_r = 1 − α ẋ⁻", "restitution::approximate", "1"),
            form("for α", "α = (1 − c_r) / ẋ⁻", "restitution::dissipation", "s/m"),
        ],
        symbols: &[C_R, ALPHA, IMPACT],
        source: "Van Bijlert (2026), section 2.3; Hunt and Crossley (1975). Accurate for c_r of about 0.8 and above; refused where it is negative",
    },
    Equation {
        label: "14",
        aliases: &[],
        title: "How dissipation follows body size at the same restitution",
        forms: &[
            form("", "α ∝ R^(−1/2)", "Ratios::dissipation", "1"),
            form("by mass", "α ∝ M^(−1/6)", "Ratios::dissipation_by_mass", "1"),
        ],
        symbols: &[ALPHA, R, M],
        source: "Van Bijlert (2026), section 2.3. With another gravity also × (g_b / g_a)^(−1/2) (an extension)",
    },
    Equation {
        label: "15",
        aliases: &[],
        title: "Mean stress on the contact patch",
        forms: &[form("", "σ = F_c / (π R² x̂)", "patch::mean_stress", "N/m²")],
        symbols: &[SIGMA, F_C, R, X_HAT],
        source: "Van Bijlert (2026), section 4.3; the patch is the circle of Fig. 3",
    },
    Equation {
        label: "Fig. 3",
        aliases: &["patch"],
        title: "Size of the contact patch",
        forms: &[
            form("", "patch radius √(x R)", "patch::radius", "m"),
            form("", "patch diameter 2 √(x R)", "patch::diameter", "m"),
            form("", "patch radius / R = √x̂", "patch::relative_radius", "1"),
        ],
        symbols: &[X, R, X_HAT],
        source: "Van Bijlert (2026), Fig. 3; for small x",
    },
];

// Moduli of surfaces: appendix A.

pub(super) const SURFACES: &[Equation] = &[
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

// Stiffness and natural frequency: appendix B.

pub(super) const STIFFNESS: &[Equation] = &[
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

// `SmoothSphereHalfSpaceForce`: appendix C.

pub(super) const SMOOTH: &[Equation] = &[
    Equation {
        label: "C.1",
        aliases: &[],
        title: "Hertz force with a constant indentation",
        forms: &[form(
            "",
            "F_cf = 4/3 η √R E* (x² + cf)^(3/4)",
            "SmoothSphere::constant_indentation_force",
            "N",
        )],
        symbols: &[F_CF, ETA, R, E, X, CF],
        source: "Van Bijlert (2026), appendix C.1, printed there as √(x² + cf)^(3/2)",
    },
    Equation {
        label: "C.2",
        aliases: &[],
        title: "cf for a wanted constant relative indentation",
        forms: &[
            form("", "cf = (R x̂_c)²", "smoothing::constant_contact_force", "m²"),
            form("for x̂_c", "x̂_c = √cf / R", "smoothing::constant_indentation", "1"),
            form("a to b", "cf ∝ R²", "Ratios::constant_contact_force", "1"),
        ],
        symbols: &[CF, R, X_HAT_C],
        source: "Van Bijlert (2026), appendix C.1. A start: x̂_c = 0.1, or 0.05 where x̂ below 0.16 is wanted",
    },
    Equation {
        label: "C.3",
        aliases: &[],
        title: "Smoothed elastic force",
        forms: &[
            form("", "F_s = F_cf s_c(x)", "SmoothSphere::elastic_force", "N"),
            form("its slope", "∂F_s / ∂x", "SmoothSphere::stiffness", "N/m"),
        ],
        symbols: &[F_S, F_CF, S_C, X],
        source: "Van Bijlert (2026), appendix C.2",
    },
    Equation {
        label: "C.4",
        aliases: &[],
        title: "Contact state, a smoothed step",
        forms: &[form("", "s_c = ½ + ½ tanh(bd x)", "SmoothSphere::contact_state", "1")],
        symbols: &[S_C, BD, X],
        source: "Van Bijlert (2026), appendix C.2",
    },
    Equation {
        label: "C.5",
        aliases: &[],
        title: "bd from a pure number",
        forms: &[
            form("", "bd = b_x̂ / R", "smoothing::hertz_smoothing", "1/m"),
            form("a to b", "bd ∝ 1/R", "Ratios::hertz_smoothing", "1"),
        ],
        symbols: &[BD, B_X, R],
        source: "Van Bijlert (2026), appendix C.2. A start: b_x̂ = 10",
    },
    Equation {
        label: "C.6",
        aliases: &[],
        title: "Indentation at which the contact state reaches a threshold",
        forms: &[form("", "x̂_t = atanh(1 − 2 t) / (bd R)", "smoothing::threshold_indentation", "1")],
        symbols: &[X_HAT_T, T, BD, R],
        source: "Van Bijlert (2026), appendix C.2; (C.4) solved for x̂",
    },
    Equation {
        label: "C.7",
        aliases: &[],
        title: "Width of the contact transition",
        forms: &[form("", "Δx̂ = 2 atanh(1 − 2 t) / (bd R)", "smoothing::transition_width", "1")],
        symbols: &[WIDTH, T, BD, R],
        source: "Van Bijlert (2026), appendix C.2; twice (C.6)",
    },
    Equation {
        label: "C.8",
        aliases: &[],
        title: "bd for a wanted width of the contact transition",
        forms: &[form("", "bd = 2 atanh(1 − 2 t) / (Δx̂ R)", "smoothing::hertz_smoothing_for_width", "1/m")],
        symbols: &[BD, T, WIDTH, R],
        source: "Van Bijlert (2026), appendix C.2; (C.7) solved for bd",
    },
    Equation {
        label: "C.9",
        aliases: &[],
        title: "Force of SmoothSphereHalfSpaceForce",
        forms: &[
            form("", "F = (F_s + 3/2 F_s α ẋ)(½ + ½ tanh(bv (ẋ + 2/(3α))))", "SmoothSphere::force", "N"),
            form("second factor", "½ + ½ tanh(bv (ẋ + 2/(3α)))", "SmoothSphere::speed_state", "1"),
            form("second factor at rest", "½ + ½ tanh(2 bv/(3α))", "smoothing::speed_state_at_rest", "1"),
            form("at rest", "F = F_s (½ + ½ tanh(2 bv/(3α)))", "SmoothSphere::rest_force", "N"),
            form("its slope at rest", "∂F / ∂x at ẋ = 0", "SmoothSphere::rest_stiffness", "N/m"),
        ],
        symbols: &[F_SMOOTH, F_S, ALPHA, SPEED, BV],
        source: "Van Bijlert (2026), appendix C.2. With α = 0 the second factor is 1. At rest (ẋ = 0) it is below 1: by 3e-15 at α = 2 s/m and bv = 50 s/m, by 3.4 % at α = 20",
    },
    Equation {
        label: "C.10",
        aliases: &[],
        title: "bv from the sphere's radius, or for a wanted width",
        forms: &[
            form("", "bv = b_ẋ / √R", "smoothing::hunt_crossley_smoothing", "s/m"),
            form(
                "from a speed",
                "bv = 2 atanh(1 − 2 t) / Δv",
                "smoothing::hunt_crossley_smoothing_for_speed_width",
                "s/m",
            ),
            form(
                "as printed",
                "bv = 2 atanh(1 − 2 t) / (Δẋ √R)",
                "smoothing::hunt_crossley_smoothing_for_reduced_width",
                "s/m",
            ),
            form("a to b", "bv ∝ R^(−1/2)", "Ratios::hunt_crossley_smoothing", "1"),
        ],
        symbols: &[BV, B_V, R, T, SPEED_WIDTH, REDUCED_WIDTH],
        source: "Van Bijlert (2026), appendix C.2. A start: b_ẋ = 9. The printed form takes Δv / √R, not a speed. With another gravity also × (g_b / g_a)^(−1/2) (an extension)",
    },
];
