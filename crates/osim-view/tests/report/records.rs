//! Tests of the JSON records for scripts.

use std::path::Path;

use osim_model::files::Failure;
use osim_model::{Fault, MissingFact};
use osim_requests::spell::{CommandLine, Python};
use osim_view::report::json::{FailureRecord, PlanRecord, line};

use crate::support::{open, rescaled};

#[test]
fn a_plan_is_one_line_with_its_fields_in_order() {
    let model = open("table1/mouse_hunt_crossley.osim");
    let plan = rescaled(&model.model, 0.1, &CommandLine);
    let record =
        PlanRecord::new(&plan, &model.model, Path::new("mouse.osim"), Some(Path::new("rat.osim")), None);
    let text = line(&record);
    assert!(text.ends_with("}\n") && text.lines().count() == 1, "{text}");
    let head = r#"{"schema_version":1,"model":"mouse.osim","output":"rat.osim","contacts_mass_kg":{"value":0.0209,"source":"bodies"},"target_mass_kg":0.1,"objects":[],"changes":[{"force":null,"path":"/contactgeometryset/"#;
    assert!(text.starts_with(head), "{text}");
    let value: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(value["changes"].as_array().unwrap().len(), plan.changes.len());
    assert_eq!(value["remarks"][0], "body masses and sphere locations stay as they are");
}

#[cfg(unix)]
#[test]
fn a_name_that_is_not_utf_8_has_its_bytes_beside_it() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt as _;

    let model = open("table1/mouse_hunt_crossley.osim");
    let plan = rescaled(&model.model, 0.1, &CommandLine);
    let odd = Path::new(OsStr::from_bytes(b"m\xFCsli.osim"));
    let text = line(&PlanRecord::new(&plan, &model.model, odd, None, None));
    let bytes: Vec<String> = b"m\xFCsli.osim".iter().map(ToString::to_string).collect();
    let expected =
        format!("\"model\":\"m\u{fffd}sli.osim\",\"model_bytes\":[{}],\"output\":null", bytes.join(","));
    assert!(text.contains(&expected), "{text}");
    let failure = Failure::outside(odd, "unreadable", "it is not there");
    let text = line(&FailureRecord::new(&failure, &CommandLine));
    assert!(text.contains("\"model_bytes\":[109,252,"), "{text}");
}

#[test]
fn a_failure_is_told_in_the_words_of_its_front_end() {
    let failure = Failure::from_fault(
        "walker.osim",
        Fault::new(MissingFact::Gravity { purpose: osim_model::GravityFor::Weight }),
    );
    let text = |dialect| line(&FailureRecord::new(&failure, dialect));
    assert_eq!(
        text(&CommandLine),
        "{\"schema_version\":1,\"model\":\"walker.osim\",\"error\":{\"code\":\"refused\",\"message\":\"the model has no \
         gravity: give --gravity G\",\"line\":null,\"column\":null}}\n"
    );
    assert!(text(&Python).contains("give gravity=G"));
}

#[test]
fn schemas_are_strict_and_allow_null_for_what_is_not_finite() {
    let schema = serde_json::to_value(schemars::schema_for!(PlanRecord)).unwrap();
    assert_eq!(schema["additionalProperties"], false);
    let amount = schema["$defs"]["Amount"].to_string();
    assert_eq!(amount.matches("\"null\"").count(), 2, "{amount}");
    let schema = serde_json::to_value(schemars::schema_for!(FailureRecord)).unwrap();
    assert_eq!(schema["$defs"]["ErrorRecord"]["additionalProperties"], false);
}
