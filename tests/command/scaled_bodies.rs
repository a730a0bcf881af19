//! Models that OpenSim scaled: `check` of their spheres, and `rescale` with a ScaleSet but without the generic model.

use serde_json::Value;

use crate::support::TestDir;

const GENERIC_AND_SCALED_FILES: &[(&str, &str)] = &[
    ("scale_tool/generic_smooth.osim", "generic.osim"),
    ("scale_tool/scaled_smooth.osim", "scaled.osim"),
    ("scale_tool/applied_scale_set.xml", "set.xml"),
];

fn check_json(dir: &TestDir, call: &str) -> Value {
    serde_json::from_str(&dir.run(&format!("check {call} --format json")).out()).unwrap()
}

fn finding_codes(report: &Value) -> Vec<&str> {
    report["findings"].as_array().unwrap().iter().map(|finding| finding["code"].as_str().unwrap()).collect()
}

#[test]
fn check_from_the_generic_model_proposes_the_correcting_command() {
    let dir = TestDir::with(GENERIC_AND_SCALED_FILES);
    let check = check_json(&dir, "scaled.osim --from generic.osim");
    let first = &check["findings"][0];
    assert_eq!((&first["code"], &first["severity"]), (&"spheres-left-behind".into(), &"error".into()));
    let command = first["command"].as_str().unwrap();
    assert_eq!(
        command,
        "osim-contact-scale transfer scaled.osim --from generic.osim --follow-bodies --level"
    );
    dir.run("check scaled.osim --from generic.osim").failed();
    let arguments = command.strip_prefix("osim-contact-scale ").unwrap();
    dir.run(&format!("{arguments} -o right.osim")).succeeded();
    for call in ["right.osim", "right.osim --from generic.osim"] {
        let check = check_json(&dir, call);
        assert_eq!(
            (&check["counts"]["error"], &check["counts"]["warning"]),
            (&0.into(), &0.into()),
            "{check}"
        );
    }
}

#[test]
fn check_reads_the_scale_set_with_the_generic_model() {
    let dir = TestDir::with(GENERIC_AND_SCALED_FILES);
    let check = check_json(&dir, "scaled.osim --from generic.osim --body-scale-file set.xml");
    let command = check["findings"][0]["command"].as_str().unwrap();
    assert!(command.contains("--body-scale-file set.xml"), "{command}");
    dir.run("check scaled.osim --body-scale-file set.xml").usage_error();
    dir.run("check scaled.osim --from absent.osim").failed().says(&["absent.osim"]);
}

#[test]
fn check_proposes_no_command_if_places_may_be_wrong() {
    // Contacts made for 62 kg under 20 kg: on a child's bones, and with places that cannot be compared.
    let dir = TestDir::with(&[
        ("check/spheres_misplaced.osim", "child.osim"),
        ("check/spheres_not_compared.osim", "other.osim"),
    ]);
    let other = dir.text("other.osim").replace("<mass>60</mass>", "<mass>18</mass>");
    dir.write("other.osim", other);
    for model in ["child.osim", "other.osim"] {
        let check = check_json(&dir, model);
        for finding in check["findings"].as_array().unwrap() {
            assert!(finding["command"].is_null(), "{model}: {finding}");
        }
    }
    assert!(finding_codes(&check_json(&dir, "child.osim")).contains(&"spheres-misplaced"));
    let other = check_json(&dir, "other.osim");
    assert!(finding_codes(&other).contains(&"contacts-of-another-mass"), "{other}");
}

#[test]
fn the_scale_set_alone_moves_spheres_and_scales_contacts() {
    let dir = TestDir::with(GENERIC_AND_SCALED_FILES);
    let call = "scaled.osim --body-scale-file set.xml --contacts-mass 62 --target-mass 52";
    dir.run(&format!("{call} -o moved.osim")).succeeded();
    let inspection: Value =
        serde_json::from_str(&dir.run("inspect moved.osim --format json").succeeded().out()).unwrap();
    let heel = &inspection["spheres"][0];
    // The set's factors of the calcn are 1.02, 0.9 and 0.95; (8) with 52/62; and a centre of -10, -40, 5 mm.
    let is_close = |value: &Value, expected: f64| (value.as_f64().unwrap() / expected - 1.0).abs() < 1e-12;
    for (axis, expected) in [-0.01 * 1.02, -0.04 * 0.9, 0.005 * 0.95].into_iter().enumerate() {
        assert!(is_close(&heel["location_m"][axis], expected), "{heel}");
    }
    let ratio: f64 = 52.0 / 62.0;
    assert!(is_close(&heel["radius_m"], 0.032 * ratio.cbrt()), "{heel}");
    // (10) with R ~ M^(1/3): stiffness follows M^(1/3).
    assert!(
        is_close(&inspection["forces"][0]["parameters"]["stiffness"], 2e6 * ratio.cbrt()),
        "{inspection}"
    );
    // The note records the scale set, so that it is not applied twice in place.
    dir.run("moved.osim --body-scale-file set.xml --contacts-mass 62 --target-mass 52 --in-place").failed();
}

#[test]
fn one_scale_set_moves_spheres_only_once() {
    let dir = TestDir::with(GENERIC_AND_SCALED_FILES);
    let call = "--body-scale-file set.xml --target-mass 52";
    dir.run(&format!("scaled.osim {call} --contacts-mass 62 -o once.osim")).succeeded();
    // Also after another change, and with --force.
    dir.run("once.osim --target-mass 60 -o later.osim").succeeded();
    for (model, force) in [("once.osim", ""), ("once.osim", " --force"), ("later.osim", "")] {
        dir.run(&format!("{model} {call} -o twice.osim{force}"))
            .failed()
            .wrote_nothing()
            .says(&["spheres follow their bodies already", "leave out --body-scale-file"]);
    }
    dir.run("once.osim --target-mass 52 -o twice.osim").succeeded();
    assert_eq!(dir.read("twice.osim"), dir.read("once.osim"));
}

#[test]
fn spheres_follow_their_bodies_by_the_note_as_by_the_scale_set() {
    let dir = TestDir::with(GENERIC_AND_SCALED_FILES);
    dir.run("note generic.osim --contacts-mass 62 -o noted.osim").succeeded().wrote(&["noted.osim"]);
    // What the Scale Tool does: it copies the credits, and leaves the spheres.
    let credits = |text: &str| {
        let start = text.find("<credits>").unwrap();
        text[start..start + text[start..].find("</credits>").unwrap()].to_owned()
    };
    let (noted, scaled) = (dir.text("noted.osim"), dir.text("scaled.osim"));
    dir.write("scaled_noted.osim", scaled.replacen(&credits(&scaled), &credits(&noted), 1));
    let check = dir.run("check scaled_noted.osim").out();
    assert!(check.contains("spheres-left-behind"), "{check}");
    let call = check.lines().find_map(|line| line.split_once("osim-contact-scale ")).unwrap().1.to_owned();
    assert!(call.contains("--follow-bodies") && call.contains("--target-mass 52"), "{call}");
    dir.run("scaled_noted.osim --target-mass 52 --follow-bodies -o by_note.osim").succeeded();
    dir.run("scaled.osim --body-scale-file set.xml --contacts-mass 62 --target-mass 52 -o by_file.osim")
        .succeeded();
    let spheres = |name: &str| -> Vec<Vec<f64>> {
        let inspection = dir.run(&format!("inspect {name} --format json")).succeeded().out();
        let inspection: Value = serde_json::from_str(&inspection).unwrap();
        let spheres = inspection["spheres"].as_array().unwrap().clone();
        let place = |sphere: &Value| {
            sphere["location_m"].as_array().unwrap().iter().map(|value| value.as_f64().unwrap()).collect()
        };
        spheres.iter().map(place).collect()
    };
    for (one, other) in spheres("by_note.osim").iter().zip(spheres("by_file.osim")) {
        for (a, b) in one.iter().zip(other) {
            assert!((a - b).abs() < 1e-12, "{a} {b}");
        }
    }
    let after = dir.run("check by_note.osim").out();
    assert!(!after.contains("spheres-"), "{after}");
}

#[test]
fn the_scale_set_alone_needs_the_contacts_mass() {
    let dir = TestDir::with(GENERIC_AND_SCALED_FILES);
    dir.run("scaled.osim --body-scale-file set.xml --target-mass 52")
        .failed()
        .wrote_nothing()
        .says(&["if OpenSim scaled this model", "--contacts-mass 62"]);
    dir.write("set.xml", dir.text("set.xml").replace("calcn_r", "calcn_x"));
    dir.run("scaled.osim --body-scale-file set.xml --contacts-mass 62 --target-mass 52 -o moved.osim")
        .failed()
        .says(&["no factors of calcn_r"]);
}
