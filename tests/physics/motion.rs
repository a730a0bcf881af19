//! `motion`: contacts along a recording. `tests/oracle/test_motion.py` compares with OpenSim; here are the numbers that can be had by hand.

use crate::support::Bench;
use crate::{assert_close, object};

const FILES: [(&str, &str); 4] = [
    ("motion/walker.osim", "walker.osim"),
    ("motion/walk.mot", "walk.mot"),
    ("motion/plates.sto", "plates.sto"),
    ("motion/plates.xml", "plates.xml"),
];
const MEASURED: &str = "motion walker.osim walk.mot --plates plates.sto --loads plates.xml";

#[track_caller]
fn refused(bench: &Bench, arguments: &str, words: &str) {
    let ran = bench.run(arguments).says(&[words]).wrote_nothing();
    assert_ne!(ran.status, Some(0));
}

/// The cells of the first row of a sphere.
fn row_of(csv: &str, sphere: &str) -> Vec<(String, String)> {
    let mut lines = csv.lines();
    let names = lines.next().unwrap().split(',').map(str::to_owned);
    let row = lines.find(|line| line.split(',').nth(1) == Some(sphere)).unwrap();
    names.zip(row.split(',').map(str::to_owned)).collect()
}

/// At time 0 the right foot is level, 0.0323 m above the floor, and turns at 0.08 · 2π/1.2 rad/s. So both of its spheres (R 35 mm, 20 mm
/// below the ankle) are 22.7 mm deep, the heel (0.05 m behind) goes in and the ball (0.12 m ahead) comes out.
#[test]
fn the_first_frame_is_known() {
    let bench = Bench::with(&FILES);
    let csv = bench.run("motion walker.osim walk.mot --format csv").done().wrote_nothing().out();
    let number = |row: &[(String, String)], name: &str| -> f64 {
        row.iter().find(|(known, _)| known == name).unwrap().1.parse().unwrap()
    };
    // 4/3 · 8e6/2^1.5 · √0.035 · 0.0227^1.5 (1 + 3/2 · 0.5 ẋ), ẋ = 0.4188790205 · 0.05 and −0.4188790205 · 0.12.
    for (sphere, x, force) in [("heel_r", -0.05, 2_450.898_891_838), ("ball_r", 0.12, 2_322.027_852_189)] {
        let row = row_of(&csv, sphere);
        assert!(
            (number(&row, "centre_x_m") - x).abs() < 1e-12
                && (number(&row, "centre_y_m") - 0.0123).abs() < 1e-9
        );
        assert!((number(&row, "indentation_m") - 0.0227).abs() < 1e-9, "{row:?}");
        // The speed is that of a spline through values of nine digits.
        assert_close(number(&row, "force_y_n"), force, 2e-4, sphere);
        // No friction: what is left is the cosine of the floor's quarter turn.
        assert!(number(&row, "force_x_n").abs() < 1e-9);
    }
    assert_eq!(csv.lines().count(), 1 + 241 * 4);
}

/// Rows of plates that are missing were taken along a straight line, without a word.
#[test]
fn missing_rows_of_plates_are_named_once() {
    let bench = Bench::with(&FILES);
    let table = bench.text("plates.sto");
    let without = |missing: &[(f64, f64)]| {
        let is_kept = |line: &&str| match line.split('\t').next().and_then(|cell| cell.parse::<f64>().ok()) {
            Some(time) => !missing.iter().any(|(from, to)| (*from..*to).contains(&time)),
            None => true,
        };
        table.lines().filter(is_kept).map(|line| format!("{line}\n")).collect::<String>()
    };
    let said = |text: &str| {
        bench.write("plates.sto", text);
        let ran = bench.run(MEASURED).done().wrote_nothing();
        let text = ran.out().split_whitespace().collect::<Vec<_>>().join(" ");
        (text.matches("rows are missing").count(), text)
    };
    assert_eq!(said(&table).0, 0);
    let (count, text) = said(&without(&[(0.505, 0.795)]));
    assert_eq!(count, 1, "{text}");
    assert!(text.contains("plates.sto: rows are missing in 1 gap from 0.504 to 0.796 s; "), "{text}");
    let (count, text) = said(&without(&[(0.505, 0.795), (1.495, 1.505)]));
    assert_eq!(count, 1, "{text}");
    assert!(text.contains("rows are missing in 2 gaps, the longest from 0.504 to 0.796 s"), "{text}");
    bench
        .run(
            "fit walker.osim --motion walk.mot --plates plates.sto --loads plates.xml --fit height --dry-run",
        )
        .done()
        .says(&["rows are missing in 2 gaps"]);
}

#[test]
fn plates_are_compared_and_words_come_first() {
    let bench = Bench::with(&FILES);
    let ran = bench.run(MEASURED).done().wrote_nothing();
    insta::assert_snapshot!("motion", ran.out());
    let seen = object(&bench.run(&format!("{MEASURED} --format json")).done().wrote_nothing());
    let feet = seen["feet"].as_array().unwrap();
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
    }
    // The plates carry the weight, over whole strides, within what the walker was made with.
    let mean = seen["measured_stride_mean_n"].as_f64().unwrap() / seen["weight_n"].as_f64().unwrap();
    assert!((mean - 1.0).abs() < 0.05, "{mean}");
}

/// The largest force under a foot, N, as NumPy has it in `fixtures/motion/plates.sto`.
const PLATES_PEAK_N: f64 = 1_048.392_9;

/// What is written reads back as ground reactions, and agrees with the model that it came from.
#[test]
fn written_reactions_are_those_of_the_model() {
    let bench = Bench::with(&FILES);
    let ran = bench.run("motion walker.osim walk.mot -o made.sto").done();
    assert_eq!(ran.changed, ["made.sto", "made.xml"]);
    let again =
        bench.run("motion walker.osim walk.mot --plates made.sto --loads made.xml --format json").done();
    let seen = object(&again);
    for foot in seen["feet"].as_array().unwrap() {
        let comparison = &foot["comparison"];
        assert!(comparison["normal_rms_n"].as_f64().unwrap() < 1e-9, "{comparison}");
        assert!(comparison["cop_rms_m"].as_f64().unwrap() < 1e-9, "{comparison}");
    }
    // Files that are there stay, unless they may go.
    refused(&bench, "motion walker.osim walk.mot -o made.sto", "made.sto");
    bench.run("motion walker.osim walk.mot -o made.sto --force").done();
    refused(&bench, "motion walker.osim walk.mot -o walk.mot --force", "walk.mot");
    refused(&bench, "motion walker.osim walk.mot -o made.csv", "expected a name that ends in .sto");
}

#[test]
fn what_is_missing_is_said() {
    let bench = Bench::with(&FILES);
    let head = "version=1\nendheader\ntime\tankle_r\n";
    let rows = |values: [f64; 6]| -> String {
        values.iter().enumerate().map(|(row, value)| format!("0.{row}\t{value}\n")).collect()
    };
    bench.write("degrees.sto", format!("{head}{}", rows([0.0, 10.0, 20.0, 30.0, 20.0, 10.0])));
    refused(&bench, "motion walker.osim degrees.sto", "--angles");
    bench.run("motion walker.osim degrees.sto --angles degrees").done();
    bench.write("short.sto", format!("{head}0\t0.1\n0.1\t0.2\n"));
    refused(&bench, "motion walker.osim short.sto", "it has 2 rows");
    bench.write("other.sto", "version=1\nendheader\ntime\thip\n0\t0\n");
    refused(&bench, "motion walker.osim other.sto", "none of its columns ('hip') is a coordinate");
    bench.write("words.sto", format!("{head}0\tten\n"));
    refused(
        &bench,
        "motion walker.osim words.sto",
        "words.sto: line 4: column 'ankle_r': 'ten' is not a number",
    );
    bench.write("back.sto", format!("{head}0\t0\n0.2\t0\n0.1\t0\n"));
    refused(&bench, "motion walker.osim back.sto", "back.sto: line 6: its time is 0.1 s, after 0.2 s");
    bench.write("gap.sto", format!("{head}0\t0\n0.1\tnan\n"));
    refused(&bench, "motion walker.osim gap.sto", "gap.sto: line 5: column 'ankle_r' is NaN");
    bench.write(
        "late.sto",
        "version=1\nendheader\ntime ground_force_vx ground_force_vy ground_force_vz\n9 0 1 0\n",
    );
    refused(&bench, "motion walker.osim walk.mot --plates late.sto", "no time in common");
    refused(&bench, "motion walker.osim walk.mot --loads plates.xml", "--plates");
    refused(&bench, "motion walker.osim walk.mot --low-pass 60", "below half of that, 50 Hz");
    refused(&bench, "motion walker.osim nothing.mot", "there is no such file");
}

/// Of plates without points and sides nobody knows the foot: feet are not compared with nothing.
#[test]
fn a_plate_of_no_foot_counts_in_the_total_alone() {
    let bench = Bench::with(&FILES);
    bench.run("motion walker.osim walk.mot -o own.sto").done();
    let text = bench.text("own.sto").replace("_r_", "_1_").replace("_l_", "_2_").replace("_p", "_unknown_");
    bench.write("forces.sto", text);
    let call = "motion walker.osim walk.mot --plates forces.sto --format json";
    let seen = object(&bench.run(call).done());
    assert!(seen["feet"][0]["comparison"].is_null() && seen["feet"][1]["comparison"].is_null(), "{seen}");
    assert!(seen["comparison"]["vertical_rms_bw"].as_f64().unwrap() < 1e-6, "{seen}");
    refused(
        &bench,
        "fit walker.osim --motion walk.mot --plates forces.sto --dry-run",
        "an ExternalLoads file says it",
    );
}

/// A step beside the plates, 7.6 body weights in the model and none in the plates, is no error of the contacts.
#[test]
fn a_step_beside_the_plates_is_not_compared() {
    let bench = Bench::with(&FILES);
    bench.run("motion walker.osim walk.mot -o own.sto").done().wrote(&["own.sto", "own.xml"]);
    let text = bench.text("own.sto");
    let (head, rows) = text.split_once("endheader\n").unwrap();
    let missed = |row: &str| {
        let cells: Vec<&str> = row.split('\t').collect();
        let is_missed = cells[0].parse().is_ok_and(|time: f64| 0.6 < time && time < 1.7);
        let of = |(at, cell): (usize, &&str)| {
            if is_missed && (1..10).contains(&at) { "0" } else { *cell }.to_owned()
        };
        cells.iter().enumerate().map(of).collect::<Vec<_>>().join("\t")
    };
    let rows: Vec<String> = rows.lines().map(missed).collect();
    bench.write("missed.sto", format!("{head}endheader\n{}\n", rows.join("\n")));
    let call = "motion walker.osim walk.mot --plates missed.sto --loads own.xml";
    bench.run(call).done().says(&["right foot: in", "seems to stand beside the plates"]);
    let seen = object(&bench.run(&format!("{call} --format json")).done());
    assert_eq!(seen["feet"][0]["stances"].as_array().unwrap().len(), 2, "{seen}");
    let rms_bw = seen["comparison"]["vertical_rms_bw"].as_f64().unwrap();
    assert!(rms_bw < 0.05, "{rms_bw}");
}

/// The seventh verdict: before a fit it warns, after it is good, and a recording that cannot be read is not known.
#[test]
fn check_says_whether_contacts_fit_a_recording() {
    let bench = Bench::with(&FILES);
    let recording = "--motion walk.mot --plates plates.sto";
    let verdict = |model: &str, more: &str| {
        let seen = object(&bench.run(&format!("check {model} {more} --format json")).done().wrote_nothing());
        let verdicts = seen["verdicts"].as_array().unwrap().clone();
        let found = verdicts.iter().find(|one| one["on"] == "motion").cloned();
        (verdicts.len(), found.map(|one| (one["sign"].as_str().unwrap().to_owned(), one["text"].to_string())))
    };
    assert_eq!(verdict("walker.osim", ""), (6, None));
    let (count, found) = verdict("walker.osim", recording);
    let (sign, text) = found.unwrap();
    assert_eq!((count, sign.as_str()), (7, "warning"));
    assert!(text.contains("up to 7.61 body weights where the plates measured up to 1.53"), "{text}");
    // What it advises works.
    assert!(text.contains("fit MODEL --motion MOTION --plates PLATES"), "{text}");
    bench.run(&format!("fit walker.osim {recording} -o fitted.osim")).done();
    assert_eq!(verdict("fitted.osim", recording).1.unwrap().0, "good");
    bench.write("words.sto", "nothing");
    assert_eq!(verdict("walker.osim", "--motion words.sto --plates plates.sto").1.unwrap().0, "unknown");
}

#[test]
fn a_figure_has_the_plates_beside_the_model() {
    let bench = Bench::with(&FILES);
    bench
        .run("plot motion walker.osim --motion walk.mot --plates plates.sto -o walk.svg --data walk.csv")
        .done()
        .wrote(&["walk.csv", "walk.svg"]);
    let drawn = bench.text("walk.svg");
    for words in ["right foot", "left foot", "\nplates\n", "walker along walk", "indentation / radius"] {
        assert!(drawn.contains(words), "{words}");
    }
    // Without plates there is no such curve.
    bench.run("plot motion walker.osim --motion walk.mot -o alone.svg").done();
    assert!(!bench.text("alone.svg").contains("\nplates\n"));
    bench.run("plot motion walker.osim -o none.svg").usage().says(&["--motion FILE"]);
    bench.run("plot force walker.osim --motion walk.mot -o none.svg").usage().says(&["--motion FILE"]);
}

/// The page of `check` shows the recording: words, feet, and the figure with a curve of each foot.
#[test]
fn a_report_shows_the_recording() {
    let bench = Bench::with(&FILES);
    let call =
        "check walker.osim --motion walk.mot --plates plates.sto --loads plates.xml --report page.html";
    bench.run(call);
    let page = bench.text("page.html");
    for part in [
        "Contacts along the recording",
        "up to 7.6 body weights where the plates measured up to 1.5",
        "centre of pressure on the sole",
        "walk.mot: 241 frames",
        ">7.610<",
    ] {
        assert!(page.replace('\n', " ").contains(part), "{part}");
    }
    bench.run("check walker.osim --report plain.html");
    assert!(!bench.text("plain.html").contains("Contacts along the recording"));
}

/// The page of a fit shows the new contacts beside the plates.
#[test]
fn the_report_of_a_fit_shows_the_recording() {
    let bench = Bench::with(&FILES);
    let call = "fit walker.osim --motion walk.mot --plates plates.sto --loads plates.xml -o fitted.osim --report page.html";
    bench.run(call).done();
    let page = bench.text("page.html").replace('\n', " ");
    for part in [
        "Contacts along the recording",
        "Right foot: up to 1.5 body weights where the plates measured up to 1.5",
        "over strides",
    ] {
        assert!(page.contains(part), "{part}");
    }
}

/// An option that figures do not have is named, and not the kind of the figure, which is a verb as well.
#[test]
fn an_option_that_a_figure_does_not_have_is_named() {
    let bench = Bench::with(&FILES);
    bench.run("plot motion walker.osim --motion walk.mot --belt 1 -o a.svg").usage().says(&["--belt"]);
    bench.run("plot feet walker.osim --belt 1").usage().says(&["--belt"]);
}

/// JSON has no number for what is not finite, and its schema promises numbers: such a model is refused.
#[test]
fn numbers_beyond_all_measure_are_refused() {
    let bench = Bench::with(&FILES);
    let walker = bench.text("walker.osim");
    for (old, new) in [
        ("<radius>0.035", "<radius>5e-324"),
        ("<stiffness>8e+06", "<stiffness>1e308"),
        ("<mass>58.0", "<mass>1e150"),
    ] {
        assert!(walker.contains(old), "{old}");
        bench.write("walker.osim", walker.replace(old, new));
        for call in ["motion walker.osim walk.mot --format json", &format!("{MEASURED} --format json")] {
            let ran = bench.run(call).wrote_nothing();
            assert!(ran.status == Some(1) && ran.out().contains("\"error\""), "{new}: {}", ran.out());
        }
    }
}
