//! How a run goes about its work, and how results are shown.

use std::path::PathBuf;

#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::choice::choices;
use crate::relation::Relation;
use crate::values::{Jobs, Shard, path};

choices! {
    /// How a change is shown.
    RunFormat {
        /// Every number that changes.
        Table = "table", "Every number that changes";
        /// One line per model.
        Lines = "lines", "One line per model";
        /// One JSON object per model and line.
        Json = "json", "One JSON object per model and line";
    }
}

choices! {
    /// How results are shown.
    Format: Table {
        /// For people.
        Table = "table", "For people";
        /// One JSON object per model and line.
        Json = "json", "One JSON object per model and line";
    }
}

choices! {
    /// How models that were inspected are shown.
    SheetFormat: Table {
        /// For people.
        Table = "table", "For people";
        /// One JSON object per model and line.
        Json = "json", "One JSON object per model and line";
        /// One table for spreadsheets, one header for all models.
        Csv = "csv", "One table for spreadsheets, one header for all models";
    }
}

impl From<Format> for SheetFormat {
    fn from(format: Format) -> Self {
        match format {
            Format::Table => Self::Table,
            Format::Json => Self::Json,
        }
    }
}

/// How a run works and what it reports.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "Output"))]
#[serde(default)]
pub struct RunOptions {
    /// Write nothing, only say what would change
    #[cfg_attr(feature = "clap", arg(long))]
    pub dry_run: bool,
    /// Show the changes as a unified diff too
    #[cfg_attr(feature = "clap", arg(long))]
    pub diff: bool,
    /// How to print [default: table; lines if more than 10 models]
    #[cfg_attr(feature = "clap", arg(long, value_enum))]
    pub format: Option<RunFormat>,
    /// Print errors only
    #[cfg_attr(feature = "clap", arg(long, hide_short_help = true))]
    pub quiet: bool,
    /// Write a page for browsers too (.html): tables, plots, findings
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub report: Option<PathBuf>,
    /// Models to work on at once [default: one per processor]
    #[cfg_attr(feature = "clap", arg(long, value_name = "N", hide_short_help = true))]
    pub jobs: Option<Jobs>,
    /// Keep a line per model in this file (.csv or .ndjson)
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE", hide_short_help = true))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub summary: Option<PathBuf>,
    /// Skip models that `summary` says are done, if nothing has changed since
    #[cfg_attr(feature = "clap", arg(long, hide_short_help = true))]
    pub resume: bool,
    /// Only share I of N of the models, for job arrays
    #[cfg_attr(feature = "clap", arg(long, value_name = "I/N", hide_short_help = true))]
    pub shard: Option<Shard>,
}

impl RunOptions {
    /// Which of its fields need or exclude others.
    pub const RELATIONS: &'static [Relation] =
        &[Relation::Needs("resume", "summary"), Relation::Excludes("resume", "dry_run")];

    /// The fields that are about many models at once.
    pub(crate) const OF_MANY: [&'static str; 4] = ["jobs", "summary", "resume", "shard"];

    /// Whether results are shown as JSON.
    #[must_use]
    pub fn is_json(&self) -> bool {
        self.format == Some(RunFormat::Json)
    }
}

/// The page that verbs write which change nothing.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "Output"))]
#[serde(default)]
pub struct ReportOptions {
    /// Write a page for browsers too (.html): tables, plots, findings
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub report: Option<PathBuf>,
    /// Replace an existing report
    #[cfg_attr(feature = "clap", arg(long))]
    pub force: bool,
}

impl ReportOptions {
    /// Which of its fields need or exclude others.
    pub const RELATIONS: &'static [Relation] = &[Relation::Needs("force", "report")];
}
