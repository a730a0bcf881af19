//! Compares two models after a change: the model in memory, by which the change is judged, and the model that is read from its new bytes.

use std::path::{Path, PathBuf};

use osim_inspect::model_findings;
use osim_model::files::{CompanionPaths, Files, InMemory, ModelFiles};
use osim_model::{FileId, FindingCode};
use osim_planning::prepare;
use osim_requests::Request;
use serde_json::json;

use crate::rules::fixtures;

/// Folders with models that include files, models with contacts of several kinds, and animals of several sizes.
const FOLDERS: [&str; 3] = ["check", "format", "table1"];

fn models_of_folders(files: &InMemory) -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures");
    let of_folder = |folder: &str| std::fs::read_dir(root.join(folder)).unwrap();
    let paths = FOLDERS.into_iter().flat_map(|folder| {
        of_folder(folder).map(move |entry| Path::new(folder).join(entry.unwrap().file_name()))
    });
    let is_model = |path: &PathBuf| path.extension().is_some_and(|end| end == "osim") && files.exists(path);
    paths.filter(is_model).collect()
}

#[test]
fn the_changed_model_is_what_its_bytes_are_read_as() {
    let files = fixtures();
    let mut compared = 0;
    for path in models_of_folders(&files) {
        for call in [
            json!({"verb": "rescale", "target_mass": 100, "contacts_mass": 62}),
            json!({"verb": "convert", "to": "hunt-crossley"}),
            json!({"verb": "remove"}),
        ] {
            let mut call = call.clone();
            call["models"] = json!([path]);
            let request = Request::from_json(call.to_string().as_bytes()).unwrap();
            let Ok(change) = prepare(request, &files) else { continue };
            let Ok(opened) = change.open(&path, &files) else { continue };
            // The plan itself, which nobody refuses for what comes of it.
            let Ok(plan) = change.plan_alone(&opened.model) else { continue };
            let changed = plan.changed_model(&opened.model).unwrap();
            let bytes = plan.patched(&opened.model, FileId::MAIN).unwrap();
            let mut read = ModelFiles::read(&path, bytes, CompanionPaths::default(), &files).unwrap();
            for file in plan.files(&opened.model).filter(|file| *file != FileId::MAIN) {
                read.replace_companion(file, plan.patched(&opened.model, file).unwrap());
            }
            let read = read.open().unwrap().model;
            assert_eq!(changed.document().bytes(), read.document().bytes(), "{call}");
            assert_eq!(changed.contact_digest(|_| None), read.contact_digest(|_| None), "{call}");
            assert_eq!(changed.places_digest(|_| None), read.places_digest(|_| None), "{call}");
            assert_eq!(
                (&changed.note, model_findings(&changed)),
                (&read.note, model_findings(&read)),
                "{call}"
            );
            compared += 1;
        }
    }
    assert!(compared > 200, "{compared}");
}

#[test]
fn forces_that_were_removed_are_not_missed_in_the_result() {
    let files = fixtures();
    let path = Path::new("table1/human_62kg_smooth_sphere.osim");
    // The spheres that are left carry the body, or are too few for it: nobody has to be asked.
    for removed in ["contact_s1_*", "contact_s[2-6]_*"] {
        let call = json!({"verb": "remove", "models": [path], "select": [removed, "heel_*"]});
        let change = prepare(Request::from_json(call.to_string().as_bytes()).unwrap(), &files).unwrap();
        let plan = change.plan(&change.open(path, &files).unwrap(), &files).unwrap();
        let has = |code| plan.findings.iter().any(|finding| finding.code() == code);
        assert!(
            !has(FindingCode::UnmatchedPattern) && !has(FindingCode::CountUnknown),
            "{:?}",
            plan.findings
        );
        assert_eq!(has(FindingCode::SunkIn), removed != "contact_s1_*");
        // A pattern that fits nothing in the model before is still said.
        let remarks: Vec<String> = plan.remarks.iter().map(ToString::to_string).collect();
        let unmatched: Vec<&String> =
            remarks.iter().filter(|text| text.contains("has such a name")).collect();
        assert!(unmatched.len() == 1 && unmatched[0].contains("heel_*"), "{remarks:?}");
    }
}

/// A human whose contacts are right.
const HUMAN: &str = include_str!("../../../../fixtures/check/known_contacts.osim");

/// Fails unless a transfer to `human` from the same human with another stiffness asks whether the result may be wrong.
#[track_caller]
fn assert_asks(human: &str, stiffness: &str) {
    let soft = HUMAN.replace(">1000000<", &format!(">{stiffness}<"));
    let files = InMemory::from_iter([("human.osim", human), ("soft.osim", soft.as_str())]);
    let plan = |yes: &[&str]| {
        let call = json!({
            "verb": "transfer", "models": ["human.osim"], "from": "soft.osim", "reference_mass": 62, "yes": yes,
        });
        let change = prepare(Request::from_json(call.to_string().as_bytes()).unwrap(), &files).unwrap();
        let opened = change.open(Path::new("human.osim"), &files).unwrap();
        change.plan(&opened, &files).map(|_| ()).map_err(|failure| failure.code)
    };
    assert_eq!(plan(&[]), Err("wrong-afterwards"));
    assert_eq!(plan(&["wrong-afterwards"]), Ok(()));
}

/// With a tenth of the stiffness the reference's spheres sink in up to their centres: 10^(2/3) times 0.353 R by (3).
#[test]
fn an_error_of_the_reference_is_asked_about_in_a_model_without_it() {
    assert_asks(HUMAN, "100000");
}

/// With 0.2265 of the stiffness the reference's spheres sink in 0.95 R by (3); in a model whose heels are 6 mm lower these sink in more.
#[test]
fn an_error_that_the_reference_has_not_is_asked_about() {
    let lower = HUMAN.replace("<location>0.00190115 -0.01 ", "<location>0.00190115 -0.016 ");
    assert_asks(&lower, "226500");
}
