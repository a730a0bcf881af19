//! The force of `SmoothSphereHalfSpaceForce`: (C.1), (C.3), (C.4), (C.9).

use contact_scaling::equations::symbols::{F_CF, F_S, F_SMOOTH, K, S_C, SPEED_STATE};
use contact_scaling::{DomainError, Hertz, SmoothSphere, SmoothingValues, smoothing};

use super::define::function;
use super::function::Function;
use super::hertz::hertz;
use super::parameter::Returns::Value;

pub(super) const ALL: &[Function] = &[
    function!(constant_indentation_force(
            composite_modulus: E, radius: R, constant_contact_force: CF, indentation: X, shape_factor: ETA = 1.0)
        -> Value(F_CF), "SmoothSphere::constant_indentation_force",
        law(hertz(composite_modulus, radius, shape_factor)?, Smooth { constant_contact_force, ..Smooth::ANY })?
            .constant_indentation_force(indentation)),
    function!(smooth_elastic_force(
            composite_modulus: E, radius: R, constant_contact_force: CF, hertz_smoothing: BD, indentation: X,
            shape_factor: ETA = 1.0)
        -> Value(F_S), "SmoothSphere::elastic_force",
        law(hertz(composite_modulus, radius, shape_factor)?,
            Smooth { constant_contact_force, hertz_smoothing, ..Smooth::ANY })?
            .elastic_force(indentation)),
    function!(smooth_elastic_stiffness(
            composite_modulus: E, radius: R, constant_contact_force: CF, hertz_smoothing: BD, indentation: X,
            shape_factor: ETA = 1.0)
        -> Value(K), "SmoothSphere::stiffness",
        law(hertz(composite_modulus, radius, shape_factor)?,
            Smooth { constant_contact_force, hertz_smoothing, ..Smooth::ANY })?
            .stiffness(indentation)),
    function!(contact_state(hertz_smoothing: BD, indentation: X)
        -> Value(S_C), "SmoothSphere::contact_state",
        law(Hertz::sphere(1.0, 1.0)?, Smooth { hertz_smoothing, ..Smooth::ANY })?.contact_state(indentation)),
    function!(smooth_force(
            composite_modulus: E, radius: R, dissipation: ALPHA, constant_contact_force: CF, hertz_smoothing: BD,
            hunt_crossley_smoothing: BV, indentation: X, speed: SPEED, shape_factor: ETA = 1.0)
        -> Value(F_SMOOTH), "SmoothSphere::force",
        law(hertz(composite_modulus, radius, shape_factor)?,
            Smooth { dissipation, constant_contact_force, hertz_smoothing, hunt_crossley_smoothing })?
            .force(indentation, speed)),
    function!(speed_state(dissipation: ALPHA, hunt_crossley_smoothing: BV, speed: SPEED)
        -> Value(SPEED_STATE), "SmoothSphere::speed_state",
        law(Hertz::sphere(1.0, 1.0)?, Smooth { dissipation, hunt_crossley_smoothing, ..Smooth::ANY })?
            .speed_state(speed)),
    function!(speed_state_at_rest(dissipation: ALPHA, hunt_crossley_smoothing: BV)
        -> Value(SPEED_STATE), "smoothing::speed_state_at_rest",
        smoothing::speed_state_at_rest(dissipation, hunt_crossley_smoothing)?),
    function!(smooth_rest_force(
            composite_modulus: E, radius: R, dissipation: ALPHA, constant_contact_force: CF, hertz_smoothing: BD,
            hunt_crossley_smoothing: BV, indentation: X, shape_factor: ETA = 1.0)
        -> Value(F_SMOOTH), "SmoothSphere::rest_force",
        law(hertz(composite_modulus, radius, shape_factor)?,
            Smooth { dissipation, constant_contact_force, hertz_smoothing, hunt_crossley_smoothing })?
            .rest_force(indentation)),
    function!(smooth_rest_stiffness(
            composite_modulus: E, radius: R, dissipation: ALPHA, constant_contact_force: CF, hertz_smoothing: BD,
            hunt_crossley_smoothing: BV, indentation: X, shape_factor: ETA = 1.0)
        -> Value(K), "SmoothSphere::rest_stiffness",
        law(hertz(composite_modulus, radius, shape_factor)?,
            Smooth { dissipation, constant_contact_force, hertz_smoothing, hunt_crossley_smoothing })?
            .rest_stiffness(indentation)),
];

/// What a smoothed law has beside the Hertz law, as OpenSim spells it.
#[derive(Clone, Copy)]
struct Smooth {
    /// α, in s/m.
    dissipation: f64,
    /// cf, in m².
    constant_contact_force: f64,
    /// bd, in 1/m.
    hertz_smoothing: f64,
    /// bv, in s/m.
    hunt_crossley_smoothing: f64,
}

impl Smooth {
    /// For what an equation does not depend on.
    const ANY: Self = Self {
        dissipation: 0.0,
        constant_contact_force: 0.0,
        hertz_smoothing: 1.0,
        hunt_crossley_smoothing: 1.0,
    };
}

fn law(hertz: Hertz, smooth: Smooth) -> Result<SmoothSphere, DomainError> {
    let Smooth { dissipation, constant_contact_force, hertz_smoothing, hunt_crossley_smoothing } = smooth;
    let smoothing = SmoothingValues { constant_contact_force, hertz_smoothing, hunt_crossley_smoothing };
    SmoothSphere::new(hertz, dissipation, smoothing)
}
