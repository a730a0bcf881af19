//! Options for the inspection of a model: the forces, the mass, and the spheres that share a load.

use std::collections::BTreeMap;
use std::path::PathBuf;

use osim_model::files::CompanionPaths;
use osim_model::messages::Input;
use osim_model::{MassRequest, MassesOfOtherRows, Pattern, Selection};
use serde::{Deserialize, Serialize};

use crate::fault::Relation;
use crate::options::run::AnswerOptions;
use crate::values::{Acceleration, Count, Kilograms, Positive, path, serial};

/// How a model is inspected.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct InspectionOptions {
    #[serde(flatten)]
    pub stance: StanceOptions,
    #[serde(flatten)]
    pub masses: MassOptions,
    #[serde(flatten)]
    pub choice: ForceOptions,
    #[serde(flatten)]
    pub set_files: SetFiles,
    #[serde(flatten)]
    pub answers: AnswerOptions,
}

/// Options for the choice of forces.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct ForceOptions {
    #[serde(deserialize_with = "serial::from_texts", serialize_with = "serial::as_texts")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<String>"))]
    pub select: Vec<Pattern>,
    #[serde(deserialize_with = "serial::from_texts", serialize_with = "serial::as_texts")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<String>"))]
    pub exclude: Vec<Pattern>,
    pub skip_disabled: bool,
}

impl ForceOptions {
    pub fn selection(&self) -> Selection {
        Selection {
            select: self.select.clone(),
            exclude: self.exclude.clone(),
            skip_disabled: self.skip_disabled,
        }
    }
}

/// Masses: which one is meant.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct MassOptions {
    pub contacts_mass: Option<Kilograms>,
    pub mass: Option<Kilograms>,
    #[serde(deserialize_with = "serial::from_texts", serialize_with = "serial::as_texts")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<String>"))]
    pub exclude_body: Vec<Pattern>,
    /// Of a row of a table: what its other rows say of the same masses. No caller gives it.
    #[serde(skip)]
    #[cfg_attr(feature = "schemas", schemars(skip))]
    pub other_rows: BTreeMap<Input, MassesOfOtherRows>,
}

impl MassOptions {
    pub fn request(&self) -> MassRequest {
        MassRequest {
            contacts_mass_kg: self.contacts_mass.map(Kilograms::get),
            model_kg: self.mass.map(Kilograms::get),
            exclude_bodies: self.exclude_body.clone(),
            target_mass_kg: None,
            other_rows: self.other_rows.clone(),
        }
    }
}

// How many spheres share which load.

/// How many spheres share the body weight.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct CountOptions {
    pub spheres: Option<Count>,
    pub stance_limbs: Option<Count>,
}

impl CountOptions {
    /// The number n of spheres, if given.
    pub fn spheres(&self) -> Option<f64> {
        self.spheres.map(Count::get)
    }

    /// Number of limbs that share the weight: the given number, else the number `noted` in the model, else 1.
    pub fn stance_limbs(&self, noted: Option<f64>) -> f64 {
        self.stance_limbs.map(Count::get).or(noted).unwrap_or(1.0)
    }

    /// Options for figures of these spheres and limbs, with the impact speed and gravity.
    pub fn stance_options(
        &self,
        impact_speed: Option<Positive>,
        gravity: Option<Acceleration>,
    ) -> StanceOptions {
        StanceOptions { spheres: self.spheres, stance_limbs: self.stance_limbs, impact_speed, gravity }
    }
}

/// Options for the load and the speed of figures.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct StanceOptions {
    pub spheres: Option<Count>,
    pub stance_limbs: Option<Count>,
    pub impact_speed: Option<Positive>,
    pub gravity: Option<Acceleration>,
}

/// The load on the spheres.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct LoadOptions {
    pub load: Option<Positive>,
    pub body_weights: Option<Positive>,
    pub gravity: Option<Acceleration>,
}

impl LoadOptions {
    /// Conditions between the options for the load.
    pub(crate) const RELATIONS: &'static [Relation] = &[Relation::Excludes("load", "body_weights")];

    /// The load in body weights, for a load that is not given in newtons.
    pub fn body_weights(&self) -> f64 {
        self.body_weights.map_or(1.0, Positive::get)
    }

    /// Gravity in the options of the load, if given.
    pub fn gravity(&self) -> Option<f64> {
        self.gravity.map(Acceleration::get)
    }
}

/// Files that belong to a standalone set.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct SetFiles {
    #[serde(with = "path::Optional")]
    pub geometry: Option<PathBuf>,
    #[serde(with = "path::Optional")]
    pub model: Option<PathBuf>,
}

impl SetFiles {
    pub fn companion_paths(&self) -> CompanionPaths<'_> {
        CompanionPaths { geometry: self.geometry.as_deref(), model: self.model.as_deref() }
    }

    /// Paths of the motion's files that the request names.
    pub fn paths(&self) -> impl Iterator<Item = &PathBuf> {
        [&self.geometry, &self.model].into_iter().flatten()
    }
}
