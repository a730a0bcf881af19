//! How much memory a run keeps for each model.

use std::process::Child;

use crate::library::{ended, feed, model, pipe, start};
use crate::support::{Bench, fixture, skipped};

const MODELS: usize = 1500;
const CALL: &str =
    "lib last.osim --target-mass 500 -d out --summary done.csv --format lines --quiet --jobs 1";

/// The most memory that a process had, in KiB; `None` where the system does not say.
fn peak(child: &Child) -> Option<usize> {
    let status = std::fs::read_to_string(format!("/proc/{}/status", child.id())).ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    line.split_ascii_whitespace().nth(1)?.parse().ok()
}

/// The peak of a run, asked when it waits for the last of its models.
fn peak_of(bench: &Bench, arguments: &str) -> Option<usize> {
    pipe(bench, "last.osim");
    let mut child = start(bench, arguments);
    let mut most = None;
    feed(bench, &mut child, "last.osim", &model(0), |child| most = peak(child));
    let (status, text) = ended(child);
    assert_eq!(status, Some(0), "{text}");
    most
}

/// A run that goes on keeps for each model the place of its line (24 bytes), not what the line says (3.6 kB as a record).
#[test]
fn resume_keeps_no_more_of_a_model_than_the_first_run() {
    let bench = Bench::new();
    for number in 0..MODELS {
        bench.write(&format!("lib/model{number:04}.osim"), fixture("format/v40000.osim"));
    }
    let (Some(first), Some(again)) = (peak_of(&bench, CALL), peak_of(&bench, &format!("{CALL} --resume")))
    else {
        return skipped("memory of --resume", "the system does not say how much memory a process had");
    };
    // 512 bytes each: far more than the places, far less than the records.
    assert!(again < first + MODELS / 2, "{first} KiB, with --resume {again} KiB");
}
