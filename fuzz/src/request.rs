//! What is asked of a mutated model: one of many rescalings, chosen by the bytes themselves, so that a run is repeatable.

use osim_model::{DissipationBy, Fault, Mass, MassRequest, Model, Pattern, PropertySet, RadiusRule, Selected, Selection};
use osim_patch::{Plan, Rescale, rescale};

/// Mass that contacts stand for where the model does not say, kg.
const ANY_MASS_KG: f64 = 62.0;

/// One rescaling of one model.
pub struct Request {
    pub selected: Selected,
    pub wanted: Rescale,
}

impl Request {
    /// The rescaling that `bytes` stand for.
    ///
    /// # Errors
    /// No forces to choose, or forces of several animals.
    pub fn of(bytes: &[u8], model: &Model) -> Result<Self, Fault> {
        let mut dice = fnv(bytes);
        let mut roll = |sides: u64| {
            let rolled = dice % sides;
            dice /= sides;
            rolled
        };
        let ratio = [8.0, 1190.0 / 62.0, 0.3, 1e-4, 1.0 / 3.0][roll(5) as usize];
        let radius =
            [RadiusRule::Isometric, RadiusRule::Keep, RadiusRule::Metres(0.0207), RadiusRule::Factor(1.1)];
        let radius = radius[roll(4) as usize];
        let properties = PropertySet::default();
        let properties = if roll(2) == 0 { properties } else { properties.with_friction() };
        let dissipation_by = [DissipationBy::Radius, DissipationBy::Mass][roll(2) as usize];
        let selection =
            Selection { skip_disabled: roll(4) == 0, exclude: Default::default(), select: select(roll(2)) };
        let selected = selection.apply(model)?;
        let contacts_mass = contacts_mass(model);
        let target_mass_kg = contacts_mass.kg * ratio;
        let mut wanted = Rescale::new(target_mass_kg, contacts_mass);
        wanted.radius = radius;
        wanted.properties = properties;
        wanted.dissipation_by = dissipation_by;
        wanted.target_gravity_m_s2 = (roll(8) == 0).then_some(1.62);
        Ok(Self { selected, wanted })
    }

    /// What it would change.
    ///
    /// # Errors
    /// As [`rescale`].
    pub fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        rescale(model, &self.selected, &self.wanted)
    }
}

/// From the file, else any.
fn contacts_mass(model: &Model) -> Mass {
    let told = MassRequest { contacts_mass_kg: Some(ANY_MASS_KG), ..MassRequest::default() };
    let found = MassRequest::default().contacts_mass(model).or_else(|_| told.contacts_mass(model));
    found.expect("62 kg is a mass").0
}

/// No choice, or every force by name: the latter also takes models with several animals.
fn select(every: u64) -> Vec<Pattern> {
    if every == 1 { vec!["*".parse().expect("a pattern")] } else { vec![] }
}

/// FNV-1a.
pub fn fnv(bytes: &[u8]) -> u64 {
    bytes
        .iter()
        .fold(0xcbf2_9ce4_8422_2325, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}
