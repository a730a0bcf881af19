//! The equations as functions of plain numbers, for `osim_contact_scale.scaling`.
//!
//! A name without "for" is what the name says; a property of OpenSim alone, such as `dissipation`, is the factor by which it
//! grows from one animal to another; `dissipation_for_restitution` is its value for what is wanted. Moduli are E\* of both
//! surfaces unless the name says plane strain: OpenSim's `stiffness` is a plane strain modulus.
//!
//! What an equation says, its number, its units and what its symbols mean come from the register of `contact-scaling`.

mod equation_error;
mod function;
mod laws;
mod parameter;
mod smooth;
mod spheres;
mod text;

pub(crate) use equation_error::EquationError;
pub(crate) use function::{Function, RustFunction};
pub(crate) use laws::continuation_steps;
pub(crate) use parameter::{Parameter, RULES, rule_by_name};
pub(crate) use spheres::{MEAN_SQUARE_RADIUS, SPHERE_LIST_FUNCTIONS};

/// All functions that take numbers, in the order of the paper.
pub(crate) fn all() -> impl Iterator<Item = &'static Function> {
    [
        laws::HERTZ,
        laws::RESTITUTION,
        laws::SURFACES,
        laws::STIFFNESS,
        smooth::SMOOTH,
        smooth::SMOOTHING,
        laws::RATIOS,
    ]
    .into_iter()
    .flatten()
}
