//! Explanations of equations: of the paper, of other sources, and rules of this project; and where each is used.

use contact_scaling::Equation;
use contact_scaling::equations::{Form, Symbol};
use osim_model::messages::Phrase;

/// The equations of the paper and of other sources, then the rules of this project.
///
/// Texts may name inputs and calls in backticks, as
/// [`Phrase::template`](osim_model::messages::Phrase::template) reads them.
pub fn equations() -> impl Iterator<Item = &'static Equation> {
    contact_scaling::equations::all().chain(EQUATIONS_OF_PROJECT)
}

/// The equation or rule with this name, such as `10`, `C.5` or `given`.
pub fn equation(name: &str) -> Option<&'static Equation> {
    let rule = || EQUATIONS_OF_PROJECT.iter().find(|rule| rule.label.eq_ignore_ascii_case(name));
    contact_scaling::equations::find(name).or_else(rule)
}

// What is in the column "equation" where no equation of the paper does: rules of this project.

const fn rule(formula: &'static str) -> Form {
    Form { variant: "", formula, function: "", unit: "" }
}

const fn symbol(symbol: &'static str, meaning: &'static str, unit: &'static str) -> Symbol {
    Symbol { symbol, meaning, unit }
}

const RADIUS_BEFORE: Symbol = symbol("R_a", "radius of the sphere before, or in the generic model", "m");
const RADIUS_WRITTEN: Symbol = symbol("R_b", "radius of the sphere to be written", "m");

/// Rules of this project, by the word that is printed in place of an equation's number. Names of inputs are in backquotes.
const EQUATIONS_OF_PROJECT: &[Equation] = &[
    Equation {
        label: "given",
        aliases: &[],
        title: "The number you gave, or the old one times the factor you gave",
        forms: &[rule("new = given"), Form { variant: "by a factor", ..rule("new = factor × now") }],
        symbols: &[],
        source: "your request: set, `radius=METRES` or xFACTOR",
    },
    Equation {
        label: "follow",
        aliases: &["follow bodies"],
        title: "Place and size from the scaled body",
        forms: &[
            Form { variant: "radius", ..rule("R_b = (s_x s_y s_z)^(1/3) R_a") },
            Form { variant: "centre", ..rule("new centre = (s_x x, s_y y, s_z z)") },
        ],
        symbols: &[
            RADIUS_WRITTEN,
            RADIUS_BEFORE,
            symbol("s_x", "scale factor of the body along its axis x, likewise s_y and s_z", "1"),
            symbol("x", "location of the centre along the body's axis x, likewise y and z", "m"),
        ],
        source: "docs/scaling.md: what the Scale Tool did to the body. The radius is that of `radius=follow` (the default is (8)); `radius_axis` takes one factor instead of the mean. With `level` or (8) the lowest point is scaled, and the centre is one new radius above it",
    },
    Equation {
        label: "level",
        aliases: &[],
        title: "The lowest point stays on the sole, or moves to the lowest of its foot",
        forms: &[
            Form { variant: "rescale, transfer", ..rule("new centre = centre + (R_b − R_a) up") },
            Form { variant: "set, add", ..rule("new centre = centre − (h − h_min) n") },
        ],
        symbols: &[
            RADIUS_WRITTEN,
            RADIUS_BEFORE,
            symbol("up", "the axis of the sphere's frame that points up (`level_axis`)", "1"),
            symbol(
                "h",
                "height of the sphere's lowest point over its floor at the default pose, with its new radius",
                "m",
            ),
            symbol("h_min", "the least h of the spheres of its limb", "m"),
            symbol("n", "the normal of its floor", "1"),
        ],
        source: "your request: `level`",
    },
    Equation {
        label: "predsim",
        aliases: &[],
        title: "PredSim's rule, to compare with",
        forms: &[
            Form { variant: "stiffness", ..rule("E₁*_b = (M_b / M_a) / h² E₁*_a") },
            Form { variant: "dissipation", ..rule("α_b = α_a / h") },
        ],
        symbols: &[
            symbol("E₁*", "plane strain modulus of one of the two surfaces (OpenSim: stiffness)", "N/m²"),
            symbol("α", "Hunt–Crossley dissipation (OpenSim: dissipation)", "s/m"),
            symbol("M_a", "mass the reference's contacts are made for", "kg"),
            symbol("M_b", "mass of the model", "kg"),
            symbol("h", "ratio of the heights, model to reference", "1"),
        ],
        source: "PredSim; smoothing stays as in the reference. docs/scaling.md compares it with the paper's rule",
    },
];

/// A sentence about where the user meets the equation called `label`; empty if there is no such equation.
pub(crate) fn sentence_of_use(label: &str) -> Phrase {
    Phrase::template(match label {
        "1" => "fit: modulus and contact onset; drop-test: force of a HuntCrossleyForce; inspect",
        "2" => "relative indentation, everywhere",
        "3" => "design: load per sphere; through (11) everywhere",
        "4" | "5" | "6" | "7" => "a step of the derivation of (8)",
        "8" => "rescale, transfer, add: isometric radii",
        "9" => "through (10)",
        "10" => "rescale, transfer, add, design: stiffness",
        "11" => {
            "design: stiffness, radius, relative indentation; presets and reports: indentation at body weight"
        }
        "12" => "fit: dissipation; drop-test: force of a HuntCrossleyForce",
        "13" => "design: dissipation for a wanted restitution; inspect, drop-test: restitution",
        "14" => "rescale, transfer, add, design: dissipation",
        "15" => "inspect, design: mean contact stress",
        "Fig. 3" => "design: contact patch diameter",
        "A.1" | "A.5" => "`design young poisson`",
        "A.2" => "the library only: OpenSim mixes by (A.3)",
        "A.3" => "forces with several ContactParameters: their common modulus, which convert writes",
        "A.4" => "design, fit: the stiffness to write; transfer",
        "Simbody" => "forces with several ContactParameters: their common dissipation",
        "Johnson" => "the library only: sphere on sphere",
        "B.1" => "drop-test: stiffness at rest by the Hertz law",
        "B.2" => "inspect, design: contact stiffness, and the radius for a wanted one",
        "B.3" => "inspect, design: dimensionless stiffness",
        "B.4" => "inspect, design: natural frequency",
        "B.5" => "design: equilibrium frequency",
        "C.1" | "C.4" => "through (C.3)",
        "C.2" => {
            "rescale, transfer, add, convert, design: constant_contact_force; inspect: the same over the radius"
        }
        "C.3" => "through (C.9)",
        "C.5" => "rescale, transfer, add, convert, design: hertz_smoothing",
        "C.6" => "the library only",
        "C.7" => "inspect: width of the contact transition",
        "C.8" => "`design state_width`: hertz_smoothing",
        "C.9" => {
            "drop-test: force of a SmoothSphereHalfSpaceForce; at rest also inspect, plot: indentation, force with the sphere just touching; design: stiffness"
        }
        "C.10" => "rescale, transfer, add, convert, design: hunt_crossley_smoothing",
        "drop speed" => "inspect, design, drop-test: the speed of an impact where none is given",
        "exact restitution" => "inspect, design, drop-test, transfer: restitution by the exact law",
        "rest by (1)" => "inspect, drop-test: indentation at rest by the Hertz law",
        "rest at own heights" => "inspect: indentation of each sphere at its own height, at the default pose",
        "rest by (C.9)" => "inspect, drop-test: indentation at rest by the model's law",
        "continuation" => "`sweep ladder`: stiffness of the steps",
        "mixed radii" => "rescale, transfer: one ContactParameters with spheres of several radii",
        "friction" => "`friction`: transition_velocity and viscous_friction",
        "given" => "set, `radius`",
        "follow" => "`transfer follow_bodies`, add: radius and centre of spheres",
        "level" => "`level`: centre of spheres",
        "predsim" => "`transfer follow_bodies rule=predsim`: stiffness, dissipation, smoothing",
        _ => "",
    })
}

#[cfg(test)]
mod tests {
    use super::{equations, sentence_of_use};

    #[test]
    fn every_equation_says_what_uses_it() {
        for equation in equations() {
            assert!(!sentence_of_use(equation.label).to_string().is_empty(), "{}", equation.label);
        }
    }
}
