//! Which numbers a force on the left gets where those of its twin on the right are others.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    unreachable_pub,
    reason = "a test fails by panicking"
)]

mod checks;
mod feet;

use checks::{check_text, check_with, find};
use osim_inspect::InspectOptions;
use osim_model::{Assignment, FindingCode, Pattern, Property, RemedyChange, Selection};

/// 62 kg on 6 spheres a foot.
const HUMAN: &str = include_str!("../../../fixtures/table1/human_62kg_smooth_sphere.osim");
const UNEQUAL_RADII: &str = include_str!("../../../fixtures/format/unequal_radii.osim");
const UNEQUAL_STIFFNESS: &str = include_str!("../../../fixtures/format/unequal_stiffness.osim");
/// Feet of one force each, for spheres of 0.05 and 0.025 m.
const MIXED_RADII: &str = include_str!("../../../fixtures/format/mixed_radii.osim");
/// A set of parameters for the heel and one for the toe in each force.
const THREE_MATERIALS: &str = include_str!("../../../fixtures/format/three_materials.osim");

#[track_caller]
fn assert_copied(text: &str, expected: Option<&RemedyChange>) {
    let result = check_text(text);
    let remedy = &find(&result, FindingCode::LeftRightDiffer).remedy;
    assert_eq!(remedy.as_ref().map(|remedy| &remedy.change), expected);
}

/// `text` in which the first `old` after `start` is `new`.
fn after(text: &str, start: &str, old: &str, new: &str) -> String {
    let (before, rest) = text.split_at(text.find(start).unwrap());
    assert!(rest.contains(old), "{old}");
    format!("{before}{}", rest.replacen(old, new, 1))
}

#[test]
fn a_left_force_gets_each_number_of_the_right_one_that_it_lacks() {
    let text = after(UNEQUAL_STIFFNESS, "contact_heel_l", "<dissipation>2.25<", "<dissipation>1<");
    let assignments =
        vec![(Property::Stiffness, Assignment::Value(1e6)), (Property::Dissipation, Assignment::Value(2.25))];
    assert_copied(&text, Some(&RemedyChange::Set { assignments }));
}

#[test]
fn a_left_sphere_gets_the_radius_of_the_right_one() {
    let assignments = vec![(Property::Radius, Assignment::Value(0.0325))];
    assert_copied(UNEQUAL_RADII, Some(&RemedyChange::Set { assignments }));
}

#[test]
fn radii_of_several_spheres_cannot_be_copied_by_one_value() {
    let text = after(MIXED_RADII, "<ContactSphere name=\"heel_l\"", "<radius>0.05<", "<radius>0.06<");
    assert_copied(&text, None);
}

#[test]
fn parameters_of_several_sets_cannot_be_copied_by_one_value() {
    let text = after(THREE_MATERIALS, "contact_l", "<stiffness>800000<", "<stiffness>900000<");
    assert_copied(&text, None);
}

#[test]
fn a_constant_contact_force_of_0_is_not_copied() {
    let text = after(
        UNEQUAL_STIFFNESS,
        "contact_heel_r",
        "<constant_contact_force>1.5e-05<",
        "<constant_contact_force>0<",
    );
    assert_copied(&text, None);
}

#[test]
fn forces_that_were_chosen_by_name_are_not_chosen_otherwise() {
    let selection = Selection { select: vec!["contact_*".parse().unwrap()], ..Selection::default() };
    let options = InspectOptions { selection, ..InspectOptions::default() };
    let result = check_with("model.osim", UNEQUAL_RADII, &options);
    assert_eq!(find(&result, FindingCode::LeftRightDiffer).remedy, None);
}

#[test]
fn a_name_that_would_be_read_as_a_pattern_is_not_chosen_by() {
    let text = UNEQUAL_RADII.replace("contact_heel", "contact[heel]");
    assert_copied(&text, None);
}

#[test]
fn the_side_that_differs_gets_the_value_of_the_other() {
    let start = HUMAN.find("name=\"contact_s1_l\"").unwrap();
    let (before, force) = HUMAN.split_at(start);
    let text = format!("{before}{}", force.replacen("<stiffness>1000000<", "<stiffness>2500000<", 1));
    assert_ne!(text, HUMAN);
    let result = check_with("human.osim", &text, &InspectOptions::default());
    let remedy = find(&result, FindingCode::LeftRightDiffer).remedy.as_ref().unwrap();
    let assignments = vec![(Property::Stiffness, Assignment::Value(1e6))];
    assert_eq!(remedy.change, RemedyChange::Set { assignments });
    let select: Vec<&str> = remedy.selection.select.iter().map(Pattern::as_str).collect();
    assert_eq!(select, ["contact_s1_l"]);
}
