//! `fit`: recovers the parameters of a measured curve, from the file of any spreadsheet.

use crate::support::{CommandRun, TestDir};
use crate::{assert_close, json_object, number};

/// Number of spheres in the curve. The constants below are its R, E*, α and onset of contact.
const SPHERE_COUNT: f64 = 6.0;
const RADIUS_M: f64 = 0.032;
const MODULUS_N_M2: f64 = 4e5;
const DISSIPATION_S_M: f64 = 0.8;
const ONSET_M: f64 = 0.0005;

/// A curve by (1) with (12): time, indentation, speed and force in SI_UNITS units, while the spheres go in and out again within 0.2 s.
fn measured_curve() -> Vec<[f64; 4]> {
    let half = std::f64::consts::PI / 0.2;
    (0..=40)
        .map(|step| {
            let time = 0.005 * f64::from(step);
            let indentation = 0.0002 + 0.0045 * (half * time).sin().powi(2);
            let speed = 0.0045 * half * (2.0 * half * time).sin();
            let depth = (indentation - ONSET_M).max(0.0);
            let elastic = SPHERE_COUNT * 4.0 / 3.0 * RADIUS_M.sqrt() * MODULUS_N_M2 * depth.powf(1.5);
            [time, indentation, speed, elastic * (1.0 + 1.5 * DISSIPATION_S_M * speed)]
        })
        .collect()
}

/// The curve as CSV text: `units` multiply the columns, `between` separates cells, and `decimal` is the decimal sign.
fn curve_as_csv(header: &str, units: [f64; 4], between: &str, decimal: &str) -> String {
    let mut text = format!("{}\n", header.replace(',', between));
    for row in measured_curve() {
        let cells =
            row.iter().zip(units).map(|(value, unit)| format!("{:?}", value / unit).replace('.', decimal));
        text.push_str(&format!("{}\n", cells.collect::<Vec<_>>().join(between)));
    }
    text
}

const HEADER_OF_MEASUREMENT: &str = "time,indentation,speed,force";
const SI_UNITS: [f64; 4] = [1.0; 4];

fn dir_with_curve() -> TestDir {
    let dir = TestDir::new();
    dir.write("curve.csv", curve_as_csv(HEADER_OF_MEASUREMENT, SI_UNITS, ",", "."));
    dir
}

#[track_caller]
fn assert_true_parameters(run: &CommandRun) {
    let fit = json_object(run);
    let value = |name: &str| number(&fit[name], "value");
    assert_close(value("composite_modulus_n_m2"), MODULUS_N_M2, 1e-9, "E*");
    // (A.4): 2^(3/2) · 4e5 = 8e5 √2.
    assert_close(value("stiffness"), 8e5 * std::f64::consts::SQRT_2, 1e-9, "E1*");
    assert_close(value("dissipation"), DISSIPATION_S_M, 1e-8, "dissipation");
    assert_close(value("onset_m"), ONSET_M, 1e-8, "onset");
    assert_close(number(&fit, "r_squared"), 1.0, 1e-12, "R²");
    // The deepest row: (0.0047 − 0.0005)/0.032; the fastest: 0.0045 π/0.2.
    assert_close(number(&fit, "largest_relative_indentation"), 0.131_25, 1e-7, "x̂");
    assert_close(number(&fit, "largest_speed_m_s"), 0.0045 * std::f64::consts::PI / 0.2, 1e-9, "speed");
    // (13): 1 − α ẋ.
    assert_close(
        number(&fit, "restitution"),
        1.0 - DISSIPATION_S_M * 0.0045 * std::f64::consts::PI / 0.2,
        1e-8,
        "c_r",
    );
    assert_eq!(
        (fit["within_hertz_limit"].as_bool(), fit["within_hunt_crossley_limit"].as_bool()),
        (Some(true), Some(true))
    );
}

const OPTIONS_OF_FIT: &str = "--radius 0.032 --spheres 6 --onset fit --speed-column speed --format json";

#[test]
fn fit_recovers_the_parameters_of_a_curve() {
    let dir = dir_with_curve();
    let run = dir.run(&format!("fit curve.csv {OPTIONS_OF_FIT}")).succeeded().wrote_nothing();
    assert_true_parameters(&run);
    let fit = json_object(&run);
    assert_eq!(fit["schema_version"], 1);
    assert_eq!(fit["file"], "curve.csv");
    assert_eq!((number(&fit, "sphere_count"), number(&fit, "radius_m")), (SPHERE_COUNT, RADIUS_M));
    assert_eq!(fit["parameters"], serde_json::json!(["composite_modulus_n_m2", "dissipation", "onset_m"]));
    assert_eq!(fit["degrees_of_freedom"], 38);
    let covariance = fit["covariance"].as_array().unwrap();
    assert!(covariance.len() == 3 && covariance.iter().all(|row| row.as_array().unwrap().len() == 3));
    let lines: Vec<_> =
        fit["residuals"]["line"].as_array().unwrap().iter().map(|l| l.as_u64().unwrap()).collect();
    assert_eq!(lines, (2..=42).collect::<Vec<_>>());
    // From standard input too.
    assert_true_parameters(
        &dir.run_with_stdin(
            &format!("fit - {OPTIONS_OF_FIT}"),
            &std::fs::read(dir.path("curve.csv")).unwrap(),
        )
        .succeeded(),
    );
}

#[test]
fn units_delimiters_and_decimal_commas_change_nothing() {
    let dir = TestDir::new();
    // A spreadsheet of continental Europe: a byte order mark, ; between cells, decimal commas, CRLF, mm, kN, ms.
    let names = "Zeit,Eindringtiefe,Geschwindigkeit,Kraft";
    let columns = "--indentation-column eindringtiefe --force-column KRAFT --speed-column Geschwindigkeit \
                   --indentation-unit mm --force-unit kN --speed-unit mm/s --radius 0.032 --spheres 6 --onset fit --format json";
    let text = curve_as_csv(names, [1e-3, 1e-3, 1e-3, 1e3], ";", ",").replace('\n', "\r\n");
    dir.write("eu.csv", [b"\xEF\xBB\xBF".as_slice(), text.as_bytes()].concat());
    assert_true_parameters(&dir.run(&format!("fit eu.csv {columns}")).succeeded());
    dir.write("tabs.tsv", curve_as_csv(HEADER_OF_MEASUREMENT, SI_UNITS, "\t", "."));
    assert_true_parameters(&dir.run(&format!("fit tabs.tsv {OPTIONS_OF_FIT}")).succeeded());
    dir.write("comma_tabs.tsv", curve_as_csv(HEADER_OF_MEASUREMENT, SI_UNITS, "\t", ","));
    assert_true_parameters(&dir.run(&format!("fit comma_tabs.tsv {OPTIONS_OF_FIT}")).succeeded());
    dir.write("micro.csv", curve_as_csv(HEADER_OF_MEASUREMENT, [1.0, 1e-6, 1.0, 1e-3], ",", "."));
    assert_true_parameters(
        &dir.run(&format!("fit micro.csv {OPTIONS_OF_FIT} --indentation-unit um --force-unit mN"))
            .succeeded(),
    );
}

#[test]
fn fit_derives_speed_from_time() {
    let dir = TestDir::new();
    dir.write("curve.csv", curve_as_csv(HEADER_OF_MEASUREMENT, [1e-3, 1.0, 1.0, 1.0], ",", "."));
    let options = "--radius 0.032 --spheres 6 --onset 0.0005 --time-column time --time-unit ms --format json";
    let fit = json_object(&dir.run(&format!("fit curve.csv {options}")).succeeded());
    // Differences of 5 ms: sin(2π/40)/(2π/40) = 0.9959 of the speed, so α comes out 0.4 % high.
    assert_close(number(&fit["dissipation"], "value"), DISSIPATION_S_M, 6e-3, "dissipation");
    assert_close(number(&fit["composite_modulus_n_m2"], "value"), MODULUS_N_M2, 1e-3, "E*");
    assert!(fit["onset_m"].is_null(), "it was given");
}

#[test]
fn without_speed_the_branches_give_bounds_of_the_modulus() {
    let dir = dir_with_curve();
    let fit = |branch: &str| {
        let options = "--radius 0.032 --spheres 6 --onset 0.0005 --format json";
        json_object(&dir.run(&format!("fit curve.csv {options} --branch {branch}")).succeeded())
    };
    let modulus = |branch: &str| number(&fit(branch)["composite_modulus_n_m2"], "value");
    // Going in, dissipation adds to the force; coming out it takes away.
    assert!(modulus("loading") > MODULUS_N_M2 && MODULUS_N_M2 > modulus("unloading"));
    let both = fit("both");
    assert!(
        both["dissipation"].is_null()
            && both["restitution"].is_null()
            && both["within_hunt_crossley_limit"].is_null()
    );
    let rows = |branch: &str| fit(branch)["residuals"]["force_n"].as_array().unwrap().len();
    assert_eq!((rows("loading"), rows("unloading"), rows("both")), (21, 20, 41));
}

#[test]
fn fit_reports_the_limits_of_the_laws() {
    let dir = dir_with_curve();
    // The same curve on a sphere of 10 mm: x̂ = 0.42.
    dir.run("fit curve.csv --radius 0.01 --onset 0.0005")
        .succeeded()
        .says(&["outside the limit of the Hertz law (at most 0.16)"]);
    dir.run("fit curve.csv --radius 0.032 --onset 0.0005")
        .succeeded()
        .says(&["within the limit of the Hertz law", "no speed is known"]);
}

#[test]
fn bad_tables_are_refused_with_the_place() {
    let dir = TestDir::new();
    for (text, words) in [
        ("indentation,force\n0.001,1\n0.002,abc\n", ["line 3, column 'force'", "'abc' is not a number"]),
        ("indentation,force\n0.001,1\n0.002,\n", ["line 3, column 'force'", "is empty"]),
        ("indentation,force\n0.001,1\n0.002\n", ["line 3", "1 cell, expected 2"]),
        ("indentation,force\n0.001,nan\n", ["line 2, column 'force'", "'nan'"]),
        ("indentation,force\n\"0,001\",1\n", ["line 2, column 'indentation'", "decimal comma"]),
        ("indentation;force\n1.000,5;1\n", ["line 2, column 'indentation'", "separators between thousands"]),
        ("indentation,force\nm,N\n0.001,1\n", ["line 2, column 'indentation'", "'m' is not a number"]),
        ("depth,load\n0.001,1\n", ["no column 'indentation'", "'depth', 'load'"]),
        ("", ["no column 'indentation'", "nothing"]),
        ("indentation,force\n0.001,1\n", ["1 rows are in contact", "at least 2"]),
        (
            "indentation,force\n0.001,2\n0.002,-4\n0.003,-9\n",
            ["composite modulus", "rises with the indentation"],
        ),
    ] {
        dir.write("bad.csv", text);
        dir.run("fit bad.csv --radius 0.032").failed().says(&["bad.csv: "]).says(&words);
    }
    dir.write("bad.csv", "time,indentation,force\n0,0.001,1\n1,0.002,3\n1,0.003,5\n2,0.003,5\n");
    dir.run("fit bad.csv --radius 0.032 --time-column time").failed().says(&["line 3", "time does not rise"]);
    let utf16: Vec<u8> = "indentation,force\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    dir.write("wide.csv", [b"\xFF\xFE".as_slice(), &utf16].concat());
    dir.run("fit wide.csv --radius 0.032").failed().says(&["UTF-16", "UTF-8"]);
    dir.run("fit nowhere.csv --radius 0.032").failed().says(&["no such file"]);
}

#[test]
fn fit_refuses_wrong_options() {
    let dir = dir_with_curve();
    dir.run("fit curve.csv").usage_error().says(&["--radius"]);
    dir.run("fit curve.csv --radius 0.032 --onset late").usage_error().says(&["--onset 'late'"]);
    dir.run("fit curve.csv --radius 0.032 --speed-column speed --time-column time")
        .usage_error()
        .says(&["--time-column"]);
    dir.run("fit curve.csv --radius 0.032 --force-unit lbf").usage_error().says(&["--force-unit"]);
}

#[test]
fn fit_output_matches_its_snapshots() {
    let dir = TestDir::new();
    // Measured numbers with scatter.
    let scatter = [0.4, -0.3, 0.1, -0.5, 0.6, -0.2, 0.3, -0.4, 0.0, 0.2];
    let mut text = "depth_mm;force_N\n".to_owned();
    for (step, error) in (1..).zip(scatter) {
        let depth = 0.4 * f64::from(step);
        let force = 6.0 * 4.0 / 3.0 * RADIUS_M.sqrt() * MODULUS_N_M2 * (depth * 1e-3).powf(1.5) + error;
        text.push_str(&format!("{depth:.1};{force:.2}\n").replace('.', ","));
    }
    dir.write("heel.csv", text);
    let columns = "--indentation-column depth_mm --indentation-unit mm --force-column force_N";
    dir.run(&format!("fit heel.csv --radius 0.032 --spheres 6 {columns}")).matches_snapshot("physics_fit");
    dir.run(&format!("fit heel.csv --radius 0.032 --spheres 6 {columns} --onset fit"))
        .matches_snapshot("physics_fit_onset");
    dir.write("bad.csv", "indentation,force\n0.001,1\n0.002,abc\n");
    dir.run("fit bad.csv --radius 0.032 --format json").matches_snapshot("physics_fit_bad_cell");
}
