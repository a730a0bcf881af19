//! The mass of a model, the mass for which its contacts were made, and masses that look wrong.

use std::collections::BTreeMap;

use crate::messages::{Input, Phrase, four_significant, phrase};
use crate::model::fault::{
    Fault, FaultKind, MassMistake, MassesOfOtherRows, MissingFact, POUND_KG, Result, Suspicion,
};
use crate::model::names_and_sides::{Pattern, any_pattern_matches};
use crate::model::{Body, Finding, Model, rules};

/// Two masses count as one body if they differ by less than this (relative): a sensor, a belt or a prosthetic foot does not make another
/// body.
const EQUAL_MASSES_TOLERANCE: f64 = 0.02;

/// Contacts need no scaling if their mass is nearer to the target mass than this (relative): no scale is read more exactly than 0.1 %.
const AT_TARGET_TOLERANCE: f64 = 1e-3;

/// Two gravities count as equal if they differ by less than this (relative), as at two places on the Earth.
const EQUAL_GRAVITIES_TOLERANCE: f64 = 5e-3;

/// The masses that the caller gives, and the bodies to sum.
///
/// ```
/// # let model = osim_model::Model::parse(include_bytes!("../../tests/data/one_foot.osim").as_slice())?;
/// use osim_model::{MassRequest, MassSource};
///
/// // No mass is given: the bodies are summed. There is one, of 10 kg.
/// let mass = MassRequest::default().model_mass(&model)?;
/// assert_eq!((mass.kg, mass.source), (10.0, MassSource::Bodies(1)));
///
/// // The contacts were made for another mass, and the user knows which.
/// let request = MassRequest { contacts_mass_kg: Some(62.0), ..MassRequest::default() };
/// let (mass, findings) = request.contacts_mass(&model)?;
/// assert_eq!((mass.kg, mass.source), (62.0, MassSource::ContactsMass));
/// // The bodies say something else, which may be a mistake.
/// assert_eq!(findings[0].code().as_str(), "mass-sources-disagree");
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct MassRequest {
    /// The mass for which the contacts in the file were made, kg.
    pub contacts_mass_kg: Option<f64>,
    /// The mass of the model that the caller gave, kg; it counts instead of the sum of the bodies' masses.
    pub model_kg: Option<f64>,
    /// The target mass of the contacts, kg. Another source with exactly this mass needs no warning: bodies are often scaled before their
    /// contacts.
    pub target_mass_kg: Option<f64>,
    /// Bodies that do not belong to the animal and are left out of the sum.
    pub exclude_bodies: Vec<Pattern>,
    /// For a row of a table: for each input, the range of the masses in its other rows.
    pub other_rows: BTreeMap<Input, MassesOfOtherRows>,
}

/// Where a mass comes from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum MassSource {
    /// The caller gave the mass for which the contacts were made.
    ContactsMass,
    Note,
    /// The contacts in the file are published for this mass; the text is how people cite them.
    Known(&'static str),
    /// The caller gave the mass of the model.
    Mass,
    /// The sum of the bodies, with their number.
    Bodies(usize),
    Preset(String),
    /// The caller gave the mass of the reference.
    ReferenceMass,
    /// A point of a grid of masses.
    Grid,
}

impl MassSource {
    pub const fn as_str(&self) -> &'static str {
        match self {
            Self::ContactsMass => "contacts-mass",
            Self::Note => "note",
            Self::Known(_) => "known-contacts",
            Self::Mass => "mass",
            Self::Bodies(_) => "bodies",
            Self::Preset(_) => "preset",
            Self::ReferenceMass => "reference-mass",
            Self::Grid => "grid",
        }
    }

    /// Whether the source gives the mass for which the contacts were made, not only the mass of the body.
    pub const fn is_about_contacts(&self) -> bool {
        !matches!(self, Self::Mass | Self::Bodies(_))
    }

    /// The source in words, such as `sum of 21 bodies`.
    pub fn describe(&self) -> Phrase {
        match self {
            Self::ContactsMass => Input::ContactsMass.into(),
            Self::Note => "note in the file".into(),
            Self::Known(title) => format!("as in {title}").into(),
            Self::Mass => Input::Mass.into(),
            Self::Bodies(1) => "mass of 1 body".into(),
            Self::Bodies(count) => format!("sum of {count} bodies").into(),
            Self::Preset(name) => format!("preset {name}").into(),
            Self::ReferenceMass => Input::ReferenceMass.into(),
            Self::Grid => Input::Grid.into(),
        }
    }
}

/// A mass in kg, with its source.
#[derive(Debug, Clone, PartialEq)]
pub struct Mass {
    pub kg: f64,
    pub source: MassSource,
}

impl Mass {
    /// A phrase with this mass as the mass for which contacts were made. It says "taken as" if the source gives only the mass of the body.
    pub fn contacts_made_for(&self) -> Phrase {
        let taken =
            if self.source.is_about_contacts() { "contacts made for" } else { "contacts taken as made for" };
        phrase![format!("{taken} {} kg (", four_significant(self.kg)), &self.source.describe(), ")"]
    }
}

impl MassRequest {
    /// Patterns of excluded bodies that match no body of `model`, probably by mistake.
    pub fn unmatched_patterns<'p>(&'p self, model: &Model) -> impl Iterator<Item = &'p Pattern> {
        let matches_nothing =
            |pattern: &Pattern| !model.bodies().iter().any(|body| pattern.matches(&body.name));
        self.exclude_bodies.iter().filter(move |pattern| matches_nothing(pattern))
    }

    /// The mass of the model: as the caller gave it, else the sum of its bodies in file order. [`Body::excluded_from_mass`] says the
    /// bodies that are left out.
    ///
    /// # Errors
    /// A body has no mass, there is no body, the sum is not above 0, or joints form a loop in which OpenSim counts a body twice.
    pub fn model_mass(&self, model: &Model) -> Result<Mass> {
        if let Some(kg) = self.model_kg {
            return Ok(Mass { kg: positive_mass(Input::Mass, kg)?, source: MassSource::Mass });
        }
        if model.skeleton().loops.mass_is_in_doubt {
            return Err(Fault::new(MissingFact::MassOfLoop));
        }
        let mut kg = 0.0;
        let mut bodies = 0;
        let is_summed =
            |body: &&Body| !body.excluded_from_mass && !any_pattern_matches(&self.exclude_bodies, &body.name);
        for body in model.bodies().iter().filter(is_summed) {
            kg += body.mass_kg()?;
            bodies += 1;
        }
        if kg > 0.0 && kg.is_finite() {
            return Ok(Mass { kg, source: MassSource::Bodies(bodies) });
        }
        Err(Fault::new(MissingFact::ModelMass { bodies, kg }))
    }

    /// The mass for which contacts were made that are not published ones: as the caller gave it, else from the note, else the mass of the
    /// model. Also a warning for each other source that gives another mass.
    ///
    /// # Errors
    /// The note no longer fits the file, or an error of [`MassRequest::model_mass`].
    pub fn contacts_mass(&self, model: &Model) -> Result<(Mass, Vec<Finding>)> {
        let noted_kg = model.note.as_ref().and_then(|note| note.contacts_mass_kg);
        let mass = if let Some(kg) = self.contacts_mass_kg {
            Mass { kg: positive_mass(Input::ContactsMass, kg)?, source: MassSource::ContactsMass }
        } else if let Some(doubt) = model.doubt_about_note() {
            let input = Input::ContactsMass;
            return Err(Fault::new(MissingFact::ContactsMass { noted_kg, doubt, input }));
        } else if let Some(kg) = noted_kg {
            Mass { kg, source: MassSource::Note }
        } else {
            self.model_mass(model)?
        };
        let noted = noted_kg.filter(|_| mass.source != MassSource::Note);
        let findings = self.disagreements(model, &mass, noted.map(|kg| (kg, "the note in the file".into())));
        Ok((mass, findings))
    }

    /// A warning if the note in `model` is not in doubt and its mass differs from the mass that the caller gave.
    pub fn disagreement_with_note(&self, model: &Model) -> Option<Finding> {
        let kg = self.contacts_mass_kg?;
        let noted = self.disagreeing_note_kg(model)?;
        let taken = (kg, &MassSource::ContactsMass.describe());
        Some(rules::mass_sources_disagree(taken, (noted, &"the note in the file".into())))
    }

    /// The mass in the note of `model`, kg, if the note is not in doubt and its mass differs from the mass that the caller gave.
    pub fn disagreeing_note_kg(&self, model: &Model) -> Option<f64> {
        let given_kg = self.contacts_mass_kg?;
        let noted_kg = model.note.as_ref().and_then(|note| note.contacts_mass_kg)?;
        (!are_equal_masses(noted_kg, given_kg) && model.doubt_about_note().is_none()).then_some(noted_kg)
    }

    /// A warning for each other source, and for the mass `noted`, that differs from the mass `taken`. A model that gets other contacts has
    /// no noted mass.
    pub fn disagreements(&self, model: &Model, taken: &Mass, noted: Option<(f64, Phrase)>) -> Vec<Finding> {
        let noted_kg = noted.as_ref().map(|(kg, _)| *kg);
        let mut others: Vec<(f64, Phrase)> = noted.into_iter().collect();
        if let (Some(kg), true) = (self.model_kg, taken.source != MassSource::Mass) {
            others.push((kg, Input::Mass.into()));
        }
        let bodies = Self { model_kg: None, ..self.clone() };
        if let (Ok(mass), false) = (bodies.model_mass(model), matches!(taken.source, MassSource::Bodies(_))) {
            others.push((mass.kg, phrase!["the ", &mass.source.describe()]));
        }
        // The usual case: the body was scaled to the target already, and the user says what the contacts were made for.
        let expected = |kg: f64| {
            matches!(taken.source, MassSource::ContactsMass | MassSource::Note)
                && self.target_mass_kg.is_some_and(|target_mass_kg| are_equal_masses(kg, target_mass_kg))
        };
        let differs = |kg: f64| !are_equal_masses(kg, taken.kg) && !expected(kg);
        // The caller says what the model will weigh, and the contacts are for that.
        let is_for_scaled_bodies = taken.source.is_about_contacts()
            && self.model_kg.is_some_and(|kg| are_equal_masses(kg, taken.kg));
        if !is_for_scaled_bodies {
            // Sources that agree are one doubt.
            others.dedup_by(|other, first| are_equal_masses(other.0, first.0));
        }
        let finding = |(kg, source): (f64, Phrase)| {
            if is_for_scaled_bodies && noted_kg != Some(kg) {
                return rules::bodies_not_scaled(kg, taken.kg);
            }
            rules::mass_sources_disagree((taken.kg, &taken.source.describe()), (kg, &source))
        };
        others.into_iter().filter(|(kg, _)| differs(*kg)).map(finding).collect()
    }
}

/// Whether contacts for `contacts_kg` can be used for `target_kg` without scaling.
pub fn is_at_target(contacts_kg: f64, target_kg: f64) -> bool {
    (target_kg - contacts_kg).abs() <= AT_TARGET_TOLERANCE * contacts_kg.abs()
}

/// Whether two masses count as equal: they differ by at most `EQUAL_MASSES_TOLERANCE` of the smaller one, whichever comes first.
pub fn are_equal_masses(a: f64, b: f64) -> bool {
    (a - b).abs() <= EQUAL_MASSES_TOLERANCE * a.abs().min(b.abs())
}

/// Whether two gravities count as equal: `noted` is within 0.5 % of `own`.
pub fn are_equal_gravities(noted: f64, own: f64) -> bool {
    (noted - own).abs() <= EQUAL_GRAVITIES_TOLERANCE * own
}

/// Checks that `kg` is a finite number above 0. The error names `input`, by which the caller gave the mass.
pub fn positive_mass(input: Input, kg: f64) -> Result<f64> {
    if kg.is_finite() && kg > 0.0 {
        return Ok(kg);
    }
    Err(Fault::new(FaultKind::BadInput { input, value: kg, expected: "a mass in kg above 0" }))
}

// Masses that look wrong: in another unit, or with a digit too many or too few.

/// A ratio of masses counts as 1000 or 1/1000 if it is at least as near as this (relative).
const GRAMS_TOLERANCE: f64 = 0.15;
/// The program asks whether a mass is in pounds if it differs by at most this (relative) from the bodies' mass in pounds.
const POUNDS_TOLERANCE: f64 = 0.01;
/// The program remarks that a mass may be in pounds if it differs by at most this (relative) from the bodies' mass in pounds: it may also
/// be the mass of a heavy person.
const WIDE_POUNDS_TOLERANCE: f64 = 0.15;
/// The lightest mass of an animal with contacts, kg: 1 mg.
const LIGHTEST_BODY_KG: f64 = 1e-6;
/// The heaviest mass of an animal with contacts, kg: 200 t.
const HEAVIEST_BODY_KG: f64 = 200e3;
/// A target mass looks like grams if it is this many times the mass of the bodies: 1000 times, for bodies of different size up to a factor
/// of 5.
const GRAMS_OF_A_TARGET: std::ops::RangeInclusive<f64> = 200.0..=5000.0;

/// A question about the mass `kg`, which the caller gave as `input`, if it looks wrong for bodies of `bodies_kg` together.
pub fn implausible_mass(input: Input, kg: f64, bodies_kg: Option<f64>) -> Option<Suspicion> {
    suspicious_mass(input, kg, bodies_kg, POUNDS_TOLERANCE, None)
}

/// A question about a mass that looks wrong. The mass counts as pounds if it is as near as `near_pounds` (relative) to the bodies' mass in
/// pounds. In a table whose other rows have the masses `other_rows`, it is compared with these, not with the bodies: if the masses of all
/// rows differ from the bodies, this is intended.
fn suspicious_mass(
    input: Input,
    kg: f64,
    bodies_kg: Option<f64>,
    near_pounds: f64,
    other_rows: Option<MassesOfOtherRows>,
) -> Option<Suspicion> {
    // What the bodies weigh is the right unit.
    if input == Input::TargetMass && bodies_kg.is_some_and(|bodies| are_equal_masses(kg, bodies)) {
        return None;
    }
    let near =
        |factor: f64| bodies_kg.is_some_and(|bodies| (kg / bodies / factor - 1.0).abs() <= near_pounds);
    let (mistake, other_rows) = match (gross_mistake(input, kg, bodies_kg), other_rows) {
        (Some(mistake), _) => (mistake, None),
        (None, Some(rows)) => (rows.mistake(kg)?, other_rows),
        (None, None) if near(1.0 / POUND_KG) => (MassMistake::Pounds, None),
        (None, None) => (near(POUND_KG).then_some(MassMistake::BodiesInPounds)?, None),
    };
    Some(Suspicion::Mass { input, kg, bodies_kg, other_rows, mistake })
}

/// Whether the mass looks like grams or tonnes, or is impossible for an animal.
fn gross_mistake(input: Input, kg: f64, bodies_kg: Option<f64>) -> Option<MassMistake> {
    let grams_of_target = input == Input::TargetMass
        && bodies_kg.is_some_and(|bodies| GRAMS_OF_A_TARGET.contains(&(kg / bodies)));
    let near =
        |factor: f64| bodies_kg.is_some_and(|bodies| (kg / bodies / factor - 1.0).abs() <= GRAMS_TOLERANCE);
    match () {
        () if near(1000.0) || grams_of_target => Some(MassMistake::Grams),
        () if near(1.0 / 1000.0) => Some(MassMistake::Tonnes),
        () if !(LIGHTEST_BODY_KG..=HEAVIEST_BODY_KG).contains(&kg) => Some(MassMistake::NoAnimal),
        () => None,
    }
}

impl MassRequest {
    /// The sum of the bodies, even if the caller gives another mass of the model; `None` if it is not known.
    pub fn bodies_kg(&self, model: &Model) -> Option<f64> {
        let bodies = Self { model_kg: None, ..self.clone() };
        bodies.model_mass(model).ok().map(|mass| mass.kg)
    }

    /// Questions about given masses that look wrong for this model. A mass that the note in the model confirms is right. If the target mass
    /// equals the bodies' mass, the other given masses are in the same unit, too.
    pub fn implausible_masses(&self, model: &Model) -> Vec<Suspicion> {
        self.suspicious_masses(model, POUNDS_TOLERANCE)
    }

    /// The given masses that may be in pounds, but not so probably that the program asks. Rows of a table are compared with each other
    /// instead.
    pub fn masses_perhaps_in_pounds(&self, model: &Model) -> Vec<Suspicion> {
        let loosely = self.suspicious_masses(model, WIDE_POUNDS_TOLERANCE);
        let asked = self.suspicious_masses(model, POUNDS_TOLERANCE);
        let is_in_pounds =
            |one: &Suspicion| matches!(one, Suspicion::Mass { mistake: MassMistake::Pounds, .. });
        loosely.into_iter().filter(|one| is_in_pounds(one) && !asked.contains(one)).collect()
    }

    fn suspicious_masses(&self, model: &Model, near_pounds: f64) -> Vec<Suspicion> {
        let given_masses = [
            (Input::TargetMass, self.target_mass_kg),
            (Input::ContactsMass, self.contacts_mass_kg),
            (Input::Mass, self.model_kg),
        ];
        if given_masses.iter().all(|(_, kg)| kg.is_none()) {
            return Vec::new();
        }
        let noted_kg = model.note.as_ref().and_then(|note| note.contacts_mass_kg);
        let bodies_kg = self.bodies_kg(model);
        let unit_is_known = self
            .target_mass_kg
            .zip(bodies_kg)
            .is_some_and(|(target_mass_kg, bodies)| are_equal_masses(target_mass_kg, bodies));
        let question = |(input, kg): (Input, Option<f64>)| {
            let kg = kg.filter(|&kg| !noted_kg.is_some_and(|noted| are_equal_masses(kg, noted)))?;
            let other_rows = self.other_rows.get(&input).copied();
            let doubt = suspicious_mass(input, kg, bodies_kg, near_pounds, other_rows)?;
            let explained = unit_is_known && input == Input::ContactsMass && doubt.is_about_pounds();
            (!explained).then_some(doubt)
        };
        given_masses.into_iter().filter_map(question).collect()
    }
}
