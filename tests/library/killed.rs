//! Kills runs by SIGKILL at random moments and at chosen system calls. Each output must be absent or complete, and `--resume` must
//! make the same files as an undisturbed run.

use std::collections::BTreeMap;
use std::os::unix::process::ExitStatusExt;
use std::process::Stdio;
use std::time::{Duration, Instant};

use crate::model_folder::{Files, files_below, folder_with_models, is_temporary, model_name, shell_command};
use crate::support::{TestDir, report_skip};

/// A run that is killed repeatedly.
struct Run {
    call: &'static str,
    models: usize,
    /// Whether the models are changed in place.
    in_place: bool,
    /// Calls whose results this run needs, so that they run before it.
    before: &'static [&'static str],
}

/// A delay that is longer than any run takes.
const LONGER_THAN_ANY_RUN: Duration = Duration::from_secs(600);

const RUN_INTO_FOLDER: Run = Run {
    call: "lib --target-mass 500 -d out --summary done.csv --jobs 2",
    models: 40,
    in_place: false,
    before: &[],
};
/// A batch by a table with a row and a mass for each model.
const BATCH_RUN: Run = Run {
    call: "batch masses.csv --summary notes/done.ndjson --format json --jobs 2",
    models: 40,
    in_place: false,
    before: &[],
};
const RUN_IN_PLACE: Run = Run {
    call: "lib --target-mass 500 --in-place --summary done.csv --jobs 2",
    models: 12,
    in_place: true,
    before: &[],
};

/// A sweep that writes variants of one model, and their table.
const SWEEP_RUN: Run = Run {
    call: "sweep lib/odd/model01.osim --grid stiffness=x0.1..x10/20 --grid dissipation=1,2 -d out --jobs 2",
    models: 40,
    in_place: false,
    before: &[],
};

/// The second of two shares of the sweep [`SWEEP_RUN`].
const RUN_OF_SHARE: Run = Run {
    call: "sweep lib/odd/model01.osim --grid stiffness=x0.1..x10/20 --grid dissipation=1,2 -d out --jobs 2 --shard 2/2",
    models: 20,
    ..SWEEP_RUN
};

/// The call that finishes the sweep after one of its shares.
const RUN_THAT_ENDS_SHARES: Run = Run {
    call: "sweep lib/odd/model01.osim --grid stiffness=x0.1..x10/20 --grid dissipation=1,2 -d out --jobs 2 --resume",
    before: &[RUN_OF_SHARE.call],
    ..SWEEP_RUN
};

#[test]
fn a_killed_sweep_is_resumed() {
    SWEEP_RUN.kill(15);
}

#[test]
fn a_killed_share_of_a_sweep_is_resumed() {
    RUN_OF_SHARE.kill(10);
}

#[test]
fn a_run_killed_while_shares_become_the_whole_sweep_is_resumed() {
    RUN_THAT_ENDS_SHARES.kill(10);
}

#[test]
fn a_run_killed_while_writing_into_a_folder_is_resumed() {
    RUN_INTO_FOLDER.kill(20);
}

#[test]
fn a_killed_batch_with_a_json_summary_is_resumed() {
    BATCH_RUN.kill(15);
}

#[test]
fn a_run_killed_while_changing_models_in_place_is_resumed() {
    RUN_IN_PLACE.kill(15);
}

#[test]
#[ignore = "slow, dev/thorough has it: cargo test --test library -- --ignored"]
fn a_run_killed_a_thousand_times_is_resumed() {
    RUN_INTO_FOLDER.kill(400);
    BATCH_RUN.kill(300);
    RUN_IN_PLACE.kill(300);
    SWEEP_RUN.kill(300);
    RUN_OF_SHARE.kill(100);
    RUN_THAT_ENDS_SHARES.kill(100);
}

/// System calls by which a run changes the disk, grouped by their effect.
const SYSTEM_CALLS: [(&str, &[&str]); 4] = [
    ("write", &["write", "writev"]),
    ("sync", &["fsync", "fdatasync"]),
    ("rename", &["rename", "renameat", "renameat2", "link", "linkat"]),
    ("remove", &["unlink", "unlinkat", "ftruncate"]),
];

/// strace kills the run at the start of a system call, so that every step on the disk is reached. `KILLS=2000` for more.
#[test]
#[ignore = "slow, dev/thorough has it: cargo test --test library -- --ignored"]
fn runs_killed_at_each_kind_of_system_call_are_resumed() {
    kill_at_calls(std::env::var("KILLS").map_or(300, |kills| kills.parse().unwrap()));
}

/// Kills a few runs of every kind at system calls; every test run does this.
#[test]
fn runs_killed_at_some_system_calls_are_resumed() {
    kill_at_calls(20);
}

fn kill_at_calls(wanted: usize) {
    let mut kills_by_kind: BTreeMap<&str, usize> = BTreeMap::new();
    // Only in place are old files replaced, and put on the disk first.
    for (run, share) in [
        (RUN_IN_PLACE, 3),
        (RUN_INTO_FOLDER, 1),
        (BATCH_RUN, 1),
        (SWEEP_RUN, 1),
        (RUN_OF_SHARE, 1),
        (RUN_THAT_ENDS_SHARES, 1),
    ] {
        let Some(calls_by_name) = run.system_calls() else {
            return report_skip(
                "killed at each kind of system call",
                "strace is missing or may not trace here",
            );
        };
        run.kill_at_system_calls(wanted * share / 5, &calls_by_name, &mut kills_by_kind);
    }
    eprintln!(
        "kills by what was about to be done: {kills_by_kind:?}, {} in all",
        kills_by_kind.values().sum::<usize>()
    );
    for kind in ["write", "sync", "rename"] {
        assert!(kills_by_kind[kind] >= 50.min(wanted / 6), "{kills_by_kind:?}");
    }
}

/// A shell command that runs the call under strace with these options.
fn strace_command(strace_options: &str, call: &str) -> String {
    format!("exec strace -f -qq -o trace {strace_options} \"$COMMAND\" {call}")
}

impl Run {
    /// Numbers of system calls of each kind that a thread of an undisturbed run makes; `None` if strace does not work.
    fn system_calls(&self) -> Option<BTreeMap<(&'static str, &'static str), usize>> {
        let dir = self.prepare();
        let all: Vec<&str> = SYSTEM_CALLS.iter().flat_map(|(_, calls)| *calls).copied().collect();
        let script = strace_command(&format!("-e trace={}", all.join(",")), self.call);
        let output = shell_command(&dir, &["sh", "-c", &script]).output().unwrap();
        if !output.status.success() {
            return None;
        }
        let trace = dir.text("trace");
        let mut most_by_call = BTreeMap::new();
        for (kind, calls) in SYSTEM_CALLS {
            for call in calls {
                let mut by_thread: BTreeMap<&str, usize> = BTreeMap::new();
                for line in trace.lines() {
                    let (thread, rest) = line.split_once(' ').unwrap();
                    if rest.trim_start().starts_with(&format!("{call}(")) {
                        *by_thread.entry(thread).or_default() += 1;
                    }
                }
                most_by_call.extend(by_thread.into_values().max().map(|count| ((kind, *call), count)));
            }
        }
        Some(most_by_call)
    }

    /// The call of this run, continued with `--resume`.
    fn resuming_call(&self) -> String {
        if self.call.ends_with(" --resume") {
            self.call.to_owned()
        } else {
            format!("{} --resume", self.call)
        }
    }

    /// Kills runs at the n-th use of a system call, until `wanted` runs were killed.
    fn kill_at_system_calls(
        &self,
        wanted: usize,
        calls_by_name: &BTreeMap<(&'static str, &'static str), usize>,
        kills_by_kind: &mut BTreeMap<&'static str, usize>,
    ) {
        let (undisturbed, _) = self.undisturbed();
        let mut random = RandomNumbers::new();
        eprintln!("seed {}, system calls of a thread: {calls_by_name:?}", random.seed);
        let mut kills = 0;
        while kills < wanted {
            let dir = self.prepare();
            let before = dir.files();
            let mut call = self.call.to_owned();
            loop {
                // The kind with the fewest kills so far; removals are few and matter least.
                let rank =
                    |kind: &str| kills_by_kind.get(kind).unwrap_or(&0) * if kind == "remove" { 8 } else { 1 };
                let least =
                    calls_by_name.keys().map(|(kind, _)| *kind).min_by_key(|kind| rank(kind)).unwrap();
                let places: Vec<_> = calls_by_name.iter().filter(|((kind, _), _)| *kind == least).collect();
                let (&(kind, name), &largest) = places[random.index_below(places.len())];
                let strace_options = format!(
                    "-e trace={name} -e inject={name}:signal=KILL:when={}",
                    1 + random.index_below(largest)
                );
                let output = shell_command(&dir, &["sh", "-c", &strace_command(&strace_options, &call)])
                    .output()
                    .unwrap();
                std::fs::remove_file(dir.path("trace")).unwrap();
                if output.status.signal() != Some(9) {
                    assert!(output.status.success(), "{call}: {}", String::from_utf8_lossy(&output.stderr));
                    break;
                }
                kills += 1;
                *kills_by_kind.entry(kind).or_default() += 1;
                self.check_files(&before, &dir.files(), &undisturbed);
                call = self.resuming_call();
            }
            assert_same_files(&dir.files(), &undisturbed);
        }
    }

    /// Kills runs until `wanted` runs were killed. Each run resumes the killed run before it.
    fn kill(&self, wanted: usize) {
        let (undisturbed, mut duration) = self.undisturbed();
        let mut random = RandomNumbers::new();
        eprintln!("seed {}, an undisturbed run takes {duration:?}", random.seed);
        let (mut kills, mut in_the_middle) = (0, 0);
        // On a busy machine a run may take much longer than the timed one: kills come later if nothing was written before them,
        // and sooner if runs end before them, until enough kills hit a run in the middle.
        while kills < wanted || (in_the_middle * 4 <= kills && kills < 20 * wanted) {
            let dir = self.prepare();
            let before = dir.files();
            let mut call = self.call.to_owned();
            // After so many kills the run may end, however slow the machine is now.
            let mut remaining_kills = 20.min(wanted);
            loop {
                if !self.is_killed(
                    &dir,
                    &call,
                    if remaining_kills > 0 { random.random_duration(duration) } else { LONGER_THAN_ANY_RUN },
                ) {
                    duration = duration * 4 / 5;
                    break;
                }
                kills += 1;
                remaining_kills -= 1;
                let after = dir.files();
                let done = self.check_files(&before, &after, &undisturbed);
                in_the_middle += usize::from(0 < done && done < self.models);
                if done == 0 {
                    duration = duration * 5 / 4;
                }
                call = self.resuming_call();
            }
            // After the last run the files are those of an undisturbed run.
            assert_same_files(&dir.files(), &undisturbed);
        }
        eprintln!("{kills} kills, {in_the_middle} of them in the middle");
        assert!(in_the_middle * 4 > kills, "only {in_the_middle} of {kills} kills hit a run in the middle");
    }

    fn prepare(&self) -> TestDir {
        let dir = folder_with_models(self.models);
        let row = |number| format!("lib/{0},{1},out/{0}\n", model_name(number), 200 + number);
        let rows: String = (0..self.models).map(row).collect();
        dir.write("masses.csv", format!("model,target-mass,output\n{rows}"));
        std::fs::create_dir(dir.path("notes")).unwrap();
        for call in self.before {
            assert!(
                dir.command(call).stdout(Stdio::null()).stderr(Stdio::null()).status().unwrap().success()
            );
        }
        dir
    }

    /// All files after an undisturbed run, and the duration of the run.
    fn undisturbed(&self) -> (Files, Duration) {
        let mut runs: Vec<(Duration, Files)> = (0..3)
            .map(|_| {
                let dir = self.prepare();
                let begin = Instant::now();
                assert!(!self.is_killed(&dir, self.call, LONGER_THAN_ANY_RUN));
                (begin.elapsed(), dir.files())
            })
            .collect();
        runs.sort_by_key(|(duration, _)| *duration);
        assert_same_files(&runs[0].1, &runs[1].1);
        let (duration, files) = runs.swap_remove(1);
        let backups = files.keys().filter(|name| name.ends_with(".bak")).count();
        let done = if self.in_place { backups } else { count_outputs(&files) };
        assert_eq!(done, self.models, "{:?}", files.keys());
        (files, duration)
    }

    /// Starts the run and kills it after `delay`. Returns whether it was killed; otherwise the run must have succeeded.
    fn is_killed(&self, dir: &TestDir, call: &str, delay: Duration) -> bool {
        let mut child = dir.command(call).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
        let end = Instant::now() + delay;
        while Instant::now() < end {
            if child.try_wait().unwrap().is_some() {
                break;
            }
            std::thread::sleep(Duration::from_micros(200).min(end.saturating_duration_since(Instant::now())));
        }
        child.kill().unwrap();
        let output = child.wait_with_output().unwrap();
        if output.status.signal() == Some(9) {
            return true;
        }
        assert!(output.status.success(), "{call}: {}", String::from_utf8_lossy(&output.stderr));
        false
    }

    /// Asserts that no file is incomplete or lost; returns the number of models that the run has changed.
    fn check_files(&self, before: &Files, after: &Files, undisturbed: &Files) -> usize {
        for (name, bytes) in after {
            let is_new = !before.contains_key(name);
            if let Some((model, _)) = name.split_once(".replaced-") {
                let is_complete = [before.get(model), undisturbed.get(model)].contains(&Some(bytes));
                assert!(is_complete, "{name} is torn");
            }
            if is_new && (is_temporary(name) || name.ends_with(".partial")) {
                continue;
            }
            let is_complete = undisturbed.get(name) == Some(bytes);
            // After an earlier run, an input is unchanged or, in place, has its new bytes.
            let untouched = before.get(name) == Some(bytes);
            assert!(
                if is_new { is_complete } else { untouched || (self.in_place && is_complete) },
                "{name} is torn"
            );
        }
        for name in before.keys().filter(|name| !after.contains_key(*name)) {
            // The table of a part goes when the whole is there, which the loop above compared.
            let is_part = name.contains(".shard-") && !undisturbed.contains_key(name);
            assert!(is_part && after.contains_key("out/model01_sweep.csv"), "{name} is gone");
        }
        if !self.in_place {
            return count_outputs(after);
        }
        let changed = before.iter().filter(|(name, bytes)| after.get(*name) != Some(bytes));
        changed
            .inspect(|(name, bytes)| assert_eq!(after.get(&format!("{name}.bak")), Some(*bytes), "{name}"))
            .count()
    }
}

/// The number of models in the output folder.
fn count_outputs(files: &Files) -> usize {
    files_below(files, "out/").keys().filter(|name| name.ends_with(".osim") && !is_temporary(name)).count()
}

/// Asserts that both sets of files are equal. Compares names first, so that the message is short.
#[track_caller]
fn assert_same_files(files: &Files, undisturbed: &Files) {
    assert_eq!(files.keys().collect::<Vec<_>>(), undisturbed.keys().collect::<Vec<_>>());
    for (name, bytes) in files {
        assert!(undisturbed.get(name) == Some(bytes), "{name} differs from that of an undisturbed run");
    }
}

/// Random numbers from a seed (SplitMix64): `KILL_SEED` from a failed run repeats its moments.
struct RandomNumbers {
    seed: u64,
    state: u64,
}

impl RandomNumbers {
    fn new() -> Self {
        let now = || std::time::UNIX_EPOCH.elapsed().unwrap().as_nanos() as u64;
        let seed = std::env::var("KILL_SEED").map_or_else(|_| now(), |seed| seed.parse().unwrap());
        Self { seed, state: seed }
    }

    fn random_duration(&mut self, duration: Duration) -> Duration {
        duration.mul_f64(self.next_u64() as f64 / u64::MAX as f64)
    }

    /// A random number below `end`.
    fn index_below(&mut self, end: usize) -> usize {
        usize::try_from(self.next_u64() % end as u64).unwrap()
    }

    fn next_u64(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
}
