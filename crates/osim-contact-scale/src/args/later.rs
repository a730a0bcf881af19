//! Verbs whose options are put together when the verb is called, so that no start waits for those of all others.

use clap::builder::Resettable;
use clap::{ArgMatches, Args, Command, Error, FromArgMatches};
use osim_model::messages::Verb;
use osim_requests::command_line::with_relations;

use super::help::in_words_of_the_command;
use super::usual::with_usual_first;

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
    let verb = Verb::ALL.iter().copied().find(|verb| verb.name() == command.get_name());
    let has_help = !command.is_disable_help_flag_set();
    let command = match verb {
        Some(verb) if has_help => with_usual_first(with_relations(command, verb), verb),
        Some(verb) => with_relations(command, verb),
        None => command,
    };
    if has_help { in_words_of_the_command(command) } else { command }
}
