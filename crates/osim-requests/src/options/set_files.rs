//! Files that belong to a standalone set.

use std::path::PathBuf;

use osim_model::files::Beside;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::values::path;

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
    /// The same, as a model is read with them.
    #[must_use]
    pub fn beside(&self) -> Beside<'_> {
        Beside { geometry: self.geometry.as_deref(), model: self.model.as_deref() }
    }

    /// Both files, those that are named.
    pub fn paths(&self) -> impl Iterator<Item = &PathBuf> {
        [&self.geometry, &self.model].into_iter().flatten()
    }
}
