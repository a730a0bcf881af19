//! With a `constant_contact_force` of 0, OpenSim computes NaN if a sphere does not slip. The program always finds and never writes it.

use crate::support::{CommandRun, HUMAN, TestDir, fixture};

const FINDING_CODE: &str = "zero-constant-contact-force";
const FOOT_MODEL: &str = "format/zero_dissipation.osim";

/// The text of a fixture, with `from` replaced by `to`.
fn fixture_with_replacement(name: &str, from: &str, to: &str) -> String {
    let text = String::from_utf8(fixture(name)).unwrap();
    assert!(text.contains(from), "{name} has no {from}");
    text.replace(from, to)
}

/// Asserts that the run is refused with a reason and a way out, and writes nothing.
#[track_caller]
fn assert_refused(run: CommandRun) {
    let run = run.wrote_nothing().says(&["constant_contact_force", "NaN", "does not slip", "0.05"]);
    assert!(matches!(run.status, Some(1 | 2)), "{:?}", run.status);
}

#[test]
fn every_verb_finds_a_zero_in_every_notation() {
    let zero = "<constant_contact_force>0</constant_contact_force>";
    let value = "<constant_contact_force>1.5e-05</constant_contact_force>";
    let smoothing = "<hertz_smoothing>111</hertz_smoothing>";
    let dir = TestDir::with(&[(FOOT_MODEL, "element.osim")]);
    let defaults =
        fixture_with_replacement("format/defaults_smooth.osim", smoothing, &format!("{smoothing}{zero}"));
    dir.write("defaults.osim", defaults.replace(value, ""));
    dir.write("underflow.osim", fixture_with_replacement(FOOT_MODEL, zero, &zero.replace('0', "1e-400")));
    dir.write("minus.osim", fixture_with_replacement(FOOT_MODEL, zero, &zero.replace('0', "-0")));
    let off = "<appliesForce>false</appliesForce>";
    dir.write(
        "off.osim",
        fixture_with_replacement("format/applies_force_false.osim", off, &format!("{off}{zero}")),
    );
    for model in ["element.osim", "defaults.osim", "underflow.osim", "minus.osim", "off.osim"] {
        dir.run(&format!("inspect {model}")).says(&[FINDING_CODE]);
        dir.run(&format!("check {model}")).says(&[FINDING_CODE]);
        dir.run(&format!("rescale {model} --target-mass 80 --contacts-mass 70 --dry-run"))
            .succeeded()
            .says(&[FINDING_CODE]);
        let transfer = format!("transfer {model} --from falisse2022 --only stiffness --spheres 1 --dry-run");
        dir.run(&transfer).succeeded().says(&[FINDING_CODE]);
    }
}

#[test]
fn a_zero_in_a_force_outside_the_selection_is_found() {
    let dir = TestDir::with_human();
    let text = dir.text("human.osim");
    let (before, after) = text.split_once("<transition_velocity>").unwrap();
    let zero = "<constant_contact_force>0</constant_contact_force>";
    dir.write("human.osim", format!("{before}{zero}<transition_velocity>{after}"));
    for call in ["check human.osim --select *_s2_*", "inspect human.osim --select *_s2_*"] {
        dir.run(call).says(&[FINDING_CODE, "contact_s1_r"]);
    }
}

#[test]
fn no_call_writes_a_zero_constant_contact_force() {
    let dir = TestDir::with(&[HUMAN, (FOOT_MODEL, "zero.osim")]);
    dir.write(
        "presets.toml",
        "[[preset]]\nname = \"lab\"\nsource = \"us\"\nmass_kg = 70\nspheres = 6\nradius_m = 0.03\n\
         gravity_m_s2 = 9.81\nstiffness = 1e6\ndissipation = 2\nconstant_contact_force = 0\n\
         hertz_smoothing = 300\nhunt_crossley_smoothing = 50\n",
    );
    dir.write("batch.csv", "verb,model,set,output\nset,human.osim,constant_contact_force=0,new.osim\n");
    dir.write(
        "request.json",
        r#"{"verb": "set", "models": ["human.osim"], "set": {"constant_contact_force": 0}, "output": "new.osim"}"#,
    );
    dir.run("set human.osim constant_contact_force=1e-300 --no-note -o tiny.osim").succeeded();
    for call in [
        "set human.osim constant_contact_force=0 -o new.osim",
        "set human.osim constant_contact_force=-0 -o new.osim",
        "set human.osim constant_contact_force=x0 -o new.osim",
        "set human.osim constant_contact_force=1e-400 -o new.osim",
        "set human.osim constant_contact_force=x1e-320 -o new.osim",
        "set human.osim constant_contact_force=0 --in-place",
        "design human.osim --constant-indentation 0 -o new.osim",
        "design human.osim --constant-indentation 1e-170 -o new.osim",
        "design --radius 0.03 --constant-indentation 0",
        "rescale tiny.osim --target-mass 80 --radius x1e-20 -o new.osim",
        "transfer human.osim --from tiny.osim --radius x1e-20 -o new.osim",
        "transfer human.osim --from zero.osim -o new.osim",
        "transfer human.osim --from lab --presets presets.toml -o new.osim",
        "sweep human.osim --grid constant_contact_force=1e-5,0,2e-5",
        "sweep human.osim --grid constant_contact_force=x1,x0",
        "batch batch.csv",
        "request request.json",
    ] {
        assert_refused(dir.run(call));
    }
}

#[test]
fn rescale_keeps_a_zero_and_reports_it_once() {
    let dir = TestDir::with(&[(FOOT_MODEL, "zero.osim")]);
    let run = dir.run("rescale zero.osim --target-mass 80 -o new.osim").succeeded();
    let output = format!("{}{}", run.out(), run.err());
    assert_eq!(output.matches(FINDING_CODE).count(), 1, "said once for its one force: {output}");
    assert!(dir.text("new.osim").contains("<constant_contact_force>0</constant_contact_force>"));
    // What stays is not written: setting the value that is there changes no byte.
    dir.run("set zero.osim constant_contact_force=0 --dry-run")
        .succeeded()
        .says(&["nothing-to-change", FINDING_CODE]);
    // The way out.
    dir.run("design zero.osim --constant-indentation 0.05 -o fixed.osim").succeeded();
    assert!(!dir.run("check fixed.osim").out().contains(FINDING_CODE));
}
