//! Rules about a model, which reading it tries: a file for each topic, with the codes of its rules, what raises them, and their texts.
//! Rules that need figures, another model or a change are in the crates above.

mod components;
mod forces;
mod numbers;
pub(crate) mod reading;
mod sides;
mod spheres;

use crate::model::finding::{Finding, Rule};
use crate::model::typed_model::Model;

/// The rules of this crate.
pub const RULES: &[&Rule] = &[
    &numbers::ANGLE_IN_DEGREES,
    &reading::CONNECTEE_BY_NAME,
    &components::CONTACT_DEFAULTS,
    &spheres::CROWDED_SPHERES,
    &forces::DEAD_DERIVATIVE_SMOOTHING,
    &numbers::DEFAULT_STIFFNESS,
    &forces::DISABLED_FORCE,
    &spheres::DOUBLED_SPHERES,
    &components::DUPLICATE_NAMES,
    &components::INCLUDED_FILE,
    &numbers::LARGE_FRICTION,
    &sides::LEFT_RIGHT_CLOSE,
    &sides::LEFT_RIGHT_DIFFER,
    &sides::LEFT_RIGHT_MISSING,
    &sides::LEFT_RIGHT_OFF,
    &sides::LEFT_RIGHT_PLACES,
    &sides::LEFT_RIGHT_SWAPPED,
    &components::LOOP_OF_JOINTS,
    &reading::MASS_SOURCES_DISAGREE,
    &reading::MISNAMED_PARAMETER_SET,
    &reading::MIXED_PAIR,
    &forces::MIXED_RADII,
    &forces::MOCO_DIALECT,
    &numbers::NOT_FINITE,
    &components::NOT_HERTZ,
    &numbers::ODD_NUMBER,
    &spheres::ODD_PLACE,
    &spheres::ODD_RADIUS,
    &sides::ONE_SIDE_ONLY,
    &numbers::OUT_OF_DOMAIN,
    &components::REFUSED_NAME,
    &forces::SEVERAL_PARAMETER_SETS,
    &forces::SEVERAL_SPHERES_ONE_FORCE,
    &forces::SPHERE_IN_TWO_FORCES,
    &forces::TERRAIN,
    &components::UNKNOWN_CLASS,
    &numbers::ZERO_CONSTANT_CONTACT_FORCE,
];

/// Rules that look at a whole model, in the order in which reports list what they find.
const OF_MODELS: [fn(&Model) -> Vec<Finding>; 17] = [
    numbers::find_in_values,
    numbers::find_in_triples,
    numbers::find_angle_in_degrees,
    components::find_included_file,
    forces::find_dead_derivative_smoothing,
    forces::find_several_spheres_one_force,
    forces::find_sphere_in_two_forces,
    numbers::find_default_stiffness,
    numbers::find_zero_constant_contact_force,
    find_on_sides,
    numbers::find_large_friction,
    components::find_contact_defaults,
    forces::find_moco_dialect,
    forces::find_terrain,
    components::find_unknown_class,
    find_in_components,
    components::find_loop_of_joints,
];

/// What all of them find in `model`.
pub(crate) fn find(model: &Model) -> impl Iterator<Item = Finding> {
    OF_MODELS.into_iter().flat_map(|find| find(model))
}

/// What rules say about the two sides of the body, and about the places and sizes of spheres on it.
fn find_on_sides(model: &Model) -> Vec<Finding> {
    let sides = model.both_sides();
    let mut found = sides::find_left_right_differ(&sides);
    found.extend(sides::find_left_right_close(&sides));
    let grouped = [
        sides::find_left_right_places,
        sides::find_left_right_missing,
        sides::find_left_right_off,
        sides::find_one_side_only,
        sides::find_left_right_swapped,
        spheres::find_doubled_spheres,
        spheres::find_crowded_spheres,
    ];
    found.extend(grouped.into_iter().filter_map(|find| find(&sides)));
    found.extend(
        [spheres::find_odd_radius, spheres::find_odd_place]
            .into_iter()
            .filter_map(|find| find(model, &sides)),
    );
    found
}

/// What rules say about each component, in the order of the tree.
fn find_in_components(model: &Model) -> Vec<Finding> {
    let all = model.components().tree.iter();
    all.flat_map(|(id, object)| {
        let found = [
            components::find_not_hertz(model, id),
            components::find_duplicate_name(model, id, object),
            components::find_refused_name(model, id, object),
        ];
        found.into_iter().flatten()
    })
    .collect()
}
