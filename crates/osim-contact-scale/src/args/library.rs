//! Options of the verbs that make or change libraries of models.

use std::path::PathBuf;

use clap::Args;

use super::groups::{OutputArgs, RunArgs};

/// One row per model; columns are named like the long options of rescale, transfer, design and set.
#[derive(Debug, Args)]
pub(crate) struct BatchArgs {
    /// A table (CSV): a column 'model', and one for each option that rows need; - is standard input
    #[arg(value_name = "MANIFEST")]
    pub manifest: PathBuf,
    #[command(flatten)]
    pub output: OutputArgs,
    #[command(flatten)]
    pub run: RunArgs,
}
