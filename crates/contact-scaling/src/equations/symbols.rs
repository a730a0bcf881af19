//! The types of the register of equations, and all symbols.
#![allow(missing_docs, reason = "each constant says what it is")]

/// A symbol of an equation, with its meaning and unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Symbol {
    /// The symbol as it is written in the formulas.
    pub symbol: &'static str,
    /// Meaning of the symbol, with OpenSim's property name if there is one.
    pub meaning: &'static str,
    /// SI unit; `1` for a pure number.
    pub unit: &'static str,
}

const fn symbol(symbol: &'static str, meaning: &'static str, unit: &'static str) -> Symbol {
    Symbol { symbol, meaning, unit }
}

pub const F_E: Symbol = symbol("F_e", "elastic force of one sphere", "N");
pub const F_D: Symbol = symbol("F_d", "dissipative force of one sphere", "N");
pub const F_C: Symbol = symbol("F_c", "contact force of one sphere, elastic and dissipative", "N");
pub const F_C_ALL: Symbol = symbol("F_c", "contact force of all n spheres together", "N");
pub const F_CF: Symbol = symbol("F_cf", "elastic force with the constant indentation", "N");
pub const F_S: Symbol = symbol("F_s", "smoothed elastic force", "N");
pub const F: Symbol = symbol("F", "expected load on all n spheres together", "N");
pub const F_SMOOTH: Symbol = symbol("F", "smoothed contact force of one sphere", "N");
pub const F_I: Symbol = symbol("F_i", "smoothed contact force of sphere i", "N");
pub const F_LOAD: Symbol = symbol("F", "load on all spheres together", "N");
pub const X: Symbol = symbol("x", "indentation: how far sphere and ground overlap", "m");
pub const X_HAT: Symbol = symbol("x̂", "relative indentation, x / R", "1");
pub const X_HAT_EQ: Symbol = symbol("x̂_eq", "relative indentation at rest under body weight", "1");
pub const X_HAT_C: Symbol = symbol("x̂_c", "constant relative indentation", "1");
pub const X_HAT_T: Symbol = symbol("x̂_t", "relative indentation at which s_c is 1 − t", "1");
pub const WIDTH: Symbol = symbol("Δx̂", "relative indentation from s_c = t to s_c = 1 − t", "1");
pub const SPEED: Symbol = symbol("ẋ", "rate of indentation, above 0 while the sphere sinks in", "m/s");
pub const IMPACT: Symbol = symbol("ẋ⁻", "speed just before impact", "m/s");
pub const R: Symbol = symbol("R", "radius of the sphere (OpenSim: radius)", "m");
pub const R_TWO: Symbol = symbol("R", "composite radius of two spheres", "m");
pub const R_1: Symbol = symbol("R₁", "radius of the first sphere", "m");
pub const R_2: Symbol = symbol("R₂", "radius of the second sphere", "m");
pub const R_A: Symbol = symbol("R_a", "radius of the spheres of a, the reference", "m");
pub const R_B: Symbol = symbol("R_b", "radius of the spheres of b, the model", "m");
pub const R_I: Symbol = symbol("R_i", "radius of sphere i", "m");
pub const H_I: Symbol = symbol("h_i", "height of the bottom of sphere i above the lowest", "m");
pub const R_EQUIVALENT: Symbol = symbol("R", "radius that n equal spheres would have", "m");
pub const R_SQUARE: Symbol = symbol("R²", "square of the radius that n equal spheres would have", "m²");
pub const E: Symbol = symbol("E*", "composite plane strain modulus of the contact", "N/m²");
pub const E_A: Symbol = symbol("E*_a", "composite plane strain modulus of a, the reference", "N/m²");
pub const E_B: Symbol = symbol("E*_b", "composite plane strain modulus of b, the model", "N/m²");
pub const E_I: Symbol = symbol("E*_i", "composite plane strain modulus of sphere i", "N/m²");
pub const E_1: Symbol =
    symbol("E₁*", "plane strain modulus of one of the two surfaces (OpenSim: stiffness)", "N/m²");
pub const E_2: Symbol = symbol("E₂*", "plane strain modulus of the other surface", "N/m²");
pub const YOUNG: Symbol = symbol("E₁", "Young's modulus of the material", "N/m²");
pub const POISSON: Symbol = symbol("ν₁", "Poisson's ratio of the material", "1");
pub const P: Symbol = symbol("p", "1 with (A.2), 3/2 with (A.3) as in OpenSim (the paper's n here)", "1");
pub const ETA: Symbol = symbol("η", "shape factor, 1 for spheres", "1");
pub const N: Symbol = symbol("n", "spheres that share the load", "1");
pub const N_I: Symbol = symbol("n_i", "how many spheres are like sphere i, itself included", "1");
pub const N_A: Symbol = symbol("n_a", "spheres that share the load of a, the reference", "1");
pub const N_B: Symbol = symbol("n_b", "spheres that share the load of b, the model", "1");
pub const M: Symbol = symbol("M", "body mass", "kg");
pub const M_A: Symbol = symbol("M_a", "body mass of a, the reference", "kg");
pub const M_B: Symbol = symbol("M_b", "body mass of b, the model", "kg");
pub const M_ON_SPHERE: Symbol = symbol("M", "mass on that sphere, body mass / n", "kg");
pub const G: Symbol = symbol("g", "gravity", "m/s²");
pub const ALPHA: Symbol = symbol("α", "Hunt–Crossley dissipation (OpenSim: dissipation)", "s/m");
pub const ALPHA_1: Symbol = symbol("α₁", "dissipation of one surface", "s/m");
pub const ALPHA_2: Symbol = symbol("α₂", "dissipation of the other surface", "s/m");
pub const SHARE: Symbol = symbol("s₁", "share of the indentation that the first surface takes", "1");
pub const C_R: Symbol = symbol("c_r", "coefficient of restitution, by the approximation", "1");
pub const C_EXACT: Symbol = symbol("c", "coefficient of restitution, exact", "1");
pub const D: Symbol = symbol("d", "3/2 α ẋ⁻", "1");
pub const SIGMA: Symbol = symbol("σ", "mean stress on the contact patch", "N/m²");
pub const K: Symbol = symbol("k", "contact stiffness of one sphere, the slope of its force", "N/m");
pub const K_HAT: Symbol = symbol("k̂", "dimensionless stiffness", "1");
pub const K_HAT_A: Symbol = symbol("k̂_a", "dimensionless stiffness with E*_a", "1");
pub const K_HAT_B: Symbol = symbol("k̂_b", "dimensionless stiffness with E*_b", "1");
pub const F_N: Symbol = symbol("f_n", "natural frequency of small oscillations", "Hz");
pub const F_N_EQ: Symbol = symbol("f_n,eq", "natural frequency at rest under body weight", "Hz");
pub const CF: Symbol =
    symbol("cf", "a squared indentation, in spite of its name in OpenSim: constant_contact_force", "m²");
pub const BD: Symbol = symbol("bd", "how sharply contact begins (OpenSim: hertz_smoothing)", "1/m");
pub const BV: Symbol =
    symbol("bv", "how sharply the force is cut off (OpenSim: hunt_crossley_smoothing)", "s/m");
pub const B_X: Symbol = symbol("b_x̂", "bd without dimension, bd R", "1");
pub const B_V: Symbol = symbol("b_ẋ", "bv with only the radius taken out, bv √R", "s/√m");
pub const S_C: Symbol = symbol("s_c", "contact state: 0 is none, 1 is full contact", "1");
pub const T: Symbol = symbol("t", "threshold on a smoothed step, such as 0.05", "1");
pub const SPEED_WIDTH: Symbol = symbol("Δv", "speed over which the step goes from t to 1 − t", "m/s");
pub const REDUCED_WIDTH: Symbol = symbol("Δẋ", "Δv / √R", "√m/s");
pub const SPEED_STATE: Symbol =
    symbol("second factor", "speed state: 0 is where the force would pull, 1 is where it pushes", "1");
pub const PATCH_RADIUS: Symbol =
    symbol("patch radius", "radius of the circle on which sphere and ground touch", "m");
pub const PATCH_DIAMETER: Symbol =
    symbol("patch diameter", "diameter of the circle on which sphere and ground touch", "m");
pub const RELATIVE_PATCH_RADIUS: Symbol =
    symbol("patch radius / R", "patch radius by the radius of the sphere", "1");
pub const MASS_RATIO: Symbol =
    symbol("M_b / M_a", "body mass of b, the model, divided by that of a, the reference", "1");
pub const SPHERE_COUNT_RATIO: Symbol = symbol(
    "n_b / n_a",
    "spheres that share the load of b, the model, divided by those of a, the reference",
    "1",
);
pub const RADIUS_RATIO: Symbol =
    symbol("R_b / R_a", "radius of the spheres of b, the model, divided by that of a, the reference", "1");
pub const GRAVITY_RATIO: Symbol =
    symbol("g_b / g_a", "gravity where b, the model, lives, divided by that of a, the reference", "1");
pub const V_T: Symbol = symbol("transition_velocity", "slip speed at which friction is fully there", "m/s");
pub const U_V: Symbol = symbol("viscous_friction", "friction that grows with slip speed", "s/m");

// One equation, as the register has it.

/// An equation in one or several forms.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Equation {
    /// The paper's number without brackets (`10`, `C.5`), or a name if the paper has no number.
    pub label: &'static str,
    /// Other names under which the equation is found.
    pub aliases: &'static [&'static str],
    /// Content of the equation in a few words.
    pub title: &'static str,
    /// The printed form first, then forms that are solved for another symbol or hold between two bodies.
    pub forms: &'static [Form],
    /// All symbols in the formulas.
    pub symbols: &'static [Symbol],
    /// Source of the equation: the paper's section, or another publication.
    pub source: &'static str,
}

/// A way to write an equation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Form {
    /// The difference from the first form, such as `for x`; empty for the first form.
    pub variant: &'static str,
    /// The formula in Unicode.
    pub formula: &'static str,
    /// The function of this crate that computes the form, as `Type::name` or `module::name`; empty for a step of a
    /// derivation.
    pub function: &'static str,
    /// Unit of the result; `1` for a pure number, empty if no function computes it.
    pub unit: &'static str,
}

pub(super) const fn form(
    variant: &'static str,
    formula: &'static str,
    function: &'static str,
    unit: &'static str,
) -> Form {
    Form { variant, formula, function, unit }
}
