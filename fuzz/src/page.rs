//! What the page can be asked about damaged files, in memory as the page does it; and variants, which the page does not make.

use std::path::Path;

use osim_library::workbook_as_csv;
use osim_model::files::{CompanionPaths, InMemory, ModelFiles};
use osim_planning::SweepPlan;
use osim_requests::Request;
use osim_requests::spell::{CommandLine, FrontEnd, Matlab, Python};
use osim_web::Engine;

use crate::request::fnv;

const MODEL: &str = include_str!("../../fixtures/motion/walker.osim");
const MOTION: &str = include_str!("../../fixtures/motion/walk.mot");
const PLATES: &str = include_str!("../../fixtures/motion/plates.sto");
const LOADS: &str = include_str!("../../fixtures/motion/plates.xml");
const BARE: &str = include_str!("../../fixtures/feet/human_40000.osim");
/// Lines of the recordings that are used: enough for a spline, few enough for thousands of runs.
const MOTION_LINES: usize = 30;
const PLATE_LINES: usize = 100;

/// Questions about MODEL, one of each kind. OTHER is its reference or the model that it was scaled from.
const QUESTIONS: [&str; 19] = [
    r#"{"do": "look", "model": "MODEL"}"#,
    r#"{"do": "look", "model": "MODEL", "fields": {"from": "OTHER"}, "parts": []}"#,
    r#"{"do": "look", "model": "MODEL", "fields": {"target_mass": 80}, "parts": ["feet", "model"]}"#,
    r#"{"do": "bones", "model": "MODEL"}"#,
    r#"{"do": "report", "request": {"verb": "inspect", "models": "MODEL"}}"#,
    r#"{"do": "change", "parts": [], "request": {"verb": "rescale", "models": "MODEL", "target_mass": 80}}"#,
    r#"{"do": "change", "parts": [], "request": {"verb": "rescale", "models": "MODEL", "target_mass": 8, "contacts_mass": 62, "level": true}}"#,
    r#"{"do": "change", "parts": [], "request": {"verb": "set", "models": "MODEL", "set": {"stiffness": "x2", "radius": "x1.1"}, "level": true}}"#,
    r#"{"do": "change", "parts": [], "request": {"verb": "design", "models": "MODEL", "indentation": 0.1, "restitution": 0.8}}"#,
    r#"{"do": "change", "parts": [], "request": {"verb": "convert", "models": "MODEL", "to": "smooth"}}"#,
    r#"{"do": "change", "parts": [], "request": {"verb": "convert", "models": "MODEL", "to": "hunt-crossley"}}"#,
    r#"{"do": "change", "parts": [], "request": {"verb": "remove", "models": "MODEL"}}"#,
    r#"{"do": "change", "parts": [], "request": {"verb": "note", "models": "MODEL", "contacts_mass": 62}}"#,
    r#"{"do": "change", "parts": [], "request": {"verb": "add", "models": "MODEL", "from": "OTHER", "replace": true}}"#,
    r#"{"do": "change", "parts": [], "request": {"verb": "add", "models": "MODEL", "from": "falisse2022", "replace": true, "level": true}}"#,
    r#"{"do": "change", "parts": [], "request": {"verb": "transfer", "models": "MODEL", "from": "OTHER"}}"#,
    r#"{"do": "change", "parts": [], "request": {"verb": "transfer", "models": "MODEL", "from": "OTHER", "follow_bodies": true, "level": true}}"#,
    r#"{"do": "play", "request": {"verb": "motion", "subject": "MODEL", "motion": "walk.mot", "plates": "plates.sto"}}"#,
    r#"{"verb": "sweep", "model": "MODEL", "grid": {"stiffness": ["x0.5", "x2"]}}"#,
];

/// Each verb on a damaged model: as the model itself, as its reference and as its original. What was written is read back.
pub fn verbs(bytes: &[u8]) {
    let dice = fnv(bytes) as usize;
    let question = QUESTIONS[dice % QUESTIONS.len()];
    let is_other = question.contains("OTHER") && (dice / QUESTIONS.len()) % 2 == 1;
    let [model, other] = if is_other { ["sound.osim", "damaged.osim"] } else { ["damaged.osim", "sound.osim"] };
    let question = question.replace("MODEL", model).replace("OTHER", other);
    if question.contains("sweep") {
        return sweep(&question, bytes);
    }
    let mut engine = engine_with_files([("sound.osim", MODEL.as_bytes()), ("damaged.osim", bytes)]);
    accept_answer(&engine.call(&question));
    let Some(written) = engine.result(0) else { return };
    accept_answer(&engine.call(r#"{"do": "diff"}"#));
    engine.put("written.osim", written);
    let judged = engine.call(r#"{"do": "look", "model": "written.osim", "parts": []}"#);
    assert!(judged.starts_with(r#"{"ok""#), "{question}: what was written cannot be read: {judged}");
}

/// All variants of a damaged model are models.
fn sweep(request: &str, bytes: &[u8]) {
    let Ok(Request::Sweep(request)) = Request::from_json(request.as_bytes()) else { panic!("{request}") };
    let files = InMemory::default();
    let read = ModelFiles::read(Path::new("damaged.osim"), bytes.to_vec(), CompanionPaths::default(), &files);
    let Ok(model) = read else { return };
    let Ok(plan) = SweepPlan::new(&request, model) else { return };
    for index in 0..plan.count() {
        if let Ok(variant) = plan.make(index) {
            let written = variant.bytes;
            assert!(osim_model::Model::parse(written).is_ok(), "variant {index} cannot be read");
        }
    }
}

/// Motions, plates, loads, tables of contacts, workbooks and requests: what the bytes look like decides what they are given as.
pub fn files(bytes: &[u8]) {
    let named = |name: &str, bytes: &[u8]| engine_with_files([("sound.osim", MODEL.as_bytes()), (name, bytes)]);
    let played = r#"{"do": "play", "request": {"verb": "motion", "subject": "sound.osim", "motion": "walk.mot", "plates": "plates.sto", "loads": "plates.xml"}}"#;
    let fitted = r#"{"do": "change", "parts": [], "request": {"verb": "fit", "file": "sound.osim", "motion": "walk.mot", "plates": "plates.sto", "fit": ["height"]}}"#;
    match bytes.trim_ascii_start() {
        [b'P', b'K', ..] => {
            if let Ok(table) = workbook_as_csv(bytes.to_vec()) {
                add_contacts(&table);
            }
        }
        [b'{', ..] => request(bytes),
        [b'<', ..] => accept_answer(&named("plates.xml", bytes).call(played)),
        _ if bytes.windows(9).any(|word| word == b"endheader") => {
            let dice = fnv(bytes);
            let name = if dice % 2 == 0 { "walk.mot" } else { "plates.sto" };
            let question = if dice % 8 < 6 { played } else { fitted };
            accept_answer(&named(name, bytes).call(question));
        }
        _ => add_contacts(bytes),
    }
}

fn add_contacts(table: &[u8]) {
    let mut engine = engine_with_files([("bare.osim", BARE.as_bytes()), ("places.csv", table)]);
    let added = r#"{"do": "change", "parts": [], "request": {"verb": "add", "models": "bare.osim", "contacts": "places.csv", "from": "falisse2022"}}"#;
    accept_answer(&engine.call(added));
    let Some(written) = engine.result(0) else { return };
    assert!(osim_model::Model::parse(written).is_ok(), "the model with new contacts cannot be read");
}

/// A request is the same after it was written as JSON; it can be spelled and asked.
fn request(bytes: &[u8]) {
    let mut engine = engine_with_files([("sound.osim", MODEL.as_bytes()), ("bare.osim", BARE.as_bytes())]);
    if let Ok(text) = std::str::from_utf8(bytes) {
        accept_answer(&engine.call(text));
        accept_answer(&engine.call(&format!(r#"{{"do": "change", "request": {text}}}"#)));
    }
    let request = match Request::from_json(bytes) {
        Ok(request) => request,
        Err(fault) => return assert!(!fault.spelled(&CommandLine).is_empty()),
    };
    let again = Request::from_map(request.to_map()).expect("a request can be read again");
    assert_eq!(again.to_map(), request.to_map());
    for spelled in [CommandLine.request(&request), Python.script(&request), Matlab.script(&request)] {
        assert!(!spelled.is_empty());
    }
}

/// An engine with the recordings, cut short, and with `files`, which may replace them.
fn engine_with_files<const N: usize>(files: [(&str, &[u8]); N]) -> Engine {
    let cut = |text: &str, lines: usize| text.lines().take(lines).map(|line| format!("{line}\n")).collect::<String>();
    let mut engine = Engine::new();
    engine.put("walk.mot", cut(MOTION, MOTION_LINES).into_bytes());
    engine.put("plates.sto", cut(PLATES, PLATE_LINES).into_bytes());
    engine.put("plates.xml", LOADS.as_bytes().to_vec());
    for (name, bytes) in files {
        engine.put(name, bytes.to_vec());
    }
    engine
}

/// A refusal is fine; a defect is not.
fn accept_answer(answer: &str) {
    assert!(answer.starts_with(r#"{"ok""#) || answer.starts_with(r#"{"error""#), "{answer}");
    assert!(!answer.starts_with(r#"{"error":{"code":"internal""#), "{answer}");
}
