//! `set`: writes given values, or multiplies values by given factors.

use crate::support::{HUMAN, TestDir};
use crate::{changed_lines, changes_in_json, json_object};

#[test]
fn set_writes_values_and_factors_and_nothing_else() {
    let dir = TestDir::with_human();
    dir.run("set human.osim stiffness=x2.5 dissipation=1 static_friction=0.9 -o out.osim")
        .succeeded()
        .wrote(&["out.osim"]);
    let lines = changed_lines(&dir.text("human.osim"), &dir.text("out.osim"));
    assert_eq!(lines.len(), 36);
    for (old, new) in [
        ("<stiffness>1000000</stiffness>", "<stiffness>2500000</stiffness>"),
        ("<dissipation>2</dissipation>", "<dissipation>1</dissipation>"),
        ("<static_friction>0.80000000000000004</static_friction>", "<static_friction>0.9</static_friction>"),
    ] {
        assert_eq!(
            lines.iter().filter(|line| (line.0.as_str(), line.1.as_str()) == (old, new)).count(),
            12,
            "{new}"
        );
    }
}

#[test]
fn set_changes_a_radius_alone() {
    let dir = TestDir::with_human();
    let run = dir.run("set human.osim radius=x1.25 --dry-run --format json").succeeded();
    assert_eq!(json_object(&run)["changes"].as_array().unwrap().len(), 12, "one for each sphere");
    let changed = changes_in_json(&run);
    assert_eq!(changed.into_iter().collect::<Vec<_>>(), [("radius".to_owned(), (0.032, 0.04))]);
}

#[test]
fn set_writes_an_absent_value() {
    let dir = TestDir::with_human();
    dir.run("set human.osim hertz_smoothing=250 -o out.osim").succeeded();
    let text = dir.text("out.osim");
    assert_eq!(text.matches("<hertz_smoothing>250</hertz_smoothing>").count(), 12);
    // A value that the model already has is not written.
    dir.run("set human.osim hertz_smoothing=300").succeeded().wrote_nothing().says(&["nothing-to-change"]);
}

#[test]
fn set_changes_only_selected_forces() {
    let dir = TestDir::with_human();
    let run = dir.run("set human.osim stiffness=2e6 --select *_r --dry-run --format json").succeeded();
    let plan = json_object(&run);
    let forces: Vec<_> =
        plan["changes"].as_array().unwrap().iter().map(|c| c["force"].as_str().unwrap()).collect();
    assert_eq!(forces.len(), 6);
    assert!(forces.iter().all(|force| force.ends_with("_r")), "{forces:?}");
}

#[test]
fn set_changes_every_surface_of_a_force() {
    let dir = TestDir::with(&[("format/three_materials.osim", "model.osim")]);
    let run = dir.run("set model.osim stiffness=x2 --dry-run --format json").succeeded();
    let plan = json_object(&run);
    let pairs: Vec<_> =
        plan["changes"].as_array().unwrap().iter().map(|c| (c["from"].as_f64(), c["to"].as_f64())).collect();
    let each = [(Some(5e6), Some(1e7)), (Some(1e6), Some(2e6)), (Some(8e5), Some(1.6e6))];
    assert_eq!(pairs, [each, each].concat());
}

#[test]
fn wrong_values_and_properties_are_refused() {
    let dir = TestDir::with(&[HUMAN, ("table1/human_62kg_hunt_crossley.osim", "hunt.osim")]);
    for (arguments, words) in [
        ("human.osim stifness=2", ["there is no property 'stifness'", "stiffness"]),
        ("human.osim mass=80", ["there is no property 'mass'", "stiffness"]),
        ("human.osim stiffness=1 stiffness=2", ["stiffness is set twice", ""]),
        ("human.osim stiffness=1,5e6", ["decimal comma", "1500000"]),
        ("human.osim stiffness=", ["stiffness=:", "expected a number"]),
        ("human.osim stiffness=-2", ["stiffness=-2", "above 0"]),
        ("human.osim", ["nothing to set", "PROPERTY=VALUE"]),
        ("stiffness=2", ["no model given", ""]),
    ] {
        dir.run(&format!("set {arguments}")).usage_error().wrote_nothing().says(&words);
    }
    dir.run("set human.osim stiffness=0").failed().wrote_nothing().says(&["stiffness is 0", "above 0"]);
    dir.run("set human.osim stiffness=x0").failed().wrote_nothing().says(&["stiffness is 0", "above 0"]);
    dir.run("set human.osim dissipation=0 --dry-run").succeeded();
    dir.run("set hunt.osim hertz_smoothing=300")
        .failed()
        .wrote_nothing()
        .says(&["none of the chosen forces has a hertz_smoothing"]);
}

#[test]
fn a_factor_in_place_is_not_repeated_without_force() {
    let dir = TestDir::with_human();
    dir.run("set human.osim stiffness=x2 --in-place").succeeded();
    assert_eq!(dir.text("human.osim").matches("<stiffness>2000000<").count(), 12);
    dir.run("set human.osim stiffness=x2 --in-place")
        .failed()
        .wrote_nothing()
        .says(&["was done already", "--force"]);
    let run = dir.run("set human.osim stiffness=x2 --in-place --format json").failed();
    assert_eq!(json_object(&run)["error"]["code"], "same-operation");
    dir.run("set human.osim stiffness=x2 --in-place --force").succeeded();
    assert_eq!(dir.text("human.osim").matches("<stiffness>4000000<").count(), 12);
    // A value may be set as often as one likes, and another factor is another operation.
    dir.run("set human.osim stiffness=1e6 --in-place").succeeded();
    dir.run("set human.osim stiffness=1e6 --in-place").succeeded().wrote_nothing();
    dir.run("set human.osim stiffness=x3 --in-place").succeeded();
}

#[test]
fn set_keeps_the_mass_that_contacts_are_made_for() {
    let dir = TestDir::with_human();
    let assert_note = |model: &str, note: &str| {
        let text = dir.text(model);
        assert!(
            text.contains(&format!("contacts made for {note} at 9.81 m/s2 (osim-contact-scale 0.1.0; ")),
            "{text}"
        );
    };
    // Without a given mass the mass of the bodies is used, as without a note, and the note has no mass.
    dir.run("set human.osim dissipation=1 -o own.osim").succeeded();
    assert!(
        dir.text("own.osim").contains(
            "made for unknown at 9.81 m/s2 (osim-contact-scale 0.1.0; all; by set dissipation=1 on "
        )
    );
    dir.run("own.osim --target-mass 500 -o a.osim")
        .succeeded()
        .says(&["contacts taken as made for 62 kg (sum of"]);
    // A mass from the caller or the note stays.
    dir.run("set human.osim dissipation=1 --contacts-mass 61 -o said.osim").succeeded();
    assert_note("said.osim", "61 kg");
    dir.run("said.osim --target-mass 500 -o b.osim").succeeded().says(&["contacts made for 61 kg (note"]);
    dir.run("set b.osim stiffness=x2 --select *_r -o c.osim").succeeded();
    assert_note("c.osim", "500 kg");
    dir.run("c.osim --target-mass 62 -o d.osim").succeeded().says(&["contacts made for 500 kg (note"]);
    // A partial note stays partial.
    dir.run("human.osim --target-mass 500 --only stiffness -o part.osim").succeeded();
    dir.run("set part.osim dissipation=1 -o still.osim").succeeded();
    let still = dir.text("still.osim");
    assert!(
        still.contains("; partial; by rescale") && still.contains("; by set dissipation=1 on "),
        "{still}"
    );
    dir.run("still.osim --target-mass 62").failed().wrote_nothing().says(&["--contacts-mass KG", "500 kg"]);
}

#[test]
fn bodies_scaled_after_set_need_the_contacts_mass() {
    let dir = TestDir::with(&[("scale_tool/generic_smooth.osim", "generic.osim")]);
    dir.run("set generic.osim dissipation=1 -o set.osim").succeeded();
    dir.run("set.osim --target-mass 100 -o other.osim").succeeded();
    // As OpenSim scales meshes.
    let text = dir.text("set.osim");
    let (size, scaled) =
        ("<scale_factors>1.01 1 1.02</scale_factors>", "<scale_factors>1.2 1 1.02</scale_factors>");
    assert!(text.contains(size));
    dir.write("scaled.osim", text.replace(size, scaled));
    dir.run("scaled.osim --target-mass 100").failed().wrote_nothing().says(&[
        "the note in the file gives no mass, and the bodies were scaled after",
        "--contacts-mass KG",
    ]);
}

#[test]
fn set_output_matches_its_snapshots() {
    let dir = TestDir::with_human();
    dir.run("set human.osim stiffness=x2 dissipation=1 --in-place").matches_snapshot("physics_set");
    dir.run("set human.osim stiffness=x2 dissipation=1 --in-place").matches_snapshot("physics_set_again");
}
