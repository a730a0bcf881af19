//! `sweep --resume`: what is there stays, what is missing is made, what somebody edited is left alone.

use std::time::{Duration, Instant};

use crate::library::{ended, start};
use crate::support::{Bench, Ran};

const MODEL: &str = "table1/emu_10_spheres_smooth_sphere.osim";
pub(crate) const CALL: &str = "sweep emu.osim --grid stiffness=x0.5,x1,x2 --grid dissipation=1,2 -d out";
/// The exit status where another run has a file.
pub(crate) const BUSY: i32 = 3;
pub(crate) const TABLE: &str = "out/emu_sweep.csv";
const PARTIAL: &str = "out/emu_sweep.csv.partial";
pub(crate) const ONE: &str = "out/emu_5_stiffness-x2_dissipation-1.osim";

fn resume(bench: &Bench) -> Ran {
    bench.run(&format!("{CALL} --resume"))
}

pub(crate) fn emu() -> Bench {
    Bench::with(&[(MODEL, "emu.osim")])
}

/// Six models, made.
fn done() -> Bench {
    let bench = emu();
    bench.run(CALL).done().says(&["6 models written"]);
    bench
}

/// The same bird, but heavier.
pub(crate) fn another_model(bench: &Bench) {
    of_mass(bench, 50);
}

/// The same bird of `kg`.
pub(crate) fn of_mass(bench: &Bench, kg: u32) {
    bench.run(&format!("emu.osim --target-mass {kg} -o other.osim --force")).done();
    std::fs::rename(bench.path("other.osim"), bench.path("emu.osim")).unwrap();
}

/// All as a sweep of this bench's model that nothing disturbed makes it.
#[track_caller]
pub(crate) fn is_calm(bench: &Bench, call: &str) {
    let calm = Bench::new();
    calm.write("emu.osim", bench.read("emu.osim"));
    calm.run(call).done();
    let (files, calm) = (bench.files(), calm.files());
    assert_eq!(files.keys().collect::<Vec<_>>(), calm.keys().collect::<Vec<_>>());
    assert!(files == calm);
}

#[test]
fn what_is_there_as_it_should_be_is_not_made_again() {
    let bench = done();
    resume(&bench).done().wrote_nothing().says(&["0 models written, 6 done before"]);
    // As a killed run leaves it: no table, and not all files.
    std::fs::remove_file(bench.path(TABLE)).unwrap();
    std::fs::remove_file(bench.path(ONE)).unwrap();
    let another = "out/emu_3_stiffness-x1_dissipation-1.osim";
    let before = std::fs::metadata(bench.path(another)).unwrap().modified().unwrap();
    resume(&bench).done().wrote(&[ONE, TABLE]).says(&["1 models written, 5 done before"]);
    assert_eq!(std::fs::metadata(bench.path(another)).unwrap().modified().unwrap(), before);
    is_calm(&bench, CALL);
    let json = resume_json(&bench);
    assert_eq!((&json["models"], &json["done_before"]), (&6.into(), &6.into()), "{json}");
}

fn resume_json(bench: &Bench) -> serde_json::Value {
    serde_json::from_str(&bench.run(&format!("{CALL} --resume --format json")).done().out()).unwrap()
}

#[test]
fn from_the_start_resume_changes_nothing() {
    let bench = emu();
    resume(&bench).done().says(&["6 models written; what"]);
    is_calm(&bench, CALL);
}

#[test]
fn a_file_that_somebody_edited_is_left_alone() {
    let bench = done();
    bench.write(ONE, "my work");
    for _ in 0..2 {
        resume(&bench).failed().says(&[
            &format!("{ONE}: is not what an earlier run wrote, so it stays"),
            "--force",
            "5 done before",
        ]);
        assert_eq!(bench.read(ONE), b"my work");
        // Something is left to do.
        assert!(bench.has(PARTIAL));
    }
    bench.run(&format!("{CALL} --resume --force")).done().says(&["1 models written, 5 done before"]);
    is_calm(&bench, CALL);
}

#[test]
fn files_that_nothing_knows_are_left_alone() {
    let bench = done();
    std::fs::remove_file(bench.path(TABLE)).unwrap();
    let before = bench.files();
    another_model(&bench);
    let ran = resume(&bench).failed().says(&["is not what an earlier run wrote", "no model was made"]);
    assert_eq!(ran.changed, Vec::<String>::new());
    for (name, bytes) in before.iter().filter(|(name, _)| name.starts_with("out/")) {
        assert!(bench.read(name) == *bytes, "{name}");
    }
    assert!(!bench.has(TABLE) && !bench.has(PARTIAL));
}

#[test]
fn another_model_or_other_settings_make_all_again() {
    let bench = done();
    another_model(&bench);
    resume(&bench).done().says(&["6 models written; what"]);
    is_calm(&bench, CALL);
    let call = format!("{CALL} --no-note");
    bench.run(&format!("{call} --resume")).done().says(&["6 models written; what"]);
    // Settings that change no file make nothing again.
    bench.run(&format!("{call} --resume --jobs 1")).done().wrote_nothing().says(&["6 done before"]);
    is_calm(&bench, &call);
}

#[test]
fn another_grid_makes_what_is_new() {
    let bench = done();
    let call = CALL.replace("x2 ", "x2,x4 ");
    bench.run(&format!("{call} --resume")).done().says(&["2 models written, 6 done before"]);
    is_calm(&bench, &call);
    // Of a smaller one the other files stay, and the table has its points alone.
    let call = CALL.replace("x0.5,x1,x2 ", "x0.5 ");
    bench.run(&format!("{call} --resume")).done().wrote(&[TABLE]).says(&["2 done before"]);
    assert_eq!(bench.text(TABLE).lines().count(), 3);
    let calm = emu();
    calm.run(&call).done();
    assert_eq!(bench.text(TABLE), calm.text(TABLE));
    // Other points under these numbers are other files.
    let call = CALL.replace("x0.5,x1,x2 ", "x2 ");
    let first = "out/emu_1_stiffness-x2_dissipation-1.osim";
    let second = "out/emu_2_stiffness-x2_dissipation-2.osim";
    bench.run(&format!("{call} --resume")).done().wrote(&[first, second, TABLE]);
    assert_eq!(bench.read(first), bench.read(ONE));
}

#[test]
fn what_an_earlier_sweep_made_is_still_ours_after_one_that_did_not_get_to_it() {
    let bench = done();
    let first = bench.read(ONE);
    another_model(&bench);
    bench.write(ONE, "my work");
    // The new table has no line for it.
    resume(&bench).failed().says(&["5 of 6 models written", "stays"]);
    assert!(!bench.text(TABLE).contains("stiffness-x2_dissipation-1.osim"));
    bench.write(ONE, first);
    resume(&bench).done().says(&["1 models written, 5 done before"]);
    is_calm(&bench, CALL);
}

/// Killed with a part of a line, and some files.
#[test]
fn the_whole_lines_of_a_partial_table_are_believed() {
    let bench = done();
    let made: Vec<String> = std::fs::read_to_string(bench.path(TABLE))
        .unwrap()
        .lines()
        .skip(1)
        .map(|row| format!("{},{}\n", row.split(',').nth(1).unwrap(), row.rsplit(',').next().unwrap()))
        .collect();
    std::fs::remove_file(bench.path(TABLE)).unwrap();
    bench.write(PARTIAL, format!("file,sha256\n{}{}", made[..5].concat(), &made[5][..60]));
    bench.run(CALL).usage().wrote_nothing().says(&["left by a run that was stopped", "--resume", "--force"]);
    another_model(&bench);
    resume(&bench).failed().says(&["5 of 6 models written", "not what an earlier run wrote"]);
    assert_eq!(made.len(), 6);
}

#[test]
fn a_table_that_no_sweep_left_is_neither_believed_nor_replaced() {
    let whole = done().text(TABLE);
    let cut = &whole[..whole.len() - 30];
    for damaged in ["frame,radius\n1,0.03\n", "my notes", "", cut, &whole.replace(',', ";")] {
        let bench = done();
        bench.write(TABLE, damaged);
        let refused = bench.run(&format!("{CALL} --resume"));
        refused.usage().wrote_nothing().says(&["cannot go on with", TABLE, "--force", "-d DIR"]);
        bench.run(&format!("{CALL} --force")).done();
        is_calm(&bench, CALL);
    }
}

#[test]
fn what_a_spreadsheet_made_of_a_table_is_refused_also_with_commas() {
    let whole = done().text(TABLE);
    let (header, rows) = whole.split_once('\n').unwrap();
    let behind = format!("{header},my notes\n{}", rows.replace('\n', ",good\n"));
    let between = whole.replace(",sha256\n", ",my notes,sha256\n").replace(".osim,", ".osim,good,");
    let marked = format!("\u{feff}{whole}");
    let quoted = whole.replace("file,", "\"file\",");
    for damaged in [&whole.replace('\n', "\r\n"), &marked, &behind, &between, &quoted] {
        let bench = done();
        bench.write(TABLE, damaged);
        resume(&bench).usage().wrote_nothing().says(&[
            "cannot go on with",
            TABLE,
            "another program saved it",
        ]);
    }
    let bench = done();
    bench.write(PARTIAL, "file,sha256,my notes\n");
    resume(&bench).usage().wrote_nothing().says(&["cannot go on with", PARTIAL]);
}

#[test]
fn a_ladder_goes_on_after_another_one() {
    let bench = emu();
    let ladder = |steps: usize| {
        let words = "--indentation 0.16 --restitution 0.9 -d out --resume";
        bench.run(&format!("sweep emu.osim --ladder {steps} {words}"))
    };
    ladder(2).done().says(&["2 models written"]);
    ladder(2).done().wrote_nothing().says(&["2 done before"]);
}

#[test]
fn a_sweep_says_how_to_go_on() {
    let bench = done();
    bench.run(CALL).usage().wrote_nothing().says(&["7 of these files exist", "--resume", "--force", "-d"]);
    bench.run(&format!("{CALL} --resume --dry-run")).usage().wrote_nothing().says(&["--dry-run"]);
}

#[test]
fn two_sweeps_into_one_folder_do_not_mix() {
    let bench = emu();
    bench.write(PARTIAL, "");
    let other = std::fs::File::options().append(true).open(bench.path(PARTIAL)).unwrap();
    other.lock().unwrap();
    for how in ["--resume", "--force"] {
        let refused = bench.run(&format!("{CALL} {how}"));
        refused.ends_with(BUSY).wrote_nothing().says(&["being written by another run", "-d DIR"]);
    }
    drop(other);
    resume(&bench).done();
    is_calm(&bench, CALL);
}

/// Ctrl-C: the partial table stays, and the same call with `--resume` ends it.
#[test]
fn a_sweep_that_was_stopped_goes_on() {
    let bench = emu();
    let call = "sweep emu.osim --grid stiffness=x0.1..x10/30 --grid dissipation=1..2/20 -d out --jobs 1";
    let mut child = start(&bench, call);
    let late = Instant::now() + Duration::from_secs(60);
    let files = |bench: &Bench| {
        bench.files().keys().filter(|name| name.starts_with("out/") && name.ends_with(".osim")).count()
    };
    while files(&bench) == 0 && Instant::now() < late {
        assert_eq!(child.try_wait().unwrap(), None);
        std::thread::sleep(Duration::from_millis(5));
    }
    let sent = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    let (status, text) = ended(child);
    assert_eq!(status, Some(130), "{text}");
    assert!(text.contains("of 600 models are made; go on with the same call and --resume"), "{text}");
    assert!(bench.has(PARTIAL));
    let made = files(&bench);
    assert!(0 < made && made < 600, "{made}");
    bench
        .run(&format!("{call} --resume"))
        .done()
        .says(&[&format!("{} models written, {made} done before", 600 - made)]);
    is_calm(&bench, call);
}
