//! After Ctrl-C the run finishes the current models, and a run with `--resume` changes the other models.

use std::time::{Duration, Instant};

use crate::model_folder::{
    assert_no_temporary_files, column_by_model, feed_pipe, folder_with_models, make_pipe, model_bytes,
    open_pipe_when_read, start, wait_for_output,
};
use crate::support::TestDir;

const CALL: &str = "pipe.osim lib --target-mass 500 -d out --jobs 1";

fn send_signal(signal: &str, child: &std::process::Child) {
    let status = std::process::Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap();
    assert!(status.success());
    // Give the process time to handle the signal.
    std::thread::sleep(Duration::from_millis(300));
}

fn send_interrupt(child: &std::process::Child) {
    send_signal("-INT", child);
}

/// Runs a call and sends Ctrl-C while the run reads the first model.
fn run_and_interrupt(dir: &TestDir, arguments: &str) -> (Option<i32>, String) {
    make_pipe(dir, "pipe.osim");
    let mut child = start(dir, arguments);
    feed_pipe(dir, &mut child, "pipe.osim", &model_bytes(99), send_interrupt);
    let run = wait_for_output(child);
    dir.write("pipe.osim", model_bytes(99));
    run
}

#[test]
fn the_current_model_is_finished_and_the_others_are_listed() {
    let dir = folder_with_models(5);
    let (status, text) = run_and_interrupt(&dir, &format!("{CALL} --summary done.csv"));
    assert_eq!(status, Some(130), "{text}");
    assert!(
        text.contains(
            "6 models: 1 written, 5 not begun; stopped: to continue, repeat the command with --resume"
        ),
        "{text}"
    );
    let statuses = column_by_model(&dir.text("done.csv"), "status");
    assert_eq!(statuses.len(), 6);
    assert_eq!(statuses["pipe.osim"], "written");
    assert_eq!(statuses.values().filter(|status| *status == "not-begun").count(), 5);
    assert!(dir.has("out/pipe.osim") && !dir.has("out/even/model00.osim"));
    assert_no_temporary_files(&dir);
    dir.run(&format!("{CALL} --summary done.csv --resume")).succeeded().says(&["5 written", "1 done before"]);

    let undisturbed = folder_with_models(5);
    undisturbed.write("pipe.osim", model_bytes(99));
    undisturbed.run(&format!("{CALL} --summary done.csv")).succeeded();
    assert_eq!(dir.files(), undisturbed.files());
}

#[test]
fn a_run_without_a_summary_can_be_interrupted() {
    let dir = folder_with_models(2);
    let (status, text) = run_and_interrupt(&dir, CALL);
    assert_eq!(status, Some(130), "{text}");
    assert!(text.contains("3 models: 1 written, 2 not begun; stopped"), "{text}");
}

/// A batch system that stops a job (SIGTERM) and a terminal that closes (SIGHUP) have the same effect as Ctrl-C.
#[test]
fn sigterm_and_sighup_work_like_an_interrupt() {
    for signal in ["-TERM", "-HUP"] {
        let dir = folder_with_models(2);
        make_pipe(&dir, "pipe.osim");
        let mut child = start(&dir, CALL);
        feed_pipe(&dir, &mut child, "pipe.osim", &model_bytes(99), |child| send_signal(signal, child));
        let (status, text) = wait_for_output(child);
        assert_eq!(status, Some(130), "{signal}: {text}");
        assert!(text.contains("3 models: 1 written, 2 not begun; stopped"), "{signal}: {text}");
    }
}

#[test]
fn a_second_interrupt_ends_the_run_at_once() {
    let dir = folder_with_models(2);
    make_pipe(&dir, "pipe.osim");
    let mut child = start(&dir, CALL);
    // It waits for bytes that never come.
    let writer = open_pipe_when_read(&dir, &mut child, "pipe.osim");
    send_interrupt(&child);
    assert_eq!(child.try_wait().unwrap(), None, "the first one waits for the model in hand");
    send_interrupt(&child);
    let deadline = Instant::now() + Duration::from_secs(10);
    while child.try_wait().unwrap().is_none() && Instant::now() < deadline {
        std::thread::sleep(Duration::from_millis(10));
    }
    let ended_by_itself = child.try_wait().unwrap().is_some();
    drop(writer);
    std::fs::remove_file(dir.path("pipe.osim")).unwrap();
    let (status, text) = wait_for_output(child);
    assert!(ended_by_itself, "{text}");
    assert_eq!(status, Some(130), "{text}");
    assert!(!dir.files().keys().any(|name| name.starts_with("out/")), "{:?}", dir.files().keys());
}
