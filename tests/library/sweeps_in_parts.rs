//! `sweep --point` and `sweep --shard`: jobs of a cluster make parts of one sweep at the same time, and a last call the whole table.

use std::fs::File;

use crate::library::{ended, start};
use crate::support::Bench;
use crate::sweeps::{BUSY, CALL, ONE, TABLE, another_model, emu, is_calm, of_mass};

/// Runs all `parts` at the same time.
#[track_caller]
fn together(bench: &Bench, parts: impl IntoIterator<Item = String>) {
    let children: Vec<_> = parts.into_iter().map(|part| start(bench, &format!("{CALL} {part}"))).collect();
    for (status, text) in children.into_iter().map(ended) {
        assert_eq!(status, Some(0), "{text}");
    }
}

fn shares(count: usize) -> impl Iterator<Item = String> {
    (1..=count).map(move |index| format!("--shard {index}/{count}"))
}

/// The call that ends the sweep: it says what it did.
#[track_caller]
fn whole(bench: &Bench, says: &str) {
    bench.run(&format!("{CALL} --resume")).done().says(&[says]);
    is_calm(bench, CALL);
}

/// Two shares of the six models, one after the other.
fn halves() -> Bench {
    let bench = emu();
    for share in shares(2) {
        bench.run(&format!("{CALL} {share}")).done().says(&["3 models written", "of 6"]);
    }
    bench
}

/// Lines of a table but the first, and the first.
fn lines(bench: &Bench, table: &str) -> (Vec<String>, String) {
    let text = bench.text(table);
    let mut lines = text.lines().map(str::to_owned);
    let first = lines.next().unwrap();
    (lines.collect(), first)
}

#[test]
fn shares_at_the_same_time_and_a_last_call_are_one_whole_sweep() {
    for count in [1, 2, 4] {
        let bench = emu();
        together(&bench, shares(count));
        assert!(!bench.has(TABLE));
        whole(&bench, "0 models written, 6 done before");
    }
}

#[test]
fn points_at_the_same_time_and_a_last_call_are_one_whole_sweep() {
    let bench = emu();
    together(&bench, (1..=6).map(|point| format!("--point {point} --jobs 1")));
    let parts: Vec<_> =
        (1..=6).map(|point| lines(&bench, &format!("out/emu_sweep.point-{point}.csv"))).collect();
    whole(&bench, "0 models written, 6 done before");
    // The same number and the same row, whichever call made it.
    let (rows, header) = lines(&bench, TABLE);
    assert_eq!(parts.iter().flat_map(|(rows, _)| rows.clone()).collect::<Vec<_>>(), rows);
    assert!(parts.iter().all(|(_, first)| *first == header));
    for (index, row) in (1..).zip(&rows) {
        assert!(row.starts_with(&format!("{index},emu_{index}_stiffness-")), "{row}");
    }
}

/// The same points by shares and one by one, all at once: each is made by two calls.
#[test]
fn a_point_that_two_calls_make_is_whole() {
    let bench = emu();
    for how in ["--resume", "--force"] {
        let parts = shares(2).chain((1..=6).map(|point| format!("--point {point}")));
        together(&bench, parts.map(|part| format!("{part} {how}")));
    }
    whole(&bench, "0 models written, 6 done before");
}

#[test]
fn a_share_is_every_nth_point_and_may_be_empty() {
    let bench = emu();
    bench.run(&format!("{CALL} --shard 2/4")).done().wrote(&[
        "out/emu_2_stiffness-x0.5_dissipation-2.osim",
        "out/emu_6_stiffness-x2_dissipation-2.osim",
        "out/emu_sweep.shard-2-of-4.csv",
    ]);
    let (rows, _) = lines(&bench, "out/emu_sweep.shard-2-of-4.csv");
    assert!(rows[0].starts_with("2,") && rows[1].starts_with("6,"), "{rows:?}");
    bench
        .run(&format!("{CALL} --shard 7/8"))
        .done()
        .wrote_nothing()
        .says(&["share 7/8 has none of the 6 models"]);
}

#[test]
fn a_part_is_not_made_again() {
    let bench = halves();
    let again = bench.run(&format!("{CALL} --shard 1/2"));
    again.usage().wrote_nothing().says(&["4 of these files exist already", "--resume", "--force"]);
    bench.run(&format!("{CALL} --shard 1/2 --resume")).done().wrote_nothing().says(&["3 done before"]);
    bench.run(&format!("{CALL} --point 3 --resume")).done().says(&["done before", "point-3.csv"]);
    let made = bench.run(CALL).usage().wrote_nothing();
    made.says(&["9 of these files exist already", "--resume", "--force"]);
    bench.run(&format!("{CALL} --force")).done();
    is_calm(&bench, CALL);
}

#[test]
fn what_parts_made_of_another_model_is_replaced() {
    let bench = halves();
    another_model(&bench);
    whole(&bench, "6 models written; what");
    // In other parts, too, which know it from the tables of these.
    let bench = halves();
    another_model(&bench);
    for share in shares(3) {
        bench.run(&format!("{CALL} {share} --resume")).done().says(&["2 models written, share"]);
    }
    whole(&bench, "0 models written, 6 done before");
    // And from the table of the whole.
    of_mass(&bench, 60);
    bench.run(&format!("{CALL} --point 5 --resume")).done().wrote(&[ONE, "out/emu_sweep.point-5.csv"]);
    whole(&bench, "5 models written, 1 done before");
}

/// A share that was killed left some models and a part of a line.
#[test]
fn what_a_killed_part_left_is_known() {
    let bench = halves();
    let part = "out/emu_sweep.shard-1-of-2.csv";
    let (rows, _) = lines(&bench, part);
    let made: Vec<String> = rows
        .iter()
        .map(|row| format!("{},{}\n", row.split(',').nth(1).unwrap(), row.rsplit(',').next().unwrap()))
        .collect();
    std::fs::remove_file(bench.path(part)).unwrap();
    bench.write(&format!("{part}.partial"), format!("file,sha256\n{}{}", made[..2].concat(), &made[2][..60]));
    for call in [CALL, &format!("{CALL} --shard 1/2")] {
        bench.run(call).usage().wrote_nothing().says(&[
            "left by a run that was stopped",
            "--resume",
            "--force",
        ]);
    }
    another_model(&bench);
    let (left, says) = (bench.path(ONE), ["5 of 6 models written", "not what an earlier run wrote"]);
    bench.run(&format!("{CALL} --resume")).failed().says(&says);
    // Something is left to do: what parts say stays until it is done.
    assert!(bench.has(&format!("{part}.partial")) && bench.has("out/emu_sweep.shard-2-of-2.csv"));
    std::fs::remove_file(left).unwrap();
    whole(&bench, "1 models written, 5 done before");
}

#[test]
fn the_whole_waits_for_its_parts_and_they_for_it() {
    let bench = emu();
    let taken = |name: &str| {
        bench.write(name, "");
        let file = File::options().append(true).open(bench.path(name)).unwrap();
        file.lock().unwrap();
        file
    };
    let part = taken("out/emu_sweep.shard-1-of-2.csv.partial");
    for how in ["", "--resume", "--force"] {
        let refused = bench.run(&format!("{CALL} {how}")).ends_with(BUSY).wrote_nothing();
        refused.says(&["shard-1-of-2.csv is being written by another run", "wait"]);
    }
    bench
        .run(&format!("{CALL} --shard 1/2 --resume"))
        .ends_with(BUSY)
        .wrote_nothing()
        .says(&["by another run"]);
    bench.run(&format!("{CALL} --shard 2/2 --resume")).done();
    drop(part);
    let other = taken("out/emu_sweep.csv.partial");
    for part in ["--shard 1/2", "--point 1", "--shard 2/2 --resume"] {
        let refused = bench.run(&format!("{CALL} {part}")).ends_with(BUSY).wrote_nothing();
        refused.says(&["emu_sweep.csv is being written by another run", "wait"]);
    }
    drop(other);
    bench.run(&format!("{CALL} --shard 1/2 --resume")).done().says(&["3 models written"]);
    whole(&bench, "0 models written, 6 done before");
}

#[test]
fn tables_that_another_program_saved_are_not_ours() {
    let bench = halves();
    let part = "out/emu_sweep.shard-1-of-2.csv";
    let mine = bench.text(part).replace(",sha256\n", ",sha256,my notes\n");
    bench.write(part, &mine);
    bench.write("out/emu_sweep.notes.csv", "my notes");
    bench.run(&format!("{CALL} --resume")).usage().wrote_nothing().says(&["cannot go on with", part]);
    bench.run(&format!("{CALL} --force")).done();
    assert_eq!((bench.text(part), bench.text("out/emu_sweep.notes.csv")), (mine, "my notes".to_owned()));
    assert!(!bench.has("out/emu_sweep.shard-2-of-2.csv"));
}

#[test]
fn steps_of_a_ladder_are_points() {
    let call = "sweep emu.osim --ladder 3 --indentation 0.16 --restitution 0.9 -d out";
    let bench = emu();
    bench
        .run(&format!("{call} --point 2"))
        .done()
        .wrote(&["out/emu_ladder-2-of-3.osim", "out/emu_ladder.point-2.csv"]);
    bench.run(&format!("{call} --shard 1/2")).done().says(&["2 models written, share 1/2 of 3"]);
    bench.run(&format!("{call} --resume")).done().says(&["3 done before"]);
    is_calm(&bench, call);
}
