//! Folders and files that are not as they should be: found before anything is written, or reported for that model alone.

use std::ffi::OsStr;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::{PermissionsExt, symlink};

use crate::library::{
    bound_by_permissions, column, ended, feed, library, model, no_temporary_files, pipe, shell_command,
    start, told,
};
use crate::support::{Bench, fixture};

const CALL: &str = "lib --target-mass 500 -d out --summary done.csv";

/// Runs the command as somebody whom permissions bind.
fn bound(bench: &Bench, test: &str, call: &str) -> Option<(Option<i32>, String)> {
    let mut words = bound_by_permissions(bench, test)?;
    let script = format!("\"$COMMAND\" {call}");
    words.extend(["sh", "-c", &script]);
    Some(told(&shell_command(bench, &words).output().unwrap()))
}

fn set_mode(bench: &Bench, name: &str, mode: u32) {
    std::fs::set_permissions(bench.path(name), PermissionsExt::from_mode(mode)).unwrap();
}

#[test]
fn a_folder_that_cannot_be_written() {
    let bench = library(4);
    for (folder, mode) in [("out", 0o777), ("out/even", 0o777), ("out/odd", 0o555)] {
        std::fs::create_dir_all(bench.path(folder)).unwrap();
        set_mode(&bench, folder, mode);
    }
    let Some((status, text)) = bound(&bench, "a folder that cannot be written", CALL) else { return };
    assert_eq!(status, Some(1), "{text}");
    assert!(text.contains("error: lib/odd/model01.osim: cannot write into out/odd: "), "{text}");
    assert!(text.contains("4 models: 2 written, 2 failed"), "{text}");
    assert!(bench.has("out/even/model00.osim") && !bench.has("out/odd/model01.osim"));
    assert_eq!(column(&bench.text("done.csv"), "error_code")["model03.osim"], "output");
}

#[test]
fn folders_and_models_that_cannot_be_read() {
    let bench = library(5);
    bench.write("lib/secret/model.osim", model(7));
    set_mode(&bench, "lib/secret", 0o000);
    set_mode(&bench, "lib/odd/model03.osim", 0o000);
    let ran = bound(&bench, "folders and models that cannot be read", CALL);
    set_mode(&bench, "lib/secret", 0o755);
    let Some((status, text)) = ran else { return };
    assert_eq!(status, Some(1), "{text}");
    assert!(text.contains("error: lib/secret: cannot be read: Permission denied"), "{text}");
    assert!(text.contains("error: lib/odd/model03.osim: cannot be read: Permission denied"), "{text}");
    assert!(text.contains("4 written, 2 failed"), "{text}");
    let statuses = column(&bench.text("done.csv"), "status");
    assert_eq!((&*statuses["secret"], &*statuses["model03.osim"]), ("failed", "failed"));
    assert_eq!(statuses.values().filter(|status| *status == "written").count(), 4);
}

#[test]
fn a_model_that_goes_or_changes_after_it_was_listed() {
    let bench = library(3);
    pipe(&bench, "pipe.osim");
    let mut child = start(&bench, "pipe.osim lib --target-mass 500 -d out --summary done.csv --jobs 1");
    feed(&bench, &mut child, "pipe.osim", &model(50), |_| {
        std::fs::remove_file(bench.path("lib/even/model00.osim")).unwrap();
        bench.write("lib/odd/model01.osim", model(6));
    });
    let (status, text) = ended(child);
    assert_eq!(status, Some(1), "{text}");
    assert!(text.contains("error: lib/even/model00.osim: there is no such file"), "{text}");
    assert!(text.contains("4 models: 3 written, 1 failed"), "{text}");
    // What was read when its turn came is what was written.
    let calm = Bench::new();
    calm.write("model01.osim", model(6));
    calm.run("model01.osim --target-mass 500 -d out").done();
    assert_eq!(bench.read("out/odd/model01.osim"), calm.read("out/model01.osim"));
    no_temporary_files(&bench);
}

/// Somebody saves a file between reading and replacing it.
#[test]
fn what_changes_while_it_is_worked_on_is_not_replaced() {
    for changed in ["forces.xml", "geometry.xml"] {
        let bench = Bench::with(&[
            ("format/standalone_ForceSet.xml", "forces.xml"),
            ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
        ]);
        pipe(&bench, "bones.osim");
        let call = "forces.xml --geometry geometry.xml --model bones.osim --target-mass 500 --in-place";
        let mut child = start(&bench, call);
        let mut edited = bench.read(changed);
        edited.extend(b"<!-- edited -->\n");
        feed(
            &bench,
            &mut child,
            "bones.osim",
            &fixture("format/standalone_model_without_contacts.osim"),
            |_| {
                bench.write(changed, &edited);
            },
        );
        let (status, text) = ended(child);
        assert_eq!(status, Some(1), "{changed}: {text}");
        assert!(text.contains("another program changed"), "{changed}: {text}");
        assert_eq!(bench.read(changed), edited);
        assert!(!bench.has("forces.xml.bak") && !bench.has("geometry.xml.bak"), "{changed}");
        no_temporary_files(&bench);
    }
}

#[test]
fn links_that_lead_nowhere_or_back() {
    let bench = library(2);
    symlink("gone.osim", bench.path("lib/dead.osim")).unwrap();
    symlink("gone", bench.path("lib/dead_folder")).unwrap();
    symlink("gone.mot", bench.path("lib/motion.mot")).unwrap();
    symlink("..", bench.path("lib/odd/up")).unwrap();
    let (status, text) = ended(start(&bench, CALL));
    assert_eq!(status, Some(1), "{text}");
    assert!(text.contains("error: lib/dead.osim: a link that leads nowhere"), "{text}");
    assert!(text.contains("error: lib/dead_folder: a link that leads nowhere"), "{text}");
    assert!(text.contains("error: lib/odd/up: a link that leads back to lib"), "{text}");
    assert!(!text.contains("motion.mot"), "what was no model is none of our business: {text}");
    assert!(text.contains("2 written"), "{text}");
    assert_eq!(column(&bench.text("done.csv"), "error_code")["dead.osim"], "unreadable");
}

#[test]
fn a_pipe_in_a_folder_is_not_waited_for() {
    let bench = library(2);
    pipe(&bench, "lib/pipe.osim");
    let (status, text) = ended(start(&bench, CALL));
    assert_eq!(status, Some(1), "{text}");
    assert!(text.contains("error: lib/pipe.osim: this is not an ordinary file"), "{text}");
    assert!(text.contains("2 written"), "{text}");
}

#[test]
fn the_output_folder_inside_the_input_folder() {
    let bench = library(3);
    let call = "lib --target-mass 500 -d lib/out --summary lib/done.csv";
    bench.run(call).done().says(&["3 models: 3 written"]);
    bench.run(&format!("{call} --resume")).done().wrote_nothing().says(&["the output folder is not read"]);
    // A summary that a run left there is no model.
    assert!(bench.has("lib/out/odd/model01.osim") && !bench.has("lib/out/out"));
}

#[test]
fn names_that_are_not_utf_8() {
    let bench = Bench::new();
    std::fs::create_dir(bench.path("lib")).unwrap();
    // Two that look the same when shown.
    let names = [OsStr::from_bytes(b"caf\xe9.osim"), OsStr::from_bytes(b"caf\xe8.osim")];
    for (number, name) in names.iter().enumerate() {
        std::fs::write(bench.path("lib").join(name), model(number)).unwrap();
    }
    let run = |more: &str| ended(start(&bench, &format!("{CALL} {more}")));
    let (status, text) = run("");
    assert_eq!(status, Some(0), "{text}");
    let outputs: Vec<_> =
        names.iter().map(|name| std::fs::read(bench.path("out").join(name)).unwrap()).collect();
    assert!(outputs[0] != outputs[1]);
    let (status, text) = run("--resume");
    assert_eq!(status, Some(0), "{text}");
    assert!(text.contains("2 done before"), "{text}");
    std::fs::remove_file(bench.path("out").join(names[0])).unwrap();
    assert_eq!(run("--resume").0, Some(0));
    assert_eq!(std::fs::read(bench.path("out").join(names[0])).unwrap(), outputs[0]);
}

#[test]
fn names_that_differ_only_in_case() {
    let bench = library(1);
    bench.write("lib/even/MODEL00.osim", model(1));
    bench.run(CALL).usage().wrote_nothing().says(&["lib/even/MODEL00.osim and lib/even/model00.osim"]);
}

#[test]
fn two_models_with_one_output() {
    let bench = library(2);
    bench.write("other/even/model00.osim", model(5));
    bench.run("lib other --target-mass 500 -d out").usage().wrote_nothing().says(&[
        "lib/even/model00.osim",
        "other/even/model00.osim",
        "out/even/model00.osim",
    ]);
}

#[test]
fn a_file_with_two_names_is_changed_once() {
    let bench = library(1);
    std::fs::create_dir(bench.path("links")).unwrap();
    symlink("../lib/even/model00.osim", bench.path("links/a.osim")).unwrap();
    symlink("../lib/even", bench.path("links/b")).unwrap();
    let call = "set links lib stiffness=x2 --in-place --no-note";
    bench.run(call).done().says(&["a second time"]).wrote(&[
        "lib/even/model00.osim",
        "lib/even/model00.osim.bak",
        "links/a.osim",
        "links/b/model00.osim",
        "links/b/model00.osim.bak",
    ]);
    let once = library(1);
    once.run("set lib stiffness=x2 --in-place --no-note").done();
    assert_eq!(bench.read("lib/even/model00.osim"), once.read("lib/even/model00.osim"));
    assert_eq!(bench.read("lib/even/model00.osim.bak"), model(0));
}

/// Hard links cannot be told from two files: each name gets the same successor, and neither gets the factor twice.
#[test]
fn a_file_with_two_hard_links_is_not_changed_twice() {
    let bench = library(1);
    std::fs::hard_link(bench.path("lib/even/model00.osim"), bench.path("lib/even/second.osim")).unwrap();
    bench.run("set lib stiffness=x2 --in-place --no-note --no-backup --jobs 1").done();
    let once = library(1);
    once.run("set lib stiffness=x2 --in-place --no-note --no-backup").done();
    assert_eq!(bench.read("lib/even/model00.osim"), once.read("lib/even/model00.osim"));
    assert_eq!(bench.read("lib/even/second.osim"), once.read("lib/even/model00.osim"));
}

/// What could not even be listed has failed like a model that cannot be read.
#[test]
fn the_last_line_counts_what_could_not_be_listed() {
    let bench = library(1);
    for number in 0..3 {
        symlink("nowhere", bench.path(&format!("lib/dead{number}.osim"))).unwrap();
    }
    bench.run("lib --target-mass 500 -d out").failed().says(&["remark: 4 models: 1 written, 3 failed"]);
}

/// A table names ordinary files. A pipe is there, and is none.
#[test]
fn a_pipe_in_a_table_is_not_called_missing() {
    let bench = library(1);
    bench.write(
        "m.csv",
        "model,output,target-mass\nlib,o.osim,70\n/dev/null,o.osim,70\nnowhere.osim,o.osim,70\n",
    );
    bench
        .run("batch m.csv")
        .usage()
        .wrote_nothing()
        .says(&["this is not an ordinary file: /dev/null", "there is no such file: nowhere.osim"]);
}

/// The model begins the line; its message does not name it again.
#[test]
fn a_model_is_named_once() {
    let bench = library(1);
    let path = bench.path("lib/even/model00.osim");
    let mut permissions = std::fs::metadata(&path).unwrap().permissions();
    permissions.set_readonly(true);
    std::fs::set_permissions(&path, permissions).unwrap();
    let ran = bench.run("set lib/even/model00.osim stiffness=x2 --in-place");
    ran.failed().says(&["error: lib/even/model00.osim: is write-protected"]);
}
