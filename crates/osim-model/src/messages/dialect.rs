//! How front ends spell inputs and calls.

use super::input::Input;
use super::part::{Call, Example};

/// The words of a front end.
///
/// ```
/// use osim_model::messages::{Call, Dialect, Example, Input, phrase};
///
/// /// `mass=KG`, as in a call of a Python function.
/// struct Python;
///
/// impl Dialect for Python {
///     fn input(&self, input: Input, example: Option<&Example>) -> String {
///         match example {
///             Some(example) => format!("{}={example}", input.name()),
///             None => input.name().to_owned(),
///         }
///     }
///
///     fn call(&self, call: &Call) -> String {
///         let inputs = call.inputs.iter().map(|(input, example)| self.input(*input, example.as_ref()));
///         format!("{}({})", call.verb.name(), inputs.collect::<Vec<_>>().join(", "))
///     }
/// }
///
/// let way_out = phrase!["say what the model weighs with ", Input::Mass.like("KG")];
/// assert_eq!(way_out.spelled(&Python), "say what the model weighs with mass=KG");
/// ```
pub trait Dialect {
    /// An input with an example of its value, as the reader types it.
    fn input(&self, input: Input, example: Option<&Example>) -> String;

    /// A call, as the reader types it.
    fn call(&self, call: &Call) -> String;
}

/// The names of the fields in a request, for callers that have no dialect.
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
