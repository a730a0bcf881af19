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
    let floors = plan["floor_up_m"].as_array().unwrap();
    assert!(floors.len() == 1 && (floors[0].as_f64().unwrap() + 0.011).abs() < 1e-4, "{plan}");
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
    assert!(plan["floor_up_m"].is_null(), "{plan}");
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

/// Where `plan` puts the centre of a sphere, m.
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

/// The height in the spheres: the floor stays, and they go up in the feet by what the floor would go down.
#[test]
fn a_height_may_be_in_the_spheres() {
    let bench = Bench::with(&FILES);
    let call = format!("{FIT} --height-in spheres");
    let plan =
        object(&bench.run(&format!("{call} -o fitted.osim --format json")).done().wrote(&["fitted.osim"]));
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

/// Where the floor is farther away than spheres may go, they end where they may go.
#[test]
fn spheres_go_down_by_a_quarter_of_a_metre_at_most() {
    let bench = Bench::with(&FILES);
    let text = bench.text("walk.mot");
    let (head, rows) = text.split_once("endheader\n").unwrap();
    let (names, rows) = rows.split_once('\n').unwrap();
    let height = names.split('\t').position(|name| name == "pelvis_ty").unwrap();
    let raised = |row: &str| {
        let mut cells: Vec<String> = row.split('\t').map(str::to_owned).collect();
        cells[height] = (cells[height].parse::<f64>().unwrap() + 0.4).to_string();
        cells.join("\t")
    };
    let rows: Vec<String> = rows.lines().map(raised).collect();
    bench.write("walk.mot", format!("{head}endheader\n{names}\n{}\n", rows.join("\n")));
    let plan = object(&bench.run(&format!("{FIT} --height-in spheres --dry-run --format json")).done());
    let [_, y, _] = new_centre(&plan, "heel_r");
    assert!((y - (-0.02 - 0.25)).abs() < 1e-3, "{y}");
}

/// Slip against a belt, at which alone the horizontal error looks: feet with friction that step in place slip over one.
#[test]
fn a_belt_counts_in_a_fit() {
    let bench = Bench::with(&FILES);
    bench
        .run("set walker.osim static_friction=0.8 dynamic_friction=0.8 -o rough.osim --yes wrong-afterwards")
        .done();
    let error = |more: &str| {
        let call = FIT.replace("walker.osim", "rough.osim");
        let plan = object(&bench.run(&format!("{call} {more} --dry-run --format json")).done());
        plan["errors"]["horizontal_rms_bw"].as_f64().unwrap()
    };
    assert!(error("--belt 1.25") > error("") + 0.1);
    // The same belt from a column of the motion.
    let text = bench.text("walk.mot");
    let (head, rows) = text.split_once("endheader\n").unwrap();
    let (names, rows) = rows.split_once('\n').unwrap();
    let with_belt: String = rows.lines().map(|row| format!("{row}\t1.25\n")).collect();
    bench.write("walk.mot", format!("{head}endheader\n{names}\tbelt\n{with_belt}"));
    assert_eq!(error("--belt-column belt"), error("--belt 1.25"));
    bench.run(&format!("{FIT} --belt-column other --dry-run")).says(&["no column 'other'"]);
    let seen = bench.run("motion rough.osim walk.mot --belt-column belt --format csv").done().out();
    assert_eq!(seen, bench.run("motion rough.osim walk.mot --belt 1.25 --format csv").done().out());
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
    let remarks: Vec<&str> =
        plan["remarks"].as_array().unwrap().iter().map(|remark| remark.as_str().unwrap()).collect();
    assert!(
        remarks.iter().any(|remark| remark.starts_with("the floor of trial 2 goes down by 11.0 mm")),
        "{remarks:?}"
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
    bench.run("fit measured.csv --radius 0.01 --unbounded").usage().says(&["--motion"]);
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
    let remarks = plan["remarks"].to_string();
    assert!(
        remarks.contains("scatters by 36 mm, more than R (34 mm): stiffness is not determined"),
        "{remarks}"
    );
    assert!(remarks.contains("--unbounded"), "{remarks}");
}

/// A table of models: one row is a body with its recording.
#[test]
fn a_table_has_a_recording_for_each_model() {
    let bench = Bench::with(&FILES);
    bench.write(
        "table.csv",
        "model,verb,motion,plates,loads,fit,output\n\
         walker.osim,fit,walk.mot,plates.sto,plates.xml,,all.osim\n\
         walker.osim,fit,walk.mot,plates.sto,plates.xml,height,height.osim\n",
    );
    bench.run("batch table.csv").done().wrote(&["all.osim", "height.osim"]);
    bench.run(&format!("{FIT} -o alone.osim")).done();
    assert_eq!(bench.text("all.osim"), bench.text("alone.osim"));
    assert!(bench.text("height.osim").contains("<stiffness>8e+06"));
    bench.write("table.csv", "model,verb,output\nwalker.osim,fit,other.osim\n");
    bench.run("batch table.csv").says(&["motion"]);
}

/// What the default pose of an ankle is does not count: down is where the floor is while the foot stands.
#[test]
fn the_default_pose_of_an_ankle_does_not_count() {
    let bench = Bench::with(&FILES);
    let text = bench.text("walker.osim");
    let at = text.find("name=\"ankle_r\"").or_else(|| text.find("ankle_r")).unwrap();
    let turned =
        format!("{}{}", &text[..at], text[at..].replacen("<default_value>0<", "<default_value>0.5<", 1));
    assert_ne!(turned, text);
    bench.write("turned.osim", turned);
    let call = FIT.replace("walker.osim", "turned.osim");
    let plan = object(&bench.run(&format!("{call} --height-in spheres --dry-run --format json")).done());
    for sphere in ["heel_r", "ball_r", "heel_l", "ball_l"] {
        let [_, y, _] = new_centre(&plan, sphere);
        assert!((y - (-0.02 + 0.011)).abs() < 2e-4, "{sphere}: {y}");
    }
}

/// Two trials of one body whose floors differ by 20 mm: contacts are shared, floors are not, in whatever the height is.
#[test]
fn each_trial_has_a_floor_of_its_own() {
    let bench = Bench::with(&FILES);
    let text = bench.text("walk.mot");
    let (head, rows) = text.split_once("endheader\n").unwrap();
    let (names, rows) = rows.split_once('\n').unwrap();
    let place = names.split_ascii_whitespace().position(|name| name.ends_with("pelvis_ty")).unwrap();
    let raised = rows.lines().map(|row| {
        let mut cells: Vec<f64> = row.split_ascii_whitespace().map(|cell| cell.parse().unwrap()).collect();
        cells[place] += 0.02;
        cells.iter().map(f64::to_string).collect::<Vec<String>>().join("\t") + "\n"
    });
    bench.write("raised.mot", format!("{head}endheader\n{names}\n{}", raised.collect::<String>()));
    for more in ["", "--height-in spheres"] {
        let call = FIT.replace("--plates", "--motion raised.mot --plates plates.sto --plates");
        let plan = object(&bench.run(&format!("{call} {more} --dry-run --format json")).done());
        assert!(plan["errors"]["vertical_rms_bw"].as_f64().unwrap() < 0.02, "{more}: {plan}");
        assert_close(new_value(&plan, "stiffness"), 4e6, 0.02, "E1*");
        let floors: Vec<f64> =
            plan["floor_up_m"].as_array().unwrap().iter().map(|up| up.as_f64().unwrap()).collect();
        assert!(floors.len() == 2 && (floors[1] - floors[0] - 0.02).abs() < 2e-4, "{more}: {floors:?}");
        let remarks = plan["remarks"].to_string();
        let floor = if more.is_empty() { "trial 2 goes up by 9.0 mm" } else { "trial 2 goes up by 20.0 mm" };
        assert!(
            remarks.contains(floor) && remarks.contains("trial 2: the error of all its feet"),
            "{remarks}"
        );
    }
}

/// The plates knew nothing of the right foot: it is left out, and said; the left one gives the contacts.
#[test]
fn a_foot_that_no_plate_measured_is_left_out() {
    let bench = Bench::with(&FILES);
    let text = bench.text("plates.sto");
    let (head, rows) = text.split_once("endheader\n").unwrap();
    let (names, rows) = rows.split_once('\n').unwrap();
    let is_right: Vec<bool> = names.split_ascii_whitespace().map(|name| name.contains("_r_")).collect();
    assert!(is_right.iter().any(|&is| is), "{names}");
    let emptied = rows.lines().map(|row| {
        let cells = row.split_ascii_whitespace().zip(&is_right);
        cells.map(|(cell, &is)| if is { "0" } else { cell }).collect::<Vec<&str>>().join("\t") + "\n"
    });
    bench.write("plates.sto", format!("{head}endheader\n{names}\n{}", emptied.collect::<String>()));
    let plan = object(&bench.run(&format!("{FIT} --dry-run --format json")).done());
    assert_close(new_value(&plan, "stiffness"), 4e6, 0.01, "E1*");
    let remarks = plan["remarks"].to_string();
    assert!(
        remarks.contains("right foot: left out, because the plates measured no force under it"),
        "{remarks}"
    );
    assert!(remarks.contains("unless a plate is missing"), "{remarks}");
}

#[test]
fn what_a_floor_does_to_others_is_said() {
    let bench = Bench::with(&FILES);
    let plan = object(&bench.run(&format!("{FIT} --select contact_heel_r --dry-run --format json")).done());
    let remarks = plan["remarks"].to_string();
    assert!(remarks.contains("the floor is also that of"), "{remarks}");
}

#[test]
fn words_that_mean_nothing_are_refused() {
    let bench = Bench::with(&FILES);
    bench
        .run(&format!("{FIT} --fit stiffness --height-in spheres"))
        .usage()
        .says(&["no height is fitted", "--height-in"]);
    bench.run(&format!("{FIT} --branch loading")).usage().says(&["--branch"]);
    bench.run(&format!("{FIT} --force-unit kN")).usage().says(&["--force-unit"]);
}
