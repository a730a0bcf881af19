//! What is wanted of a transfer, and where its contacts come from.

use contact_scaling::{Contact, Preset};
use osim_model::{Mass, MassSource};

use crate::follow::Follow;
use crate::property_set::PropertySet;
use crate::radii::RadiusRule;
use crate::scaling::DissipationBy;

/// One contact of a reference.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ReferenceContact {
    /// Names of the spheres that have it, and their radii, m.
    pub spheres: Vec<String>,
    /// Radius of each of `spheres`, m.
    pub radii_m: Vec<f64>,
    /// Their radius (the root of the mean R² where they differ), m.
    pub radius_m: f64,
    /// E₁* of two equal surfaces, α, and the smoothing where the class has it.
    pub contact: Contact,
    /// `transition_velocity` in m/s and `viscous_friction` in s/m.
    pub friction: Option<(f64, f64)>,
}

/// Where contacts are taken from.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Reference {
    /// File or preset, for the note.
    pub name: String,
    /// Mass its contacts stand for.
    pub mass: Mass,
    /// Spheres that share the body weight.
    pub sphere_count: f64,
    /// Gravity, m/s², where known.
    pub gravity_m_s2: Option<f64>,
    /// Its contacts.
    pub contacts: Vec<ReferenceContact>,
}

impl From<&Preset> for Reference {
    fn from(preset: &Preset) -> Self {
        let mass = Mass { kg: preset.scale.mass_kg(), source: MassSource::Preset(preset.name.to_string()) };
        Self {
            name: preset.name.to_string(),
            mass,
            sphere_count: preset.scale.sphere_count(),
            gravity_m_s2: Some(preset.scale.gravity_m_s2()),
            contacts: vec![ReferenceContact {
                spheres: vec![],
                radii_m: vec![],
                radius_m: preset.scale.radius_m(),
                contact: preset.contact,
                friction: None,
            }],
        }
    }
}

/// What is wanted of a transfer.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Transfer {
    /// Where the contacts come from.
    pub reference: Reference,
    /// Take the contact of this sphere for all.
    pub reference_sphere: Option<String>,
    /// What this model weighs.
    pub mass: Mass,
    /// Spheres that share this model's weight.
    pub sphere_count: f64,
    /// What becomes of the radii.
    pub radius: RadiusRule,
    /// What may change.
    pub properties: PropertySet,
    /// Which size α follows.
    pub dissipation_by: DissipationBy,
    /// Gravity of this model, m/s², where contacts shall follow it.
    pub target_gravity_m_s2: Option<f64>,
    /// New places and radii of the spheres, where they follow their bodies.
    pub follow: Option<Follow>,
    /// Whose scaling.
    pub rule: ScalingRule,
    /// Refuse instead of warning where spheres of one force follow bodies with different factors.
    pub strict: bool,
}

impl Transfer {
    /// Everything the paper scales, with radii as they are.
    #[must_use]
    pub fn new(reference: Reference, mass: Mass, sphere_count: f64) -> Self {
        Self {
            reference,
            reference_sphere: None,
            mass,
            sphere_count,
            radius: RadiusRule::Keep,
            properties: PropertySet::default(),
            dissipation_by: DissipationBy::default(),
            target_gravity_m_s2: None,
            follow: None,
            rule: ScalingRule::Paper,
            strict: false,
        }
    }
}

/// How E₁* and α follow from the reference.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub enum ScalingRule {
    /// (10) and (14).
    #[default]
    Paper,
    /// PredSim's: stiffness by mass over height squared, dissipation by one over height; smoothing stays.
    PredSim {
        /// Height of this model over that of the reference.
        height_ratio: f64,
    },
}
