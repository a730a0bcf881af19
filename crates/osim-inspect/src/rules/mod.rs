//! Rules about what contacts do: a file for each. Four rules about models and one about places have no more than their remedy here: it
//! is a request, which the crates that raise them do not know.

pub(crate) mod bare_model;
pub(crate) mod beyond_hertz;
pub(crate) mod beyond_hertz_at_two;
pub(crate) mod beyond_hunt_crossley;
pub(crate) mod contacts_of_another_mass;
pub(crate) mod default_stiffness;
pub(crate) mod floats;
pub(crate) mod floor_on_limb;
pub(crate) mod floor_slopes;
pub(crate) mod floor_upright;
pub(crate) mod floor_upside_down;
pub(crate) mod force_before_contact;
pub(crate) mod gravity_not_down;
pub(crate) mod gravity_sources_disagree;
pub(crate) mod gravity_too_large;
pub(crate) mod known_contacts;
pub(crate) mod large_constant_indentation;
pub(crate) mod left_right_differ;
mod limits;
mod many_limbs;
pub(crate) mod mass_unknown;
pub(crate) mod moco_dialect;
pub(crate) mod no_gravity;
pub(crate) mod not_on_floor;
pub(crate) mod sphere_count_unknown;
pub(crate) mod spheres_left_behind;
pub(crate) mod stale_note;
pub(crate) mod sunk_in;
mod turned_floors;
pub(crate) mod uneven_bottoms;
pub(crate) mod unlevel_foot;
pub(crate) mod unmatched_pattern;
pub(crate) mod wide_transition;
pub(crate) mod zero_constant_contact_force;

pub(crate) use limits::Limits;
pub use unmatched_pattern::unmatched_patterns;

use osim_model::{Finding, Model, Rule};

use crate::findings::Found;
use crate::floors::Floors;

/// The rules of this crate.
pub const RULES: &[&Rule] = &[
    &bare_model::RULE,
    &beyond_hertz::RULE,
    &beyond_hertz_at_two::RULE,
    &beyond_hunt_crossley::RULE,
    &contacts_of_another_mass::RULE,
    &floats::RULE,
    &floor_on_limb::RULE,
    &floor_slopes::RULE,
    &floor_upright::RULE,
    &floor_upside_down::RULE,
    &force_before_contact::RULE,
    &gravity_not_down::RULE,
    &gravity_sources_disagree::RULE,
    &gravity_too_large::RULE,
    &known_contacts::RULE,
    &large_constant_indentation::RULE,
    &mass_unknown::RULE,
    &no_gravity::RULE,
    &not_on_floor::RULE,
    &sphere_count_unknown::RULE,
    &stale_note::RULE,
    &sunk_in::RULE,
    &uneven_bottoms::RULE,
    &unlevel_foot::RULE,
    &unmatched_pattern::RULE,
    &wide_transition::RULE,
];

/// What is wrong with the floors that spheres press on, and with gravity towards them.
pub(crate) fn of_floors(model: &Model, floors: &Floors) -> Vec<Finding> {
    let of_gravity = [gravity_too_large::find(model), gravity_not_down::find(model, floors)];
    let of_planes = [
        floor_upside_down::find(floors),
        floor_upright::find(floors),
        floor_on_limb::find(floors),
        floor_slopes::find(floors),
    ];
    of_gravity.into_iter().flatten().chain(of_planes.into_iter().flatten()).collect()
}

/// Everything that figures show.
pub(crate) fn of_figures(limits: &Limits<'_>) -> Vec<Found> {
    let found = [
        sunk_in::find(limits),
        beyond_hertz::find(limits),
        beyond_hertz_at_two::find(limits),
        beyond_hunt_crossley::find(limits),
        large_constant_indentation::find(limits),
        wide_transition::find(limits),
        force_before_contact::find(limits),
        floats::find(limits),
        uneven_bottoms::find(limits),
        unlevel_foot::find(limits),
    ];
    found.into_iter().flatten().chain(not_on_floor::find(limits)).collect()
}
