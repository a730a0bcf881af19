//! What a note records of its contacts so that it can show later which of their properties, or only their names, changed.
//!
//! `spheres 12 0123456789abcdef; forces 12 0123456789abcdef; numbers stiffness=01234567 dissipation=89abcdef`

use std::collections::BTreeMap;

use super::spelling::is_digest;
use crate::model::property::Property;

const SPHERES: &str = "spheres ";
const FORCES: &str = "forces ";
const NUMBERS: &str = "numbers ";
/// Where no force has a number.
const NOTHING: &str = "-";
const PROPERTY_DIGITS: usize = 8;

/// Names of the contacts and digests of their properties. A note that has them has digests of numbers alone; in notes of earlier
/// versions the digests hold the names, too.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NotedParts {
    /// The spheres of contact forces.
    pub spheres: NotedNames,
    /// The contact forces.
    pub forces: NotedNames,
    /// The first 8 digits of the SHA-256 of the values of each property of the forces.
    pub properties: BTreeMap<Property, String>,
}

/// How many there were, and what they were called.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NotedNames {
    /// How many.
    pub count: usize,
    /// The first 16 digits of the SHA-256 of their names.
    pub digest: String,
}

impl NotedParts {
    /// As a note has it.
    pub(super) fn text(&self) -> String {
        let properties =
            self.properties.iter().map(|(property, digest)| format!("{}={digest}", property.name()));
        let properties: Vec<String> = properties.collect();
        let properties = if properties.is_empty() { NOTHING.to_owned() } else { properties.join(" ") };
        let (spheres, forces) = (self.spheres.text(), self.forces.text());
        format!("{SPHERES}{spheres}; {FORCES}{forces}; {NUMBERS}{properties}")
    }

    /// Reads it from the fields that `next_if` gives where they begin with a word; the outer `None` where it is broken.
    #[expect(clippy::option_option, reason = "what is not there is not what cannot be read")]
    pub(super) fn parse<'t>(mut next_if: impl FnMut(&str) -> Option<&'t str>) -> Option<Option<Self>> {
        let Some(spheres) = next_if(SPHERES) else { return Some(None) };
        let (forces, numbers) = (next_if(FORCES)?, next_if(NUMBERS)?);
        let property = |text: &str| {
            let (name, digest) = text.split_once('=')?;
            let is_whole =
                digest.len() == PROPERTY_DIGITS && digest.bytes().all(|byte| byte.is_ascii_hexdigit());
            is_whole.then(|| Some((name.parse().ok()?, digest.to_owned())))?
        };
        let properties =
            numbers.split(' ').filter(|text| *text != NOTHING).map(property).collect::<Option<_>>()?;
        Some(Some(Self {
            spheres: NotedNames::parse(spheres)?,
            forces: NotedNames::parse(forces)?,
            properties,
        }))
    }
}

impl NotedNames {
    fn text(&self) -> String {
        format!("{} {}", self.count, self.digest)
    }

    fn parse(text: &str) -> Option<Self> {
        let (count, digest) = text.split_once(' ')?;
        is_digest(digest).then(|| Some(Self { count: count.parse().ok()?, digest: digest.to_owned() }))?
    }
}
