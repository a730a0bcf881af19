//! Runs without enough space: a full disk, a limit on the size of files, standard output to a full device.

use crate::model_folder::{
    Files, assert_no_temporary_files, files_below, folder_with_models, run_shell, shell_command,
};
use crate::support::{TestDir, report_skip};

const CALL: &str = "lib --target-mass 500 -d out --summary done.csv --jobs 2";

fn files_of_undisturbed_run(models: usize) -> Files {
    let dir = folder_with_models(models);
    dir.run(CALL).succeeded();
    dir.files()
}

/// Under this limit models of 40 kB and more cannot be written, and models of 4 kB can.
#[test]
fn a_limit_on_file_size_fails_only_the_large_models() {
    let dir = folder_with_models(10);
    let before = dir.files();
    // Blocks of 512 bytes, as POSIX has it; 1024 in some shells.
    let (status, text) = run_shell(&dir, &format!("ulimit -f 32; \"$COMMAND\" {CALL}"));
    assert_eq!(status, Some(1), "{text}");
    assert!(
        text.contains("error: lib/odd/model01.osim: cannot write out/odd/model01.osim: File too large"),
        "{text}"
    );
    assert!(text.contains("10 models: 6 written, 4 failed"), "{text}");
    let (after, undisturbed) = (dir.files(), files_of_undisturbed_run(10));
    assert!(before.iter().all(|(name, bytes)| after.get(name) == Some(bytes)));
    assert!(
        files_below(&after, "out/")
            .iter()
            .all(|(name, bytes)| undisturbed.get(&format!("out/{name}")) == Some(bytes))
    );
    assert_no_temporary_files(&dir);
    dir.run(&format!("{CALL} --resume")).succeeded().says(&["4 written, 6 done before"]);
    assert!(dir.files() == undisturbed);
}

/// Runs a call on a small disk in the folder `disk`, and with `--resume` on a larger one. Returns the output of both runs.
fn run_on_small_disk(dir: &TestDir, size: &str, call: &str) -> Option<(String, String)> {
    std::fs::create_dir(dir.path("disk")).unwrap();
    let script = format!(
        r#"mount -t tmpfs -o size={size} none disk || exit 77
        "$COMMAND" {call} >first.txt 2>&1; echo "exit status $?" >>first.txt
        cp -r disk first
        mount -o remount,size=20m disk
        "$COMMAND" {call} --resume >second.txt 2>&1; echo "exit status $?" >>second.txt
        cp -r disk second"#
    );
    let output = shell_command(dir, &["unshare", "--mount", "--map-root-user", "sh", "-c", &script]).output();
    if !output.is_ok_and(|output| output.status.success()) {
        report_skip("a full disk", "this machine lets nobody mount a small disk");
        return None;
    }
    Some((dir.text("first.txt"), dir.text("second.txt")))
}

#[test]
fn a_full_disk_fails_only_the_models_that_do_not_fit() {
    let dir = folder_with_models(10);
    let call = "lib --target-mass 500 -d disk/out --summary done.csv --jobs 2";
    let Some((first_output, second_output)) = run_on_small_disk(&dir, "100k", call) else { return };
    assert!(first_output.contains("exit status 1"), "{first_output}");
    assert!(
        first_output.contains(": cannot write disk/out/") && first_output.contains("No space left on device"),
        "{first_output}"
    );
    assert!(
        second_output.contains("exit status 0") && second_output.contains("done before"),
        "{second_output}"
    );
    let undisturbed = files_below(&files_of_undisturbed_run(10), "out/");
    let files = dir.files();
    let (first_outputs, second_outputs) =
        (files_below(&files, "first/out/"), files_below(&files, "second/out/"));
    assert!(!first_outputs.is_empty() && first_outputs.len() < 10, "{:?}", first_outputs.keys());
    assert!(
        first_outputs.iter().all(|(name, bytes)| undisturbed.get(name) == Some(bytes)),
        "torn: {:?}",
        first_outputs.keys()
    );
    assert!(second_outputs == undisturbed);
}

/// The disk of the summary is full. No model may be written without its line, because `--resume` would not know the model.
#[test]
fn no_model_is_written_if_its_summary_line_does_not_fit() {
    let dir = folder_with_models(20);
    let call = "lib --target-mass 500 -d out --summary disk/done.csv --jobs 2";
    let Some((first_output, second_output)) = run_on_small_disk(&dir, "4k", call) else { return };
    assert!(first_output.contains("exit status 1"), "{first_output}");
    assert!(
        first_output.contains("cannot write disk/done.csv.partial: No space left on device"),
        "{first_output}"
    );
    assert!(
        first_output.contains("the summary is missing: make room for it, then continue with --resume"),
        "{first_output}"
    );
    assert!(
        second_output.contains("exit status 0") && second_output.contains("done before"),
        "{second_output}"
    );
    let (files, undisturbed) = (dir.files(), files_of_undisturbed_run(20));
    assert!(files_below(&files, "out/") == files_below(&undisturbed, "out/"));
    assert!(files.contains_key("first/done.csv.partial") && !files.contains_key("first/done.csv"));
    let summary = String::from_utf8(files["second/done.csv"].clone()).unwrap();
    // Names in a summary begin at the folder of the call, seen from that of the summary.
    let undisturbed = String::from_utf8(undisturbed["done.csv"].clone()).unwrap();
    assert_eq!(summary.lines().count(), 21);
    assert!(summary == undisturbed.replace(",.\n", ",..\n"), "{summary}");
    assert!(files.keys().filter(|name| name.starts_with("first/")).count() == 1, "a temporary file stayed");
}

#[test]
fn a_figure_that_does_not_fit_is_an_error() {
    let dir = TestDir::with_human();
    for ending in ["svg", "png", "pdf"] {
        let call = format!("ulimit -f 2; \"$COMMAND\" plot force human.osim -o figure.{ending}");
        let (status, text) = run_shell(&dir, &call);
        assert_eq!(status, Some(1), "{text}");
        assert!(text.contains(&format!("error: cannot write figure.{ending}: File too large")), "{text}");
    }
    assert_no_temporary_files(&dir);
    assert_eq!(dir.files().len(), 1);
    let full = "error: cannot write to standard output: No space left on device";
    for call in ["plot force human.osim -o -", "inspect human.osim", "explain", "--help"] {
        let (status, text) = run_shell(&dir, &format!("\"$COMMAND\" {call} >/dev/full"));
        assert!(status == Some(1) && text.contains(full), "{call}: {status:?} {text}");
    }
}

#[test]
fn a_full_standard_output_does_not_stop_the_models() {
    let dir = folder_with_models(12);
    let (status, text) = run_shell(&dir, &format!("\"$COMMAND\" {CALL} --format json >/dev/full"));
    assert_eq!(status, Some(1), "{text}");
    assert_eq!(
        text.matches("error: cannot write to standard output: No space left on device").count(),
        1,
        "{text}"
    );
    assert!(text.contains("12 models: 12 written"), "{text}");
    assert!(dir.files() == files_of_undisturbed_run(12));
}
