//! The force laws: (1) to (3), (12), (15), the contact patch, and the stiffness (B.1), (B.2).

use contact_scaling::equations::symbols::{
    F_C, F_D, F_E, K, PATCH_DIAMETER, PATCH_RADIUS, RELATIVE_PATCH_RADIUS, SIGMA, X, X_HAT,
};
use contact_scaling::{DomainError, Hertz, HertzValues, HuntCrossley, patch};

use super::define::function;
use super::function::Function;
use super::parameter::Returns::Value;

pub(super) const ALL: &[Function] = &[
    function!(hertz_force(composite_modulus: E, radius: R, indentation: X, shape_factor: ETA = 1.0)
        -> Value(F_E), "Hertz::force",
        hertz(composite_modulus, radius, shape_factor)?.force(indentation)),
    function!(hertz_indentation(composite_modulus: E, radius: R, force: F_E, shape_factor: ETA = 1.0)
        -> Value(X), "Hertz::indentation_from_force",
        hertz(composite_modulus, radius, shape_factor)?.indentation_from_force(force)?),
    function!(relative_indentation(indentation: X, radius: R)
        -> Value(X_HAT), "Hertz::relative_indentation",
        Hertz::sphere(1.0, radius)?.relative_indentation(indentation)),
    function!(indentation(relative_indentation: X_HAT, radius: R)
        -> Value(X), "Hertz::indentation",
        Hertz::sphere(1.0, radius)?.indentation(relative_indentation)),
    function!(hertz_force_at_relative_indentation(
            composite_modulus: E, radius: R, relative_indentation: X_HAT, shape_factor: ETA = 1.0)
        -> Value(F_E), "Hertz::force_at_relative_indentation",
        hertz(composite_modulus, radius, shape_factor)?.force_at_relative_indentation(relative_indentation)),
    function!(hunt_crossley_dissipative_force(
            composite_modulus: E, radius: R, dissipation: ALPHA, indentation: X, speed: SPEED, shape_factor: ETA = 1.0)
        -> Value(F_D), "HuntCrossley::dissipative_force",
        hunt_crossley(composite_modulus, radius, shape_factor, dissipation)?.dissipative_force(indentation, speed)),
    function!(hunt_crossley_force(
            composite_modulus: E, radius: R, dissipation: ALPHA, indentation: X, speed: SPEED, shape_factor: ETA = 1.0)
        -> Value(F_C), "HuntCrossley::force",
        hunt_crossley(composite_modulus, radius, shape_factor, dissipation)?.force(indentation, speed)),
    function!(mean_stress(force: F_C, radius: R, relative_indentation: X_HAT)
        -> Value(SIGMA), "patch::mean_stress",
        patch::mean_stress(force, radius, relative_indentation)?),
    function!(patch_radius(indentation: X, radius: R)
        -> Value(PATCH_RADIUS), "patch::radius",
        patch::radius(indentation, radius)?),
    function!(patch_diameter(indentation: X, radius: R)
        -> Value(PATCH_DIAMETER), "patch::diameter",
        patch::diameter(indentation, radius)?),
    function!(relative_patch_radius(relative_indentation: X_HAT)
        -> Value(RELATIVE_PATCH_RADIUS), "patch::relative_radius",
        patch::relative_radius(relative_indentation)?),
    function!(hertz_stiffness(composite_modulus: E, radius: R, indentation: X, shape_factor: ETA = 1.0)
        -> Value(K), "Hertz::stiffness",
        hertz(composite_modulus, radius, shape_factor)?.stiffness(indentation)),
    function!(hertz_stiffness_at_relative_indentation(
            composite_modulus: E, radius: R, relative_indentation: X_HAT, shape_factor: ETA = 1.0)
        -> Value(K), "Hertz::stiffness_at_relative_indentation",
        hertz(composite_modulus, radius, shape_factor)?.stiffness_at_relative_indentation(relative_indentation)),
];

/// The Hertz law of a sphere: E* in N/m², R in m, η.
pub(super) fn hertz(composite_modulus: f64, radius_m: f64, shape_factor: f64) -> Result<Hertz, DomainError> {
    Hertz::new(HertzValues { composite_modulus, radius_m, shape_factor })
}

fn hunt_crossley(
    composite_modulus: f64,
    radius_m: f64,
    shape_factor: f64,
    dissipation: f64,
) -> Result<HuntCrossley, DomainError> {
    HuntCrossley::new(hertz(composite_modulus, radius_m, shape_factor)?, dissipation)
}
