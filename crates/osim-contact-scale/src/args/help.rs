//! Help in the words of the command line: which options it shows, and usage errors in one line.

use clap::builder::{PossibleValuesParser, StyledStr, Styles};
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, Command};
use osim_model::messages::{Input, Phrase, Verb, shown};
use osim_view::report::layout::broken;

use crate::session::WORDS;

/// The parser with the help of its own arguments spelled.
pub(super) fn in_words_of_the_command(command: Command) -> Command {
    command.mut_args(argument)
}

fn argument(argument: Arg) -> Arg {
    let spelled = |text: String| Phrase::template(&text).spelled(WORDS);
    // Most texts name no input: they stay as they are. None is coloured.
    let named = |text: &StyledStr| Some(text.ansi().to_string()).filter(|text| text.contains('`'));
    let short = argument.get_help().and_then(named);
    let long = argument.get_long_help().and_then(named);
    let heading = argument.get_help_heading().filter(|text| text.contains('`')).map(str::to_owned);
    let argument = match short {
        Some(text) => argument.help(spelled(text)),
        None => argument,
    };
    let argument = match long {
        Some(text) => argument.long_help(spelled(text)),
        None => argument,
    };
    match heading {
        Some(text) => argument.help_heading(spelled(text)),
        None => argument,
    }
}

// Which options the help of a verb shows: those that it takes, the usual ones first; rare ones under `--help` alone.

/// After all usual ones under its heading.
const LAST: usize = 1000;

/// Options that groups bring along and that this verb refuses, or that change nothing for it: each is answered where it is typed,
/// and the help does not offer it.
fn refused(verb: Verb) -> &'static [Input] {
    match verb {
        Verb::Transfer => &[Input::ContactsMass, Input::ContactsGravity],
        Verb::Add | Verb::Design | Verb::DropTest => &[Input::ContactsMass],
        Verb::Remove | Verb::Convert => &[Input::GeometryOutput],
        Verb::Batch => &[Input::Output, Input::GeometryOutput],
        Verb::Sweep => &[Input::Stiffness],
        _ => &[],
    }
}

/// Options that few calls need.
fn rare(verb: Verb) -> &'static [Input] {
    match verb {
        Verb::Rescale => {
            &[Input::Exclude, Input::Diff, Input::Only, Input::Keep, Input::BodyScaleFile, Input::Format]
        }
        Verb::Set => &[Input::Exclude, Input::Diff, Input::Only, Input::Keep],
        Verb::Transfer => &[
            Input::Exclude,
            Input::Diff,
            Input::Only,
            Input::Keep,
            Input::StanceLimbs,
            Input::ReferenceSphere,
            Input::BodyScale,
            Input::MovedSpheres,
            Input::Rule,
        ],
        Verb::Add => &[
            Input::Diff,
            Input::StanceLimbs,
            Input::ReferenceSphere,
            Input::Young,
            Input::Poisson,
            Input::Load,
            Input::BodyWeights,
            Input::Gravity,
        ],
        Verb::Design => &[
            Input::Exclude,
            Input::Diff,
            Input::StanceLimbs,
            Input::ContactStiffness,
            Input::Young,
            Input::Poisson,
            Input::Threshold,
            Input::StateWidth,
            Input::SpeedWidth,
        ],
        Verb::Sweep => &[
            Input::Exclude,
            Input::StanceLimbs,
            Input::Soft,
            Input::Quiet,
            Input::Load,
            Input::BodyWeights,
            Input::Gravity,
            Input::ContactStiffness,
            Input::Young,
            Input::Poisson,
            Input::Threshold,
            Input::StateWidth,
            Input::SpeedWidth,
            Input::ConstantIndentation,
            Input::ContactsMass,
        ],
        Verb::Batch => &[Input::Diff],
        Verb::Inspect | Verb::Check => {
            &[Input::Exclude, Input::StanceLimbs, Input::ImpactSpeed, Input::Gravity, Input::BodyScaleFile]
        }
        Verb::DropTest => &[Input::Exclude, Input::StanceLimbs, Input::Samples, Input::CompareSpheres],
        Verb::Plot => &[
            Input::Exclude,
            Input::StanceLimbs,
            Input::Duration,
            Input::ContactsMass,
            Input::XColumn,
            Input::YColumn,
            Input::ValueRange,
        ],
        Verb::Motion => &[Input::Exclude, Input::ContactsMass],
        Verb::Fit => &[
            Input::SpeedColumn,
            Input::TimeColumn,
            Input::SpeedUnit,
            Input::TimeUnit,
            Input::Branch,
            Input::Exclude,
            Input::ContactsMass,
            Input::Diff,
            Input::Format,
            Input::OutputDir,
            Input::InPlace,
        ],
        _ => &[],
    }
}

/// What an option is for this verb, where the help of its group is about another.
fn reworded(verb: Verb, name: &str) -> Option<&'static str> {
    let is_radius_of_transfer = verb == Verb::Transfer && name == Input::Radius.name();
    is_radius_of_transfer.then_some(
        "Radii: keep, isometric (as large against the body as the reference's), a radius in metres, or a factor like x1.5 \
         [default: keep]",
    )
}

/// The parser of `verb` with a help of what it takes.
pub(super) fn with_usual_first(command: Command, verb: Verb) -> Command {
    let is_in = |inputs: &[Input], name: &str| inputs.iter().any(|input| input.name() == name);
    command.mut_args(|argument| {
        let name = argument.get_id().as_str().to_owned();
        let is_rare = is_in(rare(verb), &name) || argument.is_hide_short_help_set();
        let argument = if is_rare { argument.hide_short_help(true).display_order(LAST) } else { argument };
        let argument = match reworded(verb, &name) {
            Some(help) => argument.help(help).long_help(help),
            None => argument,
        };
        if is_in(refused(verb), &name) { argument.hide(true) } else { argument }
    })
}

// A usage error in one line.

/// A usage error in one line: what is wrong and what was expected.
pub(crate) fn usage_line(error: &clap::Error) -> String {
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
    if let (ErrorKind::InvalidValue, Some(value), Some(option), Some(near)) = (
        error.kind(),
        context(ContextKind::InvalidValue),
        context(ContextKind::InvalidArg),
        context(ContextKind::SuggestedValue),
    ) {
        // A value without an option is named by what it is alone.
        let option = match option.split(' ').next() {
            Some(name) if name.starts_with('-') => format!("{name} "),
            _ => String::new(),
        };
        return format!("{option}'{}': did you mean '{near}'?", shown(&value));
    }
    let text = error.render().to_string();
    let mut lines = text.lines().map(str::trim_ascii).filter(|line| !line.is_empty());
    let first = lines.next().unwrap_or_default().trim_start_matches("error: ").to_owned();
    let rest: Vec<&str> = lines
        .take_while(|line| !line.starts_with("Usage:") && !line.starts_with("For more"))
        .map(|line| line.trim_start_matches("tip: "))
        // Nobody who misspells an option wants it to be a file.
        .filter(|line| !line.contains("as a value, use '--"))
        .collect();
    let joint = if first.ends_with(':') { " " } else { "; " };
    let line = if rest.is_empty() { first } else { format!("{first}{joint}{}", rest.join(", ")) };
    Phrase::from(line).to_string()
}

// The verbs in groups, as the help of the program lists them; clap has one list for all.

/// What most people come for, with what it does.
const EXAMPLES: [(&str, &str); 3] = [
    ("check MODEL.osim", "say what is wrong, and how to correct it"),
    ("MODEL.osim --target-mass 80", "make its contacts right for 80 kg"),
    ("add MODEL.osim --from OTHER.osim", "give it the contacts of another model"),
];

/// Every verb, in the group that it is looked for in.
pub(super) const GROUPS: [(&str, &[&str]); 4] = [
    ("Change models", &["rescale", "transfer", "add", "remove", "convert", "design", "set", "note", "batch"]),
    ("Look at models", &["check", "inspect", "plot"]),
    ("Study", &["sweep", "drop-test", "motion", "fit", "reproduce"]),
    ("More", &["explain", "presets", "request", "completions", "man", "help", "version"]),
];

/// The options of a call without a verb that its short help shows: rescale has them all.
const SHOWN: [&str; 8] =
    ["models", "target_mass", "contacts_mass", "output", "in_place", "dry_run", "report", "help"];

/// Lines are no longer than clap makes them.
const LONGEST: usize = 100;

/// The parser with a help that shows examples first, and the verbs in groups.
pub(super) fn in_groups(command: Command, columns: Option<usize>) -> Command {
    let width = columns.map_or(LONGEST, |columns| columns.min(LONGEST));
    let header = *Styles::styled().get_header();
    let name = command.get_name();
    let lines: Vec<String> = EXAMPLES
        .iter()
        .map(|(words, what)| format!("  {:<53}  {what}\n", format!("{name} {words}")))
        .collect();
    let examples: String = if lines.iter().all(|line| line.trim_ascii_end().len() <= width) {
        lines.concat()
    } else {
        EXAMPLES.iter().map(|(words, what)| format!("  {name} {words}\n      {what}\n")).collect()
    };
    let line = |verb: &str| {
        let about = command.find_subcommand(verb).and_then(Command::get_about);
        let about = about.map(ToString::to_string).unwrap_or_default();
        broken(&format!("  {verb:<11}  {about}\n"), width)
    };
    let groups = GROUPS.map(|(group, verbs)| {
        let lines: String = verbs.iter().map(|verb| line(verb)).collect();
        format!("{header}{group}:{header:#}\n{lines}")
    });
    let template = format!(
        "{{about-with-newline}}\n{header}Examples:{header:#}\n{examples}\n{{usage-heading}} {{usage}}\n\n{}\n{{all-args}}{{after-help}}",
        groups.join("\n")
    );
    // What is hidden is in no list of clap's; it is found all the same.
    command.help_template(template).mut_subcommands(|verb| verb.hide(true)).mut_args(|argument| {
        let is_shown = SHOWN.contains(&argument.get_id().as_str());
        if is_shown { argument } else { argument.hide_short_help(true) }
    })
}

/// The names of all verbs, as values of an argument.
pub(super) fn names() -> PossibleValuesParser {
    PossibleValuesParser::new(GROUPS.iter().flat_map(|(_, verbs)| verbs.iter().copied()))
}
