//! The verb `request`: the same as a call, from a JSON object.

use serde_json::{Value, json};

use crate::support::{Bench, HUMAN};

fn request(bench: &Bench, request: &Value) -> crate::support::Ran {
    bench.run_with("request -", request.to_string().as_bytes())
}

#[test]
fn a_request_does_what_the_options_do() {
    let bench = Bench::human();
    bench.run("human.osim --target-mass 5 --only stiffness,radius -o called.osim").done();
    bench.write(
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
    bench.run("request request.json").done().wrote(&["requested.osim"]);
    assert_eq!(bench.read("requested.osim"), bench.read("called.osim"));
}

#[test]
fn results_are_those_of_the_call() {
    let bench = Bench::human();
    for (call, asked) in [
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
        let (called, requested) = (bench.run(call), request(&bench, &asked));
        assert_eq!((called.status, called.out()), (requested.status, requested.out()), "{call}");
    }
}

#[test]
fn what_it_says_is_in_the_words_of_requests() {
    let bench = Bench::with(&[HUMAN, ("check/wide_transition.osim", "model.osim")]);
    let checked = request(&bench, &json!({"verb": "check", "models": ["model.osim"], "format": "json"}));
    let checked: Value = serde_json::from_str(&checked.done().out()).unwrap();
    let remedy = checked["findings"][0]["command"].as_str().unwrap();
    // The remedy is a request itself, and is one that runs.
    let asked: Value = serde_json::from_str(remedy).unwrap();
    assert_eq!(asked["verb"], "design");
    bench.run_with("request -", remedy.as_bytes()).done().wrote(&["model.scaled.osim"]);

    request(&bench, &json!({"verb": "design", "models": ["human.osim"]}))
        .usage()
        .says(&["\"indentation\""])
        .wrote_nothing();
}

#[test]
fn whoever_has_it_made_by_matlab_reads_the_words_of_matlab() {
    let bench = Bench::with(&[HUMAN, ("check/wide_transition.osim", "model.osim")]);
    let of_matlab =
        |request: &Value| bench.run_with("request --words matlab -", request.to_string().as_bytes());
    let checked = of_matlab(&json!({"verb": "check", "models": ["model.osim"], "format": "json"}));
    let checked: Value = serde_json::from_str(&checked.done().out()).unwrap();
    let remedy = checked["findings"][0]["command"].as_str().unwrap();
    assert!(remedy.starts_with("osimcontact.design('model.osim', "), "{remedy}");

    of_matlab(&json!({"verb": "design", "models": ["human.osim"]}))
        .usage()
        .says(&["say for example 'Indentation', X"]);
    let unknown = json!({"verb": "set", "models": ["human.osim"], "set": {"stifness": 2, "radius": "x2"}});
    of_matlab(&unknown).usage().says(&["'stifness=2 radius=x2': there is no property 'stifness'"]);
}

#[test]
fn a_wrong_request_is_refused_with_a_way_out() {
    let bench = Bench::human();
    for (text, said) in [
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
        bench.run_with("request -", text.as_bytes()).usage().wrote_nothing().says(&[said]);
    }
    bench.run("request absent.json").usage().says(&["absent.json: there is no such file"]);
    bench.write("wrong.json", "{");
    bench.run("request wrong.json").usage().says(&["wrong.json: this is not JSON"]);
}

#[test]
fn a_batch_goes_on_past_a_model_that_fails() {
    let bench = Bench::human();
    bench.write("broken.osim", "<OpenSimDocument Version=\"40000\">");
    let failed = request(
        &bench,
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
fn what_an_option_needs_a_field_needs() {
    let bench = Bench::human();
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
        let typed = bench.run(words).usage().wrote_nothing().err();
        let asked = request(&bench, &fields).usage().wrote_nothing().err();
        // The same sentence, with each option as a field.
        let sentence = typed.trim_start_matches("error: ").trim_end();
        let spelled: Vec<String> = sentence
            .split(' ')
            .map(|word| match word.strip_prefix("--") {
                Some(name) => format!("`{}`", name.replace('-', "_")),
                None => word.to_owned(),
            })
            .collect();
        let asked = asked.replace(": true", "").replace('"', "`");
        assert!(sentence.contains(" says nothing without --"), "{words}: {typed}");
        assert!(asked.trim_end().ends_with(&spelled.join(" ")), "{words}: {asked}");
    }
}

#[test]
fn ways_out_are_spelled_as_requests() {
    let bench = Bench::human();
    let known = json!({"verb": "design", "models": ["human.osim"], "stiffness": 1e6});
    request(&bench, &known)
        .usage()
        .says(&[r#"write it with {"verb": "set", "models": ["model.osim"], "set": {"stiffness": VALUE}}"#]);
    bench.run("design human.osim --stiffness 1e6").usage().says(&["write it with set MODEL stiffness=VALUE"]);
    request(&bench, &json!({"verb": "design", "mass": 60}))
        .usage()
        .says(&[r#"(or "young": E with "poisson": NU)"#]);
}

#[test]
fn one_wrong_item_of_a_list_is_named_alone() {
    let bench = Bench::human();
    let request = |select: &str| {
        format!(r#"{{"verb": "rescale", "models": ["human.osim"], "target_mass": 100, "select": {select}}}"#)
    };
    bench.write("request.json", request(r#"["*_r", "["]"#));
    bench
        .run("request request.json")
        .usage()
        .wrote_nothing()
        .says(&["`select` '[': unclosed character class"]);
    bench.write("rows.csv", "model,target-mass,select\nhuman.osim,100,*_r;[\n");
    bench
        .run("batch rows.csv")
        .usage()
        .wrote_nothing()
        .says(&["column 'select': '[': unclosed character class"]);
}
