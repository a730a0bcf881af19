//! Determines the load under which a model is inspected: body weight, forces, and number of spheres. Finds masses that look like a typing
//! mistake or another unit.

use std::path::PathBuf;

use osim_model::messages::{Input, Phrase, phrase, readable};
use osim_model::{
    CountedSpheres, Fault, Finding, ForceId, Limb, Limbs, Mass, MassRequest, MassSource, MissingFact, Model,
    Result, Selection, Suspicion, are_equal_masses, implausible_mass,
};
use osim_requests::options::{InspectionOptions, StanceOptions};
use osim_requests::{Acceleration, Count, Positive};

use crate::known_contacts::KnownContacts;

/// How many spheres and limbs share the weight, the gravity, and the speed before an impact.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Stance {
    /// Number of spheres of all stance limbs together that share the body weight; `None`: the number of spheres of a limb in the model.
    pub spheres: Option<f64>,
    /// Number of limbs that share the body weight; `None`: the number in the note of the model, else one.
    pub limbs: Option<f64>,
    /// Speed before an impact, m/s; `None`: √(gR/2).
    pub impact_speed_m_s: Option<f64>,
    /// Gravity that is used instead of the model's, m/s²; `None`: the gravity of the model.
    pub gravity_m_s2: Option<f64>,
}

impl Stance {
    /// The number of limbs that share the weight of `model`.
    pub fn limb_count(&self, model: &Model) -> f64 {
        self.limbs.or(model.noted_stance_limbs()).unwrap_or(1.0)
    }

    /// What carries the body, in words: `limbs`, or as many spheres as the caller gives.
    pub(crate) fn carriers(&self, limbs: f64) -> String {
        match (self.spheres, limbs) {
            (Some(count), _) => format!("{} of them,", readable(count)),
            (None, 1.0) => "one limb".to_owned(),
            (None, limbs) => format!("{} limbs", readable(limbs)),
        }
    }
}

/// Options of an inspection: masses, choice of forces, and load.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct InspectOptions {
    pub masses: MassRequest,
    pub selection: Selection,
    pub stance: Stance,
    /// The file with the geometry set, if the force set is a file by itself. Remedies repeat this file.
    pub geometry: Option<PathBuf>,
    /// The file of the model, if the force set is a file by itself. Remedies repeat this file.
    pub model: Option<PathBuf>,
}

impl From<&StanceOptions> for Stance {
    fn from(options: &StanceOptions) -> Self {
        Self {
            spheres: options.spheres.map(Count::get),
            limbs: options.stance_limbs.map(Count::get),
            impact_speed_m_s: options.impact_speed.map(Positive::get),
            gravity_m_s2: options.gravity.map(Acceleration::get),
        }
    }
}

impl From<&InspectionOptions> for InspectOptions {
    fn from(options: &InspectionOptions) -> Self {
        Self {
            masses: options.masses.request(),
            selection: options.choice.selection(),
            stance: Stance::from(&options.stance),
            geometry: options.set_files.geometry.clone(),
            model: options.set_files.model.clone(),
        }
    }
}

/// Determines n, the number of spheres that share the weight of the body that chosen forces belong to.
///
/// All spheres of the body on the floor count, because spheres whose forces were not chosen carry weight, too. Spheres of another body,
/// which only ground connects with it, do not count.
///
/// ```
/// use osim_inspect::LoadSharing;
/// use osim_model::{CountedSpheres, Model, Selection};
///
/// # let bytes: &[u8] = include_bytes!("../../osim-model/tests/data/one_foot.osim");
/// // One sphere on one limb; n on two such limbs is 2.
/// let model = Model::parse(bytes)?;
/// let selected = Selection::default().apply(&model)?;
/// let sharing = LoadSharing::of(&model, &selected.forces);
/// assert_eq!(sharing.count(None, 2.0, CountedSpheres::Model)?, 2.0);
/// // A number that the caller gives comes first.
/// assert_eq!(sharing.count(Some(6.0), 2.0, CountedSpheres::Model)?, 6.0);
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LoadSharing {
    pub limbs: Limbs,
    /// The forces that press the spheres of the body on the floor, chosen or not.
    pub forces: Vec<ForceId>,
}

impl LoadSharing {
    /// Finds the limbs of the body that the `chosen` forces belong to.
    pub fn of(model: &Model, chosen: &[ForceId]) -> Self {
        let forces = model.forces_of_same_body(chosen);
        Self { limbs: model.limbs(&forces), forces }
    }

    /// The sharing of the load in a model in which no force can be chosen; `why` is the reason.
    pub(crate) fn unknown(why: Phrase) -> Self {
        Self { limbs: Limbs::Unknown(why), forces: Vec::new() }
    }

    /// The number n of spheres that share the weight: `given`, else the number of spheres of a limb times `stance_limbs`. The error message
    /// uses `whose`.
    ///
    /// # Errors
    ///
    /// No number is given, and left and right are not known, or limbs have different numbers of spheres.
    pub fn count(&self, given: Option<f64>, stance_limbs: f64, whose: CountedSpheres) -> Result<f64> {
        let on_limbs = || self.limbs.spheres_per_limb().map(|spheres| spheres as f64 * stance_limbs);
        let count = given.map_or_else(on_limbs, Ok);
        count.map_err(|why| Fault::new(MissingFact::SphereCount { of: whose, why }))
    }

    /// The number n of spheres that share the weight while the body stands on limbs like `limb`. Figures need n for each limb, even if
    /// limbs differ.
    pub fn count_on_limb(limb: &Limb, given: Option<f64>, stance_limbs: f64) -> f64 {
        given.unwrap_or(limb.spheres.len() as f64 * stance_limbs)
    }
}

/// The mass for which the contacts of some forces were made, and the source of this mass.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactsOrigin {
    /// The mass, from the first source that has one: the caller, the note, the published contacts that these contacts are, the bodies of
    /// the model.
    pub mass: Mass,
    /// The published contacts that these contacts are, if neither the caller nor a note gives a mass.
    pub known: Option<KnownContacts>,
    /// A warning for each source of a mass that disagrees with the chosen source.
    pub findings: Vec<Finding>,
}

impl ContactsOrigin {
    /// Determines the mass for which the contacts of `forces` in `model` were made.
    ///
    /// # Errors
    /// A note that no longer fits the file, or any error of [`MassRequest::model_mass`].
    pub fn find(model: &Model, forces: &[ForceId], masses: &MassRequest, stance: &Stance) -> Result<Self> {
        let is_said = masses.contacts_mass(model)?.0.source.is_about_contacts();
        let known = (!is_said).then(|| {
            let sharing = LoadSharing::of(model, forces);
            let count = sharing.count(stance.spheres, stance.limb_count(model), CountedSpheres::Model).ok();
            let weighs_kg = masses.model_mass(model).ok().map(|mass| mass.kg);
            KnownContacts::find(model, forces, count, weighs_kg)
        });
        Self::with_known(model, masses, known.flatten())
    }

    /// Like [`find`](Self::find), for a caller that has already looked for published contacts.
    pub(crate) fn with_known(
        model: &Model,
        masses: &MassRequest,
        known: Option<KnownContacts>,
    ) -> Result<Self> {
        let (mut mass, findings) = masses.contacts_mass(model)?;
        let published = known.filter(|known| !mass.source.is_about_contacts() && !known.is_made_for(mass.kg));
        if let Some(known) = published {
            mass = Mass { kg: known.made_for_kg, source: MassSource::Known(known.title) };
        }
        Ok(Self { mass, known, findings })
    }

    /// Refuses published contacts if the model weighs something else than their mass, unless the caller confirmed the mass with `input`.
    ///
    /// # Errors
    /// The question.
    pub fn refuse_other_body(&self, model: &Model, masses: &MassRequest, input: Input) -> Result<()> {
        let MassSource::Known(title) = self.mass.source else { return Ok(()) };
        let bodies_kg = masses.model_mass(model)?.kg;
        if are_equal_masses(self.mass.kg, bodies_kg) {
            return Ok(());
        }
        let (title, made_for_kg) = (title.to_owned(), self.mass.kg);
        Err(Fault::new(MissingFact::KnownContactsMass { title, made_for_kg, bodies_kg, input }))
    }
}

/// Two masses that disagree: the mass that contacts were made for (from a note or a publication), and the mass of the bodies. No option
/// says which of them counts.
#[derive(Debug, Clone, PartialEq)]
pub struct MassMismatch {
    body_kg: f64,
    contacts_mass: Mass,
}

impl MassMismatch {
    /// Compares the two masses; `None` if they agree, or the caller says what the model weighs.
    pub fn find(model: &Model, masses: &MassRequest, contacts_mass: Option<&Mass>) -> Option<Self> {
        if masses.model_kg.is_some() {
            return None;
        }
        let contacts_mass = contacts_mass?.clone();
        let body_kg = masses.model_mass(model).ok()?.kg;
        let is_of_contacts = matches!(contacts_mass.source, MassSource::Note | MassSource::Known(_));
        (is_of_contacts && !are_equal_masses(contacts_mass.kg, body_kg))
            .then_some(Self { body_kg, contacts_mass })
    }

    /// The mismatch between the mass in the note of `model` and the mass of its bodies.
    pub(crate) fn of_note(model: &Model, masses: &MassRequest) -> Option<Self> {
        let (contacts_mass, _) = masses.contacts_mass(model).ok()?;
        Self::find(model, masses, Some(&contacts_mass))
    }

    /// A message for calculators, which compute under the mass of the bodies.
    pub fn message(&self) -> Phrase {
        let (body, contacts) = (readable(self.body_kg), readable(self.contacts_mass.kg));
        phrase![
            "its contacts are made for {contacts} kg ({}) and carry its body of {body} kg here: give {}{}, or scale \
            the body first";
            &self.contacts_mass.source.describe(), Input::Mass.with_value(contacts.clone()),
            &self.answer_to_question()
        ]
    }

    /// A clause about the two masses, to add to the message of a finding.
    pub(crate) fn clause_about_masses(&self) -> Phrase {
        let (body, contacts) = (readable(self.body_kg), readable(self.contacts_mass.kg));
        let other = phrase![
            ": {}{} gives those for {contacts} kg";
            Input::Mass.with_value(contacts.clone()), &self.answer_to_question()
        ];
        phrase![format!("; all values here are for {body} kg"), Input::Mass.either(other, "")]
    }

    /// The answer ` with ...` to add to the mass of the contacts on the command line, if the program would ask about that mass; else empty.
    fn answer_to_question(&self) -> Phrase {
        match implausible_mass(Input::Mass, self.contacts_mass.kg, Some(self.body_kg)) {
            Some(doubt) => phrase![" with ", &doubt.question().answer_option()],
            None => Phrase::default(),
        }
    }
}

/// The first of the given masses that looks like a typing mistake or another unit for `model`, unless its note or the known contacts of
/// the selected forces have that mass.
pub fn unexplained_mass(masses: &MassRequest, model: &Model, selection: &Selection) -> Option<Suspicion> {
    first_unexplained(masses.implausible_masses(model), masses, model, selection)
}

/// The first of the `suspicions` about masses that neither the note in `model` nor the known contacts of the selected forces explain.
pub fn first_unexplained(
    suspicions: Vec<Suspicion>,
    masses: &MassRequest,
    model: &Model,
    selection: &Selection,
) -> Option<Suspicion> {
    if suspicions.is_empty() {
        return None;
    }
    let known_contacts = selection
        .apply(model)
        .ok()
        .and_then(|selected| KnownContacts::find(model, &selected.forces, None, masses.bodies_kg(model)));
    let is_known = |doubt: &Suspicion| match doubt {
        Suspicion::Mass { kg, .. } => {
            known_contacts.is_some_and(|known| are_equal_masses(*kg, known.made_for_kg))
        }
        _ => false,
    };
    suspicions.into_iter().find(|doubt| !is_known(doubt))
}

#[cfg(test)]
mod tests {
    use osim_model::MassMistake;

    use super::*;

    /// A model of 28 kg, which is 62 lb. With a stiffness of 1000000 it has published contacts for 62 kg.
    fn model_of_child(stiffness: &str) -> Model {
        let text = include_str!("../../../fixtures/check/known_contacts.osim");
        let text = text.replace("<stiffness>1000000<", &format!("<stiffness>{stiffness}<"));
        let model = Model::parse(text.as_str()).unwrap();
        let bodies_kg = MassRequest::default().bodies_kg(&model).unwrap();
        let pelvis = model.bodies()[0].mass_kg().unwrap();
        let lighter = 28.0 - (bodies_kg - pelvis);
        let start = text.find("<mass>").unwrap() + "<mass>".len();
        let end = start + text[start..].find('<').unwrap();
        Model::parse(format!("{}{lighter}{}", &text[..start], &text[end..])).unwrap()
    }

    fn reported_suspicion(
        model: &Model,
        contacts_mass_kg: Option<f64>,
        target_mass_kg: Option<f64>,
    ) -> Option<MassMistake> {
        let masses = MassRequest { contacts_mass_kg, target_mass_kg, ..MassRequest::default() };
        match unexplained_mass(&masses, model, &Selection::default())? {
            Suspicion::Mass { mistake, .. } => Some(mistake),
            _ => None,
        }
    }

    #[test]
    fn a_mass_of_known_contacts_or_of_the_target_raises_no_question() {
        let (known, other) = (model_of_child("1000000"), model_of_child("1020000"));
        assert!((MassRequest::default().bodies_kg(&other).unwrap() - 28.0).abs() < 1e-9);
        for (model, contacts_mass_kg, target_mass_kg, expected) in [
            (&known, Some(62.0), Some(28.0), None),
            (&known, Some(62.0), None, None),
            // These contacts are not known; the target has the unit of the bodies.
            (&other, Some(62.0), Some(28.0), None),
            (&other, Some(62.0), None, Some(MassMistake::Pounds)),
            // Within 2 % it is the mass that they are known to be made for.
            (&known, Some(61.5), None, None),
            (&other, Some(62.0), Some(30.0), Some(MassMistake::Pounds)),
            (&other, Some(28_000.0), Some(28.0), Some(MassMistake::Grams)),
        ] {
            assert_eq!(
                reported_suspicion(model, contacts_mass_kg, target_mass_kg),
                expected,
                "{contacts_mass_kg:?} {target_mass_kg:?}"
            );
        }
    }

    #[test]
    fn a_target_mass_in_grams_raises_a_question_for_a_body_of_any_size() {
        let model = model_of_child("1000000");
        for (target_mass_kg, expected) in [
            (20_000.0, Some(MassMistake::Grams)),
            (28.0 * 201.0, Some(MassMistake::Grams)),
            (28.0 * 4999.0, Some(MassMistake::Grams)),
            (28.0 * 199.0, None),
            (28.0 * 5001.0, None),
            (28.0, None),
        ] {
            assert_eq!(reported_suspicion(&model, None, Some(target_mass_kg)), expected, "{target_mass_kg}");
        }
        let masses = MassRequest { target_mass_kg: Some(20_000.0), ..MassRequest::default() };
        let doubt = unexplained_mass(&masses, &model, &Selection::default()).unwrap().phrase().to_string();
        // 20 000 / 28 is 714.3.
        assert!(doubt.contains("about 714 times the 28 kg") && doubt.contains("in g, write 20;"), "{doubt}");
    }
}
