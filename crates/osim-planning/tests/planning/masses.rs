//! Contacts that are made for another mass than the mass of their body.

use crate::checks::{check_text, check_with, codes, find, has, message, remedy};
use crate::feet::{SOLE, SmoothContact, foot};
use osim_inspect::{InspectOptions, MassMismatch};
use osim_model::{FindingCode, MassRequest, Model, Note, Scope, Step};

/// A model with six spheres of the preset falisse2022, which is made for 62 kg, under a body of 90 kg.
const MODEL_FOR_OTHER_MASS: &str = include_str!("../../../../fixtures/check/contacts_of_another_mass.osim");

// Contacts of a preset under another body.

#[track_caller]
fn assert_other_mass(text: &str, found: bool) {
    let result = check_text(text);
    assert_eq!(has(&result, FindingCode::ContactsOfAnotherMass), found, "{:?}", codes(&result));
}

#[test]
fn contacts_of_a_preset_under_another_body_are_recognised() {
    let text = message(&check_text(MODEL_FOR_OTHER_MASS), FindingCode::ContactsOfAnotherMass);
    assert_eq!(text, "the contacts are for 62 kg (Falisse et al. 2022), the body weighs 90 kg");
}

/// Radii of 32 mm move bottoms by 32 (∛(90/62) - 1) = 4.2 mm, and by 5.2 mm at 98 kg.
#[test]
fn a_rescaling_that_moves_soles_by_more_than_5_mm_keeps_them() {
    for (trunk, level) in [("<mass>88<", None), ("<mass>96<", Some(true))] {
        let text = MODEL_FOR_OTHER_MASS.replace("<mass>88<", trunk);
        let proposed = remedy(&check_text(&text), FindingCode::ContactsOfAnotherMass);
        assert_eq!(proposed["verb"], "rescale", "{trunk}");
        assert_eq!(proposed.get("level").and_then(serde_json::Value::as_bool), level, "{trunk}");
    }
}

/// The bones are those of 62 kg: at 152 kg the body is 2.45 times as dense.
#[test]
fn contacts_are_not_scaled_to_a_mass_that_no_such_body_has() {
    for (trunk, is_scaled) in [("<mass>150<", true), ("<mass>618<", false), ("<mass>10<", false)] {
        let found = check_text(&MODEL_FOR_OTHER_MASS.replace("<mass>88<", trunk));
        let finding = find(&found, FindingCode::ContactsOfAnotherMass);
        assert_eq!(finding.remedy.is_some(), is_scaled, "{trunk}");
        let advice = finding.advice.to_string();
        let expected = "Correct the masses of the bodies: the bones are those of a body of about 62 kg";
        assert_eq!(advice == expected, !is_scaled, "{advice}");
    }
}

#[test]
fn contacts_of_a_preset_under_its_own_body_are_right() {
    assert_other_mass(&MODEL_FOR_OTHER_MASS.replace("<mass>88<", "<mass>60<"), false);
    // Masses within 2 % count as one: 1.24 kg here.
    assert_other_mass(&MODEL_FOR_OTHER_MASS.replace("<mass>88<", "<mass>61.23<"), false);
    assert_other_mass(&MODEL_FOR_OTHER_MASS.replace("<mass>88<", "<mass>61.25<"), true);
}

#[test]
fn contacts_with_one_other_number_are_not_those_of_the_preset() {
    for (own, other, found) in [
        ("<radius>0.032<", "<radius>0.03200001<", true),
        ("<radius>0.032<", "<radius>0.0320004<", false),
        ("<radius>0.032<", "<radius>0.0319996<", false),
        ("<stiffness>1000000<", "<stiffness>1000001.1<", false),
        ("<stiffness>1000000<", "<stiffness>1000000.9<", true),
        ("<dissipation>2<", "<dissipation>2.000003<", false),
        ("<dissipation>2<", "<dissipation>0.000001<", false),
    ] {
        let text = MODEL_FOR_OTHER_MASS.replacen(own, other, 1);
        assert_ne!(text, MODEL_FOR_OTHER_MASS);
        assert_other_mass(&text, found);
    }
}

#[test]
fn five_spheres_are_not_the_six_of_the_preset() {
    let start = MODEL_FOR_OTHER_MASS.rfind("<SmoothSphereHalfSpaceForce").unwrap();
    let end = MODEL_FOR_OTHER_MASS.rfind("</SmoothSphereHalfSpaceForce>").unwrap()
        + "</SmoothSphereHalfSpaceForce>".len();
    assert_other_mass(&format!("{}{}", &MODEL_FOR_OTHER_MASS[..start], &MODEL_FOR_OTHER_MASS[end..]), false);
}

#[test]
fn spheres_without_figures_are_not_those_of_a_preset() {
    // A dissipation below 0: the spheres are counted, and nothing is computed of them.
    assert_other_mass(&MODEL_FOR_OTHER_MASS.replacen("<dissipation>2<", "<dissipation>-2<", 1), false);
}

#[test]
fn a_mass_of_contacts_from_the_caller_counts() {
    let has_finding = |masses| {
        let options = InspectOptions { masses, ..InspectOptions::default() };
        has(&check_with("model.osim", MODEL_FOR_OTHER_MASS, &options), FindingCode::ContactsOfAnotherMass)
    };
    assert!(!has_finding(MassRequest { contacts_mass_kg: Some(90.0), ..MassRequest::default() }));
    // What the model weighs says nothing about its contacts.
    assert!(has_finding(MassRequest { model_kg: Some(90.0), ..MassRequest::default() }));
}

// Notes of another mass than the bodies'.

/// The model `text` with a note that its contacts are made for `kg`.
fn with_note(text: &str, kg: f64) -> String {
    let model = Model::parse(text).unwrap();
    let note = Note {
        version: "0.1.0".to_owned(),
        contacts_mass_kg: Some(kg),
        gravity_m_s2: Some(10.0),
        scope: Scope::All,
        steps: vec![Step::new("rescale")],
        stance_limbs: None,
        weighed_kg: None,
        radii: model.radii_digest(|_| None),
        parts: model.noted_parts(|_| None),
        sizes: model.body_sizes(),
        digest: model.contact_digest(|_| None),
        places: Some(model.places_digest(|_| None)),
        added_to_file: Note::nothing_added(),
        added_forces: vec![],
    };
    text.replacen("<gravity>", &format!("<credits>{}</credits>\n<gravity>", note.text()), 1)
}

fn mass_mismatch(text: &str, masses: &MassRequest) -> Option<MassMismatch> {
    let model = Model::parse(text).unwrap();
    let contacts_mass = masses.contacts_mass(&model).unwrap().0;
    MassMismatch::find(&model, masses, Some(&contacts_mass))
}

#[test]
fn a_note_of_another_mass_than_the_bodies_is_a_mismatch() {
    let text = with_note(&foot(&[SOLE]), 75.5);
    let found = mass_mismatch(&text, &MassRequest::default()).unwrap();
    let expected = "its contacts are made for 75.5 kg (note in the file) and carry its body of 60 kg here: give `mass` 75.5, or scale the body first";
    assert_eq!(found.message().to_string(), expected);
}

#[test]
fn masses_that_agree_or_that_the_caller_gives_are_not_a_mismatch() {
    assert_eq!(mass_mismatch(&foot(&[SOLE]), &MassRequest::default()), None, "without a note");
    assert_eq!(mass_mismatch(&with_note(&foot(&[SOLE]), 61.1), &MassRequest::default()), None, "within 2 %");
    let text = with_note(&foot(&[SOLE]), 75.5);
    for masses in [
        MassRequest { model_kg: Some(80.0), ..MassRequest::default() },
        MassRequest { model_kg: Some(75.5), ..MassRequest::default() },
        MassRequest { contacts_mass_kg: Some(75.5), ..MassRequest::default() },
    ] {
        assert_eq!(mass_mismatch(&text, &masses), None, "{masses:?}");
    }
    let no_body = text.replace("<mass>60</mass>", "<mass>0</mass>");
    assert_eq!(mass_mismatch(&no_body, &MassRequest::default()), None, "the mass of the model is not known");
}

#[test]
fn a_mismatch_is_only_reported_after_the_finding_about_masses() {
    let text = with_note(&foot(&[SmoothContact { dissipation: 2.0, ..SOLE }]), 75.5);
    let result = check_text(&text);
    let aside = "; all values here are for 60 kg: `mass` 75.5 gives those for 75.5 kg";
    for finding in &result.findings {
        let of_masses = finding.code() == FindingCode::MassSourcesDisagree;
        assert_eq!(finding.message.to_string().ends_with(aside), of_masses, "{}", finding.message);
        assert_eq!(finding.remedy, None, "which mass is meant has to be settled first");
    }
    assert_eq!(codes(&result), [FindingCode::MassSourcesDisagree, FindingCode::BeyondHuntCrossley]);
}
