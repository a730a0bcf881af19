//! What is wanted of a contact: (11), (B.2) to (B.5), and the modulus for a dimensionless stiffness.

use contact_scaling::equations::symbols::{E, F_N, F_N_EQ, K_HAT, R, X_HAT};
use contact_scaling::{SharedLoad, continuation, design, stiffness};

use super::define::function;
use super::function::Function;
use super::parameter::Returns::{Factor, Value};

pub(super) const ALL: &[Function] = &[
    function!(composite_modulus_for_indentation(relative_indentation: X_HAT, radius: R, load: F, sphere_count: N)
        -> Value(E), "design::composite_modulus",
        design::composite_modulus(radius, relative_indentation, &SharedLoad::new(load, sphere_count)?)?),
    function!(relative_indentation_under_load(composite_modulus: E, radius: R, load: F, sphere_count: N)
        -> Value(X_HAT), "design::relative_indentation",
        design::relative_indentation(composite_modulus, radius, &SharedLoad::new(load, sphere_count)?)?),
    function!(composite_modulus_for_stiffness(stiffness: K, radius: R, relative_indentation: X_HAT)
        -> Value(E), "design::composite_modulus_for_stiffness",
        design::composite_modulus_for_stiffness(stiffness, radius, relative_indentation)?),
    function!(radius_for_stiffness(stiffness: K, relative_indentation: X_HAT, load: F, sphere_count: N)
        -> Value(R), "design::radius_for_stiffness",
        design::radius_for_stiffness(stiffness, relative_indentation, &SharedLoad::new(load, sphere_count)?)?),
    function!(dimensionless_stiffness(stiffness: K, radius: R, load: F_C_ALL, sphere_count: N)
        -> Value(K_HAT), "stiffness::dimensionless",
        stiffness::dimensionless(stiffness, radius, &SharedLoad::new(load, sphere_count)?)?),
    function!(dimensionless_hertz_stiffness(relative_indentation: X_HAT)
        -> Value(K_HAT), "stiffness::dimensionless_hertz",
        stiffness::dimensionless_hertz(relative_indentation)?),
    function!(natural_frequency(stiffness: K, mass_on_sphere: M_ON_SPHERE)
        -> Value(F_N), "stiffness::natural_frequency",
        stiffness::natural_frequency(stiffness, mass_on_sphere)?),
    function!(equilibrium_frequency(relative_indentation: X_HAT_EQ, radius: R, gravity: G)
        -> Value(F_N_EQ), "stiffness::equilibrium_frequency",
        stiffness::equilibrium_frequency(relative_indentation, radius, gravity)?),
    function!(modulus_ratio(first_dimensionless_stiffness: K_HAT_A, second_dimensionless_stiffness: K_HAT_B)
        -> Factor(E), "continuation::modulus_ratio",
        continuation::modulus_ratio(first_dimensionless_stiffness, second_dimensionless_stiffness)?),
];
