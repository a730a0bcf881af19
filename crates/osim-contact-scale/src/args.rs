//! Parses the command line: verbs, each with the options of the register. Also the program's help, and usage errors in one line.

use std::path::{Path, PathBuf};

use clap::builder::{PossibleValuesParser, Styles};
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, ArgAction, ArgMatches, Command, FromArgMatches, Subcommand};
use osim_model::messages::{Input, Phrase, Verb, shown};
use osim_model::nearest_names;
use osim_requests::command_line::{read, with_options};
use osim_requests::register::option_named;
use osim_requests::{Request, RequestFault, VerbEntry, VerbGroup, verb_entry};
use osim_view::report::ExitStatus;
use osim_view::report::layout::break_long_lines;

use crate::one_call::{COMMAND_LINE_WORDS, Language};

/// Source of the equations, as a literal text.
macro_rules! equations {
    () => {
        "Equations: Van Bijlert (2026), doi:10.1016/j.jbiomech.2026.113420"
    };
}

/// The name of the program on the command line.
pub(crate) const PROGRAM_NAME: &str = env!("CARGO_PKG_NAME");

/// How the program is called, in the help of a call without a verb.
const USAGE: &str = concat!("osim-contact-scale [OPTIONS] [MODEL]...\n", "       osim-contact-scale <VERB>");

/// The purpose of the program, in one line of the help.
const ABOUT_PROGRAM: &str = "Makes the contact parameters of OpenSim models right at every body size";

/// The text of the long help about a call without a verb.
const DETAILS_OF_HELP: &str = "Rescales the contacts of MODEL from the mass they were made for to --target-mass; with a verb, does something else. \
                       MODEL alone is inspected.";

/// What the user asked for on the command line: a request, or a verb that only the command has.
pub(crate) enum Call {
    Own(OwnVerb),
    Request(Request),
    /// Models and options of a rescale, without its name.
    WithoutVerb(Request),
}

/// The end of the help of `completions`.
const COMPLETIONS_HELP: &str = "\
Where to put it (NAME is osim-contact-scale):
  bash        NAME completions bash > ~/.local/share/bash-completion/completions/NAME
              (the folder must be there: mkdir -p; needs the package bash-completion)
  zsh         NAME completions zsh > FOLDER/_NAME, with FOLDER a folder of $fpath
  fish        NAME completions fish > ~/.config/fish/completions/NAME.fish
  PowerShell  add this line to the file that $PROFILE names:
              NAME completions powershell | Out-String | Invoke-Expression
  elvish      NAME completions elvish > ~/.config/elvish/lib/NAME.elv,
              and the line 'use NAME' in ~/.config/elvish/rc.elv
Then open a new terminal.";

/// The end of the help of `man`.
const MANUAL_HELP: &str = "\
On macOS and Linux (NAME is osim-contact-scale):
  to read one   NAME man transfer > page.1; man ./page.1
  to keep all   NAME man -d ~/.local/share/man/man1, then: man NAME-transfer";

/// Verbs that only the command has, such as `completions`, and no other front end.
#[derive(Debug, Subcommand)]
pub(crate) enum OwnVerb {
    /// Do what a request says: a verb with its options, as JSON
    Request {
        /// A JSON object; - is standard input
        #[arg(value_name = "FILE")]
        file: PathBuf,
        /// Whose names messages have for options: those of requests, or of the functions for MATLAB and GNU Octave
        #[arg(long, value_name = "LANGUAGE", default_value = "json")]
        words: Language,
    },
    /// Let the shell complete verbs, options and files
    #[command(after_help = COMPLETIONS_HELP)]
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
    /// Print the manual page, or write all of them
    #[command(after_help = MANUAL_HELP)]
    Man {
        /// The verb [default: the page of the command]
        #[arg(value_parser = verb_names_as_values(), hide_possible_values = true)]
        verb: Option<String>,
        /// Write all pages into this folder
        #[arg(short = 'd', long, value_name = "DIR", conflicts_with = "verb")]
        output_dir: Option<PathBuf>,
        /// Replace existing files
        #[arg(long, requires = "output_dir")]
        force: bool,
    },
    /// Print help, or that of one verb
    Help {
        /// The verb [default: the help of the program]
        #[arg(value_parser = verb_names_as_values(), hide_possible_values = true)]
        verb: Option<String>,
    },
    /// Print the version
    Version,
}

impl OwnVerb {
    /// The arguments of an equal call with `--help` or `--version`, which clap answers itself; `None` for verbs other than `help` and
    /// `version`.
    pub(crate) fn as_call_that_clap_answers(&self) -> Option<Vec<&str>> {
        match self {
            Self::Help { verb: Some(verb) } => Some(vec![PROGRAM_NAME, verb, "--help"]),
            Self::Help { verb: None } => Some(vec![PROGRAM_NAME, "-h"]),
            Self::Version => Some(vec![PROGRAM_NAME, "--version"]),
            _ => None,
        }
    }
}

/// The names of all verbs of the command, those of requests first.
pub(crate) fn verb_names() -> impl Iterator<Item = &'static str> {
    Verb::ALL.iter().map(|verb| verb.name()).chain(VERBS_OF_COMMAND_ALONE)
}

// The parser: most calls need one verb, and no texts of help.

/// The parser for the verb that the `first` argument names, or for a call without a verb. It knows neither `--help` nor `-h`.
pub(crate) fn bare_command(first: Option<&str>) -> Command {
    let command = command_without_verbs().disable_help_flag(true);
    match first.and_then(Verb::find) {
        Some(verb) => {
            let verb = with_options(Command::new(verb.name()).disable_help_flag(true), verb);
            command.subcommand(with_quiet(verb))
        }
        None if first.is_some_and(OwnVerb::has_subcommand) => {
            OwnVerb::augment_subcommands(command).mut_subcommands(with_quiet)
        }
        None => with_options(command, Verb::Rescale),
    }
}

/// The parser with the options of one verb. Lines of the help have at most `columns` letters; `None` breaks no lines.
pub(crate) fn command(columns: Option<usize>, verb: Option<&str>) -> Command {
    with_grouped_help(command_listing_verbs(|listed| Some(listed.name()) == verb), columns)
}

/// The parser with the options of all verbs, none of them hidden.
pub(crate) fn whole_command() -> Command {
    command_listing_verbs(|_| true)
}

/// The parser with all verbs, and the options of those for which `has_options` is true.
fn command_listing_verbs(has_options: impl Fn(Verb) -> bool) -> Command {
    let verbs = Verb::ALL.iter().map(|&verb| {
        let VerbEntry { about, details, .. } = verb_entry(verb);
        let command = Command::new(verb.name()).about(about);
        let command = match details {
            "" => command,
            details => command
                .long_about(format!("{about}\n\n{}", Phrase::template(details).spelled(COMMAND_LINE_WORDS))),
        };
        if has_options(verb) { with_options(command, verb) } else { command }
    });
    let command = command_without_verbs().subcommands(verbs);
    with_options(OwnVerb::augment_subcommands(command).mut_subcommands(with_quiet), Verb::Rescale)
        .about(ABOUT_PROGRAM)
        .long_about(format!("{ABOUT_PROGRAM}.\n\n{DETAILS_OF_HELP}"))
        .after_help(concat!("More options with --help. ", equations!()))
        .after_long_help(exit_statuses())
}

/// The argument `--quiet` of verbs whose requests have no such field: it concerns only what the command prints.
const QUIET_ARGUMENT_OF_COMMAND: &str = "quiet-command";

/// The parser of a verb with `--quiet`.
fn with_quiet(command: Command) -> Command {
    let is_there = command.get_arguments().any(|argument| argument.get_id() == Input::Quiet.name());
    let Some(option) = option_named(Verb::Rescale, Input::Quiet.name()).filter(|_| !is_there) else {
        return command;
    };
    let quiet = Arg::new(QUIET_ARGUMENT_OF_COMMAND).short(option.short).long(option.name);
    // Where the short help has all options, this one is there, too.
    let is_rare = command.get_arguments().any(Arg::is_hide_short_help_set);
    let quiet = quiet.action(ArgAction::SetTrue).help(option.help).help_heading(option.heading);
    command.arg(quiet.hide_short_help(is_rare).display_order(1000))
}

/// Whether `--quiet` was typed.
pub(crate) fn is_quiet(matches: &ArgMatches) -> bool {
    let typed = matches.subcommand().map_or(matches, |(_, typed)| typed);
    let is_typed = |id: &str| typed.try_get_one::<bool>(id).ok().flatten() == Some(&true);
    is_typed(QUIET_ARGUMENT_OF_COMMAND) || is_typed(Input::Quiet.name())
}

fn command_without_verbs() -> Command {
    Command::new(PROGRAM_NAME)
        .version(env!("CARGO_PKG_VERSION"))
        .override_usage(USAGE)
        .args_conflicts_with_subcommands(true)
        .arg_required_else_help(true)
        .disable_help_subcommand(true)
}

/// Meanings of the exit statuses, for the end of the long help.
fn exit_statuses() -> String {
    let line = |status: &ExitStatus| format!("  {:>3}  {}\n", status.code(), status.meaning());
    let lines: String = ExitStatus::ALL.iter().map(line).collect();
    format!("Exit status:\n{lines}\n{}", equations!())
}

/// The call that the user typed, read from the options and values that the parser found.
///
/// # Errors
/// The outer error comes from clap; the inner error is about options that do not go together.
pub(crate) fn typed_call(matches: &ArgMatches) -> Result<Result<Call, RequestFault>, clap::Error> {
    let is_file = Path::exists;
    Ok(match matches.subcommand() {
        None => read(Verb::Rescale, matches, is_file).and_then(with_models).map(Call::WithoutVerb),
        Some((name, typed)) => match Verb::find(name) {
            Some(verb) => read(verb, typed, is_file).and_then(with_models).map(Call::Request),
            None => Ok(Call::Own(OwnVerb::from_arg_matches(matches)?)),
        },
    })
}

/// Refuses a change without models where the parser does not: models and values to set share one list of arguments, and a call without a
/// verb may have none.
fn with_models(request: Request) -> Result<Request, RequestFault> {
    let models = match &request {
        Request::Rescale(rescale) => Some(&rescale.models),
        Request::Set(set) => Some(&set.models),
        Request::Note(note) => Some(&note.models),
        _ => None,
    };
    if models.is_some_and(Vec::is_empty) {
        let text = "no model given, expected one or more .osim files or folders (see --help)";
        return Err(RequestFault::general(text));
    }
    Ok(request)
}

// A usage error in one line.

/// Options of other programs, with those of this one.
const OPTIONS_OF_OTHER_PROGRAMS: [(&[&str], &str); 3] = [
    (&["--overwrite", "--replace"], "--force"),
    (&["--json"], "--format json"),
    (&["--generic", "--reference", "--preset"], "--from"),
];

/// A usage error in one line: what is wrong and what was expected. `words` are all arguments of the call.
pub(crate) fn usage_line(error: &clap::Error, words: &[String]) -> String {
    let context = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text.clone()),
        _ => None,
    };
    let from_parser = std::error::Error::source(error).map(ToString::to_string);
    if error.kind() == ErrorKind::ValueValidation
        && let (Some(value), Some(option), Some(reason)) =
            (context(ContextKind::InvalidValue), context(ContextKind::InvalidArg), from_parser)
    {
        let option = option.split(' ').next().unwrap_or_default().to_owned();
        return format!("{option} '{}': {reason}", shown(&value));
    }
    // clap finds `zsh` near to `tcsh`.
    let value = context(ContextKind::InvalidValue).unwrap_or_default();
    let is_near =
        |near: &String| begins_alike(near, &value) || !nearest_names(&value, [near.as_str()], 2).is_empty();
    if error.kind() == ErrorKind::InvalidValue
        && let Some(option) = context(ContextKind::InvalidArg)
        && let Some(near) = context(ContextKind::SuggestedValue).filter(is_near)
    {
        // A value without an option is named by what it is alone.
        let name = option.split(' ').next().filter(|name| name.starts_with('-'));
        let option = name.map(|name| format!("{name} ")).unwrap_or_default();
        return format!("{option}'{}': did you mean '{near}'?", shown(&value));
    }
    let option = context(ContextKind::InvalidArg).filter(|_| error.kind() == ErrorKind::UnknownArgument);
    let mut known = OPTIONS_OF_OTHER_PROGRAMS.iter();
    let typed = option.as_deref().unwrap_or_default();
    if let Some((_, meant)) = known.find(|(others, _)| others.contains(&typed)) {
        return format!("unexpected argument '{typed}' found: did you mean {meant}?");
    }
    let verbs = option.and_then(|option| Some(verbs_with_option(option.strip_prefix("--")?)));
    let text = error.render().to_string();
    let mut lines = text.lines().map(str::trim_ascii).filter(|line| !line.is_empty());
    let first = lines.next().unwrap_or_default().trim_start_matches("error: ").to_owned();
    let rest: Vec<&str> = lines
        .take_while(|line| !line.starts_with("Usage:") && !line.starts_with("For more"))
        .map(|line| line.trim_start_matches("tip: "))
        // Nobody who misspells an option wants it to be a file.
        .filter(|line| !line.contains("as a value, use '--") && !line.starts_with("a similar value exists"))
        .collect();
    if let Some(verbs) = verbs.filter(|verbs| !verbs.is_empty()) {
        let has_verb = words.first().is_some_and(|first| verb_names().any(|name| name == first));
        let note = if has_verb { "" } else { " (a verb is the first word)" };
        return format!("{first}: it is an option of {verbs}{note}");
    }
    let joint = if first.ends_with(':') { " " } else { "; " };
    let line = if rest.is_empty() { first } else { format!("{first}{joint}{}", rest.join(", ")) };
    Phrase::from(line).to_string()
}

/// The message about an option with one hyphen, such as `-from`, which the parser reads as `-f rom`, or with the dash of a word processor,
/// which makes it a model; `None` for other words.
pub(crate) fn message_about_dashes(word: &str) -> Option<String> {
    let dashes = ['-', '–', '—', '−'];
    let name = word.trim_start_matches(dashes).split('=').next()?;
    let is_odd = word.starts_with(dashes) && !word.starts_with("--") && name.len() > 1;
    let what = "does not begin with two hyphens: did you mean";
    (is_odd && (name == "version" || !verbs_with_option(name).is_empty()))
        .then(|| format!("'{}' {what} --{name}? (see --help)", shown(word)))
}

/// The names of the verbs that have an option.
fn verbs_with_option(option: &str) -> String {
    let has_option = |verb: &&Command| verb.get_arguments().any(|one| one.get_long() == Some(option));
    let command = whole_command();
    let verbs = command.get_subcommands().filter(has_option).map(Command::get_name);
    verbs.collect::<Vec<_>>().join(", ")
}

// The verbs in groups, as the help of the program lists them; clap has one list for all.

/// Examples of the most frequent calls, each with a description.
const EXAMPLES_OF_HELP: [(&str, &str); 3] = [
    ("check SCALED.osim --from GENERIC.osim", "say what to correct after scaling"),
    ("MODEL.osim --target-mass 80", "make its contacts right for 80 kg"),
    ("add MODEL.osim --from OTHER.osim", "give it the contacts of another model"),
];

/// The names of the command's own verbs, in their order.
const VERBS_OF_COMMAND_ALONE: [&str; 5] = ["request", "completions", "man", "help", "version"];

/// The verbs of a group, in the order of the help.
fn verbs_of(group: VerbGroup) -> impl Iterator<Item = &'static str> {
    let own: &[&str] = if group == VerbGroup::More { &VERBS_OF_COMMAND_ALONE } else { &[] };
    group.verbs().map(Verb::name).chain(own.iter().copied())
}

/// Options in the short help of a call without a verb. The help of `rescale` has all options.
const OPTIONS_OF_SHORT_HELP: [&str; 8] =
    ["models", "target_mass", "contacts_mass", "output", "in_place", "dry_run", "report", "help"];

/// Most letters in a line of the help, as in the help that clap lays out.
const LONGEST_LINE: usize = 100;

/// The parser with a help that shows examples first, and the verbs in groups.
fn with_grouped_help(command: Command, columns: Option<usize>) -> Command {
    let width = columns.map_or(LONGEST_LINE, |columns| columns.min(LONGEST_LINE));
    let header = *Styles::styled().get_header();
    let name = command.get_name();
    let lines: Vec<String> = EXAMPLES_OF_HELP
        .iter()
        .map(|(words, what)| format!("  {:<57}  {what}\n", format!("{name} {words}")))
        .collect();
    let examples: String = if lines.iter().all(|line| line.trim_ascii_end().len() <= width) {
        lines.concat()
    } else {
        EXAMPLES_OF_HELP.iter().map(|(words, what)| format!("  {name} {words}\n      {what}\n")).collect()
    };
    let line = |verb: &str| {
        let about = command.find_subcommand(verb).and_then(Command::get_about);
        let about = about.map(ToString::to_string).unwrap_or_default();
        break_long_lines(&format!("  {verb:<11}  {about}\n"), width)
    };
    let groups = VerbGroup::ALL.iter().map(|&group| {
        let lines: String = verbs_of(group).map(line).collect();
        format!("{header}{}:{header:#}\n{lines}", group.as_str())
    });
    let template = format!(
        "{{about-with-newline}}\n{header}Examples:{header:#}\n{examples}\n{{usage-heading}} {{usage}}\n\n{}\n{{all-args}}{{after-help}}",
        groups.collect::<Vec<_>>().join("\n")
    );
    // What is hidden is in no list of clap's; it is found all the same.
    command.help_template(template).mut_subcommands(|verb| verb.hide(true)).mut_args(|argument| {
        let is_shown = OPTIONS_OF_SHORT_HELP.contains(&argument.get_id().as_str());
        if is_shown { argument } else { argument.hide_short_help(true) }
    })
}

/// The names of all verbs, as values of an argument.
fn verb_names_as_values() -> PossibleValuesParser {
    PossibleValuesParser::new(VerbGroup::ALL.iter().copied().flat_map(verbs_of))
}

/// Whether one of two words begins with the other, in capital or small letters and with or without hyphens.
pub(crate) fn begins_alike(one: &str, other: &str) -> bool {
    let [one, other] = [one, other].map(|text| text.to_lowercase().replace(['-', '_'], ""));
    one.starts_with(&other) || other.starts_with(&one)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_consistent() {
        whole_command().debug_assert();
    }

    #[test]
    fn every_verb_is_listed() {
        let command = whole_command();
        let verbs: Vec<&str> = command.get_subcommands().map(Command::get_name).collect();
        assert_eq!(verbs, verb_names().collect::<Vec<_>>());
        let listed = VerbGroup::ALL.iter().copied().flat_map(VerbGroup::verbs).count();
        assert_eq!(listed, Verb::ALL.len());
    }
}
