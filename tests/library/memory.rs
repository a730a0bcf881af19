//! Measures the memory that a run keeps for each model.

use std::process::Child;

use crate::model_folder::{feed_pipe, make_pipe, model_bytes, start, wait_for_output};
use crate::support::{TestDir, fixture, report_skip};

const MODELS_IN_FOLDER: usize = 1500;
const CALL: &str =
    "lib last.osim --target-mass 500 -d out --summary done.csv --format lines --quiet --jobs 1";

/// The largest memory that a process had, in KiB; `None` if the system does not report it.
fn peak_memory(child: &Child) -> Option<usize> {
    let status = std::fs::read_to_string(format!("/proc/{}/status", child.id())).ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    line.split_ascii_whitespace().nth(1)?.parse().ok()
}

/// The largest memory of a run, read when the run waits for its last model.
fn peak_memory_of_run(dir: &TestDir, arguments: &str) -> Option<usize> {
    make_pipe(dir, "last.osim");
    let mut child = start(dir, arguments);
    let mut peak = None;
    feed_pipe(dir, &mut child, "last.osim", &model_bytes(0), |child| peak = peak_memory(child));
    let (status, text) = wait_for_output(child);
    assert_eq!(status, Some(0), "{text}");
    peak
}

/// A resumed run keeps for each model the position of its line (24 bytes), and not the record of the line (3.6 kB).
#[test]
fn a_resumed_run_needs_no_more_memory_than_the_first() {
    let dir = TestDir::new();
    for number in 0..MODELS_IN_FOLDER {
        dir.write(&format!("lib/model{number:04}.osim"), fixture("format/v40000.osim"));
    }
    let (Some(first), Some(resumed)) =
        (peak_memory_of_run(&dir, CALL), peak_memory_of_run(&dir, &format!("{CALL} --resume")))
    else {
        return report_skip("memory of --resume", "the system does not say how much memory a process had");
    };
    // 512 bytes each: far more than the places, far less than the records.
    assert!(resumed < first + MODELS_IN_FOLDER / 2, "{first} KiB, with --resume {resumed} KiB");
}
