//! Rows of a manifest: each a request, with a plan and the bytes of a file.

use std::path::Path;

use osim_model::files::Files;
use osim_planning::Table;
use osim_requests::spell::CommandLine;
use osim_view::report::json::{FailureRecord, PlanRecord, line};

use crate::front_end::{Changed, files_of, request};
use crate::support::{Bench, HUMAN};

#[test]
fn batch() {
    let bench = Bench::with(&[
        HUMAN,
        ("table1/mouse_hunt_crossley.osim", "lab/mouse.osim"),
        ("presets/lab.toml", "lab/lab.toml"),
    ]);
    bench.write(
        "lab/rows.csv",
        "model,target-mass,from,presets,set,verb,indentation,no-note,output,#remark\n\
         ../human.osim,500,,,,,,,heavy.osim,an elephant's calf\n\
         mouse.osim,,heel_pad,lab.toml,,,,,padded.osim,\n\
         mouse.osim,,falisse2022,,,,,yes,published.osim,\n\
         mouse.osim,,,,stiffness=x2 dissipation=1,,,,set.osim,\n\
         ../human.osim,,,,,design,0.16,,designed.osim,\n",
    );
    let files = files_of(&bench);
    let request = request!(Batch, {"verb": "batch", "manifest": "lab/rows.csv"});
    let manifest = request.manifest.clone().unwrap();
    let table = Table::read(&files.read(&manifest).unwrap(), manifest.parent().unwrap()).unwrap();
    let mut made = Vec::new();
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
        made.extend(changed.results);
    }
    let ran = bench.run("batch lab/rows.csv --format json").done();
    assert_eq!(lines, ran.out());
    assert_eq!(made.len(), 5);
    for file in made {
        assert!(bench.read(&file.name.to_string_lossy()) == file.bytes, "{}", file.name.display());
    }
}

#[test]
fn rows_that_are_wrong() {
    let bench = Bench::human();
    bench.write(
        "rows.csv",
        "model,target-mass,from,only\nhuman.osim,heavy,,\nhuman.osim,,falise2022,\nhuman.osim,70,,stifness\nhuman.osim,,,\n",
    );
    let files = files_of(&bench);
    let request = request!(Batch, {"verb": "batch", "manifest": "rows.csv"});
    let table = Table::read(&files.read(Path::new("rows.csv")).unwrap(), Path::new("")).unwrap();
    let mut lines = String::new();
    for (number, row) in table.requests(&request.output, &files) {
        let Err(fault) = row.and_then(|row| table.prepare(&row, &files)) else { panic!("row {number}") };
        lines.push_str(&line(&FailureRecord::new(&table.failure("rows.csv", number, &fault), &CommandLine)));
    }
    assert_eq!(lines, bench.run("batch rows.csv --format json").usage().wrote_nothing().out());
}
