//! Two runs that write the same files at the same time: each ends with 0 if its work is complete, or says why not, and all files are
//! complete.

use crate::model_folder::{
    assert_no_temporary_files, files_below, folder_with_models, start, wait_for_output,
};
use crate::support::TestDir;
use crate::sweep_resume::{CALL, EXIT_OF_BUSY_SWEEP, assert_undisturbed, dir_with_emu};

const PAIRS_OF_RUNS: usize = 25;
const RESCALE_CALL: &str = "lib --target-mass 500 -d out --quiet";

/// The exit status and the messages of two runs of `call` that are started together.
fn run_twice_at_once(dir: &TestDir, call: &str) -> [(Option<i32>, String); 2] {
    [start(dir, call), start(dir, call)].map(wait_for_output)
}

/// Runs `call` twice at once in many folders from `new_dir`. A run that does not end with 0 has an exit status and its message in `why_not`.
/// Returns the number of such runs.
#[track_caller]
fn race(
    new_dir: impl Fn() -> TestDir,
    call: &str,
    why_not: &[(i32, &str)],
    check: impl Fn(&TestDir),
) -> usize {
    let mut refused = 0;
    for round in 0..PAIRS_OF_RUNS {
        let dir = new_dir();
        let ends = run_twice_at_once(&dir, call);
        for (status, text) in &ends {
            let is_explained =
                why_not.iter().any(|(expected, says)| *status == Some(*expected) && text.contains(says));
            assert!(*status == Some(0) || is_explained, "{call}, round {round}: {status:?}: {text}");
            refused += usize::from(*status != Some(0));
        }
        assert_no_temporary_files(&dir);
        check(&dir);
    }
    refused
}

#[track_caller]
fn assert_all_rescaled(dir: &TestDir) {
    let undisturbed = folder_with_models(4);
    undisturbed.run(RESCALE_CALL).succeeded();
    assert!(files_below(&dir.files(), "out/") == files_below(&undisturbed.files(), "out/"));
}

#[test]
fn two_runs_that_may_replace_files_both_succeed() {
    race(|| folder_with_models(4), &format!("{RESCALE_CALL} --force"), &[], assert_all_rescaled);
}

#[test]
fn two_runs_that_may_not_replace_files_both_succeed() {
    // The second run is refused only if the first one has ended before the second one begins, as on a busy machine.
    let refused = race(
        || folder_with_models(4),
        RESCALE_CALL,
        &[(1, "exists already"), (2, "results exist already")],
        assert_all_rescaled,
    );
    assert!(refused < PAIRS_OF_RUNS / 2, "{refused} of {PAIRS_OF_RUNS}");
}

#[test]
fn two_resumed_runs_with_one_summary_succeed_or_one_is_busy() {
    let call = format!("{RESCALE_CALL} --summary done.csv --resume");
    race(
        || folder_with_models(4),
        &call,
        &[(EXIT_OF_BUSY_SWEEP, "being written by another run")],
        |dir| {
            assert_all_rescaled(dir);
            assert!(dir.has("done.csv") && !dir.has("done.csv.partial"));
            dir.run(&call).succeeded();
        },
    );
}

#[test]
fn two_resumed_sweeps_succeed_or_one_is_busy() {
    let call = format!("{CALL} --resume");
    let busy = [(EXIT_OF_BUSY_SWEEP, "being written by another run")];
    race(dir_with_emu, &call, &busy, |dir| assert_undisturbed(dir, CALL));
}
