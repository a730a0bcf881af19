//! Tests that the comparison of JSON with `schemas/`, which all tests in this folder make, fails if the JSON is wrong.

use serde_json::{Value, json};

use crate::support::{TestDir, schema_validation};

/// The JSON that `call` prints, after `change` altered it.
fn changed_result(call: &str, change: impl FnOnce(&mut Value)) -> Vec<u8> {
    let mut value: Value = serde_json::from_str(&TestDir::with_human().run(call).out()).unwrap();
    change(&mut value);
    format!("{value}\n").into_bytes()
}

const INSPECT_CALL: &str = "inspect human.osim --format json";

#[test]
fn the_schema_accepts_a_valid_result() {
    schema_validation::validate_stdout(INSPECT_CALL, &changed_result(INSPECT_CALL, |_| {}));
}

#[test]
#[should_panic(expected = "Additional properties are not allowed ('mass' was unexpected)")]
fn the_schema_refuses_an_unknown_field() {
    schema_validation::validate_stdout(
        INSPECT_CALL,
        &changed_result(INSPECT_CALL, |inspection| inspection["mass"] = json!(62)),
    );
}

#[test]
#[should_panic(expected = "\"gravity_m_s2\" is a required property")]
fn the_schema_refuses_a_missing_field() {
    let incomplete = changed_result(INSPECT_CALL, |inspection| {
        inspection.as_object_mut().unwrap().remove("gravity_m_s2");
    });
    schema_validation::validate_stdout(INSPECT_CALL, &incomplete);
}

#[test]
#[should_panic(expected = "/spheres/0/name")]
fn a_value_of_another_type_is_refused() {
    schema_validation::validate_stdout(
        INSPECT_CALL,
        &changed_result(INSPECT_CALL, |inspection| inspection["spheres"][0]["name"] = json!(1)),
    );
}

#[test]
#[should_panic(expected = "fulfils none of [\"failure\"]")]
fn the_schema_refuses_a_wrong_failure() {
    schema_validation::validate_stdout("inspect", b"{\"error\": \"no\"}\n");
}

#[test]
#[should_panic(expected = "fulfils none of [\"results/summary-line\"]")]
fn a_wrong_line_of_a_summary_is_refused() {
    schema_validation::validate_file("done.ndjson", b"{\"row\":1}\n");
}

#[test]
#[should_panic(expected = "assertion `left == right` failed")]
fn objects_of_a_list_that_differ_are_refused() {
    schema_validation::assert_uniform_lists(
        &json!({"symbols": [{"symbol": "x", "unit": "m"}, {"symbol": "y"}]}),
    );
}

#[cfg(unix)]
mod names_that_are_not_utf_8 {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    use std::path::PathBuf;

    use super::*;
    use crate::support::fixture;

    const NAME_IN_LATIN_1: &[u8] = b"m\xE4use.osim";

    /// A folder with a human whose file name is in Latin-1; `None` if the system refuses such names.
    fn dir_with_latin1_name() -> Option<TestDir> {
        let dir = TestDir::with_human();
        let copy =
            std::fs::copy(dir.path("human.osim"), dir.path("").join(OsStr::from_bytes(NAME_IN_LATIN_1)));
        if copy.is_err() {
            crate::support::report_skip("names that are no UTF-8", "this system has no such names");
        }
        copy.is_ok().then_some(dir)
    }

    fn first_line(dir: &TestDir, words: &[&str]) -> Value {
        let mut command = dir.command("");
        let argument = |word: &&str| match *word {
            "NAME" => OsStr::from_bytes(NAME_IN_LATIN_1).to_owned(),
            word => word.into(),
        };
        let output = command.args(words.iter().map(argument)).output().unwrap();
        schema_validation::validate_stdout(&words.join(" "), &output.stdout);
        let text = String::from_utf8(output.stdout).unwrap();
        serde_json::from_str(text.lines().next().unwrap_or_default())
            .unwrap_or_else(|error| panic!("{error}: {text}"))
    }

    #[test]
    fn paths_that_are_not_unicode_have_their_bytes_in_json() {
        let Some(dir) = dir_with_latin1_name() else { return };
        for words in [
            &["inspect", "NAME", "--format", "json"][..],
            &["check", "NAME", "--format", "json"],
            &["drop-test", "NAME", "--format", "json"],
            &["rescale", "NAME", "--target-mass", "5", "--dry-run", "--format", "json"],
            &["sweep", "NAME", "--grid", "stiffness=x1,x2", "--dry-run", "--format", "json"],
            // It fails: nothing has that force.
            &["rescale", "NAME", "--target-mass", "5", "--select", "none", "--format", "json"],
        ] {
            let line = first_line(&dir, words);
            assert_eq!(line["model"], "m\u{FFFD}use.osim", "{words:?}");
            assert_eq!(line["model_bytes"], json!(NAME_IN_LATIN_1), "{words:?}");
        }
        // Names that are text have none.
        let line = first_line(&dir, &["inspect", "human.osim", "--format", "json"]);
        assert_eq!(line.get("model_bytes"), None);
    }

    #[test]
    fn paths_that_are_not_unicode_have_their_bytes_in_a_json_summary() {
        let Some(dir) = dir_with_latin1_name() else { return };
        let words = ["--target-mass", "5", "-d", "out", "--summary", "done.ndjson"];
        let status = dir.command("").arg(OsStr::from_bytes(NAME_IN_LATIN_1)).args(words).status().unwrap();
        assert!(status.success());
        let line: Value = serde_json::from_str(&dir.text("done.ndjson")).unwrap();
        assert_eq!(line["model_bytes"], json!(NAME_IN_LATIN_1));
        let output: Vec<u8> = serde_json::from_value(line["output_bytes"].clone()).unwrap();
        let output = PathBuf::from(OsStr::from_bytes(&output));
        assert!(dir.path("").join(output).is_file(), "{line}");
    }

    #[test]
    fn paths_that_are_not_unicode_stay_in_remedies() {
        let Some(dir) = dir_with_latin1_name() else { return };
        std::fs::write(dir.path("").join(OsStr::from_bytes(NAME_IN_LATIN_1)), fixture("check/sunk_in.osim"))
            .unwrap();
        let request =
            json!({"verb": "check", "models": [{"bytes": NAME_IN_LATIN_1}], "format": "json"}).to_string();
        let check: Value =
            serde_json::from_str(&dir.run_with_stdin("request -", request.as_bytes()).out()).unwrap();
        let remedy = check["findings"][0]["command"].as_str().unwrap();
        dir.run_with_stdin("request -", remedy.as_bytes()).succeeded().says(&["scaled.osim"]);
    }

    #[test]
    fn a_request_can_name_a_path_by_its_bytes() {
        let Some(dir) = dir_with_latin1_name() else { return };
        let request =
            json!({"verb": "inspect", "models": [{"bytes": NAME_IN_LATIN_1}], "format": "json"}).to_string();
        let inspection = dir.run_with_stdin("request -", request.as_bytes()).succeeded();
        let inspection: Value = serde_json::from_str(&inspection.out()).unwrap();
        assert_eq!(inspection["model_bytes"], json!(NAME_IN_LATIN_1));
    }
}
