//! A model before and after a change has the same findings as `check` gives for both, without a second plan of the change.

use std::cell::Cell;
use std::path::{Path, PathBuf};

use osim_inspect::InspectOptions;
use osim_model::files::{InMemory, ModelFiles, OpenModel};
use osim_planning::{BeforeAfter, PreparedChange, check_with_remedies, find_changeable_values, prepare};
use osim_requests::spell::CommandLine;
use serde_json::json;

use crate::front_end::{Changed, request_from_json};
use crate::support::root;

fn check_json(options: &InspectOptions, opened: &OpenModel) -> serde_json::Value {
    let inspected = options.inspect(opened.name(), &opened.model, None);
    let mut check = check_with_remedies(options, &opened.model, &inspected, &[]);
    check.spell(&CommandLine);
    serde_json::to_value(check).unwrap()
}

fn fixture_models() -> Vec<PathBuf> {
    let folders = ["table1", "check", "format", "quirks"].map(|folder| root().join("fixtures").join(folder));
    let files = folders.iter().flat_map(|folder| std::fs::read_dir(folder).unwrap());
    let mut models: Vec<PathBuf> = files.map(|file| file.unwrap().path()).collect();
    models.retain(|path| path.extension().is_some_and(|ending| ending == "osim"));
    models.sort();
    models
}

#[test]
fn before_and_after_of_a_plan_agree_with_check() {
    let mut compared = 0;
    for path in fixture_models() {
        let bytes = std::fs::read(&path).unwrap();
        let files = InMemory::from_iter([("model.osim", bytes.as_slice())]);
        for request in [
            json!({"verb": "rescale", "models": "model.osim", "target_mass": 500}),
            json!({"verb": "rescale", "models": "model.osim", "target_mass": 5, "only": "radius"}),
            json!({"verb": "set", "models": "model.osim", "set": {"stiffness": "x2"}}),
            json!({"verb": "design", "models": "model.osim", "restitution": 0.9, "impact_speed": 0.1}),
        ] {
            let change: PreparedChange = prepare(request_from_json(&request), &files).unwrap();
            let Ok(changed) = Changed::new(&change, Path::new("model.osim"), &files) else { continue };
            let reads_of_new_files = Cell::new(0);
            let companions = change.set_files.companion_paths();
            let new_files = || {
                reads_of_new_files.set(reads_of_new_files.get() + 1);
                changed.as_files(
                    &ModelFiles::read(Path::new("model.osim"), bytes.clone(), companions, &files).unwrap(),
                )
            };
            let before = check_json(&change.options, &changed.opened);
            let before_after =
                BeforeAfter::of_plan(&change, &changed.opened, &changed.plan, new_files, &CommandLine, false)
                    .unwrap();
            assert_eq!(
                serde_json::to_value(&before_after.before.1).unwrap(),
                before,
                "{}: {request}",
                path.display()
            );
            assert_eq!(
                reads_of_new_files.get(),
                usize::from(!changed.plan.is_empty()),
                "{}: {request}",
                path.display()
            );
            if let Some((_, after)) = &before_after.after {
                // Remedies of the new model are tried only if the request can change it.
                let written = ModelFiles::read(
                    Path::new("model.osim"),
                    changed.results[0].bytes.clone(),
                    osim_model::files::CompanionPaths::default(),
                    &files,
                )
                .unwrap()
                .open()
                .unwrap();
                let remedies = |value: &serde_json::Value| -> Vec<bool> {
                    let findings = value["findings"].as_array().unwrap();
                    findings.iter().map(|finding| !finding["command"].is_null()).collect()
                };
                let can_be_tried = find_changeable_values(&change.options, &written.model).numbers;
                let after = serde_json::to_value(after).unwrap();
                assert!(can_be_tried || !remedies(&after).contains(&true), "{}: {request}", path.display());
            }
            compared += 1;
        }
    }
    assert!(compared > 100, "{compared}");
}
