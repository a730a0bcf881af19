//! Another program saves a model at the moment when it is changed in place, and then the run is killed: the save is there under a
//! name that no later run removes.

use std::collections::BTreeMap;
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

use crate::library::{no_temporary_files, shell, shell_command};
use crate::support::{Bench, HUMAN, fixture, skipped};

const MARK: &str = "<!-- saved by another program -->\n";

/// System calls that come after the exchange of the model and its successor.
const LATER: [&str; 4] = ["openat", "fsync", "unlink", "unlinkat"];

/// How often the thread that exchanges the two files has made each system call when it comes to that.
struct Exchange {
    before: BTreeMap<&'static str, usize>,
    call: String,
}

fn call(options: &str) -> String {
    format!("human.osim --target-mass 500 --in-place --quiet {options}")
}

/// Words that run the command under strace, which does `how`. The command's process is in the file `process`.
fn straced(how: &str, call: &str) -> String {
    let calls = LATER.join(",");
    format!(
        "exec strace -f -qq -o trace -e trace=renameat2,{calls} {how} sh -c 'echo $$ > process; exec \"$COMMAND\" {call}'"
    )
}

impl Exchange {
    /// From an undisturbed run under strace; `None` where nothing can be traced or exchanged here.
    fn find(options: &str) -> Option<Self> {
        let bench = Bench::human();
        let (status, _) = shell(&bench, &straced("", &call(options)));
        let trace = if status == Some(0) { bench.text("trace") } else { String::new() };
        let exchange = trace.lines().position(|line| line.contains("RENAME_EXCHANGE) = 0"));
        let Some(at) = exchange else {
            skipped("saved and killed", "strace is missing or may not trace here");
            return None;
        };
        let lines: Vec<(&str, &str)> =
            trace.lines().take(at + 1).filter_map(|line| line.split_once(' ')).collect();
        let thread = lines[at].0;
        let count = |call: &str| {
            let begin = format!("{call}(");
            lines.iter().filter(|(of, rest)| *of == thread && rest.trim_start().starts_with(&begin)).count()
        };
        let before = LATER.iter().chain(&["renameat2"]).map(|call| (*call, count(call))).collect();
        Some(Self { before, call: call(options) })
    }

    /// Starts a run that waits for a second before the exchange.
    fn start(&self, bench: &Bench, injected: &str) -> Child {
        let at = self.before["renameat2"];
        let injected =
            format!("-e inject=renameat2:delay_enter=1000000:{injected}").replace("AT", &at.to_string());
        let script = straced(&injected, &self.call);
        shell_command(bench, &["sh", "-c", &script])
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap()
    }
}

/// Waits for something of a run.
fn wait(what: &str, mut is_there: impl FnMut() -> bool) {
    let end = Instant::now() + Duration::from_secs(60);
    while !is_there() {
        assert!(Instant::now() < end, "{what}");
        std::thread::sleep(Duration::from_millis(2));
    }
}

/// Saves as soon as the run is about to exchange the model and its successor.
fn save(bench: &Bench) {
    // The successor is complete: it has a note that the model has not.
    wait("the successor is complete", || {
        let successors = bench.files().into_iter().filter(|(name, _)| !name.ends_with(".osim"));
        successors.into_iter().any(|(_, bytes)| {
            let text = String::from_utf8_lossy(&bytes);
            text.contains("made for 500 kg") && text.trim_end().ends_with("</OpenSimDocument>")
        })
    });
    std::thread::sleep(Duration::from_millis(300));
    bench.write("human.osim", [fixture(HUMAN.0), MARK.as_bytes().to_vec()].concat());
}

/// Names of files that hold what was saved.
fn saved(bench: &Bench) -> Vec<String> {
    let holds = |bytes: &[u8]| String::from_utf8_lossy(bytes).contains(MARK);
    bench.files().into_iter().filter(|(_, bytes)| holds(bytes)).map(|(name, _)| name).collect()
}

/// What was saved is there now, and after a later run it has the name of the model or of a backup.
#[track_caller]
fn assert_kept(bench: &Bench, when: &str) {
    let names = saved(bench);
    let beside = |name: &String| name.starts_with("human.osim");
    assert!(names.iter().any(beside), "{when}: {names:?} of {:?}", bench.files().keys());
    let mut command = bench.command("human.osim --target-mass 400 --contacts-mass 62 -o other.osim --quiet");
    let output = command.output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{when}: {said}");
    no_temporary_files(bench);
    let names = saved(bench);
    let backup = names.iter().find(|name| name.starts_with("human.osim.bak"));
    if !names.contains(&"human.osim".to_owned()) {
        let backup = backup.unwrap_or_else(|| panic!("{when}: {names:?}"));
        assert!(said.contains(&format!("kept as {backup}")), "{when}: {said}");
    }
    let all = bench.files();
    assert!(!all.keys().any(|name| name.contains(".replaced-")), "{when}: {:?}", all.keys());
}

#[test]
fn a_save_before_the_exchange_outlives_a_kill_right_after_it() {
    // Beside each other: strace ends only when its delay does, also where the run it traces has ended.
    std::thread::scope(|both| {
        both.spawn(|| saved_then_killed(""));
        both.spawn(|| saved_then_killed("--no-backup"));
    });
}

fn saved_then_killed(options: &str) {
    let Some(exchange) = Exchange::find(options) else { return };
    let bench = Bench::human();
    let mut child = exchange.start(&bench, "delay_exit=10000000:when=AT");
    save(&bench);
    wait("the successor has the model's name", || !bench.text("human.osim").contains(MARK));
    let (killed, text) = shell(&bench, "kill -9 $(cat process)");
    assert_eq!(killed, Some(0), "{text}");
    child.wait().unwrap();
    assert_kept(&bench, options);
    assert!(!saved(&bench).contains(&"human.osim".to_owned()), "killed before it was put back");
}

#[test]
fn a_save_outlives_a_kill_at_every_later_step() {
    use std::os::unix::process::ExitStatusExt;
    let Some(exchange) = Exchange::find("") else { return };
    let mut kills = 0;
    for call in LATER {
        for at in exchange.before[call] + 1.. {
            let bench = Bench::human();
            let injected = format!("when=AT -e inject={call}:signal=KILL:when={at}");
            let mut child = exchange.start(&bench, &injected);
            save(&bench);
            let status = child.wait().unwrap();
            assert_kept(&bench, &format!("{call} {at}, {status}"));
            if status.signal() != Some(9) {
                break;
            }
            kills += 1;
        }
    }
    assert!(kills >= 4, "{kills}");
}

/// Where files cannot be exchanged: of a force set and its geometry both change or none.
#[test]
fn a_save_into_the_second_of_two_files_undoes_the_first_also_where_files_cannot_be_exchanged() {
    let pair = [
        ("format/standalone_ForceSet.xml", "forces.xml"),
        ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
        ("format/standalone_model_without_contacts.osim", "bones.osim"),
    ];
    for options in ["", "--no-backup"] {
        let bench = Bench::with(&pair);
        let [forces, geometry] = ["forces.xml", "geometry.xml"].map(|name| bench.read(name));
        let call = format!(
            "forces.xml --geometry geometry.xml --model bones.osim --target-mass 500 --in-place --quiet {options}"
        );
        let script = format!(
            "exec strace -f -qq -o trace -e trace=renameat2,renameat,rename -e inject=renameat2:error=EINVAL \
             -e inject=renameat,rename:delay_exit=1000000 \"$COMMAND\" {call}"
        );
        let mut child = shell_command(&bench, &["sh", "-c", &script])
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        wait("the first of the files is changed", || {
            bench.read("forces.xml") != forces || child.try_wait().unwrap().is_some()
        });
        let saved = [geometry.as_slice(), MARK.as_bytes()].concat();
        bench.write("geometry.xml", &saved);
        let output = child.wait_with_output().unwrap();
        if !bench.has("trace") {
            return skipped("saved and undone", "strace is missing or may not trace here");
        }
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(
            said.contains("another program changed") && said.contains("so nothing was written"),
            "{said}"
        );
        assert!(bench.read("forces.xml") == forces, "the first of the files is as it was: {said}");
        assert!(bench.read("geometry.xml") == saved, "{said}");
        no_temporary_files(&bench);
        assert!(!bench.files().keys().any(|name| name.contains(".replaced-")), "{:?}", bench.files().keys());
    }
}
