//! Which mass is meant: the note, running twice, contacts that are there already.

use crate::bytes::{assert_close, line_changes, number, of};
use crate::support::{Bench, HUMAN};

#[test]
fn running_twice_goes_from_where_the_contacts_are() {
    let bench = Bench::human();
    bench
        .run("human.osim --target-mass 1190 -o a.osim")
        .done()
        .says(&["contacts taken as made for 62 kg", "9 bodies"]);
    let ran = bench.run("a.osim --target-mass 500 -o b.osim").done();
    ran.says(&["contacts made for 1190 kg", "note"]);
    let text = bench.text("b.osim");
    assert_eq!(text.matches("[contacts made for ").count(), 1, "the note is replaced, not repeated");
    assert!(text.contains("contacts made for 500 kg"));
    // To where they are: nothing.
    bench.run("b.osim --target-mass 500 --in-place").done().wrote_nothing().says(&["already"]);
    // To what the bodies weigh: back.
    bench.run("b.osim --target-mass 62 -o c.osim").done().says(&["contacts made for 500 kg"]);
}

#[test]
fn contacts_already_there_are_left_with_a_warning() {
    let bench = Bench::human();
    bench.run("human.osim --target-mass 62").done().wrote_nothing().says(&[
        "62 kg already",
        "--contacts-mass KG",
        "transfer --from MODEL",
        "already-at-target",
    ]);
    // Within 0.1 % too.
    bench.run("human.osim --target-mass 62.05").done().wrote_nothing().says(&["already-at-target"]);
    bench.run("human.osim --target-mass 62.07").done().wrote(&["human.scaled.osim"]);
}

#[test]
fn an_explicit_output_gets_an_identical_copy_when_nothing_changes() {
    let bench = Bench::human();
    bench.run("human.osim --target-mass 62 -o copy.osim").done().wrote(&["copy.osim"]);
    assert_eq!(bench.read("copy.osim"), bench.read("human.osim"));
    bench.run("human.osim --target-mass 62 -d out").done().wrote(&["out/human.osim"]);
    assert_eq!(bench.read("out/human.osim"), bench.read("human.osim"));
    let ran = bench.run("human.osim --target-mass 62 -o -").done().wrote_nothing();
    assert_eq!(ran.stdout, bench.read("human.osim"));
    bench.run("human.osim --target-mass 100 --radius keep --only dissipation -o same.osim").done();
    assert_eq!(bench.read("same.osim"), bench.read("human.osim"));
}

#[test]
fn a_model_that_was_scaled_but_not_its_contacts() {
    // The commonest case: bodies weigh 1190 kg, contacts are those of a 62 kg human.
    let bench = Bench::with(&[("table1/giraffe_smooth_sphere.osim", "giraffe.osim")]);
    bench.run("giraffe.osim --target-mass 1190").done().wrote_nothing().says(&["already-at-target"]);
    bench
        .run("giraffe.osim --target-mass 1190 --contacts-mass 62 -o out.osim")
        .done()
        .wrote(&["out.osim"])
        .says(&["contacts made for 62 kg (--contacts-mass)", "1190"]);
    // Where the bodies weigh neither, something is odd.
    bench
        .run("giraffe.osim --target-mass 500 --contacts-mass 62 --yes implausible-mass --dry-run")
        .done()
        .says(&["mass-sources-disagree", "1190 kg"]);
}

#[test]
fn a_partial_note_asks_for_the_mass() {
    for (options, left) in [
        ("--only stiffness", "a default property"),
        ("--keep dissipation", "a default property"),
        ("--select *_r*", "a force"),
    ] {
        let bench = Bench::human();
        bench.run(&format!("human.osim --target-mass 1190 {options} -o part.osim")).done();
        assert!(bench.text("part.osim").contains("; partial; "), "{left} was left behind by {options}");
        bench
            .run("part.osim --target-mass 500")
            .failed()
            .wrote_nothing()
            .says(&["--contacts-mass KG", "1190"]);
        bench.run("part.osim --target-mass 500 --contacts-mass 1190").done().wrote(&["part.scaled.osim"]);
    }
    let bench = Bench::human();
    bench.run("human.osim --target-mass 1190 --keep radius -o kept.osim").done();
    assert!(bench.text("kept.osim").contains("; all; "), "the others follow the radius that stays");
}

#[test]
fn an_edited_value_makes_the_note_stale() {
    let bench = Bench::human();
    bench.run("human.osim --target-mass 1190 -o a.osim").done();
    let edited = bench.text("a.osim").replacen("<dissipation>1.2", "<dissipation>1.3", 1);
    bench.write("edited.osim", edited);
    bench
        .run("edited.osim --target-mass 500")
        .failed()
        .wrote_nothing()
        .says(&["contacts were changed after this program left its note", "--contacts-mass KG"]);
    bench.run("edited.osim --target-mass 500 --contacts-mass 1190").done().wrote(&["edited.scaled.osim"]);
    // Other parts of the model may change freely.
    let other = bench.text("a.osim").replacen("<mass>42.0390625", "<mass>43", 1);
    bench.write("heavier.osim", other);
    bench.run("heavier.osim --target-mass 500").done().says(&["contacts made for 1190 kg (note"]);
}

#[test]
fn without_a_note_the_bodies_count_again() {
    let bench = Bench::human();
    bench.run("human.osim --target-mass 1190 --no-note -o a.osim").done();
    assert!(!bench.text("a.osim").contains("[contacts made for "));
    // Known contacts say what they were made for, and the bodies do not.
    bench
        .run("a.osim --target-mass 62")
        .failed()
        .wrote_nothing()
        .says(&["for a body of 1190 kg", "--contacts-mass 1190"]);
    bench.run("set a.osim stiffness=x1.1 --no-note -o b.osim").done();
    bench.run("b.osim --target-mass 62").done().wrote_nothing().says(&["already-at-target"]);
}

#[test]
fn without_a_new_note_the_old_one_is_not_believed() {
    let bench = Bench::human();
    bench.run("human.osim --target-mass 1190 -o a.osim").done();
    bench.run("a.osim --target-mass 500 --no-note -o b.osim").done();
    // The note of the run before speaks of other values: it is gone.
    assert!(bench.text("a.osim").contains("contacts made for 1190 kg"));
    assert!(!bench.text("b.osim").contains("contacts made for"));
    bench.run("b.osim --target-mass 100").says(&["62 kg"]);
}

#[test]
fn a_transfer_stands_for_the_models_own_mass() {
    let bench = Bench::with(&[("table1/mouse_smooth_sphere.osim", "mouse.osim"), HUMAN]);
    // The mouse of the table has the human's contact at its own size: the human on one foot, the mouse on two of four.
    let ran = bench
        .run("transfer mouse.osim --from human.osim --reference-spheres 6 --stance-limbs 2 -o same.osim")
        .done();
    ran.says(&["62 kg"]);
    let (removed, added) = line_changes(&bench.read("mouse.osim"), &bench.read("same.osim"));
    let added = added.iter().filter(|line| !line.starts_with("<!--"));
    for (before, after) in removed.iter().zip(added) {
        assert_close(number(after), number(before), 1e-13, before);
    }
    // On all four: half the load on each, half the modulus; Table 1 prints 0.259 MPa for two.
    bench
        .run("transfer mouse.osim --from human.osim --reference-spheres 6 --stance-limbs 4 -o four.osim")
        .done();
    let (_, added) = line_changes(&bench.read("mouse.osim"), &bench.read("four.osim"));
    assert_eq!(of(&added, "stiffness").len(), 4);
    for line in of(&added, "stiffness") {
        assert!((number(line) / 1e6 - 0.259 / 2.0).abs() < 0.0005, "{line}");
    }
    bench
        .run("four.osim --target-mass 0.0418 -o twice.osim")
        .done()
        .says(&["contacts made for 0.0209 kg (note"]);
}

#[test]
fn a_relative_change_is_not_made_twice_by_accident() {
    let bench = Bench::human();
    bench.run("set human.osim stiffness=x2 --in-place --no-backup").done().wrote(&["human.osim"]);
    let (_, added) = line_changes(&crate::support::fixture(HUMAN.0), &bench.read("human.osim"));
    assert_eq!(of(&added, "stiffness"), ["<stiffness>2000000</stiffness>"; 12]);
    bench
        .run("set human.osim stiffness=x2 --in-place --no-backup")
        .failed()
        .wrote_nothing()
        .says(&["--force"]);
    bench.run("set human.osim stiffness=x2 --in-place --no-backup --force").done().wrote(&["human.osim"]);
    assert!(bench.text("human.osim").contains("<stiffness>4000000</stiffness>"));
    // An absolute change may be said again.
    bench.run("set human.osim stiffness=5e6 --in-place --no-backup").done().wrote(&["human.osim"]);
    bench.run("set human.osim stiffness=5e6 --in-place --no-backup").done().wrote_nothing();
    // What the contacts are made for stays as it was: what the bodies weigh is taken.
    bench.run("human.osim --target-mass 500").done().says(&["contacts taken as made for 62 kg"]);
}
