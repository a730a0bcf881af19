//! The note in a model lists the changes that made its contacts, with their references and dates.

use crate::json::json_lines;
use crate::json_types::Inspection;
use crate::support::TestDir;

/// The first 16 digits of the model's SHA-256, computed by the program `sha256sum`.
fn sha256_prefix(dir: &TestDir, name: &str) -> String {
    let output = std::process::Command::new("sha256sum").arg(dir.path(name)).output().unwrap();
    String::from_utf8(output.stdout).unwrap()[..16].to_owned()
}

#[test]
fn the_note_lists_each_step_with_its_reference_and_date() {
    let dir = TestDir::with_human();
    dir.run("transfer human.osim --from human.osim --stance-limbs 2 --radius x2 --only radius --mass 70 --output other.osim").succeeded();
    dir.run("transfer human.osim --from other.osim --mass 41 --reference-mass 62 --stance-limbs 2 --output made.osim").succeeded();
    dir.run("set made.osim dissipation=1.5 --output given.osim").succeeded();
    let run = dir.run("inspect given.osim --format json").succeeded();
    let [inspection]: [Inspection; 1] = json_lines(&run).try_into().unwrap();
    let note = inspection.note.unwrap();
    assert_eq!((note.version.as_str(), note.weighed_kg), (env!("CARGO_PKG_VERSION"), Some(62.0)));
    assert_eq!((note.stance_limbs, inspection.stance_limbs), (Some(2.0), 2.0));
    let [transfer, set] = note.steps.as_slice() else { panic!("{:?}", note.steps) };
    assert_eq!((transfer.operation.as_str(), transfer.from_mass_kg), ("transfer", Some(62.0)));
    assert_eq!(transfer.reference.as_deref(), Some("other.osim"));
    if cfg!(target_os = "linux") {
        assert_eq!(transfer.reference_digest, Some(sha256_prefix(&dir, "other.osim")));
    }
    assert_eq!((set.operation.as_str(), set.options.as_str()), ("set dissipation=1.5", ""));
    assert_eq!((transfer.date.as_deref(), set.date.as_deref()), (Some("2025-11-26"), Some("2025-11-26")));
    assert_eq!((set.reference.as_ref(), set.reference_digest.as_ref()), (None, None));
    assert!(note.changed_since.is_empty());
}

#[test]
fn inspect_names_what_changed_after_the_note() {
    let dir = TestDir::with_human();
    dir.run("rescale human.osim --target-mass 70 --output made.osim").succeeded();
    let text = dir.text("made.osim");
    dir.write("edited.osim", text.replacen("<radius>", "<radius>1", 1));
    let run = dir.run("inspect edited.osim --format json").succeeded();
    let [inspection]: [Inspection; 1] = json_lines(&run).try_into().unwrap();
    assert_eq!(inspection.note.unwrap().changed_since, ["radii"]);
}

#[test]
fn the_next_verb_uses_and_reports_the_stance_limbs_of_the_note() {
    let dir = TestDir::with_human();
    dir.run("note human.osim --contacts-mass 62 --stance-limbs 2 --output noted.osim").succeeded();
    let with_note = dir.run("design noted.osim --indentation 0.1 --output remembered.osim").succeeded();
    let text = format!("{}{}", with_note.out(), with_note.err());
    assert!(text.contains("2 limbs share the weight, as the note in the model says"), "{text}");
    dir.run("design human.osim --indentation 0.1 --stance-limbs 2 --output said.osim").succeeded();
    let stiffness = |name: &str| {
        let text = dir.text(name);
        text.split_once("<stiffness>").unwrap().1.split_once('<').unwrap().0.to_owned()
    };
    assert_eq!(stiffness("remembered.osim"), stiffness("said.osim"));
    dir.run("design noted.osim --indentation 0.1 --stance-limbs 1 --output one.osim").succeeded();
    assert_ne!(stiffness("one.osim"), stiffness("said.osim"));
}

#[test]
fn after_a_stale_note_the_contacts_mass_is_required() {
    let dir = TestDir::with(&[("check/stale_note.osim", "stale.osim")]);
    for (call, output) in [
        ("convert stale.osim --to hunt-crossley -o c.osim", "c.osim"),
        ("set stale.osim dissipation=1 -o s.osim", "s.osim"),
    ] {
        dir.run(call).succeeded();
        dir.run(&format!("rescale {output} --target-mass 70")).failed().says(&["--contacts-mass"]);
    }
}

#[test]
fn values_changed_by_other_programs_are_a_step_of_the_note() {
    let dir = TestDir::with_human();
    dir.run("transfer human.osim --from falisse2022 --mass 80 -o made.osim").succeeded();
    dir.write("edited.osim", dir.text("made.osim").replacen("<dissipation>", "<dissipation>1", 1));
    dir.run("convert edited.osim --to hunt-crossley -o converted.osim").succeeded();
    dir.run("remove edited.osim --select *s1_* -o part.osim").succeeded();
    for (output, operation, changed) in
        [("converted.osim", "convert", "dissipation"), ("part.osim", "remove", "dissipation")]
    {
        let run = dir.run(&format!("inspect {output} --format json")).succeeded();
        let [inspection]: [Inspection; 1] = json_lines(&run).try_into().unwrap();
        let note = inspection.note.unwrap();
        let steps: Vec<&str> = note.steps.iter().map(|step| step.operation.as_str()).collect();
        assert_eq!(steps, ["transfer", "others", operation]);
        assert_eq!(note.steps[0].reference.as_deref(), Some("falisse2022"));
        assert_eq!(note.changed_since, [changed], "{output}");
    }
}

#[test]
fn a_model_of_a_sweep_has_one_step() {
    let dir = TestDir::with_human();
    dir.run("sweep human.osim --grid target_mass=70 --grid stiffness=x2 -d out").succeeded();
    dir.run("sweep human.osim --ladder 2 --indentation 0.1 -d ladder").succeeded();
    for folder in ["out", "ladder"] {
        let file =
            dir.files().into_keys().find(|name| name.starts_with(folder) && name.ends_with(".osim")).unwrap();
        let run = dir.run(&format!("inspect {file} --format json")).succeeded();
        let [inspection]: [Inspection; 1] = json_lines(&run).try_into().unwrap();
        let note = inspection.note.unwrap();
        assert_eq!(note.steps.len(), 1, "{:?}", note.steps);
        assert_eq!(note.steps[0].reference, None);
    }
}

#[test]
fn stance_limbs_multiply_the_spheres_of_a_preset() {
    let dir = TestDir::with_human();
    let out = |call: &str| dir.run(call).succeeded().out();
    // Six spheres on one foot.
    assert_eq!(
        out("drop-test falisse2022 --stance-limbs 2 --format json"),
        out("drop-test falisse2022 --spheres 12 --format json")
    );
    let force = |options: &str| {
        dir.run(&format!("plot force falisse2022 {options} -o plot.svg --data plot.csv --force")).succeeded();
        dir.text("plot.csv")
    };
    assert_eq!(force("--stance-limbs 2"), force("--spheres 12"));
    assert_ne!(force("--stance-limbs 2"), force("--stance-limbs 1"));
}
