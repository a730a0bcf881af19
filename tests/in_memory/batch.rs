//! Rows of a manifest in memory: each row is a request, with a plan and the bytes of a new file.

use std::path::Path;

use osim_model::files::Files;
use osim_planning::Table;
use osim_requests::spell::CommandLine;
use osim_view::report::json::{FailureRecord, PlanRecord, line};

use crate::front_end::{Changed, files_in_memory, request};
use crate::support::{HUMAN, TestDir};

#[test]
fn rows_of_a_manifest_equal_the_command() {
    let dir = TestDir::with(&[
        HUMAN,
        ("table1/mouse_hunt_crossley.osim", "lab/mouse.osim"),
        ("presets/lab.toml", "lab/lab.toml"),
    ]);
    dir.write(
        "lab/rows.csv",
        "model,target-mass,from,presets,set,verb,indentation,no-note,output,#remark\n\
         ../human.osim,500,,,,,,,heavy.osim,an elephant's calf\n\
         mouse.osim,,heel_pad,lab.toml,,,,,padded.osim,\n\
         mouse.osim,,falisse2022,,,,,yes,published.osim,\n\
         mouse.osim,,,,stiffness=x2 dissipation=1,,,,set.osim,\n\
         ../human.osim,,,,,design,0.16,,designed.osim,\n",
    );
    let files = files_in_memory(&dir);
    let request = request!(Batch, {"verb": "batch", "manifest": "lab/rows.csv"});
    let manifest = request.manifest.clone().unwrap();
    let table = Table::read(&files.read(&manifest).unwrap(), manifest.parent().unwrap(), false).unwrap();
    let mut results = Vec::new();
    let mut lines = String::new();
    for (number, row) in table.requests(&request.output, &files) {
        let row = row.unwrap();
        assert_eq!(row.line, number);
        let change = table.prepare(&row, &files).unwrap();
        let changed = Changed::new(&change, &row.model, &files).unwrap();
        lines.push_str(&line(&PlanRecord::new(
            &changed.plan,
            &changed.opened.model,
            &row.model,
            change.output.output.as_deref(),
            None,
        )));
        results.extend(changed.results);
    }
    let run = dir.run("batch lab/rows.csv --format json").succeeded();
    assert_eq!(lines, run.out());
    assert_eq!(results.len(), 5);
    for file in results {
        assert!(dir.read(&file.name.to_string_lossy()) == file.bytes, "{}", file.name.display());
    }
}

#[test]
fn wrong_rows_in_memory_fail_as_in_the_command() {
    let dir = TestDir::with_human();
    dir.write(
        "rows.csv",
        "model,target-mass,from,only\nhuman.osim,heavy,,\nhuman.osim,,falise2022,\nhuman.osim,70,,stifness\nhuman.osim,,,\n",
    );
    let files = files_in_memory(&dir);
    let request = request!(Batch, {"verb": "batch", "manifest": "rows.csv"});
    let table = Table::read(&files.read(Path::new("rows.csv")).unwrap(), Path::new(""), false).unwrap();
    let mut lines = String::new();
    for (number, row) in table.requests(&request.output, &files) {
        let Err(fault) = row.and_then(|row| table.prepare(&row, &files)) else { panic!("row {number}") };
        lines.push_str(&line(&FailureRecord::new(&table.failure("rows.csv", number, &fault), &CommandLine)));
    }
    assert_eq!(lines, dir.run("batch rows.csv --format json").usage_error().wrote_nothing().out());
}
