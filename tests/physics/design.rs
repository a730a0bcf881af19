//! `design`: what is known gives the rest; with models only what was asked for is written.

use std::collections::BTreeMap;

use crate::support::{Bench, HUMAN, Ran};
use crate::{assert_close, changed_lines, changes, object};

/// Table 1 as the paper prints it.
const PRINTED: &str = include_str!("../../crates/contact-scaling/src/table1/printed.csv");

/// The figures of the calculator by name.
#[track_caller]
fn sheet(arguments: &str) -> BTreeMap<String, f64> {
    let ran = Bench::new().run(&format!("design {arguments} --format json")).done().wrote_nothing();
    let sheet = object(&ran);
    assert_eq!(sheet["schema_version"], 1);
    let figures = sheet["figures"].as_array().unwrap();
    figures
        .iter()
        .map(|figure| (figure["name"].as_str().unwrap().to_owned(), figure["value"].as_f64().unwrap()))
        .collect()
}

#[track_caller]
fn has(sheet: &BTreeMap<String, f64>, name: &str, expected: f64, within: f64) {
    let seen = sheet.get(name).unwrap_or_else(|| panic!("no {name} in {sheet:?}"));
    assert_close(*seen, expected, within, name);
}

fn refused(arguments: &str) -> Ran {
    Bench::new().run(&format!("design {arguments}")).usage().wrote_nothing()
}

#[test]
fn equation_11_gives_the_moduli_of_table_1() {
    // Paper, Table 1: M, n, R, E* and E1* as printed, at the indentation of the text (0.3533). The printed mouse E*,
    // 0.0916, comes from a rounded 0.354 MPa; exact is 0.0915.
    for line in PRINTED.lines().skip(2) {
        let cells: Vec<&str> = line.split(',').collect();
        let [taxon, mass, spheres, radius, composite, stiffness, ..] = cells[..] else { panic!("{line}") };
        let [composite, stiffness] = [if taxon == "mouse" { "0.0915" } else { composite }, stiffness]
            .map(|mpa| mpa.parse::<f64>().unwrap() * 1e6);
        let sheet = sheet(&format!(
            "--mass {mass} --spheres {spheres} --radius {radius} --indentation 0.3533 --gravity 9.81"
        ));
        // Three printed digits.
        has(&sheet, "composite_modulus_n_m2", composite, 4e-3);
        has(&sheet, "stiffness", stiffness, 4e-3);
        // (B.3): 3/(2 · 0.3533).
        has(&sheet, "dimensionless_stiffness", 4.245_683_555_052_363, 1e-12);
    }
}

#[test]
fn every_figure_of_the_human_agrees_with_high_precision() {
    let sheet = sheet("--mass 62 --spheres 6 --radius 0.032 --stiffness 1e6 --gravity 9.81");
    // mpmath 1.3.0, 40 digits, from M = 62, n = 6, R = 0.032, E1* = 1e6, g = 9.81.
    for (name, expected) in [
        ("load_per_sphere_n", 101.37),
        ("relative_indentation", 0.353_300_157_597_401_94),
        ("indentation_m", 0.011_305_605_043_116_862),
        ("composite_modulus_n_m2", 353_553.390_593_273_76),
        ("stiffness", 1e6),
        ("contact_stiffness_n_m", 13_449.523_437_277_24),
        ("mean_contact_stress_n_m2", 89_189.922_386_373_82),
        ("contact_patch_diameter_m", 0.038_040_996_904_904_56),
        ("natural_frequency_hz", 5.741_870_060_573_218),
        ("equilibrium_frequency_hz", 5.741_870_060_573_218),
    ] {
        has(&sheet, name, expected, 1e-14);
    }
}

#[test]
fn a_stiffness_and_an_indentation_give_radius_and_modulus() {
    // (11) with (B.2): R = 3·300/(2·150000·0.1) = 0.03; E* = k/(2R√x̂) = 2.5e6·√10; E1* = 2^(3/2) E* = 1e7·√5.
    let sheet = sheet("--load 300 --spheres 1 --contact-stiffness 150000 --indentation 0.1");
    has(&sheet, "radius_m", 0.03, 1e-14);
    has(&sheet, "composite_modulus_n_m2", 7_905_694.150_420_948, 1e-14);
    has(&sheet, "stiffness", 22_360_679.774_997_897, 1e-14);
    // No body weight is known, so no frequency is.
    assert!(!sheet.contains_key("natural_frequency_hz") && !sheet.contains_key("equilibrium_frequency_hz"));
}

#[test]
fn body_weights_multiply_the_load() {
    let sheet =
        sheet("--mass 62 --body-weights 2.5 --spheres 6 --radius 0.032 --indentation 0.1 --gravity 9.81");
    has(&sheet, "load_per_sphere_n", 62.0 * 9.81 * 2.5 / 6.0, 1e-15);
    assert!(!sheet.contains_key("natural_frequency_hz"), "2.5 body weights are not what it carries at rest");
}

#[test]
fn youngs_modulus_and_poissons_ratio_give_the_stiffness_on_rigid_ground() {
    let sheet = sheet("--young 1e5 --poisson 0.49");
    // mpmath: 1e5/(1 − 0.49²), and 2^(3/2) times that.
    has(&sheet, "composite_modulus_n_m2", 131_596.262_666_140_28, 1e-15);
    has(&sheet, "stiffness", 372_210.438_840_135_6, 1e-14);
}

#[test]
fn restitution_gives_the_dissipation() {
    // 1 − 0.208 = 0.792 = α ẋ; theory: the exact restitution there is 0.550 where (13) says 0.208.
    let given = sheet("--restitution 0.208 --impact-speed 0.396");
    has(&given, "dissipation", 2.0, 1e-14);
    // mpmath: root of d − ln(1 + d) = −c d − ln(1 − c d) for d = 3/2 · 0.792.
    has(&given, "restitution_exact_at_this_dissipation", 0.549_476_064_408_366_5, 1e-9);
    // Without a speed: √(gR/2), a fall from a quarter of the radius.
    let fallen = sheet("--restitution 0.9 --radius 0.032 --gravity 9.81");
    has(&fallen, "dissipation", 0.252_409_388_673_076_1, 1e-14);
    has(&fallen, "restitution_exact_at_this_dissipation", 0.909_015_741_349_202_3, 1e-9);
    // The exact law, turned round.
    let turned = sheet("--restitution 0.549476064408366 --impact-speed 0.396");
    has(&turned, "dissipation_for_exact_restitution_s_m", 2.0, 1e-9);
}

#[test]
fn widths_give_the_smoothing() {
    let sheet = sheet(
        "--radius 0.032 --constant-indentation 0.1 --state-width 0.3 --speed-width 0.25 --threshold 0.01",
    );
    has(&sheet, "constant_contact_force", 1.024e-5, 1e-14);
    // mpmath: 2 atanh(0.98)/(0.3 · 0.032) and 2 atanh(0.98)/0.25.
    has(&sheet, "hertz_smoothing", 478.658_317_722_353_1, 1e-13);
    has(&sheet, "hunt_crossley_smoothing", 18.380_479_400_538_36, 1e-13);
    // Falisse et al. (2022): x̂_c = 0.0988 is cf = 1e-5 (three digits), and bd R = 9.6.
    let falisse = crate::design::sheet("--radius 0.032 --constant-indentation 0.0988");
    has(&falisse, "constant_contact_force", 1e-5, 1e-3);
}

/// What `design` of the human plans, as value and equation, and where the result is said to rest.
#[track_caller]
fn planned(arguments: &str) -> (f64, String, String) {
    let bench = Bench::with(&[HUMAN]);
    bench.run("set human.osim dissipation=20 -o damped.osim").done();
    let plan = object(&bench.run(&format!("design {arguments} --dry-run --format json")).done());
    let changes = plan["changes"].as_array().unwrap();
    let stiffness = changes.iter().find(|change| change["property"] == "stiffness").unwrap();
    let remarks = plan["remarks"].as_array().unwrap().iter().filter_map(|remark| remark.as_str());
    let rests = remarks.filter(|remark| remark.contains("rest at")).collect::<Vec<_>>().join("; ");
    (stiffness["to"].as_f64().unwrap(), stiffness["equation"].as_str().unwrap().to_owned(), rests)
}

#[test]
fn a_smoothed_force_gets_the_modulus_that_carries_the_load_at_rest() {
    // mpmath 1.4.1, 50 digits: 2^(3/2) 3 F / (4 R² x̂^(3/2) n) over 1/2 + 1/2 tanh(2 bv / (3 α)), with M = 62, n = 6,
    // g = 9.81, x̂ = 0.16 and the α, bv and R of the result. The law with cf and bd rests at 0.13561 in each.
    for (call, expected) in [
        // α = 50 s/m from (13), bv = 50 s/m.
        ("human.osim --indentation 0.16 --restitution 0 --impact-speed 0.02", 4_146_144.237_161_515_7),
        // bv = 9.81 s/m from (C.10), α = 2 s/m.
        ("human.osim --indentation 0.16 --speed-width 0.3", 3_285_947.750_885_746_4),
        // α = 17.9 s/m and bv = 44.7 s/m, carried along by the radius.
        ("damped.osim --indentation 0.16 --radius 0.04", 2_174_897.618_016_728_5),
    ] {
        let (stiffness, equation, rests) = planned(call);
        assert_close(stiffness, expected, 1e-12, call);
        assert_eq!(equation, "11, C.9", "{call}");
        assert!(rests.ends_with("x/R = 0.1356 under this load"), "{call}: {rests}");
    }
}

#[test]
fn where_nothing_is_missing_at_rest_it_is_equation_11_alone() {
    // tanh(2 · 50 / (3 · 0.5)) is 1 in binary64.
    let (stiffness, equation, rests) =
        planned("human.osim --indentation 0.16 --restitution 0.75 --impact-speed 0.5");
    // mpmath 1.4.1: 2^(3/2) 3 F / (4 R² x̂^(3/2) n).
    assert_close(stiffness, 3_281_223.193_765_884, 1e-12, "stiffness");
    assert_eq!(equation, "11");
    assert!(rests.contains("(C.9) at speed 0"), "{rests}");
    // A HuntCrossleyForce rests where (11) says.
    let bench = Bench::with(&[("table1/human_62kg_hunt_crossley.osim", "model.osim")]);
    let call = "design model.osim --indentation 0.16 --restitution 0 --impact-speed 0.02 --dry-run";
    let ran = bench.run(call).done().says(&["(11)"]);
    assert!(!ran.out().contains("C.9"), "{}", ran.out());
}

#[test]
fn the_calculator_knows_the_law_at_rest() {
    let load = "--mass 62 --spheres 6 --gravity 9.81 --indentation 0.16 --restitution 0 --speed-width 0.3";
    // mpmath 1.4.1, findroot: the radius at which α = 1/√(gR/2) and bv = 2 atanh(0.9)/0.3 leave so much of the force that
    // E1* = 1e6 carries the load at 0.16.
    let radius = sheet(&format!("{load} --stiffness 1e6"));
    has(&radius, "radius_m", 0.057_992_239_981_385_96, 1e-13);
    has(&radius, "dissipation", 1.874_975_305_427_459_7, 1e-13);
    let modulus = sheet(&format!("{load} --radius 0.057992239981385957"));
    has(&modulus, "stiffness", 1e6, 1e-13);
    // Without a dissipation nothing is known of it: (11).
    let hertz =
        sheet("--mass 62 --spheres 6 --gravity 9.81 --indentation 0.16 --radius 0.032 --speed-width 0.3");
    has(&hertz, "stiffness", 3_281_223.193_765_884, 1e-12);
}

#[test]
fn too_little_is_named() {
    refused("").says(&[
        "too little is known",
        "--radius",
        "--indentation",
        "--stiffness",
        "--contact-stiffness",
    ]);
    refused("--mass 62 --radius 0.032 --indentation 0.2")
        .says(&["known: radius, indentation", "the load needs --spheres"]);
    refused("--spheres 6 --radius 0.032 --indentation 0.2").says(&["--spheres needs --mass KG or --load N"]);
    refused("--mass 62 --spheres 6 --indentation 0.2")
        .says(&["known: load per sphere, indentation; add of: --radius"]);
    refused("--restitution 0.9").says(&["--impact-speed"]);
    refused("--constant-indentation 0.1").says(&["--constant-indentation needs a radius"]);
    refused("--state-width 0.1").says(&["--state-width needs a radius"]);
    refused("--body-weights 2 --spheres 6").says(&["--body-weights needs --mass"]);
    refused("--young 1e5").says(&["--poisson"]);
}

#[test]
fn contradictions_and_nonsense_are_refused() {
    let four = "--mass 62 --spheres 6 --radius 0.032 --indentation 0.3533";
    // By the option's own name and unit: 1 MPa follows (Table 1), not E*.
    refused(&format!("{four} --stiffness 2e6 --gravity 9.81"))
        .says(&["--stiffness is given as 2000000, but 100000"]);
    refused(&format!("{four} --contact-stiffness 5000"))
        .says(&["--contact-stiffness is given as 5000", "134"]);
    refused("--indentation 1.5").says(&["--indentation '1.5'", "at most 1"]);
    refused("--restitution 1.1").says(&["--restitution '1.1'"]);
    refused("--young 1e5 --poisson 0.6").says(&["--poisson '0.6'"]);
    refused("--threshold 0.5 --radius 1").says(&["--threshold '0.5'"]);
    refused("--radius keep").says(&["--radius needs metres"]);
    refused("--load 5 --body-weights 5").says(&["--load"]);
    refused("--stiffness 1e6 --young 1e5 --poisson 0.3").says(&["--stiffness"]);
}

#[test]
fn a_sphere_that_is_too_soft_is_said_to_be() {
    let bench = Bench::new();
    bench
        .run("design --mass 62 --spheres 6 --radius 0.0032 --stiffness 1e5")
        .done()
        .says(&["outside: at most 0.16", "softer than its load allows"]);
}

#[test]
fn with_a_model_an_indentation_writes_the_stiffness_and_nothing_else() {
    let bench = Bench::human();
    bench.run("design human.osim --indentation 0.16 -o out.osim").done().wrote(&["out.osim"]);
    let lines = changed_lines(&bench.text("human.osim"), &bench.text("out.osim"));
    assert_eq!(lines.len(), 12);
    // mpmath: 2^(3/2) · 3/4 · 62 · 9.81/6/(0.032² · 0.16^(3/2)), the model's gravity being 9.81.
    for (old, new) in lines {
        assert_eq!(old, "<stiffness>1000000</stiffness>");
        let text = new.trim_start_matches("<stiffness>").trim_end_matches("</stiffness>");
        assert_close(text.parse().unwrap(), 3_281_223.193_765_884, 1e-14, &new);
    }
    // The stiffness is made for the weight of the body, and so are the others taken to be.
    assert!(
        bench
            .text("out.osim")
            .contains("made for 62 kg at 9.81 m/s2 (osim-contact-scale 0.1.0; all; by design ")
    );
    bench.run("out.osim --target-mass 500 -o scaled.osim").done();
    // For another mass, or a load in newtons, the rest is not.
    for (other, note) in [("--mass 70", "made for 70 kg"), ("--load 300", "made for unknown")] {
        bench.run(&format!("design scaled.osim --indentation 0.16 {other} -o other.osim --force")).done();
        let text = bench.text("other.osim");
        assert!(text.contains(note) && text.contains("; partial; by design "), "{other}");
        bench.run("other.osim --target-mass 62").failed().says(&["--contacts-mass KG"]);
    }
    // What no load decides stays made for the mass of before.
    bench.run("design scaled.osim --restitution 0.9 -o calm.osim").done();
    assert!(
        bench
            .text("calm.osim")
            .contains("made for 500 kg at 9.81 m/s2 (osim-contact-scale 0.1.0; all; by design ")
    );
    // The tool reads its own result back as what was asked for.
    let ran = bench.run("drop-test out.osim --format json").done();
    assert_close(object(&ran)["relative_indentation_hertz"].as_f64().unwrap(), 0.16, 1e-12, "x̂");
}

#[test]
fn the_load_is_what_was_said() {
    let bench = Bench::human();
    let stiffness = |options: &str| {
        changes(
            &bench
                .run(&format!("design human.osim --indentation 0.16 {options} --dry-run --format json"))
                .done(),
        )["stiffness"]
            .1
    };
    let base = 3_281_223.193_765_884;
    // (11): E* ∝ F/n.
    assert_close(stiffness("--stance-limbs 2"), base / 2.0, 1e-14, "two limbs");
    assert_close(stiffness("--spheres 3"), base * 2.0, 1e-14, "three spheres");
    assert_close(stiffness("--body-weights 2.5"), base * 2.5, 1e-14, "body weights");
    assert_close(stiffness("--load 1000"), base * 1000.0 / (62.0 * 9.81), 1e-14, "load");
    assert_close(stiffness("--mass 31"), base / 2.0, 1e-14, "mass");
    assert_close(stiffness("--gravity 19.62"), base * 2.0, 1e-14, "gravity");
}

#[test]
fn a_new_radius_carries_along_what_is_not_designed() {
    let bench = Bench::human();
    let ran = bench.run("design human.osim --indentation 0.16 --radius 0.04 --dry-run --format json").done();
    let seen = changes(&ran);
    // ρ = 1.25: α and bv × ρ^(−1/2), cf × ρ², bd / ρ; the stiffness by (11) at the new radius (mpmath).
    let root = 0.894_427_190_999_915_9;
    for (name, from, to) in [
        ("radius", 0.032, 0.04),
        ("stiffness", 1e6, 2_099_982.844_010_166),
        ("dissipation", 2.0, 2.0 * root),
        ("constant_contact_force", 1e-5, 1.5625e-5),
        ("hertz_smoothing", 300.0, 240.0),
        ("hunt_crossley_smoothing", 50.0, 50.0 * root),
    ] {
        assert_eq!(seen[name].0, from, "{name}");
        assert_close(seen[name].1, to, 1e-14, name);
    }
    // Without an indentation the stiffness follows the radius too, E1* ∝ R^(−2).
    let ran = bench.run("design human.osim --radius x1.25 --dry-run --format json").done();
    assert_close(changes(&ran)["stiffness"].1, 1e6 / 1.5625, 1e-14, "stiffness");
}

#[test]
fn with_a_model_each_wish_writes_its_own_property() {
    let bench = Bench::human();
    let run = |options: &str| {
        changes(&bench.run(&format!("design human.osim {options} --dry-run --format json")).done())
    };
    // mpmath: 0.1/√(9.81 · 0.032/2); 0.1/0.5; 1e5/(1 − 0.49²) · 2^(3/2); (0.1 · 0.032)²; 2 atanh(0.9)/(0.3 · 0.032);
    // 2 atanh(0.9)/0.3.
    for (options, name, to) in [
        ("--restitution 0.9", "dissipation", 0.252_409_388_673_076_1),
        ("--restitution 0.9 --impact-speed 0.5", "dissipation", 0.2),
        ("--young 1e5 --poisson 0.49", "stiffness", 372_210.438_840_135_6),
        ("--constant-indentation 0.1", "constant_contact_force", 1.024e-5),
        ("--state-width 0.3", "hertz_smoothing", 306.712_393_663_170_9),
        ("--speed-width 0.3", "hunt_crossley_smoothing", 9.814_796_597_221_468),
    ] {
        let seen = run(options);
        assert_eq!(seen.keys().collect::<Vec<_>>(), [name], "{options}");
        assert_close(seen[name].1, to, 1e-13, options);
    }
    // (11) with (B.2): R = 3 F/(2 k x̂ n) with F/n = 101.37 N.
    let seen = run("--contact-stiffness 13449.5 --indentation 0.16");
    assert_close(seen["radius"].1, 3.0 * 101.37 / (2.0 * 13_449.5 * 0.16), 1e-14, "radius");
}

#[test]
fn a_design_of_everything_stands_for_the_model_and_can_be_scaled_on() {
    let bench = Bench::human();
    let all = "--indentation 0.16 --restitution 0.9 --constant-indentation 0.05 --state-width 0.3 --speed-width 0.3";
    bench.run(&format!("design human.osim {all} -o out.osim")).done();
    assert!(
        bench
            .text("out.osim")
            .contains("contacts made for 62 kg at 9.81 m/s2 (osim-contact-scale 0.1.0; all; by design ")
    );
    bench.run("out.osim --target-mass 500 --dry-run").done().says(&["contacts made for 62 kg (note"]);
}

#[test]
fn wrong_wishes_for_a_model_are_refused() {
    let bench = Bench::with(&[
        HUMAN,
        ("format/unequal_counts.osim", "unequal.osim"),
        ("format/no_gravity.osim", "g.osim"),
    ]);
    for (options, words) in [
        ("", "nothing is wanted"),
        ("--stiffness 1e6", "set MODEL stiffness=VALUE"),
        ("--young 1e5 --poisson 0.3 --indentation 0.2", "leave one out"),
        ("--contact-stiffness 1e4", "--contact-stiffness needs --indentation"),
        ("--contact-stiffness 1e4 --indentation 0.1 --radius 0.03", "leave out --radius"),
    ] {
        bench.run(&format!("design human.osim {options} --dry-run")).usage().says(&[words]);
    }
    bench.run("design unequal.osim --indentation 0.1").failed().wrote_nothing().says(&["--spheres N"]);
    bench.run("design g.osim --indentation 0.1 --spheres 2").failed().wrote_nothing().says(&["--gravity G"]);
    bench.run("design g.osim --restitution 0.9").failed().wrote_nothing().says(&["--impact-speed M/S"]);
}

#[test]
fn how_it_looks() {
    let bench = Bench::human();
    bench
        .run("design --mass 62 --spheres 6 --radius 0.032 --stiffness 1e6 --gravity 9.81 --constant-indentation 0.1 --state-width 0.3")
        .looks_like("physics_design");
    bench.run("design --young 1e5 --poisson 0.49 --format json").looks_like("physics_design_json");
    bench.run("design --mass 62 --radius 0.032").looks_like("physics_design_too_little");
    bench
        .run("design --load 300 --spheres 1 --indentation 0.1 --radius 0.03 --contact-stiffness 1e5")
        .looks_like("physics_design_contradictory");
    bench
        .run("design human.osim --indentation 0.16 --radius 0.04 -o out.osim")
        .looks_like("physics_design_model");
}
