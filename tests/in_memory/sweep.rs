//! Variants of one model in memory: the bytes of each variant, and the table of all variants.

use std::path::Path;

use osim_model::files::{CompanionPaths, FileName, Files, ModelFiles};
use osim_planning::SweepPlan;
use osim_view::report::json::line;
use osim_view::report::results::SweepRecord;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use crate::front_end::{files_in_memory, request};
use crate::support::TestDir;

#[track_caller]
fn assert_same_sweep(words: &str, json: &Value) {
    let dir = TestDir::with_human();
    let files = files_in_memory(&dir);
    let request = request!(Sweep, json);
    let path = request.model.clone().unwrap();
    let bytes = files.read(&path).unwrap();
    let model = ModelFiles::read(&path, bytes, CompanionPaths::default(), &files).unwrap();
    let plan = SweepPlan::new(&request, model).unwrap();
    plan.check_ends().unwrap();
    let run = dir.run(&format!("sweep {words} -d out --format json")).succeeded();

    let mut table = csv::Writer::from_writer(Vec::new());
    table.write_record(plan.table_header()).unwrap();
    for index in 0..plan.count() {
        let name = plan.file_name(index);
        let variant = plan.make(index).unwrap();
        assert!(dir.read(&format!("out/{name}")) == variant.bytes, "{name}");
        let digest = Sha256::digest(&variant.bytes).iter().map(|byte| format!("{byte:02x}")).collect();
        table.write_record(variant.row(digest)).unwrap();
    }
    let manifest = Path::new("out").join(plan.table_name());
    assert_eq!(
        dir.text(&manifest.to_string_lossy()),
        String::from_utf8(table.into_inner().unwrap()).unwrap()
    );
    let record = SweepRecord::new(&FileName::from(path.as_path()), Path::new("out"), Some(&manifest));
    let record = SweepRecord { points: plan.count(), models: plan.count(), ..record };
    assert_eq!(line(&record), run.out());
}

#[test]
fn the_points_of_a_grid_equal_the_command() {
    assert_same_sweep(
        "human.osim --grid stiffness=x0.5,x2 --grid restitution=0.5,0.8",
        &json!({
            "verb": "sweep",
            "model": "human.osim",
            "grid": {"stiffness": ["x0.5", "x2"], "restitution": [0.5, 0.8]},
        }),
    );
}

#[test]
fn the_steps_of_a_ladder_equal_the_command() {
    assert_same_sweep(
        "human.osim --ladder 3 --indentation 0.16 --restitution 0.8",
        &json!({"verb": "sweep", "model": "human.osim", "ladder": 3, "indentation": 0.16, "restitution": 0.8}),
    );
}

#[test]
fn contradicting_axes_are_refused_as_by_the_command() {
    let dir = TestDir::with_human();
    let files = files_in_memory(&dir);
    let request = request!(Sweep, {
        "verb": "sweep",
        "model": "human.osim",
        "grid": {"stiffness": [1e5], "indentation": [0.1]},
    });
    let path = Path::new("human.osim");
    let model = ModelFiles::read(path, files.read(path).unwrap(), CompanionPaths::default(), &files).unwrap();
    let Err(osim_requests::RequestError::Fault(fault)) = SweepPlan::new(&request, model) else { panic!() };
    let run = dir.run("sweep human.osim --grid stiffness=1e5 --grid indentation=0.1").usage_error();
    assert_eq!(format!("error: {}\n", fault.spelled(&osim_requests::spell::CommandLine)), run.err());
}
