//! Moduli of surfaces: appendix A, and what Simbody and Johnson make of two unlike ones.

use contact_scaling::equations::symbols::{ALPHA, E, E_1, R_TWO};
use contact_scaling::modulus::{self, SurfaceValues};

use super::define::function;
use super::function::Function;
use super::parameter::Returns::Value;

pub(super) const ALL: &[Function] = &[
    function!(plane_strain_modulus_of_material(youngs_modulus: YOUNG, poissons_ratio: POISSON)
        -> Value(E_1), "modulus::plane_strain",
        modulus::plane_strain(youngs_modulus, poissons_ratio)?),
    function!(composite_modulus_by_johnson(first_modulus: E_1, second_modulus: E_2)
        -> Value(E), "modulus::composite_johnson",
        modulus::composite_johnson(first_modulus, second_modulus)?),
    function!(composite_modulus_by_sherman(first_modulus: E_1, second_modulus: E_2)
        -> Value(E), "modulus::composite_sherman",
        modulus::composite_sherman(first_modulus, second_modulus)?),
    function!([rule] plane_strain_modulus_of_equal_surfaces(composite_modulus: E)
        -> Value(E_1), "modulus::of_equal_surfaces",
        modulus::of_equal_surfaces(composite_modulus, rule)?),
    function!([rule] composite_modulus_of_equal_surfaces(plane_strain_modulus: E_1)
        -> Value(E), "modulus::composite_of_equal",
        modulus::composite_of_equal(plane_strain_modulus, rule)?),
    function!(stiffness_on_rigid_ground(youngs_modulus: YOUNG, poissons_ratio: POISSON)
        -> Value(E_1), "modulus::stiffness_on_rigid_ground",
        modulus::stiffness_on_rigid_ground(youngs_modulus, poissons_ratio)?),
    function!(mixed_dissipation(
            first_modulus: E_1, first_dissipation: ALPHA_1, second_modulus: E_2, second_dissipation: ALPHA_2)
        -> Value(ALPHA), "modulus::mixed_dissipation",
        modulus::mixed_dissipation(
            SurfaceValues { plane_strain_modulus: first_modulus, dissipation: first_dissipation },
            SurfaceValues { plane_strain_modulus: second_modulus, dissipation: second_dissipation },
        )?),
    function!(composite_radius(first_radius: R_1, second_radius: R_2)
        -> Value(R_TWO), "modulus::composite_radius",
        modulus::composite_radius(first_radius, second_radius)?),
];
