//! Spells requests for the Python package.

use std::borrow::Cow;

use osim_model::messages::{Call, Dialect, Example, Input, Verb};

use crate::register::{FieldGroup, is_flag, option_named};
use crate::request::Request;
use crate::spell::speller::{Field, FieldValue, Fields, FrontEnd, digits, is_positional};

/// The first line of every script.
const IMPORT_LINE: &str = "import osim_contact_scale as ocs";
/// The line of a script that prints its result.
const PRINT_RESULT: &str = "print(result)";

/// Fields that a row of a table has, but not a call for all rows.
const OPTIONS_OF_ROWS: [&str; 2] = ["output", "geometry_output"];

/// Python: `mass=KG`, `ocs.design("model.osim", indentation=0.16)`.
///
/// ```
/// use osim_model::messages::{Input, Verb};
/// use osim_model::messages::Dialect;
/// use osim_requests::spell::Python;
///
/// let call = Verb::Transfer.call_with_model().with_value(Input::From, "falisse2022");
/// assert_eq!(Python.call(&call), r#"ocs.transfer("model.osim", from_="falisse2022")"#);
/// let drawn = Verb::Plot.call_with_model().with_value(Input::Kind, "feet").with_placeholder(Input::Output, "FILE.svg");
/// assert_eq!(Python.call(&drawn), r#"ocs.plot("feet", "model.osim").save("FILE.svg")"#);
/// ```
#[derive(Debug, Clone, Copy, Default)]
pub struct Python;

impl Dialect for Python {
    fn input(&self, input: Input, example: Option<&Example>) -> String {
        let value = match example {
            Some(example) => example_value(example),
            None if is_flag(input) => "True".to_owned(),
            None => String::new(),
        };
        format!("{}={value}", python_keyword(input.name()))
    }

    fn call(&self, call: &Call) -> String {
        let mut arguments = Vec::new();
        arguments.extend(call.inputs.iter().filter_map(|(input, example)| {
            Some(example_value(example.as_ref().filter(|_| is_positional(*input))?))
        }));
        arguments.extend(call.models_or("model.osim").map(|name| python_quoted(&file_word(name))));
        // A figure is saved by a method of its own.
        let is_saved = |input: &Input| call.verb == Verb::Plot && *input == Input::Output;
        let named = call.inputs.iter().filter(|(input, example)| !is_positional(*input) || example.is_none());
        let named = named.filter(|(input, _)| !is_saved(input));
        arguments.extend(named.map(|(input, example)| self.input(*input, example.as_ref())));
        let saved = call.inputs.iter().find(|(input, _)| is_saved(input)).and_then(|(_, file)| file.as_ref());
        let save = saved.map(|file| format!(".save({})", example_value(file))).unwrap_or_default();
        format!("{}{save}", function_call(call.verb, &arguments))
    }
}

impl FrontEnd for Python {
    /// The Python call: it plans the change of one model, changes many models, or returns a result. If the request names an
    /// output file, the call writes it.
    fn request(&self, request: &Request) -> String {
        let fields = Fields::of(request);
        let output = fields.in_group(FieldGroup::Output).filter(|(name, _)| name == "output");
        let written = python_arguments(keyword_arguments(output));
        let writes = plans_one_model(&fields) && !written.is_empty();
        let write = if writes { format!(".write({written})") } else { String::new() };
        format!("{}{write}", call_of(&fields))
    }

    /// The lines of a script, from the import to the lines that write and print the result.
    fn script(&self, request: &Request) -> String {
        let fields = Fields::of(request);
        let mut lines = vec![IMPORT_LINE.to_owned(), String::new(), format!("result = {}", call_of(&fields))];
        lines.extend(match fields.verb {
            Verb::Inspect => vec!["print(result.models)".to_owned()],
            Verb::Check => vec!["print(result.findings)".to_owned()],
            Verb::Plot => lines_for_figure(&fields),
            _ if plans_one_model(&fields) => lines_for_plan(&fields),
            _ => vec![PRINT_RESULT.to_owned()],
        });
        lines.join("\n")
    }
}

/// Whether the call plans the change of one model; the plan is then written by a second call.
fn plans_one_model(fields: &Fields) -> bool {
    fields.changes && fields.models().len() == 1 && fields.in_group(FieldGroup::Many).next().is_none()
}

/// The Python call of a request, without the arguments with which its result is written later.
fn call_of(fields: &Fields) -> String {
    let mut arguments: Vec<String> =
        fields.positional.iter().flat_map(|field| positional_arguments(fields.verb, field)).collect();
    // A call that only plans has no options of runs, such as `dry_run` and `report`.
    let is_left_out = |name: &str| match fields.verb {
        Verb::Batch => OPTIONS_OF_ROWS.contains(&name),
        verb => fields.changes && option_named(verb, name).is_some_and(|option| option.is_of_run),
    };
    let groups: &[FieldGroup] = match fields.verb {
        Verb::Plot | Verb::Reproduce => &[FieldGroup::Shown, FieldGroup::Output],
        _ if fields.changes => &[FieldGroup::Shown, FieldGroup::Output, FieldGroup::Many],
        _ => &[FieldGroup::Shown],
    };
    if fields.changes && !plans_one_model(fields) && !fields.models().is_empty() {
        return call_of_many(fields);
    }
    let named = fields.outside_groups(groups).filter(|(name, _)| !is_left_out(name));
    arguments.extend(keyword_arguments(named));
    function_call(fields.verb, &arguments)
}

/// The Python call that changes many models, and writes them.
fn call_of_many(fields: &Fields) -> String {
    let models = fields.models().iter().map(|model| python_literal("models", model));
    let mut arguments = vec![python_quoted(fields.verb.name()), format!("[{}]", python_arguments(models))];
    arguments.extend(keyword_arguments(fields.outside_groups(&[FieldGroup::Shown])));
    format!("ocs.many({})", python_arguments(arguments.into_iter()))
}

/// The arguments of a field without a keyword: one value alone, several values as a list, or as several arguments if the function
/// takes them.
fn positional_arguments(verb: Verb, (name, value): &Field) -> Vec<String> {
    match value {
        FieldValue::List(items) if items.len() == 1 || matches!(verb, Verb::Plot | Verb::Explain) => {
            items.iter().map(|item| python_literal(name, item)).collect()
        }
        value => vec![python_literal(name, value)],
    }
}

/// The lines of a script that write a plan, or only print it.
fn lines_for_plan(fields: &Fields) -> Vec<String> {
    let written = python_arguments(keyword_arguments(fields.in_group(FieldGroup::Output)));
    let mut lines = vec![match fields.option("dry_run") {
        Some(_) => PRINT_RESULT.to_owned(),
        None => format!("result.write({written})"),
    }];
    if fields.option("diff").is_some() {
        lines.push("print(result.diff())".to_owned());
    }
    lines.extend(fields.option("report").map(|report| save_line("report", "report", report, fields)));
    lines
}

/// The lines of a script that save a figure and its data.
fn lines_for_figure(fields: &Fields) -> Vec<String> {
    let file = |name| Some(save_line("save", name, fields.option(name)?, fields));
    ["output", "data"].into_iter().filter_map(file).collect()
}

/// The line of a script that writes the file in the field `name` with the method `method` of the result.
fn save_line(method: &str, name: &str, file: &FieldValue, fields: &Fields) -> String {
    let force = fields.options.iter().filter(|(name, _)| name == "force");
    let arguments = std::iter::once(python_literal(name, file)).chain(keyword_arguments(force));
    format!("result.{method}({})", python_arguments(arguments))
}

fn python_arguments(arguments: impl Iterator<Item = String>) -> String {
    arguments.collect::<Vec<_>>().join(", ")
}

/// Keyword arguments with their values. Each assigned property is a keyword.
fn keyword_arguments<'f>(options: impl Iterator<Item = &'f Field>) -> impl Iterator<Item = String> {
    options.flat_map(|option| {
        let entries = match option {
            (name, FieldValue::Map(properties)) if name == "set" => properties.as_slice(),
            option => std::slice::from_ref(option),
        };
        entries
            .iter()
            .map(|(name, value)| format!("{}={}", python_keyword(name), python_literal(name, value)))
    })
}

/// A Python literal for the value of the field `name`.
fn python_literal(name: &str, value: &FieldValue) -> String {
    match value {
        FieldValue::Flag => "True".to_owned(),
        FieldValue::Number(number) => digits(number),
        FieldValue::Text(text) if is_path(name) => python_quoted(&file_word(text)),
        FieldValue::Text(text) => python_quoted(text),
        FieldValue::List(items) => {
            format!("[{}]", python_arguments(items.iter().map(|item| python_literal(name, item))))
        }
        FieldValue::Map(entries) => {
            let entry =
                |(key, value): &Field| format!("{}: {}", python_quoted(key), python_literal(name, value));
            format!("{{{}}}", python_arguments(entries.iter().map(entry)))
        }
    }
}

/// Whether a field has names of files or folders, in which Python expands `~` to the home folder.
fn is_path(name: &str) -> bool {
    option_named(Verb::Rescale, name).is_some_and(|option| option.is_path())
}

/// The name of a file in a form that Python does not take for a home folder.
fn file_word(name: &str) -> Cow<'_, str> {
    if name.starts_with('~') { format!("./{name}").into() } else { name.into() }
}

fn function_call(verb: Verb, arguments: &[String]) -> String {
    let name = match verb {
        Verb::Batch => "rescale_many".to_owned(),
        verb => verb.name().replace('-', "_"),
    };
    format!("ocs.{name}({})", arguments.join(", "))
}

/// The Python keyword of an input, from its field name; a word that Python reserves gets a trailing underscore.
fn python_keyword(field: &str) -> String {
    match field {
        name @ ("class" | "from") => format!("{name}_"),
        name => name.to_owned(),
    }
}

/// An example value in Python. A placeholder is unchanged unless it looks like a text (`FILE.html`, `BODY=x,y,z`); a number is a
/// number; any other value is a string.
fn example_value(example: &Example) -> String {
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

/// `text` as a string literal of Python.
pub fn python_quoted(text: &str) -> String {
    let mut literal = String::from("\"");
    for letter in text.chars() {
        match letter {
            '"' => literal.push_str("\\\""),
            '\\' => literal.push_str("\\\\"),
            '\n' => literal.push_str("\\n"),
            '\r' => literal.push_str("\\r"),
            '\t' => literal.push_str("\\t"),
            control if control.is_control() => literal.push_str(&format!("\\u{:04x}", u32::from(control))),
            plain => literal.push(plain),
        }
    }
    literal.push('"');
    literal
}

#[cfg(test)]
mod tests {
    use osim_model::messages::Phrase;
    use serde_json::{Value, json};

    use super::*;

    fn spelled(template: &'static str) -> String {
        Phrase::template(template).spelled(&Python)
    }

    #[test]
    fn inputs_are_spelled_as_keywords_of_python() {
        assert_eq!(spelled("`mass=KG`, `mass`, `mass=62`, `strict`"), "mass=KG, mass=, mass=62, strict=True");
        assert_eq!(spelled("`radius=keep`, `from=MODEL`"), "radius=\"keep\", from_=MODEL");
        assert_eq!(
            spelled("`impact_speed=M/S`, `body_scale=BODY=x,y,z`"),
            "impact_speed=M/S, body_scale=\"BODY=x,y,z\""
        );
    }

    #[test]
    fn calls_are_spelled_as_functions_of_python() {
        assert_eq!(spelled("`drop-test MODEL`, `inspect`"), "ocs.drop_test(\"model.osim\"), ocs.inspect()");
        assert_eq!(
            spelled("`plot MODEL output=FILE.svg kind=force`"),
            "ocs.plot(\"force\", \"model.osim\").save(\"FILE.svg\")"
        );
    }

    #[test]
    fn strings_are_spelled_as_in_python() {
        assert_eq!(python_quoted("C:\\a \"b\"\n\u{1}é"), r#""C:\\a \"b\"\n\u0001é""#);
    }

    #[track_caller]
    fn assert_spelled(request: &Value, expected: &[&str]) {
        let request = Request::from_json(request.to_string().as_bytes()).unwrap();
        let lines = expected.join("\n");
        assert_eq!(Python.script(&request), format!("import osim_contact_scale as ocs\n\n{lines}"));
    }

    #[test]
    fn a_change_is_planned_and_then_written() {
        assert_spelled(
            &json!({"verb": "rescale", "models": "human.osim", "target_mass": 500}),
            &[r#"result = ocs.rescale("human.osim", target_mass=500)"#, "result.write()"],
        );
        assert_spelled(
            &json!({"verb": "add", "models": "bare.osim", "from": "a \"b\".osim", "class": "smooth", "yes": ["implausible-mass"],
        "output": "~new.osim", "force": true, "no_note": true, "report": "page.html", "format": "json"}),
            &[
                r#"result = ocs.add("bare.osim", from_="a \"b\".osim", class_="smooth", no_note=True, yes=["implausible-mass"])"#,
                r#"result.write(output="./~new.osim", force=True)"#,
                r#"result.report("page.html", force=True)"#,
            ],
        );
    }

    #[test]
    fn properties_that_are_set_are_keywords() {
        assert_spelled(
            &json!({"verb": "set", "models": "-x.osim", "set": {"stiffness": "x2", "dissipation": 1.5}, "in_place": true, "no_backup": true}),
            &[
                r#"result = ocs.set("-x.osim", stiffness="x2", dissipation=1.5)"#,
                "result.write(in_place=True, no_backup=True)",
            ],
        );
    }

    #[test]
    fn bodies_with_their_factors_are_a_dictionary() {
        assert_spelled(
            &json!({"verb": "transfer", "models": "a.osim", "from": "g.osim", "follow_bodies": true, "body_scale": {"foot l": [1.1, 1.05, 1.1]},
        "only": ["stiffness", "radius"]}),
            &[
                "result = ocs.transfer(\"a.osim\", from_=\"g.osim\", follow_bodies=True, \
         body_scale={\"foot l\": [1.1, 1.05, 1.1]}, only=[\"stiffness\", \"radius\"])",
                "result.write()",
            ],
        );
    }

    #[test]
    fn other_verbs_are_called_as_their_functions_take_them() {
        assert_spelled(
            &json!({"verb": "plot", "kind": "force", "models": ["a.osim", "~b.osim"], "output": "a.svg", "data": "a.csv", "force": true,
        "axes": "real"}),
            &[
                r#"result = ocs.plot("force", "a.osim", "./~b.osim", axes="real")"#,
                r#"result.save("a.svg", force=True)"#,
                r#"result.save("a.csv", force=True)"#,
            ],
        );
        for (request, call) in [
            (
                json!({"verb": "drop-test", "subject": "a.osim", "format": "json"}),
                r#"ocs.drop_test("a.osim")"#,
            ),
            (
                json!({"verb": "explain", "topics": ["C.2", "floats"], "ascii": true}),
                r#"ocs.explain("C.2", "floats")"#,
            ),
            (
                json!({"verb": "batch", "manifest": "masses.csv", "output_dir": "scaled", "quiet": true}),
                r#"ocs.rescale_many("masses.csv", output_dir="scaled")"#,
            ),
            (
                json!({"verb": "sweep", "model": "a.osim", "grid": "stiffness=x1,x2", "output_dir": "b"}),
                r#"ocs.sweep("a.osim", grid=["stiffness=x1,x2"], output_dir="b")"#,
            ),
            (json!({"verb": "reproduce", "output_dir": "b", "force": true}), "ocs.reproduce()"),
        ] {
            assert_spelled(&request, &[&format!("result = {call}"), "print(result)"]);
        }
    }
}
