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
        let name = argument.get_id().to_string();
        all.iter().copied().flatten().fold(argument, |argument, relation| match *relation {
            Relation::Required(field) if field == name => argument.required(true),
            Relation::RequiredUnless(field, other) if field == name => {
                argument.required_unless_present(other)
            }
            Relation::Needs(field, other) if field == name => argument.requires(other),
            Relation::Excludes(field, other) if field == name => argument.conflicts_with(other),
            _ => argument,
        })
    })
}
