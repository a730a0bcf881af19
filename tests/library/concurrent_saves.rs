//! Another program saves a model while this program changes the model in place, and then the run is killed. The save of the other
//! program must stay under a name that no later run removes.

use std::collections::BTreeMap;
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

use crate::model_folder::{assert_no_temporary_files, run_shell, shell_command};
use crate::support::{HUMAN, TestDir, fixture, report_skip};

const SAVED_TEXT: &str = "<!-- saved by another program -->\n";

/// System calls that a run makes after the exchange of the model and its new version.
const SYSTEM_CALLS_AFTER_EXCHANGE: [&str; 4] = ["openat", "fsync", "unlink", "unlinkat"];

/// Numbers of system calls of each kind that the exchanging thread makes before it exchanges the two files.
struct Exchange {
    before: BTreeMap<&'static str, usize>,
    call: String,
}

fn command_line(options: &str) -> String {
    format!("human.osim --target-mass 500 --in-place --quiet {options}")
}

/// A shell command that runs the call under strace and writes its process id to the file `process`.
fn strace_command(strace_options: &str, call: &str) -> String {
    let calls = SYSTEM_CALLS_AFTER_EXCHANGE.join(",");
    format!(
        "exec strace -f -qq -o trace -e trace=renameat2,{calls} {strace_options} sh -c 'echo $$ > process; exec \"$COMMAND\" {call}'"
    )
}

impl Exchange {
    /// Counts the system calls in an undisturbed run under strace; `None` if strace is missing or files cannot be exchanged.
    fn find(options: &str) -> Option<Self> {
        let dir = TestDir::with_human();
        let (status, _) = run_shell(&dir, &strace_command("", &command_line(options)));
        let trace = if status == Some(0) { dir.text("trace") } else { String::new() };
        let exchange = trace.lines().position(|line| line.contains("RENAME_EXCHANGE) = 0"));
        let Some(at) = exchange else {
            report_skip("saved and killed", "strace is missing or may not trace here");
            return None;
        };
        let lines: Vec<(&str, &str)> =
            trace.lines().take(at + 1).filter_map(|line| line.split_once(' ')).collect();
        let thread = lines[at].0;
        let count = |call: &str| {
            let begin = format!("{call}(");
            lines.iter().filter(|(of, rest)| *of == thread && rest.trim_start().starts_with(&begin)).count()
        };
        let before = SYSTEM_CALLS_AFTER_EXCHANGE
            .iter()
            .chain(&["renameat2"])
            .map(|call| (*call, count(call)))
            .collect();
        Some(Self { before, call: command_line(options) })
    }

    /// Starts a run that waits for a second before the exchange.
    fn start(&self, dir: &TestDir, injected: &str) -> Child {
        let at = self.before["renameat2"];
        let injected =
            format!("-e inject=renameat2:delay_enter=1000000:{injected}").replace("AT", &at.to_string());
        let script = strace_command(&injected, &self.call);
        shell_command(dir, &["sh", "-c", &script])
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap()
    }
}

/// Waits until `is_there` is true.
fn wait_until(what: &str, mut is_there: impl FnMut() -> bool) {
    let end = Instant::now() + Duration::from_secs(60);
    while !is_there() {
        assert!(Instant::now() < end, "{what}");
        std::thread::sleep(Duration::from_millis(2));
    }
}

/// Saves the model as another program when the run is about to exchange the model and its new version.
fn save_before_exchange(dir: &TestDir) {
    // The successor is complete: it has a note that the model has not.
    wait_until("the successor is complete", || {
        let successors = dir.files().into_iter().filter(|(name, _)| !name.ends_with(".osim"));
        successors.into_iter().any(|(_, bytes)| {
            let text = String::from_utf8_lossy(&bytes);
            text.contains("made for 500 kg") && text.trim_end().ends_with("</OpenSimDocument>")
        })
    });
    std::thread::sleep(Duration::from_millis(300));
    dir.write("human.osim", [fixture(HUMAN.0), SAVED_TEXT.as_bytes().to_vec()].concat());
}

/// Names of the files that contain the text that the other program saved.
fn files_with_save(dir: &TestDir) -> Vec<String> {
    let has_mark = |bytes: &[u8]| String::from_utf8_lossy(bytes).contains(SAVED_TEXT);
    dir.files().into_iter().filter(|(_, bytes)| has_mark(bytes)).map(|(name, _)| name).collect()
}

/// Asserts that the text that another program saved during the run is still in a file, and after a later run in the model or in its
/// backup.
#[track_caller]
fn assert_saved_text_survives(dir: &TestDir, when: &str) {
    let names = files_with_save(dir);
    let beside = |name: &String| name.starts_with("human.osim");
    assert!(names.iter().any(beside), "{when}: {names:?} of {:?}", dir.files().keys());
    let mut command = dir.command("human.osim --target-mass 400 --contacts-mass 62 -o other.osim --quiet");
    let output = command.output().unwrap();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{when}: {errors}");
    assert_no_temporary_files(dir);
    let names = files_with_save(dir);
    let backup = names.iter().find(|name| name.starts_with("human.osim.bak"));
    if !names.contains(&"human.osim".to_owned()) {
        let backup = backup.unwrap_or_else(|| panic!("{when}: {names:?}"));
        assert!(errors.contains(&format!("kept as {backup}")), "{when}: {errors}");
    }
    let all = dir.files();
    assert!(!all.keys().any(|name| name.contains(".replaced-")), "{when}: {:?}", all.keys());
}

#[test]
fn a_save_before_the_exchange_survives_a_kill_after_it() {
    // In parallel, because strace ends only after its delay, even if the traced run has ended.
    std::thread::scope(|scope| {
        scope.spawn(|| save_and_kill(""));
        scope.spawn(|| save_and_kill("--no-backup"));
    });
}

fn save_and_kill(options: &str) {
    let Some(exchange) = Exchange::find(options) else { return };
    let dir = TestDir::with_human();
    let mut child = exchange.start(&dir, "delay_exit=10000000:when=AT");
    save_before_exchange(&dir);
    wait_until("the successor has the model's name", || !dir.text("human.osim").contains(SAVED_TEXT));
    let (killed, text) = run_shell(&dir, "kill -9 $(cat process)");
    assert_eq!(killed, Some(0), "{text}");
    child.wait().unwrap();
    assert_saved_text_survives(&dir, options);
    assert!(!files_with_save(&dir).contains(&"human.osim".to_owned()), "killed before it was put back");
}

#[test]
fn a_save_survives_a_kill_at_every_later_system_call() {
    use std::os::unix::process::ExitStatusExt;
    let Some(exchange) = Exchange::find("") else { return };
    let mut kills = 0;
    for call in SYSTEM_CALLS_AFTER_EXCHANGE {
        for at in exchange.before[call] + 1.. {
            let dir = TestDir::with_human();
            let injected = format!("when=AT -e inject={call}:signal=KILL:when={at}");
            let mut child = exchange.start(&dir, &injected);
            save_before_exchange(&dir);
            let status = child.wait().unwrap();
            assert_saved_text_survives(&dir, &format!("{call} {at}, {status}"));
            if status.signal() != Some(9) {
                break;
            }
            kills += 1;
        }
    }
    assert!(kills >= 4, "{kills}");
}

/// On a system that cannot exchange files, either both or neither of a force set and its geometry set change.
#[test]
fn a_save_into_the_second_of_two_files_restores_the_first() {
    let pair = [
        ("format/standalone_ForceSet.xml", "forces.xml"),
        ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
        ("format/standalone_model_without_contacts.osim", "bones.osim"),
    ];
    for options in ["", "--no-backup"] {
        let dir = TestDir::with(&pair);
        let [forces, geometry] = ["forces.xml", "geometry.xml"].map(|name| dir.read(name));
        let call = format!(
            "forces.xml --geometry geometry.xml --model bones.osim --target-mass 500 --in-place --quiet {options}"
        );
        let script = format!(
            "exec strace -f -qq -o trace -e trace=renameat2,renameat,rename -e inject=renameat2:error=EINVAL \
             -e inject=renameat,rename:delay_exit=1000000 \"$COMMAND\" {call}"
        );
        let mut child = shell_command(&dir, &["sh", "-c", &script])
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        wait_until("the first of the files is changed", || {
            dir.read("forces.xml") != forces || child.try_wait().unwrap().is_some()
        });
        let saved = [geometry.as_slice(), SAVED_TEXT.as_bytes()].concat();
        dir.write("geometry.xml", &saved);
        let output = child.wait_with_output().unwrap();
        if !dir.has("trace") {
            return report_skip("saved and undone", "strace is missing or may not trace here");
        }
        let errors = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{errors}");
        assert!(
            errors.contains("another program changed") && errors.contains("so nothing was written"),
            "{errors}"
        );
        assert!(dir.read("forces.xml") == forces, "the first of the files is as it was: {errors}");
        assert!(dir.read("geometry.xml") == saved, "{errors}");
        assert_no_temporary_files(&dir);
        assert!(!dir.files().keys().any(|name| name.contains(".replaced-")), "{:?}", dir.files().keys());
    }
}
