//! What is in the column "equation" where no equation of the paper does: rules of this project.

use contact_scaling::Equation;
use contact_scaling::equations::{Form, Symbol};

const fn rule(formula: &'static str) -> Form {
    Form { note: "", formula, function: "", unit: "" }
}

const fn symbol(symbol: &'static str, meaning: &'static str, unit: &'static str) -> Symbol {
    Symbol { symbol, meaning, unit }
}

const R_A: Symbol = symbol("R_a", "radius of the sphere before, or in the generic model", "m");
const R_B: Symbol = symbol("R_b", "radius of the sphere to be written", "m");

/// Rules by the word that is printed. Inputs are in backticks.
pub(super) const ALL: &[Equation] = &[
    Equation {
        label: "given",
        aliases: &[],
        title: "The number you gave, or the old one times the factor you gave",
        forms: &[rule("new = given"), Form { note: "by a factor", ..rule("new = factor × now") }],
        symbols: &[],
        source: "your request: set, `radius=METRES` or xFACTOR",
    },
    Equation {
        label: "follow",
        aliases: &["follow bodies"],
        title: "Place and size from the scaled body",
        forms: &[
            Form { note: "radius", ..rule("R_b = (s_x s_y s_z)^(1/3) R_a") },
            Form { note: "centre", ..rule("new centre = (s_x x, s_y y, s_z z)") },
        ],
        symbols: &[
            R_B,
            R_A,
            symbol("s_x", "scale factor of the body along its axis x, likewise s_y and s_z", "1"),
            symbol("x", "location of the centre along the body's axis x, likewise y and z", "m"),
        ],
        source: "docs/scaling.md: what the Scale Tool did to the body. `radius_axis` takes one factor for the radius instead of the mean; with `level` the bottom is scaled, and the centre stands one new radius above it",
    },
    Equation {
        label: "level",
        aliases: &[],
        title: "The bottom stays on the sole, or comes down to the lowest of its foot",
        forms: &[
            Form { note: "rescale, transfer", ..rule("new centre = centre + (R_b − R_a) up") },
            Form { note: "set, add", ..rule("new centre = centre − (h − h_min) n") },
        ],
        symbols: &[
            R_B,
            R_A,
            symbol("up", "the axis of the sphere's frame that points up (`level_axis`)", "1"),
            symbol(
                "h",
                "height of the sphere's bottom over its floor at the default pose, with its new radius",
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
            Form { note: "stiffness", ..rule("E₁*_b = (M_b / M_a) / h² E₁*_a") },
            Form { note: "dissipation", ..rule("α_b = α_a / h") },
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
