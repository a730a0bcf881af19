//! `sweep --resume` keeps complete models, writes missing models, and keeps edited models.

use std::time::{Duration, Instant};

use crate::model_folder::{start, wait_for_output};
use crate::support::{CommandRun, TestDir};

const EMU_MODEL: &str = "table1/emu_10_spheres_smooth_sphere.osim";
pub(crate) const CALL: &str = "sweep emu.osim --grid stiffness=x0.5,x1,x2 --grid dissipation=1,2 -d out";
/// The exit status if another run writes a file.
pub(crate) const EXIT_OF_BUSY_SWEEP: i32 = 3;
pub(crate) const SWEEP_TABLE: &str = "out/emu_sweep.csv";
const PARTIAL_TABLE: &str = "out/emu_sweep.csv.partial";
pub(crate) const FIFTH_VARIANT: &str = "out/emu_5_stiffness-x2_dissipation-1.osim";

fn resume_sweep(dir: &TestDir) -> CommandRun {
    dir.run(&format!("{CALL} --resume"))
}

pub(crate) fn dir_with_emu() -> TestDir {
    TestDir::with(&[(EMU_MODEL, "emu.osim")])
}

/// A folder after a sweep of six models.
fn finished_sweep() -> TestDir {
    let dir = dir_with_emu();
    dir.run(CALL).succeeded().says(&["6 models written"]);
    dir
}

/// Replaces the model by a heavier one.
pub(crate) fn replace_by_heavier_model(dir: &TestDir) {
    replace_by_model_of_mass(dir, 50);
}

/// Replaces the model by a model with a mass of `kg`.
pub(crate) fn replace_by_model_of_mass(dir: &TestDir, kg: u32) {
    dir.run(&format!("emu.osim --target-mass {kg} -o other.osim --force")).succeeded();
    std::fs::rename(dir.path("other.osim"), dir.path("emu.osim")).unwrap();
}

/// Asserts that the folder has the same files as after an undisturbed sweep.
#[track_caller]
pub(crate) fn assert_undisturbed(dir: &TestDir, call: &str) {
    let undisturbed = TestDir::new();
    undisturbed.write("emu.osim", dir.read("emu.osim"));
    undisturbed.run(call).succeeded();
    let (files, undisturbed) = (dir.files(), undisturbed.files());
    assert_eq!(files.keys().collect::<Vec<_>>(), undisturbed.keys().collect::<Vec<_>>());
    assert!(files == undisturbed);
}

#[test]
fn a_resumed_sweep_skips_complete_variants() {
    let dir = finished_sweep();
    resume_sweep(&dir).succeeded().wrote_nothing().says(&["0 models written, 6 done before"]);
    // The state after a kill: no table, and not all files.
    std::fs::remove_file(dir.path(SWEEP_TABLE)).unwrap();
    std::fs::remove_file(dir.path(FIFTH_VARIANT)).unwrap();
    let another = "out/emu_3_stiffness-x1_dissipation-1.osim";
    let before = std::fs::metadata(dir.path(another)).unwrap().modified().unwrap();
    resume_sweep(&dir)
        .succeeded()
        .wrote(&[FIFTH_VARIANT, SWEEP_TABLE])
        .says(&["1 models written, 5 done before"]);
    assert_eq!(std::fs::metadata(dir.path(another)).unwrap().modified().unwrap(), before);
    assert_undisturbed(&dir, CALL);
    let json = resume_json(&dir);
    assert_eq!((&json["models"], &json["done_before"]), (&6.into(), &6.into()), "{json}");
}

fn resume_json(dir: &TestDir) -> serde_json::Value {
    serde_json::from_str(&dir.run(&format!("{CALL} --resume --format json")).succeeded().out()).unwrap()
}

#[test]
fn a_first_run_may_have_resume() {
    let dir = dir_with_emu();
    resume_sweep(&dir).succeeded().says(&["6 models written; their values"]);
    assert_undisturbed(&dir, CALL);
}

#[test]
fn a_resumed_sweep_keeps_an_edited_variant() {
    let dir = finished_sweep();
    dir.write(FIFTH_VARIANT, "my work");
    for _ in 0..2 {
        resume_sweep(&dir).failed().says(&[
            &format!("{FIFTH_VARIANT}: is not what an earlier run wrote, so it stays"),
            "--force",
            "5 done before",
        ]);
        assert_eq!(dir.read(FIFTH_VARIANT), b"my work");
        // The sweep is not complete.
        assert!(dir.has(PARTIAL_TABLE));
    }
    dir.run(&format!("{CALL} --resume --force")).succeeded().says(&["1 models written, 5 done before"]);
    assert_undisturbed(&dir, CALL);
}

#[test]
fn models_that_no_table_lists_are_kept() {
    let dir = finished_sweep();
    std::fs::remove_file(dir.path(SWEEP_TABLE)).unwrap();
    let before = dir.files();
    replace_by_heavier_model(&dir);
    let run = resume_sweep(&dir).failed().says(&["is not what an earlier run wrote", "no model was made"]);
    assert_eq!(run.changed, Vec::<String>::new());
    for (name, bytes) in before.iter().filter(|(name, _)| name.starts_with("out/")) {
        assert!(dir.read(name) == *bytes, "{name}");
    }
    assert!(!dir.has(SWEEP_TABLE) && !dir.has(PARTIAL_TABLE));
}

#[test]
fn another_model_or_other_settings_write_all_again() {
    let dir = finished_sweep();
    replace_by_heavier_model(&dir);
    resume_sweep(&dir).succeeded().says(&["6 models written; their values"]);
    assert_undisturbed(&dir, CALL);
    let call = format!("{CALL} --no-note");
    dir.run(&format!("{call} --resume")).succeeded().says(&["6 models written; their values"]);
    // Settings that change no file write nothing again.
    dir.run(&format!("{call} --resume --jobs 1")).succeeded().wrote_nothing().says(&["6 done before"]);
    assert_undisturbed(&dir, &call);
}

#[test]
fn another_grid_writes_only_its_new_points() {
    let dir = finished_sweep();
    let call = CALL.replace("x2 ", "x2,x4 ");
    dir.run(&format!("{call} --resume")).succeeded().says(&["2 models written, 6 done before"]);
    assert_undisturbed(&dir, &call);
    // With a smaller grid the other files stay, and the table has only its points.
    let call = CALL.replace("x0.5,x1,x2 ", "x0.5 ");
    dir.run(&format!("{call} --resume")).succeeded().wrote(&[SWEEP_TABLE]).says(&["2 done before"]);
    assert_eq!(dir.text(SWEEP_TABLE).lines().count(), 3);
    let undisturbed = dir_with_emu();
    undisturbed.run(&call).succeeded();
    assert_eq!(dir.text(SWEEP_TABLE), undisturbed.text(SWEEP_TABLE));
    // Other points under these numbers are other files.
    let call = CALL.replace("x0.5,x1,x2 ", "x2 ");
    let first = "out/emu_1_stiffness-x2_dissipation-1.osim";
    let second = "out/emu_2_stiffness-x2_dissipation-2.osim";
    dir.run(&format!("{call} --resume")).succeeded().wrote(&[first, second, SWEEP_TABLE]);
    assert_eq!(dir.read(first), dir.read(FIFTH_VARIANT));
}

#[test]
fn an_earlier_model_is_replaced_after_a_sweep_that_failed_to() {
    let dir = finished_sweep();
    let first = dir.read(FIFTH_VARIANT);
    replace_by_heavier_model(&dir);
    dir.write(FIFTH_VARIANT, "my work");
    // The new table has no line for it.
    resume_sweep(&dir).failed().says(&["5 of 6 models written", "stays"]);
    assert!(!dir.text(SWEEP_TABLE).contains("stiffness-x2_dissipation-1.osim"));
    dir.write(FIFTH_VARIANT, first);
    resume_sweep(&dir).succeeded().says(&["1 models written, 5 done before"]);
    assert_undisturbed(&dir, CALL);
}

/// A killed sweep leaves some files, and an incomplete line in the partial table.
#[test]
fn complete_lines_of_a_partial_table_are_used() {
    let dir = finished_sweep();
    let digest_lines: Vec<String> = std::fs::read_to_string(dir.path(SWEEP_TABLE))
        .unwrap()
        .lines()
        .skip(1)
        .map(|row| format!("{},{}\n", row.split(',').nth(1).unwrap(), row.rsplit(',').next().unwrap()))
        .collect();
    std::fs::remove_file(dir.path(SWEEP_TABLE)).unwrap();
    dir.write(
        PARTIAL_TABLE,
        format!("file,sha256\n{}{}", digest_lines[..5].concat(), &digest_lines[5][..60]),
    );
    dir.run(CALL).usage_error().wrote_nothing().says(&[
        "left by a run that was stopped",
        "--resume",
        "--force",
    ]);
    replace_by_heavier_model(&dir);
    resume_sweep(&dir).failed().says(&["5 of 6 models written", "not what an earlier run wrote"]);
    assert_eq!(digest_lines.len(), 6);
}

#[test]
fn a_table_that_no_sweep_wrote_is_refused() {
    let whole = finished_sweep().text(SWEEP_TABLE);
    let cut = &whole[..whole.len() - 30];
    for damaged in ["frame,radius\n1,0.03\n", "my notes", "", cut, &whole.replace(',', ";")] {
        let dir = finished_sweep();
        dir.write(SWEEP_TABLE, damaged);
        let refused = dir.run(&format!("{CALL} --resume"));
        refused.usage_error().wrote_nothing().says(&[
            "cannot continue with",
            SWEEP_TABLE,
            "--force",
            "-d DIR",
        ]);
        dir.run(&format!("{CALL} --force")).succeeded();
        assert_undisturbed(&dir, CALL);
    }
}

#[test]
fn a_table_saved_by_a_spreadsheet_with_commas_is_refused() {
    let whole = finished_sweep().text(SWEEP_TABLE);
    let (header, rows) = whole.split_once('\n').unwrap();
    let behind = format!("{header},my notes\n{}", rows.replace('\n', ",good\n"));
    let between = whole.replace(",sha256\n", ",my notes,sha256\n").replace(".osim,", ".osim,good,");
    let marked = format!("\u{feff}{whole}");
    let quoted = whole.replace("file,", "\"file\",");
    for damaged in [&whole.replace('\n', "\r\n"), &marked, &behind, &between, &quoted] {
        let dir = finished_sweep();
        dir.write(SWEEP_TABLE, damaged);
        resume_sweep(&dir).usage_error().wrote_nothing().says(&[
            "cannot continue with",
            SWEEP_TABLE,
            "another program saved it",
        ]);
    }
    let dir = finished_sweep();
    dir.write(PARTIAL_TABLE, "file,sha256,my notes\n");
    resume_sweep(&dir).usage_error().wrote_nothing().says(&["cannot continue with", PARTIAL_TABLE]);
}

#[test]
fn a_sweep_along_a_ladder_can_be_resumed() {
    let dir = dir_with_emu();
    let ladder = |steps: usize| {
        let words = "--indentation 0.16 --restitution 0.9 -d out --resume";
        dir.run(&format!("sweep emu.osim --ladder {steps} {words}"))
    };
    ladder(2).succeeded().says(&["2 models written"]);
    ladder(2).succeeded().wrote_nothing().says(&["2 done before"]);
}

#[test]
fn a_sweep_that_exists_names_the_options_to_continue() {
    let dir = finished_sweep();
    dir.run(CALL).usage_error().wrote_nothing().says(&[
        "7 of these files exist",
        "--resume",
        "--force",
        "-d",
    ]);
    dir.run(&format!("{CALL} --resume --dry-run")).usage_error().wrote_nothing().says(&["--dry-run"]);
}

#[test]
fn a_second_sweep_into_a_busy_folder_is_refused() {
    let dir = dir_with_emu();
    dir.write(PARTIAL_TABLE, "");
    let other = std::fs::File::options().append(true).open(dir.path(PARTIAL_TABLE)).unwrap();
    other.lock().unwrap();
    for option in ["--resume", "--force"] {
        let refused = dir.run(&format!("{CALL} {option}"));
        refused
            .exited_with(EXIT_OF_BUSY_SWEEP)
            .wrote_nothing()
            .says(&["being written by another run", "-d DIR"]);
    }
    drop(other);
    resume_sweep(&dir).succeeded();
    assert_undisturbed(&dir, CALL);
}

/// After Ctrl-C the partial table stays, and the same call with `--resume` finishes the sweep.
#[test]
fn an_interrupted_sweep_can_be_resumed() {
    let dir = dir_with_emu();
    let call = "sweep emu.osim --grid stiffness=x0.1..x10/30 --grid dissipation=1..2/20 -d out --jobs 1";
    let mut child = start(&dir, call);
    let deadline = Instant::now() + Duration::from_secs(60);
    let files = |dir: &TestDir| {
        dir.files().keys().filter(|name| name.starts_with("out/") && name.ends_with(".osim")).count()
    };
    while files(&dir) == 0 && Instant::now() < deadline {
        assert_eq!(child.try_wait().unwrap(), None);
        std::thread::sleep(Duration::from_millis(5));
    }
    let status = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(status.success());
    let (status, text) = wait_for_output(child);
    assert_eq!(status, Some(130), "{text}");
    assert!(text.contains("of 600 models are made; to continue, repeat the command with --resume"), "{text}");
    assert!(dir.has(PARTIAL_TABLE));
    let written = files(&dir);
    assert!(0 < written && written < 600, "{written}");
    dir.run(&format!("{call} --resume"))
        .succeeded()
        .says(&[&format!("{} models written, {written} done before", 600 - written)]);
    assert_undisturbed(&dir, call);
}
