//! The register of options: their values, names, texts, and differences between verbs. The parser of the command line, schemas,
//! tables and spelled calls read it.

mod entry;
mod options;

use std::path::Path;

use osim_model::messages::{Input, Verb};
use serde_json::Value;

use crate::request::Request;
use crate::values::path;
use entry::Field;
pub use entry::{Entry, FieldGroup, List, OptionValue};
use options::entry_of;

/// The option of `verb` for the field `name`; `None` if there is no such option.
pub fn option_named(verb: Verb, name: &str) -> Option<Entry> {
    match Input::find(name) {
        Some(input) => entry_of(Field::Input(input), verb),
        None => entry_of(Field::Operand(name), verb),
    }
}

/// The option of an input in what all verbs have in common: its names, and whether it takes a value.
pub(crate) fn option_for(input: Input) -> Option<Entry> {
    entry_of(Field::Input(input), Verb::Rescale)
}

/// Whether an input is a flag: given or not given, without a value.
pub(crate) fn is_flag(input: Input) -> bool {
    option_for(input).is_some_and(|option| option.takes == OptionValue::Flag)
}

impl Request {
    /// The name of the option that reads `file`, if there is one. It matters for standard input, which cannot be read twice.
    pub fn option_that_reads(&self, file: &Path) -> Option<&'static str> {
        let file = path::to_value(file);
        let options = self.to_map().into_iter().filter(|(_, value)| match value {
            Value::Array(items) => items.contains(&file),
            value => *value == file,
        });
        let mut options = options.filter_map(|(name, _)| option_named(self.verb(), &name));
        options.find(|option| option.takes == OptionValue::FileRead).map(|option| option.name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::request::{silent_fields, verb_entry};

    /// The names of the options of all verbs in a group.
    fn options_of(group: FieldGroup) -> Vec<&'static str> {
        let options = Verb::ALL.iter().flat_map(|&verb| {
            silent_fields(verb).into_iter().filter_map(move |(name, _)| option_named(verb, &name))
        });
        let mut names: Vec<&str> =
            options.filter(|option| option.group == Some(group)).map(|option| option.name).collect();
        names.sort_unstable();
        names.dedup();
        names
    }

    #[test]
    fn every_group_has_options() {
        assert_eq!(
            options_of(FieldGroup::Output),
            ["data", "fix", "force", "geometry_output", "in_place", "no_backup", "output", "output_dir"]
        );
        assert_eq!(options_of(FieldGroup::Many), ["jobs", "resume", "shard", "summary"]);
        assert_eq!(options_of(FieldGroup::Shown), ["ascii", "deny", "diff", "format", "full", "quiet"]);
    }

    #[test]
    fn every_field_of_a_request_has_an_entry() {
        for &verb in Verb::ALL {
            for (name, silent) in silent_fields(verb) {
                let option = option_named(verb, &name).unwrap_or_else(|| panic!("{name}"));
                assert_eq!((option.name, option.takes == OptionValue::Flag), (&*name, silent.is_boolean()));
                let is_list = option.list != List::One || option.takes == OptionValue::Assignments;
                assert_eq!(is_list, silent.is_array() || silent.is_object(), "{name}");
                assert!(!option.help.is_empty(), "{name}");
                // What the parser takes more than once says so, and nothing else does.
                let is_repeated =
                    option.list == List::Repeated && !verb_entry(verb).positional.contains(&&*name);
                let says_so = ["may be repeated", "one for each motion", "once for each"];
                assert_eq!(is_repeated, says_so.iter().any(|words| option.help.contains(words)), "{name}");
            }
        }
    }
}
