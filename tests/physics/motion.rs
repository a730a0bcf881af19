//! `motion`: contact forces along a recorded motion. Expected numbers are computed by hand; `tests/oracle/test_motion.py` compares
//! with OpenSim.

use crate::correct::{SUBJECT_CALL, WALK, WALK_CALL, change, consistency, subject, trial};
use crate::support::{TestDir, fixture};
use crate::{assert_close, json_object};

const FILES_OF_RECORDING: [(&str, &str); 4] = [
    ("motion/walker.osim", "walker.osim"),
    ("motion/walk.mot", "walk.mot"),
    ("motion/plates.sto", "plates.sto"),
    ("motion/plates.xml", "plates.xml"),
];
const CALL_WITH_PLATES: &str = "motion walker.osim walk.mot --plates plates.sto --loads plates.xml";

#[track_caller]
fn assert_refused(dir: &TestDir, arguments: &str, words: &str) {
    let run = dir.run(arguments).says(&[words]).wrote_nothing();
    assert_ne!(run.status, Some(0));
}

/// The cells of the first row about a sphere, with their column names.
fn first_row_of(csv: &str, sphere: &str) -> Vec<(String, String)> {
    let mut lines = csv.lines();
    let names = lines.next().unwrap().split(',').map(str::to_owned);
    let row = lines.find(|line| line.split(',').nth(1) == Some(sphere)).unwrap();
    names.zip(row.split(',').map(str::to_owned)).collect()
}

/// At time 0 the right foot is level, 0.0323 m above the floor, and turns at 0.08 · 2π/1.2 rad/s. So both of its spheres (R 35 mm, 20 mm
/// below the ankle) are 22.7 mm deep, the heel (0.05 m behind) goes in and the ball (0.12 m ahead) comes out.
#[test]
fn the_first_frame_agrees_with_a_hand_calculation() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let csv = dir.run("motion walker.osim walk.mot --format csv").succeeded().wrote_nothing().out();
    let number = |row: &[(String, String)], name: &str| -> f64 {
        row.iter().find(|(column, _)| column == name).unwrap().1.parse().unwrap()
    };
    // 4/3 · 8e6/2^1.5 · √0.035 · 0.0227^1.5 (1 + 3/2 · 0.5 ẋ), ẋ = 0.4188790205 · 0.05 and −0.4188790205 · 0.12.
    for (sphere, x, force) in [("heel_r", -0.05, 2_450.898_891_838), ("ball_r", 0.12, 2_322.027_852_189)] {
        let row = first_row_of(&csv, sphere);
        assert!(
            (number(&row, "centre_x_m") - x).abs() < 1e-12
                && (number(&row, "centre_y_m") - 0.0123).abs() < 1e-9
        );
        assert!((number(&row, "indentation_m") - 0.0227).abs() < 1e-9, "{row:?}");
        // The speed is that of a spline through values of nine digits.
        assert_close(number(&row, "force_y_n"), force, 2e-4, sphere);
        // Without friction only the rounding error of the floor's quarter turn remains.
        assert!(number(&row, "force_x_n").abs() < 1e-9);
    }
    assert_eq!(csv.lines().count(), 1 + 241 * 4);
}

/// Missing rows of plates are reported; where they are missing for long, no force is known.
#[test]
fn missing_rows_of_plates_are_reported_once() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let table = dir.text("plates.sto");
    let without = |missing: &[(f64, f64)]| {
        let is_kept = |line: &&str| match line.split('\t').next().and_then(|cell| cell.parse::<f64>().ok()) {
            Some(time) => !missing.iter().any(|(from, to)| (*from..*to).contains(&time)),
            None => true,
        };
        table.lines().filter(is_kept).map(|line| format!("{line}\n")).collect::<String>()
    };
    let gap_remarks = |text: &str| {
        dir.write("plates.sto", text);
        let run = dir.run(CALL_WITH_PLATES).succeeded().wrote_nothing();
        let text = run.out().split_whitespace().collect::<Vec<_>>().join(" ");
        (text.matches("rows are missing").count(), text)
    };
    assert_eq!(gap_remarks(&table).0, 0);
    let (count, text) = gap_remarks(&without(&[(0.505, 0.795)]));
    assert_eq!(count, 1, "{text}");
    assert!(text.contains("plates.sto: rows are missing in 1 gap from 0.504 to 0.796 s; "), "{text}");
    let (count, text) = gap_remarks(&without(&[(0.505, 0.795), (1.495, 1.505)]));
    assert_eq!(count, 1, "{text}");
    assert!(
        text.contains("2 gaps, the longest from 0.504 to 0.796 s; in gaps above 50 ms no force"),
        "{text}"
    );
    dir.run(
        "fit walker.osim --motion walk.mot --plates plates.sto --loads plates.xml --fit height --dry-run",
    )
    .succeeded()
    .says(&["rows are missing in 2 gaps"]);
}

/// Where the plates have no data, the file of the moved plates has no row: 0 N would be another measurement.
#[test]
fn moved_plates_have_no_rows_without_data() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let time = |line: &str| line.split('\t').next().and_then(|cell| cell.parse::<f64>().ok());
    let plates = dir.text("plates.sto");
    let kept = plates.lines().filter(|line| time(line).is_none_or(|time_s| time_s < 1.6));
    dir.write("part.sto", kept.map(|line| format!("{line}\n")).collect::<String>());
    let call = "motion walker.osim walk.mot --plates part.sto --loads plates.xml --correct c.sto --belt 1";
    dir.run(call).succeeded();
    let last = ["c.sto", "c.plates.sto"].map(|file| time(dir.text(file).lines().last().unwrap()));
    assert_eq!(last, [Some(2.4), Some(1.59)]);
}

/// Neither a few rows nor a motion with a gap can be corrected, and the reason is said.
#[test]
fn too_few_rows_are_not_corrected() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let call = format!("{CALL_WITH_PLATES} --correct c.sto");
    assert_refused(&dir, &format!("{call} --start 0.495 --end 0.565"), "the motion has 7 rows");
    let motion = dir.text("walk.mot");
    let is_kept = |line: &&str| {
        let time = line.split('\t').next().and_then(|cell| cell.parse::<f64>().ok());
        time.is_none_or(|time| !(1.005..1.195).contains(&time))
    };
    dir.write("walk.mot", motion.lines().filter(is_kept).map(|line| format!("{line}\n")).collect::<String>());
    assert_refused(&dir, &call, "the motion has no rows from 1 to 1.2 s");
}

#[test]
fn motion_compares_feet_with_plates() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let run = dir.run(CALL_WITH_PLATES).succeeded().wrote_nothing();
    insta::assert_snapshot!("motion", run.out());
    let motion =
        json_object(&dir.run(&format!("{CALL_WITH_PLATES} --format json")).succeeded().wrote_nothing());
    let feet = motion["feet"].as_array().unwrap();
    assert_eq!(
        feet.iter().map(|foot| foot["name"].as_str().unwrap()).collect::<Vec<_>>(),
        ["right foot", "left foot"]
    );
    for foot in feet {
        // What make_motion.py says that the plates measured: 1048.39 N.
        let peak = foot["comparison"]["measured_peak_n"].as_f64().unwrap();
        assert_close(peak, PLATES_PEAK_N, 1e-3, "peak of the plates");
        assert!(foot["comparison"]["vertical_rms_bw"].as_f64().unwrap() > 2.0);
        assert!(foot["stands_by_plates"].as_bool().unwrap());
        // From the rows of the CSV, outside of this project: the largest F/(pi R x) of the ball, and the sum of -F v over a stride.
        let stress = foot["spheres"][1]["mean_stress_n_m2"].as_f64().unwrap();
        assert_close(stress, 1_092_740.073_751_76, 1e-9, "mean stress");
        assert_close(
            foot["spheres"][1]["peak_stress_n_m2"].as_f64().unwrap(),
            1.5 * stress,
            1e-14,
            "peak stress",
        );
        assert_close(foot["lost_in_stride_j"].as_f64().unwrap(), 6.084_365_783_724_8, 1e-9, "energy lost");
    }
    // Over whole strides the plates carry the weight, within the accuracy of the walker.
    let mean = motion["measured_stride_mean_n"].as_f64().unwrap() / motion["weight_n"].as_f64().unwrap();
    assert!((mean - 1.0).abs() < 0.05, "{mean}");
}

/// The largest force under a foot in `fixtures/motion/plates.sto`, N, computed by NumPy.
const PLATES_PEAK_N: f64 = 1_048.392_9;

/// The program can read the written file as ground reactions, and the forces agree with the model.
#[test]
fn written_reactions_agree_with_the_model() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let run = dir.run("motion walker.osim walk.mot -o made.sto").succeeded();
    assert_eq!(run.changed, ["made.sto", "made.xml"]);
    let second_run =
        dir.run("motion walker.osim walk.mot --plates made.sto --loads made.xml --format json").succeeded();
    let motion = json_object(&second_run);
    for foot in motion["feet"].as_array().unwrap() {
        let comparison = &foot["comparison"];
        assert!(comparison["normal_rms_n"].as_f64().unwrap() < 1e-9, "{comparison}");
        assert!(comparison["cop_rms_m"].as_f64().unwrap() < 1e-9, "{comparison}");
    }
    // Existing files are replaced only with `--force`.
    assert_refused(&dir, "motion walker.osim walk.mot -o made.sto", "made.sto");
    dir.run("motion walker.osim walk.mot -o made.sto --force").succeeded();
    assert_refused(&dir, "motion walker.osim walk.mot -o walk.mot --force", "walk.mot");
    assert_refused(&dir, "motion walker.osim walk.mot -o made.csv", "expected a name that ends in .sto");
}

#[test]
fn wrong_recordings_are_refused_with_a_reason() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let head = "version=1\nendheader\ntime\tankle_r\n";
    let rows = |values: [f64; 6]| -> String {
        values.iter().enumerate().map(|(row, value)| format!("0.{row}\t{value}\n")).collect()
    };
    dir.write("degrees.sto", format!("{head}{}", rows([0.0, 10.0, 20.0, 30.0, 20.0, 10.0])));
    assert_refused(&dir, "motion walker.osim degrees.sto", "--angles");
    dir.run("motion walker.osim degrees.sto --angles degrees").succeeded();
    dir.write("short.sto", format!("{head}0\t0.1\n0.1\t0.2\n"));
    assert_refused(&dir, "motion walker.osim short.sto", "it has 2 rows");
    dir.write("other.sto", "version=1\nendheader\ntime\thip\n0\t0\n");
    assert_refused(&dir, "motion walker.osim other.sto", "none of its columns ('hip') is a coordinate");
    dir.write("words.sto", format!("{head}0\tten\n"));
    assert_refused(
        &dir,
        "motion walker.osim words.sto",
        "words.sto: line 4: column 'ankle_r': 'ten' is not a number",
    );
    let loads = dir.text("plates.xml").replace("_body>ground<", "_body>foot_r<");
    dir.write("turned.xml", loads);
    let turned = CALL_WITH_PLATES.replace("plates.xml", "turned.xml");
    assert_refused(&dir, &turned, "turned.xml: load 'right' is expressed in 'foot_r'");
    dir.write("back.sto", format!("{head}0\t0\n0.2\t0\n0.1\t0\n"));
    assert_refused(&dir, "motion walker.osim back.sto", "back.sto: line 6: its time is 0.1 s, after 0.2 s");
    dir.write("gap.sto", format!("{head}0\t0\n0.1\tnan\n"));
    assert_refused(&dir, "motion walker.osim gap.sto", "gap.sto: line 5: column 'ankle_r' is NaN");
    dir.write(
        "late.sto",
        "version=1\nendheader\ntime ground_force_vx ground_force_vy ground_force_vz\n9 0 1 0\n",
    );
    assert_refused(&dir, "motion walker.osim walk.mot --plates late.sto", "no time in common");
    assert_refused(&dir, "motion walker.osim walk.mot --loads plates.xml", "--plates");
    // A file under the option of the other.
    assert_refused(&dir, "motion walker.osim walk.mot --plates plates.xml", "ExternalLoads go with --loads");
    // So is a check: of a file that is not read, no verdict follows.
    assert_refused(&dir, "check walker.osim --motion walk.mot --plates plates.xml", "go with --loads");
    assert_refused(&dir, "check walker.osim --motion . --plates plates.sto", "this is a folder");
    let no_plates = "check walker.osim --motion walk.mot --plates walk.mot";
    assert_refused(&dir, no_plates, "walk.mot: it has no columns of a force that are known");
    let loads = "motion walker.osim walk.mot --plates plates.sto --loads plates.sto";
    assert_refused(&dir, loads, "plates.sto: it is not XML, expected an ExternalLoads file");
    assert_refused(&dir, "motion walker.osim walk.mot --low-pass 60", "below half of that, 50 Hz");
    assert_refused(&dir, "motion walker.osim nothing.mot", "there is no such file");
    assert_refused(&dir, "motion walker.osim wlk.mot", "did you mean walk.mot?");
    assert_refused(&dir, "motion walker.osim plates.sto", "the motion of this model, not the plates?");
}

/// Plates without pressure points and sides belong to no foot, so the program compares no foot.
#[test]
fn a_plate_without_a_foot_counts_only_in_the_total() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    dir.run("motion walker.osim walk.mot -o own.sto").succeeded();
    let text = dir.text("own.sto").replace("_r_", "_1_").replace("_l_", "_2_").replace("_p", "_unknown_");
    dir.write("forces.sto", text);
    let call = "motion walker.osim walk.mot --plates forces.sto --format json";
    let motion = json_object(&dir.run(call).succeeded());
    assert!(
        motion["feet"][0]["comparison"].is_null() && motion["feet"][1]["comparison"].is_null(),
        "{motion}"
    );
    assert!(motion["comparison"]["vertical_rms_bw"].as_f64().unwrap() < 1e-6, "{motion}");
    for call in [
        "motion walker.osim walk.mot --plates forces.sto --correct c.sto",
        "fit walker.osim --motion walk.mot --plates forces.sto --dry-run",
    ] {
        assert_refused(&dir, call, "an ExternalLoads file says which");
    }
}

/// A plate that measures only noise is left out: each foot keeps the plate that is nearest to it.
#[test]
fn an_idle_plate_does_not_make_feet_unknown() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let idle = |row: usize, line: &str| match row {
        0 => format!("{line}\tground_force_3_vx\tground_force_3_vy\tground_force_3_vz"),
        _ => format!("{line}\t0\t{}\t0", 8 + row % 11),
    };
    let text = dir.text("plates.sto").replace("_r_", "_1_").replace("_l_", "_2_");
    let (head, rows) = text.split_once("endheader\n").unwrap();
    let with_idle: Vec<String> = rows.lines().enumerate().map(|(row, line)| idle(row, line)).collect();
    dir.write("two.sto", &text);
    dir.write("three.sto", format!("{head}endheader\n{}\n", with_idle.join("\n")));
    let motion = |plates: &str| {
        let call = format!("motion walker.osim walk.mot --plates {plates} --format json");
        let mut motion = json_object(&dir.run(&call).succeeded());
        motion["motion"].take();
        motion
    };
    let two = motion("two.sto");
    assert!(two["feet"][0]["comparison"]["cop_rms_m"].is_number(), "{two}");
    assert_eq!(motion("three.sto"), two);
}

/// Plates that are late count earlier by their delay.
#[test]
fn plates_that_are_late_are_shifted() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let text = dir.text("plates.sto");
    let late = |line: &str| match line
        .split_once('\t')
        .and_then(|(time, more)| Some((time.parse::<f64>().ok()?, more)))
    {
        Some((time, more)) => format!("{}\t{more}", time + 0.0625),
        None => line.to_owned(),
    };
    dir.write("late.sto", text.lines().map(late).collect::<Vec<_>>().join("\n"));
    let feet = |plates: &str| {
        let call = format!("motion walker.osim walk.mot --loads plates.xml --plates {plates} --format json");
        json_object(&dir.run(&call).succeeded())["feet"].clone()
    };
    let rms_n = |feet: &serde_json::Value| feet[1]["comparison"]["normal_rms_n"].as_f64().unwrap();
    let (right, late, shifted) =
        (feet("plates.sto"), feet("late.sto"), feet("late.sto --plates-delay 0.0625"));
    assert_close(rms_n(&shifted), rms_n(&right), 1e-9, "shifted");
    assert!((rms_n(&late) / rms_n(&right) - 1.0).abs() > 1e-3, "{late}");
}

/// Plates whose origin lies 150 mm beside that of the motion.
#[test]
fn another_origin_of_the_plates_is_said() {
    let Some(dir) = subject("another origin", "smooth") else { return };
    let why = || consistency(&dir, SUBJECT_CALL, "")["why"].to_string();
    assert!(!why().contains("centres of pressure") && why().contains("as in half of all"), "{}", why());
    change(&dir, "subject01_walk1_grf.mot", "_pz", |value, _| value + 0.15);
    assert!(why().contains("mm apart: have plates and motion the same origin and time?"), "{}", why());
    assert!(!why().contains("as in half of all"), "{}", why());
    // Points in mm are said once, and not of each foot.
    change(&dir, "subject01_walk1_grf.mot", "_pz", |value, _| value - 0.15);
    change(&dir, "subject01_walk1_grf.mot", "_p", |value, _| value * 1000.0);
    let said = dir.run(&format!("{SUBJECT_CALL} --format json")).succeeded().out();
    assert_eq!(said.matches("points in mm").count(), 1, "{said}");
}

/// Fore-aft or sideways forces of the other sign are opposite to what the motion of the body needs.
#[test]
fn a_direction_of_the_plates_with_the_wrong_sign_is_named() {
    let Some(dir) = subject("a wrong sign in one direction", "smooth") else { return };
    let file = "subject01_walk1_grf.mot";
    let plates = dir.text(file);
    for axis in ["x", "z"] {
        dir.write(file, &plates);
        change(&dir, file, &format!("force_v{axis}"), |value, _| -value);
        let run = dir.run(&format!("{SUBJECT_CALL} --correct c.sto --format json")).wrote_nothing();
        assert_eq!(run.status, Some(1), "{axis}");
        run.says(&[&format!("forces along {axis} are opposite to the whole body's acceleration")]);
    }
}

/// Knees of the other sign, as another model has them, are named; right ones are not.
#[test]
fn angles_outside_their_ranges_are_named() {
    let Some(dir) = subject("knees of another sign", "smooth") else { return };
    let json = format!("{SUBJECT_CALL} --format json");
    dir.run(&json).succeeded().says_not(&["outside the range"]);
    change(&dir, "subject01_walk1_ik.mot", "knee_angle", |value, _| -value);
    let names = "knee_angle_r, knee_angle_l";
    let why = consistency(&dir, SUBJECT_CALL, "")["why"].to_string();
    assert!(why.contains(&format!("{names} leave their ranges")), "{why}");
    dir.run(&json).says(&[&format!("{names}: outside the range in most frames")]).says_not(&["jumps"]);
    let file = "subject01_walk1_ik.mot";
    change(&dir, file, "pelvis_rotation", |value, part| if part > 0.5 { value + 360.0 } else { value });
    dir.run(&json).says(&["pelvis_rotation jumps after 2.25 s"]);
}

/// The root of a planar model follows the belt, and sideways forces of the plates do not move it: at 1.2 m/s for 0.47 s.
#[test]
fn a_planar_model_walks_on_a_treadmill() {
    let Some(dir) = trial("a planar model", "example2DWalking", WALK) else { return };
    change(&dir, "referenceCoordinates.sto", "pelvis_tx/value", |value, part| value - 0.564 * part);
    change(&dir, "referenceGRF.sto", "ground_force_r_vz", |_, _| 100.0);
    let found = consistency(&dir, WALK_CALL, "");
    let belt_m_s = [0, 2].map(|axis| found["belt_m_per_s"][axis].as_f64().unwrap());
    assert!((belt_m_s[0] + 1.2).abs() < 0.01 && belt_m_s[1].abs() < 1e-6, "{found}");
}

/// A step beside the plates (7.6 body weights in the model, no force in the plates) does not count as an error of the contacts.
#[test]
fn a_step_beside_the_plates_is_not_compared() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    dir.run("motion walker.osim walk.mot -o own.sto").succeeded().wrote(&["own.sto", "own.xml"]);
    let text = dir.text("own.sto");
    let (head, rows) = text.split_once("endheader\n").unwrap();
    let without_steps = |row: &str| {
        let cells: Vec<&str> = row.split('\t').collect();
        let is_missed = cells[0].parse().is_ok_and(|time: f64| 0.6 < time && time < 1.7);
        let cell_without_step = |(at, cell): (usize, &&str)| {
            if is_missed && (1..10).contains(&at) { "0" } else { *cell }.to_owned()
        };
        cells.iter().enumerate().map(cell_without_step).collect::<Vec<_>>().join("\t")
    };
    let rows: Vec<String> = rows.lines().map(without_steps).collect();
    dir.write("missed.sto", format!("{head}endheader\n{}\n", rows.join("\n")));
    let call = "motion walker.osim walk.mot --plates missed.sto --loads own.xml";
    dir.run(call).succeeded().says(&["right foot: in", "seems to stand beside the plates"]);
    let motion = json_object(&dir.run(&format!("{call} --format json")).succeeded());
    assert_eq!(motion["feet"][0]["stances"].as_array().unwrap().len(), 2, "{motion}");
    let rms_bw = motion["comparison"]["vertical_rms_bw"].as_f64().unwrap();
    assert!(rms_bw < 0.05, "{rms_bw}");
}

/// The seventh verdict is good also for a floor that is too high, a warning for forces in kN, and unknown if the recording is of another model.
#[test]
fn check_judges_contacts_by_a_recording() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let recording = "--motion walk.mot --plates plates.sto";
    let motion_verdict = |model: &str, more: &str| {
        let motion =
            json_object(&dir.run(&format!("check {model} {more} --format json")).succeeded().wrote_nothing());
        let verdicts = motion["verdicts"].as_array().unwrap().clone();
        let verdict = verdicts.iter().find(|one| one["on"] == "motion").cloned();
        (
            verdicts.len(),
            verdict.map(|one| (one["sign"].as_str().unwrap().to_owned(), one["text"].to_string())),
        )
    };
    assert_eq!(motion_verdict("walker.osim", ""), (6, None));
    let (count, verdict) = motion_verdict("walker.osim", recording);
    let (sign, text) = verdict.unwrap();
    assert_eq!((count, sign.as_str()), (7, "good"));
    assert!(text.contains("contacts and plates agree") && text.contains("lower than in the model"), "{text}");
    dir.run(&format!("fit walker.osim {recording} -o fitted.osim")).succeeded();
    assert_eq!(motion_verdict("fitted.osim", recording).1.unwrap().0, "good");
    dir.write("kilonewtons.sto", fixture("motion/kilonewtons.sto"));
    let (_, verdict) = motion_verdict("walker.osim", "--motion walk.mot --plates kilonewtons.sto");
    let (sign, text) = verdict.unwrap();
    assert!(sign == "warning" && text.contains("are their forces in kN?"), "{text}");
    dir.run("motion walker.osim walk.mot --plates kilonewtons.sto").succeeded().says(&["forces in kN?"]);
    let fit = "fit walker.osim --motion walk.mot --plates kilonewtons.sto -o fitted.osim --force";
    dir.run(fit).failed().says(&["are their forces in kN?"]).wrote_nothing();
    dir.write("words.sto", "nothing");
    dir.run("check walker.osim --motion words.sto --plates plates.sto")
        .failed()
        .says(&["no line `endheader`"]);
    dir.write("other.sto", "version=1\nendheader\ntime\thip\n0\t0\n");
    let of_others = motion_verdict("walker.osim", "--motion other.sto --plates plates.sto");
    assert_eq!(of_others.1.unwrap().0, "unknown");
}

#[test]
fn a_motion_plot_shows_model_and_plates() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    dir.run("plot motion walker.osim --motion walk.mot --plates plates.sto -o walk.svg --data walk.csv")
        .succeeded()
        .wrote(&["walk.csv", "walk.svg"]);
    let svg = dir.text("walk.svg");
    for words in ["right foot", "left foot", "\nplates\n", "walker along walk", "indentation / radius"] {
        assert!(svg.contains(words), "{words}");
    }
    // Without plates there is no such curve.
    dir.run("plot motion walker.osim --motion walk.mot -o alone.svg").succeeded();
    assert!(!dir.text("alone.svg").contains("\nplates\n"));
    dir.run("plot motion walker.osim -o none.svg").usage_error().says(&["give --motion FILE"]);
    dir.run("plot drop walker.osim --motion walk.mot -o a.svg").usage_error().says(&["leave out --motion"]);
    dir.run("plot force walker.osim --motion walk.mot -o none.svg").usage_error().says(&["--motion FILE"]);
}

/// The page of `check` shows the recording: a text, the feet, and a figure with a curve for each foot.
#[test]
fn the_report_of_a_check_shows_the_recording() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let call =
        "check walker.osim --motion walk.mot --plates plates.sto --loads plates.xml --report page.html";
    dir.run(call);
    let page = dir.text("page.html");
    for part in [
        "Contacts along the recording",
        "up to 7.6 body weights where the plates measured up to 1.5",
        "centre of pressure on the sole",
        "walk.mot: 241 frames",
        ">7.610<",
    ] {
        assert!(page.replace('\n', " ").contains(part), "{part}");
    }
    dir.run("check walker.osim --report plain.html");
    assert!(!dir.text("plain.html").contains("Contacts along the recording"));
}

/// The page of a fit shows the new contacts beside the plates.
#[test]
fn the_report_of_a_fit_shows_the_recording() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let call = "fit walker.osim --motion walk.mot --plates plates.sto --loads plates.xml -o fitted.osim --report page.html";
    dir.run(call).succeeded();
    let page = dir.text("page.html").replace('\n', " ");
    for part in [
        "Contacts along the recording",
        "Right foot: up to 1.5 body weights where the plates measured up to 1.5",
        "over strides",
    ] {
        assert!(page.contains(part), "{part}");
    }
}

/// The message names the option that figures do not have, not the kind of figure, although `motion` is also a verb.
#[test]
fn an_option_that_a_plot_lacks_is_named() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    dir.run("plot motion walker.osim --motion walk.mot --belt 1 -o a.svg").usage_error().says(&["--belt"]);
    dir.run("plot feet walker.osim --belt 1").usage_error().says(&["--belt"]);
}

/// A model with values that are not finite is refused, because JSON has no such numbers and its schema promises numbers.
#[test]
fn a_model_whose_motion_overflows_is_refused() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let walker = dir.text("walker.osim");
    for (old, new) in [
        ("<radius>0.035", "<radius>5e-324"),
        ("<stiffness>8e+06", "<stiffness>1e308"),
        ("<mass>58.0", "<mass>1e150"),
    ] {
        assert!(walker.contains(old), "{old}");
        dir.write("walker.osim", walker.replace(old, new));
        for call in
            ["motion walker.osim walk.mot --format json", &format!("{CALL_WITH_PLATES} --format json")]
        {
            let run = dir.run(call).wrote_nothing();
            assert!(run.status == Some(1) && run.out().contains("\"error\""), "{new}: {}", run.out());
        }
    }
}
