//! `fit` of a model to a recording: contacts that are known are found again.

use serde_json::Value;

use crate::support::{Bench, corpus};
use crate::{assert_close, object};

const FILES: [(&str, &str); 4] = [
    ("motion/walker.osim", "walker.osim"),
    ("motion/walk.mot", "walk.mot"),
    ("motion/plates.sto", "plates.sto"),
    ("motion/plates.xml", "plates.xml"),
];
const FIT: &str = "fit walker.osim --motion walk.mot --plates plates.sto --loads plates.xml";

/// The folder of a public recording, or `None` after saying that the test was skipped.
fn trial(test: &str, name: &str) -> Option<std::path::PathBuf> {
    Some(corpus(test)?.join("../trials").join(name))
}

/// The new value of a property, equal in all changes of it.
#[track_caller]
fn new_value(plan: &Value, property: &str) -> f64 {
    let changes = plan["changes"].as_array().unwrap().iter().filter(|change| change["property"] == property);
    let values: Vec<f64> = changes.map(|change| change["to"].as_f64().unwrap()).collect();
    assert!(!values.is_empty() && values.iter().all(|value| *value == values[0]), "{property}: {values:?}");
    values[0]
}

/// How far the floor goes up, m.
#[track_caller]
fn floor_up(plan: &Value) -> f64 {
    let moved =
        plan["changes"].as_array().unwrap().iter().find(|change| change["property"] == "location").unwrap();
    moved["to"][1].as_f64().unwrap() - moved["from"][1].as_f64().unwrap()
}

/// What `make_motion.py` gave the plates: E1* 4e6 N/m2 (8e6 in the model), 1.5 s/m (0.5), a floor 11 mm lower.
#[test]
fn contacts_that_are_known_are_found_again() {
    let bench = Bench::with(&FILES);
    let plan =
        object(&bench.run(&format!("{FIT} -o fitted.osim --format json")).done().wrote(&["fitted.osim"]));
    assert_close(new_value(&plan, "stiffness"), 4e6, 0.01, "E1*");
    assert_close(new_value(&plan, "dissipation"), 1.5, 0.05, "dissipation");
    assert!((floor_up(&plan) + 0.011).abs() < 1e-4, "{plan}");
    let errors = &plan["errors"];
    assert!(errors["vertical_rms_bw"].as_f64().unwrap() < 1e-3, "{errors}");
    assert!(errors["held_out_vertical_rms_bw"].as_f64().unwrap() < 1e-3, "{errors}");
    assert!(errors["cop_rms_m"].as_f64().unwrap() < 1e-3, "{errors}");
    // The model that was written agrees with its plates, and a second fit changes nothing that counts.
    let seen = object(
        &bench.run("motion fitted.osim walk.mot --plates plates.sto --loads plates.xml --format json").done(),
    );
    assert!(seen["comparison"]["vertical_rms_bw"].as_f64().unwrap() < 1e-3, "{seen}");
    // What was fitted to a body of 70 kg is made for it.
    let scaled = object(&bench.run("fitted.osim --target-mass 560 --dry-run --format json").done());
    assert_close(
        scaled["contacts_mass_kg"]["value"].as_f64().unwrap(),
        70.0,
        1e-12,
        "the mass that the contacts are made for",
    );
    insta::assert_snapshot!(
        "fit_motion",
        bench.run(&format!("{FIT} --dry-run")).done().wrote_nothing().out()
    );
}

/// A start that is wrong by ten times, either way, in stiffness and dissipation.
#[test]
fn a_start_that_is_wrong_by_ten_times_changes_nothing() {
    let bench = Bench::with(&FILES);
    for factor in ["x10", "x0.1"] {
        bench.run(&format!("set walker.osim stiffness={factor} dissipation={factor} -o wrong.osim --force --yes wrong-afterwards")).done();
        let call = FIT.replace("walker.osim", "wrong.osim");
        let plan = object(&bench.run(&format!("{call} --dry-run --format json")).done());
        assert_close(new_value(&plan, "stiffness"), 4e6, 0.01, factor);
        assert_close(new_value(&plan, "dissipation"), 1.5, 0.05, factor);
        assert!((floor_up(&plan) + 0.011).abs() < 1e-4, "{plan}");
    }
}

#[test]
fn only_what_is_named_is_fitted() {
    let bench = Bench::with(&FILES);
    let plan = object(&bench.run(&format!("{FIT} --fit height --dry-run --format json")).done());
    let properties: Vec<&str> = plan["changes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|change| change["property"].as_str().unwrap())
        .collect();
    assert_eq!(properties, ["location"]);
    let plan = object(
        &bench.run(&format!("{FIT} --fit stiffness --fit dissipation --dry-run --format json")).done(),
    );
    assert!(plan["changes"].as_array().unwrap().iter().all(|change| change["property"] != "location"));
}

/// Spheres with dissipations of their own keep them while the floor alone is fitted.
#[test]
fn what_is_not_fitted_stays_with_each_sphere() {
    let bench = Bench::with(&FILES);
    let own = bench.text("walker.osim").replacen("<dissipation>0.5", "<dissipation>4", 1);
    bench.write("own.osim", &own);
    bench.run("motion own.osim walk.mot -o own.sto").done().wrote(&["own.sto", "own.xml"]);
    let lower = own.replacen(
        "<location>0 0 0</location><orientation>",
        "<location>0 -0.005 0</location><orientation>",
        1,
    );
    assert_ne!(own, lower);
    bench.write("lower.osim", lower);
    let call = "fit lower.osim --motion walk.mot --plates own.sto --loads own.xml --unbounded --fit height";
    let plan = object(&bench.run(&format!("{call} --dry-run --format json")).done());
    assert!((floor_up(&plan) - 0.005).abs() < 2e-6, "{plan}");
    assert!(plan["errors"]["vertical_rms_bw"].as_f64().unwrap() < 1e-3, "{plan}");
}

/// Two recordings of one body: contacts are shared, and the walk's second half is a trial of its own.
#[test]
fn several_trials_share_their_contacts() {
    let bench = Bench::with(&FILES);
    let text = bench.text("walk.mot");
    let (head, rows) = text
        .split_once("pelvis_tilt")
        .map(|(head, rest)| (format!("{head}pelvis_tilt"), rest.to_owned()))
        .unwrap();
    let (names, rows) = rows.split_once('\n').unwrap();
    let half: Vec<&str> = rows.lines().skip(120).collect();
    bench.write("second.mot", format!("{head}{names}\n{}\n", half.join("\n")));
    let call = "fit walker.osim --motion walk.mot --motion second.mot --plates plates.sto --plates plates.sto --loads plates.xml";
    let plan = object(&bench.run(&format!("{call} --dry-run --format json")).done());
    assert_close(new_value(&plan, "stiffness"), 4e6, 0.01, "E1*");
    let notes: Vec<&str> =
        plan["notes"].as_array().unwrap().iter().map(|note| note.as_str().unwrap()).collect();
    assert!(
        notes.iter().any(|note| note.starts_with("the floor of trial 2 goes down by 11.0 mm")),
        "{notes:?}"
    );
    bench
        .run("fit walker.osim --motion walk.mot --motion second.mot --plates plates.sto")
        .usage()
        .says(&["2 motions, 1 tables"]);
}

#[test]
fn a_curve_and_a_recording_are_two_things() {
    let bench = Bench::with(&FILES);
    bench.run(&format!("{FIT} --radius 0.01")).usage().says(&["--radius"]);
    bench.run("fit walker.osim --motion walk.mot").usage().says(&["--plates"]);
    bench.run("fit walker.osim --plates plates.sto --radius 0.01").usage().says(&["--motion"]);
    bench.run("fit measured.csv --radius 0.01 -o other.csv").usage().says(&["--motion"]);
}

/// A published simulation whose ground reactions come from its own contacts: E1* within 1 %, α within 5 %, height within 0.1 mm.
#[test]
fn a_simulated_gait_gives_its_own_contacts_back() {
    let Some(folder) = trial("a_simulated_gait_gives_its_own_contacts_back", "example2DWalking") else {
        return;
    };
    let bench = Bench::new();
    for name in ["2D_gait.osim", "referenceCoordinates.sto", "referenceGRF.sto", "referenceGRF.xml"] {
        bench.write(name, std::fs::read(folder.join(name)).unwrap());
    }
    let call = "fit 2D_gait.osim --motion referenceCoordinates.sto --plates referenceGRF.sto --loads referenceGRF.xml --unbounded";
    let plan = object(&bench.run(&format!("{call} --dry-run --format json")).done());
    let stiffness =
        plan["changes"].as_array().unwrap().iter().find(|change| change["property"] == "stiffness").unwrap();
    assert_close(stiffness["to"].as_f64().unwrap(), stiffness["from"].as_f64().unwrap(), 0.01, "E1*");
    assert_close(new_value(&plan, "dissipation"), 2.0, 0.05, "dissipation");
    assert!(floor_up(&plan).abs() < 1e-4, "{plan}");
}

/// A measured gait: with no bound, 0.2 body weights per foot, and 0.3 on the foot that was not fitted.
#[test]
fn a_measured_gait_is_fitted_as_well_as_can_be() {
    let Some(folder) = trial("a_measured_gait_is_fitted_as_well_as_can_be", "subject01_walk_id") else {
        return;
    };
    let bench = Bench::new();
    for name in
        ["subject01.osim", "subject01_walk1_ik.mot", "subject01_walk1_grf.mot", "subject01_walk1_grf.xml"]
    {
        bench.write(name, std::fs::read(folder.join(name)).unwrap());
    }
    bench.run("add subject01.osim --from falisse2022 -o with.osim").done();
    let call = "fit with.osim --motion subject01_walk1_ik.mot --plates subject01_walk1_grf.mot --loads subject01_walk1_grf.xml";
    let of = |more: &str| {
        let plan = object(&bench.run(&format!("{call} {more} --dry-run --format json")).done());
        (
            plan["errors"]["vertical_rms_bw"].as_f64().unwrap(),
            plan["errors"]["held_out_vertical_rms_bw"].as_f64().unwrap(),
            plan,
        )
    };
    let (free, held_out, plan) = of("--unbounded");
    assert!(free < 0.2 && held_out < 0.3, "{free} {held_out}");
    assert!(plan["errors"]["largest_relative_indentation"].as_f64().unwrap() > 1.0);
    // Bounded, it says what that costs.
    let (bounded, _, plan) = of("");
    assert!(bounded > free && plan["errors"]["largest_relative_indentation"].as_f64().unwrap() <= 1.0 + 1e-6);
    let notes = plan["notes"].to_string();
    assert!(notes.contains("scatters by 36 mm, more than R (34 mm): stiffness is not determined"), "{notes}");
    assert!(notes.contains("--unbounded"), "{notes}");
}
