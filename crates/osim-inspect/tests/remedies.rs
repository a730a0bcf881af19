//! What puts a finding right, as data: each front end prints or applies it.
//!
//! Expected numbers are the limits of the paper and its equations, computed by hand.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test fails by panicking"
)]

use contact_scaling::SharedLoad;
use osim_inspect::{CheckResult, InspectOptions, check_model};
use osim_model::{
    Assignment, FileId, Finding, FindingCode, Model, Pattern, Property, RemedyChange, RemedyDesign, Selection,
};
use osim_patch::{Design, DesignModulus, design};

/// 62 kg on 6 spheres a foot, R = 0.032 m, E₁* = 1e6 N/m², α = 2 s/m: Table 1 of the paper.
const HUMAN: &str = include_str!("../../../fixtures/table1/human_62kg_smooth_sphere.osim");
/// 10 kg on one sphere.
const ONE_FOOT: &str = include_str!("../../osim-model/tests/data/one_foot.osim");
/// The contacts of the human above under a body of 90 kg.
const OTHER_MASS: &str = include_str!("../../../fixtures/check/contacts_of_another_mass.osim");

/// What `check` finds in a model that is called `name`.
fn check(name: &str, text: &str) -> CheckResult {
    let model = Model::parse(text).unwrap();
    let options = InspectOptions::default();
    check_model(&options, &model, &options.inspect(name, &model, None), None)
}

#[track_caller]
fn find(result: &CheckResult, code: FindingCode) -> &Finding {
    let found = result.findings.iter().find(|finding| finding.code == code);
    found.unwrap_or_else(|| panic!("no {code:?}"))
}

/// The change that puts `code` right.
#[track_caller]
fn change(result: &CheckResult, code: FindingCode) -> &RemedyChange {
    &find(result, code).remedy.as_ref().expect("it has a remedy").change
}

#[track_caller]
fn wanted(result: &CheckResult, code: FindingCode) -> RemedyDesign {
    match change(result, code) {
        RemedyChange::Design(wanted) => *wanted,
        other => panic!("{code:?}: {other:?}"),
    }
}

#[test]
fn spheres_that_sink_in_too_deep_get_the_indentation_of_the_limit() {
    let result = check("human.osim", HUMAN);
    let remedy = find(&result, FindingCode::BeyondHertz).remedy.as_ref().unwrap();
    assert_eq!(&*remedy.model, "human.osim");
    assert_eq!(remedy.selection, Selection::default());
    let wanted = wanted(&result, FindingCode::BeyondHertz);
    assert_eq!((wanted.indentation, wanted.body_weights), (Some(0.16), None));
    // At rest a sphere that just touches carries ½ (x̂_c / 0.16)^{3/2} of its share, a tenth at most: x̂_c ≤ 0.0547.
    assert_eq!(wanted.constant_indentation, Some(0.054));
    assert_eq!(wanted.restitution, None);
    // The load is the model's own weight on the spheres that were found, so nothing more has to be said.
    let load = remedy.load.as_ref().unwrap();
    assert_eq!((load.mass_kg, load.gravity_m_s2, load.spheres, load.stance_limbs), (None, None, None, None));
}

#[test]
fn a_damper_gets_the_restitution_of_the_limit_at_its_own_impact_speed() {
    let wanted = wanted(&check("human.osim", HUMAN), FindingCode::BeyondHuntCrossley);
    // √(g R / 2) is 0.39618 m/s; rounded up, so that the limit is kept.
    assert_eq!((wanted.restitution, wanted.impact_speed_m_s), (Some(0.8), Some(0.3962)));
    assert_eq!((wanted.indentation, wanted.constant_indentation), (None, None));
}

#[test]
fn what_a_remedy_says_puts_the_finding_right() {
    let result = check("human.osim", HUMAN);
    let deep = wanted(&result, FindingCode::BeyondHertz);
    let damped = wanted(&result, FindingCode::BeyondHuntCrossley);
    let model = Model::parse(HUMAN).unwrap();
    let selected = Selection::default().apply(&model).unwrap();
    let mut request = Design::default();
    request.modulus = deep.indentation.map(DesignModulus::Indentation);
    request.load = SharedLoad::new(62.0 * 9.81, 6.0).ok();
    request.constant_indentation = deep.constant_indentation;
    request.restitution = damped.restitution.map(|restitution| (restitution, damped.impact_speed_m_s));
    let plan = design(&model, &selected, &request).unwrap();
    let stiffness = plan.changes.iter().find(|change| change.property == Property::Stiffness).unwrap();
    // (11) and (A.4): E₁* = 2^{3/2} 3 F / (4 R² x̂^{3/2} n), and 0.16^{3/2} is 0.064.
    let expected = 2_f64.powf(1.5) * 3.0 * 62.0 * 9.81 / (4.0 * 0.032 * 0.032 * 0.064 * 6.0);
    assert!((stiffness.to / expected - 1.0).abs() < 1e-12, "{}", stiffness.to);

    let patched = plan.patched(&model, FileId::MAIN).unwrap();
    let after = check("human.osim", std::str::from_utf8(&patched).unwrap());
    let left: Vec<&str> = after.findings.iter().map(|finding| finding.code.as_str()).collect();
    assert!(!left.contains(&"beyond-hertz") && !left.contains(&"beyond-hunt-crossley"), "{left:?}");
}

#[test]
fn contacts_of_another_body_are_rescaled_from_its_mass_to_this_one() {
    let result = check("model.osim", OTHER_MASS);
    let expected = RemedyChange::Rescale { contacts_mass_kg: 62.0, target_mass_kg: 90.0 };
    assert_eq!(*change(&result, FindingCode::ContactsOfAnotherMass), expected);
    // Everything else has to wait until the contacts are those of this body.
    let others = result.findings.iter().filter(|finding| finding.code != FindingCode::ContactsOfAnotherMass);
    assert!(others.into_iter().all(|finding| finding.remedy.is_none()));
}

#[test]
fn the_side_that_differs_gets_the_value_of_the_other() {
    let start = HUMAN.find("name=\"contact_s1_l\"").unwrap();
    let (before, force) = HUMAN.split_at(start);
    let text = format!("{before}{}", force.replacen("<stiffness>1000000<", "<stiffness>2500000<", 1));
    assert_ne!(text, HUMAN);
    let result = check("human.osim", &text);
    let remedy = find(&result, FindingCode::LeftRightDiffer).remedy.as_ref().unwrap();
    let assignments = vec![(Property::Stiffness, Assignment::Value(1e6))];
    assert_eq!(remedy.change, RemedyChange::Set { assignments });
    let select: Vec<&str> = remedy.selection.select.iter().map(Pattern::as_str).collect();
    assert_eq!(select, ["contact_s1_l"]);
}

#[test]
fn a_forgotten_stiffness_is_taken_from_a_preset() {
    let text = ONE_FOOT.replace("<stiffness>1000000</stiffness>", "");
    let result = check("one_foot.osim", &text);
    let expected = RemedyChange::Transfer { from: "falisse2022" };
    assert_eq!(*change(&result, FindingCode::DefaultStiffness), expected);
}

#[test]
fn a_model_that_cannot_be_read_again_has_findings_and_no_remedy() {
    let result = check("-", HUMAN);
    assert_eq!(result.counts.warn, 2);
    assert!(result.findings.iter().all(|finding| finding.remedy.is_none()));
}
