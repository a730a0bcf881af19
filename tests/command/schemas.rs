//! JSON beside `schemas/`: what the other tests compare with them would be refused if it were wrong.

use serde_json::{Value, json};

use crate::support::{Bench, validation};

/// A real result with one thing changed.
fn changed(call: &str, change: impl FnOnce(&mut Value)) -> Vec<u8> {
    let mut value: Value = serde_json::from_str(&Bench::human().run(call).out()).unwrap();
    change(&mut value);
    format!("{value}\n").into_bytes()
}

const INSPECT: &str = "inspect human.osim --format json";

#[test]
fn a_true_result_passes() {
    validation::printed(INSPECT, &changed(INSPECT, |_| {}));
}

#[test]
#[should_panic(expected = "Additional properties are not allowed ('mass' was unexpected)")]
fn an_unknown_field_is_refused() {
    validation::printed(INSPECT, &changed(INSPECT, |seen| seen["mass"] = json!(62)));
}

#[test]
#[should_panic(expected = "\"gravity_m_s2\" is a required property")]
fn a_missing_field_is_refused() {
    let without = changed(INSPECT, |seen| {
        seen.as_object_mut().unwrap().remove("gravity_m_s2");
    });
    validation::printed(INSPECT, &without);
}

#[test]
#[should_panic(expected = "/spheres/0/name")]
fn another_type_is_refused() {
    validation::printed(INSPECT, &changed(INSPECT, |seen| seen["spheres"][0]["name"] = json!(1)));
}

#[test]
#[should_panic(expected = "fulfils none of [\"failure\"]")]
fn a_wrong_failure_is_refused() {
    validation::printed("inspect", b"{\"error\": \"no\"}\n");
}

#[test]
#[should_panic(expected = "fulfils none of [\"results/summary-line\"]")]
fn a_wrong_line_of_a_summary_is_refused() {
    validation::written("done.ndjson", b"{\"row\":1}\n");
}

#[test]
#[should_panic(expected = "assertion `left == right` failed")]
fn objects_of_a_list_that_differ_are_refused() {
    validation::alike(&json!({"symbols": [{"symbol": "x", "unit": "m"}, {"symbol": "y"}]}));
}

#[cfg(unix)]
mod names_that_are_no_text {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    use std::path::PathBuf;

    use super::*;
    use crate::support::fixture;

    const NAME: &[u8] = b"m\xE4use.osim";

    /// A folder with the human under a name in Latin-1, or nothing where the system refuses such names.
    fn bench() -> Option<Bench> {
        let bench = Bench::human();
        let copy = std::fs::copy(bench.path("human.osim"), bench.path("").join(OsStr::from_bytes(NAME)));
        if copy.is_err() {
            crate::support::skipped("names that are no UTF-8", "this system has no such names");
        }
        copy.is_ok().then_some(bench)
    }

    fn first_line(bench: &Bench, words: &[&str]) -> Value {
        let mut command = bench.command("");
        let named = |word: &&str| match *word {
            "NAME" => OsStr::from_bytes(NAME).to_owned(),
            word => word.into(),
        };
        let output = command.args(words.iter().map(named)).output().unwrap();
        validation::printed(&words.join(" "), &output.stdout);
        let text = String::from_utf8(output.stdout).unwrap();
        serde_json::from_str(text.lines().next().unwrap_or_default())
            .unwrap_or_else(|error| panic!("{error}: {text}"))
    }

    #[test]
    fn have_their_bytes_beside_them() {
        let Some(bench) = bench() else { return };
        for words in [
            &["inspect", "NAME", "--format", "json"][..],
            &["check", "NAME", "--format", "json"],
            &["drop-test", "NAME", "--format", "json"],
            &["rescale", "NAME", "--target-mass", "5", "--dry-run", "--format", "json"],
            &["sweep", "NAME", "--grid", "stiffness=x1,x2", "--dry-run", "--format", "json"],
            // It fails: nothing has that force.
            &["rescale", "NAME", "--target-mass", "5", "--select", "none", "--format", "json"],
        ] {
            let line = first_line(&bench, words);
            assert_eq!(line["model"], "m\u{FFFD}use.osim", "{words:?}");
            assert_eq!(line["model_bytes"], json!(NAME), "{words:?}");
        }
        // Names that are text have none.
        let line = first_line(&bench, &["inspect", "human.osim", "--format", "json"]);
        assert_eq!(line.get("model_bytes"), None);
    }

    #[test]
    fn have_their_bytes_in_a_summary_for_scripts() {
        let Some(bench) = bench() else { return };
        let words = ["--target-mass", "5", "-d", "out", "--summary", "done.ndjson"];
        let status = bench.command("").arg(OsStr::from_bytes(NAME)).args(words).status().unwrap();
        assert!(status.success());
        let line: Value = serde_json::from_str(&bench.text("done.ndjson")).unwrap();
        assert_eq!(line["model_bytes"], json!(NAME));
        let output: Vec<u8> = serde_json::from_value(line["output_bytes"].clone()).unwrap();
        let output = PathBuf::from(OsStr::from_bytes(&output));
        assert!(bench.path("").join(output).is_file(), "{line}");
    }

    #[test]
    fn stay_in_remedies_that_are_sent_back() {
        let Some(bench) = bench() else { return };
        std::fs::write(bench.path("").join(OsStr::from_bytes(NAME)), fixture("check/sunk_in.osim")).unwrap();
        let asked = json!({"verb": "check", "models": [{"bytes": NAME}], "format": "json"}).to_string();
        let found: Value =
            serde_json::from_str(&bench.run_with("request -", asked.as_bytes()).out()).unwrap();
        let remedy = found["findings"][0]["command"].as_str().unwrap();
        bench.run_with("request -", remedy.as_bytes()).done().says(&["scaled.osim"]);
    }

    #[test]
    fn can_be_asked_for_by_their_bytes() {
        let Some(bench) = bench() else { return };
        let asked = json!({"verb": "inspect", "models": [{"bytes": NAME}], "format": "json"}).to_string();
        let seen = bench.run_with("request -", asked.as_bytes()).done();
        let seen: Value = serde_json::from_str(&seen.out()).unwrap();
        assert_eq!(seen["model_bytes"], json!(NAME));
    }
}
