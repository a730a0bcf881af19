//! Which part of the project uses an equation.

use osim_model::messages::Phrase;

/// Where the equation called `label` meets the user; empty for a label that is not known.
#[must_use]
pub fn uses(label: &str) -> Phrase {
    Phrase::template(template(label))
}

/// Inputs and calls are in backticks.
fn template(label: &str) -> &'static str {
    match label {
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
    }
}

#[cfg(test)]
mod tests {
    use super::template;
    use crate::report::explain::equations::equations;

    #[test]
    fn every_equation_says_what_uses_it() {
        for equation in equations() {
            assert!(!template(equation.label).is_empty(), "{}", equation.label);
        }
    }
}
