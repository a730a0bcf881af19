//! What the note tells, and masses that contradict it.

use crate::support::Bench;

/// A human whose contacts were made for 62 kg, with a note, and one made for 41 kg.
fn noted() -> Bench {
    let bench = Bench::human();
    bench.run("note human.osim --contacts-mass 62 -o lib/adult.osim").done();
    bench.run("human.osim --target-mass 41 -o lib/child.osim").done();
    bench.write("lib/plain.osim", bench.read("human.osim"));
    bench
}

fn edited(bench: &Bench, edits: &[(&str, &str)]) -> String {
    let mut text = bench.text("lib/adult.osim");
    for (from, to) in edits {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    bench.write("edited.osim", text);
    bench.run("inspect edited.osim").done().out().replace('\n', " ")
}

#[test]
fn inspect_names_what_changed_since_the_note() {
    let bench = noted();
    assert!(!edited(&bench, &[]).contains("Changed since"));
    for (from, to, named) in [
        ("<stiffness>", "<stiffness>1", "Changed since: stiffness."),
        ("<dissipation>", "<dissipation>1", "Changed since: dissipation."),
        ("<static_friction>", "<static_friction>1", "Changed since: static_friction."),
        ("<radius>", "<radius>1", "Changed since: radii."),
    ] {
        let shown = edited(&bench, &[(from, to)]);
        assert!(shown.contains(named) && shown.contains("not known"), "{named}: {shown}");
    }
    let both = edited(&bench, &[("<radius>", "<radius>1"), ("<viscous_friction>", "<viscous_friction>1")]);
    assert!(both.contains("Changed since: radii; viscous_friction."), "{both}");
    let heavier = edited(&bench, &[("<mass>42", "<mass>142")]);
    let named = "Changed since: the bodies weighed 62 kg then and weigh 162 kg now.";
    assert!(heavier.contains(named), "{heavier}");
}

/// A new name changes no number: the mass of the note is still taken.
#[test]
fn a_sphere_with_a_new_name_puts_no_mass_in_doubt() {
    let bench = noted();
    let text = bench.text("lib/adult.osim");
    let (_, rest) = text.split_once("<ContactSphere name=\"").unwrap();
    let name = &rest[..rest.find('"').unwrap()];
    let (old, new, path) = (format!("name=\"{name}\""), "name=\"another\"", format!("/{name}<"));
    let shown = edited(&bench, &[(old.as_str(), new), (path.as_str(), "/another<")]);
    assert!(shown.contains("Changed since: names of spheres."), "{shown}");
    assert!(shown.contains("contacts made for: 62 kg (note in the file)"), "{shown}");
    bench.run("edited.osim --target-mass 80 -o out.osim").done().says(&["62 kg (note in the file)"]);
}

#[test]
fn stance_limbs_alone_are_recorded() {
    let bench = noted();
    // Beside what the note says.
    bench.run("note lib/child.osim --stance-limbs 2 -o limbs.osim").done().says(&["2 stance limbs"]);
    let shown = bench.run("inspect limbs.osim").done().out().replace('\n', " ");
    assert!(shown.contains("These contacts were made for 41 kg, with 2 stance limbs"), "{shown}");
    bench.run("note limbs.osim --stance-limbs 2 -o same.osim").says(&["2 stance limbs already"]);
    // Without a note the contacts are taken as made for the bodies, as without it.
    bench.run("note human.osim --stance-limbs 2 -o first.osim").done();
    let ran = bench.run("first.osim --target-mass 80 -o out.osim").done();
    ran.says(&["62 kg"]);
    // A note that does not fit goes on not fitting.
    let stale = bench.text("lib/adult.osim").replace("<dissipation>", "<dissipation>1");
    bench.write("stale.osim", stale);
    bench.run("note stale.osim --stance-limbs 2 -o doubt.osim").done();
    bench.run("doubt.osim --target-mass 80 -o no.osim").ends_with(1).says(&["--contacts-mass"]);
    // Neither is given.
    bench.run("note human.osim").ends_with(2).says(&["--contacts-mass"]);
}

#[test]
fn one_mass_for_a_library_is_not_taken_against_a_note() {
    let bench = noted();
    let library = "lib --contacts-mass 62 --target-mass 80 --format lines";
    let ran = bench.run(&format!("{library} -d out --summary s.csv")).ends_with(1);
    ran.says(&["the note in this one says 41 kg", "--yes against-note", "3 models: 2 written, 1 failed"]);
    assert!(bench.has("out/adult.osim") && bench.has("out/plain.osim") && !bench.has("out/child.osim"));
    let summary = bench.text("s.csv");
    let row = summary.lines().find(|line| line.contains("lib/child.osim")).unwrap();
    assert!(row.contains(",failed,") && row.contains("against-note"), "{row}");
    // Going on does not do it either.
    let again = bench.run(&format!("{library} -d out --summary s.csv --resume")).ends_with(1);
    again.says(&["against-note"]);
    assert!(!bench.has("out/child.osim"));
    // The ways out: by itself, as a row of a table, and yes.
    bench
        .run("lib/child.osim --contacts-mass 62 --target-mass 80 -o alone.osim")
        .done()
        .says(&["the note in the file says 41 kg", "mass-sources-disagree"]);
    bench.write("t.csv", "model,contacts-mass,target-mass,output\nlib/child.osim,62,80,row.osim\n");
    bench.run("batch t.csv").done().wrote(&["row.osim"]);
    assert_eq!(bench.text("alone.osim").matches("made for 80 kg").count(), 1);
    let ran = bench.run(&format!("{library} -d meant --yes against-note")).done();
    ran.says(&["3 written"]);
    // A note over a note, too.
    let ran = bench.run("note lib/adult.osim lib/child.osim --contacts-mass 62 -d notes").ends_with(1);
    ran.says(&["against-note"]);
    let ran = bench.run("note lib/child.osim --contacts-mass 62 -o noted.osim").done();
    ran.says(&["the note in the file says 41 kg"]);
}

/// Published contacts under a body of another mass: a doubt, which the sentence names.
#[test]
fn check_does_not_call_contacts_right_that_may_be_for_another_mass() {
    let bench = Bench::with(&[("check/known_contacts.osim", "known.osim")]);
    let text = bench.text("known.osim");
    // 78.2 kg: the body that the source of these contacts put them under.
    bench.write("published.osim", text.replace("<mass>60</mass>", "<mass>76.2</mass>"));
    let words = |out: String| out.split_whitespace().collect::<Vec<_>>().join(" ");
    let out = words(bench.run("check published.osim").out());
    assert!(out.starts_with("published.osim: nothing is wrong for certain;"), "{out}");
    assert!(out.contains("made for 62 kg, and the body weighs 78.2 kg"), "{out}");
    // Once somebody says so, it is certain.
    bench.run("note published.osim --contacts-mass 62 -o noted.osim").done();
    let out = words(bench.run("check noted.osim").out());
    assert!(out.contains("made for 62 kg (note in the file), but the sum of 5 bodies says 78.2 kg"), "{out}");
    // Contacts that are right are still called so.
    bench.write("right.osim", text);
    assert!(!words(bench.run("check right.osim").out()).contains("for certain"));
}
