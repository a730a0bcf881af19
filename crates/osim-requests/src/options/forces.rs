//! Which forces.

use osim_model::{Pattern, Selection};
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::values::serial;

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
    /// The same, as models take it.
    #[must_use]
    pub fn selection(&self) -> Selection {
        Selection {
            select: self.select.clone(),
            exclude: self.exclude.clone(),
            skip_disabled: self.skip_disabled,
        }
    }
}
