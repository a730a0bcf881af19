//! What is known apart from models: presets, equations, codes.

use std::path::PathBuf;

#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::options::Format;
use crate::values::{path, serial};

/// Lists presets, or shows one.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct PresetsRequest {
    /// One preset (without it: list them all)
    pub name: Option<String>,
    /// A file with presets of your own (TOML)
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub presets: Option<PathBuf>,
    /// How to print
    #[cfg_attr(feature = "clap", arg(long, value_enum, default_value_t))]
    pub format: Format,
}

/// Explains equations, quantities, and the codes of warnings and errors.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct ExplainRequest {
    /// Number of an equation (10, C.5), a word from the column "equation", a property or figure (stiffness, x/R), or a code
    /// as printed after a warning
    #[cfg_attr(feature = "clap", arg(value_name = "EQUATION|QUANTITY|CODE"))]
    #[serde(deserialize_with = "serial::from_texts")]
    pub topics: Vec<String>,
    /// How to print
    #[cfg_attr(feature = "clap", arg(long, value_enum, default_value_t))]
    pub format: Format,
    /// Spell symbols in plain letters, for consoles that cannot show them
    #[cfg_attr(feature = "clap", arg(long))]
    pub ascii: bool,
}
