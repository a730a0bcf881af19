//! What is known apart from models: presets, equations, codes, and what the paper prints and draws.

use std::path::PathBuf;

use osim_model::messages::Phrase;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::fault::Relation;
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

/// Explains equations, quantities, and the codes of findings and errors.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct ExplainRequest {
    /// Number of an equation (10, C.5), a word from the column "equation", a property or figure (stiffness, x/R), or a code
    /// as printed after a finding
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

// What the paper prints and draws, computed again.

/// Compares Table 1 of the paper with what its equations give, and draws its figures 4 and C.5.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct ReproduceRequest {
    /// Write table1.csv, fig4.svg and fig-c5.svg into this folder
    #[cfg_attr(feature = "clap", arg(short = 'd', long, value_name = "DIR"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub output_dir: Option<PathBuf>,
    /// Replace existing files
    #[cfg_attr(feature = "clap", arg(long))]
    pub force: bool,
    /// How to print
    #[cfg_attr(feature = "clap", arg(long, value_enum, default_value_t))]
    pub format: Format,
}

impl ReproduceRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] = &[&[Relation::Needs("force", "output_dir")]];
}

// Fig. 1 of the paper, which no equation gives: what it shows and what it needs.

/// Why Fig. 1 is not drawn, what it needs, and how its models are made: a paragraph each.
pub fn fig1() -> [Phrase; 3] {
    [WHY, NEEDS, MODELS].map(Phrase::template)
}

/// Why Fig. 1 is not drawn, as the answer to somebody who wants it.
pub fn no_fig1() -> Phrase {
    Phrase::joined([WHY, MODELS].map(Phrase::template), " ").unwrap_or_default()
}

const WHY: &str =
    "Fig. 1 is not drawn: its points are simulated gaits of a bird with muscles, and no equation gives them.";

const NEEDS: &str = "It shows the cost of transport and the computing time over the stiffness E1* and the dissipation. To make it, you need \
                     OpenSim Moco 4.5, and the bird model with its code: doi:10.5281/zenodo.20730121.";

const MODELS: &str =
    "This program makes the models for it: `sweep MODEL grid=stiffness=x0.1..x10/9` (docs/sweep.md).";
