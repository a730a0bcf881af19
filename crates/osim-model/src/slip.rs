//! Masses that look like slips: in another unit.

use osim_messages::Input;

use crate::fault::{MassSlip, NeedsAnswer};
use crate::mass::{MassRequest, same_mass};
use crate::model::Model;

/// How near to a factor between units a ratio of masses counts as that factor.
const NEAR: f64 = 0.15;
/// Pounds in a kilogram.
const POUNDS: f64 = 2.2046;
/// Lighter than any animal that contacts are made for, kg: 1 mg.
const LIGHTEST_KG: f64 = 1e-6;
/// Heavier than any: 200 t, kg.
const HEAVIEST_KG: f64 = 200e3;
/// From this many times the bodies' mass on, a target looks like grams: 1000 times, for a body within a factor of 5.
const GRAMS_OF_A_TARGET: std::ops::RangeInclusive<f64> = 200.0..=5000.0;

/// Whether `kg`, which the caller gave as `input`, looks like a slip for a model whose bodies weigh `bodies_kg` together.
#[must_use]
pub fn mass_slip(input: Input, kg: f64, bodies_kg: Option<f64>) -> Option<NeedsAnswer> {
    // What the bodies weigh is the right unit.
    if input == Input::TargetMass && bodies_kg.is_some_and(|bodies| same_mass(kg, bodies)) {
        return None;
    }
    let grams_of_target = input == Input::TargetMass
        && bodies_kg.is_some_and(|bodies| GRAMS_OF_A_TARGET.contains(&(kg / bodies)));
    let near = |factor: f64| bodies_kg.is_some_and(|bodies| (kg / bodies / factor - 1.0).abs() <= NEAR);
    let slip = match () {
        () if near(1000.0) || grams_of_target => MassSlip::Grams,
        () if near(1.0 / 1000.0) => MassSlip::Tonnes,
        () if near(POUNDS) => MassSlip::Pounds,
        () if near(1.0 / POUNDS) => MassSlip::BodiesInPounds,
        () if !(LIGHTEST_KG..=HEAVIEST_KG).contains(&kg) => MassSlip::NoAnimal,
        () => return None,
    };
    Some(NeedsAnswer::Mass { input, kg, bodies_kg, slip })
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
            let asks = mass_slip(input, kg, bodies_kg)?;
            let explained = unit_is_known && input == Input::ContactsMass && asks.is_about_pounds();
            (!explained).then_some(asks)
        };
        said.into_iter().filter_map(asks).collect()
    }
}
