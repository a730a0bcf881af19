//! Help in the words of the command line: requests describe their fields by the fields' own names.

use clap::{Arg, Command};
use osim_model::wording::Phrase;

use crate::words::WORDS;

/// The parser with every help text spelled.
pub(crate) fn in_words_of_the_command(command: Command) -> Command {
    command.mut_args(argument).mut_subcommands(in_words_of_the_command)
}

fn argument(argument: Arg) -> Arg {
    let spelled = |text: String| Phrase::template(&text).spelled(WORDS);
    let short = argument.get_help().map(ToString::to_string);
    let long = argument.get_long_help().map(ToString::to_string);
    let heading = argument.get_help_heading().map(str::to_owned);
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
