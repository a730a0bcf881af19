//! Requests from the words of a command line, read by clap.

use clap::Command;
use osim_model::wording::Verb;

use crate::relation::Relation;
use crate::request::relations_of;

/// Teaches the parser of a verb how its options depend on each other: the same rules as for dictionaries.
#[must_use]
pub fn with_relations(command: Command, verb: Verb) -> Command {
    let all = relations_of(verb);
    command.mut_args(|argument| {
        let name = argument.get_id().clone();
        // Arguments are large, and each step moves one: only its own relations take part.
        let own = all.iter().copied().flatten().filter(|relation| name == relation.field());
        own.fold(argument, |argument, relation| match *relation {
            Relation::Required(_) => argument.required(true),
            Relation::Expected(_) => argument,
            Relation::RequiredUnless(_, other) => argument.required_unless_present(other),
            Relation::Needs(_, other) => argument.requires(other),
            Relation::Excludes(_, other) => argument.conflicts_with(other),
        })
    })
}
