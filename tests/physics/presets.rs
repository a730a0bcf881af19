//! `presets` lists presets of the program and presets in a file of the user.

use crate::support::{HUMAN, TestDir};
use crate::{assert_close, changes_in_json, json_object, number};

const PRESETS_OF_LAB: &str = "# Presets of the lab
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

fn write_lab_presets(dir: &TestDir) {
    dir.write("lab.toml", PRESETS_OF_LAB);
}

#[test]
fn the_published_preset_has_the_published_numbers() {
    let dir = TestDir::new();
    let preset = json_object(&dir.run("presets falisse2022 --format json").succeeded().wrote_nothing());
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
        assert_eq!(number(&preset, name), value, "{name}");
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
        assert_close(number(&preset["dimensionless"], name), value, 1e-14, name);
    }
}

#[test]
fn user_presets_are_listed_after_the_published_one() {
    let dir = TestDir::new();
    write_lab_presets(&dir);
    let run = dir.run("presets --presets lab.toml --format json").succeeded();
    let names: Vec<String> = run
        .out()
        .lines()
        .map(|line| {
            serde_json::from_str::<serde_json::Value>(line).unwrap()["name"].as_str().unwrap().to_owned()
        })
        .collect();
    assert_eq!(names, ["falisse2022", "moco-3d-walking", "osim-rl", "lab_heel"]);
    let preset = json_object(&dir.run("presets lab_heel --presets lab.toml --format json").succeeded());
    assert_eq!((number(&preset, "stiffness"), number(&preset, "spheres")), (1.5e6, 4.0));
    assert!(preset["hertz_smoothing"].is_null() && preset["dimensionless"]["hertz_smoothing"].is_null());
    dir.run("presets lab_hell --presets lab.toml")
        .usage_error()
        .says(&["unknown preset 'lab_hell'", "falisse2022, moco-3d-walking, osim-rl, lab_heel"]);
    dir.run("presets lab_heel").usage_error().says(&["unknown preset 'lab_heel'"]);
}

#[test]
fn transfer_accepts_a_user_preset() {
    let dir = TestDir::with(&[("format/v40000.osim", "feet.osim"), HUMAN]);
    write_lab_presets(&dir);
    let changed = changes_in_json(
        &dir.run("transfer feet.osim --from lab_heel --presets lab.toml --dry-run --format json").succeeded(),
    );
    // (10): 53/70 · 4/2 · (0.03/0.0325)² · 1.5e6; (14): √(0.03/0.0325). mpmath.
    assert_close(changed["stiffness"].1, 1_935_418.427_726_12, 1e-14, "stiffness");
    assert_close(changed["dissipation"].1, 0.960_768_922_830_522_8, 1e-14, "dissipation");
    // The preset has no smoothing, and a warning says so.
    dir.run("transfer human.osim --from lab_heel --presets lab.toml --dry-run")
        .succeeded()
        .says(&["reference-without-smoothing"]);
    dir.run("transfer feet.osim --from lab_hell --presets lab.toml")
        .usage_error()
        .wrote_nothing()
        .says(&["no such file and no such preset", "falisse2022, moco-3d-walking, osim-rl, lab_heel"]);
    let drop = json_object(&dir.run("drop-test lab_heel --presets lab.toml --format json").succeeded());
    assert_eq!((number(&drop, "mass_kg"), number(&drop, "sphere_count")), (70.0, 4.0));
}

#[test]
fn mistakes_in_a_preset_file_are_located() {
    let dir = TestDir::new();
    let lab_with = |from: &str, to: &str| {
        assert!(PRESETS_OF_LAB.contains(from), "{from}");
        PRESETS_OF_LAB.replacen(from, to, 1)
    };
    for (text, words) in [
        (lab_with("stiffness =", "stifness ="), ["lab.toml:9:1: ", "unknown field `stifness`"]),
        (lab_with("mass_kg = 70", "mass_kg = \"70 kg\""), ["lab.toml:5:11: ", "expected a number"]),
        (
            lab_with("name = \"lab_heel\"", "name = \"falisse2022\""),
            ["lab.toml:3:8: ", "'falisse2022' is taken"],
        ),
        (format!("{PRESETS_OF_LAB}\n{PRESETS_OF_LAB}"), ["lab.toml:14:8: ", "'lab_heel' is taken"]),
        (lab_with("1.5e6", "1,5e6"), ["lab.toml:9:14: ", "expected newline"]),
        (lab_with("mass_kg = 70\n", ""), ["lab.toml:2:1: ", "missing field `mass_kg`"]),
        (lab_with("mass_kg = 70", "mass_kg = -70"), ["lab.toml:3:8: preset 'lab_heel'", "mass is -70"]),
        (lab_with("spheres = 4", "spheres = 0"), ["lab.toml:3:8: preset 'lab_heel'", "sphere count is 0"]),
        (
            format!("{PRESETS_OF_LAB}hertz_smoothing = 300\n"),
            ["lab.toml:3:8: preset 'lab_heel'", "come together or not at all"],
        ),
        (lab_with("[[preset]]", "[preset]"), ["lab.toml:2:1: ", "expected a sequence"]),
        (lab_with("[[preset]]", "[[presets]]"), ["lab.toml:2:", "unknown field `presets`"]),
    ] {
        dir.write("lab.toml", &text);
        dir.run("presets --presets lab.toml").usage_error().wrote_nothing().says(&words);
    }
    dir.write("lab.toml", b"\xFF\xFE");
    dir.run("presets --presets lab.toml").usage_error().says(&["lab.toml: not UTF-8"]);
    dir.run("presets --presets nowhere.toml").usage_error().says(&["nowhere.toml", "no such file"]);
}

#[test]
fn presets_output_matches_its_snapshots() {
    let dir = TestDir::new();
    write_lab_presets(&dir);
    dir.run("presets --presets lab.toml").matches_snapshot("physics_presets");
    dir.write("bad.toml", PRESETS_OF_LAB.replace("stiffness", "stifness"));
    dir.run("presets --presets bad.toml").matches_snapshot("physics_presets_unknown_key");
}
