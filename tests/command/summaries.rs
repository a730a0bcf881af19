//! `--summary`: old and new values for every verb that changes models, and the user's own columns of a table.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use crate::support::TestDir;

/// Lines of a summary in CSV. Each line maps names of columns to cells.
fn summary_lines(text: &str) -> Vec<BTreeMap<String, String>> {
    csv::Reader::from_reader(text.as_bytes()).deserialize().map(|line| line.unwrap()).collect()
}

/// The line of one model after `call`.
fn summary_line(dir: &TestDir, call: &str) -> BTreeMap<String, String> {
    dir.run(&format!("{call} --dry-run --summary s.csv --force")).succeeded();
    summary_lines(&dir.text("s.csv")).remove(0)
}

#[track_caller]
fn assert_near(line: &BTreeMap<String, String>, column: &str, expected: f64) {
    let value: f64 = line[column].parse().unwrap_or_else(|_| panic!("{column}: '{}'", line[column]));
    assert!((value / expected - 1.0).abs() < 1e-12, "{column}: {value}, not {expected}");
}

#[test]
fn every_verb_writes_old_and_new_values_and_their_factor() {
    let dir = TestDir::with_human();
    dir.write("emu.osim", crate::support::fixture("table1/emu_10_spheres_smooth_sphere.osim"));
    let set = summary_line(&dir, "set human.osim stiffness=2e6 static_friction=0.4");
    for (column, expected) in [("stiffness_from", 1e6), ("stiffness_to", 2e6), ("stiffness_factor", 2.0)] {
        assert_near(&set, column, expected);
    }
    assert_near(&set, "static_friction_to", 0.4);
    assert_eq!((set["unequal_factors"].as_str(), set["radius_from_m"].as_str()), ("", ""));

    // (8) and (10) with 37.8 kg on 10 spheres against 62 kg on 6 of 0.032 m: E* = 1e6 (6/10) (37.8/62)^(1/3), by Python's
    // decimal.
    let transfer = summary_line(&dir, "transfer emu.osim --from falisse2022 --radius isometric");
    for (column, expected) in [
        ("radius_from_m", 0.015),
        ("radius_to_m", 0.027_134_178_757_483_97),
        ("radius_factor", 1.808_945_250_498_931_3),
        ("stiffness_to", 508_765.851_702_824_4),
    ] {
        assert_near(&transfer, column, expected);
    }
    let quotient =
        transfer["stiffness_to"].parse::<f64>().unwrap() / transfer["stiffness_from"].parse::<f64>().unwrap();
    assert_near(&transfer, "stiffness_factor", quotient);
    assert_eq!(transfer["unequal_factors"], "");

    let design = summary_line(&dir, "design human.osim --restitution 0.9");
    let quotient = design["dissipation_to"].parse::<f64>().unwrap() / 2.0;
    assert_near(&design, "dissipation_from", 2.0);
    assert_near(&design, "dissipation_factor", quotient);

    let rescale = summary_line(&dir, "human.osim --target-mass 496");
    for (column, expected) in [("radius_from_m", 0.032), ("radius_to_m", 0.064), ("radius_factor", 2.0)] {
        assert_near(&rescale, column, expected);
    }
}

#[test]
fn values_that_differ_between_forces_are_empty() {
    let dir = TestDir::with(&[("format/unequal_stiffness.osim", "model.osim")]);
    let one = summary_line(&dir, "set model.osim stiffness=3e6");
    assert_near(&one, "stiffness_to", 3e6);
    assert_eq!(
        (one["stiffness_from"].as_str(), one["stiffness_factor"].as_str(), one["unequal_factors"].as_str()),
        ("", "", "stiffness")
    );
    let twice = summary_line(&dir, "set model.osim stiffness=x2");
    assert_near(&twice, "stiffness_factor", 2.0);
    assert_eq!((twice["stiffness_from"].as_str(), twice["stiffness_to"].as_str()), ("", ""));
    assert_eq!(twice["unequal_factors"], "");
}

const TABLE_OF_SUBJECTS: &str = "#subject,model,#sex,target-mass,output\nS01,human.osim,\"f, adult\",70,a.osim\nS02,human.osim,,80,b.osim\n";

#[test]
fn columns_of_the_user_are_in_the_summary() {
    let dir = TestDir::with_human();
    dir.write("m.csv", TABLE_OF_SUBJECTS);
    dir.run("batch m.csv --summary s.csv --quiet").succeeded();
    let first = dir.text("s.csv");
    let lines_of_summary = summary_lines(&first);
    let own_columns = |line: &BTreeMap<String, String>| (line["#subject"].clone(), line["#sex"].clone());
    assert_eq!(own_columns(&lines_of_summary[0]), ("S01".to_owned(), "f, adult".to_owned()));
    assert_eq!(own_columns(&lines_of_summary[1]), ("S02".to_owned(), String::new()));
    assert!(first.lines().next().unwrap().ends_with(",tool_version,folder,#subject,#sex"), "{first}");
    // In JSON the user's columns are in `columns`.
    dir.run("batch m.csv --summary s.ndjson --quiet --force").succeeded();
    let json: Value = serde_json::from_str(dir.text("s.ndjson").lines().next().unwrap()).unwrap();
    assert_eq!(json["columns"], json!({"#subject": "S01", "#sex": "f, adult"}));
    // After a correction in the user's columns no model is written again, but the summary of the resumed run has it.
    dir.write("m.csv", TABLE_OF_SUBJECTS.replace("S02", "S03"));
    for summary in ["s.csv", "s.ndjson"] {
        dir.run(&format!("batch m.csv --summary {summary} --resume")).succeeded().wrote(&[summary]);
        assert!(dir.text(summary).contains("S03") && !dir.text(summary).contains("S02"));
    }
    // A failed row keeps its columns, too.
    dir.write("broken.osim", "<OpenSimDocument");
    dir.write("m.csv", TABLE_OF_SUBJECTS.replace("S02,human.osim", "S02,broken.osim"));
    dir.run("batch m.csv --summary s.csv --force").failed();
    let lines_of_summary = summary_lines(&dir.text("s.csv"));
    assert_eq!(
        (lines_of_summary[1]["status"].as_str(), lines_of_summary[1]["#subject"].as_str()),
        ("failed", "S02")
    );
}

#[test]
fn all_unknown_columns_are_named_at_once() {
    let dir = TestDir::with_human();
    dir.write("m.csv", "subject,model,target-mas,age,jobs\nS01,human.osim,70,30,2\n");
    dir.run("batch m.csv").usage_error().wrote_nothing().matches_snapshot("batch_unknown_columns");
}
