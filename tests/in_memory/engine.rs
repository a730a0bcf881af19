//! The engine of the page: what it answers is what the command prints and writes for the same files.

use osim_web::Engine;
use serde_json::{Value, json};

use crate::front_end::TODAY;
use crate::support::{Bench, HUMAN};

/// An engine that has the files of a folder.
fn engine_of(bench: &Bench) -> Engine {
    let mut engine = Engine::new();
    engine.set_today(TODAY);
    for (name, bytes) in bench.files() {
        engine.put(&name, bytes);
    }
    engine
}

#[track_caller]
fn ask(engine: &mut Engine, question: &Value) -> Value {
    let answer: Value = serde_json::from_str(&engine.call(&question.to_string())).unwrap();
    assert!(answer.get("ok").is_some(), "{question}: {answer}");
    answer["ok"].clone()
}

#[track_caller]
fn refused(engine: &mut Engine, question: &Value) -> Value {
    let answer: Value = serde_json::from_str(&engine.call(&question.to_string())).unwrap();
    assert!(answer.get("error").is_some(), "{question}: {answer}");
    answer["error"].clone()
}

/// Both are the same text; else the first lines that differ.
#[track_caller]
fn same_text(made: &Value, expected: &str, what: &str) {
    let made = made.as_str().unwrap();
    let different = made.lines().zip(expected.lines()).find(|(made, expected)| made != expected);
    assert!(made == expected, "{what}: {different:.2000?}");
}

/// Does the change in the engine, and by the command that the engine spells: files, lines and report are the same.
#[track_caller]
fn same(bench: &Bench, request: &Value) {
    let mut engine = engine_of(bench);
    let answer = ask(&mut engine, &json!({ "do": "change", "request": request }));
    let diff = ask(&mut engine, &json!({ "do": "diff" }));
    let made: Vec<(String, Vec<u8>)> = answer["results"]
        .as_array()
        .unwrap()
        .iter()
        .enumerate()
        .map(|(index, made)| (made["name"].as_str().unwrap().to_owned(), engine.result(index).unwrap()))
        .collect();
    let report = ask(&mut engine, &json!({ "do": "report", "request": request }));

    let spelled = ask(&mut engine, &json!({ "do": "spell", "request": request }));
    let command =
        spelled["command"].as_str().unwrap().strip_prefix("osim-contact-scale ").unwrap().to_owned();
    let shown = bench.run(&format!("{command} --dry-run --quiet --diff")).done();
    same_text(&diff["text"], &shown.out(), &command);
    let page = report["name"].as_str().unwrap();
    let mut with_report = request.clone();
    with_report["report"] = page.into();
    let spelled = ask(&mut engine, &json!({ "do": "spell", "request": with_report }));
    bench.run(spelled["command"].as_str().unwrap().strip_prefix("osim-contact-scale ").unwrap()).done();
    same_text(&report["html"], &bench.text(page), &command);
    for (name, bytes) in &made {
        assert!(bench.read(name) == *bytes, "{command}: {name}");
    }
    // What is kept is a file of its own.
    ask(&mut engine, &json!({ "do": "change", "request": request, "parts": ["changes"] }));
    let kept = ask(&mut engine, &json!({ "do": "keep" }));
    assert_eq!(kept["names"].as_array().unwrap().len(), made.len(), "{command}");
    assert_eq!(engine.bytes(kept["model"].as_str().unwrap()).unwrap(), made[0].1, "{command}");
}

#[test]
fn every_change_is_the_command_s() {
    same(&Bench::human(), &json!({"verb": "rescale", "models": "human.osim", "target_mass": 500}));
    same(
        &Bench::human(),
        &json!({"verb": "design", "models": "human.osim", "indentation": 0.2, "restitution": 0.8, "impact_speed": 0.4}),
    );
    same(
        &Bench::human(),
        &json!({"verb": "set", "models": "human.osim", "set": {"stiffness": "x2", "dissipation": 1}}),
    );
    same(&Bench::human(), &json!({"verb": "convert", "models": "human.osim", "to": "hunt-crossley"}));
    same(&Bench::human(), &json!({"verb": "remove", "models": "human.osim"}));
    same(&Bench::human(), &json!({"verb": "note", "models": "human.osim", "contacts_mass": 62}));
    same(
        &Bench::with(&[HUMAN, ("table1/mouse_smooth_sphere.osim", "mouse.osim")]),
        &json!({"verb": "transfer", "models": "mouse.osim", "from": "human.osim"}),
    );
    same(
        &Bench::with(&[
            ("feet/human_40000.osim", "feet.osim"),
            ("feet/Geometry/r_human_foot.vtp", "Geometry/r_human_foot.vtp"),
        ]),
        &json!({"verb": "add", "models": "feet.osim", "from": "falisse2022", "feet": ["calcn_r", "calcn_l"], "count": 3, "pad": 0.01}),
    );
    same(
        &Bench::with(&[
            ("format/standalone_ForceSet.xml", "forces.xml"),
            ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
        ]),
        &json!({"verb": "rescale", "models": "forces.xml", "geometry": "geometry.xml", "mass": 61.5, "target_mass": 80}),
    );
}

#[test]
fn a_report_about_nothing_that_changes_is_the_command_s() {
    let bench = Bench::with(&[("table1/human_62kg_smooth_sphere.osim", "models/human.osim")]);
    let request = json!({"verb": "set", "models": "models/human.osim", "set": {"stiffness": "x1"}});
    let mut engine = engine_of(&bench);
    let answer = ask(&mut engine, &json!({ "do": "change", "request": request }));
    assert_eq!(answer["unchanged"], true);
    let report = ask(&mut engine, &json!({ "do": "report", "request": request }));
    bench.run("set models/human.osim stiffness=x1 --report models/human.report.html").done();
    same_text(&report["html"], &bench.text("models/human.report.html"), "set stiffness=x1");
    // No file is made of it.
    ask(&mut engine, &json!({ "do": "change", "request": request }));
    assert_eq!(
        ask(&mut engine, &json!({ "do": "keep" })),
        json!({"model": "models/human.osim", "names": []})
    );
    assert!(engine.bytes("models/human.scaled.osim").is_none());
}

#[test]
fn a_look_is_what_inspect_and_check_say() {
    let bench = Bench::human();
    let look = ask(&mut engine_of(&bench), &json!({"do": "look", "model": "human.osim"}));
    let inspected: Value =
        serde_json::from_str(&bench.run("inspect human.osim --format json").done().out()).unwrap();
    assert_eq!(look["inspection"]["forces"], inspected["forces"]);
    assert_eq!(look["inspection"]["figures"], inspected["figures"]);
    let found: Value = serde_json::from_str(&bench.run("check human.osim --format json").out()).unwrap();
    let codes = |findings: &Value| -> Vec<String> {
        findings.as_array().unwrap().iter().map(|finding| finding["code"].to_string()).collect()
    };
    assert_eq!(codes(&look["findings"]), codes(&found["findings"]));
    let ids: Vec<&str> =
        look["sections"].as_array().unwrap().iter().map(|one| one["id"].as_str().unwrap()).collect();
    assert_eq!(ids, ["findings", "feet", "plots", "figures", "contacts", "model"]);
    // Every link leads to something that is explained.
    let explained = look["explained"].to_string();
    for section in look["sections"].as_array().unwrap() {
        for link in section["html"].as_str().unwrap().split("href=\"#").skip(1) {
            let anchor = link.split('"').next().unwrap();
            assert!(explained.contains(&format!("\"{anchor}\"")), "{anchor}");
        }
    }
}

#[test]
fn what_follows_a_slider_is_what_all_of_it_shows() {
    let mut engine = engine_of(&Bench::human());
    let request = json!({"verb": "rescale", "models": "human.osim", "target_mass": 500});
    let mut sections = |parts: &Value| {
        ask(&mut engine, &json!({"do": "change", "request": request, "parts": parts}))["sections"].clone()
    };
    let quick = sections(&json!(["changes", "plots", "state"]));
    let all = sections(&json!(["changes", "plots", "state", "figures"]));
    let ids: Vec<&str> = quick.as_array().unwrap().iter().map(|one| one["id"].as_str().unwrap()).collect();
    assert_eq!(ids, ["changes", "plots", "state"]);
    assert_eq!(quick.as_array().unwrap()[..], all.as_array().unwrap()[..3]);
    assert_eq!(sections(&json!(["changes"])), json!([quick[0]]));
    // A report does without what nobody names.
    let whole = ask(&mut engine, &json!({"do": "change", "request": request}));
    assert!(whole["sections"].as_array().unwrap().iter().all(|one| one["id"] != "state"));
}

#[test]
fn a_scaled_model_is_compared_with_the_one_that_was_scaled() {
    let bench = Bench::with(&[
        ("scale_tool/generic_smooth.osim", "generic.osim"),
        ("scale_tool/scaled_smooth.osim", "scaled.osim"),
    ]);
    let mut engine = engine_of(&bench);
    let look = json!({"do": "look", "model": "scaled.osim", "fields": {"from": "generic.osim"}, "parts": ["findings"]});
    let found = ask(&mut engine, &look);
    let told: Value =
        serde_json::from_str(&bench.run("check scaled.osim --from generic.osim --format json").out())
            .unwrap();
    let both = |findings: &Value, field: &str| -> Vec<String> {
        findings.as_array().unwrap().iter().map(|finding| finding[field].to_string()).collect()
    };
    assert_eq!(both(&found["findings"], "code"), both(&told["findings"], "code"));
    let remedy = &found["findings"][0]["remedy"]["request"];
    assert_eq!((&remedy["verb"], &remedy["follow_bodies"]), (&json!("transfer"), &json!(true)), "{remedy}");
    ask(&mut engine, &json!({"do": "change", "request": remedy, "parts": ["changes"]}));
}

#[test]
fn a_report_about_a_model_is_the_command_s() {
    let bench = Bench::human();
    let report = ask(
        &mut engine_of(&bench),
        &json!({"do": "report", "request": {"verb": "inspect", "models": "human.osim"}}),
    );
    let page = report["name"].as_str().unwrap();
    bench.run(&format!("inspect human.osim --report {page}")).done();
    assert_eq!(report["html"], bench.text(page));
}

#[test]
fn a_remedy_can_be_asked_for_and_its_finding_is_gone() {
    let bench = Bench::with(&[("check/floats.osim", "floats.osim")]);
    let mut engine = engine_of(&bench);
    let look = ask(&mut engine, &json!({"do": "look", "model": "floats.osim"}));
    let finding = look["findings"]
        .as_array()
        .unwrap()
        .iter()
        .find(|finding| !finding["remedy"].is_null())
        .unwrap()
        .clone();
    ask(&mut engine, &json!({"do": "change", "request": finding["remedy"]["request"], "parts": ["changes"]}));
    let kept = ask(&mut engine, &json!({"do": "keep"}));
    let after = ask(&mut engine, &json!({"do": "look", "model": kept["model"]}));
    let left = after["findings"].as_array().unwrap();
    assert!(left.iter().all(|one| one["code"] != finding["code"]), "{left:?}");
}

#[test]
fn what_is_missing_is_a_field() {
    let bench = Bench::with(&[HUMAN, ("format/standalone_ForceSet.xml", "forces.xml")]);
    let mut engine = engine_of(&bench);
    let request = json!({"verb": "rescale", "models": "human.osim"});
    let error = refused(&mut engine, &json!({"do": "change", "request": request}));
    assert_eq!(error["fields"][0], "target_mass", "{error}");
    let request = json!({"verb": "rescale", "models": "forces.xml", "target_mass": 5});
    let error = refused(&mut engine, &json!({"do": "change", "request": request}));
    assert!(error["fields"].as_array().unwrap().contains(&json!("geometry")), "{error}");
    assert!(!error["message"].as_str().unwrap().contains("--"), "{error}");
}

#[test]
fn a_broken_file_says_where_and_loses_nothing() {
    let bench = Bench::human();
    let mut engine = engine_of(&bench);
    engine.put("broken.osim", b"<OpenSimDocument Version=\"40000\">\n  <Model>\n</OpenSimDocument>".to_vec());
    let error = refused(&mut engine, &json!({"do": "look", "model": "broken.osim"}));
    bench.write("broken.osim", engine.bytes("broken.osim").unwrap());
    let told: Value =
        serde_json::from_str(&bench.run("inspect broken.osim --format json").failed().out()).unwrap();
    assert_eq!(
        (&error["line"], &error["column"], &error["code"]),
        (&told["error"]["line"], &told["error"]["column"], &told["error"]["code"])
    );
    assert!(error["excerpt"]["marked"].as_str().is_some_and(|marked| !marked.is_empty()), "{error}");
    ask(&mut engine, &json!({"do": "look", "model": "human.osim"}));
}

#[test]
fn design_calculates_without_a_model() {
    let request = json!({"verb": "design", "mass": 62, "spheres": 6, "radius": 0.032, "indentation": 0.2});
    let answer = ask(&mut Engine::new(), &json!({"do": "calculate", "request": request}));
    let bench = Bench::new();
    let words = "design --mass 62 --spheres 6 --radius 0.032 --indentation 0.2";
    assert_eq!(answer["text"], bench.run(words).done().out());
    let sheet: Value =
        serde_json::from_str(&bench.run(&format!("{words} --format json")).done().out()).unwrap();
    assert_eq!(answer["sheet"], sheet);
}

#[test]
fn presets_and_explanations() {
    let mut engine = Engine::new();
    engine.set_today(TODAY);
    let presets = ask(&mut engine, &json!({"do": "presets"}));
    assert!(presets.as_array().unwrap().iter().any(|preset| preset["name"] == "falisse2022"), "{presets}");
    let said = ask(&mut engine, &json!({"do": "explain", "topic": "C.5"}));
    assert!(said["text"].as_str().unwrap().contains("C.5"), "{said}");
    refused(&mut engine, &json!({"do": "explain", "topic": "nothing of this name"}));
}

#[test]
fn a_question_that_is_none_is_refused() {
    let mut engine = Engine::new();
    engine.set_today(TODAY);
    for question in [
        json!(1),
        json!({"do": "sing"}),
        json!({"do": "diff"}),
        json!({"do": "keep"}),
        json!({"do": "look", "model": "absent.osim"}),
    ] {
        refused(&mut engine, &question);
    }
    assert!(engine.call("{").contains("error"));
    assert!(engine.result(0).is_none() && engine.bytes("absent.osim").is_none());
}
