//! Published contacts are recognised at any mass. With one value changed by 2 % they are not recognised.

use osim_inspect::{CheckResult, InspectOptions, Inspection};
use osim_model::{FindingCode, MassRequest, Model, Severity};
use osim_planning::check_with_trials;

/// A human of 62 kg with the contacts and places of Falisse et al. (2022).
const FALISSE_MODEL: &str = include_str!("../../../../fixtures/check/known_contacts.osim");
/// A human of 90 kg with the contacts of Falisse et al. (2022), which are made for 62 kg.
const MODEL_OF_90_KG: &str = include_str!("../../../../fixtures/check/contacts_of_another_mass.osim");
/// The human in Table 1 of the paper, with forces of the class `HuntCrossleyForce`.
const HUNT_CROSSLEY: &str = include_str!("../../../../fixtures/table1/human_62kg_hunt_crossley.osim");

fn inspect_text(text: &str, options: &InspectOptions) -> (Model, Inspection) {
    let model = Model::parse(text).unwrap();
    let inspected = options.inspect("model.osim", &model, None);
    (model, inspected)
}

fn check_text(text: &str) -> CheckResult {
    let options = InspectOptions::default();
    let (model, inspected) = inspect_text(text, &options);
    check_with_trials(&options, &model, &inspected, &[])
}

/// The name of the published contacts in a model, and the mass that they are made for, kg.
fn recognised_contacts(text: &str) -> Option<(&'static str, f64)> {
    let (_, inspected) = inspect_text(text, &InspectOptions::default());
    inspected.known_contacts.map(|known| (known.name, known.made_for_kg))
}

/// Asserts that the contacts of `text` are recognised as made for `kg`.
#[track_caller]
fn assert_known(text: &str, kg: f64) {
    let Some((name, made_for_kg)) = recognised_contacts(text) else { panic!("not known") };
    assert_eq!(name, "falisse2022");
    assert!((made_for_kg / kg - 1.0).abs() < 1e-5, "{made_for_kg}, expected {kg}");
}

#[test]
fn published_contacts_are_known_in_both_classes_and_at_any_size() {
    for text in [FALISSE_MODEL, HUNT_CROSSLEY] {
        assert_known(text, 62.0);
    }
    // An eighth of the mass: half the radius by (8), half the stiffness by (10), √2 times the dissipation by (14), and
    // 1/4, 2 and √2 times the smoothing by (C.2), (C.5) and (C.10). What the body weighs plays no part.
    let eighth = FALISSE_MODEL
        .replace("<radius>0.032<", "<radius>0.016<")
        .replace("<stiffness>1000000<", "<stiffness>500000<")
        .replace("<dissipation>2<", "<dissipation>2.8284271247461903<")
        .replace("<constant_contact_force>1e-05<", "<constant_contact_force>2.5e-06<")
        .replace("<hertz_smoothing>300<", "<hertz_smoothing>600<")
        .replace("<hunt_crossley_smoothing>50<", "<hunt_crossley_smoothing>70.71067811865476<");
    assert_known(&eighth, 7.75);
    // With the radii of 62 kg instead, under a body of 7.75 kg: (10) has 1/8 of the stiffness, and the rest stays.
    let kept = FALISSE_MODEL.replace("<stiffness>1000000<", "<stiffness>125000<");
    assert_known(&kept.replace("<mass>60<", "<mass>5.75<"), 7.75);
    assert_eq!(recognised_contacts(&kept), None, "under 62 kg it is nobody's");
}

#[test]
fn contacts_are_known_under_a_body_that_they_were_not_made_for() {
    // R is that of 62 kg, whatever the body weighs.
    assert_known(MODEL_OF_90_KG, 62.0);
}

#[test]
fn one_value_that_is_off_by_two_per_cent_makes_them_unknown() {
    for (value, off) in [
        ("<radius>0.032<", "<radius>0.03264<"),
        ("<stiffness>1000000<", "<stiffness>1020000<"),
        ("<dissipation>2<", "<dissipation>2.04<"),
        ("<static_friction>0.8<", "<static_friction>0.816<"),
        ("<dynamic_friction>0.8<", "<dynamic_friction>0.816<"),
        ("<viscous_friction>0.5<", "<viscous_friction>0.51<"),
        ("<transition_velocity>0.2<", "<transition_velocity>0.204<"),
        ("<constant_contact_force>1e-05<", "<constant_contact_force>1.02e-05<"),
        ("<hertz_smoothing>300<", "<hertz_smoothing>306<"),
        ("<hunt_crossley_smoothing>50<", "<hunt_crossley_smoothing>51<"),
    ] {
        assert!(FALISSE_MODEL.contains(value), "{value}");
        // In one force or sphere alone, and in all.
        for text in [FALISSE_MODEL.replacen(value, off, 1), FALISSE_MODEL.replace(value, off)] {
            assert_eq!(recognised_contacts(&text), None, "{off}");
            let found = check_text(&text);
            let hertz = found.findings.iter().find(|one| one.code() == FindingCode::BeyondHertz).unwrap();
            assert!(!hertz.is_published, "{off}");
        }
    }
}

#[test]
fn only_faults_that_were_published_are_remarks() {
    let found = check_text(FALISSE_MODEL);
    assert_eq!((found.counts.error, found.counts.warning), (0, 0), "{:?}", found.findings);
    let codes: Vec<&str> = found.findings.iter().map(|finding| finding.code().as_str()).collect();
    assert_eq!(codes, ["beyond-hertz", "beyond-hunt-crossley", "known-contacts"]);
    assert!(found.findings[0].is_published && !found.findings[2].is_published);

    // A wrong number is an error with known contacts, too; a body of another mass is a warning.
    let forgotten = FALISSE_MODEL.replacen("<mass>60<", "<mass>58<", 1);
    let found = check_text(&forgotten);
    let other = found.findings.iter().find(|one| one.code() == FindingCode::ContactsOfAnotherMass).unwrap();
    assert_eq!(other.severity, Severity::Warning);
    assert!(
        other.message.to_string().contains("are for 62 kg (Falisse et al. 2022), the body weighs 60 kg"),
        "{}",
        other.message
    );
}

#[test]
fn contacts_are_recognised_whatever_mass_the_caller_gives() {
    let masses = MassRequest { model_kg: Some(40.0), ..MassRequest::default() };
    let options = InspectOptions { masses, ..InspectOptions::default() };
    let (_, inspected) = inspect_text(FALISSE_MODEL, &options);
    assert_eq!(inspected.known_contacts.map(|known| known.made_for_kg), Some(62.0));
}

#[test]
fn findings_come_from_the_worst_to_the_least() {
    // Falisse's contacts under 90 kg, and one force is off: nothing is known any more.
    let text = MODEL_OF_90_KG.replacen("<stiffness>1000000<", "<stiffness>1e3<", 1);
    let ranks: Vec<Severity> = check_text(&text).findings.iter().map(|finding| finding.severity).collect();
    assert!(ranks.is_sorted_by(|a, b| a >= b) && ranks.len() > 2, "{ranks:?}");
}
