//! The command line: verbs, each with the request that its options make.

mod help;

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use anyhow::{Result, anyhow, bail};
use clap::builder::Resettable;
use clap::{ArgMatches, Args, Command, CommandFactory, Error, FromArgMatches, Parser, Subcommand};
use osim_model::messages::Verb;
use osim_requests::command_line::{check, with_relations};
use osim_requests::{
    AddRequest, BatchRequest, CheckRequest, ConvertRequest, DesignRequest, DropTestRequest, ExplainRequest,
    FitRequest, InspectRequest, MotionRequest, NoteRequest, PlotRequest, PresetsRequest, RemoveRequest,
    ReproduceRequest, RequestFault, RescaleRequest, SetRequest, SweepRequest, TransferRequest, assignment,
};
use osim_view::report::ExitStatus;

use crate::args::help::{in_groups, in_words_of_the_command, with_usual_first};
use crate::session::Language;
pub(crate) use help::usage_line;

/// Where the equations are from.
macro_rules! equations {
    () => {
        "Equations: Van Bijlert (2026), doi:10.1016/j.jbiomech.2026.113420"
    };
}

/// Makes the contact parameters of OpenSim models right at every body size.
///
/// Rescales the contacts of MODEL from the mass they were made for to --target-mass; with a verb, does something else.
/// MODEL alone is inspected.
#[derive(Debug, Parser)]
#[command(
    version,
    args_conflicts_with_subcommands = true,
    arg_required_else_help = true,
    disable_help_subcommand = true,
    override_usage = concat!(
        "osim-contact-scale [OPTIONS] [MODEL]...\n",
        "       osim-contact-scale <VERB>"
    ),
    after_help = concat!("More options with --help. ", equations!())
)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub verb: Option<VerbArgs>,
    #[command(flatten)]
    pub rescale: RescaleRequest,
}

#[derive(Debug, Subcommand)]
pub(crate) enum VerbArgs {
    /// Rescale a model's own contacts to another mass (the verb may be left out)
    ///
    /// Spheres move only with --follow-bodies, --body-scale-file or --level. After OpenSim's Scale Tool, check SCALED --from GENERIC first.
    /// With a note in the model (see note), SCALED --target-mass KG --follow-bodies needs no other file; without one,
    /// --body-scale-file takes the ScaleSet that was applied.
    Rescale(Later<RescaleRequest>),
    /// Give a model the contacts of another model or of a preset, at its own size
    ///
    /// After OpenSim's Scale Tool: check SCALED --from GENERIC says where each sphere belongs, and transfer SCALED --from GENERIC
    /// --follow-bodies -o OUT puts it there and makes the contacts right for the new mass.
    Transfer(Later<TransferRequest>),
    /// Give a model contacts: of another model, a table, or under its bones
    ///
    /// Spheres are placed by the size of this model's own bones, and their numbers made for its mass. remove takes them out again.
    Add(Later<AddRequest>),
    /// Take the foot contacts out of a model
    ///
    /// After add, also with a rescale in between, the first file is there again, byte for byte.
    Remove(Later<RemoveRequest>),
    /// Make forces of one class from those of the other, one for each sphere
    ///
    /// Divides a HuntCrossleyForce with several spheres, too, also into its own class.
    Convert(Later<ConvertRequest>),
    /// Find parameters from what is wanted: indentation, stiffness, restitution
    Design(Later<DesignRequest>),
    /// Set properties to a value, or multiply them by a factor
    Set(Later<SetArgs>),
    /// Write down the mass that a model's contacts were made for
    ///
    /// No number changes. OpenSim keeps the note when it scales the model: check SCALED knows then what the contacts were made for
    /// and whether spheres followed their bodies, and SCALED --target-mass KG --follow-bodies moves them without the generic model.
    Note(Later<NoteRequest>),
    /// Change many models, as a table says: one row per model
    Batch(Later<BatchRequest>),
    /// Make a grid of variants of a model, or a ladder of them from soft to stiff
    Sweep(Later<SweepRequest>),
    /// Show what contacts a model has
    Inspect(Later<InspectRequest>),
    /// Compare models with the limits of the paper and the traps of the format
    ///
    /// After OpenSim's Scale Tool: check SCALED --from GENERIC says where each sphere belongs, and prints the transfer SCALED
    /// --from GENERIC --follow-bodies that puts it there. Where the generic model had a note, check SCALED alone is enough.
    Check(Later<CheckRequest>),
    /// Let a model fall on its contacts and see what they do
    DropTest(Later<DropTestRequest>),
    /// Follow the contacts along a recorded motion, beside what force plates measured
    ///
    /// Forces, indentations, slip and impacts of each sphere; the ground reaction of each foot, and how far it is from the plates.
    Motion(Later<MotionRequest>),
    /// Draw what contacts do, as SVG, PDF or PNG
    Plot(Later<PlotRequest>),
    /// Find contact parameters from a measured indentation and force
    Fit(Later<FitRequest>),
    /// Compare Table 1 of the paper with what its equations give, and draw its figures
    Reproduce(Later<ReproduceRequest>),
    /// List presets, or show one
    Presets(Later<PresetsRequest>),
    /// Explain an equation, a quantity, a finding or an error (alone: list them all)
    Explain(Later<ExplainRequest>),
    /// Do what a request says: a verb with its options, as JSON
    Request(Later<RequestArgs>),
    /// Let the shell complete verbs, options and files
    Completions(Later<CompletionsArgs>),
    /// Print the manual page, or write all of them
    Man(Later<ManArgs>),
    /// Print help, or that of one verb
    Help(Later<HelpArgs>),
    /// Print the version
    Version,
}

impl Cli {
    /// The words of the call that means the same, where the verb is one that clap answers as an option.
    pub(crate) fn in_other_words(&self) -> Option<Vec<&str>> {
        const NAME: &str = env!("CARGO_PKG_NAME");
        match self.verb.as_ref()? {
            VerbArgs::Help(args) => Some(match args.0.verb.as_deref() {
                Some(verb) => vec![NAME, verb, "--help"],
                None => vec![NAME, "-h"],
            }),
            VerbArgs::Version => Some(vec![NAME, "--version"]),
            _ => None,
        }
    }
}

/// The parser, and its help in lines of so many columns; `None` if lines have no end.
pub(crate) fn command(columns: Option<usize>) -> Command {
    in_groups(plain_command(), columns)
}

/// The parser without the texts of its help, which most calls do not ask for: it knows what options there are, and neither --help nor -h.
pub(crate) fn bare_command() -> Command {
    with_relations(Cli::command().disable_help_flag(true), Verb::Rescale)
}

/// The parser, with what options need and exclude, and help in the words of the command line. No verb is hidden.
pub(crate) fn plain_command() -> Command {
    let command = with_usual_first(with_relations(Cli::command(), Verb::Rescale), Verb::Rescale);
    in_words_of_the_command(command.after_long_help(exit_statuses()))
}

/// What each exit status says, at the end of the long help.
fn exit_statuses() -> String {
    let line = |status: &ExitStatus| format!("  {:>3}  {}\n", status.code(), status.meaning());
    let lines: String = ExitStatus::ALL.iter().map(line).collect();
    format!("Exit status:\n{lines}\n{}", equations!())
}

/// Checks that the options which were typed go together.
///
/// # Errors
/// The first option that has no effect without another one.
pub(crate) fn check_typed(matches: &ArgMatches) -> Result<(), RequestFault> {
    let (name, typed) = matches.subcommand().unwrap_or((Verb::Rescale.name(), matches));
    Verb::named(name).map_or(Ok(()), |verb| check(typed, verb))
}

// Verbs whose options are put together when the verb is called, so that no start waits for those of all others.

/// The options of a verb.
#[derive(Debug)]
pub(crate) struct Later<T>(pub(crate) Box<T>);

impl<T: FromArgMatches> FromArgMatches for Later<T> {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        T::from_arg_matches(matches).map(|options| Self(Box::new(options)))
    }

    fn from_arg_matches_mut(matches: &mut ArgMatches) -> Result<Self, Error> {
        T::from_arg_matches_mut(matches).map(|options| Self(Box::new(options)))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        self.0.update_from_arg_matches(matches)
    }
}

impl<T: Args> Args for Later<T> {
    fn augment_args(verb: Command) -> Command {
        verb.defer(with_options::<T>)
    }

    fn augment_args_for_update(verb: Command) -> Command {
        Self::augment_args(verb)
    }
}

/// The options, what they need and exclude, and their help in the words of the command line, if the parser has a help.
fn with_options<T: Args>(command: Command) -> Command {
    // The list of verbs says what this one does; the type of its options describes itself.
    let about = Resettable::from(command.get_about().cloned());
    let long_about = Resettable::from(command.get_long_about().cloned());
    let command = T::augment_args(command).about(about).long_about(long_about);
    let has_help = !command.is_disable_help_flag_set();
    let command = match Verb::named(command.get_name()) {
        Some(verb) if has_help => with_usual_first(with_relations(command, verb), verb),
        Some(verb) => with_relations(command, verb),
        None => command,
    };
    if has_help { in_words_of_the_command(command) } else { command }
}

// Arguments of the command alone.

/// Models and assignments in one list of words.
#[derive(Debug, Args)]
pub(crate) struct SetArgs {
    /// Models, and what to set: PROPERTY=VALUE or PROPERTY=xFACTOR
    #[arg(value_name = "MODEL|PROPERTY=VALUE|PROPERTY=xFACTOR", required = true)]
    pub items: Vec<OsString>,
    #[command(flatten)]
    pub request: SetRequest,
}

impl SetArgs {
    /// The request, with the words sorted.
    ///
    /// # Errors
    /// No model, nothing to set, an unknown property or a value that is not a number.
    pub(crate) fn request(self) -> Result<SetRequest> {
        let Self { items, mut request } = self;
        for item in items {
            // A name that is not UTF-8 is no assignment.
            match item.to_str().and_then(|item| item.split_once('=')) {
                Some((name, value)) if !Path::new(&item).exists() => {
                    let new = assignment(name, value).map_err(|why| anyhow!(why))?;
                    request.set.add(new).map_err(|why| anyhow!(why))?;
                }
                _ => request.models.push(PathBuf::from(item)),
            }
        }
        if request.models.is_empty() {
            bail!("no model given, expected one or more .osim files or folders (see set --help)");
        }
        Ok(request)
    }
}

/// Runs one request: the same verbs and options as on the command line, by their names with underscores.
///
/// For programs that would have to quote file names for a shell: {"verb": "rescale", "models": ["my model.osim"],
/// "target_mass": 70}. `schemas/requests` has the schema of each verb's requests.
#[derive(Debug, Args)]
pub(crate) struct RequestArgs {
    /// A JSON object; - is standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Whose names messages have for options: those of requests, or of the functions for MATLAB and GNU Octave
    #[arg(long, value_name = "LANGUAGE", default_value = "json")]
    pub words: Language,
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

/// Prints the help of the program, or of one verb.
#[derive(Debug, Args)]
pub(crate) struct HelpArgs {
    /// The verb [default: the help of the program]
    #[arg(value_parser = help::names(), hide_possible_values = true)]
    pub verb: Option<String>,
}

/// Prints the manual page of the command or of one verb, or writes all pages into a folder.
#[derive(Debug, Args)]
#[command(after_help = "\
On macOS and Linux (NAME is osim-contact-scale):
  to read one   NAME man transfer > page.1; man ./page.1
  to keep all   NAME man -d ~/.local/share/man/man1, then: man NAME-transfer")]
pub(crate) struct ManArgs {
    /// The verb [default: the page of the command]
    #[arg(value_parser = help::names(), hide_possible_values = true)]
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
    use super::*;
    use crate::args::help::GROUPS;

    #[test]
    fn the_command_line_is_consistent() {
        command(None).debug_assert();
    }

    #[test]
    fn every_verb_is_in_one_group() {
        let mut grouped: Vec<&str> = GROUPS.iter().flat_map(|(_, verbs)| verbs.iter().copied()).collect();
        grouped.sort_unstable();
        let command = plain_command();
        let mut verbs: Vec<&str> = command.get_subcommands().map(Command::get_name).collect();
        verbs.sort_unstable();
        assert_eq!(grouped, verbs);
    }
}
