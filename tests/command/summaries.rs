//! `--summary`: old and new values of every changing verb, and columns of the user's own table.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use crate::support::Bench;

/// Lines of a summary in CSV, each by the names of the columns.
fn lines(text: &str) -> Vec<BTreeMap<String, String>> {
    csv::Reader::from_reader(text.as_bytes()).deserialize().map(|line| line.unwrap()).collect()
}

/// The line of one model after `call`.
fn line(bench: &Bench, call: &str) -> BTreeMap<String, String> {
    bench.run(&format!("{call} --dry-run --summary s.csv --force")).done();
    lines(&bench.text("s.csv")).remove(0)
}

#[track_caller]
fn near(line: &BTreeMap<String, String>, column: &str, expected: f64) {
    let value: f64 = line[column].parse().unwrap_or_else(|_| panic!("{column}: '{}'", line[column]));
    assert!((value / expected - 1.0).abs() < 1e-12, "{column}: {value}, not {expected}");
}

#[test]
fn every_verb_says_old_and_new_values_and_their_factor() {
    let bench = Bench::human();
    bench.write("emu.osim", crate::support::fixture("table1/emu_10_spheres_smooth_sphere.osim"));
    let set = line(&bench, "set human.osim stiffness=2e6 static_friction=0.4");
    for (column, expected) in [("stiffness_from", 1e6), ("stiffness_to", 2e6), ("stiffness_factor", 2.0)] {
        near(&set, column, expected);
    }
    near(&set, "static_friction_to", 0.4);
    assert_eq!((set["unequal_factors"].as_str(), set["radius_from_m"].as_str()), ("", ""));

    // (8) and (10) with 37.8 kg on 10 spheres against 62 kg on 6 of 0.032 m: E* = 1e6 (6/10) (37.8/62)^(1/3), by Python's
    // decimal.
    let transfer = line(&bench, "transfer emu.osim --from falisse2022 --radius isometric");
    for (column, expected) in [
        ("radius_from_m", 0.015),
        ("radius_to_m", 0.027_134_178_757_483_97),
        ("radius_factor", 1.808_945_250_498_931_3),
        ("stiffness_to", 508_765.851_702_824_4),
    ] {
        near(&transfer, column, expected);
    }
    let quotient =
        transfer["stiffness_to"].parse::<f64>().unwrap() / transfer["stiffness_from"].parse::<f64>().unwrap();
    near(&transfer, "stiffness_factor", quotient);
    assert_eq!(transfer["unequal_factors"], "");

    let design = line(&bench, "design human.osim --restitution 0.9");
    let quotient = design["dissipation_to"].parse::<f64>().unwrap() / 2.0;
    near(&design, "dissipation_from", 2.0);
    near(&design, "dissipation_factor", quotient);

    let rescale = line(&bench, "human.osim --target-mass 496");
    for (column, expected) in [("radius_from_m", 0.032), ("radius_to_m", 0.064), ("radius_factor", 2.0)] {
        near(&rescale, column, expected);
    }
}

#[test]
fn values_that_are_not_the_same_everywhere_are_empty() {
    let bench = Bench::with(&[("format/unequal_stiffness.osim", "model.osim")]);
    let one = line(&bench, "set model.osim stiffness=3e6");
    near(&one, "stiffness_to", 3e6);
    assert_eq!(
        (one["stiffness_from"].as_str(), one["stiffness_factor"].as_str(), one["unequal_factors"].as_str()),
        ("", "", "stiffness")
    );
    let twice = line(&bench, "set model.osim stiffness=x2");
    near(&twice, "stiffness_factor", 2.0);
    assert_eq!((twice["stiffness_from"].as_str(), twice["stiffness_to"].as_str()), ("", ""));
    assert_eq!(twice["unequal_factors"], "");
}

const TABLE: &str = "#subject,model,#sex,target-mass,output\nS01,human.osim,\"f, adult\",70,a.osim\nS02,human.osim,,80,b.osim\n";

#[test]
fn columns_of_ones_own_are_in_the_summary() {
    let bench = Bench::human();
    bench.write("m.csv", TABLE);
    bench.run("batch m.csv --summary s.csv --quiet").done();
    let first = bench.text("s.csv");
    let found = lines(&first);
    let own = |line: &BTreeMap<String, String>| (line["#subject"].clone(), line["#sex"].clone());
    assert_eq!(own(&found[0]), ("S01".to_owned(), "f, adult".to_owned()));
    assert_eq!(own(&found[1]), ("S02".to_owned(), String::new()));
    assert!(first.lines().next().unwrap().ends_with(",tool_version,folder,#subject,#sex"), "{first}");
    // One JSON object a line has them beside its own.
    bench.run("batch m.csv --summary s.ndjson --quiet --force").done();
    let json: Value = serde_json::from_str(bench.text("s.ndjson").lines().next().unwrap()).unwrap();
    assert_eq!(json["remarks"], json!({"#subject": "S01", "#sex": "f, adult"}));
    // A remark that was corrected makes no model new, and the summary of a run that goes on has it.
    bench.write("m.csv", TABLE.replace("S02", "S03"));
    for summary in ["s.csv", "s.ndjson"] {
        bench.run(&format!("batch m.csv --summary {summary} --resume")).done().wrote(&[summary]);
        assert!(bench.text(summary).contains("S03") && !bench.text(summary).contains("S02"));
    }
    // A row that fails keeps its own, too.
    bench.write("broken.osim", "<OpenSimDocument");
    bench.write("m.csv", TABLE.replace("S02,human.osim", "S02,broken.osim"));
    bench.run("batch m.csv --summary s.csv --force").failed();
    let found = lines(&bench.text("s.csv"));
    assert_eq!((found[1]["status"].as_str(), found[1]["#subject"].as_str()), ("failed", "S02"));
}

#[test]
fn all_columns_that_nobody_knows_are_named_at_once() {
    let bench = Bench::human();
    bench.write("m.csv", "subject,model,target-mas,age,jobs\nS01,human.osim,70,30,2\n");
    bench.run("batch m.csv").usage().wrote_nothing().looks_like("batch_unknown_columns");
}
