//! A preset, as text and as JSON.

use contact_scaling::{DimensionlessContact, Preset};
use osim_inspect::SCHEMA_VERSION;
use osim_model::messages::readable;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::Serialize;

use crate::report::layout::{filled, table};

/// A preset, as the JSON has it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct PresetRecord {
    /// Raised when a field changes its meaning or goes away.
    pub schema_version: u32,
    /// Its name.
    pub name: String,
    /// Where its numbers are published.
    pub source: String,
    /// The mass it was made for, kg.
    pub mass_kg: f64,
    /// Spheres that share the weight.
    pub spheres: f64,
    /// Their radius, m.
    pub radius_m: f64,
    /// Gravity, m/s².
    pub gravity_m_s2: f64,
    /// OpenSim's `stiffness`, E₁* in N/m².
    pub stiffness: f64,
    /// OpenSim's `dissipation`, s/m.
    pub dissipation: f64,
    /// OpenSim's `constant_contact_force`, m².
    pub constant_contact_force: Option<f64>,
    /// OpenSim's `hertz_smoothing`, 1/m.
    pub hertz_smoothing: Option<f64>,
    /// OpenSim's `hunt_crossley_smoothing`, s/m.
    pub hunt_crossley_smoothing: Option<f64>,
    /// The same without dimensions.
    pub dimensionless: DimensionlessRecord,
}

/// A contact without dimensions.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct DimensionlessRecord {
    /// E* R² n / (M g).
    pub modulus: f64,
    /// x̂ under its share of the body weight, by the Hertz law (11).
    pub relative_indentation: f64,
    /// α √(g R).
    pub dissipation: f64,
    /// √cf / R (C.2).
    pub constant_indentation: Option<f64>,
    /// bd R.
    pub hertz_smoothing: Option<f64>,
    /// bv √(g R).
    pub hunt_crossley_smoothing: Option<f64>,
}

impl From<&Preset> for PresetRecord {
    fn from(preset: &Preset) -> Self {
        let (scale, contact) = (&preset.scale, &preset.contact);
        let smoothing = contact.smoothing();
        let dimensionless = DimensionlessContact::of(contact, scale);
        Self {
            schema_version: SCHEMA_VERSION,
            name: preset.name.to_string(),
            source: preset.source.to_string(),
            mass_kg: scale.mass_kg(),
            spheres: scale.sphere_count(),
            radius_m: scale.radius_m(),
            gravity_m_s2: scale.gravity_m_s2(),
            stiffness: contact.plane_strain_modulus(),
            dissipation: contact.dissipation(),
            constant_contact_force: smoothing.map(|s| s.constant_contact_force),
            hertz_smoothing: smoothing.map(|s| s.hertz_smoothing),
            hunt_crossley_smoothing: smoothing.map(|s| s.hunt_crossley_smoothing),
            dimensionless: DimensionlessRecord {
                modulus: dimensionless.modulus(),
                relative_indentation: dimensionless.relative_indentation(),
                dissipation: dimensionless.dissipation(),
                constant_indentation: dimensionless.constant_indentation(),
                hertz_smoothing: dimensionless.hertz_smoothing(),
                hunt_crossley_smoothing: dimensionless.hunt_crossley_smoothing(),
            },
        }
    }
}

/// A preset with its source and its figures, with and without dimensions.
#[must_use]
pub fn preset_text(preset: &Preset) -> String {
    let (scale, contact) = (&preset.scale, &preset.contact);
    let dimensionless = DimensionlessContact::of(contact, scale);
    let mut table = table(&["quantity", "value", "unit", "dimensionless"]);
    let mut row = |name: &str, value: f64, unit: &str, pure: Option<f64>| {
        let pure = pure.map(readable).unwrap_or_default();
        table.add_row(vec![name.to_owned(), readable(value), unit.to_owned(), pure]);
    };
    row("mass", scale.mass_kg(), "kg", None);
    row("spheres", scale.sphere_count(), "", None);
    row("radius", scale.radius_m(), "m", None);
    row("gravity", scale.gravity_m_s2(), "m/s2", None);
    row("stiffness", contact.plane_strain_modulus(), "N/m2", Some(dimensionless.modulus()));
    row("dissipation", contact.dissipation(), "s/m", Some(dimensionless.dissipation()));
    if let Some(smoothing) = contact.smoothing() {
        let cf = smoothing.constant_contact_force;
        row("constant_contact_force", cf, "m2", dimensionless.constant_indentation());
        row("hertz_smoothing", smoothing.hertz_smoothing, "1/m", dimensionless.hertz_smoothing());
        let bv = smoothing.hunt_crossley_smoothing;
        row("hunt_crossley_smoothing", bv, "s/m", dimensionless.hunt_crossley_smoothing());
    }
    format!(
        "{}\n{}\n\n{}\n\nrelative indentation at body weight: {}\n",
        preset.name,
        filled(&format!("source: {}", preset.source)),
        table.trim_fmt(),
        readable(dimensionless.relative_indentation())
    )
}
