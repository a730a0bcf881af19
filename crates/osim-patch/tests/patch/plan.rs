//! Tests of the plan and its edits: lines, scopes, notes, and files that belong together.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use osim_model::{
    Companion, Document, FileId, Mass, MassRequest, MassSource, Model, Property, PropertySet, RadiusRule,
    Scope, Selection, ValueOrigin,
};
use osim_patch::{Plan, Rescale, rescale};

const ONE_FOOT: &str = include_str!("../../../osim-model/tests/data/one_foot.osim");

fn rescale_to(target_mass_kg: f64, origin_kg: f64) -> Rescale {
    let contacts_mass = Mass { kg: origin_kg, source: MassSource::ContactsMass };
    Rescale::new(target_mass_kg, contacts_mass)
}

fn plan_rescale(model: &Model, wanted: &Rescale) -> Plan {
    let selected = Selection::default().apply(model).unwrap();
    rescale(model, &selected, wanted).unwrap()
}

/// Rescales `text` and returns the plan and the new text.
fn rescaled(text: &str, change: impl FnOnce(&mut Rescale), note: bool) -> (Plan, String) {
    let model = Model::parse(text.as_bytes()).unwrap();
    let origin = MassRequest::default().contacts_mass(&model).unwrap().0.kg;
    let mut wanted = rescale_to(8.0 * origin, origin);
    change(&mut wanted);
    let mut plan = plan_rescale(&model, &wanted);
    if !note {
        plan.drop_note();
    }
    let bytes = plan.patched(&model, FileId::MAIN).unwrap();
    (plan, String::from_utf8(bytes).unwrap())
}

/// Number (from 1) of the first line of `text` that contains the text `what`.
fn line_of(text: &str, what: &str) -> usize {
    text.lines().position(|line| line.contains(what)).unwrap() + 1
}

#[test]
fn changes_name_the_line_of_the_number_or_of_the_object_that_gets_it() {
    let (plan, _) = rescaled(ONE_FOOT, |_| (), true);
    let line = |property| plan.changes.iter().find(|change| change.property == property).unwrap().line;
    assert_eq!(line(Property::Radius), line_of(ONE_FOOT, "<radius>"));
    assert_eq!(line(Property::Stiffness), line_of(ONE_FOOT, "<stiffness>"));
    assert_eq!(line(Property::HertzSmoothing), line_of(ONE_FOOT, "<SmoothSphereHalfSpaceForce"));
}

#[test]
fn origins_have_the_names_of_the_json() {
    let names =
        [ValueOrigin::Element, ValueOrigin::Defaults, ValueOrigin::ClassDefault].map(ValueOrigin::as_str);
    assert_eq!(names, ["element", "defaults", "class default"]);
}

#[test]
fn the_scope_is_partial_if_a_default_property_is_not_scaled() {
    let scope = |change: fn(&mut Rescale)| rescaled(ONE_FOOT, change, true).0.note().unwrap().scope;
    assert_eq!(scope(|_| ()), Scope::All);
    // With radii that stay, the others follow from that: nothing is left behind.
    assert_eq!(scope(|wanted| wanted.radius = RadiusRule::Keep), Scope::All);
    assert_eq!(
        scope(|wanted| wanted.properties = PropertySet::default().restricted(&[Property::Stiffness], &[])),
        Scope::Partial
    );
    assert_eq!(
        scope(
            |wanted| wanted.properties = PropertySet::default().restricted(&[], &[Property::HertzSmoothing])
        ),
        Scope::Partial
    );
    assert_eq!(
        scope(|wanted| wanted.properties = PropertySet::default().restricted(&[], &[Property::Radius])),
        Scope::All
    );
}

#[test]
fn a_note_adds_one_line_and_a_change_without_note_removes_it() {
    let lines = |text: &str| text.lines().count();
    let (_, noted) = rescaled(ONE_FOOT, |_| (), true);
    let (_, plain) = rescaled(ONE_FOOT, |_| (), false);
    assert_eq!(lines(&noted), lines(&plain) + 1);
    let (_, again) = rescaled(&noted, |_| (), true);
    assert_eq!((lines(&again), again.matches("osim-contact-scale").count()), (lines(&noted), 1));
    let (_, without) = rescaled(&noted, |_| (), false);
    assert_eq!((lines(&without), without.matches("osim-contact-scale").count()), (lines(&plain), 0));
    // Nothing to change: the note stays, and every other byte.
    let (nothing, same) = rescaled(&noted, |wanted| wanted.target_mass_kg = wanted.contacts_mass.kg, false);
    assert!(nothing.is_empty());
    assert_eq!(same, noted);
}

#[test]
fn the_note_keeps_the_gravity_that_contacts_were_made_for() {
    let gravity = |plan: &Plan| plan.note().unwrap().gravity_m_s2;
    let (moon, on_moon) = rescaled(ONE_FOOT, |wanted| wanted.target_gravity_m_s2 = Some(1.62), true);
    assert_eq!(gravity(&moon), Some(1.62));
    // Another mass, and no word of gravity: still the moon's.
    let (heavier, _) = rescaled(&on_moon, |_| (), true);
    assert_eq!(gravity(&heavier), Some(1.62));
    // Back to where the model itself is: the factors are those of a return, not of a second departure.
    let back = |wanted: &mut Rescale| {
        wanted.target_mass_kg = wanted.contacts_mass.kg;
        wanted.target_gravity_m_s2 = Some(9.81);
    };
    let (home, _) = rescaled(&on_moon, back, true);
    let stiffness = home.changes.iter().find(|change| change.property == Property::Stiffness).unwrap();
    assert!((stiffness.factor.unwrap() - 9.81 / 1.62).abs() < 1e-12);
}

#[test]
fn every_file_of_a_standalone_pair_gets_its_edits_and_the_model_beside_it_none() {
    let forces = include_str!("../../../../fixtures/format/standalone_ForceSet.xml");
    let geometry = include_str!("../../../../fixtures/format/standalone_ContactGeometrySet.xml");
    let bones = include_str!("../../../../fixtures/format/standalone_model_without_contacts.osim");
    let [forces_document, geometry_document, bones_document] =
        [forces, geometry, bones].map(|text| Document::parse(text).unwrap());
    let beside = |document| Companion { document, included_by: None };
    let companions = vec![beside(geometry_document), beside(bones_document)];
    let model = Model::read_with(forces_document, companions).unwrap();
    let beside: Vec<FileId> = model.companions().map(|(file, _)| file).collect();
    let [main, geometry, bones_file] = [FileId::MAIN, beside[0], beside[1]];
    let mut wanted = rescale_to(8.0, 1.0);
    let plan_of = |wanted: &Rescale| plan_rescale(&model, wanted);
    let grown = plan_of(&wanted);
    let text = |plan: &Plan, file| String::from_utf8(plan.patched(&model, file).unwrap()).unwrap();
    let digest = &grown.note().unwrap().digest;
    assert!(text(&grown, main).contains(digest) && text(&grown, geometry).contains(digest));
    assert_eq!(text(&grown, bones_file), bones);
    assert!(
        grown.changes.iter().any(|change| change.file() == geometry && change.property == Property::Radius)
    );
    // Radii that stay: the geometry set still gets the common note, so that the pair stays one.
    wanted.radius = RadiusRule::Keep;
    let kept = plan_of(&wanted);
    assert_eq!(kept.edits(&model, geometry).unwrap().len(), 1);
    assert!(text(&kept, geometry).contains(&kept.note().unwrap().digest));
    assert_eq!(text(&kept, bones_file), bones);
}

// As OpenSim 4.6 reads them.
#[test]
fn a_location_is_three_numbers_or_the_origin() {
    for (location, expected) in [
        ("1 2 3", [1.0, 2.0, 3.0]),
        ("1, 2 3", [1.0, 2.0, 3.0]),
        ("1 2x 3", [1.0, 2.0, 3.0]),
        ("1,2,3", [0.0; 3]),
        ("1 2 3 4", [0.0; 3]),
        ("1 2", [0.0; 3]),
    ] {
        let text = ONE_FOOT.replace("<radius>", &format!("<location>{location}</location><radius>"));
        assert_eq!(Model::parse(text).unwrap().spheres()[0].location_m, expected, "{location}");
    }
}
