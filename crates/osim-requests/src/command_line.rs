//! Requests from the words of a command line, read by clap.

use clap::parser::ValueSource;
use clap::{ArgMatches, Command};
use osim_model::messages::Verb;

use crate::dictionary;
use crate::fault::{Relation, RequestFault};
use crate::request::relations_of;

/// Teaches the parser of a verb which options are required and which exclude each other: the same rules as for dictionaries.
/// What an option [needs](check) it is not taught: clap forgets that where the other one is excluded by a third.
pub fn with_relations(command: Command, verb: Verb) -> Command {
    let all = relations_of(verb);
    command.mut_args(|argument| {
        let name = argument.get_id().clone();
        // Arguments are large, and each step moves one: only its own relations take part.
        let own = all.iter().copied().flatten().filter(|relation| name == relation.field());
        own.fold(argument, |argument, relation| match *relation {
            Relation::Required(_) => argument.required(true),
            Relation::Expected(_) | Relation::ExpectedUnless(..) | Relation::Needs(..) => argument,
            Relation::RequiredUnless(_, other) => argument.required_unless_present(other),
            Relation::Excludes(_, other) => argument.conflicts_with(other),
        })
    })
}

/// Checks that the options which were typed for a verb go together, as a dictionary is checked.
///
/// # Errors
/// The first that has no meaning without another.
pub fn check(matches: &ArgMatches, verb: Verb) -> Result<(), RequestFault> {
    let typed = |id: &str| matches.value_source(id) == Some(ValueSource::CommandLine);
    let typed: Vec<&str> = matches.ids().map(clap::Id::as_str).filter(|id| typed(id)).collect();
    let needs = |relation: &Relation| matches!(relation, Relation::Needs(..));
    let relations = relations_of(verb).iter().copied().flatten().copied().filter(needs);
    dictionary::check_relations(|field| typed.contains(&field), relations)
}
