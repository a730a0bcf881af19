//! The command line: verbs and their options.

mod follow;
mod groups;
mod library;
mod physics;
mod plot;
mod values;

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};

pub(crate) use follow::{FollowArgs, RuleArg};
use globset::Glob;
pub(crate) use groups::{
    ForceChoice, Format, MassArgs, OutputArgs, PartArgs, ReportArgs, RunArgs, RunFormat, ScalingArgs,
    SheetFormat, StanceArgs, ViewArgs, set_of,
};
pub(crate) use library::{BatchArgs, SweepArgs};
pub(crate) use physics::{
    BranchArg, ColumnArgs, DesignArgs, DropArgs, DropNumbers, FitArgs, ForceUnit, LengthUnit, LoadArgs,
    PresetsArgs, SeriesFormat, SetArgs, SpeedUnit, TimeUnit, WantedArgs,
};
pub(crate) use plot::{AxesArg, PlotArgs, PlotKind, Quantity};
pub(crate) use values::{Length, assignment, positive_number, usage_line, usage_parts};
use values::{acceleration, count, glob, mass};

/// Makes the contact parameters of OpenSim models right at every body size.
///
/// Rescales the contacts of MODEL from the mass they stand for to --target-mass; with a verb, does something else.
/// MODEL alone is inspected.
#[derive(Debug, Parser)]
#[command(
    version,
    args_conflicts_with_subcommands = true,
    arg_required_else_help = true,
    disable_help_subcommand = true,
    after_help = "More options with --help. Equations: Van Bijlert (2026), J. Biomech., doi:10.1016/j.jbiomech.2026.113420"
)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub verb: Option<Verb>,
    #[command(flatten)]
    pub rescale: RescaleArgs,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Verb {
    /// Rescale a model's own contacts to another mass (the verb may be left out)
    Rescale(Box<RescaleArgs>),
    /// Give a model the contacts of another model or of a preset, at its own size
    Transfer(Box<TransferArgs>),
    /// Find parameters from what is wanted: indentation, stiffness, restitution
    Design(Box<DesignArgs>),
    /// Set properties to a value, or multiply them by a factor
    Set(Box<SetArgs>),
    /// Change many models, as a table says: one row per model
    Batch(Box<BatchArgs>),
    /// Make a grid of variants of a model, or a ladder of them from soft to stiff
    Sweep(Box<SweepArgs>),
    /// Show what contacts a model has
    Inspect(Box<InspectArgs>),
    /// Hold models against the limits of the paper and the traps of the format
    Check(Box<CheckArgs>),
    /// Let a model fall on its contacts and see what they do
    DropTest(Box<DropArgs>),
    /// Draw what contacts do, as SVG or PNG
    Plot(Box<PlotArgs>),
    /// Find contact parameters from a measured indentation and force
    Fit(Box<FitArgs>),
    /// List presets, or show one
    Presets(PresetsArgs),
    /// Explain an equation, or the code of a warning or an error (alone: list them all)
    Explain(ExplainArgs),
    /// Let the shell complete verbs and options
    Completions(CompletionsArgs),
    /// Print the manual page, or write all of them
    Man(ManArgs),
}

#[derive(Debug, Args)]
pub(crate) struct RescaleArgs {
    /// Models (.osim), a ForceSet (.xml) with --geometry, folders, or - for standard input
    #[arg(value_name = "MODEL")]
    pub models: Vec<PathBuf>,
    /// Mass the contacts shall stand for, kg
    #[arg(long, value_name = "KG", value_parser = mass, allow_hyphen_values = true)]
    pub target_mass: Option<f64>,
    #[command(flatten)]
    pub masses: MassArgs,
    #[command(flatten)]
    pub scaling: ScalingArgs,
    #[command(flatten)]
    pub choice: ForceChoice,
    #[command(flatten)]
    pub output: OutputArgs,
    #[command(flatten)]
    pub run: RunArgs,
    #[command(flatten)]
    pub parts: PartArgs,
}

impl RescaleArgs {
    /// `true` when an option makes sense for a change only.
    pub(crate) fn asks_for_change(&self) -> bool {
        let (scaling, output, run) = (&self.scaling, &self.output, &self.run);
        scaling.radius.is_some()
            || !scaling.only.is_empty()
            || !scaling.keep.is_empty()
            || scaling.friction
            || scaling.target_gravity.is_some()
            || scaling.level
            || output.output.is_some()
            || output.output_dir.is_some()
            || output.in_place
            || run.dry_run
            || run.diff
            || run.summary.is_some()
            || run.shard.is_some()
    }
}

#[derive(Debug, Args)]
pub(crate) struct TransferArgs {
    /// Models (.osim), a ForceSet (.xml) with --geometry, folders, or - for standard input
    #[arg(value_name = "MODEL", required = true)]
    pub models: Vec<PathBuf>,
    /// Where the contacts come from: a model, or a preset such as falisse2022
    #[arg(long, value_name = "MODEL|PRESET", required = true)]
    pub from: PathBuf,
    /// A file with presets of your own (TOML)
    #[arg(long, value_name = "FILE", hide_short_help = true)]
    pub presets: Option<PathBuf>,
    #[command(flatten)]
    pub counts: CountArgs,
    #[command(flatten)]
    pub reference: ReferenceArgs,
    #[command(flatten)]
    pub follow: FollowArgs,
    #[command(flatten)]
    pub masses: MassArgs,
    #[command(flatten)]
    pub scaling: ScalingArgs,
    #[command(flatten)]
    pub choice: ForceChoice,
    #[command(flatten)]
    pub output: OutputArgs,
    #[command(flatten)]
    pub run: RunArgs,
    #[command(flatten)]
    pub parts: PartArgs,
}

/// How many spheres share the body weight.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Spheres that share the weight")]
pub(crate) struct CountArgs {
    /// Spheres that share the body weight, all stance limbs together [default: as found per limb]
    #[arg(long, value_name = "N", value_parser = count)]
    pub spheres: Option<f64>,
    /// Limbs that share the body weight
    #[arg(long, value_name = "N", value_parser = count, default_value = "1")]
    pub stance_limbs: f64,
}

/// What the reference is, where its file does not say.
#[derive(Debug, Args)]
#[command(next_help_heading = "The reference")]
pub(crate) struct ReferenceArgs {
    /// Mass its contacts stand for, kg [default: its note, else its bodies]
    #[arg(long, value_name = "KG", value_parser = mass, allow_hyphen_values = true)]
    pub reference_mass: Option<f64>,
    /// Its spheres that share the body weight [default: as found per limb]
    #[arg(long, value_name = "N", value_parser = count, hide_short_help = true)]
    pub reference_spheres: Option<f64>,
    /// Its gravity, m/s2
    #[arg(long, value_name = "G", value_parser = acceleration, hide_short_help = true)]
    pub reference_gravity: Option<f64>,
    /// Only its forces with such a name; may be repeated
    #[arg(long, value_name = "GLOB", value_parser = glob, hide_short_help = true)]
    pub reference_select: Vec<Glob>,
    /// Take the contact of this sphere for all
    #[arg(long, value_name = "NAME")]
    pub reference_sphere: Option<String>,
}

#[derive(Debug, Args)]
pub(crate) struct InspectArgs {
    /// Models (.osim), a ForceSet (.xml) with --geometry, folders, or - for standard input
    #[arg(value_name = "MODEL", required = true)]
    pub models: Vec<PathBuf>,
    /// The generic model this one was scaled from: show each body's factors
    #[arg(long, value_name = "MODEL")]
    pub from: Option<PathBuf>,
    /// With --from: the ScaleSet that the Scale Tool applied
    #[arg(long, value_name = "FILE", requires = "from")]
    pub body_scale_file: Option<PathBuf>,
    /// How to print
    #[arg(long, value_enum, default_value_t)]
    pub format: SheetFormat,
    #[command(flatten)]
    pub report: ReportArgs,
    #[command(flatten)]
    pub view: ViewArgs,
}

#[derive(Debug, Args)]
pub(crate) struct CheckArgs {
    /// Models (.osim), a ForceSet (.xml) with --geometry, folders, or - for standard input
    #[arg(value_name = "MODEL", required = true)]
    pub models: Vec<PathBuf>,
    /// Exit with 1 where a finding is as bad as this, or worse
    #[arg(long, value_enum, default_value_t)]
    pub deny: Deny,
    /// How to print
    #[arg(long, value_enum, default_value_t)]
    pub format: SheetFormat,
    #[command(flatten)]
    pub report: ReportArgs,
    #[command(flatten)]
    pub view: ViewArgs,
}

/// From which severity on a finding is a failure.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Deny {
    /// Limits of the paper and traps, too
    Warn,
    /// What OpenSim computes otherwise than it looks, or as nonsense
    #[default]
    Error,
}

impl Deny {
    pub(crate) const fn severity(self) -> osim_patch::Severity {
        match self {
            Self::Warn => osim_patch::Severity::Warn,
            Self::Error => osim_patch::Severity::Error,
        }
    }
}

#[derive(Debug, Args)]
pub(crate) struct ExplainArgs {
    /// Number of an equation (10, C.5), a word from the column "equation", or a code as printed behind a warning
    #[arg(value_name = "EQUATION|CODE")]
    pub topics: Vec<String>,
    /// How to print
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
    /// Spell symbols in plain letters, for consoles that cannot show them
    #[arg(long)]
    pub ascii: bool,
}

/// Prints a script for the shell that completes verbs, options and file names.
#[derive(Debug, Args)]
#[command(after_help = "\
Where to put it (NAME is osim-contact-scale):
  bash        NAME completions bash > ~/.local/share/bash-completion/completions/NAME
              (the folder must be there: mkdir -p; needs the package bash-completion)
  zsh         NAME completions zsh > FOLDER/_NAME, with FOLDER a folder of $fpath
  fish        NAME completions fish > ~/.config/fish/completions/NAME.fish
  PowerShell  add this line to the file that $PROFILE names:
              NAME completions powershell | Out-String | Invoke-Expression
  elvish      NAME completions elvish > ~/.config/elvish/lib/NAME.elv,
              and the line 'use NAME' in ~/.config/elvish/rc.elv
Then open a new terminal.")]
pub(crate) struct CompletionsArgs {
    /// The shell
    pub shell: clap_complete::Shell,
}

/// Prints the manual page of the command or of one verb, or writes all pages into a folder.
#[derive(Debug, Args)]
#[command(after_help = "\
On macOS and Linux (NAME is osim-contact-scale):
  to read one   NAME man transfer > page.1; man ./page.1
  to keep all   NAME man -d ~/.local/share/man/man1, then: man NAME-transfer")]
pub(crate) struct ManArgs {
    /// The verb [default: the page of the command]
    pub verb: Option<String>,
    /// Write all pages into this folder
    #[arg(short = 'd', long, value_name = "DIR", conflicts_with = "verb")]
    pub output_dir: Option<PathBuf>,
    /// Replace existing files
    #[arg(long, requires = "output_dir")]
    pub force: bool,
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::Cli;

    #[test]
    fn the_command_line_is_consistent() {
        Cli::command().debug_assert();
    }
}
