//! An entry of the register: an option, with its help text and the form of its values.

use osim_model::messages::{Input, named};

use crate::values::serial::Words;

/// An option as it is in the register for one verb.
#[derive(Debug, Clone, Copy)]
pub struct Entry {
    /// Name of the option as a field of requests.
    pub name: &'static str,
    /// Help of the option, in plain words; other fields are in `backticks`.
    pub help: &'static str,
    /// The heading of the option in the help; empty for an option that only this verb has.
    pub heading: &'static str,
    pub takes: OptionValue,
    pub list: List,
    /// Name of the value in the help; if empty, the name of the option is used.
    pub value_name: &'static str,
    pub short: Option<char>,
    /// Whether a value may begin with a hyphen, as a negative number does.
    pub is_signed: bool,
    /// Whether few calls need the option: the short help omits it.
    pub is_rare: bool,
    /// Whether the verb refuses the option, or ignores it: the help omits it.
    pub is_refused: bool,
    /// What the option is about, if not contacts: the files written, many models at once, or how results are shown.
    pub group: Option<FieldGroup>,
    /// Whether the option is for a whole run, and not for one row of a table.
    pub is_of_run: bool,
}

/// The kind of value that an option takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OptionValue {
    /// No value: the presence of the option means yes.
    Flag,
    /// A number or any text.
    Text,
    /// One word of a list.
    Choice(Words),
    /// The name of a file to read, of a model, or of a preset.
    FileRead,
    /// The name of a file to write.
    FileWritten,
    Folder,
    /// Properties of contacts, each with its value.
    Assignments,
}

/// Whether an option takes several values, and how a command line gives several.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum List {
    One,
    /// The option is repeated for each value.
    Repeated,
    /// The values are one argument, separated by commas.
    Commas,
}

named! {
    /// Subject of an option that does not describe contacts. A front end without files, without a terminal, or for one model at a
    /// time omits the fields of such groups: it reads the group here or in `x-group` of the schema, and needs no list of its own.
    pub enum FieldGroup {
        /// The files to which results are written.
        Output = "output",
        /// The work on many models in one call.
        Many = "many",
        /// The form in which results are shown, and the exit status.
        Shown = "shown",
    }
}

/// The field of an entry: an input, which messages can name, or an operand, which only requests name.
#[derive(Clone, Copy)]
pub(super) enum Field<'n> {
    Input(Input),
    Operand(&'n str),
}

impl Entry {
    /// Whether the value is the path of a file or folder.
    pub const fn is_path(&self) -> bool {
        matches!(self.takes, OptionValue::FileRead | OptionValue::FileWritten | OptionValue::Folder)
    }

    // How entries are written: `value("KG").signed()`.

    /// A flag with this name, heading and help; the other functions change it.
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

    /// An option without a value.
    pub(super) const fn flag(self) -> Self {
        self
    }

    /// An option with one value, which the help calls `value_name`.
    pub(super) const fn value(self, value_name: &'static str) -> Self {
        Self { takes: OptionValue::Text, value_name, ..self }
    }

    /// An option that can be repeated, with one value each.
    pub(super) const fn values(self, value_name: &'static str) -> Self {
        self.value(value_name).list_if(true)
    }

    /// An option with several values between commas.
    pub(super) const fn with_commas(self, value_name: &'static str) -> Self {
        Self { list: List::Commas, ..self.value(value_name) }
    }

    /// An option whose value is one of these words.
    pub(super) const fn choice(self, words: Words) -> Self {
        Self { takes: OptionValue::Choice(words), ..self }
    }

    /// An option with a file that is read.
    pub(super) const fn read(self, value_name: &'static str) -> Self {
        Self { takes: OptionValue::FileRead, value_name, ..self }
    }

    /// An option with a file that is written.
    pub(super) const fn written(self, value_name: &'static str) -> Self {
        Self { takes: OptionValue::FileWritten, value_name, ..self }
    }

    /// An option with a folder.
    pub(super) const fn folder(self) -> Self {
        Self { takes: OptionValue::Folder, value_name: "DIR", ..self }
    }

    /// An option with values of properties.
    pub(super) const fn assignments(self) -> Self {
        Self { takes: OptionValue::Assignments, ..self }
    }

    /// The option, repeated if `is_list`.
    pub(super) const fn list_if(self, is_list: bool) -> Self {
        if is_list { Self { list: List::Repeated, ..self } } else { self }
    }

    /// The option with another name of its value in the help.
    pub(super) const fn called(self, value_name: &'static str) -> Self {
        Self { value_name, ..self }
    }

    /// The option with a short name of one letter.
    pub(super) const fn short(self, letter: char) -> Self {
        Self { short: Some(letter), ..self }
    }

    /// The option, whose value may begin with a minus sign.
    pub(super) const fn signed(self) -> Self {
        Self { is_signed: true, ..self }
    }

    pub(super) const fn signed_if(self, is_signed: bool) -> Self {
        Self { is_signed, ..self }
    }

    /// The option, which the help lists after the usual ones.
    pub(super) const fn rare(self) -> Self {
        self.rare_if(true)
    }

    pub(super) const fn rare_if(self, is_rare: bool) -> Self {
        Self { is_rare, ..self }
    }

    /// The option, which its verb refuses if `is_refused`.
    pub(super) const fn refused_if(self, is_refused: bool) -> Self {
        Self { is_refused, ..self }
    }

    /// The option under another heading of the help if `is_there`.
    pub(super) const fn under_if(self, is_there: bool, heading: &'static str) -> Self {
        if is_there { Self { heading, ..self } } else { self }
    }

    /// The option in a group of fields that do not describe contacts.
    pub(super) const fn about(self, group: FieldGroup) -> Self {
        Self { group: Some(group), ..self }
    }

    /// The option of a whole run, which a row of a table cannot set.
    pub(super) const fn of_run(self) -> Self {
        Self { is_of_run: true, ..self }
    }
}
