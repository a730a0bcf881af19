//! Tests of the changes that a note detects if its file was edited later.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use crate::given::fixture;
use osim_model::{ChangedContacts, ChangedSinceNote, FileId, Model, NoteDoubt, Property};
use osim_patch::note;

const SMOOTH: &str = "table1/human_62kg_smooth_sphere.osim";
const HUNT_CROSSLEY: &str = "scale_tool/generic_hunt_crossley.osim";

/// The fixture with a note that its contacts were made for 62 kg.
fn fixture_with_note(name: &str) -> String {
    let model = Model::parse(fixture(name)).unwrap();
    let plan = note(&model, 62.0, Some(9.81), None).unwrap();
    String::from_utf8(plan.patched(&model, FileId::MAIN).unwrap()).unwrap()
}

#[track_caller]
fn edited_model(text: &str, edits: &[(&str, &str)]) -> Model {
    let mut text = text.to_owned();
    for (from, to) in edits {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    Model::parse(text).unwrap()
}

fn no_changes_since_note() -> ChangedSinceNote {
    ChangedSinceNote::default()
}

#[track_caller]
fn assert_properties(changed: &ChangedSinceNote, expected: &[Property], what: &str) {
    let mut all = no_changes_since_note();
    all.contacts.properties.extend(expected);
    assert_eq!(*changed, all, "{what}");
}

/// Every property of a force, in both classes, is named if its number changed, and no other property is named.
#[test]
fn a_changed_property_is_named() {
    for name in [SMOOTH, HUNT_CROSSLEY] {
        let text = fixture_with_note(name);
        assert_eq!(Model::parse(text.clone()).unwrap().changed_since_note(), no_changes_since_note());
        let mut found = 0;
        for property in Property::changeable().filter(|property| *property != Property::Radius) {
            let open = format!("<{}>", property.as_str());
            if !text.contains(&open) {
                continue;
            }
            found += 1;
            let model = edited_model(&text, &[(&open, &format!("{open}1"))]);
            assert_properties(&model.changed_since_note(), &[property], property.as_str());
            assert_eq!(model.doubt_about_note(), Some(NoteDoubt::ValuesChanged));
        }
        assert!(found >= 6, "{name}: {found}");
    }
}

#[test]
fn all_changed_properties_are_named_together() {
    let text = fixture_with_note(SMOOTH);
    let both = edited_model(&text, &[("<stiffness>", "<stiffness>1"), ("<radius>", "<radius>1")])
        .changed_since_note();
    let ChangedContacts { radii: true, places: false, exchanged: false, properties, .. } = both.contacts
    else {
        panic!("{both:?}");
    };
    assert_eq!((properties, both.weight_kg), (vec![Property::Stiffness], None));
    let (then, now) =
        edited_model(&text, &[("<mass>42", "<mass>142")]).changed_since_note().weight_kg.unwrap();
    assert!((then - 62.0).abs() < 1e-9 && (now - 162.0).abs() < 1e-9, "{then} {now}");
}

#[test]
fn a_moved_sphere_is_named_and_leaves_the_noted_mass_valid() {
    let text = fixture_with_note(SMOOTH);
    let (_, spheres) = text.split_once("<ContactSphere name=").unwrap();
    let (location, _) = spheres.split_once("<location>").unwrap().1.split_once('<').unwrap();
    let model = edited_model(&text, &[(&format!("<location>{location}<"), "<location>1 1 1<")]);
    let changed = model.changed_since_note();
    assert!(matches!(
        changed.contacts,
        ChangedContacts { places: true, radii: false, sphere_names: false, exchanged: false, .. }
    ));
    assert_eq!(model.doubt_about_note(), None);
}

/// A new name changes no number: the note stays valid, and the places of the spheres still match it.
#[test]
fn renamed_objects_are_named_and_leave_the_note_valid() {
    let text = fixture_with_note(SMOOTH);
    let plain = Model::parse(text.clone()).unwrap();
    let (sphere, force) = (plain.spheres()[0].name.clone(), plain.forces()[0].name.clone());
    for (name, of_spheres) in [(sphere, true), (force, false)] {
        let (named, path) = (format!("name=\"{name}\""), format!("/{name}<"));
        let edits = [(named.as_str(), "name=\"another\""), (path.as_str(), "/another<")];
        let model = edited_model(&text, if of_spheres { &edits } else { &edits[..1] });
        let changed = model.changed_since_note();
        let ChangedContacts { sphere_names, force_names, radii, places, properties, exchanged, .. } =
            changed.contacts;
        assert_eq!((sphere_names, force_names), (of_spheres, !of_spheres), "{name}");
        assert!(!radii && !places && !exchanged && properties.is_empty(), "{name}");
        assert_eq!(model.doubt_about_note(), None, "{name}");
        assert_eq!(model.has_places_of(model.note.as_ref().unwrap()), Some(true), "{name}");
    }
}

#[test]
fn contacts_removed_since_the_note_are_counted() {
    let text = fixture_with_note(SMOOTH);
    let start = text.rfind("<SmoothSphereHalfSpaceForce ").unwrap();
    let end = text.rfind("</SmoothSphereHalfSpaceForce>").unwrap() + "</SmoothSphereHalfSpaceForce>".len();
    let count = Model::parse(text.clone()).unwrap().forces().len();
    let model = Model::parse(format!("{}{}", &text[..start], &text[end..])).unwrap();
    let changed = model.changed_since_note();
    let ChangedContacts { force_count, sphere_count, radii: false, places: false, .. } = changed.contacts
    else {
        panic!("{changed:?}");
    };
    assert_eq!((force_count, sphere_count), (Some((count, count - 1)), Some((count, count - 1))));
    assert_eq!(model.doubt_about_note(), Some(NoteDoubt::ValuesChanged));
}

/// After the user exchanged the numbers of two forces, each number is one that the note knows, but not the number of its force.
#[test]
fn numbers_exchanged_between_forces_are_detected() {
    let plain = String::from_utf8(fixture(SMOOTH)).unwrap();
    let value = plain.split_once("<stiffness>").unwrap().1.split_once('<').unwrap().0.to_owned();
    let other = plain.replacen(&format!("<stiffness>{value}<"), "<stiffness>7<", 1);
    let model = Model::parse(other).unwrap();
    let plan = note(&model, 62.0, Some(9.81), None).unwrap();
    let text = String::from_utf8(plan.patched(&model, FileId::MAIN).unwrap()).unwrap();
    let exchanged = text.replacen("<stiffness>7<", "<stiffness>HERE<", 1);
    let exchanged = exchanged.replacen(&format!("<stiffness>{value}<"), "<stiffness>7<", 1);
    let model = Model::parse(exchanged.replacen("HERE", &value, 1)).unwrap();
    let changed = model.changed_since_note();
    assert!(
        matches!(&changed.contacts, ChangedContacts { exchanged: true, radii: false, properties, .. }
            if properties.is_empty()),
        "{changed:?}"
    );
    assert_eq!(model.doubt_about_note(), Some(NoteDoubt::ValuesChanged));
}
