//! `fit` of a model to a recorded motion recovers known contacts.

use serde_json::Value;

use crate::support::{TestDir, corpus_folder};
use crate::{assert_close, json_object};

pub(crate) const FILES_OF_RECORDING: [(&str, &str); 4] = [
    ("motion/walker.osim", "walker.osim"),
    ("motion/walk.mot", "walk.mot"),
    ("motion/plates.sto", "plates.sto"),
    ("motion/plates.xml", "plates.xml"),
];
pub(crate) const FIT_CALL: &str = "fit walker.osim --motion walk.mot --plates plates.sto --loads plates.xml";

/// The folder of a public recording, or `None` after reporting that the test is skipped.
fn trial_folder(test: &str, name: &str) -> Option<std::path::PathBuf> {
    Some(corpus_folder(test)?.join("../trials").join(name))
}

/// The new value of a property, which is equal in all changes of the plan.
#[track_caller]
fn new_value(plan: &Value, property: &str) -> f64 {
    let changes = plan["changes"].as_array().unwrap().iter().filter(|change| change["property"] == property);
    let values: Vec<f64> = changes.map(|change| change["to"].as_f64().unwrap()).collect();
    assert!(!values.is_empty() && values.iter().all(|value| *value == values[0]), "{property}: {values:?}");
    values[0]
}

/// Reads from a plan how far the floor moves up, m.
#[track_caller]
pub(crate) fn floor_rise_m(plan: &Value) -> f64 {
    let moved =
        plan["changes"].as_array().unwrap().iter().find(|change| change["property"] == "location").unwrap();
    moved["to"][1].as_f64().unwrap() - moved["from"][1].as_f64().unwrap()
}

/// `make_motion.py` computed the plates with E1* 4e6 N/m² (the model has 8e6), α 1.5 s/m (the model has 0.5) and an 11 mm lower floor.
#[test]
fn fit_recovers_known_contacts_from_a_recording() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let plan = json_object(
        &dir.run(&format!("{FIT_CALL} -o fitted.osim --format json")).succeeded().wrote(&["fitted.osim"]),
    );
    assert_close(new_value(&plan, "stiffness"), 4e6, 0.01, "E1*");
    assert_close(new_value(&plan, "dissipation"), 1.5, 0.05, "dissipation");
    assert!((floor_rise_m(&plan) + 0.011).abs() < 1e-4, "{plan}");
    let floors = plan["floor_up_m"].as_array().unwrap();
    assert!(floors.len() == 1 && (floors[0].as_f64().unwrap() + 0.011).abs() < 1e-4, "{plan}");
    let errors = &plan["errors"];
    assert!(errors["vertical_rms_bw"].as_f64().unwrap() < 1e-3, "{errors}");
    assert!(errors["held_out_vertical_rms_bw"].as_f64().unwrap() < 1e-3, "{errors}");
    assert!(errors["null_vertical_rms_bw"].as_f64().unwrap() > 0.5, "{errors}");
    assert!(errors["cop_rms_m"].as_f64().unwrap() < 1e-3, "{errors}");
    // The model that was written agrees with its plates, and a second fit changes nothing that counts.
    let motion = json_object(
        &dir.run("motion fitted.osim walk.mot --plates plates.sto --loads plates.xml --format json")
            .succeeded(),
    );
    assert!(motion["comparison"]["vertical_rms_bw"].as_f64().unwrap() < 1e-3, "{motion}");
    // The fitted contacts are made for the mass of the body, 70 kg.
    let scaled = json_object(&dir.run("fitted.osim --target-mass 560 --dry-run --format json").succeeded());
    assert_close(
        scaled["contacts_mass_kg"]["value"].as_f64().unwrap(),
        70.0,
        1e-12,
        "the mass that the contacts are made for",
    );
    insta::assert_snapshot!(
        "fit_motion",
        dir.run(&format!("{FIT_CALL} --dry-run")).succeeded().wrote_nothing().out()
    );
}

/// The fit begins with a stiffness and dissipation that are ten times too large or too small.
#[test]
fn a_start_that_is_wrong_by_ten_times_leads_to_the_same_fit() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    for factor in ["x10", "x0.1"] {
        dir.run(&format!("set walker.osim stiffness={factor} dissipation={factor} -o wrong.osim --force --yes wrong-afterwards")).succeeded();
        let call = FIT_CALL.replace("walker.osim", "wrong.osim");
        let plan = json_object(&dir.run(&format!("{call} --dry-run --format json")).succeeded());
        assert_close(new_value(&plan, "stiffness"), 4e6, 0.01, factor);
        assert_close(new_value(&plan, "dissipation"), 1.5, 0.05, factor);
        assert!((floor_rise_m(&plan) + 0.011).abs() < 1e-4, "{plan}");
    }
}

/// With a stiffness that is 100 times too small, spheres as deep as their radius, the bound, carry a tenth of the force.
#[test]
fn a_poor_fit_is_only_written_on_request() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    dir.run("set walker.osim stiffness=x0.01 -o soft.osim --yes wrong-afterwards").succeeded();
    let call = FIT_CALL.replace("walker.osim", "soft.osim");
    let call = format!("{call} --fit height -o fitted.osim");
    let refused =
        dir.run(&call).says(&["a model that never touches by 0.768", "--yes poor-fit"]).wrote_nothing();
    assert_eq!(refused.status, Some(1));
    dir.run(&format!("{call} --yes poor-fit")).succeeded().wrote(&["fitted.osim"]);
}

#[test]
fn only_the_named_quantities_are_fitted() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let plan = json_object(&dir.run(&format!("{FIT_CALL} --fit height --dry-run --format json")).succeeded());
    let properties: Vec<&str> = plan["changes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|change| change["property"].as_str().unwrap())
        .collect();
    assert_eq!(properties, ["location"]);
    let plan = json_object(
        &dir.run(&format!("{FIT_CALL} --fit stiffness --fit dissipation --dry-run --format json"))
            .succeeded(),
    );
    assert!(plan["changes"].as_array().unwrap().iter().all(|change| change["property"] != "location"));
    assert!(plan["floor_up_m"].is_null(), "{plan}");
}

/// Spheres keep their different dissipations if only the floor is fitted.
#[test]
fn dissipations_that_differ_between_spheres_stay_if_only_the_floor_is_fitted() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let unequal = dir.text("walker.osim").replacen("<dissipation>0.5", "<dissipation>4", 1);
    dir.write("own.osim", &unequal);
    dir.run("motion own.osim walk.mot -o own.sto").succeeded().wrote(&["own.sto", "own.xml"]);
    let lower = unequal.replacen(
        "<location>0 0 0</location><orientation>",
        "<location>0 -0.005 0</location><orientation>",
        1,
    );
    assert_ne!(unequal, lower);
    dir.write("lower.osim", lower);
    let call = "fit lower.osim --motion walk.mot --plates own.sto --loads own.xml --unbounded --fit height";
    let plan = json_object(&dir.run(&format!("{call} --dry-run --format json")).succeeded());
    assert!((floor_rise_m(&plan) - 0.005).abs() < 2e-6, "{plan}");
    assert!(plan["errors"]["vertical_rms_bw"].as_f64().unwrap() < 1e-3, "{plan}");
}

/// The new centre of a sphere in `plan`, m.
#[track_caller]
fn new_centre(plan: &Value, sphere: &str) -> [f64; 3] {
    let changes = plan["changes"].as_array().unwrap();
    let moved = changes
        .iter()
        .find(|change| {
            change["property"] == "location" && change["sphere"].as_str().unwrap_or("").ends_with(sphere)
        })
        .unwrap_or_else(|| panic!("{sphere}: {plan}"));
    std::array::from_fn(|axis| moved["to"][axis].as_f64().unwrap())
}

/// With `--height-in spheres` the floor stays, and the spheres go up in the feet by as much as the floor would go down.
#[test]
fn the_height_can_be_fitted_by_moving_the_spheres() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let call = format!("{FIT_CALL} --height-in spheres");
    let plan = json_object(
        &dir.run(&format!("{call} -o fitted.osim --format json")).succeeded().wrote(&["fitted.osim"]),
    );
    for sphere in ["heel_r", "ball_r", "heel_l", "ball_l"] {
        let [_, y, _] = new_centre(&plan, sphere);
        assert!((y - (-0.02 + 0.011)).abs() < 2e-4, "{sphere}: {y}");
    }
    let floor = plan["changes"]
        .as_array()
        .unwrap()
        .iter()
        .find(|change| change["property"] == "location" && change["sphere"].is_null());
    assert!(floor.is_none(), "{plan}");
    assert!(plan["errors"]["vertical_rms_bw"].as_f64().unwrap() < 0.01, "{plan}");
}

/// If the floor is too far away, the spheres move by the largest allowed distance.
#[test]
fn spheres_go_down_by_a_quarter_of_a_metre_at_most() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let text = dir.text("walk.mot");
    let (head, rows) = text.split_once("endheader\n").unwrap();
    let (names, rows) = rows.split_once('\n').unwrap();
    let height = names.split('\t').position(|name| name == "pelvis_ty").unwrap();
    let raised = |row: &str| {
        let mut cells: Vec<String> = row.split('\t').map(str::to_owned).collect();
        cells[height] = (cells[height].parse::<f64>().unwrap() + 0.4).to_string();
        cells.join("\t")
    };
    let rows: Vec<String> = rows.lines().map(raised).collect();
    dir.write("walk.mot", format!("{head}endheader\n{names}\n{}\n", rows.join("\n")));
    let plan = json_object(
        &dir.run(&format!("{FIT_CALL} --height-in spheres --dry-run --format json --yes poor-fit"))
            .succeeded(),
    );
    let [_, y, _] = new_centre(&plan, "heel_r");
    assert!((y - (-0.02 - 0.25)).abs() < 1e-3, "{y}");
}

/// Only the horizontal error depends on the slip against a belt: feet with friction that step in place slip over it.
#[test]
fn the_speed_of_a_belt_counts_in_a_fit() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    dir.run("set walker.osim static_friction=0.8 dynamic_friction=0.8 -o rough.osim --yes wrong-afterwards")
        .succeeded();
    let error = |options: &str| {
        let call = FIT_CALL.replace("walker.osim", "rough.osim");
        let plan = json_object(&dir.run(&format!("{call} {options} --dry-run --format json")).succeeded());
        plan["errors"]["horizontal_rms_bw"].as_f64().unwrap()
    };
    assert!(error("--belt 1.25") > error("") + 0.1);
    // The same belt from a column of the motion.
    let text = dir.text("walk.mot");
    let (head, rows) = text.split_once("endheader\n").unwrap();
    let (names, rows) = rows.split_once('\n').unwrap();
    let with_belt: String = rows.lines().map(|row| format!("{row}\t1.25\n")).collect();
    dir.write("walk.mot", format!("{head}endheader\n{names}\tbelt\n{with_belt}"));
    assert_eq!(error("--belt-column belt"), error("--belt 1.25"));
    dir.run(&format!("{FIT_CALL} --belt-column other --dry-run")).says(&["no column 'other'"]);
    let motion = dir.run("motion rough.osim walk.mot --belt-column belt --format csv").succeeded().out();
    assert_eq!(motion, dir.run("motion rough.osim walk.mot --belt 1.25 --format csv").succeeded().out());
}

/// Two recordings of one body have the same contacts. The second recording is the second half of the walk.
#[test]
fn several_trials_share_their_contacts() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let text = dir.text("walk.mot");
    let (head, rows) = text
        .split_once("pelvis_tilt")
        .map(|(head, rest)| (format!("{head}pelvis_tilt"), rest.to_owned()))
        .unwrap();
    let (names, rows) = rows.split_once('\n').unwrap();
    let half: Vec<&str> = rows.lines().skip(120).collect();
    dir.write("second.mot", format!("{head}{names}\n{}\n", half.join("\n")));
    let call = "fit walker.osim --motion walk.mot --motion second.mot --plates plates.sto --plates plates.sto --loads plates.xml";
    let plan = json_object(&dir.run(&format!("{call} --dry-run --format json")).succeeded());
    assert_close(new_value(&plan, "stiffness"), 4e6, 0.01, "E1*");
    let remarks: Vec<&str> =
        plan["remarks"].as_array().unwrap().iter().map(|remark| remark.as_str().unwrap()).collect();
    assert!(
        remarks.iter().any(|remark| remark.starts_with("the floor of trial 2 goes down by 11.0 mm")),
        "{remarks:?}"
    );
    dir.run("fit walker.osim --motion walk.mot --motion second.mot --plates plates.sto")
        .usage_error()
        .says(&["2 motions, 1 tables"]);
}

#[test]
fn options_of_a_curve_and_of_a_recording_are_not_mixed() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    dir.run(&format!("{FIT_CALL} --radius 0.01")).usage_error().says(&["--radius"]);
    dir.run("fit walker.osim --motion walk.mot").usage_error().says(&["--plates"]);
    dir.run("fit walker.osim --plates plates.sto --radius 0.01").usage_error().says(&["--motion"]);
    dir.run("fit measured.csv --radius 0.01 -o other.csv").usage_error().says(&["--motion"]);
    dir.run("fit measured.csv --radius 0.01 --unbounded").usage_error().says(&["--motion"]);
}

/// In a published simulation the ground reactions come from its own contacts. The fit finds E1* within 1 %, α within 5 %, height
/// within 0.1 mm.
#[test]
fn fit_recovers_the_contacts_of_a_simulated_gait() {
    let Some(folder) = trial_folder("fit_recovers_the_contacts_of_a_simulated_gait", "example2DWalking")
    else {
        return;
    };
    let dir = TestDir::new();
    for name in ["2D_gait.osim", "referenceCoordinates.sto", "referenceGRF.sto", "referenceGRF.xml"] {
        dir.write(name, std::fs::read(folder.join(name)).unwrap());
    }
    let call = "fit 2D_gait.osim --motion referenceCoordinates.sto --plates referenceGRF.sto --loads referenceGRF.xml --unbounded";
    let plan = json_object(&dir.run(&format!("{call} --dry-run --format json")).succeeded());
    let stiffness =
        plan["changes"].as_array().unwrap().iter().find(|change| change["property"] == "stiffness").unwrap();
    assert_close(stiffness["to"].as_f64().unwrap(), stiffness["from"].as_f64().unwrap(), 0.01, "E1*");
    assert_close(new_value(&plan, "dissipation"), 2.0, 0.05, "dissipation");
    assert!(floor_rise_m(&plan).abs() < 1e-4, "{plan}");
}

/// The error for a measured gait, without bounds: 0.22 body weights per foot, and 0.35 on the foot that was not fitted, where a model
/// that never touches has 0.66.
#[test]
fn fit_of_a_measured_gait_reaches_the_documented_error() {
    let Some(folder) =
        trial_folder("fit_of_a_measured_gait_reaches_the_documented_error", "subject01_walk_id")
    else {
        return;
    };
    let dir = TestDir::new();
    for name in
        ["subject01.osim", "subject01_walk1_ik.mot", "subject01_walk1_grf.mot", "subject01_walk1_grf.xml"]
    {
        dir.write(name, std::fs::read(folder.join(name)).unwrap());
    }
    dir.run("add subject01.osim --from falisse2022 -o with.osim").succeeded();
    let call = "fit with.osim --motion subject01_walk1_ik.mot --plates subject01_walk1_grf.mot --loads subject01_walk1_grf.xml";
    let fit_errors_of = |model: &str, options: &str| {
        let call = call.replace("with.osim", model);
        let plan = json_object(&dir.run(&format!("{call} {options} --dry-run --format json")).succeeded());
        (
            plan["errors"]["vertical_rms_bw"].as_f64().unwrap(),
            plan["errors"]["held_out_vertical_rms_bw"].as_f64().unwrap(),
            plan,
        )
    };
    let fit_errors = |options: &str| fit_errors_of("with.osim", options);
    // With the dissipation that fits best, 0.43 s/m, instead of 2 s/m; the recording determines neither.
    dir.run("set with.osim dissipation=0.43 -o damped.osim --yes wrong-afterwards").succeeded();
    let (unbounded, held_out, _) = fit_errors_of("damped.osim", "--unbounded");
    assert!(unbounded < 0.2 && held_out < 0.3, "{unbounded} {held_out}");
    let (unbounded, held_out, plan) = fit_errors("--unbounded");
    assert!(unbounded < 0.225 && held_out < 0.355, "{unbounded} {held_out}");
    assert!(plan["changes"].as_array().unwrap().iter().all(|change| change["property"] != "dissipation"));
    let null = plan["errors"]["null_vertical_rms_bw"].as_f64().unwrap();
    assert!((null - 0.661).abs() < 1e-3, "{null}");
    assert!(plan["errors"]["largest_relative_indentation"].as_f64().unwrap() > 1.0);
    // Bounded, it says what that costs.
    let (bounded, _, plan) = fit_errors("--yes poor-fit");
    assert!(
        bounded > unbounded && plan["errors"]["largest_relative_indentation"].as_f64().unwrap() <= 1.0 + 1e-6
    );
    let remarks = plan["remarks"].to_string();
    assert!(
        remarks
            .contains("varies by 36 mm, more than the radius (34 mm): a stiffness fits this recording only"),
        "{remarks}"
    );
    assert!(remarks.contains("a model that never touches has an error of 0.661 body weights"), "{remarks}");
    assert!(remarks.contains("--unbounded"), "{remarks}");
}

/// In a table of models, each row is a body with its own recording.
#[test]
fn a_table_has_a_recording_for_each_model() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    dir.write(
        "table.csv",
        "model,verb,motion,plates,loads,fit,output\n\
         walker.osim,fit,walk.mot,plates.sto,plates.xml,,all.osim\n\
         walker.osim,fit,walk.mot,plates.sto,plates.xml,height,height.osim\n",
    );
    dir.run("batch table.csv").succeeded().wrote(&["all.osim", "height.osim"]);
    dir.run(&format!("{FIT_CALL} -o alone.osim")).succeeded();
    assert_eq!(dir.text("all.osim"), dir.text("alone.osim"));
    assert!(dir.text("height.osim").contains("<stiffness>8e+06"));
    dir.write("table.csv", "model,verb,output\nwalker.osim,fit,other.osim\n");
    dir.run("batch table.csv").says(&["motion"]);
}

/// The default pose of an ankle does not matter, because down is the direction to the floor while the foot is on the floor.
#[test]
fn the_default_pose_of_an_ankle_does_not_matter() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let text = dir.text("walker.osim");
    let at = text.find("name=\"ankle_r\"").or_else(|| text.find("ankle_r")).unwrap();
    let turned =
        format!("{}{}", &text[..at], text[at..].replacen("<default_value>0<", "<default_value>0.5<", 1));
    assert_ne!(turned, text);
    dir.write("turned.osim", turned);
    let call = FIT_CALL.replace("walker.osim", "turned.osim");
    let plan =
        json_object(&dir.run(&format!("{call} --height-in spheres --dry-run --format json")).succeeded());
    for sphere in ["heel_r", "ball_r", "heel_l", "ball_l"] {
        let [_, y, _] = new_centre(&plan, sphere);
        assert!((y - (-0.02 + 0.011)).abs() < 2e-4, "{sphere}: {y}");
    }
}

/// Two trials of one body with floors at heights that differ by 20 mm share the contacts but not the floor, also if spheres move.
#[test]
fn each_trial_has_a_floor_of_its_own() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let text = dir.text("walk.mot");
    let (head, rows) = text.split_once("endheader\n").unwrap();
    let (names, rows) = rows.split_once('\n').unwrap();
    let place = names.split_ascii_whitespace().position(|name| name.ends_with("pelvis_ty")).unwrap();
    let raised = rows.lines().map(|row| {
        let mut cells: Vec<f64> = row.split_ascii_whitespace().map(|cell| cell.parse().unwrap()).collect();
        cells[place] += 0.02;
        cells.iter().map(f64::to_string).collect::<Vec<String>>().join("\t") + "\n"
    });
    dir.write("raised.mot", format!("{head}endheader\n{names}\n{}", raised.collect::<String>()));
    for options in ["", "--height-in spheres"] {
        let call = FIT_CALL.replace("--plates", "--motion raised.mot --plates plates.sto --plates");
        let plan = json_object(&dir.run(&format!("{call} {options} --dry-run --format json")).succeeded());
        assert!(plan["errors"]["vertical_rms_bw"].as_f64().unwrap() < 0.02, "{options}: {plan}");
        assert_close(new_value(&plan, "stiffness"), 4e6, 0.02, "E1*");
        let floors: Vec<f64> =
            plan["floor_up_m"].as_array().unwrap().iter().map(|up| up.as_f64().unwrap()).collect();
        assert!(floors.len() == 2 && (floors[1] - floors[0] - 0.02).abs() < 2e-4, "{options}: {floors:?}");
        let last = plan["errors"]["parameters"].as_array().unwrap().last().unwrap();
        assert!(last["name"] == "floor_2_up_m" && last["value"] == plan["floor_up_m"][1], "{plan}");
        assert_eq!(last["written"], false, "the model has the floor of the first trial: {plan}");
        let remarks = plan["remarks"].to_string();
        let floor =
            if options.is_empty() { "trial 2 goes up by 9.0 mm" } else { "trial 2 goes up by 20.0 mm" };
        assert!(
            remarks.contains(floor) && remarks.contains("trial 2: the error of all its feet"),
            "{remarks}"
        );
    }
}

/// If no plate measured the right foot, a remark says that the foot does not count, and the left foot gives the contacts.
#[test]
fn a_foot_that_no_plate_measured_is_left_out() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let text = dir.text("plates.sto");
    let (head, rows) = text.split_once("endheader\n").unwrap();
    let (names, rows) = rows.split_once('\n').unwrap();
    let is_right: Vec<bool> = names.split_ascii_whitespace().map(|name| name.contains("_r_")).collect();
    assert!(is_right.iter().any(|&is| is), "{names}");
    let emptied = rows.lines().map(|row| {
        let cells = row.split_ascii_whitespace().zip(&is_right);
        cells.map(|(cell, &is)| if is { "0" } else { cell }).collect::<Vec<&str>>().join("\t") + "\n"
    });
    dir.write("plates.sto", format!("{head}endheader\n{names}\n{}", emptied.collect::<String>()));
    let plan = json_object(&dir.run(&format!("{FIT_CALL} --dry-run --format json")).succeeded());
    assert_close(new_value(&plan, "stiffness"), 4e6, 0.01, "E1*");
    let remarks = plan["remarks"].to_string();
    assert!(
        remarks.contains("right foot: left out, because the plates measured no force under it"),
        "{remarks}"
    );
    // It stands beside the plates, whose sum is no weight then.
    assert!(remarks.contains("a foot seems to stand beside the plates"), "{remarks}");
    assert!(!remarks.contains("of the model's weight"), "{remarks}");
    dir.write("plates.sto", &text);
    let call = "motion walker.osim walk.mot --plates plates.sto --loads plates.xml --format json";
    dir.run(&format!("{call} --mass 100")).says(&["kg, unless a plate is missing"]);
    dir.run(&format!("{call} --mass 50")).says(&["of the model's weight"]).says_not(&["is missing"]);
}

#[test]
fn a_moved_floor_of_other_spheres_is_reported() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let plan = json_object(
        &dir.run(&format!("{FIT_CALL} --select contact_heel_r --dry-run --format json --yes poor-fit"))
            .succeeded(),
    );
    let remarks = plan["remarks"].to_string();
    assert!(remarks.contains("the floor is also that of"), "{remarks}");
}

#[test]
fn fit_of_a_motion_refuses_options_without_effect() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    dir.run(&format!("{FIT_CALL} --fit stiffness --height-in spheres"))
        .usage_error()
        .says(&["no height is fitted", "--height-in"]);
    dir.run(&format!("{FIT_CALL} --branch loading")).usage_error().says(&["--branch"]);
    dir.run(&format!("{FIT_CALL} --force-unit kN")).usage_error().says(&["--force-unit"]);
}
