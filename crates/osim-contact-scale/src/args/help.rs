//! Help in the words of the command line: requests describe their fields by the fields' own names.

use clap::builder::StyledStr;
use clap::{Arg, Command};
use osim_model::messages::Phrase;

use crate::words::WORDS;

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
