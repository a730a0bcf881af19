//! Options of the verbs that make or change libraries of models.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::Args;

use super::CountArgs;
use super::groups::{ForceChoice, Format, MassArgs, OutputArgs, RunArgs};
use super::physics::{LoadArgs, WantedArgs};
use super::values::positive_number;
use crate::sweep::Axis;

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

/// One file per point of a grid, or per step of a ladder, and a table that says what is in which.
#[derive(Debug, Args)]
pub(crate) struct SweepArgs {
    /// The model (.osim) whose variants are made
    #[arg(value_name = "MODEL")]
    pub model: PathBuf,
    /// Values of a property (stiffness=1e5,1e6), factors (stiffness=x0.1,x1,x10), a logarithmic range
    /// (stiffness=x0.1..x10/9), or values of indentation, restitution or target-mass; may be repeated
    #[arg(long, value_name = "NAME=V,V,...", required_unless_present = "ladder")]
    pub grid: Vec<Axis>,
    /// N steps from a soft contact to --indentation and --restitution, to search for a gait in turn
    #[arg(long, value_name = "N", conflicts_with = "grid", requires = "indentation")]
    pub ladder: Option<u32>,
    /// With --ladder: dimensionless stiffness of the first step
    #[arg(long, value_name = "K", value_parser = positive_number, default_value = "1.2", requires = "ladder")]
    pub soft: f64,
    /// Write the models into this folder [default: NAME.sweep beside the model]
    #[arg(short = 'd', long, value_name = "DIR", help_heading = "Output")]
    pub output_dir: Option<PathBuf>,
    /// Replace existing files
    #[arg(long, help_heading = "Output")]
    pub force: bool,
    /// Make more than 10,000 models
    #[arg(long, help_heading = "Output")]
    pub yes: bool,
    /// Leave no note (a comment line) in the models
    #[arg(long, help_heading = "Output", hide_short_help = true)]
    pub no_note: bool,
    /// Write nothing, only say what would be made
    #[arg(long, help_heading = "Output")]
    pub dry_run: bool,
    /// How to print
    #[arg(long, value_enum, default_value_t, help_heading = "Output")]
    pub format: Format,
    /// Print errors only
    #[arg(long, help_heading = "Output")]
    pub quiet: bool,
    /// Models to make at once [default: one per processor]
    #[arg(long, value_name = "N", help_heading = "Output", hide_short_help = true)]
    pub jobs: Option<NonZeroUsize>,
    #[command(flatten)]
    pub wanted: WantedArgs,
    #[command(flatten)]
    pub load: LoadArgs,
    #[command(flatten)]
    pub masses: MassArgs,
    #[command(flatten)]
    pub counts: CountArgs,
    #[command(flatten)]
    pub choice: ForceChoice,
}
