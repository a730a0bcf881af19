//! Under which load a model is inspected: whose weight, by which forces, on how many spheres; and masses that look like slips.

use std::path::PathBuf;

use osim_model::messages::{Input, Phrase, phrase, readable};
use osim_model::{
    CountedSpheres, Fault, ForceId, Limb, Limbs, MassRequest, MassSource, Model, Needed, NeedsAnswer,
    Selection, implausible_mass, same_mass,
};
use osim_requests::options::{InspectionOptions, StanceOptions};
use osim_requests::{Acceleration, Count, Positive};

use crate::known_contacts::KnownContacts;

/// Under which load, on how many spheres.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Stance {
    /// Spheres that share the body weight, all stance limbs together; `None`: as found on a limb.
    pub spheres: Option<f64>,
    /// Limbs that share the body weight; `None`: as the note in the model says, else one.
    pub limbs: Option<f64>,
    /// Speed before an impact, m/s; `None`: √(gR/2).
    pub impact_speed_m_s: Option<f64>,
    /// Gravity instead of the model's own, m/s².
    pub gravity_m_s2: Option<f64>,
}

impl Stance {
    /// Limbs that share the weight of `model`.
    pub fn limbs_of(&self, model: &Model) -> f64 {
        self.limbs.or(model.noted_stance_limbs()).unwrap_or(1.0)
    }
}

/// Whose weight, by which forces, on how many spheres.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct InspectOptions {
    pub masses: MassRequest,
    pub selection: Selection,
    pub stance: Stance,
    /// The geometry set of a force set that stands alone; remedies name it again.
    pub geometry: Option<PathBuf>,
    /// The model of a force set that stands alone; remedies name it again.
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

// n, the number of spheres that share the body weight: the one rule for it.

/// Which spheres share the weight of the body that chosen forces belong to.
///
/// All spheres that stand count, whichever forces were chosen: those left out carry weight too. What stands beside the body,
/// joined to it only through ground, does not count.
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
/// // A number that was given goes before.
/// assert_eq!(sharing.count(Some(6.0), 2.0, CountedSpheres::Model)?, 6.0);
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LoadSharing {
    limbs: Limbs,
    forces: Vec<ForceId>,
}

impl LoadSharing {
    /// For the body that the spheres of `chosen` belong to.
    pub fn of(model: &Model, chosen: &[ForceId]) -> Self {
        let forces = model.forces_of_same_body(chosen);
        Self { limbs: model.limbs(&forces), forces }
    }

    /// For a model whose forces cannot be chosen.
    pub(crate) fn unknown(why: Phrase) -> Self {
        Self { limbs: Limbs::Unknown(why), forces: Vec::new() }
    }

    pub fn limbs(&self) -> &Limbs {
        &self.limbs
    }

    /// The forces through which the body stands, chosen or not.
    pub fn forces(&self) -> &[ForceId] {
        &self.forces
    }

    /// n: as `given`, else the spheres of a limb times the `stance_limbs`. `of` says whose spheres a question is about.
    ///
    /// # Errors
    /// None was given, and left and right are not known, or limbs have different numbers of spheres.
    pub fn count(&self, given: Option<f64>, stance_limbs: f64, of: CountedSpheres) -> Result<f64, Fault> {
        if let Some(count) = given {
            return Ok(count);
        }
        match self.limbs.spheres_per_limb() {
            Ok(spheres) => Ok(on_limbs(spheres, stance_limbs)),
            Err(why) => Err(Fault::new(Needed::SphereCount { of, why })),
        }
    }

    /// n while the body stands on limbs like `limb`: figures are given for each limb, even where limbs differ.
    pub fn count_on(limb: &Limb, given: Option<f64>, stance_limbs: f64) -> f64 {
        given.unwrap_or_else(|| on_limbs(limb.spheres.len(), stance_limbs))
    }
}

#[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
fn on_limbs(spheres: usize, stance_limbs: f64) -> f64 {
    spheres as f64 * stance_limbs
}

/// The two masses, where the note in the file says one and the bodies another, and no option says which is meant.
#[derive(Debug, Clone, PartialEq)]
pub struct MassMismatch {
    body_kg: f64,
    contacts_mass_kg: f64,
}

impl MassMismatch {
    /// `None` where they agree, or the caller says what the model weighs.
    pub fn find(model: &Model, masses: &MassRequest) -> Option<Self> {
        if masses.model_kg.is_some() {
            return None;
        }
        let body = masses.model_mass(model).ok()?;
        let (contacts, _) = masses.contacts_mass(model).ok()?;
        let noted = contacts.source == MassSource::Note && !same_mass(contacts.kg, body.kg);
        noted.then_some(Self { body_kg: body.kg, contacts_mass_kg: contacts.kg })
    }

    /// What the contacts do is computed under their own body.
    pub fn message(&self) -> Phrase {
        let (body, contacts) = (readable(self.body_kg), readable(self.contacts_mass_kg));
        phrase![
            format!(
                "its contacts are made for {contacts} kg (note in the file) and carry its body of {body} kg here: say "
            ),
            Input::Mass.with_value(contacts),
            &self.answer(),
            ", or scale the body first",
        ]
    }

    /// The mismatch as a clause after a finding.
    pub(crate) fn aside(&self) -> Phrase {
        let (body, contacts) = (readable(self.body_kg), readable(self.contacts_mass_kg));
        phrase![
            format!("; figures are those under {body} kg: for the others say "),
            Input::Mass.with_value(contacts),
            &self.answer(),
        ]
    }

    /// The answer to give with the mass of the contacts, if it would be asked about.
    fn answer(&self) -> Phrase {
        match implausible_mass(Input::Mass, self.contacts_mass_kg, Some(self.body_kg)) {
            Some(asks) => phrase![" with ", &asks.question().answer()],
            None => Phrase::default(),
        }
    }
}

/// The first of the masses said that looks like a slip for `model`: neither its note nor the contacts that the selected forces are
/// known to have say it.
pub fn unexplained_slip(masses: &MassRequest, model: &Model, selection: &Selection) -> Option<NeedsAnswer> {
    unexplained(masses.implausible_masses(model), masses, model, selection)
}

/// Masses that may be in pounds, and may as well not be: reason for a remark, and not for a question.
pub fn masses_perhaps_in_pounds(
    masses: &MassRequest,
    model: &Model,
    selection: &Selection,
) -> Option<NeedsAnswer> {
    unexplained(masses.masses_perhaps_in_pounds(model), masses, model, selection)
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
    use osim_model::MassMistake;

    use super::*;

    /// Published contacts for 62 kg; the bodies of this model weigh 28 kg, which is 62 lb.
    fn child(stiffness: &str) -> Model {
        let text = include_str!("../../../fixtures/check/known_contacts.osim");
        let text = text.replace("<stiffness>1000000<", &format!("<stiffness>{stiffness}<"));
        let masses = Model::parse(text.as_str()).unwrap();
        let bodies_kg = MassRequest::default().bodies_kg(&masses).unwrap();
        let pelvis = masses.bodies()[0].mass_kg().unwrap();
        let lighter = 28.0 - (bodies_kg - pelvis);
        let start = text.find("<mass>").unwrap() + "<mass>".len();
        let end = start + text[start..].find('<').unwrap();
        Model::parse(format!("{}{lighter}{}", &text[..start], &text[end..])).unwrap()
    }

    fn asked(
        model: &Model,
        contacts_mass_kg: Option<f64>,
        target_mass_kg: Option<f64>,
    ) -> Option<MassMistake> {
        let said = MassRequest { contacts_mass_kg, target_mass_kg, ..MassRequest::default() };
        match unexplained_slip(&said, model, &Selection::default())? {
            NeedsAnswer::Mass { mistake, .. } => Some(mistake),
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
            (&own, Some(62.0), None, Some(MassMistake::Pounds)),
            (&known, Some(61.5), None, Some(MassMistake::Pounds)),
            (&own, Some(62.0), Some(30.0), Some(MassMistake::Pounds)),
            (&own, Some(28_000.0), Some(28.0), Some(MassMistake::Grams)),
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
            (20_000.0, Some(MassMistake::Grams)),
            (28.0 * 201.0, Some(MassMistake::Grams)),
            (28.0 * 4999.0, Some(MassMistake::Grams)),
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
