//! Tests which mass the program uses for the contacts: the mass in the note, in an option or of the bodies.

use crate::bytes::{assert_close, line_changes, lines_of_element, number_between_tags};
use crate::support::{HUMAN, TestDir};

#[test]
fn a_second_rescaling_starts_from_the_mass_in_the_note() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 1190 -o a.osim")
        .succeeded()
        .says(&["contacts taken as made for 62 kg", "9 bodies"]);
    let run = dir.run("a.osim --target-mass 500 -o b.osim").succeeded();
    run.says(&["contacts made for 1190 kg", "note"]);
    let text = dir.text("b.osim");
    assert_eq!(text.matches("[contacts made for ").count(), 1, "the note is replaced, not repeated");
    assert!(text.contains("contacts made for 500 kg"));
    // To the mass in the note: nothing changes.
    dir.run("b.osim --target-mass 500 --in-place").succeeded().wrote_nothing().says(&["already"]);
    // To the mass of the bodies.
    dir.run("b.osim --target-mass 62 -o c.osim").succeeded().says(&["contacts made for 500 kg"]);
}

#[test]
fn contacts_already_at_the_target_mass_stay_with_a_warning() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 62").succeeded().wrote_nothing().says(&[
        "62 kg already",
        "--contacts-mass KG",
        "transfer --from MODEL",
        "already-at-target",
    ]);
    // Within 0.1 % too.
    dir.run("human.osim --target-mass 62.05").succeeded().wrote_nothing().says(&["already-at-target"]);
    dir.run("human.osim --target-mass 62.07").succeeded().wrote(&["human.scaled.osim"]);
}

#[test]
fn an_explicit_output_is_an_identical_copy_if_nothing_changes() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 62 -o copy.osim").succeeded().wrote(&["copy.osim"]);
    assert_eq!(dir.read("copy.osim"), dir.read("human.osim"));
    dir.run("human.osim --target-mass 62 -d out").succeeded().wrote(&["out/human.osim"]);
    assert_eq!(dir.read("out/human.osim"), dir.read("human.osim"));
    let run = dir.run("human.osim --target-mass 62 -o -").succeeded().wrote_nothing();
    assert_eq!(run.stdout, dir.read("human.osim"));
    dir.run("human.osim --target-mass 100 --radius keep --only dissipation -o same.osim").succeeded();
    assert_eq!(dir.read("same.osim"), dir.read("human.osim"));
}

#[test]
fn contacts_of_an_already_scaled_body_need_the_contacts_mass() {
    // The commonest case: bodies weigh 1190 kg, contacts are those of a 62 kg human.
    let dir = TestDir::with(&[("table1/giraffe_smooth_sphere.osim", "giraffe.osim")]);
    dir.run("giraffe.osim --target-mass 1190").succeeded().wrote_nothing().says(&["already-at-target"]);
    dir.run("giraffe.osim --target-mass 1190 --contacts-mass 62 -o out.osim")
        .succeeded()
        .wrote(&["out.osim"])
        .says(&["contacts made for 62 kg (--contacts-mass)", "1190"]);
    // Where the bodies weigh neither, something is odd.
    dir.run("giraffe.osim --target-mass 500 --contacts-mass 62 --yes implausible-mass --dry-run")
        .succeeded()
        .says(&["mass-sources-disagree", "1190 kg"]);
}

#[test]
fn a_partial_change_makes_the_next_run_ask_for_the_mass() {
    for (options, missing) in [
        ("--only stiffness", "a default property"),
        ("--keep dissipation", "a default property"),
        ("--select *_r*", "a force"),
    ] {
        let dir = TestDir::with_human();
        dir.run(&format!("human.osim --target-mass 1190 {options} -o part.osim")).succeeded();
        assert!(dir.text("part.osim").contains("; partial; "), "{missing} was left behind by {options}");
        dir.run("part.osim --target-mass 500").failed().wrote_nothing().says(&["--contacts-mass KG", "1190"]);
        dir.run("part.osim --target-mass 500 --contacts-mass 1190").succeeded().wrote(&["part.scaled.osim"]);
    }
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 1190 --keep radius -o kept.osim").succeeded();
    assert!(dir.text("kept.osim").contains("; all; "), "the others follow the radius that stays");
}

#[test]
fn an_edited_value_makes_the_note_stale() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 1190 -o a.osim").succeeded();
    let edited = dir.text("a.osim").replacen("<dissipation>1.2", "<dissipation>1.3", 1);
    dir.write("edited.osim", edited);
    dir.run("edited.osim --target-mass 500")
        .failed()
        .wrote_nothing()
        .says(&["contacts were changed after this program left its note", "--contacts-mass KG"]);
    dir.run("edited.osim --target-mass 500 --contacts-mass 1190").succeeded().wrote(&["edited.scaled.osim"]);
    // Other parts of the model may change freely.
    let other = dir.text("a.osim").replacen("<mass>42.0390625", "<mass>43", 1);
    dir.write("heavier.osim", other);
    dir.run("heavier.osim --target-mass 500").succeeded().says(&["contacts made for 1190 kg (note"]);
}

#[test]
fn without_a_note_the_mass_of_the_bodies_is_used() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 1190 --no-note -o a.osim").succeeded();
    assert!(!dir.text("a.osim").contains("[contacts made for "));
    // Known contacts contradict the mass of the bodies.
    dir.run("a.osim --target-mass 62")
        .failed()
        .wrote_nothing()
        .says(&["for a body of 1190 kg", "--contacts-mass 1190"]);
    dir.run("set a.osim stiffness=x1.1 --no-note -o b.osim").succeeded();
    dir.run("b.osim --target-mass 62").succeeded().wrote_nothing().says(&["already-at-target"]);
}

#[test]
fn a_change_without_a_note_removes_the_old_note() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 1190 -o a.osim").succeeded();
    dir.run("a.osim --target-mass 500 --no-note -o b.osim").succeeded();
    // The note of the earlier run is about other values, so it was removed.
    assert!(dir.text("a.osim").contains("contacts made for 1190 kg"));
    assert!(!dir.text("b.osim").contains("contacts made for"));
    dir.run("b.osim --target-mass 100").says(&["62 kg"]);
}

#[test]
fn a_transfer_makes_contacts_for_the_mass_of_the_model() {
    let dir = TestDir::with(&[("table1/mouse_smooth_sphere.osim", "mouse.osim"), HUMAN]);
    // The mouse of Table 1 has the human's contact scaled to its size: the human on one foot, the mouse on two of four.
    let run = dir
        .run("transfer mouse.osim --from human.osim --reference-spheres 6 --stance-limbs 2 -o same.osim")
        .succeeded();
    run.says(&["62 kg"]);
    let (removed, added) = line_changes(&dir.read("mouse.osim"), &dir.read("same.osim"));
    let added = added.iter().filter(|line| !line.starts_with("<!--"));
    for (before, after) in removed.iter().zip(added) {
        assert_close(number_between_tags(after), number_between_tags(before), 1e-13, before);
    }
    // On all four: half the load on each, half the modulus; Table 1 prints 0.259 MPa for two.
    dir.run("transfer mouse.osim --from human.osim --reference-spheres 6 --stance-limbs 4 -o four.osim")
        .succeeded();
    let (_, added) = line_changes(&dir.read("mouse.osim"), &dir.read("four.osim"));
    assert_eq!(lines_of_element(&added, "stiffness").len(), 4);
    for line in lines_of_element(&added, "stiffness") {
        assert!((number_between_tags(line) / 1e6 - 0.259 / 2.0).abs() < 0.0005, "{line}");
    }
    dir.run("four.osim --target-mass 0.0418 -o twice.osim")
        .succeeded()
        .says(&["contacts made for 0.0209 kg (note"]);
}

/// A scaled model with the published contacts of its generic model, and models whose spheres do not fit their bones.
const SCALED_MODELS: [(&str, &str); 4] = [
    ("scale_tool/generic_smooth.osim", "generic.osim"),
    ("scale_tool/scaled_smooth.osim", "scaled.osim"),
    ("check/known_contacts.osim", "known.osim"),
    ("check/spheres_misplaced.osim", "misplaced.osim"),
];

#[test]
fn published_contacts_under_a_scaled_body_cause_a_question_at_any_target_mass() {
    let dir = TestDir::with(&SCALED_MODELS);
    for kg in ["52", "80"] {
        dir.run(&format!("scaled.osim --target-mass {kg} -o new.osim")).failed().wrote_nothing().says(&[
            "for a body of 62 kg",
            "transfer MODEL --from GENERIC",
            "--contacts-mass 62",
        ]);
    }
    dir.run("scaled.osim --target-mass 80 --contacts-mass 62").succeeded().wrote(&["scaled.scaled.osim"]);
}

#[test]
fn a_reference_whose_spheres_do_not_fit_its_own_bones_is_refused_whatever_its_mass_is() {
    let dir = TestDir::with(&SCALED_MODELS);
    for more in ["", " --reference-mass 62"] {
        dir.run(&format!("transfer known.osim --from misplaced.osim --follow-bodies{more}"))
            .failed()
            .wrote_nothing()
            .says(&["do not fit its own bones"]);
    }
}

#[test]
fn a_note_and_bodies_that_agree_are_one_finding() {
    let dir = TestDir::with(&[("check/noted.osim", "model.osim")]);
    let run = dir.run("check model.osim --contacts-mass 80").succeeded();
    run.says(&["1 warning", "the note in the file says 61.5 kg"]);
}

#[test]
fn contacts_for_another_gravity_have_one_finding() {
    let dir = TestDir::with_human();
    let set = ["set it in OpenSim"];
    dir.run("human.osim --target-mass 62 --target-gravity 1.62 -o moon.osim").succeeded().says(&set);
    // Under gravity as it is in the file the contacts are too soft, because they are made for another.
    dir.run("check moon.osim").failed().says(&["gravity-sources-disagree"]).says_not(&["sunk-in"]);
    let back = "moon.osim --target-mass 62 --target-gravity 9.81 -o back.osim";
    dir.run(back).succeeded().says_not(&set);
}

#[test]
fn a_wrong_original_model_causes_an_error_with_the_reason() {
    let dir = TestDir::with(&SCALED_MODELS);
    let noted = [("drawn_feet/six_spheres.osim", "noted.osim"), ("drawn_feet/left_behind.osim", "left.osim")];
    noted.iter().for_each(|(from, to)| dir.write(to, crate::support::fixture(from)));
    dir.write("copy.osim", dir.text("misplaced.osim"));
    let own = |name: &str| dir.text(name).replace("<stiffness>2000000<", "<stiffness>3100000<");
    // Meshes that are scaled in one of the models.
    dir.write("own.osim", own("generic.osim").replace("1.01 1 1.02", "1 1 1"));
    dir.write("own_scaled.osim", on_unscaled_meshes(own("scaled.osim")));
    for (call, expected) in [
        ("check generic.osim --from scaled.osim", "the two are swapped"),
        // A note in both, which says by itself that spheres of the scaled model were left behind.
        ("check noted.osim --from left.osim", "the two are swapped"),
        // Contacts that nobody published.
        ("check own.osim --from own_scaled.osim", "the two are swapped"),
        ("check scaled.osim --from known.osim", "spheres-not-compared"),
        ("check misplaced.osim --from copy.osim", "has a fault of its own"),
    ] {
        let run = dir.run(call).failed();
        let text = run.out().split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains(expected) && text.contains("1 error"), "{call}: {text}");
    }
    // Without spheres, and without forces that press with them.
    dir.write("bare.osim", crate::support::fixture("feet/human_40000.osim"));
    let text = dir.text("scaled.osim");
    let (before, forces) = text.split_once("<ForceSet").unwrap();
    let (_, after) = forces.split_once("</ForceSet>").unwrap();
    dir.write("unpressed.osim", format!("{before}{after}"));
    for model in ["bare.osim", "unpressed.osim"] {
        let run = dir.run(&format!("check {model} --from generic.osim")).succeeded();
        run.says(&["bare-model"]).says_not(&["spheres-not-compared"]);
    }
    for itself in ["scaled.osim", "./scaled.osim"] {
        let run = dir.run(&format!("check scaled.osim --from {itself}")).usage_error();
        run.says(&["scaled.osim is the model itself", "--from"]);
    }
    let contacts_do_not_fit = "the contacts of this model fit its body, and those of the other one do not";
    for (call, why) in [
        ("own.osim --from own_scaled.osim", "the bones of the other one are scaled"),
        ("generic.osim --from scaled.osim --reference-mass 62", contacts_do_not_fit),
    ] {
        let swapped = dir.run(&format!("transfer {call} --follow-bodies")).failed().wrote_nothing();
        swapped.says(&[why, "the two are swapped", "--yes wrong-afterwards"]);
    }
    // The spheres of another body.
    let other = dir.run("transfer scaled.osim --from known.osim --follow-bodies").failed().wrote_nothing();
    other.says(&["was it scaled from another one?"]);
}

#[test]
fn a_right_original_is_not_said_to_be_swapped() {
    let dir = TestDir::with(&SCALED_MODELS);
    // A generic model of 75 kg with contacts for 62 kg, and its copy, which weighs 62 kg by chance. The meshes of the copy alone are scaled.
    let heavy = dir.text("generic.osim").replace("1.01 1 1.02", "1 1 1").replace("<mass>36<", "<mass>49<");
    dir.write("heavy.osim", heavy);
    let copy = on_unscaled_meshes(dir.text("scaled.osim"));
    dir.write("copy.osim", copy.replace("<mass>30.193548387096776<", "<mass>40.193548387096776<"));
    dir.run("transfer copy.osim --from heavy.osim --follow-bodies --reference-mass 62 -o followed.osim")
        .succeeded()
        .says_not(&["swapped"]);
    dir.run("check copy.osim --from heavy.osim")
        .failed()
        .says(&["spheres-left-behind"])
        .says_not(&["swapped"]);
}

/// The model `text`, which was scaled from a model whose meshes have factors, as scaled from one whose meshes have none.
fn on_unscaled_meshes(text: String) -> String {
    let factors = [
        ("1.0302 0.90000000000000002 0.96899999999999997", "1.02 0.9 0.95"),
        ("0.95949999999999991 0.93000000000000005 0.96899999999999997", "0.95 0.93 0.95"),
        ("0.96960000000000002 0.97999999999999998 0.95879999999999999", "0.96 0.98 0.94"),
        ("0.97970000000000002 0.91000000000000003 0.98939999999999995", "0.97 0.91 0.97"),
    ];
    factors.iter().fold(text, |text, (was, is)| text.replace(was, is))
}
