//! Finding the wrong one of two sides, if all contacts of one side differ from those of the other.

use crate::checks::{check_text, message, remedy, with_text_replaced};
use osim_model::FindingCode;
use serde_json::json;

/// A human with the contacts of Falisse et al. (2022), six forces on each side.
const HUMAN: &str = include_str!("../../../../fixtures/check/known_contacts.osim");

/// The human with ten times the stiffness in all forces whose names end in `end`: the forces of one side.
fn human_with_one_stiffer_side(end: &str) -> String {
    let mut parts = HUMAN.split("<SmoothSphereHalfSpaceForce name=\"");
    let first = parts.next().unwrap().to_owned();
    parts.fold(first, |text, force| {
        let is_side = force.split('"').next().unwrap().ends_with(end);
        let force = if is_side { force.replace(">1000000<", ">10000000<") } else { force.to_owned() };
        format!("{text}<SmoothSphereHalfSpaceForce name=\"{force}")
    })
}

#[test]
fn the_table_of_known_contacts_shows_which_side_is_wrong() {
    for (end, odd, known) in [("_l", "left", "right"), ("_r", "right", "left")] {
        let found = message(&check_text(&human_with_one_stiffer_side(end)), FindingCode::LeftRightDiffer);
        let expected = format!(
            "; the one on the {odd} differs from the others, since the contacts on the {known} are those of Falisse et al. (2022)"
        );
        assert!(found.ends_with(&expected), "{found}");
    }
}

#[test]
fn forces_that_are_odd_on_both_sides_are_named() {
    let stiffer = |text: &str, force: &str| with_text_replaced(text, force, ">1000000<", ">10000000<");
    let text = stiffer(&stiffer(HUMAN, "\"contact_s1_l\""), "\"contact_s2_r\"");
    let found = check_text(&text);
    let said = message(&found, FindingCode::LeftRightDiffer);
    let expected = "; /forceset/contact_s1_l, /forceset/contact_s2_r differ from the others";
    assert!(said.ends_with(expected), "{said}");
    let copied = remedy(&found, FindingCode::LeftRightDiffer);
    assert_eq!(copied["select"], json!(["contact_s1_l", "contact_s2_r"]));
}

#[test]
fn radii_of_one_side_are_one_finding() {
    for radii in [[0.0384; 6], [0.0368, 0.0384, 0.04, 0.0416, 0.0432, 0.0448]] {
        let mut radii = radii.into_iter();
        let mut parts = HUMAN.split("<ContactSphere name=\"");
        let first = parts.next().unwrap().to_owned();
        let text = parts.fold(first, |text, sphere| {
            let is_left = sphere.split('"').next().unwrap().ends_with("_l");
            let own = if is_left { radii.next().unwrap() } else { 0.032 };
            format!("{text}<ContactSphere name=\"{}", sphere.replace(">0.032<", &format!(">{own}<")))
        });
        let found = check_text(&text);
        let different = found.findings.iter().filter(|one| one.code() == FindingCode::LeftRightDiffer);
        let counts: Vec<usize> = different.map(|one| one.places.len()).collect();
        assert_eq!(counts, [6], "the left force of each pair");
        let copied = remedy(&found, FindingCode::LeftRightDiffer);
        assert_eq!(copied["set"], json!({"radius": 0.032}));
        assert_eq!(copied["select"].as_array().unwrap().len(), 6);
    }
}
