//! `presets`, and presets of one's own.

use crate::support::{Bench, HUMAN};
use crate::{assert_close, changes, figure, object};

const LAB: &str = "# Presets of the lab
[[preset]]
name = \"lab_heel\"
source = \"pendulum tests, mean of eight heels\"
mass_kg = 70
spheres = 4
radius_m = 0.03
gravity_m_s2 = 9.81
stiffness = 1.5e6
dissipation = 1.0
";

fn lab(bench: &Bench) {
    bench.write("lab.toml", LAB);
}

#[test]
fn the_published_preset_is_what_was_published() {
    let bench = Bench::new();
    let preset = object(&bench.run("presets falisse2022 --format json").done().wrote_nothing());
    // Falisse et al. (2022) as in Table 1.
    for (name, value) in [
        ("mass_kg", 62.0),
        ("spheres", 6.0),
        ("radius_m", 0.032),
        ("gravity_m_s2", 9.80665),
        ("stiffness", 1e6),
        ("dissipation", 2.0),
        ("constant_contact_force", 1e-5),
        ("hertz_smoothing", 300.0),
        ("hunt_crossley_smoothing", 50.0),
    ] {
        assert_eq!(figure(&preset, name), value, "{name}");
    }
    assert!(preset["source"].as_str().unwrap().contains("Falisse"));
    // mpmath, g = 9.80665: E* n R²/(M g), x̂ of (11), α √(gR), √cf/R, bd R, bv √(gR).
    for (name, value) in [
        ("modulus", 3.572_677_776_099_388),
        ("relative_indentation", 0.353_219_721_110_830_4),
        ("dissipation", 1.120_379_935_557_576_8),
        ("constant_indentation", 0.098_821_176_880_261_85),
        ("hertz_smoothing", 9.6),
        ("hunt_crossley_smoothing", 28.009_498_388_939_42),
    ] {
        assert_close(figure(&preset["dimensionless"], name), value, 1e-14, name);
    }
}

#[test]
fn ones_own_stand_beside_it() {
    let bench = Bench::new();
    lab(&bench);
    let ran = bench.run("presets --presets lab.toml --format json").done();
    let names: Vec<String> = ran
        .out()
        .lines()
        .map(|line| {
            serde_json::from_str::<serde_json::Value>(line).unwrap()["name"].as_str().unwrap().to_owned()
        })
        .collect();
    assert_eq!(names, ["falisse2022", "lab_heel"]);
    let preset = object(&bench.run("presets lab_heel --presets lab.toml --format json").done());
    assert_eq!((figure(&preset, "stiffness"), figure(&preset, "spheres")), (1.5e6, 4.0));
    assert!(preset["hertz_smoothing"].is_null() && preset["dimensionless"]["hertz_smoothing"].is_null());
    bench
        .run("presets lab_hell --presets lab.toml")
        .usage()
        .says(&["unknown preset 'lab_hell'", "falisse2022, lab_heel"]);
    bench.run("presets lab_heel").usage().says(&["unknown preset 'lab_heel'"]);
}

#[test]
fn a_transfer_takes_ones_own() {
    let bench = Bench::with(&[("format/v40000.osim", "feet.osim"), HUMAN]);
    lab(&bench);
    let seen = changes(
        &bench.run("transfer feet.osim --from lab_heel --presets lab.toml --dry-run --format json").done(),
    );
    // (10): 53/70 · 4/2 · (0.03/0.0325)² · 1.5e6; (14): √(0.03/0.0325). mpmath.
    assert_close(seen["stiffness"].1, 1_935_418.427_726_12, 1e-14, "stiffness");
    assert_close(seen["dissipation"].1, 0.960_768_922_830_522_8, 1e-14, "dissipation");
    // It has no smoothing to give, which is said.
    bench
        .run("transfer human.osim --from lab_heel --presets lab.toml --dry-run")
        .done()
        .says(&["reference-without-smoothing"]);
    bench
        .run("transfer feet.osim --from lab_hell --presets lab.toml")
        .usage()
        .wrote_nothing()
        .says(&["no such file and no such preset", "falisse2022, lab_heel"]);
    let drop = object(&bench.run("drop-test lab_heel --presets lab.toml --format json").done());
    assert_eq!((figure(&drop, "mass_kg"), figure(&drop, "sphere_count")), (70.0, 4.0));
}

#[test]
fn mistakes_in_the_file_are_shown_where_they_are() {
    let bench = Bench::new();
    let with = |from: &str, to: &str| {
        assert!(LAB.contains(from), "{from}");
        LAB.replacen(from, to, 1)
    };
    for (text, words) in [
        (with("stiffness =", "stifness ="), ["lab.toml:9:1: ", "unknown field `stifness`"]),
        (with("mass_kg = 70", "mass_kg = \"70 kg\""), ["lab.toml:5:11: ", "expected a number"]),
        (with("name = \"lab_heel\"", "name = \"falisse2022\""), ["lab.toml:3:8: ", "'falisse2022' is taken"]),
        (format!("{LAB}\n{LAB}"), ["lab.toml:14:8: ", "'lab_heel' is taken"]),
        (with("1.5e6", "1,5e6"), ["lab.toml:9:14: ", "expected newline"]),
        (with("mass_kg = 70\n", ""), ["lab.toml:2:1: ", "missing field `mass_kg`"]),
        (with("mass_kg = 70", "mass_kg = -70"), ["lab.toml:3:8: preset 'lab_heel'", "mass is -70"]),
        (with("spheres = 4", "spheres = 0"), ["lab.toml:3:8: preset 'lab_heel'", "sphere count is 0"]),
        (
            format!("{LAB}hertz_smoothing = 300\n"),
            ["lab.toml:3:8: preset 'lab_heel'", "come together or not at all"],
        ),
        (with("[[preset]]", "[preset]"), ["lab.toml:2:1: ", "expected a sequence"]),
        (with("[[preset]]", "[[presets]]"), ["lab.toml:2:", "unknown field `presets`"]),
    ] {
        bench.write("lab.toml", &text);
        bench.run("presets --presets lab.toml").usage().wrote_nothing().says(&words);
    }
    bench.write("lab.toml", b"\xFF\xFE");
    bench.run("presets --presets lab.toml").usage().says(&["lab.toml: not UTF-8"]);
    bench.run("presets --presets nowhere.toml").usage().says(&["nowhere.toml", "no such file"]);
}

#[test]
fn how_it_looks() {
    let bench = Bench::new();
    lab(&bench);
    bench.run("presets --presets lab.toml").looks_like("physics_presets");
    bench.write("bad.toml", LAB.replace("stiffness", "stifness"));
    bench.run("presets --presets bad.toml").looks_like("physics_presets_unknown_key");
}
