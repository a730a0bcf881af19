//! The words of the Python package.

use osim_messages::{Call, Dialect, Example, Input, Verb, shortest};
use osim_model::Assignment;
use osim_requests::{Request, Speller};

use super::front_end::FrontEnd;
use super::remedy::{InputValue, RemedyParts};

/// Python: `mass=KG`, `ocs.design("model.osim", indentation=0.16)`.
///
/// ```
/// use osim_messages::{Input, Verb};
/// use osim_messages::Dialect;
/// use osim_report::dialect::Python;
///
/// let call = Verb::Transfer.of_model().saying(Input::From, "falisse2022");
/// assert_eq!(Python.call(&call), r#"ocs.transfer("model.osim", from_="falisse2022")"#);
/// ```
#[derive(Debug, Clone, Copy, Default)]
pub struct Python;

impl Dialect for Python {
    fn input(&self, input: Input, example: Option<&Example>) -> String {
        let value = match example {
            Some(example) => value_of(example),
            None if input.is_flag() => "True".to_owned(),
            None => String::new(),
        };
        format!("{}={value}", python_keyword(input.name()))
    }

    fn call(&self, call: &Call) -> String {
        let mut arguments = Vec::new();
        arguments.extend(call.inputs.iter().filter_map(|(input, example)| {
            Some(value_of(example.as_ref().filter(|_| is_positional(*input))?))
        }));
        arguments.extend(call.with_model.then(|| python_quoted("model.osim")));
        let named = call.inputs.iter().filter(|(input, example)| !is_positional(*input) || example.is_none());
        arguments.extend(named.map(|(input, example)| self.input(*input, example.as_ref())));
        function(call.verb, &arguments)
    }
}

impl Speller for Python {
    fn request(&self, request: &Request) -> String {
        let parts = RemedyParts::of(request);
        let mut arguments = vec![python_quoted(&parts.model)];
        arguments.extend(parts.assignments.iter().map(|(property, assignment)| match assignment {
            Assignment::Factor(factor) => {
                format!("{property}={}", python_quoted(&format!("x{}", shortest(*factor))))
            }
            Assignment::Value(value) => format!("{property}={}", shortest(*value)),
        }));
        arguments.extend(parts.inputs.iter().map(|(input, given)| {
            let value = match given {
                InputValue::Number(value) => shortest(*value),
                InputValue::Text(text) => python_quoted(text),
                InputValue::Patterns(patterns) => {
                    let patterns: Vec<String> =
                        patterns.iter().map(|pattern| python_quoted(pattern)).collect();
                    format!("[{}]", patterns.join(", "))
                }
                InputValue::Flag => "True".to_owned(),
            };
            format!("{}={value}", python_keyword(input.name()))
        }));
        function(parts.verb, &arguments)
    }
}

impl FrontEnd for Python {}

fn function(verb: Verb, arguments: &[String]) -> String {
    format!("ocs.{}({})", verb.name().replace('-', "_"), arguments.join(", "))
}

/// What is written without a keyword.
fn is_positional(input: Input) -> bool {
    matches!(input, Input::Kind | Input::Topics)
}

/// The keyword of an input, given by the name of its field; a word that Python reserves gets a line after it.
#[must_use]
pub fn python_keyword(field: &str) -> String {
    match field {
        name @ ("class" | "from") => format!("{name}_"),
        name => name.to_owned(),
    }
}

/// A placeholder stays as it is unless it looks like a text (`FILE.html`, `BODY=x,y,z`); a number is a number; everything
/// else is a string.
fn value_of(example: &Example) -> String {
    match example {
        Example::Placeholder(word) if !word.contains(['.', ',', '=']) => word.to_string(),
        Example::Value(value) if is_number(value) => value.clone(),
        example => python_quoted(&example.to_string()),
    }
}

fn is_number(text: &str) -> bool {
    let digit = text.trim_start_matches('-').starts_with(|c: char| c.is_ascii_digit());
    digit && text.parse::<f64>().is_ok_and(f64::is_finite)
}

/// A string as Python reads it.
#[must_use]
pub fn python_quoted(text: &str) -> String {
    let mut literal = String::from("\"");
    for letter in text.chars() {
        match letter {
            '"' => literal.push_str("\\\""),
            '\\' => literal.push_str("\\\\"),
            '\n' => literal.push_str("\\n"),
            '\r' => literal.push_str("\\r"),
            '\t' => literal.push_str("\\t"),
            control if control.is_control() => {
                literal.push_str(&format!("\\u{:04x}", u32::from(control)));
            }
            plain => literal.push(plain),
        }
    }
    literal.push('"');
    literal
}

#[cfg(test)]
mod tests {
    use osim_messages::Phrase;

    use super::*;

    fn spelled(template: &'static str) -> String {
        Phrase::template(template).spelled(&Python)
    }

    #[test]
    fn inputs_are_keywords() {
        assert_eq!(spelled("`mass=KG`, `mass`, `mass=62`, `strict`"), "mass=KG, mass=, mass=62, strict=True");
        assert_eq!(spelled("`radius=keep`, `from=MODEL`"), "radius=\"keep\", from_=MODEL");
        assert_eq!(
            spelled("`impact_speed=M/S`, `body_scale=BODY=x,y,z`"),
            "impact_speed=M/S, body_scale=\"BODY=x,y,z\""
        );
    }

    #[test]
    fn calls_are_functions() {
        assert_eq!(spelled("`drop-test MODEL`, `inspect`"), "ocs.drop_test(\"model.osim\"), ocs.inspect()");
        assert_eq!(
            spelled("`plot MODEL output=FILE.svg kind=force`"),
            "ocs.plot(\"force\", \"model.osim\", output=\"FILE.svg\")"
        );
    }

    #[test]
    fn strings_are_python_s() {
        assert_eq!(python_quoted("C:\\a \"b\"\n\u{1}é"), r#""C:\\a \"b\"\n\u0001é""#);
    }
}
