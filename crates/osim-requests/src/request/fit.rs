//! Contact parameters from a measurement.

use std::path::PathBuf;

use contact_scaling::fit::Branch;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::choice::choices;
use crate::options::{ColumnOptions, Format};
use crate::relation::Relation;
use crate::values::{ContactOnset, Count, Positive, path};

choices! {
    /// Which part of a measurement.
    BranchChoice: Both {
        /// All of it.
        Both = "both";
        /// While the indentation grows.
        Loading = "loading";
        /// While it shrinks.
        Unloading = "unloading";
    }
}

impl BranchChoice {
    /// The branch.
    #[must_use]
    pub const fn branch(self) -> Branch {
        match self {
            Self::Both => Branch::Both,
            Self::Loading => Branch::Loading,
            Self::Unloading => Branch::Unloading,
        }
    }
}

/// Finds contact parameters from a measured indentation and force.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct FitRequest {
    /// Measured indentation and force (.csv; - is standard input)
    #[cfg_attr(feature = "clap", arg(value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub file: Option<PathBuf>,
    /// Sphere radius, m
    #[cfg_attr(feature = "clap", arg(long, value_name = "M"))]
    pub radius: Option<Positive>,
    /// Spheres that share the measured force
    #[cfg_attr(feature = "clap", arg(long, value_name = "N", default_value_t = Count::ONE))]
    pub spheres: Count,
    /// Where contact begins, in metres, or fit to find it
    #[cfg_attr(
        feature = "clap",
        arg(long, value_name = "M|fit", default_value_t, allow_hyphen_values = true)
    )]
    pub onset: ContactOnset,
    /// Which part of the measurement
    #[cfg_attr(feature = "clap", arg(long, value_enum, default_value_t))]
    pub branch: BranchChoice,
    /// How to print
    #[cfg_attr(feature = "clap", arg(long, value_enum, default_value_t))]
    pub format: Format,
    /// Columns and units.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub columns: ColumnOptions,
}

impl Default for FitRequest {
    fn default() -> Self {
        Self {
            file: None,
            radius: None,
            spheres: Count::ONE,
            onset: ContactOnset::default(),
            branch: BranchChoice::Both,
            format: Format::Table,
            columns: ColumnOptions::default(),
        }
    }
}

impl FitRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] =
        &[&[Relation::Required("file"), Relation::Required("radius")], ColumnOptions::RELATIONS];
}
