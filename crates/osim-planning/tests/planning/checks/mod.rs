//! What `check` finds in a model, and the sphere that has it.

<<<<<<<< HEAD:crates/osim-planning/tests/checks/mod.rs
use osim_inspect::{CheckResult, InspectOptions};
========
use osim_inspect::{CheckResult, InspectOptions, check_model};
>>>>>>>> e969d3c (One program of integration tests per crate):crates/osim-inspect/tests/inspect/checks/mod.rs
use osim_model::{Finding, FindingCode, Model};
use osim_planning::check_with_trials;

use crate::feet::{Smooth, foot};

/// What is found in a model that is called `name`.
pub fn check_with(name: &str, text: &str, options: &InspectOptions) -> CheckResult {
    let model = Model::parse(text).unwrap();
    check_with_trials(options, &model, &options.inspect(name, &model, None), None)
}

pub fn check_text(text: &str) -> CheckResult {
    check_with("model.osim", text, &InspectOptions::default())
}

pub fn check_foot(spheres: &[Smooth]) -> CheckResult {
    check_text(&foot(spheres))
}

pub fn codes(result: &CheckResult) -> Vec<FindingCode> {
    result.findings.iter().map(|finding| finding.code).collect()
}

pub fn has(result: &CheckResult, code: FindingCode) -> bool {
    codes(result).contains(&code)
}

#[track_caller]
pub fn find(result: &CheckResult, code: FindingCode) -> &Finding {
    let found = result.findings.iter().find(|finding| finding.code == code);
    found.unwrap_or_else(|| panic!("no {code:?}: {:?}", codes(result)))
}

#[track_caller]
pub fn message(result: &CheckResult, code: FindingCode) -> String {
    find(result, code).message.to_string()
}
