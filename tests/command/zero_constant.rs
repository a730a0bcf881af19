//! A `constant_contact_force` of 0, with which OpenSim computes NaN without slip: seen wherever it is read, never written.

use crate::support::{Bench, HUMAN, Ran, fixture};

const CODE: &str = "zero-constant-contact-force";
const FOOT: &str = "format/zero_dissipation.osim";

/// A fixture of text, with `from` replaced.
fn altered(name: &str, from: &str, to: &str) -> String {
    let text = String::from_utf8(fixture(name)).unwrap();
    assert!(text.contains(from), "{name} has no {from}");
    text.replace(from, to)
}

/// Refused with the reason and a way out, and nothing is written.
#[track_caller]
fn refused(ran: Ran) {
    let ran = ran.wrote_nothing().says(&["constant_contact_force", "NaN", "does not slip", "0.05"]);
    assert!(matches!(ran.status, Some(1 | 2)), "{:?}", ran.status);
}

#[test]
fn it_is_seen_by_every_verb_and_on_every_way_of_reading() {
    let zero = "<constant_contact_force>0</constant_contact_force>";
    let value = "<constant_contact_force>1.5e-05</constant_contact_force>";
    let smoothing = "<hertz_smoothing>111</hertz_smoothing>";
    let bench = Bench::with(&[(FOOT, "element.osim")]);
    let defaults = altered("format/defaults_smooth.osim", smoothing, &format!("{smoothing}{zero}"));
    bench.write("defaults.osim", defaults.replace(value, ""));
    bench.write("underflow.osim", altered(FOOT, zero, &zero.replace('0', "1e-400")));
    bench.write("minus.osim", altered(FOOT, zero, &zero.replace('0', "-0")));
    let off = "<appliesForce>false</appliesForce>";
    bench.write("off.osim", altered("format/applies_force_false.osim", off, &format!("{off}{zero}")));
    for model in ["element.osim", "defaults.osim", "underflow.osim", "minus.osim", "off.osim"] {
        bench.run(&format!("inspect {model}")).says(&[CODE]);
        bench.run(&format!("check {model}")).says(&[CODE]);
        bench
            .run(&format!("rescale {model} --target-mass 80 --contacts-mass 70 --dry-run"))
            .done()
            .says(&[CODE]);
        let transfer = format!("transfer {model} --from falisse2022 --only stiffness --spheres 1 --dry-run");
        bench.run(&transfer).done().says(&[CODE]);
    }
}

#[test]
fn a_force_outside_the_selection_is_seen_too() {
    let bench = Bench::human();
    let text = bench.text("human.osim");
    let (before, after) = text.split_once("<transition_velocity>").unwrap();
    let zero = "<constant_contact_force>0</constant_contact_force>";
    bench.write("human.osim", format!("{before}{zero}<transition_velocity>{after}"));
    for call in ["check human.osim --select *_s2_*", "inspect human.osim --select *_s2_*"] {
        bench.run(call).says(&[CODE, "contact_s1_r"]);
    }
}

#[test]
fn it_is_never_written() {
    let bench = Bench::with(&[HUMAN, (FOOT, "zero.osim")]);
    bench.write(
        "presets.toml",
        "[[preset]]\nname = \"lab\"\nsource = \"us\"\nmass_kg = 70\nspheres = 6\nradius_m = 0.03\n\
         gravity_m_s2 = 9.81\nstiffness = 1e6\ndissipation = 2\nconstant_contact_force = 0\n\
         hertz_smoothing = 300\nhunt_crossley_smoothing = 50\n",
    );
    bench.write("batch.csv", "verb,model,set,output\nset,human.osim,constant_contact_force=0,new.osim\n");
    bench.write(
        "request.json",
        r#"{"verb": "set", "models": ["human.osim"], "set": {"constant_contact_force": 0}, "output": "new.osim"}"#,
    );
    bench.run("set human.osim constant_contact_force=1e-300 --no-note -o tiny.osim").done();
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
        refused(bench.run(call));
    }
}

#[test]
fn a_model_that_has_it_keeps_it_when_scaled() {
    let bench = Bench::with(&[(FOOT, "zero.osim")]);
    let ran = bench.run("rescale zero.osim --target-mass 80 -o new.osim").done();
    let said = format!("{}{}", ran.out(), ran.err());
    assert_eq!(said.matches(CODE).count(), 1, "said once for its one force: {said}");
    assert!(bench.text("new.osim").contains("<constant_contact_force>0</constant_contact_force>"));
    // What stays is not written: setting the value that is there changes no byte.
    bench.run("set zero.osim constant_contact_force=0 --dry-run").done().says(&["nothing-to-change", CODE]);
    // The way out.
    bench.run("design zero.osim --constant-indentation 0.05 -o fixed.osim").done();
    assert!(!bench.run("check fixed.osim").out().contains(CODE));
}
