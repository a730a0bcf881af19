//! The equations as functions of plain numbers, for `osim_contact_scale.scaling`.
//!
//! A name without "for" is what the name says; a property of OpenSim alone, such as `dissipation`, is the factor by which it
//! grows from one animal to another; `dissipation_for_restitution` is its value for what is wanted. Moduli are E\* of both
//! surfaces unless the name says plane strain: OpenSim's `stiffness` is a plane strain modulus.
//!
//! What an equation says, its number, its units and what its symbols mean come from the register of `contact-scaling`.

mod columns;
mod define;
mod failure;
mod function;
mod hertz;
mod lists;
mod parameter;
mod ratios;
mod restitution;
mod rule;
mod smooth;
mod smoothing;
mod spheres;
mod steps;
mod stiffness;
mod surfaces;
mod text;

pub(crate) use failure::Failure;
pub(crate) use function::{Call, Function};
pub(crate) use lists::MEAN_SQUARE_RADIUS;
pub(crate) use parameter::Parameter;
pub(crate) use rule::{RULES, rule};
pub(crate) use spheres::OF_SPHERES;
pub(crate) use steps::continuation_steps;

/// All functions that take numbers, in the order of the paper.
pub(crate) fn all() -> impl Iterator<Item = &'static Function> {
    [hertz::ALL, restitution::ALL, surfaces::ALL, stiffness::ALL, smooth::ALL, smoothing::ALL, ratios::ALL]
        .into_iter()
        .flatten()
}
