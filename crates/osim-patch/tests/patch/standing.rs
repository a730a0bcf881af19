//! Tests of the mass that contacts are made for: from notes in the file, from other files, and from presets.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use crate::given::{assert_close, fixture, foot, given, smooth};
use osim_model::Property;

#[test]
fn standalone_force_set_and_geometry_set_change_together() {
    let pair = || {
        given(fixture("format/standalone_ForceSet.xml"))
            .with_companion(fixture("format/standalone_ContactGeometrySet.xml"))
    };
    let outcome = pair().standing_for(61.5).rescaled_to(492.0);
    outcome.sets(Property::Stiffness, 1, 2_469_135.6).sets(Property::Radius, 1, 0.065);
    let geometry = String::from_utf8(fixture("format/standalone_ContactGeometrySet.xml")).unwrap();
    let expected = geometry.replace("<radius>0.0325</radius>", "<radius>0.065</radius>");
    assert_eq!(String::from_utf8(outcome.file(1).to_vec()).unwrap(), expected);
    // The masses of the model they belong to.
    let outcome =
        pair().with_companion(fixture("format/standalone_model_without_contacts.osim")).rescaled_to(492.0);
    outcome.sets(Property::Stiffness, 1, 2_469_135.6);
    assert_eq!(outcome.file(2), fixture("format/standalone_model_without_contacts.osim"));
    pair().rescaled_to(492.0).is_refused("no-mass", &["`mass`", "`contacts_mass`"]);
    given(fixture("format/standalone_ForceSet.xml"))
        .rescaled_to(1.0)
        .is_refused("incomplete-set", &["`geometry`"]);
    given(fixture("format/standalone_ContactGeometrySet.xml"))
        .rescaled_to(1.0)
        .is_refused("incomplete-set", &["ForceSet"]);
}

#[test]
fn the_note_is_in_the_credits_and_is_replaced_on_later_runs() {
    let first = given(foot(&smooth("<stiffness>1000000</stiffness>"), "0.01")).with_note().rescaled_to(8.0);
    let text = String::from_utf8(first.bytes().to_vec()).unwrap();
    assert!(text.contains("<credits>[contacts made for 8 kg at 9.80665 m/s2 (osim-contact-scale "), "{text}");
    assert!(text.contains("; all; by rescale from 1 kg; weighed 1 kg; sizes none; record "), "{text}");
    // The bodies weigh 1 kg still; the contacts are made for 8 kg.
    let second = given(text).with_note().rescaled_to(64.0);
    let text = String::from_utf8(second.bytes().to_vec()).unwrap();
    assert_eq!(text.matches("osim-contact-scale").count(), 1, "{text}");
    assert!(text.contains("[contacts made for 64 kg at "), "{text}");
    second.has_finding("mass-sources-disagree");
    let direct = given(foot(&smooth("<stiffness>1000000</stiffness>"), "0.01")).rescaled_to(64.0);
    for (two, one) in second.plan().changes.iter().zip(&direct.plan().changes) {
        assert_eq!((two.property, &two.path), (one.property, &one.path));
        assert_close(two.to, one.to, &two.path);
    }
}

#[test]
fn a_partial_or_stale_note_is_not_believed() {
    let foot =
        || given(foot(&smooth("<stiffness>1000000</stiffness>\n<dissipation>2</dissipation>"), "0.01"));
    let after = |outcome: &crate::given::Outcome| String::from_utf8(outcome.bytes().to_vec()).unwrap();
    let partial = after(&foot().with_note().changing_only(&[Property::Stiffness]).rescaled_to(64.0));
    assert!(partial.contains("; partial; "), "{partial}");
    given(partial.clone()).rescaled_to(100.0).is_refused("stale-note", &["64 kg", "`contacts_mass`"]);
    given(partial).standing_for(1.0).rescaled_to(64.0).sets(Property::Radius, 1, 0.04);
    let edited = after(&foot().with_note().rescaled_to(64.0)).replace("<dissipation>1<", "<dissipation>1.1<");
    given(edited).rescaled_to(100.0).is_refused("stale-note", &["64 kg", "`contacts_mass`"]);
    // Another spelling of the same number is the same number.
    let respelled = after(&foot().with_note().rescaled_to(64.0)).replace(">4000000<", "> 4.0e6 <");
    given(respelled).rescaled_to(8.0).sets(Property::Stiffness, 1, 2e6);
}

#[test]
fn a_model_at_the_target_mass_is_not_changed_and_a_finding_says_so() {
    for kg in [1.0, 1.0009, 0.9991] {
        given(foot(&smooth("<stiffness>1e6</stiffness>"), "0.01"))
            .with_note()
            .rescaled_to(kg)
            .changes_nothing()
            .has_finding("already-at-target");
    }
    assert!(
        !given(foot(&smooth("<stiffness>1e6</stiffness>"), "0.01")).rescaled_to(1.0011).plan().is_empty()
    );
}

#[test]
fn the_preset_gives_the_animals_of_table_1_what_the_paper_prints() {
    // Table 1 of the paper, as printed: E₁* in MPa and α in s/m, at this model's M, n and R.
    for (file, spheres, modulus_mpa, modulus_digit, dissipation) in [
        ("human_62kg", 6.0, 1.00, 0.005, 2.00),
        ("human_500kg", 6.0, 2.04, 0.005, 1.42),
        ("mouse", 2.0, 0.259, 0.0005, 8.00),
        ("emu_10_spheres", 10.0, 1.66, 0.005, 2.92),
        ("emu_2_spheres", 2.0, 2.08, 0.005, 2.07),
        ("horse", 10.0, 24.0, 0.05, 2.92),
        ("giraffe", 8.0, 16.4, 0.05, 2.07),
    ] {
        for class in ["hunt_crossley", "smooth_sphere"] {
            // Something else in the file first, so that every number is written by the transfer.
            let name = format!("table1/{file}_{class}.osim");
            let spoiled = String::from_utf8(fixture(&name)).unwrap();
            let spoiled = replace_values(&replace_values(&spoiled, "stiffness", "5"), "dissipation", "7");
            let outcome = given(spoiled).taking_preset("falisse2022", spheres);
            let stiffness = outcome.changes_of(Property::Stiffness);
            assert!(!stiffness.is_empty());
            for change in stiffness {
                assert!((change.to / 1e6 - modulus_mpa).abs() <= modulus_digit, "{name}: {}", change.to);
            }
            for change in outcome.changes_of(Property::Dissipation) {
                assert!((change.to - dissipation).abs() <= 0.005, "{name}: {}", change.to);
            }
        }
    }
}

/// The text with `value` in every `<tag>…</tag>`.
fn replace_values(text: &str, tag: &str, value: &str) -> String {
    let (open, close) = (format!("<{tag}>"), format!("</{tag}>"));
    let mut parts = text.split(&open);
    let mut out = parts.next().unwrap().to_owned();
    for part in parts {
        let (_, rest) = part.split_once(&close).unwrap();
        out.push_str(&format!("{open}{value}{close}{rest}"));
    }
    out
}
