//! What clap_complete 4.6 leaves out for fish: options after a model where no verb is typed, and values of arguments without a name,
//! such as the kind of a figure.

use std::fmt::Write;

use clap::builder::PossibleValue;
use clap::{Arg, Command};

/// The script with both. Verbs and files are completed without.
pub(super) fn completed(script: &str, command: &Command) -> String {
    let functions = format!("__fish_{}", command.get_name().replace('-', "_"));
    let (needs_verb, without_verb) =
        (format!("{functions}_needs_command"), format!("{functions}_without_verb"));
    let verbs: Vec<&str> = command.get_subcommands().map(Command::get_name).collect();
    let mut completed = String::new();
    for line in script.split_inclusive('\n') {
        let is_option = line.contains(" -l ") && line.starts_with("complete ");
        let condition = |name: &str| format!(" -n \"{name}\"");
        completed.push_str(&match is_option {
            true => line.replacen(&condition(&needs_verb), &condition(&without_verb), 1),
            false => line.to_owned(),
        });
    }
    let name = command.get_name();
    // Writing to a text cannot fail.
    let _ = writeln!(
        completed,
        "\n# Options of a call without a verb come after its models, too.\n\
         function {without_verb}\n    set -l word ({needs_verb})\n    or not contains -- \"$word\" {}\nend\n",
        verbs.join(" ")
    );
    for verb in command.get_subcommands() {
        let files = if takes_files(verb) { "" } else { " -f" };
        for values in verb.get_positionals().map(values).filter(|values| !values.is_empty()) {
            let _ = writeln!(
                completed,
                "complete -c {name} -n \"{functions}_using_subcommand {}\"{files} -a \"{}\"",
                verb.get_name(),
                values.iter().map(entry).collect::<Vec<_>>().join("\n")
            );
        }
    }
    completed
}

/// Whether any argument without a name is not one of a few words.
fn takes_files(verb: &Command) -> bool {
    verb.get_positionals().any(|argument| values(argument).is_empty())
}

fn values(argument: &Arg) -> Vec<PossibleValue> {
    argument.get_value_parser().possible_values().into_iter().flatten().collect()
}

/// A value and what it is, as fish reads them between double quotation marks.
fn entry(value: &PossibleValue) -> String {
    let help = value.get_help().map(ToString::to_string).unwrap_or_default();
    let help = help.replace('\\', "\\\\").replace('\'', "\\'").replace(['"', '$', '\n'], " ");
    format!("{}\\t'{help}'", value.get_name())
}
