//! Masses that look like slips, and that known contacts explain.

use osim_model::{MassRequest, Model, NeedsAnswer, Selection, same_mass};

use super::KnownContacts;

/// The first of the masses said that looks like a slip for `model`: neither its note nor the contacts that the selected forces are
/// known to have say it.
#[must_use]
pub fn unexplained_slip(masses: &MassRequest, model: &Model, selection: &Selection) -> Option<NeedsAnswer> {
    unexplained(masses.slips(model), masses, model, selection)
}

/// The same of those that may be in pounds, and may as well not be: reason for a remark, and not for a question.
#[must_use]
pub fn perhaps_in_pounds(masses: &MassRequest, model: &Model, selection: &Selection) -> Option<NeedsAnswer> {
    unexplained(masses.perhaps_in_pounds(model), masses, model, selection)
}

fn unexplained(
    slips: Vec<NeedsAnswer>,
    masses: &MassRequest,
    model: &Model,
    selection: &Selection,
) -> Option<NeedsAnswer> {
    if slips.is_empty() {
        return None;
    }
    let known = selection
        .apply(model)
        .ok()
        .and_then(|selected| KnownContacts::find(model, &selected.forces, None, masses.bodies_kg(model)));
    let is_known = |asks: &NeedsAnswer| match asks {
        NeedsAnswer::Mass { kg, .. } => known.is_some_and(|known| same_mass(*kg, known.made_for_kg)),
        _ => false,
    };
    slips.into_iter().find(|asks| !is_known(asks))
}

#[cfg(test)]
mod tests {
    use osim_model::MassSlip;

    use super::*;

    /// Published contacts for 62 kg; the bodies of this model weigh 28 kg, which is 62 lb.
    fn child(stiffness: &str) -> Model {
        let text = include_str!("../../../../fixtures/check/known_contacts.osim");
        let text = text.replace("<stiffness>1000000<", &format!("<stiffness>{stiffness}<"));
        let masses = Model::parse(text.as_str()).unwrap();
        let bodies_kg = MassRequest::default().bodies_kg(&masses).unwrap();
        let pelvis = masses.bodies()[0].mass_kg().unwrap();
        let lighter = 28.0 - (bodies_kg - pelvis);
        let start = text.find("<mass>").unwrap() + "<mass>".len();
        let end = start + text[start..].find('<').unwrap();
        Model::parse(format!("{}{lighter}{}", &text[..start], &text[end..])).unwrap()
    }

    fn asked(model: &Model, contacts_mass_kg: Option<f64>, target_mass_kg: Option<f64>) -> Option<MassSlip> {
        let said = MassRequest { contacts_mass_kg, target_mass_kg, ..MassRequest::default() };
        match unexplained_slip(&said, model, &Selection::default())? {
            NeedsAnswer::Mass { slip, .. } => Some(slip),
            _ => None,
        }
    }

    #[test]
    fn a_mass_that_known_contacts_or_the_target_explain_is_not_asked_about() {
        let (known, own) = (child("1000000"), child("1020000"));
        assert!((MassRequest::default().bodies_kg(&own).unwrap() - 28.0).abs() < 1e-9);
        for (model, contacts_mass_kg, target_mass_kg, expected) in [
            (&known, Some(62.0), Some(28.0), None),
            (&known, Some(62.0), None, None),
            // Nobody's contacts, and a target in the unit of the bodies.
            (&own, Some(62.0), Some(28.0), None),
            (&own, Some(62.0), None, Some(MassSlip::Pounds)),
            (&known, Some(61.5), None, Some(MassSlip::Pounds)),
            (&own, Some(62.0), Some(30.0), Some(MassSlip::Pounds)),
            (&own, Some(28_000.0), Some(28.0), Some(MassSlip::Grams)),
        ] {
            assert_eq!(
                asked(model, contacts_mass_kg, target_mass_kg),
                expected,
                "{contacts_mass_kg:?} {target_mass_kg:?}"
            );
        }
    }

    #[test]
    fn a_target_in_grams_is_asked_about_for_a_body_of_another_size_too() {
        let model = child("1000000");
        for (target_mass_kg, expected) in [
            (20_000.0, Some(MassSlip::Grams)),
            (28.0 * 201.0, Some(MassSlip::Grams)),
            (28.0 * 4999.0, Some(MassSlip::Grams)),
            (28.0 * 199.0, None),
            (28.0 * 5001.0, None),
            (28.0, None),
        ] {
            assert_eq!(asked(&model, None, Some(target_mass_kg)), expected, "{target_mass_kg}");
        }
        let said = MassRequest { target_mass_kg: Some(20_000.0), ..MassRequest::default() };
        let asks = unexplained_slip(&said, &model, &Selection::default()).unwrap().phrase().to_string();
        // 20 000 / 28 is 714.3.
        assert!(asks.contains("about 714 times the 28 kg") && asks.contains("in g, write 20;"), "{asks}");
    }
}
