//! How front ends spell inputs and calls.

use super::input::Input;
use super::part::{Call, Example};

/// The words of a front end.
pub trait Dialect {
    /// An input with what stands behind it, as the reader types it.
    fn input(&self, input: Input, example: Option<&Example>) -> String;

    /// A call, as the reader types it.
    fn call(&self, call: &Call) -> String;
}

/// The names of the fields in a request, for whoever has no dialect of their own.
#[derive(Debug, Clone, Copy, Default)]
pub struct Plain;

impl Dialect for Plain {
    fn input(&self, input: Input, example: Option<&Example>) -> String {
        match example {
            Some(Example::Value(value)) => format!("`{}` {value}", input.name()),
            _ => format!("`{}`", input.name()),
        }
    }

    fn call(&self, call: &Call) -> String {
        let inputs: Vec<String> =
            call.inputs.iter().map(|(input, example)| self.input(*input, example.as_ref())).collect();
        let with = if inputs.is_empty() { String::new() } else { format!(" with {}", inputs.join(" and ")) };
        format!("`{}`{with}", call.verb.name())
    }
}
