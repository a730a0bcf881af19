//! What is in a model: as text, JSON and CSV.

use osim_inspect::Inspection;
use osim_model::files::InMemory;
use osim_planning::{Inspector, open_with};
use osim_requests::InspectRequest;
use osim_requests::spell::CommandLine;
use osim_view::report::extent::Extent;
use osim_view::report::inspection::{csv_rows, text};
use osim_view::report::json::line;
use osim_view::report::layout::Colour;
use serde_json::{Value, json};

use crate::front_end::{files_of, request};
use crate::support::{Bench, HUMAN};

/// All models of a request, inspected and spelled.
fn inspected(request: &InspectRequest, files: &InMemory) -> Vec<Inspection> {
    let inspector = Inspector::for_inspect(request, files);
    let one = |path| {
        let opened = open_with(path, inspector.set_files().companion_paths(), files).unwrap();
        let mut inspected = inspector.inspect(&opened).unwrap();
        inspected.spell(&CommandLine);
        inspected
    };
    request.models.iter().map(|path| one(path.as_path())).collect()
}

#[track_caller]
fn same(bench: &Bench, words: &str, json: &Value) {
    let all = inspected(&request!(Inspect, json), &files_of(bench));
    let extent = Extent::new(words.ends_with("--full"));
    let texts: Vec<String> =
        all.iter().map(|model| text(model, &CommandLine, Colour::Plain, extent)).collect();
    assert_eq!(texts.join("\n"), bench.run(words).done().out());
    let lines: String = all.iter().map(line).collect();
    assert_eq!(lines, bench.run(&format!("{words} --format json")).done().out());
    let rows = all.iter().enumerate().map(|(index, model)| csv_rows(model, index == 0).unwrap());
    assert_eq!(rows.collect::<String>(), bench.run(&format!("{words} --format csv")).done().out());
}

#[test]
fn inspect() {
    let bench = Bench::with(&[HUMAN, ("table1/horse_hunt_crossley.osim", "horse.osim")]);
    same(
        &bench,
        "inspect human.osim horse.osim --mass 70 --stance-limbs 2 --full",
        &json!({"verb": "inspect", "models": ["human.osim", "horse.osim"], "mass": 70, "stance_limbs": 2}),
    );
}

#[test]
fn inspect_a_scaled_model_from_its_generic_one() {
    let bench = Bench::with(&[
        ("scale_tool/generic_smooth.osim", "generic.osim"),
        ("scale_tool/scaled_smooth.osim", "scaled.osim"),
        ("scale_tool/applied_scale_set.xml", "applied.xml"),
    ]);
    same(
        &bench,
        "inspect scaled.osim --from generic.osim --body-scale-file applied.xml",
        &json!({
            "verb": "inspect",
            "models": "scaled.osim",
            "from": "generic.osim",
            "body_scale_file": "applied.xml",
        }),
    );
}
