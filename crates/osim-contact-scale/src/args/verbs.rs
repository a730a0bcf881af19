//! The verbs in groups, as the help of the program lists them; clap has one list for all.

use clap::Command;
use clap::builder::{PossibleValuesParser, Styles};
use osim_view::report::layout::broken;

/// What most people come for, with what it does.
const EXAMPLES: [(&str, &str); 3] = [
    ("check MODEL.osim", "say what is wrong, and how to correct it"),
    ("MODEL.osim --target-mass 80", "make its contacts right for 80 kg"),
    ("add MODEL.osim --from OTHER.osim", "give it the contacts of another model"),
];

/// Every verb, in the group that it is looked for in.
const GROUPS: [(&str, &[&str]); 4] = [
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_verb_is_in_one_group() {
        let mut grouped: Vec<&str> = GROUPS.iter().flat_map(|(_, verbs)| verbs.iter().copied()).collect();
        grouped.sort_unstable();
        let command = super::super::plain_command();
        let mut verbs: Vec<&str> = command.get_subcommands().map(Command::get_name).collect();
        verbs.sort_unstable();
        assert_eq!(grouped, verbs);
    }
}
