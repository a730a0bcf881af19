//! Tests with numbers at the limits of a double: no verb writes a number that is not finite.

use osim_model::{
    Assignment, FaultKind, FileId, ForceKind, MassRequest, Model, Property, RadiusRule, Selection,
};
use osim_patch::{Convert, Design, DesignModulus, Plan, Rescale, Set, convert, design, rescale, set};
use proptest::prelude::*;

use crate::given::fixture;

const ONE_FOOT: &str = include_str!("../../../osim-model/tests/data/one_foot.osim");

fn assigned_plan(text: &str, property: Property, value: Assignment) -> Result<Plan, osim_model::Fault> {
    let model = Model::parse(text).unwrap();
    set(&model, &Selection::default().apply(&model).unwrap(), &Set::new(vec![(property, value)]))
}

#[test]
fn the_message_names_property_line_and_where_the_number_comes_from() {
    // <stiffness>1000000</stiffness> times 1e305 is more than a double holds.
    let fault = assigned_plan(ONE_FOOT, Property::Stiffness, Assignment::Factor(1e305)).unwrap_err();
    let line = ONE_FOOT.lines().position(|line| line.contains("<stiffness>")).unwrap() + 1;
    assert_eq!(fault.clone().located(ONE_FOOT.as_bytes()).position.map(|place| place.line), Some(line));
    assert_eq!(fault.code(), "out-of-domain");
    assert_eq!(
        fault.kind.phrase().to_string(),
        "the new stiffness is inf, expected a finite number above 0: it comes from 1000000 times 1e305, what the request says"
    );
    // Less than the least number there is.
    let fault = assigned_plan(ONE_FOOT, Property::Radius, Assignment::Factor(5e-324)).unwrap_err();
    assert!(fault.to_string().contains("the new radius is 0, expected a finite number above 0"), "{fault}");
}

#[test]
fn a_plan_with_an_invalid_number_is_not_written() {
    let model = Model::parse(ONE_FOOT).unwrap();
    let selected = Selection::default().apply(&model).unwrap();
    let mass = MassRequest::default().contacts_mass(&model).unwrap().0;
    for value in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN, -1.0] {
        let mut plan = rescale(&model, &selected, &Rescale::new(80.0, mass.clone())).unwrap();
        plan.changes[0].to = value;
        assert!(matches!(plan.patched(&model, FileId::MAIN).unwrap_err().kind, FaultKind::NewValue { .. }));
        assert!(plan.changed_model(&model).is_err() && plan.edits(&model, FileId::MAIN).is_err());
    }
}

#[test]
fn a_composite_value_of_two_surfaces_may_be_too_large() {
    let text = String::from_utf8(fixture("format/floor_of_its_own.osim")).unwrap();
    // 2ab/(a + b) of 1e200 and 1e199: ab is more than a double holds.
    let large = text.replace("<static_friction>0.81<", "<static_friction>1e200<");
    let text = large.replacen("<static_friction>1e200<", "<static_friction>1e199<", 1);
    let model = Model::parse(text).unwrap();
    let selected = Selection::default().apply_to_all(&model).unwrap();
    for to in [ForceKind::SmoothSphereHalfSpace, ForceKind::HuntCrossley] {
        let fault = convert(&model, &selected, &Convert::new(to)).unwrap_err();
        let said = fault.to_string();
        assert!(said.contains("the new static_friction is inf"), "{said}");
        assert!(said.contains("by equation (A.3)") && fault.offset.is_some(), "{said}");
    }
}

#[test]
fn only_change_rs_converts_numbers_to_text() {
    let source = concat!(env!("CARGO_MANIFEST_DIR"), "/src");
    let (mut folders, mut spelling) = (vec![std::path::PathBuf::from(source)], Vec::new());
    while let Some(folder) = folders.pop() {
        for path in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            if path.is_dir() {
                folders.push(path);
            } else if std::fs::read_to_string(&path).unwrap().contains("shortest") {
                spelling.push(path.file_name().unwrap().to_owned());
            }
        }
    }
    assert_eq!(spelling, ["change.rs"]);
}

/// Numbers as people and programs write them, and numbers at the limits of a double.
fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![
        Just(1e-308),
        Just(1e308),
        Just(f64::MIN_POSITIVE),
        Just(5e-324),
        Just(f64::MAX),
        Just(1e-150),
        Just(1e150),
        Just(1.0),
        1e-3..1e3,
    ]
}

/// The number of numbers in a text that are not finite.
fn count_not_finite(bytes: &[u8]) -> usize {
    let text = String::from_utf8_lossy(bytes);
    let words = text.split(|letter: char| !letter.is_alphanumeric());
    words.filter(|word| ["inf", "nan", "infinity"].contains(&word.to_ascii_lowercase().as_str())).count()
}

/// The plans of several verbs for `model` with the values `a` and `b`, without the plans that are refused.
fn plans_of_several_verbs(model: &Model, a: f64, b: f64) -> Vec<Plan> {
    let Ok(selected) = Selection::default().apply(model) else { return Vec::new() };
    let mut made = Vec::new();
    if let Ok((mass, _)) =
        (MassRequest { contacts_mass_kg: Some(b), ..MassRequest::default() }).contacts_mass(model)
    {
        for rule in [RadiusRule::Isometric, RadiusRule::Keep, RadiusRule::Metres(b), RadiusRule::Factor(b)] {
            let mut wanted = Rescale::new(a, mass.clone());
            wanted.radius = rule;
            wanted.target_gravity_m_s2 = Some(b);
            made.push(rescale(model, &selected, &wanted));
        }
    }
    for property in Property::changeable() {
        for value in [Assignment::Value(a), Assignment::Factor(b)] {
            made.push(set(model, &selected, &Set::new(vec![(property, value)])));
        }
    }
    let wanted = Design {
        modulus: Some(DesignModulus::Young { young_n_m2: a, poisson: 0.3 }),
        constant_indentation: Some(b),
        speed_width: Some((0.1, a)),
        ..Design::default()
    };
    made.push(design(model, &selected, &wanted));
    for to in [ForceKind::SmoothSphereHalfSpace, ForceKind::HuntCrossley] {
        let converted = convert(model, &selected, &Convert::new(to));
        made.push(converted.map(|done| Plan::from_objects(done.rebuilt, "converted".into())));
    }
    made.into_iter().flatten().collect()
}

proptest! {
    #[test]
    fn nothing_that_is_not_finite_is_written(
        hunt: bool, radius in any_number(), stiffness in any_number(), dissipation in any_number(), mass in any_number(), a in any_number(), b in any_number(),
    ) {
        let name = if hunt { "format/floor_of_its_own.osim" } else { "format/v40600.osim" };
        let text = String::from_utf8(fixture(name)).unwrap();
        let text = text
            .replacen("<radius>0.0325<", &format!("<radius>{radius:e}<"), 1)
            .replacen("<stiffness>1000000<", &format!("<stiffness>{stiffness:e}<"), 1)
            .replacen("<stiffness>1234567.8<", &format!("<stiffness>{stiffness:e}<"), 1)
            .replacen("<dissipation>2.25<", &format!("<dissipation>{dissipation:e}<"), 1)
            .replacen("<mass>61.5<", &format!("<mass>{mass:e}<"), 1);
        let model = Model::parse(text.as_str()).unwrap();
        for plan in plans_of_several_verbs(&model, a, b) {
            if let Ok(bytes) = plan.patched(&model, FileId::MAIN) {
                prop_assert_eq!(count_not_finite(&bytes), 0, "{}", String::from_utf8_lossy(&bytes));
            }
        }
    }
}
