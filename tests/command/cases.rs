//! Models that an earlier version judged wrongly, as users found. Each is a folder in the folder that OSIM_CASES names, and its README
//! has the expected judgement.

use std::collections::BTreeSet;
use std::path::PathBuf;

use serde_json::Value;

use crate::support::{TestDir, corpus_folder, fixture, report_skip};

/// A folder with copies of the files of a case; `None` after reporting that the test is skipped.
pub(crate) fn dir_of_case(name: &str) -> Option<TestDir> {
    let folder = std::env::var_os("OSIM_CASES").map(PathBuf::from).filter(|folder| folder.is_dir());
    let Some(folder) = folder else {
        report_skip(name, "OSIM_CASES is not set to the folder of cases");
        return None;
    };
    let dir = TestDir::new();
    for entry in std::fs::read_dir(folder.join(name)).unwrap().map(|entry| entry.unwrap()) {
        dir.write(entry.file_name().to_str().unwrap(), std::fs::read(entry.path()).unwrap());
    }
    Some(dir)
}

pub(crate) fn check_json(dir: &TestDir, arguments: &str) -> Value {
    let run = dir.run(&format!("check {arguments} --format json"));
    serde_json::from_str(&run.out()).unwrap_or_else(|error| panic!("{error}: {}{}", run.out(), run.err()))
}

/// The codes of the findings with this severity.
pub(crate) fn codes_of_severity<'r>(report: &'r Value, severity: &str) -> BTreeSet<&'r str> {
    let findings = report["findings"].as_array().unwrap().iter();
    let of_severity = findings.filter(|finding| finding["severity"] == severity);
    of_severity.map(|finding| finding["code"].as_str().unwrap()).collect()
}

#[track_caller]
fn assert_no_error_or_warning(report: &Value) {
    assert_eq!(
        [codes_of_severity(report, "error"), codes_of_severity(report, "warning")],
        [BTreeSet::new(), BTreeSet::new()]
    );
}

fn verdict_sign<'r>(report: &'r Value, on: &str) -> &'r Value {
    &report["verdicts"].as_array().unwrap().iter().find(|verdict| verdict["on"] == on).unwrap()["sign"]
}

pub(crate) fn finding_with_code<'r>(report: &'r Value, code: &str) -> &'r Value {
    report["findings"].as_array().unwrap().iter().find(|finding| finding["code"] == code).unwrap()
}

#[test]
fn a_verdict_that_warns_counts_as_a_warning() {
    let files = [
        ("motion/walker.osim", "walker.osim"),
        ("motion/walk.mot", "walk.mot"),
        ("motion/kilonewtons.sto", "plates.sto"),
    ];
    let dir = TestDir::with(&files);
    let call = "walker.osim --motion walk.mot --plates plates.sto";
    let report = check_json(&dir, call);
    assert_eq!(
        (verdict_sign(&report, "motion"), &report["counts"]["warning"]),
        (&"warning".into(), &1.into())
    );
    let row =
        report["verdicts"].as_array().unwrap().iter().find(|verdict| verdict["on"] == "motion").unwrap();
    assert_eq!(row["codes"][0], finding_with_code(&report, "unlike-recording")["code"]);
    dir.run(&format!("check {call} --deny warning")).failed();
}

#[test]
fn no_verdict_is_good_while_spheres_are_left_behind() {
    let Some(dir) = dir_of_case("left-behind-no-command") else { return };
    let report = check_json(&dir, "scaled.osim --from generic.osim");
    assert_eq!(verdict_sign(&report, "sizes"), "error");
    assert_eq!(verdict_sign(&report, "solver"), "warning");
    assert_ne!(verdict_sign(&report, "standing"), "good");
    assert_eq!(finding_with_code(&report, "spheres-left-behind")["spheres"].as_array().unwrap().len(), 6);
    // The original has warnings of its own, which are no reason to print no command.
    let command = report["commands"][0].as_str().unwrap().strip_prefix("osim-contact-scale ").unwrap();
    dir.run(command).succeeded();
    let right = check_json(&dir, "scaled.fixed-1.osim --from generic.osim");
    assert_eq!(codes_of_severity(&right, "error"), BTreeSet::new());
}

#[test]
fn places_that_differ_only_by_rounding_count_as_equal() {
    let Some(dir) = dir_of_case("places-rounded") else { return };
    for model in ["scaled", "scaled_exact"] {
        let report = check_json(&dir, &format!("{model}.osim --from generic.osim"));
        assert!(codes_of_severity(&report, "error").contains("spheres-left-behind"), "{model}");
        let command = report["commands"][0].as_str().unwrap().strip_prefix("osim-contact-scale ").unwrap();
        dir.run(&format!("{command} -o {model}_right.osim")).succeeded();
        let report = check_json(&dir, &format!("{model}_right.osim --from generic.osim"));
        assert_no_error_or_warning(&report);
    }
}

#[test]
fn spheres_on_hands_are_not_on_feet() {
    let Some(dir) = dir_of_case("hands") else { return };
    let report = check_json(&dir, "model.osim");
    let found = finding_with_code(&report, "spheres-misplaced");
    assert_eq!(found["severity"], "warning");
    assert!(found["message"].as_str().unwrap().contains("hand_l, hand_r"), "{found}");
}

#[test]
fn the_size_of_bones_without_meshes_follows_from_joints() {
    let Some(dir) = dir_of_case("scaled_without_meshes") else { return };
    assert!(codes_of_severity(&check_json(&dir, "model.osim"), "warning").contains("spheres-misplaced"));
}

#[test]
fn the_reported_distance_is_the_distance_that_spheres_move() {
    let files = [
        ("scale_tool/generic_smooth.osim", "generic.osim"),
        ("scale_tool/scaled_smooth.osim", "scaled.osim"),
    ];
    let dir = TestDir::with(&files);
    let report = check_json(&dir, "scaled.osim --from generic.osim");
    let message = finding_with_code(&report, "spheres-left-behind")["message"].as_str().unwrap().to_owned();
    let command = report["commands"][0].as_str().unwrap().strip_prefix("osim-contact-scale ").unwrap();
    dir.run(&format!("{command} -o right.osim")).succeeded();
    let place = |model: &str| -> Vec<f64> {
        let out = dir.run(&format!("inspect {model} --format json")).succeeded().out();
        let inspection: Value = serde_json::from_str(&out).unwrap();
        let spheres = inspection["spheres"].as_array().unwrap().clone();
        let heel = spheres.iter().find(|sphere| sphere["name"] == "heel_r").unwrap();
        heel["location_m"].as_array().unwrap().iter().map(|value| value.as_f64().unwrap()).collect()
    };
    let moved: f64 =
        place("scaled.osim").iter().zip(place("right.osim")).map(|(a, b)| (a - b) * (a - b)).sum();
    assert!(
        message.contains(&format!("{:.2} mm, heel_r", 1e3 * moved.sqrt())),
        "{message}, moved by {}",
        moved.sqrt()
    );
}

#[test]
fn a_body_of_too_high_density_causes_a_remark() {
    let Some(dir) = dir_of_case("mass-against-length") else { return };
    let report = check_json(&dir, "scaled.osim --from generic.osim");
    let message = finding_with_code(&report, "mass-against-length")["message"].as_str().unwrap();
    assert!(message.contains("0.35") && message.contains("0.0429") && message.contains("8.16"), "{message}");
    assert!(codes_of_severity(&report, "remark").contains("mass-against-length"));
    dir.run("transfer scaled.osim --from generic.osim --follow-bodies -o right.osim").succeeded();
    assert!(
        codes_of_severity(&check_json(&dir, "right.osim --from generic.osim"), "remark")
            .contains("mass-against-length")
    );
}

#[test]
fn a_torso_without_mass_is_named_and_no_command_hides_it() {
    let Some(dir) = dir_of_case("mass_zero_torso") else { return };
    let report = check_json(&dir, "model.osim");
    assert!(finding_with_code(&report, "massless-body")["place"].as_str().unwrap().ends_with("/torso"));
    assert_eq!(report["commands"], Value::Array(Vec::new()));
}

#[test]
fn a_plate_below_the_floor_does_not_count_as_part_of_the_body() {
    let Some(dir) = dir_of_case("plate_counts_as_body") else { return };
    let report = check_json(&dir, "model.osim");
    assert_no_error_or_warning(&report);
    assert_eq!(report["commands"], Value::Array(Vec::new()));
}

#[test]
fn a_radius_in_feet_causes_a_warning() {
    let Some(dir) = dir_of_case("radius_in_feet") else { return };
    assert_eq!(codes_of_severity(&check_json(&dir, "model.osim"), "warning"), BTreeSet::from(["odd-radius"]));
}

#[test]
fn published_values_cause_no_warning_if_another_number_changed() {
    let Some(dir) = dir_of_case("dhondt_friction_changed") else { return };
    assert_no_error_or_warning(&check_json(&dir, "model.osim"));
}

#[test]
fn a_tilted_default_pose_alone_is_no_error() {
    let Some(dir) = dir_of_case("tilted_pose_sunk_in") else { return };
    assert_no_error_or_warning(&check_json(&dir, "model.osim"));
}

#[test]
fn spheres_without_a_force_are_reported() {
    let Some(dir) = dir_of_case("left_forces_deleted") else { return };
    let found = check_json(&dir, "model.osim");
    let found = finding_with_code(&found, "one-side-only");
    assert_eq!((&found["severity"], found["spheres"].as_array().unwrap().len()), (&"warning".into(), 6));
}

#[test]
fn spheres_that_leave_the_floor_are_refused_without_level() {
    let Some(dir) = dir_of_case("unlike-radii-level") else { return };
    let run = dir.run("model.osim --target-mass 8 -o out.osim").failed().wrote_nothing();
    assert!(run.err().contains("sunk-in"), "{}", run.err());
    dir.run("model.osim --target-mass 8 --level -o out.osim").succeeded();
    // Also where the feet lean, so that lower spheres sink in before, too.
    let model = dir.text("model.osim");
    let (before, after) = model.split_once("name=\"pelvis_tilt\"").unwrap();
    let leaning = after.replacen("<default_value>0<", "<default_value>0.1<", 1);
    dir.write("leaning.osim", format!("{before}name=\"pelvis_tilt\"{leaning}"));
    let run = dir.run("leaning.osim --target-mass 8 -o leaning8.osim").failed().wrote_nothing();
    assert!(run.err().contains("sunk-in") && run.err().contains("with --level"), "{}", run.err());
    dir.run("leaning.osim --target-mass 8 --level -o leaning8.osim").succeeded();
}

#[test]
fn contacts_of_an_adult_under_a_child_are_reported() {
    let Some(dir) = dir_of_case("child_with_adult_contacts_is_not_good") else { return };
    let report = check_json(&dir, "model.osim");
    assert_eq!(verdict_sign(&report, "mass"), "warning");
    assert!(codes_of_severity(&report, "warning").contains("contacts-of-another-mass"));
    dir.run("model.osim --target-mass 30 -o out.osim").failed().wrote_nothing();
}

#[test]
fn a_light_sensor_on_a_body_causes_no_warning() {
    let Some(dir) = dir_of_case("mass_01_percent") else { return };
    assert_no_error_or_warning(&check_json(&dir, "model.osim"));
}

#[test]
fn a_reference_whose_spheres_do_not_fit_its_bones_is_refused() {
    let Some(dir) = dir_of_case("reference_of_another_mass_is_asked") else { return };
    for mass in ["", "--reference-mass 62"] {
        let call = format!("transfer m52.osim --from m75.osim {mass} --follow-bodies -o out.osim");
        dir.run(&call).failed().wrote_nothing();
    }
    dir.run("m75.osim --target-mass 80 -o out.osim").failed().wrote_nothing();
    dir.run("transfer m52.osim --from generic.osim --follow-bodies -o out.osim").succeeded();
}

#[test]
fn scaled_models_in_a_folder_are_asked_about() {
    let names = ["generic_hunt_crossley", "generic_smooth", "scaled_hunt_crossley", "scaled_smooth"];
    let dir = TestDir::new();
    for name in names {
        dir.write(&format!("models/{name}.osim"), fixture(&format!("scale_tool/{name}.osim")));
    }
    let run = dir.run("models --target-mass 80 -d results").failed();
    let written = names.map(|name| dir.has(&format!("results/{name}.osim")));
    assert_eq!(written, [true, true, false, false], "{}", run.err());
    assert!(run.err().contains("transfer MODEL --from GENERIC --follow-bodies --level"), "{}", run.err());
}

#[test]
fn a_model_with_one_leg_gets_the_contacts_of_one_side() {
    let Some(dir) = dir_of_case("one-leg-add") else { return };
    let run = dir.run("add model.osim --from falisse2022 -o out.osim").failed().wrote_nothing();
    assert!(run.err().contains("--reference-select \"*_r\""), "{}", run.err());
    dir.run("add model.osim --from falisse2022 --reference-select *_r -o out.osim").succeeded();
}

#[test]
fn a_model_without_contacts_is_not_asked_about_a_mass() {
    let Some(dir) = dir_of_case("questions-out-of-order") else { return };
    let run = dir.run("model.osim --target-mass 62000 -o out.osim").failed().wrote_nothing();
    assert!(run.err().contains("no contacts"), "{}", run.err());
}

#[test]
fn a_place_that_the_run_corrects_causes_no_warning() {
    let Some(dir) = dir_of_case("stale-warning-after-transfer") else { return };
    let run = dir.run("transfer scaled.osim --from generic.osim --follow-bodies -o out.osim").succeeded();
    assert!(!(run.out() + &run.err()).contains("odd-place"));
    assert!(!codes_of_severity(&check_json(&dir, "out.osim"), "warning").contains("odd-place"));
}

#[test]
fn a_pair_that_is_pressed_many_times_is_refused_at_once() {
    let Some(dir) = dir_of_case("convert_out_of_memory") else { return };
    let run = dir.run("convert model.osim --to smooth -o out.osim").failed().wrote_nothing();
    run.says(&["/forceset/", "floor", "s0", "this pair 62500 times", "--exclude"]);
}

#[test]
fn content_of_forces_that_convert_drops_is_named() {
    let Some(dir) = dir_of_case("convert_loses_content") else { return };
    dir.run("convert --to hunt-crossley model.osim -o out.osim")
        .succeeded()
        .says(&["the comment 'tuned by hand in 2023: do not touch', <components>, <my_property>"]);
}

#[test]
fn an_error_has_nothing_of_an_included_file() {
    let Some(dir) = dir_of_case("include_prints_first_line") else { return };
    dir.write("inside/model.osim", dir.read("model.osim"));
    for secret in [
        "secret: 1234\n".to_owned(),
        "<secret>1234</secret>".to_owned(),
        "<a><secret></a>".to_owned(),
        "<OpenSimDocument Version=\"secret\"><ForceSet/></OpenSimDocument>".to_owned(),
        "<OpenSimDocument Version=\"40000\"><secret/></OpenSimDocument>".to_owned(),
    ] {
        dir.write("README.md", &secret);
        let run = dir.run("check inside/model.osim").failed();
        assert!(!(run.out() + &run.err()).contains("secret"), "{secret}: {}", run.err());
    }
}

#[cfg(unix)]
#[test]
fn unusual_friction_is_reported() {
    for (case, code, severity) in [
        ("friction_swapped", "dynamic-above-static", "warning"),
        ("transition_velocity_mm", "odd-transition-velocity", "warning"),
        ("transition-velocity-zero", "odd-transition-velocity", "remark"),
    ] {
        let Some(dir) = dir_of_case(case) else { return };
        let report = check_json(&dir, "model.osim");
        assert_eq!(finding_with_code(&report, code)["severity"], severity, "{case}");
        assert_eq!(codes_of_severity(&report, "error"), BTreeSet::new(), "{case}");
    }
}

#[test]
fn a_transition_velocity_of_zero_is_scaled() {
    let Some(dir) = dir_of_case("transition-velocity-zero") else { return };
    let run = dir.run("check model.osim --full");
    assert!(!(run.out() + &run.err()).contains("NaN"));
    dir.run("model.osim --target-mass 30 --friction -o out.osim").succeeded();
    assert!(codes_of_severity(&check_json(&dir, "out.osim"), "remark").contains("odd-transition-velocity"));
}

#[test]
fn a_force_without_a_floor_is_reported() {
    let Some(dir) = dir_of_case("hc_force_without_floor") else { return };
    let report = check_json(&dir, "model.osim");
    let found = finding_with_code(&report, "no-surfaces-meet");
    assert_eq!(found["severity"], "warning");
    assert!(found["place"].as_str().unwrap().ends_with("foot_r"), "{found}");
}

#[test]
fn a_floor_that_is_named_twice_is_reported() {
    let (Some(dir), Some(corpus)) =
        (dir_of_case("floor_between_spheres"), corpus_folder("floor_between_spheres"))
    else {
        return;
    };
    let text = std::fs::read_to_string(corpus.join("v40000_scone_h0914m.osim")).unwrap();
    assert!(text.contains("platform r_heel r_toe"));
    dir.write("model.osim", text.replace("platform r_heel r_toe", "platform r_heel platform r_toe"));
    let report = check_json(&dir, "model.osim");
    let found = finding_with_code(&report, "surface-named-twice");
    assert_eq!(found["severity"], "warning");
    assert!(found["message"].as_str().unwrap().contains("platform"), "{found}");
}

#[test]
fn a_stiffness_that_no_solver_can_handle_is_reported() {
    let Some(dir) = dir_of_case("hc_stiffness_1e300") else { return };
    let report = check_json(&dir, "model.osim");
    assert!(codes_of_severity(&report, "warning").contains("too-stiff"), "{report}");
}
