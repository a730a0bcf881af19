//! The numbers that a force on the left gets from the proposed command, if the force on the right has other numbers.

use crate::checks::{check_text, check_with, find, remedy, with_text_replaced};
use osim_inspect::InspectOptions;
use osim_model::{FindingCode, Selection};
use osim_requests::Request;
use serde_json::{Value, json};

/// A human of 62 kg on 6 spheres on each foot.
const HUMAN_MODEL: &str = include_str!("../../../../fixtures/table1/human_62kg_smooth_sphere.osim");
const MODEL_OF_UNEQUAL_RADII: &str = include_str!("../../../../fixtures/format/unequal_radii.osim");
const MODEL_OF_UNEQUAL_STIFFNESS: &str = include_str!("../../../../fixtures/format/unequal_stiffness.osim");
/// A model whose feet have one force each, for spheres of 0.05 and 0.025 m.
const MODEL_OF_MIXED_RADII: &str = include_str!("../../../../fixtures/format/mixed_radii.osim");
/// A model in which each force has a set of parameters for the heel and a set for the toe.
const MODEL_OF_THREE_MATERIALS: &str = include_str!("../../../../fixtures/format/three_materials.osim");

#[track_caller]
fn assert_copied(text: &str, expected: &Value) {
    let copied = remedy(&check_text(text), FindingCode::LeftRightDiffer);
    assert_eq!(&copied["set"], expected);
}

#[test]
fn a_left_force_gets_each_number_of_the_right_one_that_it_lacks() {
    let text = with_text_replaced(
        MODEL_OF_UNEQUAL_STIFFNESS,
        "contact_heel_l",
        "<dissipation>2.25<",
        "<dissipation>1<",
    );
    let text = with_text_replaced(&text, "contact_toe_l", "<stiffness>1200000<", "<stiffness>1000000<");
    assert_copied(&text, &json!({"stiffness": 1e6, "dissipation": 2.25}));
}

#[test]
fn a_left_sphere_gets_the_radius_of_the_right_one() {
    // Up to 10 % is as in published models. A third pair shows which radius is meant; without it, one is as likely as the other.
    let unequal = MODEL_OF_UNEQUAL_RADII.replace("<radius>0.035<", "<radius>0.045<");
    assert_copied(&unequal, &Value::Null);
    let text =
        with_text_replaced(&unequal, "<ContactSphere name=\"toe_l\"", "<radius>0.045<", "<radius>0.0325<");
    assert_copied(&text, &json!({"radius": 0.0325}));
}

#[test]
fn radii_of_several_spheres_cannot_be_copied_by_one_value() {
    let text = with_text_replaced(
        MODEL_OF_MIXED_RADII,
        "<ContactSphere name=\"heel_l\"",
        "<radius>0.05<",
        "<radius>0.06<",
    );
    assert_copied(&text, &Value::Null);
}

#[test]
fn parameters_of_several_sets_cannot_be_copied_by_one_value() {
    let text =
        with_text_replaced(MODEL_OF_THREE_MATERIALS, "contact_l", "<stiffness>800000<", "<stiffness>900000<");
    assert_copied(&text, &Value::Null);
}

#[test]
fn a_constant_contact_force_of_0_is_not_copied() {
    let text = with_text_replaced(
        MODEL_OF_UNEQUAL_STIFFNESS,
        "contact_heel_r",
        "<constant_contact_force>1.5e-05<",
        "<constant_contact_force>0<",
    );
    assert_copied(&text, &Value::Null);
}

#[test]
fn the_side_that_is_a_slip_is_put_right_whichever_it_is() {
    for side in ["l", "r"] {
        let text = with_text_replaced(
            HUMAN_MODEL,
            &format!("name=\"contact_s1_{side}\""),
            "<stiffness>1000000<",
            "<stiffness>1e7<",
        );
        let result = check_with("human.osim", &text, &InspectOptions::default());
        let expected =
            json!({"verb": "set", "set": {"stiffness": 1e6}, "select": [format!("contact_s1_{side}")]});
        assert_eq!(remedy(&result, FindingCode::LeftRightDiffer), expected);
    }
}

#[test]
fn no_remedy_is_proposed_if_the_wrong_side_is_not_known() {
    // Two feet of two forces each, and one foot is stiffer: no number is published.
    assert_copied(MODEL_OF_UNEQUAL_STIFFNESS, &Value::Null);
    // Nor is a smoothing that suits the one side or the other.
    let text = MODEL_OF_UNEQUAL_STIFFNESS.replace(">1.5e-05<", ">8e-06<");
    let text = text.replace("<stiffness>1000000<", "<stiffness>40000000<");
    assert_eq!(remedy(&check_text(&text), FindingCode::ForceBeforeContact), Value::Null);
}

#[test]
fn forces_that_were_chosen_by_name_are_not_chosen_otherwise() {
    let selection = Selection { select: vec!["contact_*".parse().unwrap()], ..Selection::default() };
    let options = InspectOptions { selection, ..InspectOptions::default() };
    let result = check_with("model.osim", MODEL_OF_UNEQUAL_STIFFNESS, &options);
    assert_eq!(find(&result, FindingCode::LeftRightDiffer).remedy, None);
}

#[test]
fn a_force_whose_name_is_a_pattern_is_not_chosen_by_name() {
    let text = MODEL_OF_UNEQUAL_STIFFNESS.replace("contact_heel", "contact[heel]");
    assert_copied(&text, &Value::Null);
}

#[test]
fn the_side_that_differs_gets_the_value_of_the_other() {
    let start = HUMAN_MODEL.find("name=\"contact_s1_l\"").unwrap();
    let (before, force) = HUMAN_MODEL.split_at(start);
    let text = format!("{before}{}", force.replacen("<stiffness>1000000<", "<stiffness>2500000<", 1));
    assert_ne!(text, HUMAN_MODEL);
    let result = check_with("human.osim", &text, &InspectOptions::default());
    let expected = json!({"verb": "set", "set": {"stiffness": 1e6}, "select": ["contact_s1_l"]});
    assert_eq!(remedy(&result, FindingCode::LeftRightDiffer), expected);
    // One that was forgotten, too: a preset would replace the contacts of both sides.
    let text = format!("{before}{}", force.replacen("<stiffness>1000000</stiffness>", "", 1));
    let result = check_with("human.osim", &text, &InspectOptions::default());
    assert_eq!(remedy(&result, FindingCode::LeftRightDiffer), expected);
    assert!(matches!(result.steps[..], [Request::Set(_)]), "{:?}", result.steps);
}

/// A model with two feet of six spheres. The left foot was scaled by 0.99, 0.96 and 0.97: its radii by the geometric mean of these, the
/// parameters of its forces by (10), (14), (C.2), (C.5) and (C.10) for one mass.
fn smaller_left_foot() -> String {
    let text = include_str!("../../../../fixtures/check/known_contacts.osim");
    let ratio = (0.99_f64 * 0.96 * 0.97).cbrt();
    let times = |text: String, tag: &str, power: f64| {
        let open = format!("<{tag}>");
        let mut parts = text.split(&open);
        let mut out = parts.next().unwrap().to_owned();
        let mut owner_is_left = out.rfind("_l\">") > out.rfind("_r\">");
        for part in parts {
            let (value, rest) = part.split_once('<').unwrap();
            let value: f64 = value.parse().unwrap();
            let factor = if owner_is_left { ratio.powf(power) } else { 1.0 };
            out.push_str(&format!("{open}{}<{rest}", value * factor));
            owner_is_left = out.rfind("_l\">") > out.rfind("_r\">");
        }
        out
    };
    let mut text = text.to_owned();
    for (tag, power) in [
        ("radius", 1.0),
        ("stiffness", -2.0),
        ("dissipation", -0.5),
        ("constant_contact_force", 2.0),
        ("hertz_smoothing", -1.0),
        ("hunt_crossley_smoothing", -0.5),
    ] {
        text = times(text, tag, power);
    }
    let (right, left) = text.split_at(text.find("<Body name=\"calcn_l\">").unwrap());
    let small = [0.99, 0.96, 0.97].map(|factor| (factor * 0.913924).to_string()).join(" ");
    format!("{right}{}", left.replace("0.913924 0.913924 0.913924", &small))
}

fn differing_sides(text: &str) -> Vec<String> {
    let found = check_text(text).findings;
    let differ = found.iter().filter(|found| found.code() == FindingCode::LeftRightDiffer);
    differ.inspect(|found| assert_eq!(found.remedy, None)).map(|found| found.message.to_string()).collect()
}

#[test]
fn contacts_that_follow_bones_of_unlike_size_do_not_differ() {
    let text = smaller_left_foot();
    assert!(text.contains("<radius>0.032<") && text.contains("<radius>0.0311"));
    assert_eq!(differing_sides(&text), Vec::<String>::new());
    // On equal bones the same numbers differ, as little as in published models.
    let equal = include_str!("../../../../fixtures/check/known_contacts.osim");
    let (_, feet) = equal.split_at(equal.find("<Body name=\"calcn_l\">").unwrap());
    let of_equal = format!(
        "{}{}{}",
        &text[..text.find("<Body name=\"calcn_l\">").unwrap()],
        &feet[..feet.find("<ForceSet").unwrap()],
        &text[text.find("<ForceSet").unwrap()..]
    );
    let found = check_text(&of_equal);
    let differ = found.findings.iter().filter(|found| found.code() == FindingCode::LeftRightClose);
    let pairs: Vec<usize> = differ.map(|found| found.paths().count()).collect();
    assert_eq!(pairs, [6], "one cause");
}

#[test]
fn a_remedy_leaves_radii_on_bones_of_unlike_size() {
    let text = smaller_left_foot();
    let start = text.rfind("<radius>0.0311").unwrap();
    let end = start + text[start..].find("</radius>").unwrap();
    let wrong = format!("{}<radius>0.02{}", &text[..start], &text[end..]);
    assert!(
        differing_sides(&wrong)[0].contains("radius is 0.02 m for s6_l and 0.032 m for s6_r"),
        "one radius"
    );
    // A modulus that stays as it is, as in published models, and one that does neither.
    let start = text.rfind("<stiffness>").unwrap();
    let end = start + text[start..].find("</stiffness>").unwrap();
    let modulus = |modulus: f64| format!("{}<stiffness>{modulus}{}", &text[..start], &text[end..]);
    assert_eq!(differing_sides(&modulus(1e6)), Vec::<String>::new());
    let found = differing_sides(&modulus(1.3e6));
    assert!(found.len() == 1 && found[0].contains("stiffness is 1300000 and 1000000"), "{found:?}");
}
