//! One fault in a model is one error or warning, about the element that is wrong: what follows from it is not said beside it.

use osim_inspect::{CheckResult, InspectOptions, Sign, Stance};
use osim_model::{FindingCode, Severity};

use crate::checks::{check_text, check_with, find, has, with_text_replaced};

/// A human with the contacts of Falisse et al. (2022), six forces on each side.
const HUMAN: &str = include_str!("../../../../fixtures/check/known_contacts.osim");

/// The codes of all errors and warnings.
fn severe_codes(found: &CheckResult) -> Vec<FindingCode> {
    let severe = found.findings.iter().filter(|one| one.severity > Severity::Remark);
    severe.map(|one| one.code()).collect()
}

#[test]
fn each_fault_is_said_once() {
    use FindingCode::{
        LeftRightBones, NotFinite, OddNumber, OddRadius, OutOfDomain, SphereOfOtherSide, SpheresMisplaced,
    };
    let edited = |start: &str, old: &str, new: &str| with_text_replaced(HUMAN, start, old, new);
    let sphere = "ContactSphere name=\"s1_r\"";
    for (text, code, place) in [
        (edited(sphere, ">0.032<", ">0,32<"), OddNumber, "/contactgeometryset/s1_r"),
        (edited(sphere, "<location>", "<location>["), OddNumber, "/contactgeometryset/s1_r"),
        (edited(sphere, ">0.032<", ">inf<"), NotFinite, "/contactgeometryset/s1_r"),
        (edited(sphere, " -0.01 ", " inf "), NotFinite, "/contactgeometryset/s1_r"),
        (edited(sphere, "0.00190115 ", "1.90115 "), SpheresMisplaced, "/contactgeometryset/s1_r"),
        (edited(sphere, ">0.032<", ">0.32<"), OddRadius, "/contactgeometryset/s1_r"),
        (edited("\"contact_s1_r\"", ">1000000<", ">0<"), OutOfDomain, "/forceset/contact_s1_r"),
        (edited("\"contact_s1_l\"", "/s1_l<", "/s1_r<"), SphereOfOtherSide, "/forceset/contact_s1_l"),
        (edited("\"mtp_r\"", ">0.16341 -0.00183 0", ">163.41 -1.83 0"), LeftRightBones, "/jointset/mtp_l"),
    ] {
        let found = check_text(&text);
        assert_eq!(severe_codes(&found), [code], "{:?}", found.findings);
        assert_eq!(find(&found, code).place.as_deref(), Some(place));
        // Nothing is called good that was not judged.
        let sides = found.verdicts.iter().find(|verdict| verdict.on.as_str() == "sides").unwrap();
        assert_ne!(sides.sign, Sign::Good, "{:?}", sides.text);
    }
}

#[test]
fn a_warning_from_which_an_error_follows_is_an_error() {
    use FindingCode::{
        ContactsOfAnotherMass, HeavyFoot, LeftRightDiffer, LeftRightPlaces, MasslessBody, OddPlace,
        OddRadius, UnevenBottoms,
    };
    let (sphere, pelvis) = ("ContactSphere name=\"s1_r\"", "Body name=\"pelvis\"");
    for (start, old, new, code) in [
        (sphere, " -0.01 ", " -10 ", OddPlace),
        (sphere, ">0.032<", ">32<", OddRadius),
        (sphere, ">0.032<", ">0.000032<", OddRadius),
        (pelvis, ">60<", ">0<", MasslessBody),
        (pelvis, ">60<", ">500<", ContactsOfAnotherMass),
        ("Body name=\"calcn_r\"", ">0.75<", ">500<", HeavyFoot),
        ("\"contact_s1_r\"", ">1000000<", ">1<", LeftRightDiffer),
    ] {
        let found = check_text(&with_text_replaced(HUMAN, start, old, new));
        assert_eq!(severe_codes(&found), [code], "{:?}", found.findings);
        assert_eq!(find(&found, code).severity, Severity::Error);
    }
    // A warning from which it does not follow stays one.
    let far = with_text_replaced(HUMAN, sphere, " -0.01 ", " -10 ");
    let text = with_text_replaced(&far, "\"contact_s4_l\"", "static_friction>0.8", "static_friction>0.9");
    let found = check_text(&text);
    assert_eq!(find(&found, LeftRightDiffer).severity, Severity::Warning, "{:?}", found.findings);
    // That the other spheres of this foot are higher is said beside it: the other foot may be as uneven.
    let found = check_text(&with_text_replaced(HUMAN, sphere, " -0.01 ", " -0.05 "));
    assert_eq!(severe_codes(&found), [LeftRightPlaces, UnevenBottoms], "{:?}", found.findings);
    assert_eq!(find(&found, LeftRightPlaces).severity, Severity::Error);
}

#[test]
fn forces_that_press_spheres_of_the_other_side_leave_their_own_without_a_force() {
    let found = check_text(&HUMAN.replace("_l</socket_sphere>", "_r</socket_sphere>"));
    assert_eq!(severe_codes(&found), [FindingCode::SphereOfOtherSide], "{:?}", found.findings);
}

#[test]
fn a_force_that_is_pasted_twice_is_said_once() {
    let end = "</SmoothSphereHalfSpaceForce>";
    let from = HUMAN.find("<SmoothSphereHalfSpaceForce name=\"contact_s1_r\">").unwrap();
    let to = from + HUMAN[from..].find(end).unwrap() + end.len();
    let found = check_text(&format!("{}{}", &HUMAN[..to], &HUMAN[from..]));
    assert_eq!(severe_codes(&found), [FindingCode::SphereInTwoForces], "{:?}", found.findings);
}

#[test]
fn a_dynamic_friction_that_is_too_large_is_said_once() {
    let found = check_text(&HUMAN.replace("<dynamic_friction>0.8<", "<dynamic_friction>3<"));
    assert_eq!(severe_codes(&found), [FindingCode::LargeFriction], "{:?}", found.findings);
}

/// The difference of the sides has the command, so the number on the odd side is said once.
#[test]
fn a_number_of_one_side_is_said_with_its_command() {
    for (old, new) in [("<static_friction>0.8<", "<static_friction>80<"), (">1000000<", ">1<")] {
        let found = check_text(&with_text_replaced(HUMAN, "\"contact_s1_r\"", old, new));
        assert_eq!(severe_codes(&found), [FindingCode::LeftRightDiffer], "{:?}", found.findings);
        assert_eq!(found.steps.len(), 1, "{:?}", found.steps);
    }
}

#[test]
fn a_mass_that_cannot_be_used_is_said_once() {
    use FindingCode::{NotFinite, OddNumber, OutOfDomain};
    for (mass, code) in [("NaN", NotFinite), ("abc", OddNumber), ("-1", OutOfDomain)] {
        let pelvis = "Body name=\"pelvis\"";
        let found = check_text(&with_text_replaced(HUMAN, pelvis, ">60<", &format!(">{mass}<")));
        assert_eq!(severe_codes(&found), [code], "{:?}", found.findings);
        let weight = found.verdicts.iter().find(|verdict| verdict.on.as_str() == "mass").unwrap();
        assert_eq!(weight.sign, Sign::Unknown, "{:?}", weight.text);
    }
}

#[test]
fn what_follows_elsewhere_in_the_model_is_left_out() {
    use FindingCode::{AngleInDegrees, ContactsOfAnotherMass, DoubledSpheres};
    use FindingCode::{NoSurfacesMeet, NotFinite, UnknownName};
    const LISTS: &str = include_str!("../../../../fixtures/motion/walker.osim");
    let mut places = HUMAN.split("<location>");
    let start = places.next().unwrap().to_owned();
    let at_origins = places.fold(start, |text, place| {
        format!("{text}<location>0 0 0{}", &place[place.find("</location>").unwrap()..])
    });
    let without_gravity = HUMAN.replace(">0 -9.81 0<", ">NaN NaN NaN<");
    let of_a_child = with_text_replaced(HUMAN, "Body name=\"pelvis\"", ">60<", ">29<");
    let empty = LISTS.replace("heel_r floor", "").replace("ball_r floor", "");
    let leg = "PinJoint name=\"leg_r\"";
    let turned = with_text_replaced(HUMAN, leg, "<orientation>0 0 0<", "<orientation>0 0 90<");
    for (text, code) in [
        (turned, AngleInDegrees),
        (at_origins, DoubledSpheres),
        (without_gravity, NotFinite),
        (of_a_child, ContactsOfAnotherMass),
        (empty, NoSurfacesMeet),
        (HUMAN.replace("ForceSet", "Forceset"), UnknownName),
    ] {
        let found = check_text(&text);
        assert_eq!(severe_codes(&found), [code], "{:?}", found.findings);
    }
}

#[test]
fn what_follows_from_nothing_else_is_not_left_out() {
    use FindingCode::{AngleInDegrees, DynamicAboveStatic, GravitySourcesDisagree, IgnoredContacts};
    use FindingCode::{LargeFriction, NoGravity, NotFinite, OddPlace, OddRadius, SunkIn, UnknownName};
    const NOTED: &str = include_str!("../../../../fixtures/check/noted.osim");
    let sphere = "ContactSphere name=\"s1_r\"";
    let far = with_text_replaced(HUMAN, sphere, " -0.01 ", " -10 ");
    let unknown = with_text_replaced(HUMAN, sphere, ">0.032<", ">NaN<");
    let force = "\"contact_s1_r\"";
    let sticky = with_text_replaced(HUMAN, force, "dynamic_friction>0.8", "dynamic_friction>0.9");
    let on_both_sides = ["r", "l"].iter().fold(HUMAN.to_owned(), |text, side| {
        let force = |number: u8| format!("\"contact_s{number}_{side}\"");
        let text = with_text_replaced(&text, &force(1), "dynamic_friction>0.8", "dynamic_friction>0.9");
        with_text_replaced(&text, &force(2), "static_friction>0.8", "static_friction>80")
    });
    let second = "<ForceSet><objects><HuntCrossleyForce name=\"more\"/></objects></ForceSet></Model>";
    let second = HUMAN.replace("</Model>", second);
    let misspelt = with_text_replaced(&second, "\"leg_r\"", "<frames>", "<revers>false</revers><frames>");
    for (text, codes) in [
        (on_both_sides, [DynamicAboveStatic, LargeFriction]),
        (far.replace(">0 0 -1.5707963267948966<", ">0 0 -90<"), [AngleInDegrees, OddPlace]),
        (unknown.replace(">0 -9.81 0<", ">0 0 0<"), [NoGravity, NotFinite]),
        (with_text_replaced(&sticky, sphere, ">0.032<", ">0.32<"), [DynamicAboveStatic, OddRadius]),
        // Less gravity than the contacts are made for.
        (
            NOTED.replace("0 -9.81 0", "0 -8 0").replace("4.4876e7", "4.4876e4"),
            [GravitySourcesDisagree, SunkIn],
        ),
        (misspelt, [IgnoredContacts, UnknownName]),
    ] {
        let found = check_text(&text);
        assert!(codes.into_iter().all(|code| has(&found, code)), "{:?}", found.findings);
    }
}

/// A change is not blamed for what was hidden before it, but for all else: an odd radius can make contacts too stiff, and does not here.
#[test]
fn codes_that_were_left_out_are_those_of_this_model() {
    let sphere = "ContactSphere name=\"s1_r\"";
    let left_out = check_text(&with_text_replaced(HUMAN, sphere, ">0.032<", ">0.32<")).left_out;
    assert!(left_out.contains(&FindingCode::LeftRightDiffer), "{left_out:?}");
    assert!(!left_out.contains(&FindingCode::TooStiff), "{left_out:?}");
}

/// Under ten times the gravity these contacts sink in up to their centres, and nothing is wrong with them. The caller may give the same.
#[test]
fn figures_under_a_gravity_that_is_wrong_are_not_judged() {
    let text = with_text_replaced(HUMAN, "<gravity>", ">0 -9.81 0<", ">0 -98.1 0<");
    for gravity_m_s2 in [None, Some(98.1)] {
        let stance = Stance { gravity_m_s2, ..Stance::default() };
        let found = check_with("model.osim", &text, &InspectOptions { stance, ..InspectOptions::default() });
        assert_eq!(severe_codes(&found), [FindingCode::OddGravity]);
        let unknown = found.verdicts.iter().filter(|verdict| verdict.sign == Sign::Unknown);
        let unknown: Vec<&str> = unknown.map(|verdict| verdict.on.as_str()).collect();
        assert_eq!(unknown, ["standing", "mass", "solver"]);
    }
}

/// Numbers that suit the rest of the model would be wrong once the fault is gone: a stiffness in the place of a friction, one of three radii
/// of a force, which no single value puts right, and a heel that one force has lost.
#[test]
fn no_command_hides_the_fault() {
    const FEET: &str = include_str!("../../../../fixtures/scale_tool/generic_hunt_crossley.osim");
    let exchanged = HUMAN.replace("<stiffness>1000000<", "<stiffness>0.8<");
    let exchanged = exchanged.replace("<static_friction>0.8<", "<static_friction>1000000<");
    let heel = "<ContactSphere name=\"heel_r\">";
    let larger = with_text_replaced(FEET, heel, ">0.032000000000000001<", ">0.062<");
    let soft = FEET.replace(">2000000<", ">500000<");
    for (text, codes) in [
        (soft.replace("floor heel_r", "floor"), [FindingCode::LeftRightMissing, FindingCode::SunkIn]),
        (exchanged, [FindingCode::LargeFriction, FindingCode::SunkIn]),
        (larger, [FindingCode::LeftRightDiffer, FindingCode::UnevenBottoms]),
    ] {
        let found = check_text(&text);
        assert!(codes.into_iter().all(|code| has(&found, code)), "{:?}", found.findings);
        assert!(found.steps.is_empty(), "{:?}", found.steps);
    }
}
