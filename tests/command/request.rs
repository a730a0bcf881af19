//! The verb `request` makes a call that is given as a JSON object.

use serde_json::{Value, json};

use crate::support::{HUMAN, TestDir};

fn run_request(dir: &TestDir, request: &Value) -> crate::support::CommandRun {
    dir.run_with_stdin("request -", request.to_string().as_bytes())
}

#[test]
fn a_request_makes_the_same_change_as_the_options() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 5 --only stiffness,radius -o called.osim").succeeded();
    dir.write(
        "request.json",
        json!({
            "verb": "rescale",
            "models": ["human.osim"],
            "target_mass": 5,
            "only": ["stiffness", "radius"],
            "output": "requested.osim",
        })
        .to_string(),
    );
    dir.run("request request.json").succeeded().wrote(&["requested.osim"]);
    assert_eq!(dir.read("requested.osim"), dir.read("called.osim"));
}

#[test]
fn a_request_prints_the_same_output_as_the_call() {
    let dir = TestDir::with_human();
    for (call, fields) in [
        (
            "inspect human.osim --format json",
            json!({"verb": "inspect", "models": "human.osim", "format": "json"}),
        ),
        ("design --mass 62 --spheres 6 --radius 0.032", {
            json!({"verb": "design", "mass": 62, "spheres": 6, "radius": 0.032})
        }),
        ("explain C.2", json!({"verb": "explain", "topics": ["C.2"]})),
        (
            "presets falisse2022 --format json",
            json!({"verb": "presets", "name": "falisse2022", "format": "json"}),
        ),
    ] {
        let (by_call, by_request) = (dir.run(call), run_request(&dir, &fields));
        assert_eq!((by_call.status, by_call.out()), (by_request.status, by_request.out()), "{call}");
    }
}

#[test]
fn messages_about_a_request_are_spelled_as_requests() {
    let dir = TestDir::with(&[HUMAN, ("check/wide_transition.osim", "model.osim")]);
    let checked = run_request(&dir, &json!({"verb": "check", "models": ["model.osim"], "format": "json"}));
    let checked: Value = serde_json::from_str(&checked.succeeded().out()).unwrap();
    let remedy = checked["findings"][0]["command"].as_str().unwrap();
    // The remedy is a request itself, and is one that runs.
    let fields: Value = serde_json::from_str(remedy).unwrap();
    assert_eq!(fields["verb"], "design");
    dir.run_with_stdin("request -", remedy.as_bytes()).succeeded().wrote(&["model.scaled.osim"]);

    run_request(&dir, &json!({"verb": "design", "models": ["human.osim"]}))
        .usage_error()
        .says(&["\"indentation\""])
        .wrote_nothing();
}

#[test]
fn messages_for_matlab_are_spelled_in_matlab() {
    let dir = TestDir::with(&[HUMAN, ("check/wide_transition.osim", "model.osim")]);
    let run_matlab_request =
        |request: &Value| dir.run_with_stdin("request --words matlab -", request.to_string().as_bytes());
    let checked = run_matlab_request(&json!({"verb": "check", "models": ["model.osim"], "format": "json"}));
    let checked: Value = serde_json::from_str(&checked.succeeded().out()).unwrap();
    let remedy = checked["findings"][0]["command"].as_str().unwrap();
    assert!(remedy.starts_with("osimcontact.design('model.osim', "), "{remedy}");

    run_matlab_request(&json!({"verb": "design", "models": ["human.osim"]}))
        .usage_error()
        .says(&["give for example 'Indentation', X"]);
    let unknown = json!({"verb": "set", "models": ["human.osim"], "set": {"stifness": 2, "radius": "x2"}});
    run_matlab_request(&unknown)
        .usage_error()
        .says(&["'stifness=2 radius=x2': there is no property 'stifness'"]);
}

#[test]
fn a_wrong_request_is_refused_with_a_way_out() {
    let dir = TestDir::with_human();
    for (text, expected) in [
        ("", "standard input: this is not JSON: EOF while parsing a value at line 1 column 0"),
        ("{\"verb\": \"rescale\", \"models\": [", "at line 1 column 31"),
        ("[1]", "expected a JSON object"),
        (r#"{"models": ["human.osim"]}"#, "`verb` is missing"),
        (r#"{"verb": "grow"}"#, "expected one of rescale, transfer"),
        (r#"{"verb": "rescale", "target_mass": 5}"#, "`models` is missing"),
        (r#"{"verb": "rescale", "models": ["human.osim"], "target_mas": 5}"#, "did you mean `target_mass`?"),
        (r#"{"verb": "rescale", "models": ["human.osim"], "target_mass": "5,5"}"#, "`target_mass`"),
        (r#"{"verb": "rescale", "models": ["-"], "target_mass": 5}"#, "put the request into a file"),
        (
            r#"{"verb": "plot", "kind": "force", "models": ["human.osim"], "output": "a.jpg"}"#,
            "`output` 'a.jpg': expected",
        ),
        (r#"{"verb": "set", "models": ["human.osim"], "set": {}}"#, "`set` is missing"),
        (r#"{"verb": "inspect", "models": [""]}"#, "expected the name of a file"),
        (r#"{"verb": "transfer", "models": ["human.osim"], "from": "-"}"#, "`from` is standard input"),
        (
            r#"{"verb": "check", "models": ["human.osim"], "motion": "-", "plates": "grf.mot"}"#,
            "`motion` is standard input, where the request itself was: put the request into a file",
        ),
        (
            r#"{"verb": "fit", "file": "human.osim", "motion": "a.mot", "plates": ["grf.mot", "-"]}"#,
            "`plates` is standard input",
        ),
    ] {
        dir.run_with_stdin("request -", text.as_bytes()).usage_error().wrote_nothing().says(&[expected]);
    }
    let typed = dir.run_words(&["request", r#"{"verb":"check","models":["human.osim"]}"#]);
    assert!(String::from_utf8(typed.stderr).unwrap().contains("give it on standard input (-)"));
    dir.run("request absent.json").usage_error().says(&["absent.json: there is no such file"]);
    dir.write("wrong.json", "{");
    dir.run("request wrong.json").usage_error().says(&["wrong.json: this is not JSON"]);
}

#[test]
fn a_request_continues_after_a_failed_model() {
    let dir = TestDir::with_human();
    dir.write("broken.osim", "<OpenSimDocument Version=\"40000\">");
    let failed = run_request(
        &dir,
        &json!({
            "verb": "rescale",
            "models": ["broken.osim", "human.osim"],
            "target_mass": 5,
            "format": "json",
        }),
    )
    .failed()
    .wrote(&["human.scaled.osim"]);
    let lines: Vec<Value> = failed.out().lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(lines[0]["error"]["code"], "malformed-xml");
    assert_eq!(lines[1]["output"], "human.scaled.osim");
}

#[test]
fn a_field_requires_the_same_other_fields_as_its_option_does() {
    let dir = TestDir::with_human();
    for (words, fields) in [
        (
            "human.osim --target-mass 5 -o x.osim --no-backup",
            json!({"verb": "rescale", "models": "human.osim", "target_mass": 5, "output": "x.osim", "no_backup": true}),
        ),
        (
            "design --mass 60 --spheres 2 --stiffness 1e6 --poisson 0.3",
            json!({"verb": "design", "mass": 60, "spheres": 2, "stiffness": 1e6, "poisson": 0.3}),
        ),
        (
            "transfer human.osim --from falisse2022 --strict",
            json!({"verb": "transfer", "models": "human.osim", "from": "falisse2022", "strict": true}),
        ),
        (
            "drop-test human.osim --compare-spheres 2",
            json!({"verb": "drop-test", "subject": "human.osim", "compare_spheres": 2}),
        ),
    ] {
        let error_of_call = dir.run(words).usage_error().wrote_nothing().err();
        let error_of_request = run_request(&dir, &fields).usage_error().wrote_nothing().err();
        // The sentence of the call, with each option as a field.
        let sentence = error_of_call.trim_start_matches("error: ").trim_end();
        let spelled: Vec<String> = sentence
            .split(' ')
            .map(|word| match word.strip_prefix("--") {
                Some(name) => format!("`{}`", name.replace('-', "_")),
                None => word.to_owned(),
            })
            .collect();
        let error_of_request = error_of_request.replace(": true", "").replace('"', "`");
        assert!(sentence.contains(" needs --"), "{words}: {error_of_call}");
        assert!(error_of_request.trim_end().ends_with(&spelled.join(" ")), "{words}: {error_of_request}");
    }
}

#[test]
fn advice_is_spelled_as_a_request() {
    let dir = TestDir::with_human();
    let given_stiffness = json!({"verb": "design", "models": ["human.osim"], "stiffness": 1e6});
    run_request(&dir, &given_stiffness)
        .usage_error()
        .says(&[r#"write it with {"verb": "set", "models": ["model.osim"], "set": {"stiffness": VALUE}}"#]);
    dir.run("design human.osim --stiffness 1e6")
        .usage_error()
        .says(&["write it with set MODEL stiffness=VALUE"]);
    run_request(&dir, &json!({"verb": "design", "mass": 60}))
        .usage_error()
        .says(&[r#"(or "young": E with "poisson": NU)"#]);
}

#[test]
fn the_message_names_only_the_wrong_item_of_a_list() {
    let dir = TestDir::with_human();
    let request_with = |select: &str| {
        format!(r#"{{"verb": "rescale", "models": ["human.osim"], "target_mass": 100, "select": {select}}}"#)
    };
    dir.write("request.json", request_with(r#"["*_r", "["]"#));
    dir.run("request request.json")
        .usage_error()
        .wrote_nothing()
        .says(&["`select` '[': unclosed character class"]);
    dir.write("rows.csv", "model,target-mass,select\nhuman.osim,100,*_r;[\n");
    dir.run("batch rows.csv")
        .usage_error()
        .wrote_nothing()
        .says(&["column 'select': '[': unclosed character class"]);
}
