//! No room: a full disk, a limit on the size of files, a full device behind standard output.

use crate::library::{Files, below, library, no_temporary_files, shell, shell_command};
use crate::support::{Bench, skipped};

const CALL: &str = "lib --target-mass 500 -d out --summary done.csv --jobs 2";

fn undisturbed(models: usize) -> Files {
    let bench = library(models);
    bench.run(CALL).done();
    bench.files()
}

/// Models of 40 kB and more do not fit, those of 4 kB do.
#[test]
fn a_limit_on_the_size_of_files_is_an_error_of_the_model() {
    let bench = library(10);
    let before = bench.files();
    // Blocks of 512 bytes, as POSIX has it; 1024 in some shells.
    let (status, text) = shell(&bench, &format!("ulimit -f 32; \"$COMMAND\" {CALL}"));
    assert_eq!(status, Some(1), "{text}");
    assert!(
        text.contains("error: lib/odd/model01.osim: cannot write out/odd/model01.osim: File too large"),
        "{text}"
    );
    assert!(text.contains("10 models: 6 written, 4 failed"), "{text}");
    let (after, calm) = (bench.files(), undisturbed(10));
    assert!(before.iter().all(|(name, bytes)| after.get(name) == Some(bytes)));
    assert!(
        below(&after, "out/").iter().all(|(name, bytes)| calm.get(&format!("out/{name}")) == Some(bytes))
    );
    no_temporary_files(&bench);
    bench.run(&format!("{CALL} --resume")).done().says(&["4 written, 6 done before"]);
    assert!(bench.files() == calm);
}

/// A disk of its own for the folder `disk`, made larger halfway. The shell's words of two runs, and what each left.
fn on_small_disk(bench: &Bench, size: &str, call: &str) -> Option<(String, String)> {
    std::fs::create_dir(bench.path("disk")).unwrap();
    let script = format!(
        r#"mount -t tmpfs -o size={size} none disk || exit 77
        "$COMMAND" {call} >first.txt 2>&1; echo "exit status $?" >>first.txt
        cp -r disk first
        mount -o remount,size=20m disk
        "$COMMAND" {call} --resume >second.txt 2>&1; echo "exit status $?" >>second.txt
        cp -r disk second"#
    );
    let output =
        shell_command(bench, &["unshare", "--mount", "--map-root-user", "sh", "-c", &script]).output();
    if !output.is_ok_and(|output| output.status.success()) {
        skipped("a full disk", "this machine lets nobody mount a small disk");
        return None;
    }
    Some((bench.text("first.txt"), bench.text("second.txt")))
}

#[test]
fn a_full_disk_is_an_error_of_the_models_that_do_not_fit() {
    let bench = library(10);
    let call = "lib --target-mass 500 -d disk/out --summary done.csv --jobs 2";
    let Some((first, second)) = on_small_disk(&bench, "100k", call) else { return };
    assert!(first.contains("exit status 1"), "{first}");
    assert!(
        first.contains(": cannot write disk/out/") && first.contains("No space left on device"),
        "{first}"
    );
    assert!(second.contains("exit status 0") && second.contains("done before"), "{second}");
    let calm = below(&undisturbed(10), "out/");
    let files = bench.files();
    let (some, all) = (below(&files, "first/out/"), below(&files, "second/out/"));
    assert!(!some.is_empty() && some.len() < 10, "{:?}", some.keys());
    assert!(some.iter().all(|(name, bytes)| calm.get(name) == Some(bytes)), "torn: {:?}", some.keys());
    assert!(all == calm);
}

/// The disk of the summary is full: a model without its line would not be known to `--resume`.
#[test]
fn no_model_is_written_whose_line_has_no_room() {
    let bench = library(20);
    let call = "lib --target-mass 500 -d out --summary disk/done.csv --jobs 2";
    let Some((first, second)) = on_small_disk(&bench, "4k", call) else { return };
    assert!(first.contains("exit status 1"), "{first}");
    assert!(first.contains("cannot write disk/done.csv.partial: No space left on device"), "{first}");
    assert!(first.contains("the summary is missing: make room for it, then go on with --resume"), "{first}");
    assert!(second.contains("exit status 0") && second.contains("done before"), "{second}");
    let (files, calm) = (bench.files(), undisturbed(20));
    assert!(below(&files, "out/") == below(&calm, "out/"));
    assert!(files.contains_key("first/done.csv.partial") && !files.contains_key("first/done.csv"));
    let summary = String::from_utf8(files["second/done.csv"].clone()).unwrap();
    // Names in a summary begin at the folder of the call, seen from that of the summary.
    let calm = String::from_utf8(calm["done.csv"].clone()).unwrap();
    assert_eq!(summary.lines().count(), 21);
    assert!(summary == calm.replace(",.\n", ",..\n"), "{summary}");
    assert!(files.keys().filter(|name| name.starts_with("first/")).count() == 1, "a temporary file stayed");
}

#[test]
fn a_figure_that_has_no_room_is_an_error() {
    let bench = Bench::human();
    for ending in ["svg", "png", "pdf"] {
        let call = format!("ulimit -f 2; \"$COMMAND\" plot force human.osim -o figure.{ending}");
        let (status, text) = shell(&bench, &call);
        assert_eq!(status, Some(1), "{text}");
        assert!(text.contains(&format!("error: cannot write figure.{ending}: File too large")), "{text}");
    }
    no_temporary_files(&bench);
    assert_eq!(bench.files().len(), 1);
    let full = "error: cannot write to standard output: No space left on device";
    for call in ["plot force human.osim -o -", "inspect human.osim", "explain", "--help"] {
        let (status, text) = shell(&bench, &format!("\"$COMMAND\" {call} >/dev/full"));
        assert!(status == Some(1) && text.contains(full), "{call}: {status:?} {text}");
    }
}

#[test]
fn a_full_standard_output_stops_no_model() {
    let bench = library(12);
    let (status, text) = shell(&bench, &format!("\"$COMMAND\" {CALL} --format json >/dev/full"));
    assert_eq!(status, Some(1), "{text}");
    assert_eq!(
        text.matches("error: cannot write to standard output: No space left on device").count(),
        1,
        "{text}"
    );
    assert!(text.contains("12 models: 12 written"), "{text}");
    assert!(bench.files() == undisturbed(12));
}
