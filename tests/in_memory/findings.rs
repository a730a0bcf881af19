//! Findings about a model, and the requests that correct the model.

use std::path::Path;

use osim_inspect::CheckResult;
use osim_model::FindingCode;
use osim_model::files::InMemory;
use osim_planning::{Inspector, open_with, prepare};
use osim_requests::spell::CommandLine;
use osim_requests::{CheckRequest, Request};
use osim_view::report::check::{LibraryTable, RESULTS_FOLDER, csv_rows, text};
use osim_view::report::extent::{Extent, Layout};
use osim_view::report::json::line;
use serde_json::json;

use crate::front_end::{Changed, files_in_memory, request};
use crate::support::{HUMAN, TestDir};

/// The findings of a model, spelled for the command line.
fn check_and_spell(request: &CheckRequest, path: &Path, files: &InMemory) -> CheckResult {
    let inspector = Inspector::for_check(request, files);
    let opened = open_with(path, inspector.set_files.companion_paths(), files).unwrap();
    let inspected = inspector.inspect(&opened).unwrap();
    inspector.refuse_without_contacts(&opened, &inspected).unwrap();
    let mut result = inspector.check(&opened.model, &inspected, None, files);
    result.spell(&CommandLine);
    result
}

fn check_request(model: &str) -> CheckRequest {
    request!(Check, {"verb": "check", "models": [model]})
}

#[test]
fn check_in_memory_equals_the_command() {
    let dir = TestDir::with(&[HUMAN, ("format/unequal_stiffness.osim", "unequal.osim")]);
    let files = files_in_memory(&dir);
    for model in ["human.osim", "unequal.osim"] {
        let result = check_and_spell(&check_request(model), Path::new(model), &files);
        let printed = |more: &str| dir.run(&format!("check {model}{more}")).out();
        for (extent, option) in [(Extent::Brief, ""), (Extent::Full, " --full")] {
            assert_eq!(text(&result, &CommandLine, Layout { extent, ..Layout::default() }), printed(option));
        }
        assert_eq!(line(&result), printed(" --format json"));
        assert_eq!(csv_rows(&result, true).unwrap(), printed(" --format csv"));
    }
}

#[test]
fn check_of_several_models_equals_the_command() {
    let dir = TestDir::with(&[HUMAN, ("check/floats.osim", "floats.osim")]);
    let files = files_in_memory(&dir);
    let request =
        request!(Check, {"verb": "check", "models": ["human.osim", "floats.osim"], "deny": "warning"});
    let mut table = LibraryTable::new(request.clone(), vec![RESULTS_FOLDER.into()]);
    let mut denied = false;
    for path in &request.models {
        let result = check_and_spell(&request, path, &files);
        table.add(&result);
        denied |= result.findings.iter().any(|finding| finding.severity >= request.deny.severity());
    }
    let run = dir.run("check human.osim floats.osim --deny warning");
    assert_eq!(run.status, Some(i32::from(denied)));
    assert_eq!(table.text(&CommandLine, Layout::default()), run.out());
}

/// Applies the remedy of the finding `code` in memory and with the proposed command. Both must give the same file, without the
/// finding.
#[track_caller]
fn assert_remedy_removes(dir: &TestDir, model: &str, code: FindingCode) {
    let mut files = files_in_memory(dir);
    let result = check_and_spell(&check_request(model), Path::new(model), &files);
    let finding = result.findings.iter().find(|finding| finding.code() == code).unwrap();

    let mut last_model = model.to_owned();
    for (remedy, command) in result.steps_to(finding).iter().zip(&result.commands) {
        // A dictionary can be kept, sent and changed before it is run.
        let remedy = Request::from_json(remedy.to_json().as_bytes()).unwrap();
        let change = prepare(remedy, &files).unwrap();
        let changed = Changed::new(&change, &change.models[0], &files).unwrap();
        dir.run(command.strip_prefix("osim-contact-scale ").unwrap()).succeeded();
        for file in changed.results {
            last_model = file.name.to_string_lossy().into_owned();
            assert!(dir.read(&last_model) == file.bytes, "{command}");
            files.add(file.name, file.bytes);
        }
    }
    let remaining = check_and_spell(&check_request(&last_model), Path::new(&last_model), &files);
    assert!(
        last_model != model && remaining.findings.iter().all(|finding| finding.code() != code),
        "{remaining:?}"
    );
}

#[test]
fn remedies_remove_their_findings() {
    for (fixture, code) in [
        ("check/sunk_in.osim", FindingCode::SunkIn),
        ("check/floats.osim", FindingCode::Floats),
        ("check/contacts_of_another_mass.osim", FindingCode::ContactsOfAnotherMass),
        ("check/wide_transition.osim", FindingCode::WideTransition),
        ("format/left_out_stiffness.osim", FindingCode::DefaultStiffness),
    ] {
        assert_remedy_removes(&TestDir::with(&[(fixture, "model.osim")]), "model.osim", code);
    }
}

#[test]
fn remedies_spelled_as_requests_equal_the_command() {
    let dir = TestDir::with_human();
    let inspector = Inspector::for_check(&check_request("human.osim"), &files_in_memory(&dir));
    let opened =
        open_with(Path::new("human.osim"), inspector.set_files.companion_paths(), &files_in_memory(&dir))
            .unwrap();
    let inspected = inspector.inspect(&opened).unwrap();
    let mut result = inspector.check(&opened.model, &inspected, None, &files_in_memory(&dir));
    result.spell(&osim_requests::spell::JsonRequest);
    let check_request = json!({"verb": "check", "models": ["human.osim"], "format": "json"}).to_string();
    assert_eq!(line(&result), dir.run_with_stdin("request -", check_request.as_bytes()).out());
}
