//! Tests of calls that users can copy: the parser of the command line reads the same request from a spelled command.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use clap::Command;
use osim_model::messages::Verb;
use osim_requests::command_line::{read, with_options};
use osim_requests::spell::{CommandLine, FrontEnd, Python};
use osim_requests::{Request, schema_of};
use serde_json::{Map, Value, json};

fn request_of_json(json: &Value) -> Request {
    Request::from_json(json.to_string().as_bytes()).unwrap_or_else(|fault| panic!("{json}: {fault:?}"))
}

fn command_line_of(request: &Request) -> String {
    CommandLine.request(request)
}

/// The request that the program reads from a command line.
fn read_back(line: &str) -> Request {
    // The crate does not know `$'a\nb'`, as bash and zsh read it.
    let plain = line.replace("$'", "'");
    let mut words = shlex::split(&plain).unwrap_or_else(|| panic!("no shell takes this: {line}"));
    if plain != line {
        words = words.iter().map(|word| word.replace(r"\n", "\n").replace(r"\t", "\t")).collect();
    }
    assert_eq!(words[0], "osim-contact-scale");
    let verb = Verb::find(&words[1]).unwrap();
    let matches =
        parser(verb).try_get_matches_from(&words[1..]).unwrap_or_else(|error| panic!("{words:?}: {error}"));
    read(verb, &matches, |_| false).unwrap()
}

fn parser(verb: Verb) -> Command {
    with_options(Command::new(verb.name()), verb)
}

/// For each field, a value that is not the default.
const EXAMPLES: &str = r##"{
    "models": ["a.osim", "my models/b.osim"], "from": "my generic.osim", "to": "hunt-crossley",
    "set": {"stiffness": "x2", "dissipation": 1.5, "radius": "x0.5"},
    "target_mass": 500, "contacts_mass": 62.5, "mass": 0.0209, "exclude_body": ["cart", "*board"],
    "radius": 0.04, "level": true, "level_axis": "-y", "only": ["stiffness", "radius"], "keep": ["dissipation", "radius"],
    "dissipation_by": "mass", "friction": true, "contacts_gravity": 9.81, "target_gravity": 1.62,
    "body_scale_file": "ScaleSet 1.xml", "follow_bodies": true, "select": ["*_r", "toe?"], "exclude": ["heel_[lr]"],
    "skip_disabled": true, "output": "$new.osim", "geometry_output": "g.xml", "output_dir": "it's/here", "in_place": true, "fix": true,
    "no_backup": true, "force": true, "no_note": true, "dry_run": true, "diff": true, "format": "json", "quiet": true,
    "report": "page 1.html", "jobs": 3, "summary": "run.csv", "resume": true, "shard": "1/4", "yes": ["implausible-mass"],
    "geometry": "g.xml", "model": "m.osim", "presets": "own.toml", "spheres": 6, "stance_limbs": 2, "reference_mass": 75,
    "reference_spheres": 4, "reference_gravity": 9.80665, "reference_select": ["*"], "reference_sphere": "heel r",
    "body_scale": {"calcn_r": [1.1, 1.05, 1.1], "foot l": 2}, "radius_axis": "max", "moved_spheres": "keep", "strict": true,
    "rule": "predsim", "height_ratio": 0.5, "contacts": "places.csv", "default_pose": true, "feet": ["calcn_r", "calcn l"],
    "count": 3, "pad": 0.01, "geometry_dir": "Geometry", "mirror": "z", "class": "smooth", "body_map": ["toes_r=calcn_r"],
    "replace": true, "indentation": 0.16, "young": 1e6, "poisson": -0.25, "restitution": 0.5, "impact_speed": 0.4,
    "constant_indentation": 0.05, "state_width": 1e-6, "speed_width": 0.1, "threshold": 0.02, "static_friction": 0.8,
    "dynamic_friction": 0.7, "viscous_friction": 0.5, "transition_velocity": 0.2, "load": 608, "body_weights": 2,
    "gravity": 1.62, "contact_stiffness": 1e16, "dimensionless_stiffness": 4.25, "stress": 2e5, "other_young": 1e7, "other_poisson": 0.3, "state_smoothing": 10, "speed_smoothing": 9, "stiffness": 3067776, "constant_contact_force": 1e-5,
    "hertz_smoothing": 300, "hunt_crossley_smoothing": 50, "full": true, "deny": "warning",
    "manifest": "masses 1.csv", "allow_outside": true, "grid": {"stiffness": "x0.1..x10/9", "indentation": [0.1, 0.2]}, "ladder": 5,
    "soft": 2.5, "point": 3, "subject": "a.osim", "height": "x0.5", "duration": 1.5, "samples": 501, "compare": "falisse2022",
    "compare_spheres": 4, "foot_mass": 3.9, "kind": "sweep", "data": "a.csv", "axes": "real", "quantity": "peak-force", "table": "sweep.csv",
    "value_column": "my result", "x_column": "a", "y_column": "b", "value_range": "-1..2", "title": "two \"models\"",
    "label": ["one", "-2"], "width": 190, "font_size": 8, "x_range": "-0.1..0.2", "y_range": "0..1", "dpi": 300,
    "file": "measured.csv", "onset": -0.001, "branch": "loading", "indentation_column": "x [mm]", "force_column": "F",
    "speed_column": "v", "time_column": "t", "indentation_unit": "mm", "force_unit": "kN", "speed_unit": "mm/s", "time_unit": "ms",
    "dissipation": 1.5, "name": "falisse2022", "topics": ["C.2", "x/R"], "ascii": true,
    "motion": "walk 1.mot", "plates": "grf.mot", "loads": "grf.xml", "angles": "degrees", "low_pass": 6, "plates_delay": -0.05, "belt": -1.25, "belt_column": "belt speed",
    "moco_setup": "my walk.omoco", "from_moco_setup": "walk.omoco",
    "fit": ["height"], "unbounded": true, "height_in": "spheres", "start": -0.5, "end": 2, "correct": "b.sto", "vertical": true, "floor": -0.01, "error": "6mm,2deg", "moco": "moco folder", "nmsm": "nmsm", "sockets": true
}"##;

/// A value of a field for a verb to which the value in [`EXAMPLES`] does not apply.
fn example_of(verb: Verb, field: &str) -> Option<Value> {
    match (verb, field) {
        (Verb::Plot, "stiffness" | "dissipation") => Some("x0.5..x2/3".into()),
        (Verb::Fit, "motion" | "plates") => Some(json!(["a.mot", "my b.mot"])),
        _ => None,
    }
}

/// The fields that `field` needs, by the schema.
fn fields_needed_by<'s>(schema: &'s Value, field: &str) -> Vec<&'s str> {
    let rules = schema["allOf"].as_array().into_iter().flatten();
    let given = |rule: &'s Value| rule["$ref"].as_str()?.strip_prefix("#/$defs/")?.strip_suffix("_given");
    let needs = rules.filter(|rule| given(&rule["anyOf"][0]["not"]) == Some(field));
    needs.filter_map(|rule| given(&rule["anyOf"][1])).collect()
}

/// An example of a request of `verb` with `field` and every field that `field` needs.
fn example_request_with_field(verb: Verb, schema: &Value, field: &str) -> Value {
    let examples: Map<String, Value> = serde_json::from_str(EXAMPLES).unwrap();
    let mut said = json!({"verb": verb.name()});
    if schema["properties"].get("models").is_some() {
        said["models"] = "a.osim".into();
    }
    let required = schema["required"].as_array().into_iter().flatten().filter_map(Value::as_str);
    let mut wanted: Vec<&str> = required.filter(|name| !["verb", "models"].contains(name)).collect();
    // A sweep needs a grid or a ladder.
    wanted.extend((verb == Verb::Sweep && !["ladder", "soft"].contains(&field)).then_some("grid"));
    wanted.extend((verb == Verb::Fit).then_some("radius"));
    // A convert needs a class, unless it only corrects sockets.
    wanted.extend((verb == Verb::Convert && field != "sockets").then_some("to"));
    // A set needs an assignment, unless it only levels feet.
    wanted.extend((verb == Verb::Set && field != "level").then_some("set"));
    wanted.extend((verb == Verb::Note && field != "stance_limbs").then_some("contacts_mass"));
    wanted.push(field);
    while let Some(name) = wanted.pop() {
        if said.get(name).is_none() || name == "models" {
            let example = || examples.get(name).unwrap_or_else(|| panic!("no example of {name}")).clone();
            said[name] = example_of(verb, name).unwrap_or_else(example);
            wanted.extend(fields_needed_by(schema, name));
        }
    }
    // A fit is of a curve, or of a motion.
    if verb == Verb::Fit && said.get("motion").is_some() {
        said.as_object_mut().unwrap().remove("radius");
    }
    said
}

#[test]
fn every_spelled_field_of_every_verb_is_read_back() {
    for &verb in Verb::ALL {
        let schema = schema_of(verb).to_value();
        for field in schema["properties"].as_object().unwrap().keys().filter(|field| *field != "verb") {
            let request = request_of_json(&example_request_with_field(verb, &schema, field));
            assert!(request.to_map().contains_key(field), "{verb:?}: {field} says nothing");
            let line = command_line_of(&request);
            assert_eq!(read_back(&line), request, "{line}");
        }
    }
}

/// Fields without a name in calls have no option on the command line; the exception is `set`, which has models and assignments in
/// one list.
#[test]
fn positional_fields_have_no_option_on_a_command_line() {
    for &verb in Verb::ALL.iter().filter(|verb| **verb != Verb::Set) {
        let command = parser(verb);
        let taken: Vec<&str> = command.get_positionals().map(|argument| argument.get_id().as_str()).collect();
        let schema = schema_of(verb).to_value();
        let declared = schema["x-positional"].as_array().into_iter().flatten().filter_map(Value::as_str);
        assert_eq!(declared.collect::<Vec<_>>(), taken, "{verb:?}");
    }
}

#[test]
fn lists_are_one_word_with_commas_where_an_option_takes_one() {
    let mut lists = 0;
    for &verb in Verb::ALL {
        let schema = schema_of(verb).to_value();
        for argument in parser(verb).get_arguments().filter(|argument| !argument.is_positional()) {
            let request =
                request_of_json(&example_request_with_field(verb, &schema, argument.get_id().as_str()));
            let Some(Value::Array(items)) = request.to_map().remove(argument.get_id().as_str()) else {
                continue;
            };
            let line = command_line_of(&request);
            let option = format!("--{}", argument.get_long().unwrap());
            let times = shlex::split(&line)
                .unwrap()
                .iter()
                .filter(|word| word.split('=').next() == Some(&option))
                .count();
            let expected = if argument.get_value_delimiter() == Some(',') { 1 } else { items.len() };
            assert_eq!(times, expected, "{line}");
            lists += usize::from(items.len() > 1);
        }
    }
    assert!(lists > 10, "{lists} lists");
}

#[test]
fn texts_with_quotes_and_blanks_are_read_back() {
    for text in [
        "a b",
        "it's",
        r#"12" foot"#,
        r"C:\my models\a",
        r"a\",
        r"\\server\a",
        "Fuß_ä",
        "モデル",
        "$HOME",
        "`id`",
        "$(id)",
        "a!b",
        "*",
        "a?",
        "[a]",
        "{a,b}",
        "~",
        "#a",
        "a;b",
        "a&b|c",
        "(a)",
        "<a>",
        "=a",
        "a%b",
        "^a",
        "a\nb",
        "a\tb",
        "“a”",
        "it's $5!",
        "--a",
        "-a b",
    ] {
        let request = request_of_json(&json!({
            "verb": "transfer", "models": [format!("{text}.osim")], "from": text, "output": text, "follow_bodies": true,
            "reference_sphere": text,
        }));
        let line = command_line_of(&request);
        let Request::Transfer(back) = read_back(&line) else { panic!("{line}") };
        let mut back = *back;
        let model = back.models[0].to_str().unwrap().to_owned();
        if let Some(hidden) = model.strip_prefix("./").filter(|_| text.starts_with('-')) {
            back.models = vec![hidden.into()];
        }
        assert_eq!(Request::from(back), request, "{line}");
    }
}

#[test]
fn unusual_body_names_are_read_back() {
    for body in ["foot l", "it's", r#"12""#, "$a", "-a", "Fuß", "a,b"] {
        let request = request_of_json(&json!({
            "verb": "add", "models": "a.osim", "from": "b.osim", "body_scale": {body: [1.1, 1e-6, 3]}, "body_map": [format!("{body}={body}")],
        }));
        let line = command_line_of(&request);
        assert_eq!(read_back(&line), request, "{line}");
    }
}

#[test]
fn a_calculation_has_no_model() {
    let design = json!({"verb": "design", "radius": 0.032, "indentation": 0.16, "mass": 62, "spheres": 6, "quiet": true});
    let design = request_of_json(&design);
    assert_eq!(read_back(&command_line_of(&design)), design);
    assert_eq!(
        Python.script(&design),
        "import osim_contact_scale as ocs\n\n\
         result = ocs.design(radius=0.032, indentation=0.16, mass=62, spheres=6)\n\
         print(result)"
    );
}

#[track_caller]
fn assert_python(json: &Value, expected: &[&str]) {
    let lines = Python.script(&request_of_json(json));
    assert_eq!(lines.lines().skip(2).collect::<Vec<_>>(), expected);
}

#[test]
fn a_result_without_a_file_is_printed_in_python() {
    assert_python(
        &json!({"verb": "inspect", "models": "~a.osim", "spheres": 6, "full": true}),
        &[r#"result = ocs.inspect("./~a.osim", spheres=6)"#, "print(result.models)"],
    );
    assert_python(
        &json!({"verb": "note", "models": "a.osim", "contacts_mass": 62.5, "dry_run": true, "diff": true}),
        &[r#"result = ocs.note("a.osim", contacts_mass=62.5)"#, "print(result)", "print(result.diff())"],
    );
    assert_python(
        &json!({"verb": "check", "models": ["a.osim", "b.osim"], "from": "g.osim", "deny": "warning", "report": "p.html",
            "force": true}),
        &[
            r#"result = ocs.check(["a.osim", "b.osim"], from_="g.osim", report="p.html", force=True)"#,
            "print(result.findings)",
        ],
    );
}

#[test]
fn many_models_are_changed_at_once_in_python() {
    assert_python(
        &json!({"verb": "set", "models": ["a.osim", "b.osim"], "set": {"stiffness": "x2"}, "output_dir": "out", "diff": true}),
        &[
            r#"result = ocs.many("set", ["a.osim", "b.osim"], stiffness="x2", output_dir="out")"#,
            "print(result)",
        ],
    );
    assert_python(
        &json!({"verb": "transfer", "models": "a.osim", "from": "g.osim", "summary": "run.csv", "resume": true}),
        &[
            r#"result = ocs.many("transfer", ["a.osim"], from_="g.osim", summary="run.csv", resume=True)"#,
            "print(result)",
        ],
    );
}
