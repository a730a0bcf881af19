//! Tests of requests from dictionaries: their fields, and the messages about wrong fields.

use osim_model::messages::{Input, Verb};
use osim_requests::{Request, RequestFault, schema_of};
use serde_json::{Value, json};

fn read(json: &Value) -> Result<Request, RequestFault> {
    Request::from_json(json.to_string().as_bytes())
}

/// A request to rescale `a.osim` with additional `fields`.
fn rescale_request(fields: &Value) -> Result<Request, RequestFault> {
    read(&with_fields(json!({"verb": "rescale", "models": ["a.osim"]}), fields))
}

fn with_fields(mut request: Value, fields: &Value) -> Value {
    for (field, value) in fields.as_object().into_iter().flatten() {
        request[field] = value.clone();
    }
    request
}

#[test]
fn fields_have_the_names_of_the_options() {
    let request = read(&json!({
        "verb": "transfer",
        "models": ["a.osim", "b.osim"],
        "from": "generic.osim",
        "spheres": 4,
        "follow_bodies": true,
        "body_scale": {"calcn_r": [1.1, 1.05, 1.1]},
        "only": ["stiffness", "radius"],
        "select": "*_r",
    }));
    let Ok(Request::Transfer(request)) = request else { panic!("{request:?}") };
    assert_eq!(request.models, ["a.osim", "b.osim"].map(std::path::PathBuf::from));
    assert_eq!(request.follow.body_scale[0].factors, [1.1, 1.05, 1.1]);
    assert_eq!(request.scaling.only.len(), 2);
    assert!(request.choice.select[0].matches("heel_r"));
}

#[test]
fn fields_with_default_values_are_left_out() {
    let request =
        rescale_request(&json!({"models": "a.osim", "target_mass": 70, "select": null, "level": false}))
            .unwrap();
    assert_eq!(
        Value::Object(request.to_map()),
        json!({"verb": "rescale", "models": ["a.osim"], "target_mass": 70.0})
    );
    assert_eq!(Request::from_json(request.to_json().as_bytes()), Ok(request));
}

#[test]
fn a_single_text_is_read_as_a_list() {
    let added = |feet: Value| {
        read(&json!({"verb": "add", "models": "a.osim", "from": "b.osim", "feet": feet, "pad": 0.01}))
    };
    assert_eq!(added(json!("calcn_r")), added(json!(["calcn_r"])));
    assert!(added(json!("calcn_r")).is_ok());
}

#[test]
fn the_message_about_a_wrong_field_has_its_name_and_advice() {
    for (fields, field, hint) in [
        (json!({"target_mass": "20.9g"}), "target_mass", "type 0.0209"),
        (json!({"target_mas": 62}), "target_mas", "did you mean `target_mass`"),
        (json!({"radius": "huge"}), "radius", "expected isometric, keep"),
        (json!({"only": ["stifness"]}), "only", "there is no property 'stifness'"),
        (json!({"level_axis": "y"}), "level_axis", "needs `level`"),
        (json!({"in_place": true, "output": "b.osim"}), "in_place", "exclude each other"),
        (json!({"dissipation_by": "height"}), "dissipation_by", "expected one of radius, mass"),
        (json!({"jobs": 0}), "jobs", "expected a whole number from 1 to 4096"),
        (json!({"jobs": -1}), "jobs", "expected a whole number from 1 to 4096"),
        (json!({"target_mass": [5, 6]}), "target_mass", "'[5,6]': a list, expected one number or one text"),
        (
            json!({"target_mass": {}}),
            "target_mass",
            "'{}': names with values, expected one number or one text",
        ),
        (json!({"target_mass": true}), "target_mass", "'true': expected a number or a text"),
        (json!({"models": 7}), "models", "expected the name of a file, as text or as"),
        (json!({"output": ""}), "output", "it is empty, expected the name of a file"),
        (json!({"output": {"bytes": [97], "byte": [98]}}), "output", "expected the name of a file"),
        // Also where it says nothing, and however it is spelled.
        (json!({"outptu": null}), "outptu", "did you mean `output`"),
        (json!({"target-mass": 5}), "target-mass", "did you mean `target_mass`"),
    ] {
        let fault = rescale_request(&fields).unwrap_err();
        assert_eq!(fault.field(), Some(field), "{fields}: {fault}");
        assert!(fault.to_string().contains(hint), "{fields}: {fault}");
    }
    for (text, hint) in [
        ("{", "this is not JSON"),
        ("[]", "expected a JSON object"),
        ("{}", "`verb` is missing"),
        ("{\"verb\": \"rescale\", \"verb\": \"set\"}", "'verb' appears twice at line 1 column"),
        ("{\"verb\": \"set\", \"set\": {\"radius\": 1, \"radius\": 2}}", "'radius' appears twice"),
        ("{\"verb\": \"rescal\"}", "expected one of rescale, transfer"),
        ("{\"verb\": \"rescale\", \"target_mass\": 5}", "`models` is missing"),
    ] {
        let fault = Request::from_json(text.as_bytes()).unwrap_err().to_string();
        assert!(fault.contains(hint), "{text}: {fault}");
    }
}

#[test]
fn properties_keep_their_given_order() {
    let request =
        read(&json!({"verb": "set", "models": "a.osim", "set": {"stiffness": "x2", "dissipation": 1}}));
    let Ok(Request::Set(request)) = request else { panic!("{request:?}") };
    let names: Vec<&str> = request.set.as_slice().iter().map(|(property, _)| property.as_str()).collect();
    assert_eq!(names, ["stiffness", "dissipation"]);
}

#[test]
fn every_verb_has_a_schema_that_its_own_requests_fulfil() {
    for (verb, fields) in [
        (
            Verb::Rescale,
            json!({"models": ["a.osim"], "target_mass": 70, "radius": "x1.5", "output": "b.osim"}),
        ),
        (Verb::Transfer, json!({"models": ["a.osim"], "from": "falisse2022", "radius": 0.03})),
        (
            Verb::Design,
            json!({"indentation": 0.16, "spheres": 4, "mass": 62, "radius": 0.02, "poisson": 0.5, "young": 1e6}),
        ),
        (Verb::Set, json!({"models": ["a.osim"], "set": {"stiffness": "x2", "dissipation": 1}})),
        (
            Verb::Batch,
            json!({"manifest": "table.csv", "output_dir": "out", "resume": true, "summary": "s.csv"}),
        ),
        (
            Verb::Sweep,
            json!({"model": "a.osim", "grid": {"stiffness": "x0.1..x10/9", "dissipation": [0.5, 1]}}),
        ),
        (Verb::Inspect, json!({"models": ["a.osim"], "format": "json"})),
        (Verb::Check, json!({"models": ["a.osim"], "deny": "warning", "stance_limbs": 2})),
        (Verb::DropTest, json!({"subject": "falisse2022", "height": "x0.25", "samples": 11})),
        (
            Verb::Plot,
            json!({"kind": "force", "models": ["a.osim"], "output": "a.svg", "stiffness": "1e5..1e6/3"}),
        ),
        (Verb::Fit, json!({"file": "a.csv", "radius": 0.01, "onset": "fit", "indentation_unit": "mm"})),
        (Verb::Reproduce, json!({"output_dir": "paper", "force": true, "format": "json"})),
        (Verb::Presets, json!({"name": "falisse2022"})),
        (Verb::Explain, json!({"topics": ["10"], "ascii": true})),
    ] {
        let schema = Value::from(schema_of(verb));
        let validator = jsonschema::validator_for(&schema).unwrap();
        let Value::Object(map) = fields.clone() else { panic!() };
        let request = Request::read(verb, map).unwrap();
        for value in [request.to_map().into(), with_fields(json!({"verb": verb.name()}), &fields)] {
            let errors: Vec<String> = validator.iter_errors(&value).map(|error| error.to_string()).collect();
            assert!(errors.is_empty(), "{}: {value}: {errors:?}", verb.name());
        }
        assert!(
            !validator.is_valid(&with_fields(json!({"verb": verb.name()}), &json!({"nonsense": 1}))),
            "{}",
            verb.name()
        );
    }
}

#[test]
fn a_schema_has_the_relations_between_fields() {
    let schema = Value::from(schema_of(Verb::Rescale));
    let validator = jsonschema::validator_for(&schema).unwrap();
    for (fields, valid) in [
        (json!({"models": "a.osim", "select": "heel_*", "only": "radius"}), true),
        (json!({"models": [], "target_mass": 5}), false),
        (json!({"format": null, "dissipation_by": null, "jobs": null}), true),
        (json!({"level": true, "level_axis": "y"}), true),
        (json!({"level_axis": "y"}), false),
        (json!({"in_place": true, "output": "b.osim"}), false),
        (json!({"in_place": false, "output": "b.osim"}), true),
        (json!({"target_mass": 0}), false),
        (json!({"target_mass": null}), true),
    ] {
        assert_eq!(
            validator.is_valid(&with_fields(json!({"verb": "rescale", "models": ["a.osim"]}), &fields)),
            valid,
            "{fields}"
        );
        assert_eq!(rescale_request(&fields).is_ok(), valid, "{fields}");
    }
}

#[test]
fn an_object_of_defaults_is_valid_in_the_schema() {
    for (fields, valid) in [
        (json!({"verb": "transfer", "models": ["a.osim"], "from": "b.osim", "body_scale": {}}), true),
        (
            json!({"verb": "transfer", "models": ["a.osim"], "from": "b.osim", "body_scale": {"toes": [1, 1, 1]}}),
            false,
        ),
        (json!({"verb": "sweep", "model": "a.osim", "grid": {}}), false),
        (json!({"verb": "set", "models": ["a.osim"], "set": {}}), false),
        (json!({"verb": "set", "models": ["a.osim"], "level": true}), true),
        (json!({"verb": "set", "models": ["a.osim"], "level": false}), false),
        (json!({"verb": "set", "models": ["a.osim"], "set": "stiffness=x2"}), true),
        (json!({"verb": "sweep", "model": "a.osim", "grid": "stiffness=x1,x2"}), true),
    ] {
        let verb = Verb::ALL.iter().find(|verb| fields["verb"] == verb.name()).unwrap();
        let schema = Value::from(schema_of(*verb));
        assert_eq!(jsonschema::is_valid(&schema, &fields), valid, "{fields}");
        assert_eq!(read(&fields).is_ok(), valid, "{fields}: {:?}", read(&fields));
    }
}

#[test]
fn json_with_a_byte_order_mark_is_read() {
    let request = r#"{"verb": "explain"}"#;
    let marked = [b"\xEF\xBB\xBF", request.as_bytes()].concat();
    assert_eq!(Request::from_json(&marked), Request::from_json(request.as_bytes()));
    let utf16: Vec<u8> =
        std::iter::once(0xFEFF).chain(request.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    assert!(Request::from_json(&utf16).unwrap_err().to_string().contains("save it as UTF-8"));
}

#[test]
fn a_number_may_be_its_text_as_in_a_table() {
    let request = rescale_request(&json!({"target_mass": "70", "jobs": "2"})).unwrap();
    assert_eq!(request.to_map()["jobs"], 2);
    assert_eq!(request.to_map()["target_mass"], 70.0);
}

#[test]
fn a_body_may_have_any_name() {
    let fields = json!({
        "verb": "transfer", "models": ["a.osim"], "from": "b.osim",
        "follow_bodies": true, "body_scale": {"a=b": [1.0, 2.0, 0.5]},
    });
    let Ok(Request::Transfer(request)) = read(&fields) else { panic!("{:?}", read(&fields)) };
    assert_eq!(
        (&*request.follow.body_scale[0].body, request.follow.body_scale[0].factors),
        ("a=b", [1.0, 2.0, 0.5])
    );
    let none = with_fields(fields, &json!({"body_scale": {"calcn_r": [1, 0, 1]}}));
    assert!(read(&none).unwrap_err().to_string().contains("calcn_r: expected three factors above 0"));
}

/// Standard input can be read only once, so that a request from standard input must not name it as a file to read.
#[test]
fn a_file_that_is_read_is_found_in_every_option() {
    for (fields, option) in [
        (json!({"verb": "inspect", "models": ["a.osim", "-"]}), Some("models")),
        (json!({"verb": "check", "models": "a.osim", "motion": "-", "plates": "p.mot"}), Some("motion")),
        (
            json!({"verb": "fit", "file": "a.osim", "motion": "m.mot", "plates": ["p.mot", "-"]}),
            Some("plates"),
        ),
        (json!({"verb": "fit", "file": "a.osim", "motion": "m", "plates": "p", "loads": "-"}), Some("loads")),
        (json!({"verb": "add", "models": "a.osim", "contacts": "-"}), Some("contacts")),
        (
            json!({"verb": "plot", "kind": "sweep", "output": "-", "table": "-", "value_column": "a"}),
            Some("table"),
        ),
        (
            json!({"verb": "check", "models": "a.osim", "from": "g.osim", "moco_setup": "-"}),
            Some("moco_setup"),
        ),
        (
            json!({"verb": "check", "models": "a.osim", "from": "g.osim", "moco_setup": "m", "from_moco_setup": "-"}),
            Some("from_moco_setup"),
        ),
        (json!({"verb": "set", "models": "a.xml", "set": "stiffness=x2", "model": "-"}), Some("model")),
        (json!({"verb": "rescale", "models": "a.osim", "target_mass": 70, "output": "-"}), None),
    ] {
        let request = read(&fields).unwrap();
        assert_eq!(request.option_that_reads("-".as_ref()), option, "{fields}");
    }
}

/// Each field of a front end is an [`Input`].
#[test]
fn every_option_is_an_input() {
    const OPERANDS: [&str; 7] = ["verb", "models", "subject", "manifest", "file", "name", "set"];
    for verb in Verb::ALL {
        let schema = Value::from(schema_of(*verb));
        for field in schema["properties"].as_object().unwrap().keys() {
            assert_eq!(Input::find(field).is_some(), !OPERANDS.contains(&field.as_str()), "{field}");
        }
    }
}
