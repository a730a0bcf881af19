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
