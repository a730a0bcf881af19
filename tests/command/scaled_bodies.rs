//! A model that OpenSim scaled: what `check` says of its spheres, and `rescale` with the ScaleSet alone.

use serde_json::Value;

use crate::support::Bench;

const FILES: &[(&str, &str)] = &[
    ("scale_tool/generic_smooth.osim", "generic.osim"),
    ("scale_tool/scaled_smooth.osim", "scaled.osim"),
    ("scale_tool/applied_scale_set.xml", "set.xml"),
];

fn checked(bench: &Bench, call: &str) -> Value {
    serde_json::from_str(&bench.run(&format!("check {call} --format json")).out()).unwrap()
}

fn codes(report: &Value) -> Vec<&str> {
    report["findings"].as_array().unwrap().iter().map(|finding| finding["code"].as_str().unwrap()).collect()
}

#[test]
fn check_with_the_original_prints_the_command_that_puts_it_right() {
    let bench = Bench::with(FILES);
    let found = checked(&bench, "scaled.osim --from generic.osim");
    let first = &found["findings"][0];
    assert_eq!((&first["code"], &first["severity"]), (&"spheres-left-behind".into(), &"error".into()));
    let command = first["command"].as_str().unwrap();
    assert_eq!(
        command,
        "osim-contact-scale transfer scaled.osim --from generic.osim --follow-bodies --level"
    );
    bench.run("check scaled.osim --from generic.osim").failed();
    let arguments = command.strip_prefix("osim-contact-scale ").unwrap();
    bench.run(&format!("{arguments} -o right.osim")).done();
    for call in ["right.osim", "right.osim --from generic.osim"] {
        let found = checked(&bench, call);
        assert_eq!(
            (&found["counts"]["error"], &found["counts"]["warning"]),
            (&0.into(), &0.into()),
            "{found}"
        );
    }
}

#[test]
fn check_reads_the_scale_set_and_the_original() {
    let bench = Bench::with(FILES);
    let found = checked(&bench, "scaled.osim --from generic.osim --body-scale-file set.xml");
    let command = found["findings"][0]["command"].as_str().unwrap();
    assert!(command.contains("--body-scale-file set.xml"), "{command}");
    bench.run("check scaled.osim --body-scale-file set.xml").usage();
    bench.run("check scaled.osim --from absent.osim").failed().says(&["absent.osim"]);
}

#[test]
fn no_command_keeps_places_that_may_be_wrong() {
    // Contacts made for 62 kg under 20 kg: on a child's bones, and where nothing is known of the places.
    let bench = Bench::with(&[
        ("check/spheres_misplaced.osim", "child.osim"),
        ("check/spheres_not_compared.osim", "other.osim"),
    ]);
    let other = bench.text("other.osim").replace("<mass>60</mass>", "<mass>18</mass>");
    bench.write("other.osim", other);
    for model in ["child.osim", "other.osim"] {
        let found = checked(&bench, model);
        for finding in found["findings"].as_array().unwrap() {
            assert!(finding["command"].is_null(), "{model}: {finding}");
        }
    }
    assert!(codes(&checked(&bench, "child.osim")).contains(&"spheres-misplaced"));
    let other = checked(&bench, "other.osim");
    assert!(codes(&other).contains(&"contacts-of-another-mass"), "{other}");
}

#[test]
fn the_scale_set_alone_moves_spheres_and_scales_contacts() {
    let bench = Bench::with(FILES);
    let call = "scaled.osim --body-scale-file set.xml --contacts-mass 62 --target-mass 52";
    bench.run(&format!("{call} -o moved.osim")).done();
    let seen: Value =
        serde_json::from_str(&bench.run("inspect moved.osim --format json").done().out()).unwrap();
    let heel = &seen["spheres"][0];
    // The set's factors of the calcn are 1.02, 0.9 and 0.95; (8) with 52/62; and a centre of -10, -40, 5 mm.
    let close = |value: &Value, expected: f64| (value.as_f64().unwrap() / expected - 1.0).abs() < 1e-12;
    for (axis, expected) in [-0.01 * 1.02, -0.04 * 0.9, 0.005 * 0.95].into_iter().enumerate() {
        assert!(close(&heel["location_m"][axis], expected), "{heel}");
    }
    let ratio: f64 = 52.0 / 62.0;
    assert!(close(&heel["radius_m"], 0.032 * ratio.cbrt()), "{heel}");
    // (10) with R ~ M^(1/3): stiffness follows M^(1/3).
    assert!(close(&seen["forces"][0]["parameters"]["stiffness"], 2e6 * ratio.cbrt()), "{seen}");
    // What it did is in the note, so that it is not done twice in place.
    bench.run("moved.osim --body-scale-file set.xml --contacts-mass 62 --target-mass 52 --in-place").failed();
}

#[test]
fn spheres_are_not_moved_twice_by_one_scale_set() {
    let bench = Bench::with(FILES);
    let call = "--body-scale-file set.xml --target-mass 52";
    bench.run(&format!("scaled.osim {call} --contacts-mass 62 -o once.osim")).done();
    // Also after something else was done, and where --force replaces an output.
    bench.run("once.osim --target-mass 60 -o later.osim").done();
    for (model, force) in [("once.osim", ""), ("once.osim", " --force"), ("later.osim", "")] {
        bench
            .run(&format!("{model} {call} -o twice.osim{force}"))
            .failed()
            .wrote_nothing()
            .says(&["spheres follow their bodies already", "leave out --body-scale-file"]);
    }
    bench.run("once.osim --target-mass 52 -o twice.osim").done();
    assert_eq!(bench.read("twice.osim"), bench.read("once.osim"));
}

#[test]
fn by_the_note_alone_spheres_follow_their_bodies_exactly() {
    let bench = Bench::with(FILES);
    bench.run("note generic.osim --contacts-mass 62 -o noted.osim").done().wrote(&["noted.osim"]);
    // What the Scale Tool does: it copies the credits, and leaves the spheres.
    let credits = |text: &str| {
        let start = text.find("<credits>").unwrap();
        text[start..start + text[start..].find("</credits>").unwrap()].to_owned()
    };
    let (noted, scaled) = (bench.text("noted.osim"), bench.text("scaled.osim"));
    bench.write("scaled_noted.osim", scaled.replacen(&credits(&scaled), &credits(&noted), 1));
    let checked = bench.run("check scaled_noted.osim").out();
    assert!(checked.contains("spheres-left-behind"), "{checked}");
    let call = checked.lines().find_map(|line| line.split_once("osim-contact-scale ")).unwrap().1.to_owned();
    assert!(call.contains("--follow-bodies") && call.contains("--target-mass 52"), "{call}");
    bench.run("scaled_noted.osim --target-mass 52 --follow-bodies -o by_note.osim").done();
    bench
        .run("scaled.osim --body-scale-file set.xml --contacts-mass 62 --target-mass 52 -o by_file.osim")
        .done();
    let spheres = |name: &str| -> Vec<Vec<f64>> {
        let seen = bench.run(&format!("inspect {name} --format json")).done().out();
        let seen: Value = serde_json::from_str(&seen).unwrap();
        let spheres = seen["spheres"].as_array().unwrap().clone();
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
    let after = bench.run("check by_note.osim").out();
    assert!(!after.contains("spheres-"), "{after}");
}

#[test]
fn the_scale_set_alone_asks_what_the_contacts_were_made_for() {
    let bench = Bench::with(FILES);
    bench
        .run("scaled.osim --body-scale-file set.xml --target-mass 52")
        .failed()
        .wrote_nothing()
        .says(&["the bodies were scaled", "--contacts-mass KG"]);
    bench.write("set.xml", bench.text("set.xml").replace("calcn_r", "calcn_x"));
    bench
        .run("scaled.osim --body-scale-file set.xml --contacts-mass 62 --target-mass 52 -o moved.osim")
        .failed()
        .says(&["no factors of calcn_r"]);
}
