//! What can be wrong with a request before any model is read, and what options need and exclude.

use osim_model::files::Failure;
use osim_model::messages::{Dialect, Input, Phrase, phrase, shown};

#[derive(Debug, Clone, PartialEq)]
pub enum RequestFault {
    /// The request has no field of this name.
    UnknownField {
        /// The name of the field as the caller gave it.
        field: String,
        /// Name of the field that was probably meant.
        nearest: Option<String>,
    },
    /// A field cannot take its value.
    BadValue {
        field: String,
        /// The value of the field as the caller gave it.
        value: String,
        /// What was expected, in words.
        reason: String,
    },
    Missing {
        field: &'static str,
    },
    /// A field has no meaning without another.
    Needs {
        /// Name of the field that is given.
        field: &'static str,
        /// Name of the field that is missing.
        other: &'static str,
    },
    /// Only one of two fields can be given.
    Excludes {
        field: &'static str,
        other: &'static str,
    },
    /// The request makes no sense, whatever the model.
    Refused {
        /// The field that it is about, where it is one.
        input: Option<Input>,
        /// Why the request is refused, and what to do.
        message: Phrase,
    },
}

impl RequestFault {
    /// A request that makes no sense because of `input`.
    pub fn refused(input: Input, message: impl Into<Phrase>) -> Self {
        Self::Refused { input: Some(input), message: message.into() }
    }

    /// A refusal because of several inputs or of none.
    pub fn general(message: impl Into<Phrase>) -> Self {
        Self::Refused { input: None, message: message.into() }
    }

    /// The name of the field that it is about, where it is one.
    pub fn field(&self) -> Option<&str> {
        match self {
            Self::UnknownField { field, .. } | Self::BadValue { field, .. } => Some(field),
            Self::Missing { field } | Self::Needs { field, .. } | Self::Excludes { field, .. } => Some(field),
            Self::Refused { input, .. } => input.map(Input::name),
        }
    }

    /// The message of the fault; inputs in it are data, for a spelling.
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
                    &name_of_field(field),
                    " and ",
                    &name_of_field(other),
                    " exclude each other: leave one out"
                ]
            }
            Self::Refused { message, .. } => message.clone(),
        }
    }

    pub fn spelled(&self, dialect: &dyn Dialect) -> String {
        self.phrase().spelled(dialect)
    }
}

/// A field as front ends know it.
fn name_of_field(field: &str) -> Phrase {
    match Input::named(field) {
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

/// Why a request cannot be begun: the request or a file. A match on it is complete, so that no error is lost.
#[derive(Debug, Clone, PartialEq)]
pub enum RequestError {
    Fault(RequestFault),
    /// A file that it needs cannot be used.
    Failure(Failure),
}

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

/// How options depend on each other; each is named by its field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    /// The field must be given.
    Required(&'static str),
    /// The field is required in a dictionary; the command line asks for it in its own words.
    Expected(&'static str),
    /// The field is required if the other is absent.
    RequiredUnless(&'static str, &'static str),
    /// The field is required without the other, and the command line asks for it in its own words.
    ExpectedUnless(&'static str, &'static str),
    /// The field has no meaning without the other.
    Needs(&'static str, &'static str),
    /// Only one of the two can be given.
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
