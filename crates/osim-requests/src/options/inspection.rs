//! How a model is inspected: which forces, which mass, and how many spheres share which load.

use std::collections::BTreeMap;
use std::path::PathBuf;

use osim_model::files::CompanionPaths;
use osim_model::messages::Input;
use osim_model::{MassRequest, MassesOfOtherRows, Pattern, Selection};
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::fault::Relation;
use crate::options::run::AnswerOptions;
use crate::values::{Acceleration, Count, Kilograms, Positive, path, serial};

/// How a model is inspected.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct InspectionOptions {
    /// Under what load.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub stance: StanceOptions,
    /// Whose weight.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub masses: MassOptions,
    /// Which forces.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub choice: ForceOptions,
    /// Files of a standalone set.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub set_files: SetFiles,
    /// Answers to questions.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub answers: AnswerOptions,
}

/// Which forces.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "Which forces"))]
#[serde(default)]
pub struct ForceOptions {
    /// Only forces with such a name; may be repeated
    #[cfg_attr(feature = "clap", arg(long, value_name = "GLOB"))]
    #[serde(deserialize_with = "serial::from_texts", serialize_with = "serial::as_texts")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<String>"))]
    pub select: Vec<Pattern>,
    /// No forces with such a name; may be repeated
    #[cfg_attr(feature = "clap", arg(long, value_name = "GLOB"))]
    #[serde(deserialize_with = "serial::from_texts", serialize_with = "serial::as_texts")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<String>"))]
    pub exclude: Vec<Pattern>,
    /// Leave out forces that are switched off
    #[cfg_attr(feature = "clap", arg(long, hide_short_help = true))]
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
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "Masses"))]
#[serde(default)]
pub struct MassOptions {
    /// Mass the contacts are made for now, kg [default: the note, else `mass`]
    #[cfg_attr(feature = "clap", arg(long, value_name = "KG", allow_hyphen_values = true))]
    pub contacts_mass: Option<Kilograms>,
    /// What this model weighs, kg [default: the sum of its bodies]
    #[cfg_attr(feature = "clap", arg(long, value_name = "KG", allow_hyphen_values = true))]
    pub mass: Option<Kilograms>,
    /// Leave these bodies out of the sum (props, platforms); may be repeated
    #[cfg_attr(feature = "clap", arg(long, value_name = "GLOB", hide_short_help = true))]
    #[serde(deserialize_with = "serial::from_texts", serialize_with = "serial::as_texts")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<String>"))]
    pub exclude_body: Vec<Pattern>,
    /// Of a row of a table: what its other rows say of the same masses. No caller gives it.
    #[serde(skip)]
    #[cfg_attr(feature = "clap", arg(skip))]
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
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(
    feature = "clap",
    derive(clap::Args),
    command(next_help_heading = "Spheres that share the weight")
)]
#[serde(default)]
pub struct CountOptions {
    /// Spheres that share the body weight, all stance limbs together [default: as found per limb]
    #[cfg_attr(feature = "clap", arg(long, value_name = "N"))]
    pub spheres: Option<Count>,
    /// Limbs that share the body weight [default: as the note in the model says, else 1]
    #[cfg_attr(feature = "clap", arg(long, value_name = "N"))]
    pub stance_limbs: Option<Count>,
}

impl CountOptions {
    /// n, if given.
    pub fn spheres(&self) -> Option<f64> {
        self.spheres.map(Count::get)
    }

    /// Limbs that share the weight: as said, else as `noted` in the model, else one.
    pub fn stance_limbs(&self, noted: Option<f64>) -> f64 {
        self.stance_limbs.map(Count::get).or(noted).unwrap_or(1.0)
    }

    /// The options with what else figures are made for.
    pub fn stance_options(
        &self,
        impact_speed: Option<Positive>,
        gravity: Option<Acceleration>,
    ) -> StanceOptions {
        StanceOptions { spheres: self.spheres, stance_limbs: self.stance_limbs, impact_speed, gravity }
    }
}

/// What the figures are made for.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(
    feature = "clap",
    derive(clap::Args),
    command(next_help_heading = "What the figures are made for")
)]
#[serde(default)]
pub struct StanceOptions {
    /// Spheres that share the body weight, all stance limbs together [default: as found per limb]
    #[cfg_attr(feature = "clap", arg(long, value_name = "N"))]
    pub spheres: Option<Count>,
    /// Limbs that share the body weight [default: as the note in the model says, else 1]
    #[cfg_attr(feature = "clap", arg(long, value_name = "N"))]
    pub stance_limbs: Option<Count>,
    /// Impact speed for the restitution, m/s [default: sqrt(gR/2), a fall from a quarter of the radius]
    #[cfg_attr(feature = "clap", arg(long, value_name = "M/S"))]
    pub impact_speed: Option<Positive>,
    /// Gravity, m/s2 [default: the model's own]
    #[cfg_attr(feature = "clap", arg(long, value_name = "G"))]
    pub gravity: Option<Acceleration>,
}

/// The load on the spheres.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "The load"))]
#[serde(default)]
pub struct LoadOptions {
    /// Total load on all spheres, N
    #[cfg_attr(feature = "clap", arg(long, value_name = "N"))]
    pub load: Option<Positive>,
    /// The load in body weights [default: 1 where a mass is known]
    #[cfg_attr(feature = "clap", arg(long, value_name = "B"))]
    pub body_weights: Option<Positive>,
    /// Gravity, m/s2 [default: the model's, else 9.80665]
    #[cfg_attr(feature = "clap", arg(long, value_name = "G"))]
    pub gravity: Option<Acceleration>,
}

impl LoadOptions {
    /// Which of its fields need or exclude others.
    pub(crate) const RELATIONS: &'static [Relation] = &[Relation::Excludes("load", "body_weights")];

    /// The load in body weights, if none is given in newtons.
    pub fn body_weights(&self) -> f64 {
        self.body_weights.map_or(1.0, Positive::get)
    }

    /// Gravity, if given.
    pub fn gravity(&self) -> Option<f64> {
        self.gravity.map(Acceleration::get)
    }
}

/// Files that belong to a standalone set.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "Standalone sets"))]
#[serde(default)]
pub struct SetFiles {
    /// The ContactGeometrySet (or model) that holds the spheres of a standalone ForceSet
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE", hide_short_help = true))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub geometry: Option<PathBuf>,
    /// The model a standalone ForceSet belongs to, for its masses and joints
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE", hide_short_help = true))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub model: Option<PathBuf>,
}

impl SetFiles {
    pub fn companion_paths(&self) -> CompanionPaths<'_> {
        CompanionPaths { geometry: self.geometry.as_deref(), model: self.model.as_deref() }
    }

    /// Both files, those that are named.
    pub fn paths(&self) -> impl Iterator<Item = &PathBuf> {
        [&self.geometry, &self.model].into_iter().flatten()
    }
}
