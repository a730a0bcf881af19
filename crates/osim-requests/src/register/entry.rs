//! An entry of the register, and how it is written.

use osim_model::messages::Input;

use crate::values::serial::Words;

/// An option as one verb has it.
#[derive(Debug, Clone, Copy)]
pub struct Entry {
    /// Name of the option as a field of requests.
    pub name: &'static str,
    /// Help of the option, in plain words; other fields are in `backticks`.
    pub help: &'static str,
    /// The heading under which the help has it; empty for what this verb alone has.
    pub heading: &'static str,
    pub takes: OptionValue,
    pub list: List,
    /// Name of the value in the help; empty for the name of the option.
    pub value_name: &'static str,
    pub short: Option<char>,
    /// A value may begin with a hyphen, as a negative number does.
    pub is_signed: bool,
    /// Few calls need it: the short help leaves it out.
    pub is_rare: bool,
    /// The verb refuses the option, or the option changes nothing: the help leaves it out.
    pub is_refused: bool,
    /// Subject of the option, if it says nothing about contacts.
    pub group: Option<FieldGroup>,
    /// The option is about a whole run, and not about one row of a table.
    pub is_of_run: bool,
}

/// The kind of value that an option takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OptionValue {
    /// The option has no value: its name alone says it.
    Flag,
    /// A number or any text.
    Text,
    /// One of the words that are listed.
    Choice(Words),
    /// The name of a file that is read, of a model, or of a preset.
    FileRead,
    /// The name of a file that is written.
    FileWritten,
    Folder,
    /// Properties of contacts, each with its value.
    Assignments,
}

/// How many values there are, and how a command line has several.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum List {
    One,
    /// The option is repeated for each value.
    Repeated,
    /// The values are one word, with commas between them.
    Commas,
}

/// Subject of an option that says nothing about contacts. A front end that has no files, no terminal, or one model at a time leaves such
/// fields out: it asks here, or reads `x-group` in the schema, so that it needs no list of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FieldGroup {
    /// Which files results are written to.
    Output,
    /// Work on many models in one call.
    Many,
    /// How results are shown: on a terminal, and by an exit status.
    Shown,
}

impl FieldGroup {
    /// Name of the kind of value in schemas.
    #[cfg(feature = "schemas")]
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Output => "output",
            Self::Many => "many",
            Self::Shown => "shown",
        }
    }
}

/// The field that an entry describes: an input, which messages can name, or an operand, which only requests name.
#[derive(Clone, Copy)]
pub(super) enum Field<'n> {
    Input(Input),
    Operand(&'n str),
}

impl Entry {
    pub const fn is_path(&self) -> bool {
        matches!(self.takes, OptionValue::FileRead | OptionValue::FileWritten | OptionValue::Folder)
    }
}

// How entries are written: `value("KG").signed()`.

impl Entry {
    pub(super) const fn new(name: &'static str, heading: &'static str, help: &'static str) -> Self {
        Self {
            name,
            help,
            heading,
            takes: OptionValue::Flag,
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

    pub(super) const fn flag(self) -> Self {
        self
    }

    pub(super) const fn value(self, value_name: &'static str) -> Self {
        Self { takes: OptionValue::Text, value_name, ..self }
    }

    pub(super) const fn values(self, value_name: &'static str) -> Self {
        self.value(value_name).list_if(true)
    }

    pub(super) const fn with_commas(self, value_name: &'static str) -> Self {
        Self { list: List::Commas, ..self.value(value_name) }
    }

    pub(super) const fn choice(self, words: Words) -> Self {
        Self { takes: OptionValue::Choice(words), ..self }
    }

    pub(super) const fn read(self, value_name: &'static str) -> Self {
        Self { takes: OptionValue::FileRead, value_name, ..self }
    }

    pub(super) const fn written(self, value_name: &'static str) -> Self {
        Self { takes: OptionValue::FileWritten, value_name, ..self }
    }

    pub(super) const fn folder(self) -> Self {
        Self { takes: OptionValue::Folder, value_name: "DIR", ..self }
    }

    pub(super) const fn assignments(self) -> Self {
        Self { takes: OptionValue::Assignments, ..self }
    }

    pub(super) const fn list_if(self, is_list: bool) -> Self {
        if is_list { Self { list: List::Repeated, ..self } } else { self }
    }

    pub(super) const fn called(self, value_name: &'static str) -> Self {
        Self { value_name, ..self }
    }

    pub(super) const fn short(self, letter: char) -> Self {
        Self { short: Some(letter), ..self }
    }

    pub(super) const fn signed(self) -> Self {
        Self { is_signed: true, ..self }
    }

    pub(super) const fn signed_if(self, is_signed: bool) -> Self {
        Self { is_signed, ..self }
    }

    pub(super) const fn rare(self) -> Self {
        self.rare_if(true)
    }

    pub(super) const fn rare_if(self, is_rare: bool) -> Self {
        Self { is_rare, ..self }
    }

    pub(super) const fn refused_if(self, is_refused: bool) -> Self {
        Self { is_refused, ..self }
    }

    pub(super) const fn under_if(self, is_there: bool, heading: &'static str) -> Self {
        if is_there { Self { heading, ..self } } else { self }
    }

    pub(super) const fn about(self, group: FieldGroup) -> Self {
        Self { group: Some(group), ..self }
    }

    pub(super) const fn of_run(self) -> Self {
        Self { is_of_run: true, ..self }
    }
}
