//! Helpers that run `check` on a model and look up findings and remedies.

use osim_inspect::{CheckResult, FindingWithRemedy, InspectOptions};
use osim_model::{FindingCode, Model, Rule};
use osim_planning::{check_with_trials, rules};
use osim_requests::Request;
use serde_json::Value;

use crate::feet::{SmoothContact, foot};

/// The result of `check` for the model `text`, which is called `name`.
pub fn check_with(name: &str, text: &str, options: &InspectOptions) -> CheckResult {
    let model = Model::parse(text).unwrap();
    check_with_trials(options, &model, &options.inspect(name, &model, None), &[])
}

pub fn check_text(text: &str) -> CheckResult {
    check_with("model.osim", text, &InspectOptions::default())
}

pub fn check_foot(spheres: &[SmoothContact]) -> CheckResult {
    check_text(&foot(spheres))
}

/// The rule with this code.
pub fn rule(code: FindingCode) -> &'static Rule {
    rules::with_code(|one| one == code).next().unwrap()
}

pub fn codes(result: &CheckResult) -> Vec<FindingCode> {
    result.findings.iter().map(|finding| finding.code()).collect()
}

pub fn has(result: &CheckResult, code: FindingCode) -> bool {
    codes(result).contains(&code)
}

#[track_caller]
pub fn find(result: &CheckResult, code: FindingCode) -> &FindingWithRemedy {
    let found = result.findings.iter().find(|finding| finding.code() == code);
    found.unwrap_or_else(|| panic!("no {code:?}: {:?}", codes(result)))
}

#[track_caller]
pub fn message(result: &CheckResult, code: FindingCode) -> String {
    find(result, code).message.to_string()
}

/// The request that corrects the finding `code`, as a dictionary without the model; null if there is none.
#[track_caller]
pub fn remedy(result: &CheckResult, code: FindingCode) -> Value {
    remedy_without_models(find(result, code).remedy.as_ref())
}

/// The fields of the request that a remedy is, without `models`; null without a remedy.
pub fn remedy_without_models(remedy: Option<&Request>) -> Value {
    let Some(remedy) = remedy else { return Value::Null };
    let mut fields = remedy.to_map();
    fields.shift_remove("models");
    Value::Object(fields)
}

/// The model `text` in which the first `old` after `start` is replaced by `new`.
pub fn with_text_replaced(text: &str, start: &str, old: &str, new: &str) -> String {
    let (before, rest) = text.split_at(text.find(start).unwrap());
    assert!(rest.contains(old), "{old}");
    format!("{before}{}", rest.replacen(old, new, 1))
}
