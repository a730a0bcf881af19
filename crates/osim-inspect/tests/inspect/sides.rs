//! Left and right: damage on one side gives a finding, and right models get no such finding.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use osim_inspect::{BothSides, model_findings};
use osim_model::{Finding, FindingCode, Model, Severity, Side};

use crate::{corpus_folder, moco_3d_walking};

/// A model with two legs of four bodies. The calcaneus has a heel sphere and a ball sphere, whose own frame is turned; the toes have
/// spheres, too.
const HUMAN: &str = include_str!("../../../../fixtures/scale_tool/generic_smooth.osim");
const HUNT_CROSSLEY: &str = include_str!("../../../../fixtures/scale_tool/generic_hunt_crossley.osim");
/// A model with published contacts, six spheres on each foot.
const PUBLISHED_FEET: &str = include_str!("../../../../fixtures/check/known_contacts.osim");

const SPHERE_CLASS: &str = "ContactSphere";
const SMOOTH_CLASS: &str = "SmoothSphereHalfSpaceForce";
/// The texts of 0.032 and 0.2 in the fixture.
const RADIUS_TEXT: &str = "0.032000000000000001";
const VELOCITY_TEXT: &str = "0.20000000000000001";

/// The codes that these tests look at; other findings are left out.
const SIDE_CODES: &[FindingCode] = &[
    FindingCode::DoubledSpheres,
    FindingCode::LeftRightDiffer,
    FindingCode::LeftRightPlaces,
    FindingCode::LeftRightMissing,
    FindingCode::LeftRightSwapped,
    FindingCode::LeftRightOff,
    FindingCode::LeftRightClose,
    FindingCode::OneSideOnly,
    FindingCode::OddRadius,
    FindingCode::OddPlace,
    FindingCode::CrowdedSpheres,
    FindingCode::LargeFriction,
];

/// The text of the element `tag` called `name`, with its tags.
#[track_caller]
fn text_of_element<'t>(text: &'t str, tag: &str, name: &str) -> &'t str {
    let start = text.find(&format!("<{tag} name=\"{name}\">")).unwrap_or_else(|| panic!("no {tag} {name}"));
    let end = format!("</{tag}>");
    &text[start..start + text[start..].find(&end).unwrap() + end.len()]
}

/// The model `text` with `new` instead of `old` in the element `tag` called `name`.
#[track_caller]
fn with_edited_element(text: &str, (tag, name): (&str, &str), old: &str, new: &str) -> String {
    let element = text_of_element(text, tag, name);
    assert!(element.contains(old), "{element} has no {old}");
    text.replacen(element, &element.replace(old, new), 1)
}

/// The model `text` without the sphere `name` and its force, or with a copy of both whose name ends in `_0`.
fn with_sphere_removed_or_copied(text: &str, name: &str, count: usize) -> String {
    let objects = [(SPHERE_CLASS, name.to_owned()), (SMOOTH_CLASS, format!("contact_{name}"))];
    objects.iter().fold(text.to_owned(), |text, (tag, name_of)| {
        let own = text_of_element(&text, tag, name_of).to_owned();
        let copy = own
            .replace(&format!("{name}\""), &format!("{name}_0\""))
            .replace(&format!("{name}<"), &format!("{name}_0<"));
        let all = [own.clone(), copy][..count].concat();
        text.replacen(&own, &all, 1)
    })
}

fn codes_of_findings(model: &Model) -> BTreeSet<FindingCode> {
    model_findings(model).iter().map(Finding::code).filter(|code| SIDE_CODES.contains(code)).collect()
}

#[track_caller]
fn assert_found(text: &str, expected: &[FindingCode]) {
    let model = Model::parse(text).unwrap();
    let found = codes_of_findings(&model);
    assert_eq!(found, expected.iter().copied().collect(), "{:?}", model_findings(&model));
}

#[track_caller]
fn message_of_finding(text: &str, code: FindingCode) -> String {
    let model = Model::parse(text).unwrap();
    let found = model_findings(&model)
        .iter()
        .find(|finding| finding.code() == code)
        .unwrap_or_else(|| panic!("no {code}"));
    found.message.to_string()
}

#[test]
fn models_whose_sides_are_mirror_images_are_not_accused() {
    for text in [HUMAN, HUNT_CROSSLEY, PUBLISHED_FEET] {
        assert_found(text, &[]);
    }
}

#[test]
fn a_difference_between_sides_names_the_side_unlike_most_contacts() {
    for (name, expected) in [("contact_ball_r", Side::Right), ("contact_ball_l", Side::Left)] {
        let text = with_edited_element(HUMAN, (SMOOTH_CLASS, name), ">2000000<", ">20000000<");
        assert_found(&text, &[FindingCode::LeftRightDiffer]);
        let model = Model::parse(text.as_str()).unwrap();
        let left = model.forces().iter().find(|force| force.name == "contact_ball_l").unwrap();
        assert_eq!(BothSides::of(&model).odd_side(left), Some(expected));
        // Of six forces the two compared are one that is odd and one of five.
        assert!(message_of_finding(&text, FindingCode::LeftRightDiffer).contains("(4 others have 2000000)"));
    }
}

#[test]
fn no_majority_names_a_side_where_all_contacts_of_one_side_differ() {
    let (right, left) = HUMAN.split_at(HUMAN.find("name=\"contact_heel_l\"").unwrap());
    let text = format!("{right}{}", left.replace(">2000000<", ">20000000<"));
    assert_found(&text, &[FindingCode::LeftRightDiffer]);
    let model = Model::parse(text.as_str()).unwrap();
    let sides = BothSides::of(&model);
    assert!(model.forces().iter().all(|force| sides.odd_side(force).is_none()));
}

#[test]
fn a_number_of_a_few_contacts_is_not_a_majority() {
    // Toes of another radius on both sides; the ball on the left has theirs by a slip.
    let toes = ["toe_r", "toe_l"].iter();
    let text = toes.fold(HUMAN.to_owned(), |text, name| {
        with_edited_element(&text, (SPHERE_CLASS, name), RADIUS_TEXT, "0.02")
    });
    let text = with_edited_element(&text, (SPHERE_CLASS, "heel_l"), RADIUS_TEXT, "0.04");
    let text = with_edited_element(&text, (SPHERE_CLASS, "heel_r"), RADIUS_TEXT, "0.04");
    let text = with_edited_element(&text, (SPHERE_CLASS, "ball_l"), RADIUS_TEXT, "0.02");
    let found = message_of_finding(&text, FindingCode::LeftRightDiffer);
    assert!(found.ends_with("radius is 0.02 m for ball_l and 0.032 m for ball_r"), "{found}");
}

#[test]
fn contacts_are_paired_by_place_whatever_their_names_are() {
    // No sides in names, and other numbers on the left than on the right.
    let mut text = HUMAN.to_owned();
    for (old, new) in [("heel_l", "l1"), ("toe_l", "l3"), ("heel_r", "r2"), ("toe_r", "r3")] {
        for (before, after) in [("\"", "\""), ("contact_", "\""), ("/", "<")] {
            text = text.replace(&format!("{before}{old}{after}"), &format!("{before}{new}{after}"));
        }
    }
    assert_found(&text, &[]);
    let text = with_edited_element(&text, (SMOOTH_CLASS, "contact_l1"), ">2000000<", ">20000000<");
    let found = message_of_finding(&text, FindingCode::LeftRightDiffer);
    let expected = "/forceset/contact_l1 and /forceset/contact_r2 differ: stiffness is 20000000 and 2000000";
    assert!(found.starts_with(expected), "{found}");
}

#[test]
fn numbers_that_differ_as_little_as_published_or_rounded_ones_are_a_remark() {
    use FindingCode::{LeftRightClose, LeftRightDiffer};
    for (new, expected) in [
        ("0.0338", LeftRightClose),
        ("0.03519", LeftRightClose),
        ("0.03521", LeftRightDiffer),
        ("0.048", LeftRightDiffer),
    ] {
        assert_found(&with_edited_element(HUMAN, (SPHERE_CLASS, "ball_l"), RADIUS_TEXT, new), &[expected]);
    }
    for (new, expected) in [
        ("0.21", LeftRightClose),
        ("0.17", LeftRightClose),
        ("0.25", LeftRightDiffer),
        ("-0.2", LeftRightDiffer),
        ("40", LeftRightDiffer),
    ] {
        assert_found(
            &with_edited_element(HUMAN, (SMOOTH_CLASS, "contact_ball_l"), VELOCITY_TEXT, new),
            &[expected],
        );
    }
    for (new, expected) in [("1990000", LeftRightClose), ("2025000", LeftRightDiffer)] {
        let left = (SMOOTH_CLASS, "contact_ball_l");
        assert_found(&with_edited_element(HUMAN, left, ">2000000<", &format!(">{new}<")), &[expected]);
    }
    // The older class has its velocity beside its parameter sets.
    let text =
        with_edited_element(HUNT_CROSSLEY, ("HuntCrossleyForce", "contact_foot_l"), VELOCITY_TEXT, "40");
    assert_found(&text, &[LeftRightDiffer]);
}

#[test]
fn numbers_of_sides_have_four_digits() {
    let text = with_edited_element(HUMAN, (SPHERE_CLASS, "ball_l"), RADIUS_TEXT, "0.054124409");
    let found = message_of_finding(&text, FindingCode::LeftRightDiffer);
    assert!(found.contains("radius is 0.05412 m for ball_l and 0.032 m for ball_r"), "{found}");
}

#[test]
fn places_that_are_not_mirror_images_are_named() {
    let wrong_sign = with_edited_element(HUMAN, (SPHERE_CLASS, "ball_l"), " -0.02<", " 0.02<");
    assert_found(&wrong_sign, &[FindingCode::LeftRightPlaces]);
    let found = message_of_finding(&wrong_sign, FindingCode::LeftRightPlaces);
    // In a frame that is turned: no sign of the body's axes puts it right.
    let expected = "ball_l on calcn_l is 40 mm from the mirror image of ball_r on calcn_r, ";
    assert!(found.starts_with(expected) && found.ends_with(", expected at most 3 %"), "{found}");
    let published =
        with_edited_element(PUBLISHED_FEET, (SPHERE_CLASS, "s3_l"), " -0.05163625<", " 0.05163625<");
    let found = message_of_finding(&published, FindingCode::LeftRightPlaces);
    assert!(found.ends_with(": the sign of z is wrong on one of them"), "{found}");

    let on_shank =
        with_edited_element(HUMAN, (SPHERE_CLASS, "heel_l"), "/bodyset/calcn_l", "/bodyset/tibia_l");
    assert_found(&on_shank, &[FindingCode::LeftRightPlaces]);
    let found = message_of_finding(&on_shank, FindingCode::LeftRightPlaces);
    assert_eq!(found, "heel_l is on tibia_l, its counterpart heel_r on calcn_r");

    let other_side =
        with_edited_element(HUMAN, (SPHERE_CLASS, "heel_l"), "/bodyset/calcn_l", "/bodyset/calcn_r");
    let found = message_of_finding(&other_side, FindingCode::LeftRightPlaces);
    assert_eq!(found, "heel_l is on calcn_r, its counterpart heel_r on calcn_r");

    let in_mm = with_edited_element(HUMAN, (SPHERE_CLASS, "toe_l"), "0.029999999999999999 ", "30 ");
    assert_found(&in_mm, &[FindingCode::LeftRightPlaces, FindingCode::OddPlace]);
}

#[test]
fn spheres_without_a_counterpart_are_named() {
    assert_found(&with_sphere_removed_or_copied(HUMAN, "ball_l", 0), &[FindingCode::LeftRightMissing]);
    let found =
        message_of_finding(&with_sphere_removed_or_copied(HUMAN, "ball_l", 0), FindingCode::LeftRightMissing);
    assert_eq!(found, "ball_r on calcn_r has no counterpart on calcn_l");
    let on_pelvis = with_edited_element(HUMAN, (SPHERE_CLASS, "ball_l"), "/calcn_l/calcn_l_ball", "/pelvis");
    let found = message_of_finding(&on_pelvis, FindingCode::LeftRightMissing);
    assert_eq!(found, "ball_r on calcn_r has no counterpart on calcn_l: ball_l is on pelvis");
    // One side without contacts: a kicker.
    let one_side = ["heel_l", "ball_l", "toe_l"]
        .iter()
        .fold(HUMAN.to_owned(), |text, name| with_sphere_removed_or_copied(&text, name, 0));
    assert_found(&one_side, &[FindingCode::OneSideOnly]);
    // A prosthesis, which the other side does not have.
    let prosthesis = HUMAN.replace("\"toes_l\"", "\"blade_l\"").replace("/toes_l<", "/blade_l<");
    assert_found(&prosthesis, &[FindingCode::OneSideOnly]);
}

#[test]
fn a_bone_that_is_far_heavier_than_its_counterpart_is_named() {
    let femur = ("Body", "femur_r");
    let heavy = with_edited_element(HUMAN, femur, "<mass>8<", "<mass>80<");
    let found = message_of_finding(&heavy, FindingCode::HeavyFoot);
    assert_eq!(found, "femur_r weighs 80 kg, more than femur_l (8 kg)");
    // Three times the counterpart, or a small part of the body, may be a prosthesis on the other side.
    let shank = with_edited_element(HUMAN, ("Body", "tibia_r"), "<mass>3.5<", "<mass>12<");
    for text in [with_edited_element(HUMAN, femur, "<mass>8<", "<mass>24<"), shank] {
        let model = Model::parse(text).unwrap();
        assert!(model_findings(&model).iter().all(|one| one.code() != FindingCode::HeavyFoot));
    }
}

#[test]
fn a_contact_that_is_switched_off_on_one_side_is_named() {
    let start = "<socket_sphere>";
    let off = format!("<appliesForce>false</appliesForce>{start}");
    let text = with_edited_element(HUMAN, (SMOOTH_CLASS, "contact_ball_l"), start, &off);
    assert_found(&text, &[FindingCode::LeftRightOff]);
    assert_found(&with_edited_element(&text, (SMOOTH_CLASS, "contact_ball_r"), start, &off), &[]);
}

#[test]
fn spheres_at_one_place_are_an_error() {
    let text = with_sphere_removed_or_copied(HUMAN, "ball_l", 2);
    assert_found(&text, &[FindingCode::DoubledSpheres]);
    let model = Model::parse(text.as_str()).unwrap();
    let found =
        model_findings(&model).iter().find(|finding| finding.code() == FindingCode::DoubledSpheres).unwrap();
    assert_eq!(found.severity, Severity::Error);
    assert_eq!(found.message.to_string(), "ball_l and ball_l_0 are at the same place of calcn_l");
}

/// The model `text` in which the numbers of `property` of the object are multiplied by `factor`.
fn with_property_multiplied(text: &str, object: (&str, &str), property: &str, factor: f64) -> String {
    let own = text_of_element(text, object.0, object.1);
    let start = own.find(&format!("<{property}>")).unwrap() + property.len() + 2;
    let old = &own[start..start + own[start..].find('<').unwrap()];
    let new: Vec<String> =
        old.split(' ').map(|number| (number.parse::<f64>().unwrap() * factor).to_string()).collect();
    with_edited_element(text, object, &format!(">{old}<"), &format!(">{}<", new.join(" ")))
}

/// A model whose left foot is `factor` times as large as the right foot: the bones and the spheres, or the spheres alone.
fn larger_left_foot(factor: f64, with_bones: bool) -> String {
    let mut text = HUMAN.to_owned();
    for name in ["heel_l", "ball_l", "toe_l"] {
        text = with_property_multiplied(&text, (SPHERE_CLASS, name), "radius", factor);
        text = with_property_multiplied(&text, (SPHERE_CLASS, name), "location", factor);
    }
    text = with_property_multiplied(&text, ("PhysicalOffsetFrame", "calcn_l_ball"), "translation", factor);
    for name in ["calcn_l", "toes_l"].iter().filter(|_| with_bones) {
        text = with_property_multiplied(&text, ("Body", name), "scale_factors", factor);
    }
    text
}

#[test]
fn a_foot_that_is_larger_with_its_bones_is_not_accused() {
    for factor in [0.9, 1.1, 1.5] {
        assert_found(&larger_left_foot(factor, true), &[]);
    }
    // An axis without a number does not end the comparison.
    let text = larger_left_foot(1.5, true);
    let factors = text_of_element(text_of_element(&text, "Body", "calcn_l"), "Mesh", "calcn_l_geom_1");
    let start = factors.find("<scale_factors>").unwrap() + "<scale_factors>".len();
    let whole = &factors[start..start + factors[start..].find('<').unwrap()];
    let (first, _) = whole.split_once(' ').unwrap();
    let zero = with_edited_element(&text, ("Body", "calcn_l"), whole, &whole.replacen(first, "0", 1));
    assert_found(&zero, &[]);
    assert_found(
        &larger_left_foot(1.5, false),
        &[FindingCode::LeftRightDiffer, FindingCode::LeftRightPlaces],
    );
}

#[test]
fn parameters_that_follow_other_radii_are_right() {
    // (10) at one mass: E* goes with R^-2. The speeds and friction stay.
    let mut text = larger_left_foot(1.5, true);
    for name in ["contact_heel_l", "contact_ball_l", "contact_toe_l"] {
        text = with_property_multiplied(&text, (SMOOTH_CLASS, name), "stiffness", 1.0 / (1.5 * 1.5));
    }
    assert_found(&text, &[]);
    let text = with_property_multiplied(&text, (SMOOTH_CLASS, "contact_toe_l"), "stiffness", 1.5);
    assert_found(&text, &[FindingCode::LeftRightDiffer]);
}

#[test]
fn a_left_frame_with_another_mirrored_axis_is_understood() {
    // The frames of the left foot are turned by half a turn about y, as models of other programs have them.
    let mut text =
        with_sphere_removed_or_copied(&with_sphere_removed_or_copied(HUMAN, "ball_r", 0), "ball_l", 0);
    for (object, property) in [
        ((SPHERE_CLASS, "heel_l"), "location"),
        ((SPHERE_CLASS, "toe_l"), "location"),
        (("PinJoint", "toes_l_joint"), "translation"),
    ] {
        text = mirrored_in_x_instead_of_z(&text, object, property);
    }
    assert_found(&text, &[]);
}

#[test]
fn a_centre_of_mass_that_is_not_mirrored_turns_no_frame() {
    // As the toes of some published models have it: on the same side of both feet, and higher than it is aside.
    let centre = "<mass_center>0 -0 0<";
    let text = ["toes_r", "toes_l"].iter().fold(HUMAN.to_owned(), |text, name| {
        with_edited_element(&text, ("Body", name), centre, "<mass_center>0.035 0.006 -0.0175<")
    });
    assert_found(&text, &[]);
}

/// The model `text` with the signs of x and z of a triple changed: it was mirrored in z, and is then mirrored in x.
fn mirrored_in_x_instead_of_z(text: &str, object: (&str, &str), property: &str) -> String {
    let own = text_of_element(text, object.0, object.1);
    let start = own.find(&format!("<{property}>")).unwrap() + property.len() + 2;
    let old = &own[start..start + own[start..].find('<').unwrap()];
    let [x, y, z] = *old.split(' ').map(|number| number.parse::<f64>().unwrap()).collect::<Vec<_>>() else {
        panic!("{old}")
    };
    with_edited_element(text, object, &format!(">{old}<"), &format!(">{} {y} {}<", -x, -z))
}

#[test]
fn radii_places_and_friction_in_other_units_are_named() {
    let in_mm = HUMAN.replace(&format!("<radius>{RADIUS_TEXT}<"), "<radius>32<");
    assert_found(&in_mm, &[FindingCode::OddRadius]);
    let found = message_of_finding(&in_mm, FindingCode::OddRadius);
    // The longest bone of the fixture is 0.4 m or more: 32 m is at most 80 of it.
    assert!(
        found.starts_with("radius of heel_r is 32 m, ") && found.ends_with("; 5 other radii, too"),
        "{found}"
    );
    let places = ["heel_r", "ball_r", "toe_r", "heel_l", "ball_l", "toe_l"];
    let in_mm = places.iter().fold(HUMAN.to_owned(), |text, name| {
        with_property_multiplied(&text, (SPHERE_CLASS, name), "location", 1000.0)
    });
    assert_found(&in_mm, &[FindingCode::OddPlace]);
    let per_cent = HUMAN.replace("<static_friction>0.80000000000000004<", "<static_friction>80<");
    assert_found(&per_cent, &[FindingCode::LargeFriction]);
    // 0.3 of the longest bone is the limit; one sphere on each side, so that the sides are equal.
    let found = codes_of_findings(
        &Model::parse(with_edited_element(HUMAN, (SPHERE_CLASS, "ball_r"), RADIUS_TEXT, "0.001")).unwrap(),
    );
    assert!(found.contains(&FindingCode::OddRadius), "{found:?}");
}

/// The hips are 0.16 m apart, and the thighs 0.4 m long.
#[test]
fn the_radii_of_a_seat_are_compared_with_the_thighs() {
    for (radius, is_odd) in [("0.06", false), ("0.2", true)] {
        let sits = ["heel_r", "heel_l"].iter().fold(HUMAN.to_owned(), |text, name| {
            let text = with_edited_element(&text, (SPHERE_CLASS, name), RADIUS_TEXT, radius);
            let calcn = format!("/bodyset/calcn_{}", &name[5..]);
            with_edited_element(&text, (SPHERE_CLASS, name), &calcn, "/bodyset/pelvis")
        });
        let found = codes_of_findings(&Model::parse(sits).unwrap());
        assert_eq!(found.contains(&FindingCode::OddRadius), is_odd, "{found:?}");
    }
}

/// The names of the spheres in the fixture.
const SPHERE_NAMES: [&str; 6] = ["heel_r", "ball_r", "toe_r", "heel_l", "ball_l", "toe_l"];

/// The model `text` with the sphere `name` moved along z by `by_m`, m.
fn with_sphere_moved(text: &str, name: &str, by_m: f64) -> String {
    let own = text_of_element(text, SPHERE_CLASS, name);
    let start = own.find("<location>").unwrap() + "<location>".len();
    let old = &own[start..start + own[start..].find('<').unwrap()];
    let [x, y, z] = *old.split(' ').map(|number| number.parse::<f64>().unwrap()).collect::<Vec<_>>() else {
        panic!("{old}")
    };
    with_edited_element(text, (SPHERE_CLASS, name), &format!(">{old}<"), &format!(">{x} {y} {}<", z + by_m))
}

#[test]
fn places_aside_and_in_thousandths_are_named() {
    // Outwards on both sides, so that they are mirror images; the ball is in a frame that is turned.
    let outwards = |text: String, name: &&str| {
        with_sphere_moved(&text, name, if name.ends_with("_r") { 0.2 } else { -0.2 })
    };
    let text = ["heel_r", "toe_r", "heel_l", "toe_l"].iter().fold(HUMAN.to_owned(), outwards);
    assert_found(&text, &[FindingCode::OddPlace]);
    let found = message_of_finding(&text, FindingCode::OddPlace);
    assert!(
        found.contains(" m sideways from the nearest joint of ") && found.ends_with("; 3 other spheres, too"),
        "{found}"
    );
    // 0.05 m are the width of a foot.
    let outwards = |text: String, name: &&str| {
        with_sphere_moved(&text, name, if name.ends_with("_r") { 0.05 } else { -0.05 })
    };
    assert_found(&["heel_r", "heel_l"].iter().fold(HUMAN.to_owned(), outwards), &[]);

    let places = (1..=6).flat_map(|number| [format!("s{number}_r"), format!("s{number}_l")]);
    let text = places.fold(PUBLISHED_FEET.to_owned(), |text, name| {
        with_property_multiplied(&text, (SPHERE_CLASS, &name), "location", 0.001)
    });
    assert_found(&text, &[FindingCode::CrowdedSpheres]);
    let found = message_of_finding(&text, FindingCode::CrowdedSpheres);
    // The toes' spheres are 15 mm apart in x and 80.617 mm in z, and the calcaneus is 163.42 mm long.
    let expected = "the 2 spheres of toes_l are within 0.000082 m, 0.000502 of the limb's longest bone (0.163 m), expected at least 0.02";
    assert_eq!(found, format!("{expected}; those of 3 other bodies, too"));
}

#[test]
fn spheres_with_names_of_the_other_side_are_reported() {
    let swapped = SPHERE_NAMES.iter().fold(HUMAN.to_owned(), |text, name| {
        let other = if let Some(bone) = name.strip_suffix("_r") {
            format!("{bone}_l")
        } else {
            name.replace("_l", "_r")
        };
        text.replace(&format!("name=\"{name}\""), &format!("name=\"@{other}\""))
            .replace(&format!("/{name}<"), &format!("/@{other}<"))
    });
    let text = swapped.replace('@', "");
    assert_found(&text, &[FindingCode::LeftRightSwapped]);
    let found = message_of_finding(&text, FindingCode::LeftRightSwapped);
    assert_eq!(found, "heel_l is on calcn_r, and heel_r on calcn_l; 2 other pairs, too");
}

/// Codes of the findings about sides, for each model with contacts in the folder, by its name.
fn codes_of_models_in(folder: &Path) -> Vec<(String, BTreeSet<FindingCode>)> {
    let mut paths: Vec<PathBuf> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    // README's first command leaves a result there, which is not a fixture.
    let is_model = |path: &Path| path.extension().is_some_and(|end| end == "osim");
    paths.retain(|path| is_model(path) && !path.to_string_lossy().ends_with(".scaled.osim"));
    paths.sort();
    let read = |path: &PathBuf| {
        let model = Model::parse(std::fs::read(path).unwrap()).ok()?;
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        (!model.loaded_spheres(&model.force_ids()).is_empty()).then(|| (name, codes_of_findings(&model)))
    };
    paths.iter().filter_map(read).collect()
}

#[test]
fn no_published_model_gets_a_finding_about_its_sides() {
    let Some(folder) = corpus_folder("sides of published models") else { return };
    let mut found = codes_of_models_in(&folder);
    found.push(("moco_3d_walking".to_owned(), codes_of_findings(&moco_3d_walking(&folder))));
    assert!(found.len() >= 16, "{} models with contacts", found.len());
    let accused: Vec<_> = found.iter().filter(|(_, codes)| !codes.is_empty()).collect();
    // A kicker, whose right foot alone has spheres.
    let kicker =
        ("v40000_soccer_kick_sphere_pairs.osim".to_owned(), BTreeSet::from([FindingCode::OneSideOnly]));
    assert_eq!(accused, [&kicker], "of {} models", found.len());
}

#[test]
fn only_fixtures_about_sides_have_findings_about_sides() {
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures");
    let folders = ["check", "drawn_feet", "format", "scale_tool", "table1", "walks"];
    let found: Vec<_> =
        folders.iter().flat_map(|folder| codes_of_models_in(&fixtures.join(folder))).collect();
    assert!(found.len() >= 150, "{} models with contacts", found.len());
    let accused: Vec<&str> =
        found.iter().filter(|(_, codes)| !codes.is_empty()).map(|(name, _)| name.as_str()).collect();
    let about_it = [
        "crowded_spheres",
        "doubled_spheres",
        "large_friction",
        "left_right_close",
        "left_right_missing",
        "left_right_off",
        "left_right_places",
        "left_right_swapped",
        "mass_against_length",
        "odd_place",
        "odd_radius",
        "one_side_only",
        "applies_force_false",
        "unequal_counts",
        "unequal_radii",
        "unequal_stiffness",
        "v30000_disabled",
    ];
    let expected: Vec<String> = about_it.iter().map(|name| format!("{name}.osim")).collect();
    assert_eq!(accused, expected, "of {} models", found.len());
}
