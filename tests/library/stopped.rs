//! Ctrl-C: the models in hand are finished, the others are left, and `--resume` does them.

use std::time::{Duration, Instant};

use crate::library::{column, ended, feed, library, model, no_temporary_files, opened, pipe, start};
use crate::support::Bench;

const CALL: &str = "pipe.osim lib --target-mass 500 -d out --jobs 1";

fn send(signal: &str, child: &std::process::Child) {
    let sent = std::process::Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    // Until it has heard.
    std::thread::sleep(Duration::from_millis(300));
}

fn interrupt(child: &std::process::Child) {
    send("-INT", child);
}

/// Ctrl-C while the first of the models is being read.
fn stopped(bench: &Bench, arguments: &str) -> (Option<i32>, String) {
    pipe(bench, "pipe.osim");
    let mut child = start(bench, arguments);
    feed(bench, &mut child, "pipe.osim", &model(99), interrupt);
    let ran = ended(child);
    bench.write("pipe.osim", model(99));
    ran
}

#[test]
fn the_model_in_hand_is_finished_and_the_others_are_listed() {
    let bench = library(5);
    let (status, text) = stopped(&bench, &format!("{CALL} --summary done.csv"));
    assert_eq!(status, Some(130), "{text}");
    assert!(
        text.contains("6 models: 1 written, 5 not begun; stopped: go on with the same call and --resume"),
        "{text}"
    );
    let statuses = column(&bench.text("done.csv"), "status");
    assert_eq!(statuses.len(), 6);
    assert_eq!(statuses["pipe.osim"], "written");
    assert_eq!(statuses.values().filter(|status| *status == "not-begun").count(), 5);
    assert!(bench.has("out/pipe.osim") && !bench.has("out/even/model00.osim"));
    no_temporary_files(&bench);
    bench.run(&format!("{CALL} --summary done.csv --resume")).done().says(&["5 written", "1 done before"]);

    let calm = library(5);
    calm.write("pipe.osim", model(99));
    calm.run(&format!("{CALL} --summary done.csv")).done();
    assert_eq!(bench.files(), calm.files());
}

#[test]
fn without_a_summary_it_stops_as_well() {
    let bench = library(2);
    let (status, text) = stopped(&bench, CALL);
    assert_eq!(status, Some(130), "{text}");
    assert!(text.contains("3 models: 1 written, 2 not begun; stopped"), "{text}");
}

/// A batch system that stops a job, a terminal that closes: as Ctrl-C.
#[test]
fn other_requests_to_end_are_heard_too() {
    for signal in ["-TERM", "-HUP"] {
        let bench = library(2);
        pipe(&bench, "pipe.osim");
        let mut child = start(&bench, CALL);
        feed(&bench, &mut child, "pipe.osim", &model(99), |child| send(signal, child));
        let (status, text) = ended(child);
        assert_eq!(status, Some(130), "{signal}: {text}");
        assert!(text.contains("3 models: 1 written, 2 not begun; stopped"), "{signal}: {text}");
    }
}

#[test]
fn a_second_one_ends_it_at_once() {
    let bench = library(2);
    pipe(&bench, "pipe.osim");
    let mut child = start(&bench, CALL);
    // It waits for bytes that never come.
    let writer = opened(&bench, &mut child, "pipe.osim");
    interrupt(&child);
    assert_eq!(child.try_wait().unwrap(), None, "the first one waits for the model in hand");
    interrupt(&child);
    let late = Instant::now() + Duration::from_secs(10);
    while child.try_wait().unwrap().is_none() && Instant::now() < late {
        std::thread::sleep(Duration::from_millis(10));
    }
    let ended_by_itself = child.try_wait().unwrap().is_some();
    drop(writer);
    std::fs::remove_file(bench.path("pipe.osim")).unwrap();
    let (status, text) = ended(child);
    assert!(ended_by_itself, "{text}");
    assert_eq!(status, Some(130), "{text}");
    assert!(!bench.files().keys().any(|name| name.starts_with("out/")), "{:?}", bench.files().keys());
}
