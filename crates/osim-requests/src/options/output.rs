//! Where results go.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::relation::Relation;
use crate::value::path;

/// Where results go.
#[derive(Debug, Clone, Default, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "Output"))]
#[serde(default)]
#[non_exhaustive]
pub struct OutputOptions {
    /// Write to this file (one model; - is standard output) [default: NAME.scaled.osim beside the model]
    #[cfg_attr(feature = "clap", arg(short, long, value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[schemars(with = "Option<path::PathSchema>")]
    pub output: Option<PathBuf>,
    /// Write the changed ContactGeometrySet of a standalone ForceSet to this file
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE", hide_short_help = true))]
    #[serde(with = "path::optional")]
    #[schemars(with = "Option<path::PathSchema>")]
    pub geometry_output: Option<PathBuf>,
    /// Write into this folder
    #[cfg_attr(feature = "clap", arg(short = 'd', long, value_name = "DIR"))]
    #[serde(with = "path::optional")]
    #[schemars(with = "Option<path::PathSchema>")]
    pub output_dir: Option<PathBuf>,
    /// Change the model itself and keep the old one as NAME.osim.bak
    #[cfg_attr(feature = "clap", arg(long))]
    pub in_place: bool,
    /// With `in_place`: keep no backup
    #[cfg_attr(feature = "clap", arg(long, hide_short_help = true))]
    pub no_backup: bool,
    /// Replace existing files
    #[cfg_attr(feature = "clap", arg(long))]
    pub force: bool,
    /// Leave no note (a comment line) in the model
    #[cfg_attr(feature = "clap", arg(long, hide_short_help = true))]
    pub no_note: bool,
}

impl OutputOptions {
    pub(crate) const RELATIONS: &'static [Relation] = &[
        Relation::Excludes("output_dir", "output"),
        Relation::Excludes("in_place", "output"),
        Relation::Excludes("in_place", "output_dir"),
        Relation::Excludes("in_place", "geometry_output"),
        Relation::Needs("no_backup", "in_place"),
    ];

    /// Whether a factor may be applied to a model whose note says that it was applied already: a new file is no mistake.
    pub(crate) fn may_repeat(&self) -> bool {
        self.force || !self.in_place
    }
}
