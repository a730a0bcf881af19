//! SIGKILL at random moments, and at chosen system calls: outputs are absent or complete, and `--resume` makes the result of an
//! undisturbed run.

use std::collections::BTreeMap;
use std::os::unix::process::ExitStatusExt;
use std::process::Stdio;
use std::time::{Duration, Instant};

use crate::library::{Files, below, is_temporary, library, name, shell_command};
use crate::support::{Bench, skipped};

/// A run that is killed again and again.
struct Run {
    call: &'static str,
    models: usize,
    /// Its models are changed themselves.
    in_place: bool,
    /// What ran before.
    before: &'static [&'static str],
}

/// Longer than any run takes.
const CALM: Duration = Duration::from_secs(600);

const INTO_FOLDER: Run = Run {
    call: "lib --target-mass 500 -d out --summary done.csv --jobs 2",
    models: 40,
    in_place: false,
    before: &[],
};
/// A row for each model, each with a mass of its own.
const BATCH: Run = Run {
    call: "batch masses.csv --summary notes/done.ndjson --format json --jobs 2",
    models: 40,
    in_place: false,
    before: &[],
};
const IN_PLACE: Run = Run {
    call: "lib --target-mass 500 --in-place --summary done.csv --jobs 2",
    models: 12,
    in_place: true,
    before: &[],
};

/// Variants of one model, and the table of them.
const SWEEP: Run = Run {
    call: "sweep lib/odd/model01.osim --grid stiffness=x0.1..x10/20 --grid dissipation=1,2 -d out --jobs 2",
    models: 40,
    in_place: false,
    before: &[],
};

/// A part of the same.
const SHARE: Run = Run {
    call: "sweep lib/odd/model01.osim --grid stiffness=x0.1..x10/20 --grid dissipation=1,2 -d out --jobs 2 --shard 2/2",
    models: 20,
    ..SWEEP
};

/// The whole of which a part is done.
const END_OF_SHARES: Run = Run {
    call: "sweep lib/odd/model01.osim --grid stiffness=x0.1..x10/20 --grid dissipation=1,2 -d out --jobs 2 --resume",
    before: &[SHARE.call],
    ..SWEEP
};

#[test]
fn killed_in_a_sweep() {
    SWEEP.kill(15);
}

#[test]
fn killed_in_a_share_of_a_sweep() {
    SHARE.kill(10);
}

#[test]
fn killed_where_shares_of_a_sweep_become_the_whole() {
    END_OF_SHARES.kill(10);
}

#[test]
fn killed_while_writing_into_a_folder() {
    INTO_FOLDER.kill(20);
}

#[test]
fn killed_in_a_batch_with_a_summary_of_json_lines() {
    BATCH.kill(15);
}

#[test]
fn killed_while_changing_models_in_place() {
    IN_PLACE.kill(15);
}

#[test]
#[ignore = "slow, dev/thorough has it: cargo test --test library -- --ignored"]
fn killed_a_thousand_times() {
    INTO_FOLDER.kill(400);
    BATCH.kill(300);
    IN_PLACE.kill(300);
    SWEEP.kill(300);
    SHARE.kill(100);
    END_OF_SHARES.kill(100);
}

/// System calls by which a run changes the disk, by what they do.
const CALLS: [(&str, &[&str]); 4] = [
    ("write", &["write", "writev"]),
    ("sync", &["fsync", "fdatasync"]),
    ("rename", &["rename", "renameat", "renameat2", "link", "linkat"]),
    ("remove", &["unlink", "unlinkat", "ftruncate"]),
];

/// strace kills the run where a system call begins: nothing that is between two calls is left out. `KILLS=2000` for more.
#[test]
#[ignore = "slow, dev/thorough has it: cargo test --test library -- --ignored"]
fn killed_at_each_kind_of_system_call() {
    kill_at_calls(std::env::var("KILLS").map_or(300, |kills| kills.parse().unwrap()));
}

/// A few of them after every change.
#[test]
fn killed_at_some_system_calls() {
    kill_at_calls(20);
}

fn kill_at_calls(wanted: usize) {
    let mut hit: BTreeMap<&str, usize> = BTreeMap::new();
    // Only in place are old files replaced, and put on the disk first.
    for (run, share) in
        [(IN_PLACE, 3), (INTO_FOLDER, 1), (BATCH, 1), (SWEEP, 1), (SHARE, 1), (END_OF_SHARES, 1)]
    {
        let Some(counted) = run.calls() else {
            return skipped("killed at each kind of system call", "strace is missing or may not trace here");
        };
        run.kill_at(wanted * share / 5, &counted, &mut hit);
    }
    eprintln!("kills by what was about to be done: {hit:?}, {} in all", hit.values().sum::<usize>());
    for kind in ["write", "sync", "rename"] {
        assert!(hit[kind] >= 50.min(wanted / 6), "{hit:?}");
    }
}

/// Words that run the command under strace, which does `how`.
fn straced(how: &str, call: &str) -> String {
    format!("exec strace -f -qq -o trace {how} \"$COMMAND\" {call}")
}

impl Run {
    /// How often a thread of an undisturbed run makes each system call that changes the disk; `None` where nothing can be traced.
    fn calls(&self) -> Option<BTreeMap<(&'static str, &'static str), usize>> {
        let bench = self.bench();
        let all: Vec<&str> = CALLS.iter().flat_map(|(_, calls)| *calls).copied().collect();
        let script = straced(&format!("-e trace={}", all.join(",")), self.call);
        let output = shell_command(&bench, &["sh", "-c", &script]).output().unwrap();
        if !output.status.success() {
            return None;
        }
        let trace = bench.text("trace");
        let mut most = BTreeMap::new();
        for (kind, calls) in CALLS {
            for call in calls {
                let mut by_thread: BTreeMap<&str, usize> = BTreeMap::new();
                for line in trace.lines() {
                    let (thread, rest) = line.split_once(' ').unwrap();
                    if rest.trim_start().starts_with(&format!("{call}(")) {
                        *by_thread.entry(thread).or_default() += 1;
                    }
                }
                most.extend(by_thread.into_values().max().map(|most| ((kind, *call), most)));
            }
        }
        Some(most)
    }

    /// The call that goes on.
    fn again(&self) -> String {
        if self.call.ends_with(" --resume") {
            self.call.to_owned()
        } else {
            format!("{} --resume", self.call)
        }
    }

    /// Kills runs where they make a system call for the n-th time, until `wanted` were hit.
    fn kill_at(
        &self,
        wanted: usize,
        counted: &BTreeMap<(&'static str, &'static str), usize>,
        hit: &mut BTreeMap<&'static str, usize>,
    ) {
        let (calm, _) = self.undisturbed();
        let mut dice = Dice::new();
        eprintln!("seed {}, system calls of a thread: {counted:?}", dice.seed);
        let mut kills = 0;
        while kills < wanted {
            let bench = self.bench();
            let before = bench.files();
            let mut call = self.call.to_owned();
            loop {
                // The kind that was hit least so far; of removals there are few, and they matter least.
                let rank = |kind: &str| hit.get(kind).unwrap_or(&0) * if kind == "remove" { 8 } else { 1 };
                let least = counted.keys().map(|(kind, _)| *kind).min_by_key(|kind| rank(kind)).unwrap();
                let places: Vec<_> = counted.iter().filter(|((kind, _), _)| *kind == least).collect();
                let (&(kind, name), &most) = places[dice.below(places.len())];
                let how =
                    format!("-e trace={name} -e inject={name}:signal=KILL:when={}", 1 + dice.below(most));
                let output = shell_command(&bench, &["sh", "-c", &straced(&how, &call)]).output().unwrap();
                std::fs::remove_file(bench.path("trace")).unwrap();
                if output.status.signal() != Some(9) {
                    assert!(output.status.success(), "{call}: {}", String::from_utf8_lossy(&output.stderr));
                    break;
                }
                kills += 1;
                *hit.entry(kind).or_default() += 1;
                self.check(&before, &bench.files(), &calm);
                call = self.again();
            }
            assert_same(&bench.files(), &calm);
        }
    }

    /// Kills runs until `wanted` were hit, each going on where the one before was killed.
    fn kill(&self, wanted: usize) {
        let (calm, mut duration) = self.undisturbed();
        let mut dice = Dice::new();
        eprintln!("seed {}, an undisturbed run takes {duration:?}", dice.seed);
        let (mut kills, mut in_the_middle) = (0, 0);
        // Beside other work a run may need much longer than the one that was timed: kills come later where they come before anything
        // was written, and sooner where runs end before them, until enough of them hit.
        while kills < wanted || (in_the_middle * 4 <= kills && kills < 20 * wanted) {
            let bench = self.bench();
            let before = bench.files();
            let mut call = self.call.to_owned();
            // Then it may end, however slow the machine has become since an undisturbed run was timed.
            let mut most = 20.min(wanted);
            loop {
                if !self.is_killed(&bench, &call, if most > 0 { dice.up_to(duration) } else { CALM }) {
                    duration = duration * 4 / 5;
                    break;
                }
                kills += 1;
                most -= 1;
                let after = bench.files();
                let done = self.check(&before, &after, &calm);
                in_the_middle += usize::from(0 < done && done < self.models);
                if done == 0 {
                    duration = duration * 5 / 4;
                }
                call = self.again();
            }
            // The last one came to its end: all is as if nothing had happened.
            assert_same(&bench.files(), &calm);
        }
        eprintln!("{kills} kills, {in_the_middle} of them in the middle");
        assert!(in_the_middle * 4 > kills, "only {in_the_middle} of {kills} kills hit a run in the middle");
    }

    fn bench(&self) -> Bench {
        let bench = library(self.models);
        let row = |number| format!("lib/{0},{1},out/{0}\n", name(number), 200 + number);
        let rows: String = (0..self.models).map(row).collect();
        bench.write("masses.csv", format!("model,target-mass,output\n{rows}"));
        for call in self.before {
            assert!(
                bench.command(call).stdout(Stdio::null()).stderr(Stdio::null()).status().unwrap().success()
            );
        }
        bench
    }

    /// All files after an undisturbed run, and how long it takes.
    fn undisturbed(&self) -> (Files, Duration) {
        let mut runs: Vec<(Duration, Files)> = (0..3)
            .map(|_| {
                let bench = self.bench();
                let begin = Instant::now();
                assert!(!self.is_killed(&bench, self.call, CALM));
                (begin.elapsed(), bench.files())
            })
            .collect();
        runs.sort_by_key(|(duration, _)| *duration);
        assert_same(&runs[0].1, &runs[1].1);
        let (duration, files) = runs.swap_remove(1);
        let backups = files.keys().filter(|name| name.ends_with(".bak")).count();
        let done = if self.in_place { backups } else { outputs(&files) };
        assert_eq!(done, self.models, "{:?}", files.keys());
        (files, duration)
    }

    /// Whether the run had to be killed after `delay`; else it must have done all.
    fn is_killed(&self, bench: &Bench, call: &str, delay: Duration) -> bool {
        let mut child = bench.command(call).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
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

    /// Nothing is torn or lost; how many models are done.
    fn check(&self, before: &Files, after: &Files, calm: &Files) -> usize {
        for (name, bytes) in after {
            let is_new = !before.contains_key(name);
            if let Some((model, _)) = name.split_once(".replaced-") {
                let whole = [before.get(model), calm.get(model)].contains(&Some(bytes));
                assert!(whole, "{name} is torn");
            }
            if is_new && (is_temporary(name) || name.ends_with(".partial")) {
                continue;
            }
            let whole = calm.get(name) == Some(bytes);
            // Another run may have ended before: an input is as it was, or, in place, what it is to become.
            let untouched = before.get(name) == Some(bytes);
            assert!(if is_new { whole } else { untouched || (self.in_place && whole) }, "{name} is torn");
        }
        for name in before.keys().filter(|name| !after.contains_key(*name)) {
            // The table of a part goes when the whole is there, which the loop above compared.
            let is_part = name.contains(".shard-") && !calm.contains_key(name);
            assert!(is_part && after.contains_key("out/model01_sweep.csv"), "{name} is gone");
        }
        if !self.in_place {
            return outputs(after);
        }
        let changed = before.iter().filter(|(name, bytes)| after.get(*name) != Some(bytes));
        changed
            .inspect(|(name, bytes)| assert_eq!(after.get(&format!("{name}.bak")), Some(*bytes), "{name}"))
            .count()
    }
}

/// How many models are in the folder of the outputs.
fn outputs(files: &Files) -> usize {
    below(files, "out/").keys().filter(|name| name.ends_with(".osim") && !is_temporary(name)).count()
}

/// Compares the names first: what differs is told shortly.
#[track_caller]
fn assert_same(files: &Files, calm: &Files) {
    assert_eq!(files.keys().collect::<Vec<_>>(), calm.keys().collect::<Vec<_>>());
    for (name, bytes) in files {
        assert!(calm.get(name) == Some(bytes), "{name} differs from that of an undisturbed run");
    }
}

/// Random numbers that a seed repeats (SplitMix64): `KILL_SEED` from a failed run rolls the same moments again.
struct Dice {
    seed: u64,
    state: u64,
}

impl Dice {
    fn new() -> Self {
        let now = || std::time::UNIX_EPOCH.elapsed().unwrap().as_nanos() as u64;
        let seed = std::env::var("KILL_SEED").map_or_else(|_| now(), |seed| seed.parse().unwrap());
        Self { seed, state: seed }
    }

    fn up_to(&mut self, duration: Duration) -> Duration {
        duration.mul_f64(self.roll() as f64 / u64::MAX as f64)
    }

    /// One of the numbers below `end`.
    fn below(&mut self, end: usize) -> usize {
        usize::try_from(self.roll() % end as u64).unwrap()
    }

    fn roll(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
}
