//! A model that somebody received: its note says who made its contacts from what.

use crate::contract::Inspection;
use crate::json::lines;
use crate::support::Bench;

/// `sha256sum` of the model, its first 16 digits, as another program computes them.
fn sha256sum(bench: &Bench, name: &str) -> String {
    let output = std::process::Command::new("sha256sum").arg(bench.path(name)).output().unwrap();
    String::from_utf8(output.stdout).unwrap()[..16].to_owned()
}

#[test]
fn the_note_tells_who_made_the_contacts_from_what_and_when() {
    let bench = Bench::human();
    bench.run("transfer human.osim --from human.osim --stance-limbs 2 --radius x2 --only radius --mass 70 --output other.osim").done();
    bench.run("transfer human.osim --from other.osim --mass 41 --reference-mass 62 --stance-limbs 2 --output made.osim").done();
    bench.run("set made.osim dissipation=1.5 --output given.osim").done();
    let ran = bench.run("inspect given.osim --format json").done();
    let [seen]: [Inspection; 1] = lines(&ran).try_into().unwrap();
    let note = seen.note.unwrap();
    assert_eq!((note.version.as_str(), note.weighed_kg), (env!("CARGO_PKG_VERSION"), Some(62.0)));
    assert_eq!((note.stance_limbs, seen.stance_limbs), (Some(2.0), 2.0));
    let [transfer, set] = note.steps.as_slice() else { panic!("{:?}", note.steps) };
    assert_eq!((transfer.operation.as_str(), transfer.from_mass_kg), ("transfer", Some(62.0)));
    assert_eq!(transfer.reference.as_deref(), Some("other.osim"));
    if cfg!(target_os = "linux") {
        assert_eq!(transfer.reference_digest, Some(sha256sum(&bench, "other.osim")));
    }
    assert_eq!((set.operation.as_str(), set.options.as_str()), ("set dissipation=1.5", ""));
    assert_eq!((transfer.date.as_deref(), set.date.as_deref()), (Some("2025-11-26"), Some("2025-11-26")));
    assert_eq!((set.reference.as_ref(), set.reference_digest.as_ref()), (None, None));
    assert!(note.changed_since.is_empty());
}

#[test]
fn the_note_says_what_changed_since() {
    let bench = Bench::human();
    bench.run("rescale human.osim --target-mass 70 --output made.osim").done();
    let text = bench.text("made.osim");
    bench.write("edited.osim", text.replacen("<radius>", "<radius>1", 1));
    let ran = bench.run("inspect edited.osim --format json").done();
    let [seen]: [Inspection; 1] = lines(&ran).try_into().unwrap();
    assert_eq!(seen.note.unwrap().changed_since, ["radii"]);
}

#[test]
fn stance_limbs_that_were_said_once_are_used_by_the_next_verb_which_says_so() {
    let bench = Bench::human();
    bench.run("note human.osim --contacts-mass 62 --stance-limbs 2 --output noted.osim").done();
    let remembered = bench.run("design noted.osim --indentation 0.1 --output remembered.osim").done();
    let text = format!("{}{}", remembered.out(), remembered.err());
    assert!(text.contains("2 limbs share the weight, as the note in the model says"), "{text}");
    bench.run("design human.osim --indentation 0.1 --stance-limbs 2 --output said.osim").done();
    let value = |name: &str| {
        let text = bench.text(name);
        text.split_once("<stiffness>").unwrap().1.split_once('<').unwrap().0.to_owned()
    };
    assert_eq!(value("remembered.osim"), value("said.osim"));
    bench.run("design noted.osim --indentation 0.1 --stance-limbs 1 --output one.osim").done();
    assert_ne!(value("one.osim"), value("said.osim"));
}

#[test]
fn a_note_that_cannot_be_read_leaves_one_in_doubt() {
    let bench = Bench::with(&[("check/stale_note.osim", "stale.osim")]);
    for (call, made) in [
        ("convert stale.osim --to hunt-crossley -o c.osim", "c.osim"),
        ("set stale.osim dissipation=1 -o s.osim", "s.osim"),
    ] {
        bench.run(call).done();
        bench.run(&format!("rescale {made} --target-mass 70")).failed().says(&["--contacts-mass"]);
    }
}

#[test]
fn values_that_others_changed_are_a_step_and_no_other_step_is_lost() {
    let bench = Bench::human();
    bench.run("transfer human.osim --from falisse2022 --mass 80 -o made.osim").done();
    bench.write("edited.osim", bench.text("made.osim").replacen("<dissipation>", "<dissipation>1", 1));
    bench.run("convert edited.osim --to hunt-crossley -o converted.osim").done();
    bench.run("remove edited.osim --select *s1_* -o part.osim").done();
    for (made, operation, changed) in
        [("converted.osim", "convert", "dissipation"), ("part.osim", "remove", "dissipation")]
    {
        let ran = bench.run(&format!("inspect {made} --format json")).done();
        let [seen]: [Inspection; 1] = lines(&ran).try_into().unwrap();
        let note = seen.note.unwrap();
        let steps: Vec<&str> = note.steps.iter().map(|step| step.operation.as_str()).collect();
        assert_eq!(steps, ["transfer", "others", operation]);
        assert_eq!(note.steps[0].reference.as_deref(), Some("falisse2022"));
        assert_eq!(note.changed_since, [changed], "{made}");
    }
}

#[test]
fn a_point_of_a_sweep_is_one_step() {
    let bench = Bench::human();
    bench.run("sweep human.osim --grid target_mass=70 --grid stiffness=x2 -d out").done();
    bench.run("sweep human.osim --ladder 2 --indentation 0.1 -d ladder").done();
    for folder in ["out", "ladder"] {
        let file = bench
            .files()
            .into_keys()
            .find(|name| name.starts_with(folder) && name.ends_with(".osim"))
            .unwrap();
        let ran = bench.run(&format!("inspect {file} --format json")).done();
        let [seen]: [Inspection; 1] = lines(&ran).try_into().unwrap();
        let note = seen.note.unwrap();
        assert_eq!(note.steps.len(), 1, "{:?}", note.steps);
        assert_eq!(note.steps[0].reference, None);
    }
}

#[test]
fn a_preset_stands_on_as_many_limbs_as_are_said() {
    let bench = Bench::human();
    let out = |call: &str| bench.run(call).done().out();
    // Six spheres on one foot.
    assert_eq!(
        out("drop-test falisse2022 --stance-limbs 2 --format json"),
        out("drop-test falisse2022 --spheres 12 --format json")
    );
    let force = |options: &str| {
        bench.run(&format!("plot force falisse2022 {options} -o plot.svg --data plot.csv --force")).done();
        bench.text("plot.csv")
    };
    assert_eq!(force("--stance-limbs 2"), force("--spheres 12"));
    assert_ne!(force("--stance-limbs 2"), force("--stance-limbs 1"));
}
