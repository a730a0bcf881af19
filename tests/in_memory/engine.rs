//! The engine of the web page gives the same answers and files as the command for the same models.

use osim_web::Engine;
use serde_json::{Value, json};

use crate::front_end::TODAY;
use crate::support::{HUMAN, TestDir};

/// An engine with the files of the folder `dir`.
fn engine_with_files(dir: &TestDir) -> Engine {
    let mut engine = Engine::new();
    engine.set_today(TODAY);
    for (name, bytes) in dir.files() {
        engine.put(&name, bytes);
    }
    engine
}

#[track_caller]
fn ask_engine(engine: &mut Engine, question: &Value) -> Value {
    let answer: Value = serde_json::from_str(&engine.call(&question.to_string())).unwrap();
    assert!(answer.get("ok").is_some(), "{question}: {answer}");
    answer["ok"].clone()
}

#[track_caller]
fn ask_for_error(engine: &mut Engine, question: &Value) -> Value {
    let answer: Value = serde_json::from_str(&engine.call(&question.to_string())).unwrap();
    assert!(answer.get("error").is_some(), "{question}: {answer}");
    answer["error"].clone()
}

/// Asserts that both texts are equal; the message has the first lines that differ.
#[track_caller]
fn assert_same_text(written: &Value, expected: &str, what: &str) {
    let written = written.as_str().unwrap();
    let different = written.lines().zip(expected.lines()).find(|(written, expected)| written != expected);
    assert!(written == expected, "{what}: {different:.2000?}");
}

/// Makes the change in the engine, and with the command line that the engine proposes. Files, diff and report must be equal.
#[track_caller]
fn assert_same_change(dir: &TestDir, request: &Value) {
    let mut engine = engine_with_files(dir);
    let answer = ask_engine(&mut engine, &json!({ "do": "change", "request": request }));
    let diff = ask_engine(&mut engine, &json!({ "do": "diff" }));
    let written: Vec<(String, Vec<u8>)> = answer["results"]
        .as_array()
        .unwrap()
        .iter()
        .enumerate()
        .map(|(index, written)| (written["name"].as_str().unwrap().to_owned(), engine.result(index).unwrap()))
        .collect();
    let report = ask_engine(&mut engine, &json!({ "do": "report", "request": request }));

    let spelled = ask_engine(&mut engine, &json!({ "do": "spell", "request": request }));
    let command =
        spelled["command"].as_str().unwrap().strip_prefix("osim-contact-scale ").unwrap().to_owned();
    let run = dir.run(&format!("{command} --dry-run --quiet --diff")).succeeded();
    assert_same_text(&diff["text"], &run.out(), &command);
    let page = report["name"].as_str().unwrap();
    let mut with_report = request.clone();
    with_report["report"] = page.into();
    let spelled = ask_engine(&mut engine, &json!({ "do": "spell", "request": with_report }));
    dir.run(spelled["command"].as_str().unwrap().strip_prefix("osim-contact-scale ").unwrap()).succeeded();
    assert_same_text(&report["html"], &dir.text(page), &command);
    for (name, bytes) in &written {
        assert!(dir.read(name) == *bytes, "{command}: {name}");
    }
    // A kept result is a new file.
    ask_engine(&mut engine, &json!({ "do": "change", "request": request, "parts": ["changes"] }));
    let kept = ask_engine(&mut engine, &json!({ "do": "keep" }));
    assert_eq!(kept["names"].as_array().unwrap().len(), written.len(), "{command}");
    assert_eq!(engine.bytes(kept["model"].as_str().unwrap()).unwrap(), written[0].1, "{command}");
}

#[test]
fn every_change_equals_the_command() {
    assert_same_change(
        &TestDir::with_human(),
        &json!({"verb": "rescale", "models": "human.osim", "target_mass": 500}),
    );
    assert_same_change(
        &TestDir::with_human(),
        &json!({"verb": "design", "models": "human.osim", "indentation": 0.2, "restitution": 0.8, "impact_speed": 0.4}),
    );
    assert_same_change(
        &TestDir::with_human(),
        &json!({"verb": "set", "models": "human.osim", "set": {"stiffness": "x2", "dissipation": 1}}),
    );
    assert_same_change(
        &TestDir::with_human(),
        &json!({"verb": "convert", "models": "human.osim", "to": "hunt-crossley"}),
    );
    assert_same_change(&TestDir::with_human(), &json!({"verb": "remove", "models": "human.osim"}));
    assert_same_change(
        &TestDir::with_human(),
        &json!({"verb": "note", "models": "human.osim", "contacts_mass": 62}),
    );
    assert_same_change(
        &TestDir::with(&[HUMAN, ("table1/mouse_smooth_sphere.osim", "mouse.osim")]),
        &json!({"verb": "transfer", "models": "mouse.osim", "from": "human.osim"}),
    );
    assert_same_change(
        &TestDir::with(&[
            ("feet/human_40000.osim", "feet.osim"),
            ("feet/Geometry/r_human_foot.vtp", "Geometry/r_human_foot.vtp"),
        ]),
        &json!({"verb": "add", "models": "feet.osim", "from": "falisse2022", "feet": ["calcn_r", "calcn_l"], "count": 3, "pad": 0.01}),
    );
    assert_same_change(
        &TestDir::with(&[
            ("format/standalone_ForceSet.xml", "forces.xml"),
            ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
        ]),
        &json!({"verb": "rescale", "models": "forces.xml", "geometry": "geometry.xml", "mass": 61.5, "target_mass": 80}),
    );
    assert_same_change(
        &TestDir::with_human(),
        &json!({"verb": "rescale", "models": "human.osim", "target_mass": 500, "target_gravity": 1.62, "no_note": true}),
    );
    assert_same_change(
        &TestDir::with(&[
            ("format/standalone_ForceSet.xml", "forces.xml"),
            ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
        ]),
        &json!({
            "verb": "design", "models": "forces.xml", "geometry": "geometry.xml", "mass": 61.5, "spheres": 1,
            "gravity": 9.81, "indentation": 0.16, "radius": 0.04,
        }),
    );
}

#[test]
fn a_report_without_changes_equals_the_command() {
    let dir = TestDir::with(&[("table1/human_62kg_smooth_sphere.osim", "models/human.osim")]);
    let request = json!({"verb": "set", "models": "models/human.osim", "set": {"stiffness": "x1"}});
    let mut engine = engine_with_files(&dir);
    let answer = ask_engine(&mut engine, &json!({ "do": "change", "request": request }));
    assert_eq!(answer["unchanged"], true);
    let report = ask_engine(&mut engine, &json!({ "do": "report", "request": request }));
    dir.run("set models/human.osim stiffness=x1 --report models/human.report.html").succeeded();
    assert_same_text(&report["html"], &dir.text("models/human.report.html"), "set stiffness=x1");
    // It gives no new file.
    ask_engine(&mut engine, &json!({ "do": "change", "request": request }));
    assert_eq!(
        ask_engine(&mut engine, &json!({ "do": "keep" })),
        json!({"model": "models/human.osim", "names": []})
    );
    assert!(engine.bytes("models/human.scaled.osim").is_none());
}

#[test]
fn the_answer_to_look_equals_inspect_and_check() {
    let dir = TestDir::with_human();
    let inspection = ask_engine(&mut engine_with_files(&dir), &json!({"do": "look", "model": "human.osim"}));
    let inspected: Value =
        serde_json::from_str(&dir.run("inspect human.osim --format json").succeeded().out()).unwrap();
    assert_eq!(inspection["inspection"]["forces"], inspected["forces"]);
    assert_eq!(inspection["inspection"]["figures"], inspected["figures"]);
    let from_engine: Value = serde_json::from_str(&dir.run("check human.osim --format json").out()).unwrap();
    let codes = |findings: &Value| -> Vec<String> {
        findings.as_array().unwrap().iter().map(|finding| finding["code"].to_string()).collect()
    };
    assert_eq!(codes(&inspection["findings"]), codes(&from_engine["findings"]));
    let ids: Vec<&str> =
        inspection["sections"].as_array().unwrap().iter().map(|one| one["id"].as_str().unwrap()).collect();
    assert_eq!(ids, ["findings", "feet", "plots", "figures", "contacts", "model"]);
    // Every link leads to something that is explained.
    let explained = inspection["explained"].to_string();
    for section in inspection["sections"].as_array().unwrap() {
        for link in section["html"].as_str().unwrap().split("href=\"#").skip(1) {
            let anchor = link.split('"').next().unwrap();
            assert!(explained.contains(&format!("\"{anchor}\"")), "{anchor}");
        }
    }
}

#[test]
fn quick_sections_equal_those_of_the_whole_answer() {
    let mut engine = engine_with_files(&TestDir::with_human());
    let request = json!({"verb": "rescale", "models": "human.osim", "target_mass": 500});
    let mut sections = |parts: &Value| {
        ask_engine(&mut engine, &json!({"do": "change", "request": request, "parts": parts}))["sections"]
            .clone()
    };
    let quick = sections(&json!(["changes", "plots", "state"]));
    let all = sections(&json!(["changes", "plots", "state", "figures"]));
    let ids: Vec<&str> = quick.as_array().unwrap().iter().map(|one| one["id"].as_str().unwrap()).collect();
    assert_eq!(ids, ["changes", "plots", "state"]);
    assert_eq!(quick.as_array().unwrap()[..], all.as_array().unwrap()[..3]);
    assert_eq!(sections(&json!(["changes"])), json!([quick[0]]));
    // Without `parts` the answer has no section that only a slider needs.
    let whole = ask_engine(&mut engine, &json!({"do": "change", "request": request}));
    assert!(whole["sections"].as_array().unwrap().iter().all(|one| one["id"] != "state"));
}

#[test]
fn a_scaled_model_is_compared_with_its_original() {
    let dir = TestDir::with(&[
        ("scale_tool/generic_smooth.osim", "generic.osim"),
        ("scale_tool/scaled_smooth.osim", "scaled.osim"),
    ]);
    let mut engine = engine_with_files(&dir);
    let inspection = json!({"do": "look", "model": "scaled.osim", "fields": {"from": "generic.osim"}, "parts": ["findings"]});
    let from_engine = ask_engine(&mut engine, &inspection);
    let from_command: Value =
        serde_json::from_str(&dir.run("check scaled.osim --from generic.osim --format json").out()).unwrap();
    let field_of_findings = |findings: &Value, field: &str| -> Vec<String> {
        findings.as_array().unwrap().iter().map(|finding| finding[field].to_string()).collect()
    };
    assert_eq!(
        field_of_findings(&from_engine["findings"], "code"),
        field_of_findings(&from_command["findings"], "code")
    );
    let remedy = &from_engine["findings"][0]["remedy"]["request"];
    assert_eq!((&remedy["verb"], &remedy["follow_bodies"]), (&json!("transfer"), &json!(true)), "{remedy}");
    ask_engine(&mut engine, &json!({"do": "change", "request": remedy, "parts": ["changes"]}));
}

#[test]
fn a_report_of_a_model_equals_the_command() {
    let dir = TestDir::with_human();
    let report = ask_engine(
        &mut engine_with_files(&dir),
        &json!({"do": "report", "request": {"verb": "inspect", "models": "human.osim"}}),
    );
    let page = report["name"].as_str().unwrap();
    dir.run(&format!("inspect human.osim --report {page}")).succeeded();
    assert_eq!(report["html"], dir.text(page));
}

#[test]
fn a_remedy_removes_its_finding() {
    let dir = TestDir::with(&[("check/floats.osim", "floats.osim")]);
    let mut engine = engine_with_files(&dir);
    let inspection = ask_engine(&mut engine, &json!({"do": "look", "model": "floats.osim"}));
    let finding = inspection["findings"]
        .as_array()
        .unwrap()
        .iter()
        .find(|finding| !finding["remedy"].is_null())
        .unwrap()
        .clone();
    ask_engine(
        &mut engine,
        &json!({"do": "change", "request": finding["remedy"]["request"], "parts": ["changes"]}),
    );
    let kept = ask_engine(&mut engine, &json!({"do": "keep"}));
    let after = ask_engine(&mut engine, &json!({"do": "look", "model": kept["model"]}));
    let remaining = after["findings"].as_array().unwrap();
    assert!(remaining.iter().all(|one| one["code"] != finding["code"]), "{remaining:?}");
}

#[test]
fn a_missing_option_is_named_as_a_field() {
    let dir = TestDir::with(&[HUMAN, ("format/standalone_ForceSet.xml", "forces.xml")]);
    let mut engine = engine_with_files(&dir);
    let request = json!({"verb": "rescale", "models": "human.osim"});
    let error = ask_for_error(&mut engine, &json!({"do": "change", "request": request}));
    assert_eq!(error["fields"][0], "target_mass", "{error}");
    let request = json!({"verb": "rescale", "models": "forces.xml", "target_mass": 5});
    let error = ask_for_error(&mut engine, &json!({"do": "change", "request": request}));
    assert!(error["fields"].as_array().unwrap().contains(&json!("geometry")), "{error}");
    assert!(!error["message"].as_str().unwrap().contains("--"), "{error}");
}

#[test]
fn a_broken_file_is_located_and_stays_available() {
    let dir = TestDir::with_human();
    let mut engine = engine_with_files(&dir);
    engine.put("broken.osim", b"<OpenSimDocument Version=\"40000\">\n  <Model>\n</OpenSimDocument>".to_vec());
    let error = ask_for_error(&mut engine, &json!({"do": "look", "model": "broken.osim"}));
    dir.write("broken.osim", engine.bytes("broken.osim").unwrap());
    let from_command: Value =
        serde_json::from_str(&dir.run("inspect broken.osim --format json").failed().out()).unwrap();
    assert_eq!(
        (&error["line"], &error["column"], &error["code"]),
        (&from_command["error"]["line"], &from_command["error"]["column"], &from_command["error"]["code"])
    );
    assert!(error["excerpt"]["marked"].as_str().is_some_and(|marked| !marked.is_empty()), "{error}");
    ask_engine(&mut engine, &json!({"do": "look", "model": "human.osim"}));
}

#[test]
fn design_calculates_without_a_model() {
    let request = json!({"verb": "design", "mass": 62, "spheres": 6, "radius": 0.032, "indentation": 0.2});
    let answer = ask_engine(&mut Engine::new(), &json!({"do": "calculate", "request": request}));
    let dir = TestDir::new();
    let words = "design --mass 62 --spheres 6 --radius 0.032 --indentation 0.2";
    assert_eq!(answer["text"], dir.run(words).succeeded().out());
    let sheet: Value =
        serde_json::from_str(&dir.run(&format!("{words} --format json")).succeeded().out()).unwrap();
    assert_eq!(answer["sheet"], sheet);
}

#[test]
fn the_engine_answers_about_presets_and_topics() {
    let mut engine = Engine::new();
    engine.set_today(TODAY);
    let presets = ask_engine(&mut engine, &json!({"do": "presets"}));
    assert!(presets.as_array().unwrap().iter().any(|preset| preset["name"] == "falisse2022"), "{presets}");
    let explanation = ask_engine(&mut engine, &json!({"do": "explain", "topic": "C.5"}));
    assert!(explanation["text"].as_str().unwrap().contains("C.5"), "{explanation}");
    ask_for_error(&mut engine, &json!({"do": "explain", "topic": "nothing of this name"}));
}

#[test]
fn a_corrected_motion_equals_the_command() {
    let dir = TestDir::with(&[
        ("motion/walker.osim", "walker.osim"),
        ("motion/walk.mot", "walk.mot"),
        ("motion/plates.sto", "plates.sto"),
        ("motion/plates.xml", "plates.xml"),
    ]);
    let mut engine = engine_with_files(&dir);
    let request = json!({
        "verb": "motion", "subject": "walker.osim", "motion": "walk.mot", "plates": "plates.sto", "loads": "plates.xml",
        "correct": "walk.corrected.sto",
    });
    let question = json!({ "do": "correct", "request": request });
    let answer = ask_engine(&mut engine, &question);
    assert_eq!(answer["verdict"], "agree");
    let spelled = ask_engine(&mut engine, &json!({ "do": "spell", "request": request }));
    dir.run(spelled["command"].as_str().unwrap().strip_prefix("osim-contact-scale ").unwrap()).succeeded();
    let [file] = answer["files"].as_array().unwrap().as_slice() else { panic!("{}", answer["files"]) };
    assert_same_text(&file[1], &dir.text(file[0].as_str().unwrap()), "the corrected motion");
    let peak = |motion: &Value| {
        let forces = motion["feet"][0]["model"]["forces_bw"].as_array().unwrap();
        forces.iter().filter_map(|force| force[1].as_f64()).fold(0.0, f64::max)
    };
    assert!(peak(&answer["played"]) < 2.0, "{}", peak(&answer["played"]));
    assert!(engine.bytes("walk.corrected.sto").is_none());
    engine.put("walk.corrected.sto", Vec::new());
    assert!(ask_for_error(&mut engine, &question)["message"].as_str().unwrap().contains("exists already"));
}

#[test]
fn unknown_questions_to_the_engine_are_refused() {
    let mut engine = Engine::new();
    engine.set_today(TODAY);
    for question in [
        json!(1),
        json!({"do": "sing"}),
        json!({"do": "diff"}),
        json!({"do": "keep"}),
        json!({"do": "look", "model": "absent.osim"}),
    ] {
        ask_for_error(&mut engine, &question);
    }
    assert!(engine.call("{").contains("error"));
    assert!(engine.result(0).is_none() && engine.bytes("absent.osim").is_none());
}
