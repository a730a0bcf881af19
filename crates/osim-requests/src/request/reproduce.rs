//! What the paper prints and draws, computed again.

use std::path::PathBuf;

#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::options::Format;
use crate::relation::Relation;
use crate::values::path;

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
