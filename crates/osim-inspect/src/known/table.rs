//! The table of known contacts, `contacts.json`: published numbers, and which findings are their published state.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use osim_model::{FindingCode, Severity};
use serde::Deserialize;

/// A published contact.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Entry {
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

/// Spheres of a limb that have one contact.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PublishedContact {
    /// How many on a limb.
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
    Warn,
    Info,
}

impl Entry {
    /// What the body weighs that carries them as published, kg.
    pub(super) fn body_kg(&self) -> f64 {
        self.body_kg.unwrap_or(self.made_for_kg)
    }

    /// Spheres of a limb.
    pub(super) fn spheres(&self) -> usize {
        self.contacts.iter().map(|contact| contact.spheres).sum()
    }

    /// How bad a finding is with these contacts, if it is not what the rule says.
    pub(super) fn severity(&self, code: FindingCode) -> Option<Severity> {
        self.severity.get(code.as_str()).map(|level| match level {
            Level::Error => Severity::Error,
            Level::Warn => Severity::Warn,
            Level::Info => Severity::Info,
        })
    }
}

/// Every known contact.
pub(super) fn entries() -> &'static [Entry] {
    static ENTRIES: OnceLock<Vec<Entry>> = OnceLock::new();
    // A test reads the table strictly; a program that could not would know none.
    ENTRIES.get_or_init(|| serde_json::from_str(include_str!("contacts.json")).unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn the_table_is_read_whole_and_names_codes_that_exist() {
        let entries: Vec<Entry> = serde_json::from_str(include_str!("contacts.json")).unwrap();
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
