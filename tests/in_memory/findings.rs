//! What is wrong with a model, and its remedy, which is data: applied, and gone.

use std::path::Path;

use osim_inspect::CheckResult;
use osim_model::FindingCode;
use osim_model::files::InMemory;
use osim_planning::{Inspector, open_with, prepare};
use osim_requests::spell::{CommandLine, FrontEnd};
use osim_requests::{CheckRequest, Request};
use osim_view::report::check::{LibraryTable, csv_rows, text};
use osim_view::report::extent::Extent;
use osim_view::report::json::line;
use osim_view::report::layout::Colour;
use serde_json::json;

use crate::front_end::{Changed, files_of, request};
use crate::support::{Bench, HUMAN};

/// What is found in a model, spelled.
fn checked(request: &CheckRequest, path: &Path, files: &InMemory) -> CheckResult {
    let inspector = Inspector::for_check(request, files);
    let opened = open_with(path, inspector.set_files().companion_paths(), files).unwrap();
    let inspected = inspector.inspect(&opened).unwrap();
    inspector.refuse_without_contacts(&opened, &inspected).unwrap();
    let mut found = inspector.check(&opened.model, &inspected, None, files);
    found.spell(&CommandLine);
    found
}

fn check_of(model: &str) -> CheckRequest {
    request!(Check, {"verb": "check", "models": [model]})
}

#[test]
fn check() {
    let bench = Bench::with(&[HUMAN, ("format/unequal_stiffness.osim", "unequal.osim")]);
    let files = files_of(&bench);
    for model in ["human.osim", "unequal.osim"] {
        let found = checked(&check_of(model), Path::new(model), &files);
        let said = |more: &str| bench.run(&format!("check {model}{more}")).out();
        for (extent, option) in [(Extent::Brief, ""), (Extent::Full, " --full")] {
            assert_eq!(text(&found, CommandLine.prompt(), Colour::Plain, extent), said(option));
        }
        assert_eq!(line(&found), said(" --format json"));
        assert_eq!(csv_rows(&found, true).unwrap(), said(" --format csv"));
    }
}

#[test]
fn check_of_several_models() {
    let bench = Bench::with(&[HUMAN, ("check/floats.osim", "floats.osim")]);
    let files = files_of(&bench);
    let request =
        request!(Check, {"verb": "check", "models": ["human.osim", "floats.osim"], "deny": "warning"});
    let mut table = LibraryTable::default();
    let mut denied = false;
    for path in &request.models {
        let found = checked(&request, path, &files);
        table.add(&found);
        denied |= found.reaches(request.deny.severity());
    }
    let ran = bench.run("check human.osim floats.osim --deny warning");
    assert_eq!(ran.status, Some(i32::from(denied)));
    assert_eq!(table.text(true, &CommandLine, Colour::Plain, true), ran.out());
}

/// Applies the remedy of `code`, as data in memory and as the command that is proposed: both give the same file, and in it
/// the finding is gone.
#[track_caller]
fn put_right(bench: &Bench, model: &str, code: FindingCode) {
    let mut files = files_of(bench);
    let found = checked(&check_of(model), Path::new(model), &files);
    let finding = found.findings.iter().find(|finding| finding.code() == code).unwrap();

    let mut last = model.to_owned();
    for (remedy, command) in found.steps_to(finding).iter().zip(&found.commands) {
        // A dictionary can be kept, sent and changed before it is run.
        let remedy = Request::from_json(remedy.to_json().as_bytes()).unwrap();
        let change = prepare(remedy, &files).unwrap();
        let changed = Changed::new(&change, &change.models[0], &files).unwrap();
        bench.run(command.strip_prefix("osim-contact-scale ").unwrap()).done();
        for made in changed.results {
            last = made.name.to_string_lossy().into_owned();
            assert!(bench.read(&last) == made.bytes, "{command}");
            files.add(made.name, made.bytes);
        }
    }
    let left = checked(&check_of(&last), Path::new(&last), &files);
    assert!(last != model && left.findings.iter().all(|finding| finding.code() != code), "{left:?}");
}

#[test]
fn remedies() {
    for (fixture, code) in [
        ("check/sunk_in.osim", FindingCode::SunkIn),
        ("check/floats.osim", FindingCode::Floats),
        ("check/contacts_of_another_mass.osim", FindingCode::ContactsOfAnotherMass),
        ("check/wide_transition.osim", FindingCode::WideTransition),
        ("format/left_out_stiffness.osim", FindingCode::DefaultStiffness),
    ] {
        put_right(&Bench::with(&[(fixture, "model.osim")]), "model.osim", code);
    }
}

#[test]
fn a_remedy_in_the_words_of_requests_is_a_request() {
    let bench = Bench::human();
    let inspector = Inspector::for_check(&check_of("human.osim"), &files_of(&bench));
    let opened =
        open_with(Path::new("human.osim"), inspector.set_files().companion_paths(), &files_of(&bench))
            .unwrap();
    let inspected = inspector.inspect(&opened).unwrap();
    let mut found = inspector.check(&opened.model, &inspected, None, &files_of(&bench));
    found.spell(&osim_requests::spell::JsonRequest);
    let asked = json!({"verb": "check", "models": ["human.osim"], "format": "json"}).to_string();
    assert_eq!(line(&found), bench.run_with("request -", asked.as_bytes()).out());
}
