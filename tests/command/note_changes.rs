//! Changes of a model after its note was written, and masses that contradict the note.

use crate::support::TestDir;

/// A folder with two humans that have notes: one with contacts made for 62 kg, one with contacts made for 41 kg.
fn dir_with_notes() -> TestDir {
    let dir = TestDir::with_human();
    dir.write("lib/plain.osim", dir.read("human.osim"));
    dir.run("note human.osim --contacts-mass 62 -o lib/adult.osim").succeeded();
    dir.run("human.osim --target-mass 41 -o lib/child.osim").succeeded();
    dir
}

fn inspect_edited(dir: &TestDir, edits: &[(&str, &str)]) -> String {
    let mut text = dir.text("lib/adult.osim");
    for (from, to) in edits {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    dir.write("edited.osim", text);
    dir.run("inspect edited.osim").succeeded().out().replace('\n', " ")
}

#[test]
fn inspect_names_each_value_changed_after_the_note() {
    let dir = dir_with_notes();
    assert!(!inspect_edited(&dir, &[]).contains("Changed since"));
    for (from, to, expected) in [
        ("<stiffness>", "<stiffness>1", "Changed since: stiffness."),
        ("<dissipation>", "<dissipation>1", "Changed since: dissipation."),
        ("<static_friction>", "<static_friction>1", "Changed since: static_friction."),
        ("<radius>", "<radius>1", "Changed since: radii."),
    ] {
        let inspection = inspect_edited(&dir, &[(from, to)]);
        assert!(
            inspection.contains(expected) && inspection.contains("not known"),
            "{expected}: {inspection}"
        );
    }
    let two_edits =
        inspect_edited(&dir, &[("<radius>", "<radius>1"), ("<viscous_friction>", "<viscous_friction>1")]);
    assert!(two_edits.contains("Changed since: radii; viscous_friction."), "{two_edits}");
    let heavier = inspect_edited(&dir, &[("<mass>42", "<mass>142")]);
    let expected = "Changed since: the bodies weighed 62 kg then and weigh 162 kg now.";
    assert!(heavier.contains(expected), "{heavier}");
}

/// A new name changes no number, so the program still uses the mass in the note.
#[test]
fn a_renamed_sphere_does_not_invalidate_the_note() {
    let dir = dir_with_notes();
    let text = dir.text("lib/adult.osim");
    let (_, rest) = text.split_once("<ContactSphere name=\"").unwrap();
    let name = &rest[..rest.find('"').unwrap()];
    let (old, new, path) = (format!("name=\"{name}\""), "name=\"another\"", format!("/{name}<"));
    let inspection = inspect_edited(&dir, &[(old.as_str(), new), (path.as_str(), "/another<")]);
    assert!(inspection.contains("Changed since: names of spheres."), "{inspection}");
    assert!(inspection.contains("contacts made for: 62 kg (note in the file)"), "{inspection}");
    dir.run("edited.osim --target-mass 80 -o out.osim").succeeded().says(&["62 kg (note in the file)"]);
}

#[test]
fn note_records_stance_limbs_alone() {
    let dir = dir_with_notes();
    // Beside what the note says.
    dir.run("note lib/child.osim --stance-limbs 2 -o limbs.osim").succeeded().says(&["2 stance limbs"]);
    let inspection = dir.run("inspect limbs.osim").succeeded().out().replace('\n', " ");
    assert!(inspection.contains("These contacts were made for 41 kg, with 2 stance limbs"), "{inspection}");
    dir.run("note limbs.osim --stance-limbs 2 -o same.osim").says(&["2 stance limbs already"]);
    // A note without a mass: the mass of the bodies is used.
    dir.run("note human.osim --stance-limbs 2 -o first.osim").succeeded();
    let run = dir.run("first.osim --target-mass 80 -o out.osim").succeeded();
    run.says(&["62 kg"]);
    // A stale note stays stale.
    let stale = dir.text("lib/adult.osim").replace("<dissipation>", "<dissipation>1");
    dir.write("stale.osim", stale);
    dir.run("note stale.osim --stance-limbs 2 -o doubt.osim").succeeded();
    dir.run("doubt.osim --target-mass 80 -o no.osim").exited_with(1).says(&["--contacts-mass"]);
    // Without either option the call is refused, and so is a model that has nothing to note.
    dir.run("note human.osim").exited_with(2).says(&["--contacts-mass"]);
    dir.run("note --contacts-mass 62").usage_error().says(&["no model given"]);
    dir.run("remove human.osim -o bare.osim").succeeded();
    let run = dir.run("note bare.osim --contacts-mass 62").failed().wrote_nothing();
    run.says(&["the model has no contacts"]);
}

#[test]
fn one_mass_for_many_models_does_not_override_a_note() {
    let dir = dir_with_notes();
    let library = "lib --contacts-mass 62 --target-mass 80 --format lines";
    let run = dir.run(&format!("{library} -d out --summary s.csv")).exited_with(1);
    run.says(&["the note in this one says 41 kg", "--yes against-note", "3 models: 2 written, 1 failed"]);
    assert!(dir.has("out/adult.osim") && dir.has("out/plain.osim") && !dir.has("out/child.osim"));
    let summary = dir.text("s.csv");
    let row = summary.lines().find(|line| line.contains("lib/child.osim")).unwrap();
    assert!(row.contains(",failed,") && row.contains("against-note"), "{row}");
    // Resuming does not override it either.
    let resumed = dir.run(&format!("{library} -d out --summary s.csv --resume")).exited_with(1);
    resumed.says(&["against-note"]);
    assert!(!dir.has("out/child.osim"));
    // The ways out: by itself, as a row of a table, and yes.
    dir.run("lib/child.osim --contacts-mass 62 --target-mass 80 -o alone.osim")
        .succeeded()
        .says(&["the note in the file says 41 kg", "mass-sources-disagree"]);
    dir.write("t.csv", "model,contacts-mass,target-mass,output\nlib/child.osim,62,80,row.osim\n");
    dir.run("batch t.csv").succeeded().wrote(&["row.osim"]);
    assert_eq!(dir.text("alone.osim").matches("made for 80 kg").count(), 1);
    let run = dir.run(&format!("{library} -d answered --yes against-note")).succeeded();
    run.says(&["3 written"]);
    // A note over a note, too.
    let run = dir.run("note lib/adult.osim lib/child.osim --contacts-mass 62 -d notes").exited_with(1);
    run.says(&["against-note"]);
    let run = dir.run("note lib/child.osim --contacts-mass 62 -o noted.osim").succeeded();
    run.says(&["the note in the file says 41 kg"]);
}

/// The model has published contacts and a body of another mass. The message says that the contacts may be for another mass.
#[test]
fn check_reports_doubt_if_contacts_may_be_for_another_mass() {
    let dir = TestDir::with(&[("check/known_contacts.osim", "known.osim")]);
    let text = dir.text("known.osim");
    // 78.2 kg: the body that the source of these contacts put them under.
    dir.write("published.osim", text.replace("<mass>60</mass>", "<mass>76.2</mass>"));
    let on_one_line = |out: String| out.split_whitespace().collect::<Vec<_>>().join(" ");
    let out = on_one_line(dir.run("check published.osim").out());
    assert!(out.starts_with("published.osim: 1 remark; the contact parameters are those of"), "{out}");
    assert!(
        out.contains("the contacts are for 62 kg (OpenCap's Lai-Arnold model), the body weighs 78.2 kg"),
        "{out}"
    );
    // With a note it is certain.
    dir.run("note published.osim --contacts-mass 62 -o noted.osim").succeeded();
    let out = on_one_line(dir.run("check noted.osim").out());
    assert!(out.contains("made for 62 kg (note in the file), but the sum of 5 bodies says 78.2 kg"), "{out}");
    // Contacts that are right are still called so.
    dir.write("right.osim", text);
    assert!(on_one_line(dir.run("check right.osim").out()).contains("right.osim: nothing is wrong;"));
}
