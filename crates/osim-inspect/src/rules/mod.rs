//! Rules about what contacts do: a file for each topic. Four rules about models and one about places have no more than their remedy
//! here: it is a request, which the crates that raise them do not know.

pub(crate) mod contacts;
pub(crate) mod depth;
pub(crate) mod floors;
pub(crate) mod gravity;
mod limits;
pub(crate) mod places;
pub(crate) mod sides;
pub(crate) mod smoothing;
pub(crate) mod standing;

use osim_model::{Finding, Model, Rule};

use crate::findings::Found;
use crate::floors::Floors;
pub use contacts::unmatched_patterns;
pub(crate) use limits::Limits;
pub use places::misplaced_spheres;

/// The rules of this crate.
pub const RULES: &[&Rule] = &[
    &contacts::BARE_MODEL,
    &depth::BEYOND_HERTZ,
    &depth::BEYOND_HERTZ_AT_TWO,
    &smoothing::BEYOND_HUNT_CROSSLEY,
    &contacts::CONTACTS_OF_ANOTHER_MASS,
    &smoothing::FLOATS,
    &floors::FLOOR_ON_LIMB,
    &floors::FLOOR_SLOPES,
    &floors::FLOOR_UPRIGHT,
    &floors::FLOOR_UPSIDE_DOWN,
    &smoothing::FORCE_BEFORE_CONTACT,
    &gravity::GRAVITY_NOT_DOWN,
    &gravity::GRAVITY_SOURCES_DISAGREE,
    &gravity::GRAVITY_TOO_LARGE,
    &contacts::KNOWN_CONTACTS,
    &smoothing::LARGE_CONSTANT_INDENTATION,
    &contacts::MASS_UNKNOWN,
    &gravity::NO_GRAVITY,
    &standing::NOT_ON_FLOOR,
    &contacts::COUNT_UNKNOWN,
    &contacts::STALE_NOTE,
    &depth::SUNK_IN,
    &standing::UNEVEN_BOTTOMS,
    &standing::UNLEVEL_FOOT,
    &contacts::UNMATCHED_PATTERN,
    &smoothing::WIDE_TRANSITION,
];

/// What is wrong with the floors that spheres press on, and with gravity towards them.
pub(crate) fn of_floors(model: &Model, floors: &Floors) -> Vec<Finding> {
    let of_gravity = [gravity::find_too_large(model), gravity::find_not_down(model, floors)];
    let of_planes = [
        floors::find_upside_down(floors),
        floors::find_upright(floors),
        floors::find_on_limb(floors),
        floors::find_slopes(floors),
    ];
    of_gravity.into_iter().flatten().chain(of_planes.into_iter().flatten()).collect()
}

/// Everything that figures show.
pub(crate) fn of_figures(limits: &Limits<'_>) -> Vec<Found> {
    let found = [
        depth::find_sunk_in(limits),
        depth::find_beyond_hertz(limits),
        depth::find_beyond_hertz_at_two(limits),
        smoothing::find_beyond_hunt_crossley(limits),
        smoothing::find_large_constant_indentation(limits),
        smoothing::find_wide_transition(limits),
        smoothing::find_force_before_contact(limits),
        smoothing::find_floats(limits),
        standing::find_uneven_bottoms(limits),
        standing::find_unlevel_foot(limits),
    ];
    found.into_iter().flatten().chain(standing::find_not_on_floor(limits)).collect()
}
