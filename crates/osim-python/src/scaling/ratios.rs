//! The factors of OpenSim's properties from one animal to another: (8) to (10), (14), (C.2), (C.5), (C.10), friction.

use contact_scaling::equations::symbols::{ALPHA, BD, BV, CF, E, U_V, V_T};
use contact_scaling::{DomainError, RatioValues, Ratios};

use super::define::function;
use super::function::Function;
use super::parameter::Returns::Factor;

pub(super) const ALL: &[Function] = &[
    function!(plane_strain_modulus(
            mass_ratio: MASS_RATIO, sphere_count_ratio: SPHERE_COUNT_RATIO, radius_ratio: RADIUS_RATIO,
            gravity_ratio: GRAVITY_RATIO = 1.0)
        -> Factor(E), "Ratios::plane_strain_modulus",
        Ratios::new(RatioValues {
            mass: mass_ratio,
            sphere_count: sphere_count_ratio,
            radius: radius_ratio,
            gravity: gravity_ratio,
        })?
        .plane_strain_modulus()),
    function!(dissipation(radius_ratio: RADIUS_RATIO, gravity_ratio: GRAVITY_RATIO = 1.0)
        -> Factor(ALPHA), "Ratios::dissipation",
        of_size(radius_ratio, gravity_ratio)?.dissipation()),
    function!(dissipation_by_mass(mass_ratio: MASS_RATIO, gravity_ratio: GRAVITY_RATIO = 1.0)
        -> Factor(ALPHA), "Ratios::dissipation_by_mass",
        Ratios::new(RatioValues { mass: mass_ratio, gravity: gravity_ratio, ..Ratios::identity().values() })?
            .dissipation_by_mass()),
    function!(constant_contact_force(radius_ratio: RADIUS_RATIO)
        -> Factor(CF), "Ratios::constant_contact_force",
        of_size(radius_ratio, 1.0)?.constant_contact_force()),
    function!(hertz_smoothing(radius_ratio: RADIUS_RATIO)
        -> Factor(BD), "Ratios::hertz_smoothing",
        of_size(radius_ratio, 1.0)?.hertz_smoothing()),
    function!(hunt_crossley_smoothing(radius_ratio: RADIUS_RATIO, gravity_ratio: GRAVITY_RATIO = 1.0)
        -> Factor(BV), "Ratios::hunt_crossley_smoothing",
        of_size(radius_ratio, gravity_ratio)?.hunt_crossley_smoothing()),
    function!(transition_velocity(radius_ratio: RADIUS_RATIO, gravity_ratio: GRAVITY_RATIO = 1.0)
        -> Factor(V_T), "Ratios::transition_velocity",
        of_size(radius_ratio, gravity_ratio)?.transition_velocity()),
    function!(viscous_friction(radius_ratio: RADIUS_RATIO, gravity_ratio: GRAVITY_RATIO = 1.0)
        -> Factor(U_V), "Ratios::viscous_friction",
        of_size(radius_ratio, gravity_ratio)?.viscous_friction()),
];

/// Ratios in which only size and gravity matter.
fn of_size(radius: f64, gravity: f64) -> Result<Ratios, DomainError> {
    Ratios::new(RatioValues { radius, gravity, ..Ratios::identity().values() })
}
