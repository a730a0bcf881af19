//! Runs over a folder by a small front end that uses the crate's trait, without the command.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use osim_library::run::{
    ChangedModel, CheckedRows, ModelDetail, OutcomeCounts, Record, RowReader, Run, RunFrontEnd, RunRequest,
    Status,
};
use osim_library::{LibraryFault, sha256};
use osim_model::messages::{Call, Dialect, Example, FieldNames, Input};
use osim_planning::prepare;
use osim_requests::options::RunOptions;
use osim_requests::spell::FrontEnd;
use osim_requests::{BatchRequest, Request};
use tempfile::TempDir;

/// A model of 10 kg on one sphere with a radius of 0.03 m and a stiffness of 1e6 N/m².
const ONE_FOOT: &str = include_str!("../../osim-model/tests/data/one_foot.osim");

/// Spells options by the names of fields; fails if a remedy has to be spelled, because a change shows none.
struct Words;

impl Dialect for Words {
    fn input(&self, input: Input, example: Option<&Example>) -> String {
        FieldNames.input(input, example)
    }

    fn call(&self, call: &Call) -> String {
        FieldNames.call(call)
    }
}

impl FrontEnd for Words {
    fn request(&self, request: &Request) -> String {
        panic!("nobody asked for {request:?}")
    }
}

/// A front end that counts finished and failed models, and returns the written files of each model.
#[derive(Default)]
struct CountingFrontEnd {
    done: AtomicUsize,
    failed: AtomicUsize,
}

impl RunFrontEnd for CountingFrontEnd {
    type Shown = Vec<PathBuf>;

    fn dialect(&self) -> &dyn FrontEnd {
        &Words
    }

    fn detail(&self) -> ModelDetail {
        ModelDetail::ResultOnly
    }

    fn show(&self, changed: ChangedModel<'_>) -> Vec<PathBuf> {
        changed.written.paths().to_vec()
    }

    fn is_interrupted(&self) -> bool {
        false
    }

    fn task_done(&self, failed: bool) {
        self.done.fetch_add(1, Ordering::Relaxed);
        self.failed.fetch_add(usize::from(failed), Ordering::Relaxed);
    }
}

/// What a run left: its counts, the lines of its summary and its files.
struct RunResult {
    watch: CountingFrontEnd,
    counts: OutcomeCounts,
    /// The number of models or folders that could not be listed.
    failures: usize,
    records: Vec<Record>,
    written: Vec<PathBuf>,
}

/// Rescales `models` to 80 kg, into `output`.
fn rescale_to_80_kg(
    models: &Path,
    field: &str,
    output: &Path,
    options: &RunOptions,
) -> Result<RunResult, LibraryFault> {
    let (models, output) = (models.to_str().unwrap(), output.to_str().unwrap());
    let request = serde_json::json!({"verb": "rescale", "models": models, "target_mass": 80, field: output})
        .to_string();
    let Request::Rescale(request) = Request::from_json(request.as_bytes()).unwrap() else { panic!() };
    let mut run = Run::new(
        RunRequest::for_change(prepare(*request, &osim_model::files::InMemory::default()).unwrap(), options)?,
        options,
    )?;
    run.begin()?;
    let failures = run.request.failures.len();
    let (watch, mut records, mut written) = (CountingFrontEnd::default(), Vec::new(), Vec::new());
    let counts = run.do_tasks(&watch, |_, outcome| {
        records.push(outcome.record);
        written.extend(outcome.shown.unwrap_or_default());
    })?;
    run.finish()?;
    Ok(RunResult { watch, counts, failures, records, written })
}

/// Names and contents of all files of a folder.
fn files_in_folder(folder: &Path) -> Vec<(String, String)> {
    let mut files: Vec<(String, String)> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .map(|path| {
            let name = path.file_name().unwrap().to_str().unwrap().to_owned();
            (name, std::fs::read_to_string(path).unwrap())
        })
        .collect();
    files.sort();
    files
}

/// A folder with a good model, a truncated model, and another good model.
fn three_models() -> (TempDir, PathBuf) {
    let folder = TempDir::new().unwrap();
    let models = folder.path().join("models");
    std::fs::create_dir(&models).unwrap();
    let half = &ONE_FOOT[..ONE_FOOT.find("<stiffness>").unwrap()];
    for (name, text) in [("a.osim", ONE_FOOT), ("b.osim", half), ("c.osim", ONE_FOOT)] {
        std::fs::write(models.join(name), text).unwrap();
    }
    (folder, models)
}

#[test]
fn a_bad_model_does_not_stop_the_other_models() {
    let (folder, models) = three_models();
    let before = files_in_folder(&models);
    let output = folder.path().join("scaled");
    let ran = rescale_to_80_kg(&models, "output_dir", &output, &RunOptions::default()).unwrap();

    // In the order of the names, whichever thread was first.
    let all: Vec<(&str, Status)> =
        ran.records.iter().map(|record| (&record.model[record.model.len() - 6..], record.status)).collect();
    assert_eq!(all, [("a.osim", Status::Written), ("b.osim", Status::Failed), ("c.osim", Status::Written)]);
    assert_eq!((ran.counts.written, ran.counts.failed, ran.counts.interrupted()), (2, 1, false));
    assert_eq!((ran.watch.done.into_inner(), ran.watch.failed.into_inner()), (3, 1));
    let bad = &ran.records[1];
    assert_eq!(bad.error_code.as_deref(), Some("malformed-xml"));
    assert!(bad.error.as_ref().is_some_and(|error| error.contains("SmoothSphereHalfSpaceForce")));
    assert_eq!(files_in_folder(&models), before);
}

#[test]
fn outputs_are_complete_and_the_only_files_in_their_folder() {
    let (folder, models) = three_models();
    let output = folder.path().join("scaled");
    let summary = Some(folder.path().join("summary.csv"));
    let options = RunOptions { summary, ..RunOptions::default() };
    let ran = rescale_to_80_kg(&models, "output_dir", &output, &options).unwrap();
    assert_eq!(ran.written, [output.join("a.osim"), output.join("c.osim")]);

    let written = files_in_folder(&output);
    let names: Vec<&str> = written.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["a.osim", "c.osim"]);
    for ((_, text), record) in written.iter().zip([&ran.records[0], &ran.records[2]]) {
        // 8 times the mass: twice the radius (8), and 8 / 2² times the stiffness (10).
        assert!(text.contains("<radius>0.06</radius>") && text.contains("<stiffness>2000000</stiffness>"));
        assert_eq!((record.radius_factor, record.stiffness_factor), (Some(2.0), Some(2.0)));
        // Every line of the model is there, but for the three with numbers that changed.
        let lost: Vec<&str> = ONE_FOOT
            .lines()
            .filter(|line| !text.lines().any(|other| other == *line))
            .map(str::trim)
            .collect();
        assert_eq!(
            lost,
            ["<radius>0.03</radius>", "<stiffness>1000000</stiffness>", "<dissipation>2</dissipation>"]
        );
        assert!(text.ends_with("</OpenSimDocument>\n"));
        assert_eq!(record.sha256_output, Some(sha256(text.as_bytes())));
        assert_eq!(record.sha256_input, Some(sha256(ONE_FOOT.as_bytes())));
    }
    // One line for the names of the columns, and one for each model.
    let summary = std::fs::read_to_string(folder.path().join("summary.csv")).unwrap();
    assert_eq!(summary.lines().count(), 4, "{summary}");
}

#[test]
fn no_run_overwrites_a_model() {
    let (folder, models) = three_models();
    let before = files_in_folder(&models);
    // Onto itself: refused before anything is begun.
    let a = models.join("a.osim");
    assert!(rescale_to_80_kg(&a, "output", &a, &RunOptions::default()).is_err());
    // The whole folder into itself: what is written into is never read, so nothing is left to be done.
    let ran = rescale_to_80_kg(&models, "output_dir", &models, &RunOptions::default()).unwrap();
    assert_eq!((ran.counts.written, ran.counts.failed, ran.failures), (0, 1, 1));
    // Onto another file that is there already: that model fails.
    let there = folder.path().join("there.osim");
    std::fs::write(&there, "something else").unwrap();
    let ran = rescale_to_80_kg(&a, "output", &there, &RunOptions::default()).unwrap();
    assert_eq!((ran.counts.written, ran.counts.failed), (0, 1));
    assert_eq!(std::fs::read_to_string(&there).unwrap(), "something else");
    assert_eq!(files_in_folder(&models), before);
}

/// Reads and checks the rows of a table in memory, whose paths begin in `folder`.
fn read_rows(request: &BatchRequest, table: &str, folder: &Path) -> Result<CheckedRows, LibraryFault> {
    RowReader::new(request)?.read(table.as_bytes(), "table", folder)
}

/// Faults in the rows of a table: line, column and message of each.
fn row_faults(
    request: &BatchRequest,
    table: &str,
    folder: &Path,
) -> Vec<(Option<usize>, Option<usize>, String)> {
    let CheckedRows::Invalid(wrong) = read_rows(request, table, folder).unwrap() else {
        panic!("nothing is wrong")
    };
    assert!(wrong.iter().all(|failure| failure.model.to_string() == "table"), "{wrong:?}");
    wrong.into_iter().map(|failure| (failure.line, failure.column, failure.message.to_string())).collect()
}

/// The stiffness of the only contact in a model such as [`ONE_FOOT`].
fn stiffness_in_model(model: &Path) -> f64 {
    let text = std::fs::read_to_string(model).unwrap();
    let (_, rest) = text.split_once("<stiffness>").unwrap();
    rest.split_once('<').unwrap().0.trim().parse().unwrap()
}

#[test]
fn a_table_can_be_in_memory() {
    let (folder, models) = three_models();
    let table = "model,target_mass,output,#site\na.osim,80,../a80.osim,north\nc.osim,6,../c6.osim,south\n";
    let request = BatchRequest { allow_outside: true, ..BatchRequest::default() };
    let CheckedRows::Run(rows) = read_rows(&request, table, &models).unwrap() else { panic!() };
    assert!(rows.extra_files.is_empty(), "{:?}", rows.extra_files);
    let options = RunOptions::default();
    let mut run = Run::new(rows, &options).unwrap();
    run.begin().unwrap();
    let mut user_columns = Vec::new();
    let counts = run
        .do_tasks(&CountingFrontEnd::default(), |task, outcome| {
            assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
            user_columns.push((task.row, outcome.record.user_columns));
        })
        .unwrap();
    run.finish().unwrap();
    assert_eq!(counts.written, 2);
    let site = |text: &str| vec![("#site".to_owned(), text.to_owned())];
    assert_eq!(user_columns, [(Some(2), site("north")), (Some(3), site("south"))]);
    // (10) with radii that follow the masses' cube root: E* grows like M^(1/3); 10 kg had 1e6 N/m².
    for (name, mass) in [("a80.osim", 80.0_f64), ("c6.osim", 6.0)] {
        let expected = 1e6 * (mass / 10.0).cbrt();
        let found = stiffness_in_model(&folder.path().join(name));
        assert!((found / expected - 1.0).abs() < 1e-12, "{name}: {found}, expected {expected}");
    }
}

#[test]
fn all_wrong_rows_of_a_table_are_found_at_once() {
    let (folder, models) = three_models();
    let request = BatchRequest::default();
    let table = "model,target_mass,output\nmissing.osim,80,\na.osim,-1,\n.,80,\nc.osim,80,../outside.osim\n";
    let before = files_in_folder(&models);
    let found = row_faults(&request, table, &models);
    let places: Vec<_> = found.iter().map(|(line, column, _)| (*line, *column)).collect();
    assert_eq!(
        places,
        [(Some(2), Some(1)), (Some(3), Some(2)), (Some(4), Some(1)), (Some(5), Some(3))],
        "{found:?}"
    );
    for ((_, _, message), part) in found.iter().zip([
        "row 2, column 'model': there is no such file: ",
        "row 3, column 'target_mass': '-1': ",
        "row 4, column 'model': a folder, expected one model per row",
        "is outside the folder ",
    ]) {
        assert!(message.contains(part), "{message}");
    }
    assert_eq!(files_in_folder(&models), before);
    assert!(!folder.path().join("outside.osim").exists());
}

#[test]
fn bytes_without_a_table_and_options_for_one_model_are_refused() {
    let (_folder, models) = three_models();
    let refused = |request: &BatchRequest, table: &str| match read_rows(request, table, &models) {
        Err(fault) => fault.to_string(),
        Ok(_) => panic!("{table:?} is read"),
    };
    let request = BatchRequest::default();
    assert_eq!(
        refused(&request, "model,target_mass\n"),
        "table: no rows below the first one, which names the columns"
    );
    assert!(refused(&request, "mass\n62\n").starts_with("table: "));
    let output = serde_json::json!({"verb": "batch", "manifest": "-", "output": "one.osim"}).to_string();
    let Request::Batch(output) = Request::from_json(output.as_bytes()).unwrap() else { panic!() };
    assert!(refused(&output, "model,target_mass\na.osim,80\n").contains("is for one model"));
}
