//! `transfer`: gravities, the radius of a reference sphere, and names that may be a preset or a file.

use serde_json::{Value, json};

use crate::support::TestDir;

/// The 62 kg human with 6 spheres a limb of 0.032 m: E₁* = 1e6 N/m², α = 2 s/m, bv = 50 s/m (OpenSim's default), g = 9.81 m/s².
const TRANSFER_FROM_ITSELF: &str = "transfer human.osim --from human.osim --reference-spheres 6";
/// A reference gravity of 9.81/4 m/s², so that γ = 4 and γ^-1/2 = 1/2.
const OPTION_FOR_QUARTER_GRAVITY: &str = "--reference-gravity 2.4525";
/// The relative rounding error of 9.81 divided by 2.4525.
const RELATIVE_ROUNDING_ERROR: f64 = 4e-16;

/// The planned new values of each force, by property: E₁*, α, bv.
#[track_caller]
fn planned_values(report: &str) -> Vec<(String, f64)> {
    let report: Value = serde_json::from_str(report).unwrap();
    let changes = report["changes"].as_array().unwrap();
    changes
        .iter()
        .map(|change| (change["property"].as_str().unwrap().to_owned(), change["to"].as_f64().unwrap()))
        .collect()
}

/// Asserts the changes for γ = 4: E₁* times γ, α and bv times γ^-1/2. Nothing else changes, because mass, radius and count stay.
#[track_caller]
fn assert_scaled_to_fourfold_gravity(report: &str) {
    let planned = planned_values(report);
    for (property, expected) in [("stiffness", 4e6), ("dissipation", 1.0), ("hunt_crossley_smoothing", 25.0)]
    {
        let values: Vec<f64> =
            planned.iter().filter(|(name, _)| name == property).map(|(_, value)| *value).collect();
        assert_eq!(values.len(), 12, "{property}: {planned:?}");
        for value in values {
            assert!(
                (value / expected - 1.0).abs() <= RELATIVE_ROUNDING_ERROR,
                "{property}: {value}, not {expected}"
            );
        }
    }
    assert_eq!(planned.len(), 36, "{planned:?}");
}

#[test]
fn a_reference_gravity_scales_to_the_gravity_of_the_model() {
    let dir = TestDir::with_human();
    dir.write(
        "weightless.osim",
        dir.text("human.osim").replace("<gravity>0 -9.8100000000000005 0<", "<gravity>0 0 0<"),
    );
    let json = "--dry-run --format json";
    for from in ["human.osim", "falisse2022", "weightless.osim"] {
        let call =
            format!("transfer human.osim --from {from} --reference-spheres 6 {OPTION_FOR_QUARTER_GRAVITY}");
        assert_scaled_to_fourfold_gravity(&dir.run(&format!("{call} {json}")).succeeded().out());
        assert_scaled_to_fourfold_gravity(
            &dir.run(&format!("{call} --target-gravity 9.81 {json}")).succeeded().out(),
        );
    }
    // Without it, gravity does not affect the scaling.
    let report = dir.run(&format!("{TRANSFER_FROM_ITSELF} {json}")).succeeded().out();
    assert!(!planned_values(&report).iter().any(|(name, _)| name == "stiffness"), "{report}");
}

#[test]
fn the_table_and_the_note_name_the_gravities() {
    let dir = TestDir::with_human();
    dir.run(&format!("{TRANSFER_FROM_ITSELF} {OPTION_FOR_QUARTER_GRAVITY} -o earth.osim"))
        .succeeded()
        .says(&["gravity 2.4525 -> 9.81 m/s2 (x4)"]);
    assert!(
        dir.text("earth.osim").contains("contacts made for 62 kg at 9.8100000000000005 m/s2 (")
            || dir.text("earth.osim").contains("contacts made for 62 kg at 9.81 m/s2 (")
    );
    // The contacts are now made for 9.81 m/s²: scaling back restores them.
    dir.run("earth.osim --target-mass 62 --target-gravity 2.4525 -o back.osim").succeeded();
    let inspection = dir.run("inspect back.osim --format json").succeeded().out();
    let inspection: Value = serde_json::from_str(&inspection).unwrap();
    let stiffness = inspection["forces"][0]["parameters"]["stiffness"].as_f64().unwrap();
    assert!((stiffness / 1e6 - 1.0).abs() < 1e-14, "{stiffness}");
}

#[test]
fn a_model_without_gravity_needs_a_gravity_option() {
    let dir = TestDir::with_human();
    let text = dir.text("human.osim").replace("<gravity>0 -9.8100000000000005 0<", "<gravity>0 0 0<");
    dir.write("weightless.osim", &text);
    let call = format!(
        "transfer weightless.osim --from human.osim --reference-spheres 6 --dry-run {OPTION_FOR_QUARTER_GRAVITY}"
    );
    dir.run(&call).failed().says(&["the model has no gravity: give --target-gravity G"]);
    assert_scaled_to_fourfold_gravity(
        &dir.run(&format!("{call} --target-gravity 9.81 --format json")).succeeded().out(),
    );
    // A reference without one is named as such.
    let call = "transfer human.osim --from weightless.osim --target-gravity 9.81 --dry-run";
    dir.run(call).failed().says(&["the reference has no gravity: give --reference-gravity G"]);
}

#[test]
fn rows_and_json_requests_give_the_same_plan() {
    let dir = TestDir::with_human();
    dir.write(
        "table.csv",
        "model,from,reference-spheres,reference-gravity,output\nhuman.osim,human.osim,6,2.4525,row.osim\n",
    );
    assert_scaled_to_fourfold_gravity(&dir.run("batch table.csv --dry-run --format json").succeeded().out());
    let request = json!({
        "verb": "transfer", "models": "human.osim", "from": "human.osim", "reference_spheres": 6,
        "reference_gravity": 2.4525, "dry_run": true, "format": "json",
    });
    assert_scaled_to_fourfold_gravity(
        &dir.run_with_stdin("request -", request.to_string().as_bytes()).succeeded().out(),
    );
}

#[test]
fn contacts_gravity_is_refused_for_transfer() {
    let dir = TestDir::with_human();
    dir.run(&format!("{TRANSFER_FROM_ITSELF} --contacts-gravity 1.62 --target-gravity 9.81"))
        .usage_error()
        .says(&["--contacts-gravity has no effect here", "--reference-gravity"]);
}

#[test]
fn spheres_that_stay_where_the_reference_has_them_are_remarked_on() {
    let dir = TestDir::with(&[
        ("scale_tool/generic_smooth.osim", "generic.osim"),
        ("scale_tool/scaled_smooth.osim", "scaled.osim"),
    ]);
    let remark = ["the bones have another size", "move the spheres with --follow-bodies and --level"];
    dir.run("transfer scaled.osim --from generic.osim -o stayed.osim").succeeded().says(&remark);
    let follow = "transfer scaled.osim --from generic.osim --follow-bodies --level -o moved.osim";
    dir.run(follow).succeeded().says_not(&remark);
    dir.run("transfer moved.osim --from generic.osim --dry-run").succeeded().says_not(&remark);
}

/// The heels of a model that was right are moved 120 mm down: no number of a contact changes, but two places do.
#[test]
fn a_transfer_that_only_moves_spheres_changes_something() {
    let dir = TestDir::with(&[
        ("scale_tool/generic_smooth.osim", "generic.osim"),
        ("scale_tool/scaled_smooth.osim", "scaled.osim"),
    ]);
    let follow = "--from generic.osim --follow-bodies --level --moved-spheres replace";
    dir.run(&format!("transfer scaled.osim {follow} -o right.osim")).succeeded();
    let right = dir.text("right.osim");
    let heel = "<location>-0.0102 -0.0346";
    assert_eq!(right.matches(heel).count(), 2);
    dir.write("low.osim", right.replace(heel, "<location>-0.0102 -0.1546"));
    let run = dir.run(&format!("transfer low.osim {follow} --dry-run")).succeeded();
    run.says(&["heel_l", "spheres follow their bodies"]).says_not(&["nothing-to-change", "stiffness"]);
    let again = dir.run(&format!("transfer right.osim {follow} --dry-run")).succeeded();
    again.says(&["nothing-to-change"]);
}

#[test]
fn the_named_reference_sphere_gives_the_radius() {
    let dir = TestDir::with(&[
        ("format/mixed_radii.osim", "mixed.osim"),
        ("table1/human_62kg_smooth_sphere.osim", "human.osim"),
    ]);
    let call = "transfer human.osim --from mixed.osim --reference-spheres 2 --radius isometric --dry-run --format json";
    let refused = dir.run(call).failed();
    assert!(refused.err().contains("--reference-sphere NAME"), "{}", refused.err());
    // The reference weighs 53 kg; (62/53)^(1/3) is 1.0536644894... (mpmath).
    for (name, radius) in [("heel_r", 0.05), ("toe_l", 0.025)] {
        let report = dir.run(&format!("{call} --reference-sphere {name}")).succeeded().out();
        let radii: Vec<f64> = planned_values(&report)
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
fn presets_and_files_are_distinguished_by_one_rule() {
    let dir = TestDir::with_human();
    // The name of a preset means the preset, even if a file has this name.
    dir.write("falisse2022", "no model");
    dir.write("table.csv", "model,from,output\nhuman.osim,falisse2022,row.osim\n");
    for call in [
        "transfer human.osim --from falisse2022 --dry-run",
        "batch table.csv --dry-run",
        "plot force falisse2022 -o a.svg",
        "drop-test falisse2022",
        "drop-test human.osim --compare falisse2022",
    ] {
        dir.run(call).succeeded();
    }
    // A name that looks like a file is reported as missing, another name as neither file nor preset.
    dir.write("table.csv", "model,from,output\nhuman.osim,NAME,row.osim\n");
    let table = dir.text("table.csv");
    for (name, expected) in
        [("absent.osim", "absent.osim"), ("falisse2023", "expected a model or one of: falisse2022")]
    {
        dir.write("table.csv", table.replace("NAME", name));
        for call in [
            format!("transfer human.osim --from {name} --dry-run"),
            "batch table.csv --dry-run".to_owned(),
            format!("plot force {name} -o b.svg"),
            format!("drop-test {name}"),
            format!("drop-test human.osim --compare {name}"),
        ] {
            let run = dir.run(&call);
            assert!(run.err().contains(expected), "{call}: {}", run.err());
            assert_eq!(run.err().contains("no such preset"), name == "falisse2023", "{call}: {}", run.err());
        }
    }
}

#[test]
fn a_compared_model_needs_gravity_in_its_file() {
    let dir = TestDir::with_human();
    let text = dir.text("human.osim").replace("<gravity>0 -9.8100000000000005 0<", "<gravity>0 0 0<");
    dir.write("weightless.osim", &text);
    dir.run("drop-test human.osim --compare weightless.osim --gravity 9.81")
        .failed()
        .says(&["weightless.osim", "the model has no gravity: set <gravity> in its file"]);
    dir.run("drop-test weightless.osim").failed().says(&["the model has no gravity: give --gravity G"]);
}

#[test]
fn similarity_is_reported_at_the_target_gravity() {
    // One body at two gravities is similar to itself: 0.3533 (Table 1) in both.
    let dir = TestDir::with(&[
        ("scale_tool/scaled_smooth.osim", "scaled.osim"),
        ("scale_tool/generic_smooth.osim", "generic.osim"),
        ("scale_tool/applied_scale_set.xml", "set.xml"),
    ]);
    let call = "transfer scaled.osim --from generic.osim --follow-bodies --body-scale-file set.xml --dry-run";
    for gravity in ["", " --target-gravity 1.62"] {
        let run = dir.run(&format!("{call}{gravity}")).succeeded();
        let text = format!("{}{}", run.out(), run.err());
        let line =
            text.lines().find(|line| line.contains("in the reference")).unwrap_or_else(|| panic!("{text}"));
        assert!(line.contains("sink in as deep (0.353 R) and bounce as much"), "{line}");
    }
}

#[test]
fn the_predsim_rule_refuses_gravity_options() {
    let dir = TestDir::with_human();
    let call = "transfer human.osim --from falisse2022 --rule predsim --height-ratio 1.1";
    for gravity in ["--target-gravity 1.62", "--reference-gravity 1.62"] {
        let run = dir.run(&format!("{call} {gravity}"));
        assert_eq!(run.status, Some(2), "{gravity}");
        run.says(&["has no effect with --rule predsim"]);
    }
}

#[test]
fn contacts_gravity_needs_a_target_gravity() {
    let run = TestDir::with_human().run("human.osim --target-mass 80 --contacts-gravity 1.62 --dry-run");
    assert_eq!(run.status, Some(2), "{}", run.err());
    run.says(&["--target-gravity"]);
}

#[test]
fn standard_input_cannot_be_model_and_reference() {
    let run = TestDir::with_human().run("transfer - --from - --spheres 2");
    assert_eq!(run.status, Some(2), "{}", run.err());
    run.says(&["standard input cannot be both"]);
}

/// An animal with its own feet gets a human's contact: the radius by (8) is 0.032 m times
/// the cube root of 37.8/62 (Python's decimal), and the lowest points stay.
#[test]
fn level_spheres_get_the_radius_of_a_preset_and_stay_on_the_sole() {
    const RADIUS_OF_NEW_MASS: f64 = 0.027_134_178_757_483_97;
    let dir = TestDir::with(&[("table1/emu_10_spheres_smooth_sphere.osim", "emu.osim")]);
    let call = "transfer emu.osim --from falisse2022 --radius isometric --level --dry-run";
    let report: Value =
        serde_json::from_str(&dir.run(&format!("{call} --format json")).succeeded().out()).unwrap();
    let changes = report["changes"].as_array().unwrap();
    let values_of =
        |property: &'static str| changes.iter().filter(move |change| change["property"] == property);
    assert_eq!((values_of("radius").count(), values_of("location").count()), (20, 20));
    for change in values_of("radius") {
        assert!((change["to"].as_f64().unwrap() / RADIUS_OF_NEW_MASS - 1.0).abs() < 1e-15, "{change}");
        assert_eq!((&change["from"], &change["equation"]), (&json!(0.015), &json!("8")));
    }
    for change in values_of("location") {
        let (from, to) = (change["from"].as_array().unwrap(), change["to"].as_array().unwrap());
        assert_eq!((&from[0], &from[2]), (&to[0], &to[2]));
        let (from, to) = (from[1].as_f64().unwrap(), to[1].as_f64().unwrap());
        assert!((from - 0.015 - (to - RADIUS_OF_NEW_MASS)).abs() < 1e-15, "the bottom stays: {change}");
    }
    dir.run(call).succeeded().matches_snapshot("transfer_level_preset");
    // A second transfer changes nothing.
    dir.run(&call.replace("--dry-run", "-o done.osim")).succeeded();
    dir.run(&call.replace("emu.osim", "done.osim"))
        .succeeded()
        .says(&["every value is already as the reference wants it"]);
    // Metres and factors move bottoms as well; a radius that stays does not.
    for radius in ["0.02", "x1.5"] {
        dir.run(&call.replace("isometric", radius))
            .succeeded()
            .says(&["so that the lowest point of each sphere stays"]);
    }
    for radius in ["--radius keep", "--radius isometric --keep radius", "--only stiffness", ""] {
        let call = call.replace("--radius isometric", radius);
        dir.run(&call)
            .usage_error()
            .says(&["--level has no effect here: radii stay, and the lowest points with them"]);
    }
}

/// `transfer` from moco-2d-gait restores the stiffnesses that `add` gave, after a change.
#[test]
fn a_preset_with_several_radii_can_be_transferred() {
    let dir = TestDir::with(&[("feet/human_40000.osim", "bare.osim")]);
    dir.run("add bare.osim --from moco-2d-gait --body-scale calcn_r=1 --body-scale calcn_l=1 -o added.osim")
        .succeeded();
    dir.run("set added.osim stiffness=x2 -o stiff.osim").succeeded();
    let values_of = |file: &str| -> Vec<f64> {
        let inspection: Value =
            serde_json::from_str(&dir.run(&format!("inspect {file} --format json")).succeeded().out())
                .unwrap();
        let forces = inspection["forces"].as_array().unwrap().iter();
        forces.map(|force| force["parameters"]["stiffness"].as_f64().unwrap()).collect()
    };
    let (added, stiff) = (values_of("added.osim"), values_of("stiff.osim"));
    assert!(added.len() == 4 && added.iter().zip(&stiff).all(|(one, twice)| 2.0 * one == *twice));
    dir.run("transfer stiff.osim --from moco-2d-gait -o again.osim").succeeded();
    for (one, repeated) in added.iter().zip(values_of("again.osim")) {
        assert!((one - repeated).abs() <= 1e-12 * one, "{one} {repeated}");
    }
    dir.run("drop-test moco-2d-gait --duration 0.01").succeeded();
    dir.run("transfer stiff.osim --from moco-2d --dry-run")
        .usage_error()
        .says(&["one of: falisse2022, moco-3d-walking, osim-rl, dhondt2024, moco-2d-gait"]);
    dir.run("presets moco-2d-gait").succeeded().says(&["add, transfer and drop-test take it"]);
}
