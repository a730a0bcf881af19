//! Inputs and calls as they are in a sentence.

use std::borrow::Cow;
use std::fmt;

use super::input::{Input, Verb};
use super::shown::shown_whole;

/// A part of a [`Phrase`](super::Phrase).
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Part {
    /// Plain words.
    Text(Cow<'static, str>),
    /// Something that the reader can say.
    Input(Input, Option<Example>),
    /// Something that the reader can do.
    Call(Call),
    /// Words for verbs that take an input, and those for verbs that do not.
    Either(Input, Box<[Vec<Part>; 2]>),
}

/// An example of the value of an input.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Example {
    /// A word for a value that the reader knows, such as `KG`.
    Placeholder(Cow<'static, str>),
    /// A value to be taken as it is: a number, or a word such as `keep`.
    Value(String),
}

/// A verb with some of its inputs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Call {
    /// What is done.
    pub verb: Verb,
    /// Whether it names the model: as `MODEL`.
    pub with_model: bool,
    /// The inputs that the call gives, in this order.
    pub inputs: Vec<(Input, Option<Example>)>,
}

impl Verb {
    /// The verb alone, for a sentence.
    #[must_use]
    pub const fn call(self) -> Call {
        Call { verb: self, with_model: false, inputs: Vec::new() }
    }

    /// The verb with a model.
    #[must_use]
    pub const fn of_model(self) -> Call {
        Call { verb: self, with_model: true, inputs: Vec::new() }
    }
}

impl Call {
    /// With an input and a placeholder for its value.
    #[must_use]
    pub fn with(mut self, input: Input, placeholder: &'static str) -> Self {
        self.inputs.push((input, Some(Example::Placeholder(placeholder.into()))));
        self
    }

    /// With an input and a value.
    #[must_use]
    pub fn saying(mut self, input: Input, value: impl Into<String>) -> Self {
        self.inputs.push((input, Some(Example::Value(value.into()))));
        self
    }

    /// With an input that has no value.
    #[must_use]
    pub fn and(mut self, input: Input) -> Self {
        self.inputs.push((input, None));
        self
    }
}

impl Input {
    /// The input with a placeholder for its value: `--mass KG`.
    #[must_use]
    pub const fn like(self, placeholder: &'static str) -> Part {
        Part::Input(self, Some(Example::Placeholder(Cow::Borrowed(placeholder))))
    }

    /// The input with a value: `--radius keep`.
    #[must_use]
    pub fn being(self, value: impl Into<String>) -> Part {
        Part::Input(self, Some(Example::Value(value.into())))
    }
}

impl fmt::Display for Example {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Placeholder(word) => f.write_str(word),
            // A value may be the name of a file or of a sphere.
            Self::Value(value) => shown_whole(value).fmt(f),
        }
    }
}
