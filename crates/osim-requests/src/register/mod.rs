//! The register of options: what each takes, how it is called and shown, and what differs between verbs. The parser of the command
//! line, schemas, tables and spelled calls read it.

mod options;

use std::path::Path;

use osim_model::messages::{Input, Verb};
use serde_json::Value;

use crate::request::Request;
use crate::values::path;
use crate::values::serial::Words;
use options::entry;

/// An option as one verb has it.
#[derive(Debug, Clone, Copy)]
pub struct Entry {
    /// Name of its field in requests.
    pub name: &'static str,
    /// What it is for, in plain words; other fields are in `backticks`.
    pub help: &'static str,
    /// The heading under which the help has it; empty for what this verb alone has.
    pub heading: &'static str,
    pub takes: Takes,
    pub list: List,
    /// What the help calls its value; empty for the name of the option.
    pub value_name: &'static str,
    pub short: Option<char>,
    /// A value may begin with a hyphen, as a negative number does.
    pub is_signed: bool,
    /// Few calls need it: the short help leaves it out.
    pub is_rare: bool,
    /// This verb refuses it, or it changes nothing: the help leaves it out.
    pub is_refused: bool,
    /// What it is about, if it says nothing about contacts.
    pub group: Option<FieldGroup>,
    /// It is about a whole run, and not about one row of a table.
    pub is_of_run: bool,
}

/// What a value is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Takes {
    /// None: the option alone says it.
    Flag,
    /// A number or a text.
    Text,
    /// One of a few words.
    Choice(Words),
    /// The name of a file that is read, of a model, or of a preset.
    FileRead,
    /// The name of a file that is written.
    FileWritten,
    Folder,
    /// Properties, each with its value.
    Assignments,
}

/// How many values there are, and how a command line has several.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum List {
    One,
    /// The option is repeated.
    Repeated,
    /// They are one word, with commas between them.
    Commas,
}

/// What an option is about, if it says nothing about contacts. A front end that has no files, no terminal, or one model at a time
/// leaves such fields out: it asks here, or reads `x-group` in the schema, so that it needs no list of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FieldGroup {
    /// Which files results are written to.
    Output,
    /// Many models at once.
    Many,
    /// How results are shown: on a terminal, and by an exit status.
    Shown,
}

impl FieldGroup {
    /// Its name in schemas.
    #[cfg(feature = "schemas")]
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Output => "output",
            Self::Many => "many",
            Self::Shown => "shown",
        }
    }
}

/// The option of `verb` whose field has this name, if there is such an option.
pub fn option_named(verb: Verb, name: &str) -> Option<Entry> {
    match Input::named(name) {
        Some(input) => entry(Field::Input(input), verb),
        None => entry(Field::Operand(name), verb),
    }
}

/// Whether an input is either so or not, without a value.
pub(crate) fn is_flag(input: Input) -> bool {
    entry(Field::Input(input), Verb::Rescale).is_some_and(|option| option.takes == Takes::Flag)
}

impl Request {
    /// The option that names `file` as one to be read, if any does: standard input, for one, cannot be read twice.
    pub fn option_that_reads(&self, file: &Path) -> Option<&'static str> {
        let file = path::to_value(file);
        let options = self.to_map().into_iter().filter(|(_, value)| match value {
            Value::Array(items) => items.contains(&file),
            value => *value == file,
        });
        let mut options = options.filter_map(|(name, _)| option_named(self.verb(), &name));
        options.find(|option| option.takes == Takes::FileRead).map(|option| option.name)
    }
}

/// What an entry is about: something that messages name, or what only requests have a name for.
#[derive(Clone, Copy)]
enum Field<'n> {
    Input(Input),
    Operand(&'n str),
}

impl Entry {
    pub const fn is_path(&self) -> bool {
        matches!(self.takes, Takes::FileRead | Takes::FileWritten | Takes::Folder)
    }

    pub const fn is_list(&self) -> bool {
        !matches!(self.list, List::One)
    }
}

// How entries are written: `value("KG").signed()`.

impl Entry {
    const fn new(name: &'static str, heading: &'static str, help: &'static str) -> Self {
        Self {
            name,
            help,
            heading,
            takes: Takes::Flag,
            list: List::One,
            value_name: "",
            short: None,
            is_signed: false,
            is_rare: false,
            is_refused: false,
            group: None,
            is_of_run: false,
        }
    }

    const fn flag(self) -> Self {
        self
    }

    const fn value(self, value_name: &'static str) -> Self {
        Self { takes: Takes::Text, value_name, ..self }
    }

    const fn values(self, value_name: &'static str) -> Self {
        self.value(value_name).list_if(true)
    }

    const fn with_commas(self, value_name: &'static str) -> Self {
        Self { list: List::Commas, ..self.value(value_name) }
    }

    const fn choice(self, words: Words) -> Self {
        Self { takes: Takes::Choice(words), ..self }
    }

    const fn read(self, value_name: &'static str) -> Self {
        Self { takes: Takes::FileRead, value_name, ..self }
    }

    const fn written(self, value_name: &'static str) -> Self {
        Self { takes: Takes::FileWritten, value_name, ..self }
    }

    const fn folder(self) -> Self {
        Self { takes: Takes::Folder, value_name: "DIR", ..self }
    }

    const fn assignments(self) -> Self {
        Self { takes: Takes::Assignments, ..self }
    }

    const fn list_if(self, is_list: bool) -> Self {
        if is_list { Self { list: List::Repeated, ..self } } else { self }
    }

    const fn called(self, value_name: &'static str) -> Self {
        Self { value_name, ..self }
    }

    const fn short(self, letter: char) -> Self {
        Self { short: Some(letter), ..self }
    }

    const fn signed(self) -> Self {
        Self { is_signed: true, ..self }
    }

    const fn signed_if(self, is_signed: bool) -> Self {
        Self { is_signed, ..self }
    }

    const fn rare(self) -> Self {
        self.rare_if(true)
    }

    const fn rare_if(self, is_rare: bool) -> Self {
        Self { is_rare, ..self }
    }

    const fn refused_if(self, is_refused: bool) -> Self {
        Self { is_refused, ..self }
    }

    const fn under_if(self, is_there: bool, heading: &'static str) -> Self {
        if is_there { Self { heading, ..self } } else { self }
    }

    const fn about(self, group: FieldGroup) -> Self {
        Self { group: Some(group), ..self }
    }

    const fn of_run(self) -> Self {
        Self { is_of_run: true, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::request::silent_fields;

    /// The options of all verbs that are of a group.
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
            ["data", "force", "geometry_output", "in_place", "no_backup", "output", "output_dir"]
        );
        assert_eq!(options_of(FieldGroup::Many), ["jobs", "resume", "shard", "summary"]);
        assert_eq!(options_of(FieldGroup::Shown), ["ascii", "deny", "diff", "format", "full", "quiet"]);
    }

    #[test]
    fn every_field_of_a_request_has_an_entry() {
        for &verb in Verb::ALL {
            for (name, silent) in silent_fields(verb) {
                let option = option_named(verb, &name).unwrap_or_else(|| panic!("{name}"));
                assert_eq!((option.name, option.takes == Takes::Flag), (&*name, silent.is_boolean()));
                let is_list = option.is_list() || option.takes == Takes::Assignments;
                assert_eq!(is_list, silent.is_array() || silent.is_object(), "{name}");
                assert!(!option.help.is_empty(), "{name}");
            }
        }
    }
}
