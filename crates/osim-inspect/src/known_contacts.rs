//! Contacts that are known again: published ones, by their dimensionless values, and those of the model that another one was made from.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use contact_scaling::EQUAL_SURFACES;
use foldhash::HashMap;
use osim_model::messages::shown;
use osim_model::{
    FindingCode, Force, ForceId, LoadedSphere, Model, Property, Severity, Side, Value, loaded_spheres,
};
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::sides::BothSides;

/// Values that differ by no more than this, relatively, are the same.
const SAME: f64 = 1e-6;

/// Contacts that were recognised: from [`KnownContacts::find`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
pub struct KnownContacts {
    /// Name in the table of known contacts, such as `falisse2022`.
    pub name: &'static str,
    /// As people cite it: `Falisse et al. (2022)`.
    pub title: &'static str,
    /// Where it was published.
    pub source: &'static str,
    /// The mass that these contacts are made for, kg.
    pub made_for_kg: f64,
}

impl KnownContacts {
    fn new(entry: &'static Entry, made_for_kg: f64) -> Self {
        Self { name: &entry.name, title: &entry.title, source: &entry.source, made_for_kg }
    }

    /// The contacts of `forces`, if `count` of their spheres share the weight, under a body of `mass_kg`.
    ///
    /// Known contacts have the dimensionless values of an entry at that mass, whatever their radii; or at any mass with
    /// radii that follow it (R ∝ M^(1/3)). Both say every value, so one that differs by more than 1e-6 is seen. Gravity is
    /// taken to be the same.
    ///
    /// ```
    /// use osim_inspect::KnownContacts;
    /// use osim_model::{Model, Selection};
    ///
    /// # let text = include_str!("../../osim-model/tests/data/one_foot.osim");
    /// let model = Model::parse(text)?;
    /// let selected = Selection::default().apply(&model)?;
    /// // One sphere of 30 mm with 1 MPa under 10 kg is nobody's published contact.
    /// assert_eq!(KnownContacts::find(&model, &selected.forces, Some(1.0), Some(10.0)), None);
    /// # Ok::<(), osim_model::Fault>(())
    /// ```
    pub fn find(model: &Model, forces: &[ForceId], count: Option<f64>, mass_kg: Option<f64>) -> Option<Self> {
        let held = held_contacts(model, forces)?;
        let fits =
            |entry: &Entry, mass: f64, isometric: bool| Fit { entry, mass, isometric }.admits(&held, count);
        let under_body = |entry: &'static Entry| {
            let mass = mass_kg?;
            let made_for_kg = entry.made_for_kg * (mass / entry.body_kg());
            fits(entry, mass, false).then(|| Self::new(entry, made_for_kg))
        };
        let at_any_mass = |entry: &'static Entry| {
            // What is published under a body that it was not made for is known under that body alone.
            let own = entry.made_for_kg == entry.body_kg();
            let radius_m = held.first()?.radius_m;
            let masses = entry.contacts.iter().map(|contact| {
                // Unscaled contacts are those of the entry's own mass, to the last bit.
                let ratio = radius_m / contact.radius_m;
                if close(ratio, 1.0) { entry.made_for_kg } else { entry.made_for_kg * ratio * ratio * ratio }
            });
            let found = masses.filter(|_| own).find(|&mass| fits(entry, mass, true));
            found.map(|made_for_kg| Self::new(entry, made_for_kg))
        };
        entries().iter().find_map(under_body).or_else(|| entries().iter().find_map(at_any_mass))
    }

    /// How bad a finding is with these contacts, where the table says it: what was published so is a remark.
    pub fn severity(&self, code: FindingCode) -> Option<Severity> {
        entries().iter().find(|entry| entry.name == self.name)?.severity(code)
    }
}

/// The contact of one parameter set, and how many spheres have it.
struct HeldContact {
    spheres: usize,
    /// The root of the mean square.
    radius_m: f64,
    composite_modulus: f64,
    dissipation: f64,
    smoothing: Option<[f64; 3]>,
    friction: [f64; 3],
    transition_velocity: f64,
}

/// `None` where a value cannot be read, or there are no spheres.
fn held_contacts(model: &Model, forces: &[ForceId]) -> Option<Vec<HeldContact>> {
    let loaded = loaded_spheres(model, forces).ok().filter(|loaded| !loaded.is_empty())?;
    // The spheres of a set stand together.
    let sets = loaded.chunk_by(|a, b| (a.force, a.set) == (b.force, b.set));
    sets.map(|spheres| held_contact(model, spheres)).collect()
}

fn held_contact(model: &Model, of_set: &[LoadedSphere]) -> Option<HeldContact> {
    let LoadedSphere { contact, force, set, .. } = of_set.first()?;
    let force = model.force(*force)?;
    let value = |property| force.value(*set, property).map(|value| value.number);
    #[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
    let count = of_set.len() as f64;
    let squares: f64 = of_set.iter().map(|sphere| sphere.radius_m * sphere.radius_m).sum();
    Some(HeldContact {
        spheres: of_set.len(),
        radius_m: (squares / count).sqrt(),
        composite_modulus: contact.composite_modulus(),
        dissipation: contact.dissipation(),
        smoothing: contact.smoothing().map(|smoothing| {
            [smoothing.constant_contact_force, smoothing.hertz_smoothing, smoothing.hunt_crossley_smoothing]
        }),
        friction: [
            value(Property::StaticFriction)?,
            value(Property::DynamicFriction)?,
            value(Property::ViscousFriction)?,
        ],
        transition_velocity: force.transition_velocity.number,
    })
}

struct Fit<'e> {
    entry: &'e Entry,
    mass: f64,
    /// Radii follow the mass, too.
    isometric: bool,
}

impl Fit<'_> {
    fn admits(&self, held: &[HeldContact], count: Option<f64>) -> bool {
        let (own, total) = (self.entry.spheres(), held.iter().map(|contact| contact.spheres).sum::<usize>());
        let published = &self.entry.contacts;
        #[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
        let as_published = own as f64;
        // Where limbs are not known, one or two limbs of the published count are.
        let unknown = count.is_none() && (total == own || total == 2 * own);
        let count = match count {
            Some(count) if published.len() == 1 || count == as_published => count,
            None if unknown => as_published,
            _ => return false,
        };
        let share = count / as_published;
        published.iter().all(|contact| {
            let alike = held.iter().filter(|held| self.is(held, contact, share));
            alike.map(|held| held.spheres).sum::<usize>() * own == contact.spheres * total
        })
    }

    /// Whether `held` is `contact` where `share` times as many spheres carry the weight.
    fn is(&self, held: &HeldContact, contact: &PublishedContact, share: f64) -> bool {
        let mass = self.mass / if self.isometric { self.entry.made_for_kg } else { self.entry.body_kg() };
        let radius = held.radius_m / contact.radius_m;
        // (10), (14), (C.2), (C.5), (C.10), and (8).
        let modulus = contact.stiffness / EQUAL_SURFACES * mass / (radius * radius * share);
        let smoothed = |[cf, bd, bv]: [f64; 3], [c, d, v]: [f64; 3]| {
            close(cf, c * radius * radius) && close(bd, d / radius) && close(bv, v / radius.sqrt())
        };
        let smoothing = match (held.smoothing, contact.smoothing) {
            (Some(held), Some(published)) => smoothed(held, published),
            (None, _) => true,
            (Some(_), None) => false,
        };
        close(held.composite_modulus, modulus)
            && close(held.dissipation, contact.dissipation / radius.sqrt())
            && smoothing
            && self.has_friction(held, radius)
            && (!self.isometric || close(radius * radius * radius, mass))
    }

    /// Coefficients stay; the two speeds stay, or follow the radius where that was asked for.
    fn has_friction(&self, held: &HeldContact, radius: f64) -> bool {
        let [r#static, dynamic, viscous] = self.entry.friction;
        let velocity = self.entry.transition_velocity;
        let speeds = [1.0, radius.sqrt()].into_iter().any(|speed| {
            close(held.friction[2], viscous / speed) && close(held.transition_velocity, velocity * speed)
        });
        close(held.friction[0], r#static) && close(held.friction[1], dynamic) && speeds
    }
}

fn close(value: f64, expected: f64) -> bool {
    (value - expected).abs() <= SAME * expected.abs()
}

// The table of known contacts, `known_contacts.json`: published numbers, and which findings are their published state.

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    pub name: String,
    /// As people cite it.
    pub title: String,
    /// Where it was published, and what is accepted of it.
    pub source: String,
    /// The mass that the contacts were made for, kg.
    pub made_for_kg: f64,
    /// The mass of the body that carries them as published, if it is another one.
    body_kg: Option<f64>,
    /// Static, dynamic and viscous.
    pub friction: [f64; 3],
    pub transition_velocity: f64,
    /// The different ones on a limb.
    pub contacts: Vec<PublishedContact>,
    severity: BTreeMap<String, Level>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct PublishedContact {
    pub spheres: usize,
    /// Of spheres that share one parameter set the root of the mean square.
    pub radius_m: f64,
    /// Of both surfaces, as OpenSim spells it.
    pub stiffness: f64,
    pub dissipation: f64,
    /// `constant_contact_force`, `hertz_smoothing` and `hunt_crossley_smoothing`, where the class has them.
    pub smoothing: Option<[f64; 3]>,
}

#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Level {
    Error,
    Warning,
    Remark,
}

impl Entry {
    /// What the body weighs that carries them as published, kg.
    fn body_kg(&self) -> f64 {
        self.body_kg.unwrap_or(self.made_for_kg)
    }

    /// Spheres of a limb.
    fn spheres(&self) -> usize {
        self.contacts.iter().map(|contact| contact.spheres).sum()
    }

    /// How bad a finding is with these contacts, if it is not what the rule says.
    fn severity(&self, code: FindingCode) -> Option<Severity> {
        self.severity.get(code.as_str()).map(|level| match level {
            Level::Error => Severity::Error,
            Level::Warning => Severity::Warning,
            Level::Remark => Severity::Remark,
        })
    }
}

fn entries() -> &'static [Entry] {
    static ENTRIES: OnceLock<Vec<Entry>> = OnceLock::new();
    // A test reads the table strictly; a program that could not would know none.
    ENTRIES.get_or_init(|| serde_json::from_str(include_str!("known_contacts.json")).unwrap_or_default())
}

/// The numbers of a reference's contact forces.
#[derive(Debug, Clone, PartialEq)]
pub struct ReferenceContacts {
    name: String,
    /// Values of the parameter sets, by the name of the force.
    numbers: HashMap<String, Vec<f64>>,
}

impl ReferenceContacts {
    /// Those of `model`; `name` is what messages call it.
    pub fn of(name: &str, model: &Model) -> Self {
        let numbers = model.forces().iter().map(|force| (force.name.clone(), numbers(force))).collect();
        Self { name: name.to_owned(), numbers }
    }

    pub(crate) fn title(&self) -> String {
        shown(&self.name).to_string()
    }

    /// The side whose forces have the numbers of the reference, where those of the other side have others.
    pub(crate) fn side(&self, model: &Model, sides: &BothSides<'_>) -> Option<Side> {
        let is_as_here = |side| {
            let forces = sides.forces_on(side);
            let mut all = forces.iter().filter_map(|&id| model.force(id)).peekable();
            all.peek().is_some() && all.all(|force| self.numbers.get(&force.name) == Some(&numbers(force)))
        };
        match (is_as_here(Side::Right), is_as_here(Side::Left)) {
            (true, false) => Some(Side::Right),
            (false, true) => Some(Side::Left),
            _ => None,
        }
    }
}

fn numbers(force: &Force) -> Vec<f64> {
    force.sets.iter().flat_map(|set| &set.values).map(|value: &Value| value.number).collect()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn the_table_is_read_whole_and_names_codes_that_exist() {
        let entries: Vec<Entry> = serde_json::from_str(include_str!("known_contacts.json")).unwrap();
        assert!(!entries.is_empty());
        let names: BTreeSet<&str> = entries.iter().map(|entry| entry.name.as_str()).collect();
        assert_eq!(names.len(), entries.len());
        let codes: Vec<&str> = FindingCode::ALL.iter().map(|code| code.as_str()).collect();
        for entry in &entries {
            assert!(!entry.source.is_empty() && entry.made_for_kg > 0.0 && entry.spheres() > 0);
            assert!(entry.severity.keys().all(|code| codes.contains(&code.as_str())), "{}", entry.name);
        }
    }

    #[test]
    fn the_preset_is_the_contact_of_its_name() {
        let preset = contact_scaling::falisse2022();
        let entry = entries().iter().find(|entry| entry.name == preset.name).unwrap();
        let contact = &entry.contacts[0];
        assert_eq!((entry.made_for_kg, entry.spheres()), (preset.scale.mass_kg(), 6));
        assert_eq!(contact.radius_m, preset.scale.radius_m());
        assert_eq!(contact.stiffness, preset.contact.plane_strain_modulus());
        assert_eq!(contact.dissipation, preset.contact.dissipation());
    }
}
