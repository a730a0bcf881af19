//! The contacts of a model, compared with those of the table.

use contact_scaling::EQUAL_SURFACES;
use osim_model::{FindingCode, ForceId, LoadedSphere, Model, Property, Severity, loaded_spheres};
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::Serialize;

use super::table::{Entry, PublishedContact, entries};

/// Values that differ by no more than this, relatively, are the same.
const SAME: f64 = 1e-6;

/// Contacts that were recognised: from [`KnownContacts::find`].
///
/// ```
/// use osim_inspect::KnownContacts;
/// use osim_model::{Model, Selection};
///
/// # let text = include_str!("../../../osim-model/tests/data/one_foot.osim");
/// let model = Model::parse(text)?;
/// let selected = Selection::default().apply(&model)?;
/// // One sphere of 30 mm with 1 MPa under 10 kg is nobody's published contact.
/// assert_eq!(KnownContacts::find(&model, &selected.forces, Some(1.0), Some(10.0)), None);
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
#[non_exhaustive]
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
    #[must_use]
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
    #[must_use]
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

/// An entry at a mass.
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
