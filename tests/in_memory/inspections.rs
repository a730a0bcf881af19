//! `inspect` in memory gives the text, JSON and CSV of the command.

use osim_inspect::Inspection;
use osim_model::files::InMemory;
use osim_planning::{Inspector, open_with};
use osim_requests::InspectRequest;
use osim_requests::spell::CommandLine;
use osim_view::report::extent::{Extent, Layout};
use osim_view::report::inspection::{csv_rows, text};
use osim_view::report::json::line;
use serde_json::{Value, json};

use crate::front_end::{files_in_memory, request};
use crate::support::{HUMAN, TestDir};

/// All models of a request, inspected and spelled.
fn inspected(request: &InspectRequest, files: &InMemory) -> Vec<Inspection> {
    let inspector = Inspector::for_inspect(request, files);
    let inspect_one = |path| {
        let opened = open_with(path, inspector.set_files.companion_paths(), files).unwrap();
        let mut inspected = inspector.inspect(&opened).unwrap();
        inspected.spell(&CommandLine);
        inspected
    };
    request.models.iter().map(|path| inspect_one(path.as_path())).collect()
}

#[track_caller]
fn assert_same_output(dir: &TestDir, words: &str, json: &Value) {
    let all = inspected(&request!(Inspect, json), &files_in_memory(dir));
    let extent = Extent::new(words.ends_with("--full"));
    let layout = Layout { extent, ..Layout::default() };
    let texts: Vec<String> = all.iter().map(|model| text(model, &CommandLine, layout)).collect();
    assert_eq!(texts.join("\n"), dir.run(words).succeeded().out());
    let lines: String = all.iter().map(line).collect();
    assert_eq!(lines, dir.run(&format!("{words} --format json")).succeeded().out());
    let rows = all.iter().enumerate().map(|(index, model)| csv_rows(model, index == 0).unwrap());
    assert_eq!(rows.collect::<String>(), dir.run(&format!("{words} --format csv")).succeeded().out());
}

#[test]
fn inspect_in_memory_equals_the_command() {
    let dir = TestDir::with(&[HUMAN, ("table1/horse_hunt_crossley.osim", "horse.osim")]);
    assert_same_output(
        &dir,
        "inspect human.osim horse.osim --mass 70 --stance-limbs 2 --full",
        &json!({"verb": "inspect", "models": ["human.osim", "horse.osim"], "mass": 70, "stance_limbs": 2}),
    );
}

#[test]
fn inspect_of_a_scaled_model_equals_the_command() {
    let dir = TestDir::with(&[
        ("scale_tool/generic_smooth.osim", "generic.osim"),
        ("scale_tool/scaled_smooth.osim", "scaled.osim"),
        ("scale_tool/applied_scale_set.xml", "applied.xml"),
    ]);
    assert_same_output(
        &dir,
        "inspect scaled.osim --from generic.osim --body-scale-file applied.xml",
        &json!({
            "verb": "inspect",
            "models": "scaled.osim",
            "from": "generic.osim",
            "body_scale_file": "applied.xml",
        }),
    );
}
