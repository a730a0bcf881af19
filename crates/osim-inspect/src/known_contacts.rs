//! Recognises published contacts by their dimensionless values.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use contact_scaling::SURFACE_OVER_COMPOSITE_MODULUS;
use osim_model::{
    Finding, FindingCode, ForceId, LoadedSphere, Model, Property, Severity, are_equal_masses, loaded_spheres,
};
use serde::{Deserialize, Serialize};

/// Two values of contacts are equal if their relative difference is at most this.
const EXACT_TOLERANCE: f64 = 1e-6;
/// Two values of contacts are similar, and give the same findings, if their relative difference is at most this. A radius that differs by
/// 2 % changes other values by up to 6 %.
const SIMILAR_TOLERANCE: f64 = 0.07;
/// Radii, and the numbers on which a finding depends, are near those of the published body if their relative differences are at most this.
const NEAR_TOLERANCE: f64 = 0.25;

/// Published contacts that a model has: from [`KnownContacts::find`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct KnownContacts {
    /// Name in the table of known contacts, for example `falisse2022`.
    pub name: &'static str,
    /// How people cite the publication: `Falisse et al. (2022)`.
    pub title: &'static str,
    /// Where the contacts were published.
    pub source: &'static str,
    /// The mass that these contacts are made for, kg.
    pub made_for_kg: f64,
}

impl KnownContacts {
    fn new(entry: &'static KnownContactsEntry, made_for_kg: f64) -> Self {
        Self { name: entry.name, title: entry.title, source: entry.source, made_for_kg }
    }

    /// Recognises the contacts of `forces`, if `count` of their spheres share the weight under a body of `mass_kg`.
    ///
    /// Known contacts have the dimensionless values of an entry of the table at that mass, whatever their radii; or at any mass with
    /// radii in proportion to it (R ∝ M^(1/3)). Every value is compared, with a relative tolerance of 1e-6. Gravity is assumed to be equal.
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
        let contacts = contacts_of_sets(model, forces)?;
        Self::find_similar_entry(&contacts, count, mass_kg, entries(), &ComparedNumbers::EXACT)
    }

    /// The severity that the table gives `finding` about `forces`, if their contacts are not known but the numbers on which the finding
    /// depends are the published ones. A fault that was published is only a remark, whatever the other numbers are, and whatever the
    /// contacts are of spheres that the finding is not about.
    pub(crate) fn severity_of_similar(
        model: &Model,
        forces: &[ForceId],
        count: Option<f64>,
        mass_kg: Option<f64>,
        finding: &Finding,
    ) -> Option<Severity> {
        let code = finding.code();
        let likeness = ComparedNumbers::for_finding(code)?;
        let with_severity = entries().iter().filter(|entry| entry.severity(code).is_some());
        let contacts = contacts_of_sets(model, forces)?;
        let similar = Self::find_similar_entry(&contacts, count, mass_kg, with_severity.clone(), &likeness);
        similar.and_then(|known| known.severity(code, mass_kg)).or_else(|| {
            let near = ComparedNumbers { tolerance: NEAR_TOLERANCE, ..likeness };
            let mass_kg = mass_kg?;
            let is_near = |entry: &&KnownContactsEntry| entry.is_near(&contacts, finding, mass_kg, &near);
            with_severity.clone().find(is_near)?.severity(code)
        })
    }

    /// The entry of the table whose contacts these are, compared as `likeness` says, and the mass that they are made for.
    fn find_similar_entry(
        contacts: &[ContactOfSet],
        count: Option<f64>,
        mass_kg: Option<f64>,
        entries: impl IntoIterator<Item = &'static KnownContactsEntry> + Clone,
        likeness: &ComparedNumbers,
    ) -> Option<Self> {
        let fits = |entry: &KnownContactsEntry, mass: f64, isometric: bool| {
            entry.matches_contacts(contacts, count, (mass, isometric), likeness)
        };
        let under_body = |entry: &'static KnownContactsEntry| {
            let mass = mass_kg?;
            // A sensor makes no other body of the published one.
            let published_mass = are_equal_masses(mass, entry.body_kg()).then_some(entry.body_kg());
            let mass =
                [Some(mass), published_mass].into_iter().flatten().find(|&mass| fits(entry, mass, false))?;
            Some(Self::new(entry, entry.made_for_kg * (mass / entry.body_kg())))
        };
        let at_any_mass = |entry: &'static KnownContactsEntry| {
            // Contacts that were published under a body of another mass are only recognised under that body.
            let is_for_its_body = entry.made_for_kg == entry.body_kg();
            let radius_m = contacts.first()?.radius_m;
            let masses = entry.contacts.iter().map(|contact| {
                // For unscaled contacts the mass is that of the entry, to the last bit.
                let ratio = radius_m / contact.radius_m;
                let is_unscaled = likeness.is_close(ratio, 1.0);
                if is_unscaled { entry.made_for_kg } else { entry.made_for_kg * ratio * ratio * ratio }
            });
            let made_for_kg = masses.filter(|_| is_for_its_body).find(|&mass| fits(entry, mass, true));
            made_for_kg.map(|made_for_kg| Self::new(entry, made_for_kg))
        };
        entries.clone().into_iter().find_map(under_body).or_else(|| entries.into_iter().find_map(at_any_mass))
    }

    /// Whether the contacts are made for exactly this mass, kg.
    pub(crate) fn is_made_for(&self, mass_kg: f64) -> bool {
        ComparedNumbers::EXACT.is_close(self.made_for_kg, mass_kg)
    }

    /// Whether the contacts were published under a body of another mass than the mass that they are made for.
    pub fn is_published_under_other_body(&self) -> bool {
        entries().iter().any(|entry| entry.name == self.name && entry.made_for_kg != entry.body_kg())
    }

    /// The severity that the table gives a finding about these contacts under a body of `mass_kg`, if it gives one. A fault that was
    /// published is only a remark. How deep spheres sink in was published under one mass; under less they sink in less.
    pub fn severity(&self, code: FindingCode, mass_kg: Option<f64>) -> Option<Severity> {
        let entry = entries().iter().find(|entry| entry.name == self.name)?;
        let body_kg = self.made_for_kg * (entry.body_kg() / entry.made_for_kg);
        let is_at_most = |kg: f64| kg <= body_kg || are_equal_masses(kg, body_kg);
        let follows_mass = matches!(code, FindingCode::SunkIn | FindingCode::BeyondHertzAtTwo);
        entry.severity(code).filter(|_| !follows_mass || mass_kg.is_none_or(is_at_most))
    }
}

/// The contact of one parameter set of a model, and the number of spheres with this contact.
struct ContactOfSet {
    spheres: usize,
    /// Names of the spheres.
    names: Vec<String>,
    /// Root mean square of the radii of the spheres.
    radius_m: f64,
    composite_modulus: f64,
    dissipation: f64,
    smoothing: Option<[f64; 3]>,
    friction: [f64; 3],
    transition_velocity: f64,
}

/// The contact of each parameter set of `forces`; `None` if a value cannot be read, or there are no spheres.
fn contacts_of_sets(model: &Model, forces: &[ForceId]) -> Option<Vec<ContactOfSet>> {
    let loaded = loaded_spheres(model, forces).ok().filter(|loaded| !loaded.is_empty())?;
    // The spheres of a set follow each other.
    let sets = loaded.chunk_by(|a, b| (a.force, a.set) == (b.force, b.set));
    sets.map(|spheres| contact_of_set(model, spheres)).collect()
}

/// The contact of the `spheres` of one parameter set; their radii count with the mean of R².
fn contact_of_set(model: &Model, spheres: &[LoadedSphere]) -> Option<ContactOfSet> {
    let LoadedSphere { contact, force, set, .. } = spheres.first()?;
    let force = model.force(*force)?;
    let value = |property| force.value(*set, property).map(|value| value.number);
    let count = spheres.len() as f64;
    let squares: f64 = spheres.iter().map(|sphere| sphere.radius_m * sphere.radius_m).sum();
    let names = spheres.iter().filter_map(|sphere| Some(model.sphere(sphere.sphere)?.name.clone()));
    Some(ContactOfSet {
        spheres: spheres.len(),
        names: names.collect(),
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

/// The numbers of a contact that are compared with published ones, and the tolerance.
#[derive(Default)]
struct ComparedNumbers {
    tolerance: f64,
    stiffness: bool,
    dissipation: bool,
    /// Whether `constant_contact_force`, `hertz_smoothing` and `hunt_crossley_smoothing` are compared.
    smoothing: [bool; 3],
    friction: bool,
}

impl ComparedNumbers {
    /// All numbers of a contact, with the tolerance for equal contacts.
    const EXACT: Self = Self {
        tolerance: EXACT_TOLERANCE,
        stiffness: true,
        dissipation: true,
        smoothing: [true; 3],
        friction: true,
    };

    /// The numbers of a model that must be near the published ones, so that its finding was published with them: the numbers on which the
    /// finding depends, besides the weight. `None` if it also depends on anything else.
    fn for_finding(code: FindingCode) -> Option<Self> {
        let radii = Self { tolerance: SIMILAR_TOLERANCE, ..Self::default() };
        Some(match code {
            FindingCode::SunkIn | FindingCode::BeyondHertz => Self { stiffness: true, ..radii },
            FindingCode::BeyondHuntCrossley => Self { dissipation: true, ..radii },
            FindingCode::LargeConstantIndentation => Self { smoothing: [true, false, false], ..radii },
            FindingCode::WideTransition => Self { smoothing: [false, true, false], ..radii },
            FindingCode::ForceBeforeContact => {
                Self { stiffness: true, smoothing: [true, true, false], ..radii }
            }
            FindingCode::DeadDerivativeSmoothing => radii,
            _ => return None,
        })
    }

    /// Whether a value is the expected one within the tolerance.
    fn is_close(&self, value: f64, expected: f64) -> bool {
        (value - expected).abs() <= self.tolerance * expected.abs()
    }
}

impl KnownContactsEntry {
    /// The mass of the published body that carries the contacts, kg.
    fn body_kg(&self) -> f64 {
        self.body_kg.unwrap_or(self.made_for_kg)
    }

    /// The number of spheres on one limb.
    fn spheres(&self) -> usize {
        self.contacts.iter().map(|contact| contact.spheres).sum()
    }

    /// The severity that a finding has with these contacts, if it differs from the severity of its rule.
    fn severity(&self, code: FindingCode) -> Option<Severity> {
        let level = *self.severity.get(code.as_str())?;
        Severity::ALL.iter().copied().find(|severity| severity.as_str() == level)
    }

    /// Whether `contacts` are the contacts of this entry, scaled to `mass` (kg), if `count` of their spheres share the weight. If they are
    /// `isometric`, the radii follow the mass, too.
    fn matches_contacts(
        &self,
        contacts: &[ContactOfSet],
        count: Option<f64>,
        (mass, isometric): (f64, bool),
        likeness: &ComparedNumbers,
    ) -> bool {
        let mass_ratio = mass / if isometric { self.made_for_kg } else { self.body_kg() };
        let (per_limb, total) =
            (self.spheres(), contacts.iter().map(|contact| contact.spheres).sum::<usize>());
        let published = &self.contacts;
        let as_published = per_limb as f64;
        // If limbs are not known, one or two limbs with the published number of spheres are assumed.
        let is_plausible = count.is_none() && (total == per_limb || total == 2 * per_limb);
        let count = match count {
            Some(count) if published.len() == 1 || count == as_published => count,
            None if is_plausible => as_published,
            _ => return false,
        };
        let share = count / as_published;
        published.iter().all(|published| {
            let alike = contacts.iter().filter(|contact| {
                let radius = contact.radius_m / published.radius_m;
                self.matches_values(contact, published, [mass_ratio, share, radius], likeness)
                    && (!isometric || likeness.is_close(radius * radius * radius, mass_ratio))
            });
            alike.map(|contact| contact.spheres).sum::<usize>() * per_limb == published.spheres * total
        })
    }

    /// Whether each of `contacts` is near a contact of this entry, and each contact of the entry near one of them; or whether those that
    /// `finding` is about are published ones. The body has the published mass. No number follows a radius that somebody has changed.
    fn is_near(
        &self,
        contacts: &[ContactOfSet],
        finding: &Finding,
        mass_kg: f64,
        likeness: &ComparedNumbers,
    ) -> bool {
        let is_like = |contact: &ContactOfSet, published: &PublishedContact, likeness: &ComparedNumbers| {
            likeness.is_close(contact.radius_m, published.radius_m)
                && self.matches_values(contact, published, [1.0; 3], likeness)
        };
        let is_near = |contact| self.contacts.iter().any(|published| is_like(contact, published, likeness));
        let has_near = |published| contacts.iter().any(|contact| is_like(contact, published, likeness));
        let total: usize = contacts.iter().map(|contact| contact.spheres).sum();
        // No more than were published: a changed contact can be equal to another one.
        let is_published = |published: &PublishedContact| {
            let equal = contacts.iter().filter(|one| is_like(one, published, &ComparedNumbers::EXACT));
            equal.map(|one| one.spheres).sum::<usize>() * self.spheres() <= published.spheres * total
        };
        let is_unchanged = |contact: &ContactOfSet| {
            let mut equal = self.contacts.iter();
            equal.any(|one| is_like(contact, one, &ComparedNumbers::EXACT) && is_published(one))
        };
        let is_about =
            |contact: &&ContactOfSet| contact.names.iter().any(|name| finding.spheres.contains(name));
        let mut in_question = contacts.iter().filter(is_about).peekable();
        let are_unchanged = in_question.peek().is_some() && in_question.all(is_unchanged);
        let are_near = contacts.iter().all(is_near) && self.contacts.iter().all(has_near);
        // Spheres share the load: how deep one is depends on the others.
        let shares_load = matches!(finding.code(), FindingCode::SunkIn | FindingCode::BeyondHertz);
        are_equal_masses(mass_kg, self.body_kg()) && ((!shares_load && are_unchanged) || are_near)
    }

    /// Whether `contact` has the published values, scaled to `mass` times the published mass, `share` times as many spheres and `radius`
    /// times the published radius.
    fn matches_values(
        &self,
        contact: &ContactOfSet,
        published: &PublishedContact,
        [mass, share, radius]: [f64; 3],
        likeness: &ComparedNumbers,
    ) -> bool {
        let close = |value, expected| likeness.is_close(value, expected);
        // (10), (14), (C.2), (C.5), (C.10), and (8).
        let modulus = published.stiffness / SURFACE_OVER_COMPOSITE_MODULUS * mass / (radius * radius * share);
        let is_scaled = |values: [f64; 3], [c, d, v]: [f64; 3]| {
            let expected = [c * radius * radius, d / radius, v / radius.sqrt()];
            let mut compared = values.into_iter().zip(expected).zip(likeness.smoothing);
            compared.all(|((value, expected), is_compared)| !is_compared || close(value, expected))
        };
        let has_smoothing = match (contact.smoothing, published.smoothing) {
            (Some(smoothing), Some(published)) => is_scaled(smoothing, published),
            (None, _) => true,
            (Some(_), None) => false,
        };
        // The coefficients of friction do not depend on size; the two speeds may stay, or follow the radius.
        let [r#static, dynamic, viscous] = self.friction;
        let has_speeds = [1.0, radius.sqrt()].into_iter().any(|speed| {
            close(contact.friction[2], viscous / speed)
                && close(contact.transition_velocity, self.transition_velocity * speed)
        });
        let has_friction =
            close(contact.friction[0], r#static) && close(contact.friction[1], dynamic) && has_speeds;
        (!likeness.stiffness || close(contact.composite_modulus, modulus))
            && (!likeness.dissipation || close(contact.dissipation, published.dissipation / radius.sqrt()))
            && has_smoothing
            && (!likeness.friction || has_friction)
    }
}

/// An entry of the table of known contacts, `known_contacts.json`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct KnownContactsEntry {
    pub name: &'static str,
    /// The name of the contacts in messages, such as `Falisse et al. (2022)`.
    pub title: &'static str,
    /// Where the contacts were published, and which findings about them are accepted.
    pub source: &'static str,
    /// The mass that the contacts were made for, kg.
    pub made_for_kg: f64,
    /// The mass of the published body that carries them, if it is another one.
    body_kg: Option<f64>,
    /// Coefficients of static, dynamic and viscous friction.
    pub friction: [f64; 3],
    pub transition_velocity: f64,
    /// The published contacts of one limb; equal contacts are one entry.
    pub contacts: Vec<PublishedContact>,
    severity: BTreeMap<&'static str, &'static str>,
}

/// The published parameters of one contact, in an entry of the table of known contacts.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct PublishedContact {
    pub spheres: usize,
    /// The root of the mean square, if spheres of several radii share one parameter set.
    pub radius_m: f64,
    /// OpenSim's `stiffness` of both surfaces.
    pub stiffness: f64,
    pub dissipation: f64,
    /// `constant_contact_force`, `hertz_smoothing` and `hunt_crossley_smoothing`, if the class has them.
    pub smoothing: Option<[f64; 3]>,
}

/// All entries of the table of known contacts.
fn entries() -> &'static [KnownContactsEntry] {
    static ENTRIES: OnceLock<Vec<KnownContactsEntry>> = OnceLock::new();
    // A test checks that the table can be read.
    ENTRIES.get_or_init(|| serde_json::from_str(include_str!("known_contacts.json")).unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn the_table_is_complete_and_its_codes_exist() {
        let entries: Vec<KnownContactsEntry> =
            serde_json::from_str(include_str!("known_contacts.json")).unwrap();
        assert!(!entries.is_empty());
        let names: BTreeSet<&str> = entries.iter().map(|entry| entry.name).collect();
        assert_eq!(names.len(), entries.len());
        let codes: Vec<&str> = FindingCode::ALL.iter().map(|code| code.as_str()).collect();
        for entry in &entries {
            assert!(!entry.source.is_empty() && entry.made_for_kg > 0.0 && entry.spheres() > 0);
            assert!(entry.severity.keys().all(|code| codes.contains(code)), "{}", entry.name);
            let levels: Vec<&str> = Severity::ALL.iter().map(|severity| severity.as_str()).collect();
            assert!(entry.severity.values().all(|level| levels.contains(level)), "{}", entry.name);
        }
    }

    /// Moco's front spheres are in up to their centres under 62 kg. Ten times the mass sinks in 10^(2/3) times as deep by (3).
    #[test]
    fn a_published_depth_is_a_remark_under_the_published_mass_or_less() {
        let entry = entries().iter().find(|entry| entry.name == "moco-2d-gait").unwrap();
        let known = KnownContacts::new(entry, 62.0);
        for (mass_kg, expected) in
            [(60.0, Some(Severity::Remark)), (62.5, Some(Severity::Remark)), (620.0, None)]
        {
            assert_eq!(known.severity(FindingCode::SunkIn, Some(mass_kg)), expected, "{mass_kg} kg");
            assert_eq!(known.severity(FindingCode::BeyondHertz, Some(mass_kg)), Some(Severity::Remark));
        }
        // Scaled to this mass, they sink in as deep as published.
        let scaled = KnownContacts::new(entry, 620.0);
        assert_eq!(scaled.severity(FindingCode::SunkIn, Some(620.0)), Some(Severity::Remark));
    }

    /// osim-rl's toes of 25 mm carry a third of 75 kg each: 1.41 R by (1).
    #[test]
    fn the_models_of_osim_rl_are_as_deep_as_published() {
        for (name, mass_kg) in [("osim-rl-2017", 75.1646), ("osim-rl-prosthesis", 72.17025)] {
            let entry = entries().iter().find(|entry| entry.name == name).unwrap();
            let known = KnownContacts::new(entry, mass_kg);
            assert_eq!(known.severity(FindingCode::SunkIn, Some(mass_kg)), Some(Severity::Remark), "{name}");
            assert_eq!(known.severity(FindingCode::SunkIn, Some(2.0 * mass_kg)), None, "{name}");
        }
    }

    #[test]
    fn a_published_finding_stays_a_remark_near_the_published_numbers() {
        let entry = entries().iter().find(|entry| entry.name == "dhondt2024").unwrap();
        // About the first sphere, a heel on the right.
        let finding = |code| {
            let rule = crate::rules::rules().find(|rule| rule.code == code).unwrap();
            Finding::new(rule, "").with_spheres(vec!["0".to_owned()])
        };
        let is_near = |finding: &Finding, mass_kg, edit: fn(&mut [ContactOfSet])| {
            let both_sides = entry.contacts.iter().chain(&entry.contacts).enumerate();
            let published = both_sides.map(|(index, contact)| ContactOfSet {
                spheres: contact.spheres,
                names: vec![index.to_string()],
                radius_m: contact.radius_m,
                composite_modulus: contact.stiffness / SURFACE_OVER_COMPOSITE_MODULUS,
                dissipation: contact.dissipation,
                smoothing: contact.smoothing,
                friction: entry.friction,
                transition_velocity: entry.transition_velocity,
            });
            let mut contacts: Vec<ContactOfSet> = published.collect();
            edit(&mut contacts);
            let likeness = ComparedNumbers::for_finding(finding.code()).unwrap();
            let near = ComparedNumbers { tolerance: NEAR_TOLERANCE, ..likeness };
            entry.is_near(&contacts, finding, mass_kg, &near)
        };
        let constant = &finding(FindingCode::LargeConstantIndentation);
        let before = &finding(FindingCode::ForceBeforeContact);
        assert!(is_near(constant, 62.0, |all| all[0].radius_m *= 1.1));
        assert!(is_near(constant, 62.0, |all| all[0].friction[0] = 0.2));
        assert!(is_near(before, 62.0, |all| all[0].composite_modulus *= 1.2));
        // Half the radius of both heels, ten times the stiffness or the mass is something else.
        let halve_heels = |all: &mut [ContactOfSet]| {
            let first_left = all.len() / 2;
            [0, first_left].into_iter().for_each(|heel| all[heel].radius_m *= 0.5);
        };
        assert!(!is_near(constant, 62.0, halve_heels));
        assert!(!is_near(before, 62.0, |all| all[0].composite_modulus *= 10.0));
        assert!(!is_near(constant, 620.0, |_| ()));
        // Another sphere does not change what this one was published with.
        assert!(is_near(constant, 62.0, |all| all[7].radius_m *= 4.0));
    }

    #[test]
    fn falisse2022_has_the_numbers_of_the_preset() {
        let preset = contact_scaling::falisse2022();
        let entry = entries().iter().find(|entry| entry.name == preset.name).unwrap();
        let contact = &entry.contacts[0];
        assert_eq!((entry.made_for_kg, entry.spheres()), (preset.scale.mass_kg(), 6));
        assert_eq!(contact.radius_m, preset.scale.radius_m());
        assert_eq!(contact.stiffness, preset.contact.plane_strain_modulus());
        assert_eq!(contact.dissipation, preset.contact.dissipation());
    }
}
