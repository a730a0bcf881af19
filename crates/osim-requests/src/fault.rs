//! Faults of a request that are known before a model is read, and the conditions between options.

use osim_model::files::Failure;
use osim_model::messages::{Dialect, Input, Phrase, phrase, shown};

/// Why a request is refused.
#[derive(Debug, Clone, PartialEq)]
pub enum RequestFault {
    /// The request has no field of this name; `nearest` was probably meant.
    UnknownField { field: String, nearest: Option<String> },
    /// A field cannot take its value, for a reason that says the expected form.
    BadValue { field: String, value: String, reason: String },
    /// A field that every such request has is missing.
    Missing { field: &'static str },
    /// A field that has no meaning without another field.
    Needs { field: &'static str, other: &'static str },
    /// Only one of two fields can be given.
    Excludes { field: &'static str, other: &'static str },
    /// A request that makes no sense for any model, with advice. `input` causes it, if it is a single one.
    Refused { input: Option<Input>, message: Phrase },
}

impl RequestFault {
    /// A refused request because of `input`.
    pub fn refused(input: Input, message: impl Into<Phrase>) -> Self {
        Self::Refused { input: Some(input), message: message.into() }
    }

    /// A refused request because of several inputs or of none.
    pub fn general(message: impl Into<Phrase>) -> Self {
        Self::Refused { input: None, message: message.into() }
    }

    /// The name of the field that the fault is about, if it is about a single field.
    pub fn field(&self) -> Option<&str> {
        match self {
            Self::UnknownField { field, .. } | Self::BadValue { field, .. } => Some(field),
            Self::Missing { field } | Self::Needs { field, .. } | Self::Excludes { field, .. } => Some(field),
            Self::Refused { input, .. } => input.map(Input::name),
        }
    }

    /// The message of the fault; its inputs are data, which each dialect spells in its own way.
    pub fn phrase(&self) -> Phrase {
        match self {
            Self::UnknownField { field, nearest: Some(nearest) } => {
                phrase![format!("there is no option '{field}': did you mean "), &name_of_field(nearest), "?"]
            }
            Self::UnknownField { field, nearest: None } => format!("there is no option '{field}'").into(),
            Self::BadValue { field, value, reason } => {
                phrase![&name_of_field(field), format!(" '{}': {reason}", shown(value))]
            }
            Self::Missing { field } => phrase![&name_of_field(field), " is missing"],
            Self::Needs { field, other } => {
                phrase![&name_of_field(field), " needs ", &name_of_field(other)]
            }
            Self::Excludes { field, other } => {
                phrase![
                    "{} and {} exclude each other: leave one out";
                    &name_of_field(field), &name_of_field(other)
                ]
            }
            Self::Refused { message, .. } => message.clone(),
        }
    }

    pub fn spelled(&self, dialect: &dyn Dialect) -> String {
        self.phrase().spelled(dialect)
    }
}

/// A field name as a phrase, which each front end spells in its own way.
fn name_of_field(field: &str) -> Phrase {
    match Input::find(field) {
        Some(input) => input.into(),
        None => format!("`{field}`").into(),
    }
}

impl std::fmt::Display for RequestFault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.phrase().fmt(f)
    }
}

impl std::error::Error for RequestFault {}

/// The reason why a request cannot be started: the request is wrong, or a file.
#[derive(Debug, Clone, PartialEq)]
pub enum RequestError {
    Fault(RequestFault),
    /// A file of the request cannot be used.
    Failure(Failure),
}

/// What a request gives, or why it cannot be started.
pub type Result<T, E = RequestError> = std::result::Result<T, E>;

impl From<RequestFault> for RequestError {
    fn from(fault: RequestFault) -> Self {
        Self::Fault(fault)
    }
}

impl From<Failure> for RequestError {
    fn from(failure: Failure) -> Self {
        Self::Failure(failure)
    }
}

// What options need and exclude: the same for the words of a command line and for a dictionary.

/// A condition between options, each given by its field name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    /// The field must be given.
    Required(&'static str),
    /// The field is required in a dictionary; on the command line, it has a message of its own.
    Expected(&'static str),
    /// The first field is required if the second is absent.
    RequiredUnless(&'static str, &'static str),
    /// The first field is required if the second is absent; on the command line, the first has a message of its own.
    ExpectedUnless(&'static str, &'static str),
    /// The first field has no meaning without the second.
    Needs(&'static str, &'static str),
    /// Only one of the two fields can be given.
    Excludes(&'static str, &'static str),
}

impl Relation {
    /// The field to which the relation applies.
    pub const fn field(self) -> &'static str {
        match self {
            Self::Required(field)
            | Self::Expected(field)
            | Self::RequiredUnless(field, _)
            | Self::ExpectedUnless(field, _)
            | Self::Needs(field, _)
            | Self::Excludes(field, _) => field,
        }
    }
}
