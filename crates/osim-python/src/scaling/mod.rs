//! The equations as functions of plain numbers, for `osim_contact_scale.scaling`.
//!
//! Names of functions: `dissipation_for_restitution` gives the dissipation for a wanted restitution. A property of OpenSim alone,
//! such as `dissipation`, gives the factor of this property from one animal to another. Any other name is the computed quantity.
//! Moduli are E\* of both surfaces unless the name says plane strain: OpenSim's `stiffness` is a plane strain modulus.
//!
//! The description of an equation, its number, its units and the meanings of its symbols come from the register of `contact-scaling`.

mod function;
mod laws;
pub(crate) mod mean_square_radius;
mod spheres;

pub(crate) use function::{EquationError, Function, MIXING_RULES, Parameter, rule_by_name};
pub(crate) use spheres::SPHERE_LIST_FUNCTIONS;

/// All functions that take numbers, in the order of the paper.
pub(crate) fn all() -> impl Iterator<Item = &'static Function> {
    [
        laws::HERTZ,
        laws::RESTITUTION,
        laws::SURFACES,
        laws::STIFFNESS,
        laws::SMOOTH,
        laws::SMOOTHING,
        laws::RATIOS,
    ]
    .into_iter()
    .flatten()
}
