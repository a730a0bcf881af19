//! `motion --correct`: the least correction of a motion with which contacts give the forces of plates. Expected numbers are those of a
//! prototype in OpenSim and Python, on public recordings in the folder `trials` beside the one that OSIM_CORPUS names.

use serde_json::Value;

use crate::support::{TestDir, corpus_folder};
use crate::{json_object, number};

pub(crate) const WALK: [&str; 4] =
    ["2D_gait.osim", "referenceCoordinates.sto", "referenceGRF.sto", "referenceGRF.xml"];
pub(crate) const WALK_CALL: &str =
    "motion 2D_gait.osim referenceCoordinates.sto --plates referenceGRF.sto --loads referenceGRF.xml";
const SUBJECT: [&str; 4] =
    ["subject01.osim", "subject01_walk1_ik.mot", "subject01_walk1_grf.mot", "subject01_walk1_grf.xml"];
pub(crate) const SUBJECT_CALL: &str = "motion feet.osim subject01_walk1_ik.mot --plates subject01_walk1_grf.mot --loads subject01_walk1_grf.xml";

/// A folder with the files of a public trial; `None` after reporting that the test is skipped.
pub(crate) fn trial(test: &str, folder: &str, files: [&str; 4]) -> Option<TestDir> {
    let place = corpus_folder(test)?.join("../trials").join(folder);
    let dir = TestDir::new();
    for file in files {
        dir.write(file, std::fs::read(place.join(file)).unwrap());
    }
    Some(dir)
}

/// Subject 1 with published contacts of this class.
pub(crate) fn subject(test: &str, class: &str) -> Option<TestDir> {
    let dir = trial(test, "subject01_walk_id", SUBJECT)?;
    dir.run(&format!("add subject01.osim --from falisse2022 --class {class} -o feet.osim")).succeeded();
    Some(dir)
}

/// Changes the values of a column whose name contains `column`; `change` takes the part of the time that has passed.
pub(crate) fn change(dir: &TestDir, file: &str, column: &str, change: impl Fn(f64, f64) -> f64) {
    let text = dir.text(file);
    let (head, table) = text.split_once("endheader").unwrap();
    let (names, rows) = table.trim_start().split_once('\n').unwrap();
    let is_changed: Vec<bool> = names.split_ascii_whitespace().map(|name| name.contains(column)).collect();
    assert!(is_changed.contains(&true), "{column}: {names}");
    let last = rows.lines().count() as f64 - 1.0;
    let changed = rows.lines().enumerate().map(|(row, line)| {
        let cells = line.split_ascii_whitespace().zip(&is_changed).map(|(cell, is)| match is {
            true => change(cell.parse().unwrap(), row as f64 / last).to_string(),
            false => cell.to_owned(),
        });
        cells.collect::<Vec<String>>().join("\t") + "\n"
    });
    dir.write(file, format!("{head}endheader\n{names}\n{}", changed.collect::<String>()));
}

#[track_caller]
pub(crate) fn consistency(dir: &TestDir, call: &str, options: &str) -> Value {
    let run = dir.run(&format!("{call} --correct corrected.sto {options} --force --format json"));
    json_object(&run.succeeded())["consistency"].clone()
}

/// The largest of an error of all feet.
#[track_caller]
fn worst(consistency: &Value, name: &str, when: &str) -> f64 {
    let feet = consistency[name].as_array().unwrap();
    feet.iter().map(|foot| number(foot, when)).fold(0.0, f64::max)
}

#[test]
fn a_simulated_walk_hardly_needs_a_correction() {
    let Some(dir) = trial("a simulated walk", "example2DWalking", WALK) else { return };
    for options in ["--vertical", ""] {
        let found = consistency(&dir, WALK_CALL, options);
        assert!(worst(&found, "vertical_rms_bw", "after") <= 0.004, "{found}");
        assert!(
            number(&found, "floor_up_m").abs() <= 1e-4 && number(&found, "lift_p95_m") <= 2e-4,
            "{found}"
        );
        assert!(
            number(&found, "joint_rms_rad").to_degrees() <= 0.1 && found["verdict"] == "agree",
            "{found}"
        );
    }
}

#[test]
fn check_has_the_figures_of_the_correction() {
    let Some(dir) = trial("figures of the correction", "example2DWalking", WALK) else { return };
    let check = WALK_CALL.replace("motion 2D_gait.osim", "check 2D_gait.osim --motion") + " --format json";
    let checked = json_object(&dir.run(&check).succeeded());
    assert_eq!(checked["consistency"], consistency(&dir, WALK_CALL, ""));
}

#[test]
fn a_floor_at_another_height_is_found() {
    for up_m in [-0.02, 0.03, -0.03, 0.06, -0.06] {
        let Some(dir) = trial("a floor at another height", "example2DWalking", WALK) else { return };
        change(&dir, "referenceCoordinates.sto", "pelvis_ty", |value, _| value + up_m);
        for options in ["--vertical", ""] {
            let found = consistency(&dir, WALK_CALL, options);
            assert!((number(&found, "floor_up_m") - up_m).abs() <= 3e-4, "{up_m}: {found}");
            assert!(worst(&found, "vertical_rms_bw", "after") <= 0.005, "{up_m}: {found}");
            assert_eq!(found["verdict"], "agree");
        }
    }
}

#[test]
fn disturbed_joints_are_corrected() {
    let Some(dir) = trial("disturbed joints", "example2DWalking", WALK) else { return };
    let turn = std::f64::consts::TAU;
    let file = "referenceCoordinates.sto";
    change(&dir, file, "pelvis_ty", |value, _| value - 0.02);
    change(&dir, file, "ankle_angle_r/value", |value, part| {
        value + 2.0_f64.to_radians() * (turn * part).sin()
    });
    change(&dir, file, "knee_angle_r/value", |value, part| {
        value + 1.0_f64.to_radians() * (turn * part).cos()
    });
    change(&dir, file, "hip_flexion_l/value", |value, part| {
        value + 0.5_f64.to_radians() * (2.0 * turn * part).sin()
    });
    let found = consistency(&dir, WALK_CALL, "");
    assert!(worst(&found, "vertical_rms_bw", "after") <= 0.006, "{found}");
    assert!((number(&found, "floor_up_m") + 0.0206).abs() <= 1e-3, "{found}");
}

#[test]
fn a_treadmill_walk_is_corrected() {
    for class in ["smooth", "hunt-crossley"] {
        let Some(dir) = subject("a treadmill walk", class) else { return };
        let found = consistency(&dir, SUBJECT_CALL, "");
        assert!(worst(&found, "vertical_rms_bw", "after") <= 0.02, "{found}");
        assert!(worst(&found, "horizontal_rms_bw", "after") <= 0.05, "{found}");
        assert!(number(&found, "cop_rms_m") <= 0.032, "{found}");
        assert!((number(&found, "floor_up_m") - 0.011).abs() <= 0.002, "{found}");
        assert!(number(&found, "lift_rms_m") <= 0.008 && number(&found, "lift_p95_m") <= 0.018, "{found}");
        assert!(number(&found, "joint_rms_rad").to_degrees() <= 5.0, "{found}");
        assert!((found["belt_m_per_s"][0].as_f64().unwrap() + 1.15).abs() <= 0.01, "{found}");
        assert_eq!(found["verdict"], "large-correction");
        let residual = |part: &str, which: &str| number(&found["root_residual"][part], which);
        for (part, most) in [("vertical", 0.13), ("horizontal", 0.33), ("moment", 0.16)] {
            assert!(
                residual(part, "after") <= most && residual(part, "after") < residual(part, "before"),
                "{found}"
            );
        }
        assert!(residual("vertical", "with_plates") <= 0.12, "{found}");
        for (joint, most_n_m) in [("hip", 8.0), ("knee", 5.5), ("ankle", 3.0)] {
            let change_n_m = number(&found["joint_moment_change_nm"], joint);
            assert!(change_n_m > 1.0 && change_n_m <= most_n_m, "{found}");
        }
        // The written files agree with each other: the floor rests, and the plates move with the motion.
        let call =
            "motion feet.osim corrected.sto --plates corrected.plates.sto --loads corrected.plates.xml";
        let again = json_object(&dir.run(&format!("{call} --format json")).succeeded());
        for (foot, errors) in
            again["feet"].as_array().unwrap().iter().zip(found["vertical_rms_bw"].as_array().unwrap())
        {
            let difference = number(&foot["comparison"], "vertical_rms_bw") - number(errors, "after");
            assert!(difference.abs() < 1e-3, "{foot}");
        }
    }
}

/// A corrected motion agrees with the contacts that it was corrected to, whatever they are.
#[test]
fn a_corrected_motion_is_no_evidence() {
    let Some(dir) = trial("a corrected motion", "example2DWalking", WALK) else { return };
    consistency(&dir, WALK_CALL, "");
    let plates = "--plates referenceGRF.sto --loads referenceGRF.xml";
    let says = |call: &str| dir.run(&format!("{call} {plates} --format json")).says(&["no evidence"]);
    says("check 2D_gait.osim --motion corrected.sto");
    says("motion 2D_gait.osim corrected.sto --correct again.sto");
}

/// What is wrong with the plates is named, and nothing is written.
#[test]
fn wrong_plates_are_refused_by_name() {
    let times = |factor: f64| move |value: f64, _| value * factor;
    let refused = |dir: &TestDir, call: &str, words: &str| {
        let run = dir.run(&format!("{call} --correct corrected.sto")).says(&[words]).wrote_nothing();
        assert_eq!(run.status, Some(1), "{words}");
    };
    for (factor, words) in [(0.001, "kN"), (-1.0, "point down")] {
        let Some(dir) = trial("wrong plates", "example2DWalking", WALK) else { return };
        change(&dir, "referenceGRF.sto", "_v", times(factor));
        refused(&dir, WALK_CALL, words);
    }
    let file = "subject01_walk1_grf.mot";
    let Some(dir) = subject("wrong plates", "smooth") else { return };
    let loads = dir.text("subject01_walk1_grf.xml");
    dir.write(
        "subject01_walk1_grf.xml",
        loads.replace("calcn_r", "X").replace("calcn_l", "calcn_r").replace('X', "calcn_l"),
    );
    refused(&dir, SUBJECT_CALL, "are the feet swapped?");
    dir.write("subject01_walk1_grf.xml", loads);
    let plates = dir.text(file);
    change(&dir, file, "torque", times(1000.0));
    refused(&dir, SUBJECT_CALL, "moments in N mm");
    dir.write(file, &plates);
    change(&dir, file, "_p", times(1000.0));
    refused(&dir, SUBJECT_CALL, "points in mm");
    for late_s in [0.02, 0.05, 0.1] {
        dir.write(file, &plates);
        change(&dir, file, "time", |value, _| value + late_s);
        let found = consistency(&dir, SUBJECT_CALL, "");
        let why = found["why"].as_str().unwrap();
        let said: f64 =
            why.split("the plates are ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
        assert!((said - 1e3 * late_s).abs() <= 3.0 && why.contains("ms later"), "{why}");
        assert_eq!(found["verdict"], "disagree");
    }
}

/// Right plates are never wrong: not in a window that is too short for a delay or for the height of a foot, and not beside another name.
#[test]
fn short_windows_accuse_nobody() {
    let Some(dir) = subject("short windows", "smooth") else { return };
    for (start, end) in [(2.207, 2.507), (0.907, 1.357), (1.467, 2.067)] {
        let found = consistency(&dir, SUBJECT_CALL, &format!("--start {start} --end {end}"));
        assert_ne!(found["verdict"], "disagree", "{found}");
    }
    let run = dir.run(&format!("{SUBJECT_CALL} --correct tiny.sto --start 1 --end 1.1"));
    assert!(run.says(&["the motion has 7 rows"]).wrote_nothing().status == Some(1));
}

/// What is said depends on what explains the data: a unit, an axis, a sign of one plate, and a delay that is given already.
#[test]
fn causes_are_those_that_explain_the_plates() {
    let file = "subject01_walk1_grf.mot";
    let Some(dir) = subject("causes of plates", "smooth") else { return };
    let (plates, loads) = (dir.text(file), dir.text("subject01_walk1_grf.xml"));
    let said = |column: &str, change_value: &dyn Fn(f64) -> f64, words: &[&str]| {
        dir.write(file, &plates);
        change(&dir, file, column, |value, _| change_value(value));
        dir.run(&format!("{SUBJECT_CALL} --correct corrected.sto --force --format json"))
            .says(words)
            .says_not(&["kN", "large correction", "on average", "of the model's weight"]);
    };
    said("_v", &|force| force / 9.80665, &["body weights under load: are their forces in kgf or daN?"]);
    said("l_ground_force_v", &|force| -force, &["forces under the left foot point down"]);
    dir.write(file, &plates);
    // Axes that are turned: y up in the file is z.
    dir.write(file, plates.replace("_vy", "_vq").replace("_vz", "_vy").replace("_vq", "_vz"));
    dir.run(&format!("{SUBJECT_CALL} --correct corrected.sto --format json"))
        .says(&["lie along the floor"])
        .says_not(&["kN"]);
    // 50 ms are given already, and not there.
    dir.write(file, &plates);
    let found = consistency(&dir, SUBJECT_CALL, "--plates-delay 0.05");
    let why = found["why"].as_str().unwrap();
    let shift: f64 = why.split("--plates-delay ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
    assert!(shift.abs() < 0.005, "{why}");
    let remarks = |options: &str| {
        let run = dir.run(&format!("{SUBJECT_CALL} {options} --format json")).succeeded();
        json_object(&run)["remarks"].to_string()
    };
    // Heels and forefeet, weighted by the forces of their spheres (OpenSim's places and forces along both motions).
    let said = remarks("--correct c.sto");
    assert!(said.contains("left foot, uncorrected: its centre of pressure"), "{said}");
    let words: Vec<&str> = said.split("heels ").nth(1).unwrap().split(' ').take(12).collect();
    let number = |at: usize| words[at].parse::<f64>().unwrap();
    for (at, expected_mm) in [(0, 4.52), (2, 9.33), (6, 2.72), (10, 8.61)] {
        assert!((number(at) - expected_mm).abs() < 0.1, "{words:?}");
    }
    // Both plates on the right foot: each force is that of the nearest foot, as with the right loads.
    let right = consistency(&dir, SUBJECT_CALL, "");
    dir.write("subject01_walk1_grf.xml", loads.replace("calcn_l", "calcn_r"));
    let found = consistency(&dir, SUBJECT_CALL, "");
    let [found_bw, right_bw] = [&found, &right].map(|one| worst(one, "vertical_rms_bw", "after"));
    assert!((found_bw - right_bw).abs() < 0.01 && found_bw < 0.044, "{found}");
    assert!(remarks("").contains("each force counts for the foot nearest to it"));
    // The belt moves at 1.15 m/s.
    assert!(!remarks("--belt 1.15").contains("against the belt"));
    let said = remarks("--belt 100");
    let speed = said.split("standing feet move at ").nth(1).unwrap().split(' ').next().unwrap();
    assert!(
        (speed.parse::<f64>().unwrap() - 98.85).abs() <= 0.01 && said.contains("against the belt"),
        "{said}"
    );
    // Toes that are locked do not bend.
    assert!(!remarks("--correct a.sto").contains("locked"));
    let text = dir.text("feet.osim");
    let mut parts = text.split("<Coordinate name=\"mtp_angle_");
    let first = parts.next().unwrap().to_owned();
    let locked = parts.map(|part| part.replacen("<locked> false", "<locked> true", 1));
    dir.write(
        "feet.osim",
        std::iter::once(first).chain(locked).collect::<Vec<_>>().join("<Coordinate name=\"mtp_angle_"),
    );
    assert!(remarks("--correct b.sto").contains("mtp_angle_r, mtp_angle_l: locked"));
}

/// A foot whose plate is not in the file was not measured: its force is not 0.
#[test]
fn a_foot_without_a_plate_is_not_compared() {
    let Some(dir) = subject("a foot without a plate", "smooth") else { return };
    let text = dir.text("subject01_walk1_grf.xml");
    let end = text.rfind("<ExternalForce ").unwrap();
    let close = end + text[end..].find("</ExternalForce>").unwrap() + "</ExternalForce>".len();
    dir.write("subject01_walk1_grf.xml", format!("{}{}", &text[..end], &text[close..]));
    let run = dir.run(&format!("{SUBJECT_CALL} --format json")).succeeded();
    let feet = json_object(&run)["feet"].clone();
    let known = feet
        .as_array()
        .unwrap()
        .iter()
        .filter(|foot| foot.get("comparison").is_some_and(|one| !one.is_null()));
    assert_eq!(known.count(), 1, "{feet}");
    dir.run(SUBJECT_CALL).says(&["left foot: its force is not known"]).says_not(&["beside the plates"]);
}

/// A step that the plates miss: the whole body's inertia, whose residual with the plates is 0.12 body weights, says what the foot carries.
#[test]
fn a_step_beside_the_plates_carries_what_the_body_needs() {
    let Some(dir) = subject("a step beside the plates", "smooth") else { return };
    let file = "subject01_walk1_grf.mot";
    let plates = dir.text(file);
    let (head, table) = plates.split_once("endheader").unwrap();
    let (names, rows) = table.trim_start().split_once('\n').unwrap();
    let is_left: Vec<bool> = names.split_ascii_whitespace().map(|name| name.starts_with("l_")).collect();
    let without_step = |row: &str| {
        let cells: Vec<&str> = row.split_ascii_whitespace().collect();
        let is_missed = (1.75..2.9).contains(&cells[0].parse::<f64>().unwrap());
        let cell =
            |(cell, is_left): (&&str, &bool)| if is_missed && *is_left { "0" } else { *cell }.to_owned();
        cells.iter().zip(&is_left).map(cell).collect::<Vec<_>>().join("\t")
    };
    let rows: Vec<String> = rows.lines().map(without_step).collect();
    dir.write("missed.mot", format!("{head}endheader\n{names}\n{}\n", rows.join("\n")));
    consistency(&dir, &SUBJECT_CALL.replace(file, "missed.mot"), "");
    let call = format!(
        "{} --start 2.65 --end 2.85 --format json",
        SUBJECT_CALL.replace("subject01_walk1_ik.mot", "corrected.sto")
    );
    let left = json_object(&dir.run(&call).succeeded())["feet"][1]["comparison"].clone();
    assert!(number(&left, "vertical_rms_bw") < 0.15 && number(&left, "measured_peak_n") > 600.0, "{left}");
}

/// The left foot is on no plate: it stands beside them in all 128 frames in which its own plate carried it, and in few of its other 83.
#[test]
fn a_foot_on_no_plate_stands_beside_them() {
    let Some(dir) = subject("a foot on no plate", "smooth") else { return };
    change(&dir, "subject01_walk1_grf.mot", "l_ground_force", |_, _| 0.0);
    let run = dir.run(&format!("{SUBJECT_CALL} --format json")).succeeded();
    let said = run.out().split("left foot: in ").nth(1).unwrap().split(' ').next().unwrap().to_owned();
    assert!((128..155).contains(&said.parse::<usize>().unwrap()), "{said}");
}

/// On a treadmill slip and lost energy are those of the same walk over ground: the root moves with the belt's speed, 1.15 m/s.
#[test]
fn slip_and_lost_energy_are_against_the_belt() {
    let Some(dir) = subject("a belt that nobody gives", "smooth") else { return };
    let lost = || {
        let motion = json_object(&dir.run(&format!("{SUBJECT_CALL} --format json")).succeeded());
        (number(&motion["feet"][0], "lost_in_stride_j"), motion["remarks"].to_string())
    };
    let (on_belt_j, said) = lost();
    assert!(said.contains("as on a treadmill"), "{said}");
    let table = dir.text("subject01_walk1_ik.mot");
    let rows = table.split_once("endheader").unwrap().1.lines().skip(2);
    let time = |row: &str| row.split_ascii_whitespace().next().unwrap().parse::<f64>().unwrap();
    let (first, last) = (rows.clone().next().map(time).unwrap(), rows.last().map(time).unwrap());
    change(&dir, "subject01_walk1_ik.mot", "pelvis_tx", |value, part| value + 1.15 * (last - first) * part);
    let (over_ground_j, said) = lost();
    assert!(!said.contains("as on a treadmill"), "{said}");
    assert!(
        (on_belt_j - over_ground_j).abs() < 0.1 * over_ground_j.abs() + 1.0,
        "{on_belt_j} {over_ground_j}"
    );
}

/// The spheres of the left foot are 30 mm too high or too low: it is said, and the motion is written all the same. In the simulated walk
/// the left foot is loaded for 47 ms only.
#[test]
fn a_foot_that_is_off_is_said() {
    for (up_m, words) in [(0.03, "the right foot has to go up"), (-0.03, "the left foot has to go up")] {
        let Some(dir) = subject("one foot that is off", "smooth") else { return };
        let Some(walk) = trial("one foot that is off", "example2DWalking", WALK) else { return };
        let moved = |sphere: &str| {
            let (before, rest) = sphere.split_once("<location>").unwrap();
            let (place, after) = rest.split_once("</location>").unwrap();
            let place = place.split_ascii_whitespace().map(|number| number.parse().unwrap());
            let place: Vec<f64> = place.collect();
            format!("{before}<location>{} {} {}</location>{after}", place[0], place[1] + up_m, place[2])
        };
        for (dir, model, call) in [(&dir, "feet.osim", SUBJECT_CALL), (&walk, "2D_gait.osim", WALK_CALL)] {
            let text = dir.text(model);
            let spheres = text.split("<ContactSphere ").map(|sphere| {
                let is_left = sphere.split('>').next().is_some_and(|name| name.ends_with("_l\""));
                if is_left { moved(sphere) } else { sphere.to_owned() }
            });
            dir.write(model, spheres.collect::<Vec<String>>().join("<ContactSphere "));
            let found = consistency(dir, call, "");
            let why = found["why"].as_str().unwrap();
            assert!(found["verdict"] == "disagree" && why.contains(words), "{why}");
            assert!(dir.text("corrected.sto").contains("corrected to contacts"));
        }
        // Of 30 mm, by the cost of the correction.
        let why = consistency(&walk, WALK_CALL, "")["why"].to_string();
        let said = why.split("has to go up by ").nth(1).unwrap().split(' ').next().unwrap();
        assert!((said.parse::<f64>().unwrap() - 30.0).abs() < 5.0, "{why}");
    }
}

/// Smoothed forces far above the floor are 0, whatever the sign that the law gives them.
#[test]
fn a_force_of_nothing_has_no_sign() {
    let Some(dir) = subject("a force of nothing", "smooth") else { return };
    change(&dir, "subject01_walk1_ik.mot", "pelvis_ty", |value, _| value + 1.0);
    dir.run("motion feet.osim subject01_walk1_ik.mot")
        .succeeded()
        .says(&["it never touches"])
        .says_not(&[" -0 "]);
}

/// Without public recordings: the walker of the fixtures has a floor 11 mm too high, and contacts twice as stiff as its plates.
#[test]
fn the_walker_is_corrected_within_a_window() {
    let files = ["walker.osim", "walk.mot", "plates.sto", "plates.xml"];
    let dir = TestDir::with(
        &files.map(|name| (format!("motion/{name}"), name)).each_ref().map(|(from, to)| (from.as_str(), *to)),
    );
    let call = "motion walker.osim walk.mot --plates plates.sto --loads plates.xml";
    let run = dir.run(&format!("{call} --correct corrected.sto --start 0.5 --end 1.7")).succeeded();
    run.says(&[
        "contacts and plates agree",
        "if nothing touched",
        "inverse dynamics: root residual",
        "cannot show that the stiffness is right",
    ]);
    let text = dir.text("corrected.sto");
    assert!(text.contains("corrected to contacts of walker.osim: loaded spheres move"), "{text}");
    let times: Vec<f64> = text.lines().filter_map(|line| line.split('\t').next()?.parse().ok()).collect();
    assert!(
        times[0] >= 0.5 && times.last().is_some_and(|time| *time <= 1.7) && times.len() > 50,
        "{times:?}"
    );
    dir.run("motion walker.osim walk.mot --correct b.sto").usage_error().says(&["--plates"]);
    dir.run(&format!("{call} --correct corrected.txt")).says(&[".sto"]);
    dir.run(&format!("{call} --correct b.sto --start 90")).says(&["no row between"]);
    // Larger usual errors let the motion move further, and a foot that is off is said later.
    let large = format!("{call} --correct b.sto --error 12mm,4deg --format json");
    assert_eq!(json_object(&dir.run(&large).succeeded())["consistency"]["verdict"], "agree");
    dir.run(&format!("{call} --correct c.sto --error 12")).usage_error().says(&["like 6mm,2deg"]);
    let call = call.to_owned() + " --force";
    let fixed =
        json_object(&dir.run(&format!("{call} --correct b.sto --floor -0.011 --format json")).succeeded());
    assert_eq!(fixed["consistency"]["floor_up_m"], -0.011);
}

/// What follows a correction: a folder to track with Moco, and one for NMSM, which has the motion as it was measured.
#[test]
fn folders_for_moco_and_nmsm_are_written() {
    let files = ["walker.osim", "walk.mot", "plates.sto", "plates.xml"];
    let dir = TestDir::with(
        &files.map(|name| (format!("motion/{name}"), name)).each_ref().map(|(from, to)| (from.as_str(), *to)),
    );
    // Toes that point down by 17 degrees at the default pose.
    let ankle = "<Coordinate name=\"ankle_r\"><default_value>";
    dir.write(
        "walker.osim",
        dir.text("walker.osim").replace(&format!("{ankle}0<"), &format!("{ankle}-0.3<")),
    );
    let call = "motion walker.osim walk.mot --plates plates.sto --loads plates.xml";
    dir.run(&format!("{call} --correct corrected.sto --moco moco --nmsm nmsm")).succeeded();
    let (model, script) = (dir.text("moco/model.osim"), dir.text("moco/track.py"));
    assert!(model.contains("SmoothSphereHalfSpaceForce") && !model.contains("HuntCrossleyForce"), "{model}");
    let column = |file: &str, name: &str| -> Vec<f64> {
        let text = dir.text(file);
        let table = text.split("endheader\n").nth(1).unwrap();
        let place = table.lines().next().unwrap().split('\t').position(|column| column == name).unwrap();
        table.lines().skip(1).map(|line| line.split('\t').nth(place).unwrap().parse().unwrap()).collect()
    };
    let height = |model: &str, name: &str| -> f64 {
        let start = format!("<Coordinate name=\"{name}\"><default_value>");
        model.split(&start).nth(1).unwrap().split('<').next().unwrap().parse().unwrap()
    };
    assert_eq!(height(&model, "pelvis_ty"), column("moco/motion.sto", "pelvis_ty")[0]);
    assert!(
        script.contains(
            "\"plates_foot_r\": ([\"/forceset/contact_heel_r\", \"/forceset/contact_ball_r\"], []),"
        ),
        "{script}"
    );
    assert!(script.contains("START, END = 0.0, 2.4\n"), "{script}");
    for folder in ["moco", "nmsm"] {
        let [motion, plates] =
            ["motion", "plates"].map(|file| column(&format!("{folder}/{file}.sto"), "time"));
        assert_eq!(motion, plates);
    }
    assert_eq!(column("nmsm/motion.sto", "pelvis_ty"), vec![0.9323; 241]);
    let flat = dir.text("nmsm/model.osim");
    assert!(height(&flat, "ankle_r").abs() < 1e-3, "{flat}");
    assert_eq!(height(&flat, "ankle_l"), 0.0);
    // All files or none.
    dir.write("moco/plates.xml", "mine");
    std::fs::remove_file(dir.path("corrected.sto")).unwrap();
    dir.run(&format!("{call} --correct corrected.sto --moco moco")).says(&["name with --moco", "--force"]);
    assert!(dir.text("moco/plates.xml") == "mine" && !dir.has("corrected.sto"));
    dir.run(&format!("{call} --moco other")).usage_error().says(&["--correct"]);
}
