//! Tests of refused models and of the places that their faults name.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use crate::given::{fixture, fixtures, given_fixture};
use osim_model::{Assignment, Fault, FaultKind, Model, Property, Selection};
use osim_patch::{Design, Set, design, set};

#[test]
fn a_missing_mass_is_requested() {
    let outcome = given_fixture("format/terrain_welded.osim").rescaled_to(8.0 * 53.0);
    outcome.sets(Property::Stiffness, 2, 2_469_135.6);
    given_fixture("bad/mass_missing.osim").rescaled_to(1.0).is_refused("no-mass", &["`mass`"]);
    given_fixture("bad/mass_missing.osim").weighing(53.0).rescaled_to(8.0 * 53.0).plan();
}

/// The fault of rescaling a bad fixture; `None` if the fixture is accepted.
fn fault_of_bad_fixture(name: &str) -> Option<Fault> {
    given_fixture(name).rescaled_to(1234.5).result.err()
}

#[test]
fn every_bad_fixture_is_refused_or_listed_here() {
    // OpenSim has the same numbers here, or its parser is stricter than XML (the oracle has the same list).
    let harmless = [
        "bad/location_short.osim",
        "bad/attribute_unquoted.osim",
        "bad/attribute_less_than.osim",
        "bad/second_bom.osim",
        "bad/blank_in_end_tag.osim",
        "bad/name_with_blank.osim",
        "bad/nul_byte.osim",
        // `check` has an error for what OpenSim refuses without regard to contacts.
        "bad/body_without_joint.osim",
        "bad/sphere_in_force_set.osim",
        "bad/version_of_bodies_with_joints.osim",
    ];
    let mut accepted: Vec<String> =
        fixtures("bad").into_iter().filter(|name| fault_of_bad_fixture(name).is_none()).collect();
    accepted.retain(|name| !harmless.contains(&name.as_str()));
    assert!(accepted.is_empty(), "rescaled without a word: {accepted:?}");
}

#[test]
fn the_fault_of_a_refused_number_has_its_line() {
    for (file, code, text, line_of) in [
        ("number_decimal_comma", "not-a-number", "OpenSim reads 1 and", "<stiffness>"),
        ("number_unit", "not-a-number", "OpenSim reads 2000000", "<stiffness>"),
        ("number_nan", "out-of-domain", "NaN", "<stiffness>"),
        ("stiffness_zero", "out-of-domain", "0", "<stiffness>"),
        ("radius_zero", "out-of-domain", "0", "<radius>"),
        ("dissipation_negative", "out-of-domain", "", "<dissipation>"),
        ("mass_negative", "out-of-domain", "", "<mass>"),
        ("hertz_smoothing_zero", "out-of-domain", "", "<hertz_smoothing>"),
    ] {
        let name = format!("bad/{file}.osim");
        let bytes = fixture(&name);
        let fault =
            fault_of_bad_fixture(&name).unwrap_or_else(|| panic!("{name} is not refused")).located(&bytes);
        assert_eq!(fault.code(), code, "{name}: {fault}");
        assert!(fault.to_string().contains(text), "{name}: {fault}");
        let line = fault.position.unwrap_or_else(|| panic!("{name}: no place")).line;
        let text = String::from_utf8(bytes).unwrap();
        assert!(text.lines().nth(line - 1).unwrap().contains(line_of), "{name} points at line {line}");
    }
}

#[test]
fn a_constant_contact_force_of_0_is_never_written() {
    const ONE_FOOT: &str = include_str!("../../../osim-model/tests/data/one_foot.osim");
    let model = Model::parse(ONE_FOOT.as_bytes()).unwrap();
    let selected = Selection::default().apply(&model).unwrap();
    let cf = Property::ConstantContactForce;
    let assigned = [0.0, -0.0].map(Assignment::Value).into_iter();
    // 1e-5 m² times 1e-320 is less than the smallest number there is.
    for value in assigned.chain([0.0, 1e-320].map(Assignment::Factor)) {
        let fault = set(&model, &selected, &Set::new(vec![(cf, value)])).unwrap_err();
        assert_eq!((fault.code(), &fault.kind), ("out-of-domain", &FaultKind::ZeroConstantContactForce));
        assert!(fault.to_string().contains("NaN"), "{fault}");
    }
    let wanted = Design { constant_indentation: Some(1e-200), ..Design::default() };
    assert_eq!(design(&model, &selected, &wanted).unwrap_err().kind, FaultKind::ZeroConstantContactForce);
    // What is 0 already and stays 0 is not written.
    let zero =
        ONE_FOOT.replace("<dissipation>", "<constant_contact_force>0</constant_contact_force><dissipation>");
    let model = Model::parse(zero.as_bytes()).unwrap();
    let selected = Selection::default().apply(&model).unwrap();
    let plan = set(&model, &selected, &Set::new(vec![(cf, Assignment::Factor(2.0))])).unwrap();
    assert!(plan.changes.is_empty());
}
