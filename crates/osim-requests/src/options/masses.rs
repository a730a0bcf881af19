//! Masses: which one is meant.

use std::collections::BTreeMap;

use osim_model::messages::Input;
use osim_model::{MassRequest, MassesBeside, Pattern};
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::values::{Kilograms, serial};

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
    pub beside: BTreeMap<Input, MassesBeside>,
}

impl MassOptions {
    /// The same, as models are asked for it.
    #[must_use]
    pub fn request(&self) -> MassRequest {
        MassRequest {
            contacts_mass_kg: self.contacts_mass.map(Kilograms::get),
            model_kg: self.mass.map(Kilograms::get),
            exclude_bodies: self.exclude_body.clone(),
            target_mass_kg: None,
            beside: self.beside.clone(),
        }
    }
}
