//! The smoothing parameters from what is wanted: (C.2), (C.5) to (C.8), (C.10).

use contact_scaling::equations::symbols::{BD, BV, CF, WIDTH, X_HAT_C, X_HAT_T};
use contact_scaling::smoothing;

use super::define::function;
use super::function::Function;
use super::parameter::Returns::Value;

pub(super) const ALL: &[Function] = &[
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
