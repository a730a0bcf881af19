//! Lines of Python.

use std::borrow::Cow;

use osim_messages::Verb;
use osim_report::dialect::{python_keyword, python_quoted};

use super::fields::{FieldValue, Fields};

const IMPORT: &str = "import osim_contact_scale as ocs";
const SHOWN: &str = "print(result)";

/// Where the results of a change go: arguments of `write`.
const OF_WRITE: [&str; 6] = ["output", "output_dir", "in_place", "no_backup", "force", "geometry_output"];

/// What a change takes only where many models are changed at once.
const OF_MANY: [&str; 4] = ["jobs", "summary", "resume", "shard"];

/// What is done with a plan when it is there.
const OF_PLAN: [&str; 3] = ["dry_run", "diff", "report"];

/// What is about a terminal, or an exit status.
const OF_TERMINAL: [&str; 4] = ["format", "quiet", "full", "deny"];

/// Fields with names of files or folders, in which Python's `~` is the home folder.
const PATHS: [&str; 12] = [
    "body_scale_file",
    "contacts",
    "from",
    "geometry",
    "geometry_dir",
    "geometry_output",
    "model",
    "output",
    "output_dir",
    "presets",
    "report",
    "summary",
];

/// The lines, from the import on.
pub(super) fn python(fields: &Fields) -> String {
    let lines = match (fields.verb, fields.models.as_slice()) {
        (Verb::Inspect | Verb::Check, _) => survey(fields),
        (_, []) => calculation(fields),
        (_, [model]) if !fields.says(&OF_MANY) => change(fields, model),
        _ => many(fields),
    };
    format!("{IMPORT}\n\n{}", lines.join("\n"))
}

fn survey(fields: &Fields) -> Vec<String> {
    let models = match fields.models.as_slice() {
        [model] => path(model),
        models => list(models),
    };
    let mut arguments = vec![models];
    arguments.extend(keywords(fields.without(&OF_TERMINAL)));
    let shown = if fields.verb == Verb::Check { "findings" } else { "models" };
    vec![result_of(fields, &arguments), format!("print(result.{shown})")]
}

fn calculation(fields: &Fields) -> Vec<String> {
    vec![result_of(fields, &planned(fields)), SHOWN.to_owned()]
}

/// A plan of one model, and its writing.
fn change(fields: &Fields, model: &str) -> Vec<String> {
    let mut arguments = vec![path(model)];
    arguments.extend(planned(fields));
    let mut lines = vec![result_of(fields, &arguments)];
    lines.push(match fields.says(&["dry_run"]) {
        true => SHOWN.to_owned(),
        false => format!("result.write({})", keywords(fields.only(&OF_WRITE)).collect::<Vec<_>>().join(", ")),
    });
    if fields.says(&["diff"]) {
        lines.push("print(result.diff())".to_owned());
    }
    if let Some((_, report)) = fields.only(&["report"]).next() {
        let mut arguments = vec![literal("report", report)];
        arguments.extend(keywords(fields.only(&["force"])));
        lines.push(format!("result.report({})", arguments.join(", ")));
    }
    lines
}

/// The same change of many models, which are written at once.
fn many(fields: &Fields) -> Vec<String> {
    let mut arguments = vec![python_quoted(fields.verb.name()), list(&fields.models)];
    let left_out = [&OF_TERMINAL[..], &["diff"]].concat();
    arguments.extend(keywords(fields.without(&left_out)));
    vec![format!("result = ocs.many({})", arguments.join(", ")), SHOWN.to_owned()]
}

fn result_of(fields: &Fields, arguments: &[String]) -> String {
    format!("result = ocs.{}({})", fields.verb.name().replace('-', "_"), arguments.join(", "))
}

/// What a plan, or a calculation, takes.
fn planned(fields: &Fields) -> Vec<String> {
    let later = [&OF_WRITE[..], &OF_MANY, &OF_PLAN, &OF_TERMINAL].concat();
    keywords(fields.without(&later)).collect()
}

/// Keywords with their values. Each property that is set is a keyword.
fn keywords<'f>(options: impl Iterator<Item = &'f (String, FieldValue)>) -> impl Iterator<Item = String> {
    options.flat_map(|option| {
        let entries = match option {
            (name, FieldValue::Map(properties)) if name == "set" => properties.as_slice(),
            option => std::slice::from_ref(option),
        };
        entries.iter().map(|(name, value)| format!("{}={}", python_keyword(name), literal(name, value)))
    })
}

/// The value of the field `name`.
fn literal(name: &str, value: &FieldValue) -> String {
    match value {
        FieldValue::Flag => "True".to_owned(),
        FieldValue::Number(number) => number.clone(),
        FieldValue::Text(text) if PATHS.contains(&name) => path(text),
        FieldValue::Text(text) => python_quoted(text),
        FieldValue::List(items) => {
            let items: Vec<String> = items.iter().map(|item| literal(name, item)).collect();
            format!("[{}]", items.join(", "))
        }
        FieldValue::Map(entries) => {
            let entry = |(key, value): &(String, FieldValue)| {
                format!("{}: {}", python_quoted(key), literal(name, value))
            };
            format!("{{{}}}", entries.iter().map(entry).collect::<Vec<_>>().join(", "))
        }
    }
}

fn list(models: &[String]) -> String {
    format!("[{}]", models.iter().map(|model| path(model)).collect::<Vec<_>>().join(", "))
}

/// The name of a file.
fn path(name: &str) -> String {
    let name: Cow<'_, str> = if name.starts_with('~') { format!("./{name}").into() } else { name.into() };
    python_quoted(&name)
}

#[cfg(test)]
mod tests {
    use osim_requests::Request;
    use serde_json::{Value, json};

    use super::*;

    #[track_caller]
    fn is_spelled(request: &Value, expected: &[&str]) {
        let request = Request::from_json(request.to_string().as_bytes()).unwrap();
        let lines = expected.join("\n");
        assert_eq!(python(&Fields::of(&request)), format!("import osim_contact_scale as ocs\n\n{lines}"));
    }

    #[test]
    fn a_change_is_planned_and_then_written() {
        is_spelled(
            &json!({"verb": "rescale", "models": "human.osim", "target_mass": 500}),
            &[r#"result = ocs.rescale("human.osim", target_mass=500)"#, "result.write()"],
        );
        is_spelled(
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
        is_spelled(
            &json!({"verb": "set", "models": "-x.osim", "set": {"stiffness": "x2", "dissipation": 1.5}, "in_place": true, "no_backup": true}),
            &[
                r#"result = ocs.set("-x.osim", stiffness="x2", dissipation=1.5)"#,
                "result.write(in_place=True, no_backup=True)",
            ],
        );
    }

    #[test]
    fn bodies_with_their_factors_are_a_dictionary() {
        is_spelled(
            &json!({"verb": "transfer", "models": "a.osim", "from": "g.osim", "follow_bodies": true, "body_scale": {"foot l": [1.1, 1.05, 1.1]},
                "only": ["stiffness", "radius"]}),
            &[
                "result = ocs.transfer(\"a.osim\", from_=\"g.osim\", follow_bodies=True, \
                 body_scale={\"foot l\": [1.1, 1.05, 1.1]}, only=[\"stiffness\", \"radius\"])",
                "result.write()",
            ],
        );
    }
}
