//! The help of the program, and usage errors in one line.

use clap::Command;
use clap::builder::{PossibleValuesParser, Styles};
use clap::error::{ContextKind, ContextValue, ErrorKind};
use osim_model::messages::{Phrase, Verb, shown};
use osim_requests::VerbGroup;
use osim_view::report::layout::broken;

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

/// The names of the command's own verbs, in their order.
pub(super) const OWN_VERBS: [&str; 5] = ["request", "completions", "man", "help", "version"];

/// The verbs of a group, in the order of the help.
fn verbs_of(group: VerbGroup) -> impl Iterator<Item = &'static str> {
    let own: &[&str] = if group == VerbGroup::More { &OWN_VERBS } else { &[] };
    group.verbs().map(Verb::name).chain(own.iter().copied())
}

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
    let groups = VerbGroup::ALL.map(|group| {
        let lines: String = verbs_of(group).map(line).collect();
        format!("{header}{}:{header:#}\n{lines}", group.heading())
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
    PossibleValuesParser::new(VerbGroup::ALL.into_iter().flat_map(verbs_of))
}
