//! `transfer`: gravities, radii that one sphere says, and names that may be a preset or a file.

use serde_json::{Value, json};

use crate::support::Bench;

/// The 62 kg human with 6 spheres a limb of 0.032 m: E₁* = 1e6 N/m², α = 2 s/m, bv = 50 s/m (OpenSim's default), g = 9.81 m/s².
const FROM_ITSELF: &str = "transfer human.osim --from human.osim --reference-spheres 6";
/// A quarter of that gravity, so that γ = 4 and γ^-1/2 = 1/2.
const QUARTER: &str = "--reference-gravity 2.4525";
/// What is left of an exact 4 where 9.81 is divided by 2.4525.
const TOLERANCE: f64 = 4e-16;

/// What is planned for each force: E₁*, α, bv.
#[track_caller]
fn planned(report: &str) -> Vec<(String, f64)> {
    let report: Value = serde_json::from_str(report).unwrap();
    let changes = report["changes"].as_array().unwrap();
    changes
        .iter()
        .map(|change| (change["property"].as_str().unwrap().to_owned(), change["to"].as_f64().unwrap()))
        .collect()
}

/// γ = 4: E₁* x γ, α and bv x γ^-1/2; nothing else, because neither mass nor radius nor count is another.
#[track_caller]
fn is_scaled_by_four(report: &str) {
    let planned = planned(report);
    for (property, expected) in [("stiffness", 4e6), ("dissipation", 1.0), ("hunt_crossley_smoothing", 25.0)]
    {
        let values: Vec<f64> =
            planned.iter().filter(|(name, _)| name == property).map(|(_, value)| *value).collect();
        assert_eq!(values.len(), 12, "{property}: {planned:?}");
        for value in values {
            assert!((value / expected - 1.0).abs() <= TOLERANCE, "{property}: {value}, not {expected}");
        }
    }
    assert_eq!(planned.len(), 36, "{planned:?}");
}

#[test]
fn naming_the_gravity_of_the_reference_asks_for_the_models_own() {
    let bench = Bench::human();
    bench.write(
        "weightless.osim",
        bench.text("human.osim").replace("<gravity>0 -9.8100000000000005 0<", "<gravity>0 0 0<"),
    );
    let json = "--dry-run --format json";
    for from in ["human.osim", "falisse2022", "weightless.osim"] {
        let call = format!("transfer human.osim --from {from} --reference-spheres 6 {QUARTER}");
        is_scaled_by_four(&bench.run(&format!("{call} {json}")).done().out());
        is_scaled_by_four(&bench.run(&format!("{call} --target-gravity 9.81 {json}")).done().out());
    }
    // Without it, gravity is no part of the scaling.
    let report = bench.run(&format!("{FROM_ITSELF} {json}")).done().out();
    assert!(!planned(&report).iter().any(|(name, _)| name == "stiffness"), "{report}");
}

#[test]
fn the_table_and_the_note_say_which_gravities_were_taken() {
    let bench = Bench::human();
    bench
        .run(&format!("{FROM_ITSELF} {QUARTER} -o earth.osim"))
        .done()
        .says(&["gravity 2.4525 -> 9.81 m/s2 (x4)"]);
    assert!(
        bench.text("earth.osim").contains("contacts made for 62 kg at 9.8100000000000005 m/s2 (")
            || bench.text("earth.osim").contains("contacts made for 62 kg at 9.81 m/s2 (")
    );
    // They are made for 9.81 m/s² now: scaled back, they are what they were.
    bench.run("earth.osim --target-mass 62 --target-gravity 2.4525 -o back.osim").done();
    let seen = bench.run("inspect back.osim --format json").done().out();
    let seen: Value = serde_json::from_str(&seen).unwrap();
    let stiffness = seen["forces"][0]["parameters"]["stiffness"].as_f64().unwrap();
    assert!((stiffness / 1e6 - 1.0).abs() < 1e-14, "{stiffness}");
}

#[test]
fn a_model_without_gravity_is_asked_for_one() {
    let bench = Bench::human();
    let text = bench.text("human.osim").replace("<gravity>0 -9.8100000000000005 0<", "<gravity>0 0 0<");
    bench.write("weightless.osim", &text);
    let call =
        format!("transfer weightless.osim --from human.osim --reference-spheres 6 --dry-run {QUARTER}");
    bench.run(&call).failed().says(&["the model has no gravity: say --target-gravity G"]);
    is_scaled_by_four(&bench.run(&format!("{call} --target-gravity 9.81 --format json")).done().out());
    // A reference without one is named as such.
    let call = "transfer human.osim --from weightless.osim --target-gravity 9.81 --dry-run";
    bench.run(call).failed().says(&["the reference has no gravity: say --reference-gravity G"]);
}

#[test]
fn rows_and_requests_in_json_mean_the_same() {
    let bench = Bench::human();
    bench.write(
        "table.csv",
        "model,from,reference-spheres,reference-gravity,output\nhuman.osim,human.osim,6,2.4525,row.osim\n",
    );
    is_scaled_by_four(&bench.run("batch table.csv --dry-run --format json").done().out());
    let request = json!({
        "verb": "transfer", "models": "human.osim", "from": "human.osim", "reference_spheres": 6,
        "reference_gravity": 2.4525, "dry_run": true, "format": "json",
    });
    is_scaled_by_four(&bench.run_with("request -", request.to_string().as_bytes()).done().out());
}

#[test]
fn the_gravity_of_the_contacts_is_not_ignored() {
    let bench = Bench::human();
    bench
        .run(&format!("{FROM_ITSELF} --contacts-gravity 1.62 --target-gravity 9.81"))
        .usage()
        .says(&["--contacts-gravity says nothing here", "--reference-gravity"]);
}

#[test]
fn the_sphere_that_is_named_says_the_radius() {
    let bench = Bench::with(&[
        ("format/mixed_radii.osim", "mixed.osim"),
        ("table1/human_62kg_smooth_sphere.osim", "human.osim"),
    ]);
    let call = "transfer human.osim --from mixed.osim --reference-spheres 2 --radius isometric --dry-run --format json";
    let asked = bench.run(call).failed();
    assert!(asked.err().contains("--reference-sphere NAME"), "{}", asked.err());
    // The reference weighs 53 kg; (62/53)^(1/3) is 1.0536644894... (mpmath).
    for (name, radius) in [("heel_r", 0.05), ("toe_l", 0.025)] {
        let report = bench.run(&format!("{call} --reference-sphere {name}")).done().out();
        let radii: Vec<f64> = planned(&report)
            .into_iter()
            .filter(|(property, _)| property == "radius")
            .map(|(_, value)| value)
            .collect();
        assert_eq!(radii.len(), 12);
        for value in radii {
            let cube = (value / radius).powi(3);
            assert!((cube * 53.0 / 62.0 - 1.0).abs() < 1e-14, "{name}: {value}");
        }
    }
}

#[test]
fn one_rule_says_what_is_a_preset_and_what_a_file() {
    let bench = Bench::human();
    // A preset is meant, also where a file has its name.
    bench.write("falisse2022", "no model");
    bench.write("table.csv", "model,from,output\nhuman.osim,falisse2022,row.osim\n");
    for call in [
        "transfer human.osim --from falisse2022 --dry-run",
        "batch table.csv --dry-run",
        "plot force falisse2022 -o a.svg",
        "drop-test falisse2022",
        "drop-test human.osim --compare falisse2022",
    ] {
        bench.run(call).done();
    }
    // What looks like a file is one that is missing; what does not is neither.
    bench.write("table.csv", "model,from,output\nhuman.osim,NAME,row.osim\n");
    let table = bench.text("table.csv");
    for (name, said) in
        [("absent.osim", "absent.osim"), ("falisse2023", "expected a model or one of: falisse2022")]
    {
        bench.write("table.csv", table.replace("NAME", name));
        for call in [
            format!("transfer human.osim --from {name} --dry-run"),
            "batch table.csv --dry-run".to_owned(),
            format!("plot force {name} -o b.svg"),
            format!("drop-test {name}"),
            format!("drop-test human.osim --compare {name}"),
        ] {
            let ran = bench.run(&call);
            assert!(ran.err().contains(said), "{call}: {}", ran.err());
            assert_eq!(ran.err().contains("no such preset"), name == "falisse2023", "{call}: {}", ran.err());
        }
    }
}

#[test]
fn the_gravity_of_a_compared_body_is_its_files() {
    let bench = Bench::human();
    let text = bench.text("human.osim").replace("<gravity>0 -9.8100000000000005 0<", "<gravity>0 0 0<");
    bench.write("weightless.osim", &text);
    bench
        .run("drop-test human.osim --compare weightless.osim --gravity 9.81")
        .failed()
        .says(&["weightless.osim", "the model has no gravity: set <gravity> in its file"]);
    bench.run("drop-test weightless.osim").failed().says(&["the model has no gravity: say --gravity G"]);
}

#[test]
fn similarity_is_told_at_the_gravity_that_contacts_are_scaled_to() {
    // One body at two gravities is similar to itself: 0.3533 (Table 1) in both.
    let bench = Bench::with(&[
        ("scale_tool/scaled_smooth.osim", "scaled.osim"),
        ("scale_tool/generic_smooth.osim", "generic.osim"),
        ("scale_tool/applied_scale_set.xml", "set.xml"),
    ]);
    let call = "transfer scaled.osim --from generic.osim --follow-bodies --body-scale-file set.xml --dry-run";
    for gravity in ["", " --target-gravity 1.62"] {
        let ran = bench.run(&format!("{call}{gravity}")).done();
        let text = format!("{}{}", ran.out(), ran.err());
        let line =
            text.lines().find(|line| line.contains("in the reference")).unwrap_or_else(|| panic!("{text}"));
        let x_hats: Vec<&str> = line.matches("0.3533").collect();
        assert_eq!(x_hats.len(), 2, "{line}");
    }
}

#[test]
fn predsims_rule_has_no_gravity() {
    let bench = Bench::human();
    let call = "transfer human.osim --from falisse2022 --rule predsim --height-ratio 1.1";
    for gravity in ["--target-gravity 1.62", "--reference-gravity 1.62"] {
        let ran = bench.run(&format!("{call} {gravity}"));
        assert_eq!(ran.status, Some(2), "{gravity}");
        ran.says(&["says nothing with --rule predsim"]);
    }
}

#[test]
fn a_gravity_of_the_contacts_needs_one_to_scale_to() {
    let ran = Bench::human().run("human.osim --target-mass 80 --contacts-gravity 1.62 --dry-run");
    assert_eq!(ran.status, Some(2), "{}", ran.err());
    ran.says(&["--target-gravity"]);
}

#[test]
fn standard_input_is_one_file() {
    let ran = Bench::human().run("transfer - --from - --spheres 2");
    assert_eq!(ran.status, Some(2), "{}", ran.err());
    ran.says(&["standard input cannot be both"]);
}

/// An animal with feet of its own, and a human's contact: spheres as large against the body as the human's by (8), 0.032 m times
/// the cube root of 37.8/62 (Python's decimal), on the soles where they are.
#[test]
fn spheres_of_ones_own_get_the_size_of_a_preset_and_stay_on_their_soles() {
    const RADIUS: f64 = 0.027_134_178_757_483_97;
    let bench = Bench::with(&[("table1/emu_10_spheres_smooth_sphere.osim", "emu.osim")]);
    let call = "transfer emu.osim --from falisse2022 --radius isometric --level --dry-run";
    let report: Value =
        serde_json::from_str(&bench.run(&format!("{call} --format json")).done().out()).unwrap();
    let changes = report["changes"].as_array().unwrap();
    let of = |property: &'static str| changes.iter().filter(move |change| change["property"] == property);
    assert_eq!((of("radius").count(), of("location").count()), (20, 20));
    for change in of("radius") {
        assert!((change["to"].as_f64().unwrap() / RADIUS - 1.0).abs() < 1e-15, "{change}");
        assert_eq!((&change["from"], &change["equation"]), (&json!(0.015), &json!("8")));
    }
    for change in of("location") {
        let (from, to) = (change["from"].as_array().unwrap(), change["to"].as_array().unwrap());
        assert_eq!((&from[0], &from[2]), (&to[0], &to[2]));
        let (from, to) = (from[1].as_f64().unwrap(), to[1].as_f64().unwrap());
        assert!((from - 0.015 - (to - RADIUS)).abs() < 1e-15, "the bottom stays: {change}");
    }
    bench.run(call).done().looks_like("transfer_level_preset");
    // Written, and done again: nothing is left to move.
    bench.run(&call.replace("--dry-run", "-o done.osim")).done();
    bench
        .run(&call.replace("emu.osim", "done.osim"))
        .done()
        .says(&["every value is already as the reference wants it"]);
    // Metres and factors move bottoms as well; a radius that stays does not.
    for radius in ["0.02", "x1.5"] {
        bench
            .run(&call.replace("isometric", radius))
            .done()
            .says(&["so that the lowest point of each sphere stays"]);
    }
    for radius in ["--radius keep", "--radius isometric --keep radius", "--only stiffness", ""] {
        let call = call.replace("--radius isometric", radius);
        bench.run(&call).usage().says(&["--level says nothing here: radii stay, and bottoms with them"]);
    }
}

/// `add` takes moco-2d-gait, so `transfer` does: stiffnesses that somebody changed since are again what `add` made of it.
#[test]
fn a_preset_with_spheres_of_several_radii_is_taken() {
    let bench = Bench::with(&[("feet/human_40000.osim", "bare.osim")]);
    bench
        .run("add bare.osim --from moco-2d-gait --body-scale calcn_r=1 --body-scale calcn_l=1 -o added.osim")
        .done();
    bench.run("set added.osim stiffness=x2 -o stiff.osim").done();
    let of = |file: &str| -> Vec<f64> {
        let seen: Value =
            serde_json::from_str(&bench.run(&format!("inspect {file} --format json")).done().out()).unwrap();
        let forces = seen["forces"].as_array().unwrap().iter();
        forces.map(|force| force["parameters"]["stiffness"].as_f64().unwrap()).collect()
    };
    let (added, stiff) = (of("added.osim"), of("stiff.osim"));
    assert!(added.len() == 4 && added.iter().zip(&stiff).all(|(one, twice)| 2.0 * one == *twice));
    bench.run("transfer stiff.osim --from moco-2d-gait -o again.osim").done();
    for (one, again) in added.iter().zip(of("again.osim")) {
        assert!((one - again).abs() <= 1e-12 * one, "{one} {again}");
    }
    bench.run("drop-test moco-2d-gait --duration 0.01").done();
    bench
        .run("transfer stiff.osim --from moco-2d --dry-run")
        .usage()
        .says(&["one of: falisse2022, moco-2d-gait"]);
    bench.run("presets moco-2d-gait").usage().says(&["add and transfer take them"]);
}
