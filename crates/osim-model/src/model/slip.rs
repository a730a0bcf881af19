//! Masses that look like slips: in another unit, or with a figure too many.

use crate::messages::Input;

use crate::model::fault::NeedsAnswer;
use crate::model::mass::{MassRequest, same_mass};
use crate::model::mass_slip::{MassSlip, POUND_KG};
use crate::model::masses_beside::MassesBeside;
use crate::model::typed_model::Model;

/// How near to a factor of 1000 a ratio of masses counts as that factor.
const NEAR: f64 = 0.15;
/// The same of pounds, for a question: the same body weighs the same in both units, but for what scales and people round.
const NEAR_POUNDS: f64 = 0.01;
/// The same, for a remark: in between are heavy people.
const PERHAPS_POUNDS: f64 = 0.15;
/// Lighter than any animal that contacts are made for, kg: 1 mg.
const LIGHTEST_KG: f64 = 1e-6;
/// Heavier than any: 200 t, kg.
const HEAVIEST_KG: f64 = 200e3;
/// From this many times the bodies' mass on, a target looks like grams: 1000 times, for a body within a factor of 5.
const GRAMS_OF_A_TARGET: std::ops::RangeInclusive<f64> = 200.0..=5000.0;

/// Whether `kg`, which the caller gave as `input`, looks like a slip for a model whose bodies weigh `bodies_kg` together.
#[must_use]
pub fn mass_slip(input: Input, kg: f64, bodies_kg: Option<f64>) -> Option<NeedsAnswer> {
    within(input, kg, bodies_kg, NEAR_POUNDS)
}

/// The same, where a mass counts as one in pounds that is so near to it.
fn within(input: Input, kg: f64, bodies_kg: Option<f64>, near_pounds: f64) -> Option<NeedsAnswer> {
    // What the bodies weigh is the right unit.
    if is_of_bodies(input, kg, bodies_kg) {
        return None;
    }
    let near =
        |factor: f64| bodies_kg.is_some_and(|bodies| (kg / bodies / factor - 1.0).abs() <= near_pounds);
    let slip = far_off(input, kg, bodies_kg)
        .or_else(|| near(1.0 / POUND_KG).then_some(MassSlip::Pounds))
        .or_else(|| near(POUND_KG).then_some(MassSlip::BodiesInPounds))?;
    Some(NeedsAnswer::Mass { input, kg, bodies_kg, beside: None, slip })
}

/// The same of a row of a table, whose other rows have the masses `beside`: many bodies of half the size or twice are meant, one is not.
fn among(input: Input, kg: f64, bodies_kg: Option<f64>, beside: MassesBeside) -> Option<NeedsAnswer> {
    if is_of_bodies(input, kg, bodies_kg) {
        return None;
    }
    if let Some(slip) = far_off(input, kg, bodies_kg) {
        return Some(NeedsAnswer::Mass { input, kg, bodies_kg, beside: None, slip });
    }
    let slip = beside.slip(kg)?;
    Some(NeedsAnswer::Mass { input, kg, bodies_kg, beside: Some(beside), slip })
}

fn is_of_bodies(input: Input, kg: f64, bodies_kg: Option<f64>) -> bool {
    input == Input::TargetMass && bodies_kg.is_some_and(|bodies| same_mass(kg, bodies))
}

/// Grams, tonnes, or a mass that no animal has.
fn far_off(input: Input, kg: f64, bodies_kg: Option<f64>) -> Option<MassSlip> {
    let grams_of_target = input == Input::TargetMass
        && bodies_kg.is_some_and(|bodies| GRAMS_OF_A_TARGET.contains(&(kg / bodies)));
    let near = |factor: f64| bodies_kg.is_some_and(|bodies| (kg / bodies / factor - 1.0).abs() <= NEAR);
    match () {
        () if near(1000.0) || grams_of_target => Some(MassSlip::Grams),
        () if near(1.0 / 1000.0) => Some(MassSlip::Tonnes),
        () if !(LIGHTEST_KG..=HEAVIEST_KG).contains(&kg) => Some(MassSlip::NoAnimal),
        () => None,
    }
}

impl MassRequest {
    /// The sum of the bodies, whatever the caller says that the model weighs; `None` where it is not known.
    #[must_use]
    pub fn bodies_kg(&self, model: &Model) -> Option<f64> {
        let bodies = Self { model_kg: None, ..self.clone() };
        bodies.of_model(model).ok().map(|mass| mass.kg)
    }

    /// The masses said that look like slips for this model. What its note says is not a slip; and a caller who gives the target
    /// in the unit of the bodies gives the other masses in it, too.
    #[must_use]
    pub fn slips(&self, model: &Model) -> Vec<NeedsAnswer> {
        self.odd(model, NEAR_POUNDS)
    }

    /// Those among the masses said that may be in pounds, and may as well not be: too far from it for a question. The rows of a
    /// table are judged by each other instead. Of lighter ones, such as a child's, nothing is said: bodies in pounds are rare.
    #[must_use]
    pub fn perhaps_in_pounds(&self, model: &Model) -> Vec<NeedsAnswer> {
        let loosely = self.odd(model, PERHAPS_POUNDS);
        let asked = self.odd(model, NEAR_POUNDS);
        let is_in_pounds =
            |one: &NeedsAnswer| matches!(one, NeedsAnswer::Mass { slip: MassSlip::Pounds, .. });
        loosely.into_iter().filter(|one| is_in_pounds(one) && !asked.contains(one)).collect()
    }

    fn odd(&self, model: &Model, near_pounds: f64) -> Vec<NeedsAnswer> {
        let said = [
            (Input::TargetMass, self.target_mass_kg),
            (Input::ContactsMass, self.contacts_mass_kg),
            (Input::Mass, self.model_kg),
        ];
        if said.iter().all(|(_, kg)| kg.is_none()) {
            return Vec::new();
        }
        let noted_kg = model.note.as_ref().and_then(|note| note.contacts_mass_kg);
        let bodies_kg = self.bodies_kg(model);
        let unit_is_known = self
            .target_mass_kg
            .zip(bodies_kg)
            .is_some_and(|(target_mass_kg, bodies)| same_mass(target_mass_kg, bodies));
        let asks = |(input, kg): (Input, Option<f64>)| {
            let kg = kg.filter(|&kg| !noted_kg.is_some_and(|noted| same_mass(kg, noted)))?;
            let asks = match self.beside.get(&input) {
                Some(&beside) => among(input, kg, bodies_kg, beside)?,
                None => within(input, kg, bodies_kg, near_pounds)?,
            };
            let explained = unit_is_known && input == Input::ContactsMass && asks.is_about_pounds();
            (!explained).then_some(asks)
        };
        said.into_iter().filter_map(asks).collect()
    }
}
