//! Runs the verbs that use the paper's equations: design, set, drop-test, fit, presets.
//!
//! Expected numbers come from the paper's Table 1, from OpenSim, or from mpmath 1.3.0 with 40 digits; the comment beside a number
//! names its source. No number is copied from the command's output. Layout and wording are compared with snapshots.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::print_stderr,
    reason = "a test fails by panicking and says aloud what it skips"
)]

#[path = "physics/correct.rs"]
mod correct;
#[path = "physics/design.rs"]
mod design;
#[path = "physics/drop_test.rs"]
mod drop_test;
#[path = "physics/fit.rs"]
mod fit;
#[path = "physics/fit_determined.rs"]
mod fit_determined;
#[path = "physics/fit_motion.rs"]
mod fit_motion;
#[path = "physics/motion.rs"]
mod motion;
#[path = "physics/presets.rs"]
mod presets;
#[path = "physics/set.rs"]
mod set;
#[path = "command/support.rs"]
#[allow(dead_code, reason = "shared with the tests of the command, which use all of it")]
mod support;

use std::collections::BTreeMap;

use serde_json::Value;

use support::CommandRun;

/// The one JSON object that a run prints.
#[track_caller]
fn json_object(run: &CommandRun) -> Value {
    let text = run.out();
    assert_eq!(text.lines().count(), 1, "{text}");
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

/// A number of a JSON object.
#[track_caller]
fn number(object: &Value, name: &str) -> f64 {
    object[name].as_f64().unwrap_or_else(|| panic!("no number '{name}' in {object}"))
}

/// Asserts that the relative difference between `value` and `expected` is at most `within`.
#[track_caller]
fn assert_close(value: f64, expected: f64, within: f64, what: &str) {
    assert!((value - expected).abs() <= within * expected.abs(), "{what}: {value:?}, expected {expected:?}");
}

/// The changes that a run with `--format json` reports: each property with its old and new value, which all forces have in common.
#[track_caller]
fn changes_in_json(run: &CommandRun) -> BTreeMap<String, (f64, f64)> {
    let plan = json_object(run);
    let mut by_property: BTreeMap<String, (f64, f64)> = BTreeMap::new();
    for change in plan["changes"].as_array().unwrap() {
        let name = change["property"].as_str().unwrap().to_owned();
        let values = (number(change, "from"), number(change, "to"));
        let first = *by_property.entry(name.clone()).or_insert(values);
        assert_eq!(values, first, "{name} is not the same everywhere");
    }
    by_property
}

/// Lines that differ between two texts with the same number of lines, as trimmed pairs `(before, after)`; notes do not count.
#[track_caller]
fn changed_lines(before: &str, after: &str) -> Vec<(String, String)> {
    let body = |text: &str| -> Vec<String> {
        let without_note = |line: &str| match line.split_once("; [contacts made for ") {
            Some((credits, note)) => format!("{credits}{}", note.split_once(")]").unwrap().1),
            None => line.to_owned(),
        };
        text.lines().map(|line| without_note(line.trim())).collect()
    };
    let (before, after) = (body(before), body(after));
    assert_eq!(before.len(), after.len(), "lines came or went");
    before.into_iter().zip(after).filter(|(old, new)| old != new).collect()
}
