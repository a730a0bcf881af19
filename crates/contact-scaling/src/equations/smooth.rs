//! `SmoothSphereHalfSpaceForce`: appendix C.

use super::equation::{Equation, form};
use super::symbols::{
    ALPHA, B_V, B_X, BD, BV, CF, E, ETA, F_CF, F_S, F_SMOOTH, R, REDUCED_WIDTH, S_C, SPEED, SPEED_WIDTH, T,
    WIDTH, X, X_HAT_C, X_HAT_T,
};

pub(super) const ALL: &[Equation] = &[
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
