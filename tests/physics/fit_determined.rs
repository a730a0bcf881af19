//! What `fit` says and writes of what recordings do not determine, and its errors of each foot.

use crate::fit_motion::{FILES_OF_RECORDING, FIT_CALL, floor_rise_m};
use crate::support::TestDir;
use crate::{json_object, number};

/// Two feet that stand still: their force F = 8/3 E* √R d^(3/2) depends on stiffness and depth together, and not on the dissipation.
/// Half of 70 kg on each foot presses its spheres 3.89667 mm into contacts of 8e6 N/m² (Python); the floor of the model is 22.7 mm up.
#[test]
fn what_a_recording_does_not_determine_stays_as_it_is_in_the_model() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    let foot = "0\t343.23275\t0\t0.035\t0\t0\t0\t0\t0";
    for (file, row) in
        [("walk.mot", "0\t0\t0.9323\t0\t0\t0\t0"), ("plates.sto", format!("{foot}\t{foot}").as_str())]
    {
        let text = dir.text(file);
        let (head, rows) = text.split_once("endheader\n").unwrap();
        let names = rows.lines().next().unwrap();
        let rows: String = (0..50).map(|frame| format!("{}\t{row}\n", f64::from(frame) / 100.0)).collect();
        dir.write(file, format!("{head}endheader\n{names}\n{rows}"));
    }
    let plan = json_object(&dir.run(&format!("{FIT_CALL} --dry-run --format json")).succeeded());
    let changes = plan["changes"].as_array().unwrap();
    assert!(changes.iter().all(|change| change["property"] == "location"), "{plan}");
    assert!((floor_rise_m(&plan) - (0.003_896_67 - 0.022_7)).abs() < 2e-6, "{plan}");
    assert!(number(&plan["errors"], "vertical_rms_bw") < 1e-3, "{plan}");
    let parameters = plan["errors"]["parameters"].as_array().unwrap();
    let names: Vec<(&str, bool)> = parameters
        .iter()
        .map(|one| (one["name"].as_str().unwrap(), one["written"].as_bool().unwrap()))
        .collect();
    assert_eq!(
        names,
        [("floor_up_m", true), ("stiffness_factor", false), ("dissipation_s_m", false)],
        "{plan}"
    );
    // Spheres as deep as their radius, the bound, need (3.89667/35)^(3/2) of the stiffness.
    let low = number(&parameters[1], "low");
    assert!((0.036..0.041).contains(&low) && number(&parameters[1], "high") > 3.0, "{plan}");
    assert!(number(&parameters[2], "high") - number(&parameters[2], "low") > 9.0, "{plan}");
    let pairs = plan["errors"]["correlations"].as_array().unwrap();
    let pairs: Vec<(&str, &str)> = pairs
        .iter()
        .map(|pair| (pair["first"].as_str().unwrap(), pair["second"].as_str().unwrap()))
        .collect();
    assert_eq!(
        pairs,
        [
            ("stiffness_factor", "dissipation_s_m"),
            ("stiffness_factor", "floor_up_m"),
            ("dissipation_s_m", "floor_up_m")
        ]
    );
    let remarks = plan["remarks"].to_string();
    assert!(remarks.contains("it is not determined, and that of the model stays"), "{remarks}");
    for answer in ["", " --yes poor-fit"] {
        let call = format!("{FIT_CALL} --fit dissipation -o fitted.osim{answer}");
        let refused = dir.run(&call).says(&["determine nothing of what was to be fitted", "--correct FILE"]);
        assert_eq!(refused.wrote_nothing().status, Some(1));
    }
}

/// The forces that `motion` prints for the fitted model, compared with the file of the plates: every fifth of its rows is at a time of the
/// motion.
#[test]
fn errors_of_each_foot_are_those_of_its_forces() {
    let dir = TestDir::with(&FILES_OF_RECORDING);
    dir.run("set walker.osim static_friction=0.8 dynamic_friction=0.8 -o rough.osim --yes wrong-afterwards")
        .succeeded();
    let call = FIT_CALL.replace("walker.osim", "rough.osim");
    let plan =
        json_object(&dir.run(&format!("{call} --fit height -o fitted.osim --format json")).succeeded());
    let (floor_m, weight_n) = (floor_rise_m(&plan), 70.0 * 9.80665);
    let plates = dir.text("plates.sto");
    let plates: Vec<Vec<f64>> = plates
        .lines()
        .skip(7)
        .step_by(5)
        .map(|row| row.split('\t').map(|cell| cell.parse().unwrap()).collect())
        .collect();
    // The force of a foot along x and y in each frame, N, and where it acts in the plane of the fitted floor, m.
    let forces = |model: &str, body: &str| -> Vec<[f64; 3]> {
        let csv = dir.run(&format!("motion {model} walk.mot --format csv")).succeeded().out();
        let names: Vec<&str> = csv.lines().next().unwrap().split(',').collect();
        let mut frames = vec![[0.0; 3]; 241];
        for (row, line) in csv.lines().skip(1).enumerate() {
            let cells: Vec<&str> = line.split(',').collect();
            let cell = |name: &str| cells[names.iter().position(|one| *one == name).unwrap()];
            let [x_n, y_n, x_m, y_m] = ["force_x_n", "force_y_n", "point_x_m", "point_y_m"]
                .map(|name| cell(name).parse::<f64>().unwrap());
            if cell("body") == body {
                let sum = &mut frames[row / 4];
                *sum = [sum[0] + x_n, sum[1] + y_n, sum[2] + x_m * y_n - (y_m - floor_m) * x_n];
            }
        }
        frames.into_iter().map(|[x_n, y_n, moment]| [x_n, y_n, moment / y_n]).collect()
    };
    for (foot, (name, body, vx)) in
        [("right foot", "foot_r", 1), ("left foot", "foot_l", 10)].iter().enumerate()
    {
        let found = &plan["errors"]["feet"][foot];
        assert_eq!(found["name"], *name);
        let (before, after) = (forces("rough.osim", body), forces("fitted.osim", body));
        let rms = |values: Vec<f64>| {
            (values.iter().map(|value| value * value).sum::<f64>() / values.len() as f64).sqrt()
        };
        let differences = |forces: &[[f64; 3]], axis: usize| {
            rms(forces.iter().zip(&plates).map(|(force, plate)| force[axis] - plate[vx + axis]).collect())
        };
        let is_loaded =
            |(force, plate): &(&[f64; 3], &Vec<f64>)| force[1].min(plate[vx + 1]) > 0.05 * weight_n;
        let loaded = after.iter().zip(&plates).filter(is_loaded);
        let peak_n = |forces: &mut dyn Iterator<Item = f64>| forces.fold(0.0, f64::max) / weight_n;
        for (figure, expected) in [
            ("vertical_rms_bw", differences(&after, 1) / weight_n),
            ("vertical_rms_before_bw", differences(&before, 1) / weight_n),
            ("horizontal_rms_bw", differences(&after, 0) / weight_n),
            ("cop_rms_m", rms(loaded.map(|(force, plate)| force[2] - plate[vx + 3]).collect())),
            ("peak_bw", peak_n(&mut after.iter().map(|force| force[1]))),
            ("measured_peak_bw", peak_n(&mut plates.iter().map(|plate| plate[vx + 1]))),
        ] {
            let value = number(found, figure);
            assert!(
                expected > 1e-3 && (value - expected).abs() < 1e-6,
                "{name}: {figure} {value} {expected}"
            );
        }
    }
}
