//! `sweep --point` and `sweep --shard`: jobs on a cluster write parts of one sweep in parallel, and a last call writes the whole table.

use std::fs::File;

use crate::model_folder::{start, wait_for_output};
use crate::support::TestDir;
use crate::sweep_resume::{
    CALL, EXIT_OF_BUSY_SWEEP, FIFTH_VARIANT, SWEEP_TABLE, assert_undisturbed, dir_with_emu,
    replace_by_heavier_model, replace_by_model_of_mass,
};

/// Runs all `parts` in parallel.
#[track_caller]
fn run_in_parallel(dir: &TestDir, parts: impl IntoIterator<Item = String>) {
    let children: Vec<_> = parts.into_iter().map(|part| start(dir, &format!("{CALL} {part}"))).collect();
    for (status, text) in children.into_iter().map(wait_for_output) {
        assert_eq!(status, Some(0), "{text}");
    }
}

fn share_options(count: usize) -> impl Iterator<Item = String> {
    (1..=count).map(move |index| format!("--shard {index}/{count}"))
}

/// Runs the call that finishes the sweep; the call must print `says`.
#[track_caller]
fn finish_sweep(dir: &TestDir, says: &str) {
    dir.run(&format!("{CALL} --resume")).succeeded().says(&[says]);
    assert_undisturbed(dir, CALL);
}

/// A folder after both shares of a sweep of six models were run, one after the other.
fn sweep_in_two_shares() -> TestDir {
    let dir = dir_with_emu();
    for share in share_options(2) {
        dir.run(&format!("{CALL} {share}")).succeeded().says(&["3 models written", "of 6"]);
    }
    dir
}

/// The rows and the header of a table.
fn rows_and_header(dir: &TestDir, table: &str) -> (Vec<String>, String) {
    let text = dir.text(table);
    let mut lines = text.lines().map(str::to_owned);
    let first = lines.next().unwrap();
    (lines.collect(), first)
}

#[test]
fn parallel_shares_and_a_last_call_make_the_whole_sweep() {
    for count in [1, 2, 4] {
        let dir = dir_with_emu();
        run_in_parallel(&dir, share_options(count));
        assert!(!dir.has(SWEEP_TABLE));
        finish_sweep(&dir, "0 models written, 6 done before");
    }
}

#[test]
fn parallel_points_and_a_last_call_make_the_whole_sweep() {
    let dir = dir_with_emu();
    run_in_parallel(&dir, (1..=6).map(|point| format!("--point {point} --jobs 1")));
    let parts: Vec<_> =
        (1..=6).map(|point| rows_and_header(&dir, &format!("out/emu_sweep.point-{point}.csv"))).collect();
    finish_sweep(&dir, "0 models written, 6 done before");
    // Each row is that of its part, with the number of its point.
    let (rows, header) = rows_and_header(&dir, SWEEP_TABLE);
    assert_eq!(parts.iter().flat_map(|(rows, _)| rows.clone()).collect::<Vec<_>>(), rows);
    assert!(parts.iter().all(|(_, first)| *first == header));
    for (index, row) in (1..).zip(&rows) {
        assert!(row.starts_with(&format!("{index},emu_{index}_stiffness-")), "{row}");
    }
}

/// Shares and single points run in parallel, so that two calls write each model.
#[test]
fn a_point_that_two_calls_write_is_complete() {
    let dir = dir_with_emu();
    for option in ["--resume", "--force"] {
        let parts = share_options(2).chain((1..=6).map(|point| format!("--point {point}")));
        run_in_parallel(&dir, parts.map(|part| format!("{part} {option}")));
    }
    finish_sweep(&dir, "0 models written, 6 done before");
}

#[test]
fn a_share_is_every_nth_point_and_may_be_empty() {
    let dir = dir_with_emu();
    dir.run(&format!("{CALL} --shard 2/4")).succeeded().wrote(&[
        "out/emu_2_stiffness-x0.5_dissipation-2.osim",
        "out/emu_6_stiffness-x2_dissipation-2.osim",
        "out/emu_sweep.shard-2-of-4.csv",
    ]);
    let (rows, _) = rows_and_header(&dir, "out/emu_sweep.shard-2-of-4.csv");
    assert!(rows[0].starts_with("2,") && rows[1].starts_with("6,"), "{rows:?}");
    dir.run(&format!("{CALL} --shard 7/8"))
        .succeeded()
        .wrote_nothing()
        .says(&["share 7/8 has none of the 6 models"]);
}

#[test]
fn a_finished_part_is_skipped() {
    let dir = sweep_in_two_shares();
    let second_run = dir.run(&format!("{CALL} --shard 1/2"));
    second_run.usage_error().wrote_nothing().says(&["4 of these files exist already", "--resume", "--force"]);
    dir.run(&format!("{CALL} --shard 1/2 --resume")).succeeded().wrote_nothing().says(&["3 done before"]);
    dir.run(&format!("{CALL} --point 3 --resume")).succeeded().says(&["done before", "point-3.csv"]);
    let whole_sweep = dir.run(CALL).usage_error().wrote_nothing();
    whole_sweep.says(&["9 of these files exist already", "--resume", "--force"]);
    dir.run(&format!("{CALL} --force")).succeeded();
    assert_undisturbed(&dir, CALL);
}

#[test]
fn parts_of_another_model_are_replaced() {
    let dir = sweep_in_two_shares();
    replace_by_heavier_model(&dir);
    finish_sweep(&dir, "6 models written; their values");
    // Also by other parts, which read the tables of these.
    let dir = sweep_in_two_shares();
    replace_by_heavier_model(&dir);
    for share in share_options(3) {
        dir.run(&format!("{CALL} {share} --resume")).succeeded().says(&["2 models written, share"]);
    }
    finish_sweep(&dir, "0 models written, 6 done before");
    // And by a part that reads the table of the whole sweep.
    replace_by_model_of_mass(&dir, 60);
    dir.run(&format!("{CALL} --point 5 --resume"))
        .succeeded()
        .wrote(&[FIFTH_VARIANT, "out/emu_sweep.point-5.csv"]);
    finish_sweep(&dir, "5 models written, 1 done before");
}

/// A run of one share was killed: some of its models exist, and the last line of its partial table is incomplete.
#[test]
fn models_of_a_killed_part_are_recognised() {
    let dir = sweep_in_two_shares();
    let part = "out/emu_sweep.shard-1-of-2.csv";
    let (rows, _) = rows_and_header(&dir, part);
    let digest_lines: Vec<String> = rows
        .iter()
        .map(|row| format!("{},{}\n", row.split(',').nth(1).unwrap(), row.rsplit(',').next().unwrap()))
        .collect();
    std::fs::remove_file(dir.path(part)).unwrap();
    dir.write(
        &format!("{part}.partial"),
        format!("file,sha256\n{}{}", digest_lines[..2].concat(), &digest_lines[2][..60]),
    );
    for call in [CALL, &format!("{CALL} --shard 1/2")] {
        dir.run(call).usage_error().wrote_nothing().says(&[
            "left by a run that was stopped",
            "--resume",
            "--force",
        ]);
    }
    replace_by_heavier_model(&dir);
    let (fifth_model, says) =
        (dir.path(FIFTH_VARIANT), ["5 of 6 models written", "not what an earlier run wrote"]);
    dir.run(&format!("{CALL} --resume")).failed().says(&says);
    // The tables of the parts stay until the sweep is finished.
    assert!(dir.has(&format!("{part}.partial")) && dir.has("out/emu_sweep.shard-2-of-2.csv"));
    std::fs::remove_file(fifth_model).unwrap();
    finish_sweep(&dir, "1 models written, 5 done before");
}

#[test]
fn the_whole_sweep_and_its_parts_refuse_to_run_at_the_same_time() {
    let dir = dir_with_emu();
    let lock_file = |name: &str| {
        dir.write(name, "");
        let file = File::options().append(true).open(dir.path(name)).unwrap();
        file.lock().unwrap();
        file
    };
    let part = lock_file("out/emu_sweep.shard-1-of-2.csv.partial");
    for option in ["", "--resume", "--force"] {
        let refused = dir.run(&format!("{CALL} {option}")).exited_with(EXIT_OF_BUSY_SWEEP).wrote_nothing();
        refused.says(&["shard-1-of-2.csv is being written by another run", "wait"]);
    }
    dir.run(&format!("{CALL} --shard 1/2 --resume"))
        .exited_with(EXIT_OF_BUSY_SWEEP)
        .wrote_nothing()
        .says(&["by another run"]);
    dir.run(&format!("{CALL} --shard 2/2 --resume")).succeeded();
    drop(part);
    let other = lock_file("out/emu_sweep.csv.partial");
    for part in ["--shard 1/2", "--point 1", "--shard 2/2 --resume"] {
        let refused = dir.run(&format!("{CALL} {part}")).exited_with(EXIT_OF_BUSY_SWEEP).wrote_nothing();
        refused.says(&["emu_sweep.csv is being written by another run", "wait"]);
    }
    drop(other);
    dir.run(&format!("{CALL} --shard 1/2 --resume")).succeeded().says(&["3 models written"]);
    finish_sweep(&dir, "0 models written, 6 done before");
}

#[test]
fn tables_that_another_program_saved_are_kept() {
    let dir = sweep_in_two_shares();
    let part = "out/emu_sweep.shard-1-of-2.csv";
    let edited_table = dir.text(part).replace(",sha256\n", ",sha256,my notes\n");
    dir.write(part, &edited_table);
    dir.write("out/emu_sweep.notes.csv", "my notes");
    dir.run(&format!("{CALL} --resume")).usage_error().wrote_nothing().says(&["cannot continue with", part]);
    dir.run(&format!("{CALL} --force")).succeeded();
    assert_eq!((dir.text(part), dir.text("out/emu_sweep.notes.csv")), (edited_table, "my notes".to_owned()));
    assert!(!dir.has("out/emu_sweep.shard-2-of-2.csv"));
}

#[test]
fn steps_of_a_ladder_are_points() {
    let call = "sweep emu.osim --ladder 3 --indentation 0.16 --restitution 0.9 -d out";
    let dir = dir_with_emu();
    dir.run(&format!("{call} --point 2"))
        .succeeded()
        .wrote(&["out/emu_ladder-2-of-3.osim", "out/emu_ladder.point-2.csv"]);
    dir.run(&format!("{call} --shard 1/2")).succeeded().says(&["2 models written, share 1/2 of 3"]);
    dir.run(&format!("{call} --resume")).succeeded().says(&["3 done before"]);
    assert_undisturbed(&dir, call);
}
