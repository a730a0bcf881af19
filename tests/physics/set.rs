//! `set`: plain changes, with the same safety as every other change.

use crate::support::{Bench, HUMAN};
use crate::{changed_lines, changes, object};

#[test]
fn values_and_factors_are_written_and_nothing_follows() {
    let bench = Bench::human();
    bench
        .run("set human.osim stiffness=x2.5 dissipation=1 static_friction=0.9 -o out.osim")
        .done()
        .wrote(&["out.osim"]);
    let lines = changed_lines(&bench.text("human.osim"), &bench.text("out.osim"));
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
fn a_radius_changes_alone() {
    let bench = Bench::human();
    let ran = bench.run("set human.osim radius=x1.25 --dry-run --format json").done();
    assert_eq!(object(&ran)["changes"].as_array().unwrap().len(), 12, "one for each sphere");
    let seen = changes(&ran);
    assert_eq!(seen.into_iter().collect::<Vec<_>>(), [("radius".to_owned(), (0.032, 0.04))]);
}

#[test]
fn an_absent_value_is_written_out() {
    let bench = Bench::human();
    bench.run("set human.osim hertz_smoothing=250 -o out.osim").done();
    let text = bench.text("out.osim");
    assert_eq!(text.matches("<hertz_smoothing>250</hertz_smoothing>").count(), 12);
    // What it is already stays unwritten.
    bench.run("set human.osim hertz_smoothing=300").done().wrote_nothing().says(&["nothing-to-change"]);
}

#[test]
fn forces_can_be_chosen() {
    let bench = Bench::human();
    let ran = bench.run("set human.osim stiffness=2e6 --select *_r --dry-run --format json").done();
    let plan = object(&ran);
    let forces: Vec<_> =
        plan["changes"].as_array().unwrap().iter().map(|c| c["force"].as_str().unwrap()).collect();
    assert_eq!(forces.len(), 6);
    assert!(forces.iter().all(|force| force.ends_with("_r")), "{forces:?}");
}

#[test]
fn every_surface_of_a_force_is_set() {
    let bench = Bench::with(&[("format/three_materials.osim", "model.osim")]);
    let ran = bench.run("set model.osim stiffness=x2 --dry-run --format json").done();
    let plan = object(&ran);
    let pairs: Vec<_> =
        plan["changes"].as_array().unwrap().iter().map(|c| (c["from"].as_f64(), c["to"].as_f64())).collect();
    let each = [(Some(5e6), Some(1e7)), (Some(1e6), Some(2e6)), (Some(8e5), Some(1.6e6))];
    assert_eq!(pairs, [each, each].concat());
}

#[test]
fn what_makes_no_sense_is_refused() {
    let bench = Bench::with(&[HUMAN, ("table1/human_62kg_hunt_crossley.osim", "hunt.osim")]);
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
        bench.run(&format!("set {arguments}")).usage().wrote_nothing().says(&words);
    }
    bench.run("set human.osim stiffness=0").failed().wrote_nothing().says(&["stiffness is 0", "above 0"]);
    bench.run("set human.osim stiffness=x0").failed().wrote_nothing().says(&["stiffness is 0", "above 0"]);
    bench.run("set human.osim dissipation=0 --dry-run").done();
    bench
        .run("set hunt.osim hertz_smoothing=300")
        .failed()
        .wrote_nothing()
        .says(&["none of the chosen forces has a hertz_smoothing"]);
}

#[test]
fn a_factor_is_not_applied_twice_by_accident() {
    let bench = Bench::human();
    bench.run("set human.osim stiffness=x2 --in-place").done();
    assert_eq!(bench.text("human.osim").matches("<stiffness>2000000<").count(), 12);
    bench
        .run("set human.osim stiffness=x2 --in-place")
        .failed()
        .wrote_nothing()
        .says(&["was done already", "--force"]);
    let ran = bench.run("set human.osim stiffness=x2 --in-place --format json").failed();
    assert_eq!(object(&ran)["error"]["code"], "same-operation");
    bench.run("set human.osim stiffness=x2 --in-place --force").done();
    assert_eq!(bench.text("human.osim").matches("<stiffness>4000000<").count(), 12);
    // A value may be set as often as one likes, and another factor is another operation.
    bench.run("set human.osim stiffness=1e6 --in-place").done();
    bench.run("set human.osim stiffness=1e6 --in-place").done().wrote_nothing();
    bench.run("set human.osim stiffness=x3 --in-place").done();
}

#[test]
fn after_a_plain_change_the_contacts_are_made_for_what_they_were_made_for() {
    let bench = Bench::human();
    let noted = |model: &str, note: &str| {
        let text = bench.text(model);
        assert!(
            text.contains(&format!("contacts made for {note} at 9.81 m/s2 (osim-contact-scale 0.1.0; ")),
            "{text}"
        );
    };
    // Nobody said a mass: what the bodies weigh is taken, as without the note, and the note does not say it.
    bench.run("set human.osim dissipation=1 -o own.osim").done();
    assert!(
        bench.text("own.osim").contains(
            "made for unknown at 9.81 m/s2 (osim-contact-scale 0.1.0; all; by set dissipation=1 on "
        )
    );
    bench
        .run("own.osim --target-mass 500 -o a.osim")
        .done()
        .says(&["contacts taken as made for 62 kg (sum of"]);
    // The caller says it, or the note: it stays.
    bench.run("set human.osim dissipation=1 --contacts-mass 61 -o said.osim").done();
    noted("said.osim", "61 kg");
    bench.run("said.osim --target-mass 500 -o b.osim").done().says(&["contacts made for 61 kg (note"]);
    bench.run("set b.osim stiffness=x2 --select *_r -o c.osim").done();
    noted("c.osim", "500 kg");
    bench.run("c.osim --target-mass 62 -o d.osim").done().says(&["contacts made for 500 kg (note"]);
    // A note that is in doubt stays so.
    bench.run("human.osim --target-mass 500 --only stiffness -o part.osim").done();
    bench.run("set part.osim dissipation=1 -o still.osim").done();
    let still = bench.text("still.osim");
    assert!(
        still.contains("; partial; by rescale") && still.contains("; by set dissipation=1 on "),
        "{still}"
    );
    bench.run("still.osim --target-mass 62").failed().wrote_nothing().says(&["--contacts-mass KG", "500 kg"]);
}

#[test]
fn bodies_that_were_scaled_since_no_longer_weigh_what_the_contacts_are_made_for() {
    let bench = Bench::with(&[("scale_tool/generic_smooth.osim", "generic.osim")]);
    bench.run("set generic.osim dissipation=1 -o set.osim").done();
    bench.run("set.osim --target-mass 100 -o other.osim").done();
    // As OpenSim scales meshes.
    let text = bench.text("set.osim");
    let (size, scaled) =
        ("<scale_factors>1.01 1 1.02</scale_factors>", "<scale_factors>1.2 1 1.02</scale_factors>");
    assert!(text.contains(size));
    bench.write("scaled.osim", text.replace(size, scaled));
    bench.run("scaled.osim --target-mass 100").failed().wrote_nothing().says(&[
        "the note in the file gives no mass, and the bodies were scaled after",
        "--contacts-mass KG",
    ]);
}

#[test]
fn how_it_looks() {
    let bench = Bench::human();
    bench.run("set human.osim stiffness=x2 dissipation=1 --in-place").looks_like("physics_set");
    bench.run("set human.osim stiffness=x2 dissipation=1 --in-place").looks_like("physics_set_again");
}
