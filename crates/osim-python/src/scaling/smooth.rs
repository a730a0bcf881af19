//! The force of `SmoothSphereHalfSpaceForce`: (C.1), (C.3), (C.4), (C.9).

use contact_scaling::equations::symbols::{
    BD, BV, CF, F_CF, F_S, F_SMOOTH, K, S_C, SPEED_STATE, WIDTH, X_HAT_C, X_HAT_T,
};
use contact_scaling::{Hertz, SmoothSphere, SmoothingValues, smoothing};

use crate::scaling::docstring::Returns::Value;
use crate::scaling::function::{Function, function};
use crate::scaling::laws::hertz;

pub(super) const SMOOTH: &[Function] = &[
    function!(constant_indentation_force(
            composite_modulus: E, radius: R, constant_contact_force: CF, indentation: X, shape_factor: ETA = 1.0)
        -> Value(F_CF), "SmoothSphere::constant_indentation_force",
        SmoothSphere::new(hertz(composite_modulus, radius, shape_factor)?, 0.0, SmoothingValues { constant_contact_force, ..UNUSED })?
            .constant_indentation_force(indentation)),
    function!(smooth_elastic_force(
            composite_modulus: E, radius: R, constant_contact_force: CF, hertz_smoothing: BD, indentation: X,
            shape_factor: ETA = 1.0) -> Value(F_S), "SmoothSphere::elastic_force",
        SmoothSphere::new(hertz(composite_modulus, radius, shape_factor)?,
            0.0, SmoothingValues { constant_contact_force, hertz_smoothing, ..UNUSED })?
            .elastic_force(indentation)),
    function!(smooth_elastic_stiffness(
            composite_modulus: E, radius: R, constant_contact_force: CF, hertz_smoothing: BD, indentation: X,
            shape_factor: ETA = 1.0) -> Value(K), "SmoothSphere::stiffness",
        SmoothSphere::new(hertz(composite_modulus, radius, shape_factor)?,
            0.0, SmoothingValues { constant_contact_force, hertz_smoothing, ..UNUSED })?
            .stiffness(indentation)),
    function!(contact_state(hertz_smoothing: BD, indentation: X) -> Value(S_C), "SmoothSphere::contact_state",
        SmoothSphere::new(Hertz::sphere(1.0, 1.0)?, 0.0, SmoothingValues { hertz_smoothing, ..UNUSED })?.contact_state(indentation)),
    function!(smooth_force(
            composite_modulus: E, radius: R, dissipation: ALPHA, constant_contact_force: CF, hertz_smoothing: BD,
            hunt_crossley_smoothing: BV, indentation: X, speed: SPEED, shape_factor: ETA = 1.0)
        -> Value(F_SMOOTH), "SmoothSphere::force",
        SmoothSphere::new(hertz(composite_modulus, radius, shape_factor)?,
            dissipation, SmoothingValues { constant_contact_force, hertz_smoothing, hunt_crossley_smoothing })?
            .force(indentation, speed)),
    function!(speed_state(dissipation: ALPHA, hunt_crossley_smoothing: BV, speed: SPEED)
        -> Value(SPEED_STATE), "SmoothSphere::speed_state",
        SmoothSphere::new(Hertz::sphere(1.0, 1.0)?, dissipation, SmoothingValues { hunt_crossley_smoothing, ..UNUSED })?
            .speed_state(speed)),
    function!(speed_state_at_rest(dissipation: ALPHA, hunt_crossley_smoothing: BV)
        -> Value(SPEED_STATE), "smoothing::speed_state_at_rest",
        smoothing::speed_state_at_rest(dissipation, hunt_crossley_smoothing)?),
    function!(smooth_rest_force(
            composite_modulus: E, radius: R, dissipation: ALPHA, constant_contact_force: CF, hertz_smoothing: BD,
            hunt_crossley_smoothing: BV, indentation: X, shape_factor: ETA = 1.0)
        -> Value(F_SMOOTH), "SmoothSphere::rest_force",
        SmoothSphere::new(hertz(composite_modulus, radius, shape_factor)?,
            dissipation, SmoothingValues { constant_contact_force, hertz_smoothing, hunt_crossley_smoothing })?
            .rest_force(indentation)),
    function!(smooth_rest_stiffness(
            composite_modulus: E, radius: R, dissipation: ALPHA, constant_contact_force: CF, hertz_smoothing: BD,
            hunt_crossley_smoothing: BV, indentation: X, shape_factor: ETA = 1.0)
        -> Value(K), "SmoothSphere::rest_stiffness",
        SmoothSphere::new(hertz(composite_modulus, radius, shape_factor)?,
            dissipation, SmoothingValues { constant_contact_force, hertz_smoothing, hunt_crossley_smoothing })?
            .rest_stiffness(indentation)),
];

/// Smoothing for equations that do not depend on it.
const UNUSED: SmoothingValues =
    SmoothingValues { constant_contact_force: 0.0, hertz_smoothing: 1.0, hunt_crossley_smoothing: 1.0 };

// The smoothing parameters from what is wanted: (C.2), (C.5) to (C.8), (C.10).

pub(super) const SMOOTHING: &[Function] = &[
    function!(constant_contact_force_for_indentation(constant_relative_indentation: X_HAT_C, radius: R)
        -> Value(CF), "smoothing::constant_contact_force",
        smoothing::constant_contact_force(constant_relative_indentation, radius)?),
    function!(constant_relative_indentation(constant_contact_force: CF, radius: R)
        -> Value(X_HAT_C), "smoothing::constant_indentation",
        smoothing::constant_indentation(constant_contact_force, radius)?),
    function!(hertz_smoothing_for_radius(dimensionless_hertz_smoothing: B_X, radius: R)
        -> Value(BD), "smoothing::hertz_smoothing",
        smoothing::hertz_smoothing(dimensionless_hertz_smoothing, radius)?),
    function!(threshold_indentation(threshold: T, hertz_smoothing: BD, radius: R)
        -> Value(X_HAT_T), "smoothing::threshold_indentation",
        smoothing::threshold_indentation(threshold, hertz_smoothing, radius)?),
    function!(transition_width(threshold: T, hertz_smoothing: BD, radius: R)
        -> Value(WIDTH), "smoothing::transition_width",
        smoothing::transition_width(threshold, hertz_smoothing, radius)?),
    function!(hertz_smoothing_for_width(threshold: T, transition_width: WIDTH, radius: R)
        -> Value(BD), "smoothing::hertz_smoothing_for_width",
        smoothing::hertz_smoothing_for_width(threshold, transition_width, radius)?),
    function!(hunt_crossley_smoothing_for_radius(reduced_hunt_crossley_smoothing: B_V, radius: R)
        -> Value(BV), "smoothing::hunt_crossley_smoothing",
        smoothing::hunt_crossley_smoothing(reduced_hunt_crossley_smoothing, radius)?),
    function!(hunt_crossley_smoothing_for_speed_width(threshold: T, speed_width: SPEED_WIDTH)
        -> Value(BV), "smoothing::hunt_crossley_smoothing_for_speed_width",
        smoothing::hunt_crossley_smoothing_for_speed_width(threshold, speed_width)?),
    function!(hunt_crossley_smoothing_for_reduced_width(
            threshold: T, reduced_speed_width: REDUCED_WIDTH, radius: R)
        -> Value(BV), "smoothing::hunt_crossley_smoothing_for_reduced_width",
        smoothing::hunt_crossley_smoothing_for_reduced_width(threshold, reduced_speed_width, radius)?),
];
