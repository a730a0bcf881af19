//! Python functions for the force laws, restitution, stiffness, moduli of surfaces, factors from one animal to another, and the force of
//! `SmoothSphereHalfSpaceForce`: (C.1), (C.3), (C.4), (C.9).

use contact_scaling::equations::symbols::{
    ALPHA, BD, BV, C_EXACT, C_R, CF, E, E_1, F_C, F_CF, F_D, F_E, F_N, F_N_EQ, F_S, F_SMOOTH, IMPACT, K,
    K_HAT, PATCH_DIAMETER, PATCH_RADIUS, R, R_TWO, RELATIVE_PATCH_RADIUS, S_C, SIGMA, SPEED_STATE, U_V, V_T,
    WIDTH, X, X_HAT, X_HAT_C, X_HAT_T,
};
use contact_scaling::modulus::{self, SurfaceValues};
use contact_scaling::{
    DomainError, Hertz, HertzValues, HuntCrossley, RatioValues, Ratios, SharedLoad, SmoothSphere,
    SmoothingValues, continuation, design, patch, restitution, smoothing, stiffness,
};

use crate::scaling::function::Returns::{Factor, Value};
use crate::scaling::function::{Function, function};

pub(super) const HERTZ: &[Function] = &[
    function!(hertz_force(composite_modulus: E, radius: R, indentation: X, shape_factor: ETA = 1.0)
        -> Value(F_E), "Hertz::force",
        hertz(composite_modulus, radius, shape_factor)?.force(indentation)),
    function!(hertz_indentation(composite_modulus: E, radius: R, force: F_E, shape_factor: ETA = 1.0)
        -> Value(X), "Hertz::indentation_from_force",
        hertz(composite_modulus, radius, shape_factor)?.indentation_from_force(force)?),
    function!(relative_indentation(indentation: X, radius: R) -> Value(X_HAT), "Hertz::relative_indentation",
        Hertz::sphere(1.0, radius)?.relative_indentation(indentation)),
    function!(indentation(relative_indentation: X_HAT, radius: R) -> Value(X), "Hertz::indentation",
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
        -> Value(SIGMA), patch::mean_stress),
    function!(patch_radius(indentation: X, radius: R) -> Value(PATCH_RADIUS), patch::radius),
    function!(patch_diameter(indentation: X, radius: R) -> Value(PATCH_DIAMETER), patch::diameter),
    function!(relative_patch_radius(relative_indentation: X_HAT)
        -> Value(RELATIVE_PATCH_RADIUS), patch::relative_radius),
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

// Restitution and dissipation: (13), its exact form, and the speed of the paper's drop.

pub(super) const RESTITUTION: &[Function] = &[
    function!(approximate_restitution(dissipation: ALPHA, impact_speed: IMPACT)
        -> Value(C_R), restitution::approximate),
    function!(dissipation_for_restitution(restitution: C_R, impact_speed: IMPACT)
        -> Value(ALPHA), restitution::dissipation),
    function!(exact_restitution(dissipation: ALPHA, impact_speed: IMPACT)
        -> Value(C_EXACT), restitution::exact),
    function!(dissipation_for_exact_restitution(restitution: C_EXACT, impact_speed: IMPACT)
        -> Value(ALPHA), restitution::exact_dissipation),
    function!(drop_speed(gravity: G, radius: R) -> Value(IMPACT), restitution::drop_speed),
];

// What is wanted of a contact: (11), (B.2) to (B.5), and the modulus for a dimensionless stiffness.

pub(super) const STIFFNESS: &[Function] = &[
    function!(composite_modulus_for_indentation(relative_indentation: X_HAT, radius: R, load: F, sphere_count: N)
        -> Value(E), "design::composite_modulus",
        design::composite_modulus(radius, relative_indentation, &SharedLoad::new(load, sphere_count)?)?),
    function!(relative_indentation_under_load(composite_modulus: E, radius: R, load: F, sphere_count: N)
        -> Value(X_HAT), "design::relative_indentation",
        design::relative_indentation(composite_modulus, radius, &SharedLoad::new(load, sphere_count)?)?),
    function!(composite_modulus_for_stiffness(stiffness: K, radius: R, relative_indentation: X_HAT)
        -> Value(E), design::composite_modulus_for_stiffness),
    function!(radius_for_stiffness(stiffness: K, relative_indentation: X_HAT, load: F, sphere_count: N)
        -> Value(R), "design::radius_for_stiffness",
        design::radius_for_stiffness(stiffness, relative_indentation, &SharedLoad::new(load, sphere_count)?)?),
    function!(dimensionless_stiffness(stiffness: K, radius: R, load: F_C_ALL, sphere_count: N)
        -> Value(K_HAT), "stiffness::dimensionless",
        stiffness::dimensionless(stiffness, radius, &SharedLoad::new(load, sphere_count)?)?),
    function!(dimensionless_hertz_stiffness(relative_indentation: X_HAT)
        -> Value(K_HAT), stiffness::dimensionless_hertz),
    function!(natural_frequency(stiffness: K, mass_on_sphere: M_ON_SPHERE)
        -> Value(F_N), stiffness::natural_frequency),
    function!(equilibrium_frequency(relative_indentation: X_HAT_EQ, radius: R, gravity: G)
        -> Value(F_N_EQ), stiffness::equilibrium_frequency),
    function!(modulus_ratio(first_dimensionless_stiffness: K_HAT_A, second_dimensionless_stiffness: K_HAT_B)
        -> Factor(E), continuation::modulus_ratio),
];

// Moduli of surfaces: appendix A, and what Simbody and Johnson make of two unlike ones.

pub(super) const SURFACES: &[Function] = &[
    function!(plane_strain_modulus_of_material(youngs_modulus: YOUNG, poissons_ratio: POISSON)
        -> Value(E_1), modulus::plane_strain),
    function!(composite_modulus_by_johnson(first_modulus: E_1, second_modulus: E_2)
        -> Value(E), modulus::composite_johnson),
    function!(composite_modulus_by_sherman(first_modulus: E_1, second_modulus: E_2)
        -> Value(E), modulus::composite_sherman),
    function!([rule] plane_strain_modulus_of_equal_surfaces(composite_modulus: E)
        -> Value(E_1), "modulus::of_equal_surfaces",
        modulus::of_equal_surfaces(composite_modulus, rule)?),
    function!([rule] composite_modulus_of_equal_surfaces(plane_strain_modulus: E_1)
        -> Value(E), "modulus::composite_of_equal",
        modulus::composite_of_equal(plane_strain_modulus, rule)?),
    function!(stiffness_on_rigid_ground(youngs_modulus: YOUNG, poissons_ratio: POISSON)
        -> Value(E_1), modulus::stiffness_on_rigid_ground),
    function!(mixed_dissipation(
            first_modulus: E_1, first_dissipation: ALPHA_1, second_modulus: E_2, second_dissipation: ALPHA_2)
        -> Value(ALPHA), "modulus::mixed_dissipation",
        modulus::mixed_dissipation(
            SurfaceValues { plane_strain_modulus: first_modulus, dissipation: first_dissipation },
            SurfaceValues { plane_strain_modulus: second_modulus, dissipation: second_dissipation },
        )?),
    function!(composite_radius(first_radius: R_1, second_radius: R_2)
        -> Value(R_TWO), modulus::composite_radius),
];

// The factors of OpenSim's properties from one animal to another: (8) to (10), (14), (C.2), (C.5), (C.10), friction.

pub(super) const RATIOS: &[Function] = &[
    function!(plane_strain_modulus(
            mass_ratio: MASS_RATIO, sphere_count_ratio: SPHERE_COUNT_RATIO, radius_ratio: RADIUS_RATIO,
            gravity_ratio: GRAVITY_RATIO = 1.0) -> Factor(E), "Ratios::plane_strain_modulus",
        Ratios::new(RatioValues {
            mass: mass_ratio,
            sphere_count: sphere_count_ratio,
            radius: radius_ratio,
            gravity: gravity_ratio,
        })?
        .plane_strain_modulus()),
    function!(dissipation(radius_ratio: RADIUS_RATIO, gravity_ratio: GRAVITY_RATIO = 1.0)
        -> Factor(ALPHA), "Ratios::dissipation",
        size_ratios(radius_ratio, gravity_ratio)?.dissipation()),
    function!(dissipation_by_mass(mass_ratio: MASS_RATIO, gravity_ratio: GRAVITY_RATIO = 1.0)
        -> Factor(ALPHA), "Ratios::dissipation_by_mass",
        Ratios::new(RatioValues { mass: mass_ratio, gravity: gravity_ratio, ..Ratios::identity().values() })?
            .dissipation_by_mass()),
    function!(constant_contact_force(radius_ratio: RADIUS_RATIO)
        -> Factor(CF), "Ratios::constant_contact_force",
        size_ratios(radius_ratio, 1.0)?.constant_contact_force()),
    function!(hertz_smoothing(radius_ratio: RADIUS_RATIO) -> Factor(BD), "Ratios::hertz_smoothing",
        size_ratios(radius_ratio, 1.0)?.hertz_smoothing()),
    function!(hunt_crossley_smoothing(radius_ratio: RADIUS_RATIO, gravity_ratio: GRAVITY_RATIO = 1.0)
        -> Factor(BV), "Ratios::hunt_crossley_smoothing",
        size_ratios(radius_ratio, gravity_ratio)?.hunt_crossley_smoothing()),
    function!(transition_velocity(radius_ratio: RADIUS_RATIO, gravity_ratio: GRAVITY_RATIO = 1.0)
        -> Factor(V_T), "Ratios::transition_velocity",
        size_ratios(radius_ratio, gravity_ratio)?.transition_velocity()),
    function!(viscous_friction(radius_ratio: RADIUS_RATIO, gravity_ratio: GRAVITY_RATIO = 1.0)
        -> Factor(U_V), "Ratios::viscous_friction",
        size_ratios(radius_ratio, gravity_ratio)?.viscous_friction()),
];

/// Factors from one animal to another that differ only in size and gravity.
fn size_ratios(radius: f64, gravity: f64) -> Result<Ratios, DomainError> {
    Ratios::new(RatioValues { radius, gravity, ..Ratios::identity().values() })
}

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
        -> Value(SPEED_STATE), smoothing::speed_state_at_rest),
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
        -> Value(CF), smoothing::constant_contact_force),
    function!(constant_relative_indentation(constant_contact_force: CF, radius: R)
        -> Value(X_HAT_C), smoothing::constant_indentation),
    function!(hertz_smoothing_for_radius(dimensionless_hertz_smoothing: B_X, radius: R)
        -> Value(BD), smoothing::hertz_smoothing),
    function!(threshold_indentation(threshold: T, hertz_smoothing: BD, radius: R)
        -> Value(X_HAT_T), smoothing::threshold_indentation),
    function!(transition_width(threshold: T, hertz_smoothing: BD, radius: R)
        -> Value(WIDTH), smoothing::transition_width),
    function!(hertz_smoothing_for_width(threshold: T, transition_width: WIDTH, radius: R)
        -> Value(BD), smoothing::hertz_smoothing_for_width),
    function!(hunt_crossley_smoothing_for_radius(reduced_hunt_crossley_smoothing: B_V, radius: R)
        -> Value(BV), smoothing::hunt_crossley_smoothing),
    function!(hunt_crossley_smoothing_for_speed_width(threshold: T, speed_width: SPEED_WIDTH)
        -> Value(BV), smoothing::hunt_crossley_smoothing_for_speed_width),
    function!(hunt_crossley_smoothing_for_reduced_width(
            threshold: T, reduced_speed_width: REDUCED_WIDTH, radius: R)
        -> Value(BV), smoothing::hunt_crossley_smoothing_for_reduced_width),
];
