//! Rules about a model, which reading it tries: a file for each, with its code, what raises it, and its texts. Rules that need figures,
//! another model or a change are in the crates above.

pub(crate) mod angle_in_degrees;
pub(crate) mod connectee_by_name;
pub(crate) mod contact_defaults;
pub(crate) mod crowded_spheres;
pub(crate) mod dead_derivative_smoothing;
pub(crate) mod default_stiffness;
pub(crate) mod disabled_force;
pub(crate) mod doubled_spheres;
pub(crate) mod duplicate_names;
pub(crate) mod included_file;
pub(crate) mod large_friction;
pub(crate) mod left_right_close;
pub(crate) mod left_right_differ;
pub(crate) mod left_right_missing;
pub(crate) mod left_right_off;
pub(crate) mod left_right_places;
pub(crate) mod left_right_swapped;
pub(crate) mod loop_of_joints;
pub(crate) mod mass_sources_disagree;
pub(crate) mod misnamed_parameter_set;
pub(crate) mod mixed_pair;
pub(crate) mod mixed_radii;
pub(crate) mod moco_dialect;
pub(crate) mod not_finite;
pub(crate) mod not_hertz;
pub(crate) mod odd_number;
pub(crate) mod odd_place;
pub(crate) mod odd_radius;
pub(crate) mod one_side_only;
pub(crate) mod out_of_domain;
pub(crate) mod refused_name;
mod remarks;
pub(crate) mod several_parameter_sets;
pub(crate) mod several_spheres_one_force;
pub(crate) mod sphere_in_two_forces;
pub(crate) mod terrain;
pub(crate) mod unknown_class;
mod values;
pub(crate) mod zero_constant_contact_force;

use crate::model::finding::{Finding, Rule};
use crate::model::typed_model::Model;

/// The rules of this crate.
pub const RULES: &[&Rule] = &[
    &angle_in_degrees::RULE,
    &connectee_by_name::RULE,
    &contact_defaults::RULE,
    &crowded_spheres::RULE,
    &dead_derivative_smoothing::RULE,
    &default_stiffness::RULE,
    &disabled_force::RULE,
    &doubled_spheres::RULE,
    &duplicate_names::RULE,
    &included_file::RULE,
    &large_friction::RULE,
    &left_right_close::RULE,
    &left_right_differ::RULE,
    &left_right_missing::RULE,
    &left_right_off::RULE,
    &left_right_places::RULE,
    &left_right_swapped::RULE,
    &loop_of_joints::RULE,
    &mass_sources_disagree::RULE,
    &misnamed_parameter_set::RULE,
    &mixed_pair::RULE,
    &mixed_radii::RULE,
    &moco_dialect::RULE,
    &not_finite::RULE,
    &not_hertz::RULE,
    &odd_number::RULE,
    &odd_place::RULE,
    &odd_radius::RULE,
    &one_side_only::RULE,
    &out_of_domain::RULE,
    &refused_name::RULE,
    &several_parameter_sets::RULE,
    &several_spheres_one_force::RULE,
    &sphere_in_two_forces::RULE,
    &terrain::RULE,
    &unknown_class::RULE,
    &zero_constant_contact_force::RULE,
];

/// Rules that look at a whole model, in the order in which reports list what they find.
const OF_MODELS: [(Looks, Find); 17] = [
    (Looks::AtNumbers, values::numbers),
    (Looks::Elsewhere, values::triples),
    (Looks::Elsewhere, angle_in_degrees::find),
    (Looks::Elsewhere, included_file::find),
    (Looks::Elsewhere, dead_derivative_smoothing::find),
    (Looks::Elsewhere, several_spheres_one_force::find),
    (Looks::Elsewhere, sphere_in_two_forces::find),
    (Looks::AtNumbers, default_stiffness::find),
    (Looks::AtNumbers, zero_constant_contact_force::find),
    (Looks::AtNumbers, both_sides),
    (Looks::AtNumbers, large_friction::find),
    (Looks::Elsewhere, contact_defaults::find),
    (Looks::Elsewhere, moco_dialect::find),
    (Looks::Elsewhere, terrain::find),
    (Looks::Elsewhere, unknown_class::find),
    (Looks::Elsewhere, components),
    (Looks::Elsewhere, loop_of_joints::find),
];

type Find = fn(&Model) -> Vec<Finding>;

/// Where a rule looks.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Looks {
    /// At radii of spheres or parameters of forces, among others.
    AtNumbers,
    /// At neither: in a model with other such numbers it finds the same.
    Elsewhere,
}

/// What each rule finds in `model`.
pub(crate) fn find(model: &Model) -> Vec<Vec<Finding>> {
    OF_MODELS.into_iter().map(|(_, find)| find(model)).collect()
}

/// The same in a model that differs in numbers of its contacts alone from the one in which they found `before`.
pub(crate) fn find_again<'f>(
    model: &Model,
    before: impl Iterator<Item = &'f [Finding]>,
) -> Vec<Vec<Finding>> {
    let again = |((looks, find), before): ((Looks, Find), &[Finding])| match looks {
        Looks::AtNumbers => find(model),
        Looks::Elsewhere => before.to_vec(),
    };
    OF_MODELS.into_iter().zip(before).map(again).collect()
}

/// What rules say about the two sides of the body, and about the places and sizes of spheres on it.
fn both_sides(model: &Model) -> Vec<Finding> {
    let sides = model.both_sides();
    let mut found = left_right_differ::find(&sides);
    found.extend(left_right_close::find(&sides));
    let grouped = [
        left_right_places::find,
        left_right_missing::find,
        left_right_off::find,
        one_side_only::find,
        left_right_swapped::find,
        doubled_spheres::find,
        crowded_spheres::find,
    ];
    found.extend(grouped.into_iter().filter_map(|find| find(&sides)));
    found.extend([odd_radius::find, odd_place::find].into_iter().filter_map(|find| find(model, &sides)));
    found
}

/// What rules say about each component, in the order of the tree.
fn components(model: &Model) -> Vec<Finding> {
    let all = model.components().tree.iter();
    all.flat_map(|(id, object)| {
        let found = [
            not_hertz::of_component(model, id),
            duplicate_names::of_component(model, id, object),
            refused_name::of_component(model, id, object),
        ];
        found.into_iter().flatten()
    })
    .collect()
}
