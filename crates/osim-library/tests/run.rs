//! A run over a folder, asked for as any front end asks: through the crate's own trait, without the command.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test fails by panicking"
)]

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use osim_library::run::{ChangedModel, Counts, Detail, FrontEnd, Record, Run, RunRequest, Status};
use osim_library::{LibraryFault, sha256};
use osim_model::wording::{Call, Dialect, Example, Input, Plain};
use osim_model::{Remedy, RemedyDialect};
use osim_requests::Request;
use osim_requests::options::RunOptions;
use tempfile::TempDir;

/// 10 kg on one sphere of 0.03 m with a stiffness of 1e6 N/m².
const ONE_FOOT: &str = include_str!("../../osim-model/tests/data/one_foot.osim");

/// The names of fields, and no words for remedies: a change shows none.
struct Words;

impl Dialect for Words {
    fn input(&self, input: Input, example: Option<&Example>) -> String {
        Plain.input(input, example)
    }

    fn call(&self, call: &Call) -> String {
        Plain.call(call)
    }
}

impl RemedyDialect for Words {
    fn remedy(&self, remedy: &Remedy) -> String {
        panic!("nobody asked for {remedy:?}")
    }
}

/// Counts what is done, and shows which files were written.
#[derive(Default)]
struct Watch {
    done: AtomicUsize,
    failed: AtomicUsize,
}

impl FrontEnd for Watch {
    type Shown = Vec<PathBuf>;

    fn dialect(&self) -> &dyn RemedyDialect {
        &Words
    }

    fn detail(&self) -> Detail {
        Detail::Result
    }

    fn show(&self, changed: ChangedModel<'_>) -> Vec<PathBuf> {
        changed.written.paths().to_vec()
    }

    fn is_interrupted(&self) -> bool {
        false
    }

    fn done(&self, failed: bool) {
        self.done.fetch_add(1, Ordering::Relaxed);
        self.failed.fetch_add(usize::from(failed), Ordering::Relaxed);
    }
}

/// What a run did.
struct Ran {
    watch: Watch,
    counts: Counts,
    /// What could not even be listed.
    failures: usize,
    records: Vec<Record>,
    written: Vec<PathBuf>,
}

/// Rescales `models` to 80 kg, into `output`.
fn rescale(models: &Path, field: &str, output: &Path, options: &RunOptions) -> Result<Ran, LibraryFault> {
    let (models, output) = (models.to_str().unwrap(), output.to_str().unwrap());
    let request = serde_json::json!({"verb": "rescale", "models": models, "target_mass": 80, field: output})
        .to_string();
    let Request::Rescale(request) = Request::from_json(request.as_bytes()).unwrap() else { panic!() };
    let mut run = Run::new(
        RunRequest::of_change(request.prepare(&osim_model::files::InMemory::default()).unwrap(), options)?,
        options,
    )?;
    run.begin()?;
    let failures = run.failures().len();
    let (watch, mut records, mut written) = (Watch::default(), Vec::new(), Vec::new());
    let counts = run.work_off(&watch, |_, outcome| {
        records.push(outcome.record);
        written.extend(outcome.shown.unwrap_or_default());
        Ok::<(), LibraryFault>(())
    })?;
    run.finish()?;
    Ok(Ran { watch, counts, failures, records, written })
}

/// Names and contents of all files of a folder.
fn files(folder: &Path) -> Vec<(String, String)> {
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

/// A folder with a good model, one that ends in the middle, and another good one.
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
fn a_bad_file_in_the_middle_stops_nothing() {
    let (folder, models) = three_models();
    let before = files(&models);
    let output = folder.path().join("scaled");
    let ran = rescale(&models, "output_dir", &output, &RunOptions::default()).unwrap();

    // In the order of the names, whichever thread was first.
    let all: Vec<(&str, Status)> =
        ran.records.iter().map(|record| (&record.model[record.model.len() - 6..], record.status)).collect();
    assert_eq!(all, [("a.osim", Status::Written), ("b.osim", Status::Failed), ("c.osim", Status::Written)]);
    assert_eq!((ran.counts.written, ran.counts.failed, ran.counts.interrupted()), (2, 1, false));
    assert_eq!((ran.watch.done.into_inner(), ran.watch.failed.into_inner()), (3, 1));
    let bad = &ran.records[1];
    assert_eq!(bad.error_code.as_deref(), Some("malformed-xml"));
    assert!(bad.error.as_ref().is_some_and(|error| error.contains("SmoothSphereHalfSpaceForce")));
    assert_eq!(files(&models), before);
}

#[test]
fn outputs_are_whole_and_alone_in_their_folder() {
    let (folder, models) = three_models();
    let output = folder.path().join("scaled");
    let mut options = RunOptions::default();
    options.summary = Some(folder.path().join("summary.csv"));
    let ran = rescale(&models, "output_dir", &output, &options).unwrap();
    assert_eq!(ran.written, [output.join("a.osim"), output.join("c.osim")]);

    let written = files(&output);
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
fn no_model_is_written_over() {
    let (folder, models) = three_models();
    let before = files(&models);
    // Onto itself: refused before anything is begun.
    let a = models.join("a.osim");
    assert!(rescale(&a, "output", &a, &RunOptions::default()).is_err());
    // The whole folder into itself: what is written into is never read, so nothing is left to be done.
    let ran = rescale(&models, "output_dir", &models, &RunOptions::default()).unwrap();
    assert_eq!((ran.counts.written, ran.counts.failed, ran.failures), (0, 1, 1));
    // Onto another file that is there already: that model fails.
    let there = folder.path().join("there.osim");
    std::fs::write(&there, "something else").unwrap();
    let ran = rescale(&a, "output", &there, &RunOptions::default()).unwrap();
    assert_eq!((ran.counts.written, ran.counts.failed), (0, 1));
    assert_eq!(std::fs::read_to_string(&there).unwrap(), "something else");
    assert_eq!(files(&models), before);
}
