//! The equations of the paper: force laws and their scaling, then its appendices A to C.

use crate::equations::symbols::{
    ALPHA, ALPHA_1, ALPHA_2, B_V, B_X, BD, BV, C_R, CF, E, E_1, E_2, E_A, E_B, ETA, Equation, F, F_C,
    F_C_ALL, F_CF, F_D, F_E, F_N, F_N_EQ, F_S, F_SMOOTH, G, IMPACT, K, K_HAT, M, M_A, M_B, M_ON_SPHERE, N,
    N_A, N_B, P, POISSON, R, R_1, R_2, R_A, R_B, R_TWO, REDUCED_WIDTH, S_C, SHARE, SIGMA, SPEED, SPEED_WIDTH,
    T, WIDTH, X, X_HAT, X_HAT_C, X_HAT_EQ, X_HAT_T, YOUNG, form,
};

/// Equations (1) to (15) and Fig. 3 of the paper: the contact laws and how they scale.
pub(super) const EQUATIONS_OF_LAWS: &[Equation] = equations! {
    "1" [] "Hertz force of one sphere":
        form("", "F_e = 4/3 η √R E* x^(3/2)", "Hertz::force", "N"),
        form("for x", "x = (F_e / (4/3 η √R E*))^(2/3)", "Hertz::indentation_from_force", "m");
        [F_E, ETA, R, E, X]
        "Van Bijlert (2026), section 2; Hertz's law as in Johnson (1985) and Sherman et al. (2011)";
    "2" [] "Relative indentation":
        form("", "x̂ = x / R", "Hertz::relative_indentation", "1"),
        form("for x", "x = x̂ R", "Hertz::indentation", "m");
        [X_HAT, X, R] "Van Bijlert (2026), section 2";
    "3" [] "Hertz force by relative indentation":
        form("", "F_e = 4/3 η R² E* x̂^(3/2)", "Hertz::force_at_relative_indentation", "N");
        [F_E, ETA, R, E, X_HAT] "Van Bijlert (2026), section 2; it is (1) with (2)";
    "4" [] "Body weight is shared equally by the spheres":
        form("", "F_e ∝ M / n", "", "N");
        [F_E, M, N] "Van Bijlert (2026), section 2; a step to (8)";
    "5" [] "What the Hertz force grows with":
        form("", "F_e ∝ R² E* x̂^(3/2)", "", "");
        [F_E, R, E, X_HAT] "Van Bijlert (2026), section 2; it is (3), a step to (8)";
    "6" [] "Load per sphere and indentation":
        form("", "M / n ∝ E* x̂^(3/2) R²", "", "");
        [M, N, E, X_HAT, R] "Van Bijlert (2026), section 2; (4) with (5), a step to (8)";
    "7" [] "Load per sphere at the same relative indentation":
        form("", "M / n ∝ E* R²", "", "");
        [M, N, E, R] "Van Bijlert (2026), section 2; a step to (8)";
    "8" [] "How the modulus grows with body size at the same relative indentation":
        form("", "E* ∝ M / (n R²)", "Ratios::plane_strain_modulus", "1");
        [E, M, N, R]
        "Van Bijlert (2026), section 2. With geometric similarity R ∝ M^(1/3), so E* ∝ M^(1/3) too: this is what sets isometric radii";
    "9" [] "Ratio of the moduli of two animals":
        form("", "E*_b / E*_a = (M_b / M_a) (n_a / n_b) (R_a² / R_b²)", "Ratios::plane_strain_modulus", "1");
        [E_B, E_A, M_B, M_A, N_A, N_B, R_A, R_B] "Van Bijlert (2026), section 2.1; it is (8) for a and b";
    "10" [] "The modulus of another animal":
        form("", "E*_b = (M_b / M_a) (n_a / n_b) (R_a² / R_b²) E*_a", "Ratios::plane_strain_modulus", "1");
        [E_B, E_A, M_B, M_A, N_A, N_B, R_A, R_B]
        "Van Bijlert (2026), section 2.1. It holds for E₁* (OpenSim's stiffness) as well, since both surfaces are equal (A.4). With another gravity also × g_b / g_a (an extension)";
    "11" [] "The modulus for a wanted relative indentation under a known load":
        form("", "E* = 3 F / (4 η R² x̂^(3/2) n)", "design::composite_modulus", "N/m²"),
        form("for x̂", "x̂ = (3 F / (4 η E* R² n))^(2/3)", "design::relative_indentation", "1");
        [E, F, ETA, R, X_HAT, N]
        "Van Bijlert (2026), section 2.2. Multiply by 2^(3/2) (A.4) to get OpenSim's stiffness";
    "12" [] "Hunt–Crossley dissipation":
        form("", "F_d = 3/2 F_e α ẋ", "HuntCrossley::dissipative_force", "N"),
        form("the sum", "F_c = F_e (1 + 3/2 α ẋ)", "HuntCrossley::force", "N");
        [F_D, F_E, ALPHA, SPEED, F_C] "Van Bijlert (2026), section 2.3; Hunt and Crossley (1975)";
    "13" [] "Coefficient of restitution, approximate":
        form("", "c_r = 1 − α ẋ⁻", "restitution::approximate", "1"),
        form("for α", "α = (1 − c_r) / ẋ⁻", "restitution::dissipation", "s/m");
        [C_R, ALPHA, IMPACT]
        "Van Bijlert (2026), section 2.3; Hunt and Crossley (1975). Accurate for c_r of about 0.8 and above; refused where it is negative";
    "14" [] "How dissipation follows body size at the same restitution":
        form("", "α ∝ R^(−1/2)", "Ratios::dissipation", "1"),
        form("by mass", "α ∝ M^(−1/6)", "Ratios::dissipation_by_mass", "1");
        [ALPHA, R, M]
        "Van Bijlert (2026), section 2.3. With another gravity also × (g_b / g_a)^(−1/2) (an extension)";
    "15" [] "Mean stress on the contact patch":
        form("", "σ = F_c / (π R² x̂)", "patch::mean_stress", "N/m²");
        [SIGMA, F_C, R, X_HAT] "Van Bijlert (2026), section 4.3; the patch is the circle of Fig. 3";
    "Fig. 3" ["patch"] "Size of the contact patch":
        form("", "patch radius √(x R)", "patch::radius", "m"),
        form("", "patch diameter 2 √(x R)", "patch::diameter", "m"),
        form("", "patch radius / R = √x̂", "patch::relative_radius", "1");
        [X, R, X_HAT] "Van Bijlert (2026), Fig. 3; for small x";
};

// Moduli of surfaces: appendix A.

/// Equations (A.1) to (A.5) of the paper, and the mixing rules of Simbody and Johnson: moduli of two surfaces.
pub(super) const EQUATIONS_OF_SURFACES: &[Equation] = equations! {
    "A.1" [] "Plane strain modulus from Young's modulus":
        form("", "E₁* = E₁ / (1 − ν₁²)", "modulus::plane_strain", "N/m²");
        [E_1, YOUNG, POISSON] "Van Bijlert (2026), appendix A; Johnson (1985)";
    "A.2" [] "Composite modulus, Johnson's rule":
        form("", "E* = E₁* E₂* / (E₁* + E₂*)", "modulus::composite_johnson", "N/m²");
        [E, E_1, E_2] "Van Bijlert (2026), appendix A; Johnson (1985). OpenSim uses (A.3)";
    "A.3" [] "Composite modulus, the rule of Simbody and OpenSim":
        form("", "E* = (E₁*^(2/3) E₂*^(2/3) / (E₁*^(2/3) + E₂*^(2/3)))^(3/2)", "modulus::composite_sherman", "N/m²");
        [E, E_1, E_2] "Van Bijlert (2026), appendix A; Sherman et al. (2011)";
    "A.4" [] "Modulus of one of two equal surfaces":
        form("", "E₁* = 2^p E*", "modulus::of_equal_surfaces", "N/m²"),
        form("for E*", "E* = E₁* / 2^p", "modulus::composite_of_equal", "N/m²");
        [E_1, E, P]
        "Van Bijlert (2026), appendix A. OpenSim's stiffness is E₁*: 2^(3/2) times what the contact feels";
    "A.5" [] "A soft body on rigid ground":
        form("", "E* → E₁* for E₂* → ∞", "modulus::stiffness_on_rigid_ground", "N/m²"),
        form("to write", "stiffness = 2^(3/2) E₁ / (1 − ν₁²)", "modulus::stiffness_on_rigid_ground", "N/m²");
        [E, E_1, E_2, YOUNG, POISSON]
        "Van Bijlert (2026), appendix A; with (A.1) and (A.4) it gives the stiffness to write in OpenSim";
    "Simbody" ["mixed dissipation"] "Dissipation of two unlike surfaces":
        form("", "α = α₁ s₁ + α₂ (1 − s₁), s₁ = E₂*^(2/3) / (E₁*^(2/3) + E₂*^(2/3))", "modulus::mixed_dissipation", "s/m");
        [ALPHA, ALPHA_1, ALPHA_2, SHARE, E_1, E_2]
        "not numbered in the paper: Simbody's HuntCrossleyForce (Sherman et al. 2011)";
    "Johnson" ["composite radius"] "Composite radius of two spheres":
        form("", "R = R₁ R₂ / (R₁ + R₂)", "modulus::composite_radius", "m");
        [R_TWO, R_1, R_2] "not numbered in the paper: Johnson (1985), as in section 2";
};

// Stiffness and natural frequency: appendix B.

/// Equations (B.1) to (B.5) of the paper: contact stiffness and natural frequency.
pub(super) const EQUATIONS_OF_STIFFNESS: &[Equation] = equations! {
    "B.1" [] "Contact stiffness of one sphere":
        form("", "k = 2 η √R E* √x", "Hertz::stiffness", "N/m");
        [K, ETA, R, E, X] "Van Bijlert (2026), appendix B; the slope of (1)";
    "B.2" [] "Contact stiffness by relative indentation":
        form("", "k = 2 η R E* √x̂", "Hertz::stiffness_at_relative_indentation", "N/m"),
        form("for E*", "E* = k / (2 η R √x̂)", "design::composite_modulus_for_stiffness", "N/m²"),
        form("with (11)", "R = 3 F / (2 k x̂ n)", "design::radius_for_stiffness", "m");
        [K, ETA, R, E, X_HAT, F, N] "Van Bijlert (2026), appendix B; (B.1) with (2)";
    "B.3" [] "Dimensionless stiffness":
        form("", "k̂ = k R n / F_c", "stiffness::dimensionless", "1"),
        form("Hertz", "k̂ = 3 / (2 x̂)", "stiffness::dimensionless_hertz", "1");
        [K_HAT, K, R, N, F_C_ALL, X_HAT]
        "Van Bijlert (2026), appendix B, which cites Alexander et al. (1986). The second form: (B.2), (3)";
    "B.4" [] "Natural frequency of one loaded sphere":
        form("", "f_n = √(k / M) / (2π)", "stiffness::natural_frequency", "Hz");
        [F_N, K, M_ON_SPHERE] "Van Bijlert (2026), appendix B; for small oscillations without damping";
    "B.5" [] "Natural frequency at rest under body weight":
        form("", "f_n,eq = √(3/2 · g / (x̂_eq R)) / (2π)", "stiffness::equilibrium_frequency", "Hz");
        [F_N_EQ, G, X_HAT_EQ, R] "Van Bijlert (2026), appendix B; (B.4) with (B.2) and (3)";
};

// `SmoothSphereHalfSpaceForce`: appendix C.

/// Equations (C.1) to (C.10) of the paper: the smoothed law.
pub(super) const EQUATIONS_OF_SMOOTHING: &[Equation] = equations! {
    "C.1" [] "Hertz force with a constant indentation":
        form("", "F_cf = 4/3 η √R E* (x² + cf)^(3/4)", "SmoothSphere::constant_indentation_force", "N");
        [F_CF, ETA, R, E, X, CF] "Van Bijlert (2026), appendix C.1, printed there as √(x² + cf)^(3/2)";
    "C.2" [] "cf for a wanted constant relative indentation":
        form("", "cf = (R x̂_c)²", "smoothing::constant_contact_force", "m²"),
        form("for x̂_c", "x̂_c = √cf / R", "smoothing::constant_indentation", "1"),
        form("a to b", "cf ∝ R²", "Ratios::constant_contact_force", "1");
        [CF, R, X_HAT_C]
        "Van Bijlert (2026), appendix C.1. A start: x̂_c = 0.1, or 0.05 where x̂ below 0.16 is wanted";
    "C.3" [] "Smoothed elastic force":
        form("", "F_s = F_cf s_c(x)", "SmoothSphere::elastic_force", "N"),
        form("its slope", "∂F_s / ∂x", "SmoothSphere::stiffness", "N/m");
        [F_S, F_CF, S_C, X] "Van Bijlert (2026), appendix C.2";
    "C.4" [] "Contact state, a smoothed step":
        form("", "s_c = ½ + ½ tanh(bd x)", "SmoothSphere::contact_state", "1");
        [S_C, BD, X] "Van Bijlert (2026), appendix C.2";
    "C.5" [] "bd from a pure number":
        form("", "bd = b_x̂ / R", "smoothing::hertz_smoothing", "1/m"),
        form("a to b", "bd ∝ 1/R", "Ratios::hertz_smoothing", "1");
        [BD, B_X, R] "Van Bijlert (2026), appendix C.2. A start: b_x̂ = 10";
    "C.6" [] "Indentation at which the contact state reaches a threshold":
        form("", "x̂_t = atanh(1 − 2 t) / (bd R)", "smoothing::threshold_indentation", "1");
        [X_HAT_T, T, BD, R] "Van Bijlert (2026), appendix C.2; (C.4) solved for x̂";
    "C.7" [] "Width of the contact transition":
        form("", "Δx̂ = 2 atanh(1 − 2 t) / (bd R)", "smoothing::transition_width", "1");
        [WIDTH, T, BD, R] "Van Bijlert (2026), appendix C.2; twice (C.6)";
    "C.8" [] "bd for a wanted width of the contact transition":
        form("", "bd = 2 atanh(1 − 2 t) / (Δx̂ R)", "smoothing::hertz_smoothing_for_width", "1/m");
        [BD, T, WIDTH, R] "Van Bijlert (2026), appendix C.2; (C.7) solved for bd";
    "C.9" [] "Force of SmoothSphereHalfSpaceForce":
        form("", "F = (F_s + 3/2 F_s α ẋ)(½ + ½ tanh(bv (ẋ + 2/(3α))))", "SmoothSphere::force", "N"),
        form("second factor", "½ + ½ tanh(bv (ẋ + 2/(3α)))", "SmoothSphere::speed_state", "1"),
        form("second factor at rest", "½ + ½ tanh(2 bv/(3α))", "smoothing::speed_state_at_rest", "1"),
        form("at rest", "F = F_s (½ + ½ tanh(2 bv/(3α)))", "SmoothSphere::rest_force", "N"),
        form("its slope at rest", "∂F / ∂x at ẋ = 0", "SmoothSphere::rest_stiffness", "N/m");
        [F_SMOOTH, F_S, ALPHA, SPEED, BV]
        "Van Bijlert (2026), appendix C.2. With α = 0 the second factor is 1. At rest (ẋ = 0) it is below 1: by 3e-15 at α = 2 s/m and bv = 50 s/m, by 3.4 % at α = 20";
    "C.10" [] "bv from the sphere's radius, or for a wanted width":
        form("", "bv = b_ẋ / √R", "smoothing::hunt_crossley_smoothing", "s/m"),
        form("from a speed", "bv = 2 atanh(1 − 2 t) / Δv", "smoothing::hunt_crossley_smoothing_for_speed_width", "s/m"),
        form("as printed", "bv = 2 atanh(1 − 2 t) / (Δẋ √R)", "smoothing::hunt_crossley_smoothing_for_reduced_width", "s/m"),
        form("a to b", "bv ∝ R^(−1/2)", "Ratios::hunt_crossley_smoothing", "1");
        [BV, B_V, R, T, SPEED_WIDTH, REDUCED_WIDTH]
        "Van Bijlert (2026), appendix C.2. A start: b_ẋ = 9. The printed form takes Δv / √R, not a speed. With another gravity also × (g_b / g_a)^(−1/2) (an extension)";
};
