//! Folders and files with faults: the run refuses them before it writes anything, or reports the fault for one model alone.

use std::ffi::OsStr;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::{PermissionsExt, symlink};

use crate::model_folder::{
    assert_no_temporary_files, column_by_model, feed_pipe, folder_with_models, make_pipe, model_bytes,
    shell_command, start, status_and_output, unprivileged_prefix, wait_for_output,
};
use crate::support::{TestDir, fixture};

const CALL: &str = "lib --target-mass 500 -d out --summary done.csv";

/// Runs the command as a user without the rights of root, so that permissions of files apply.
fn run_unprivileged(dir: &TestDir, test: &str, call: &str) -> Option<(Option<i32>, String)> {
    let mut words = unprivileged_prefix(dir, test)?;
    let script = format!("\"$COMMAND\" {call}");
    words.extend(["sh", "-c", &script]);
    Some(status_and_output(&shell_command(dir, &words).output().unwrap()))
}

fn set_mode(dir: &TestDir, name: &str, mode: u32) {
    std::fs::set_permissions(dir.path(name), PermissionsExt::from_mode(mode)).unwrap();
}

#[test]
fn a_write_protected_output_folder_fails_only_its_models() {
    let dir = folder_with_models(4);
    for (folder, mode) in [("out", 0o777), ("out/even", 0o777), ("out/odd", 0o555)] {
        std::fs::create_dir_all(dir.path(folder)).unwrap();
        set_mode(&dir, folder, mode);
    }
    let Some((status, text)) = run_unprivileged(&dir, "a folder that cannot be written", CALL) else {
        return;
    };
    assert_eq!(status, Some(1), "{text}");
    assert!(text.contains("error: lib/odd/model01.osim: cannot write into out/odd: "), "{text}");
    assert!(text.contains("4 models: 2 written, 2 failed"), "{text}");
    assert!(dir.has("out/even/model00.osim") && !dir.has("out/odd/model01.osim"));
    assert_eq!(column_by_model(&dir.text("done.csv"), "error_code")["model03.osim"], "output");
}

#[test]
fn unreadable_folders_and_models_are_reported() {
    let dir = folder_with_models(5);
    dir.write("lib/secret/model.osim", model_bytes(7));
    set_mode(&dir, "lib/secret", 0o000);
    set_mode(&dir, "lib/odd/model03.osim", 0o000);
    let run = run_unprivileged(&dir, "folders and models that cannot be read", CALL);
    set_mode(&dir, "lib/secret", 0o755);
    let Some((status, text)) = run else { return };
    assert_eq!(status, Some(1), "{text}");
    assert!(text.contains("error: lib/secret: cannot be read: Permission denied"), "{text}");
    assert!(text.contains("error: lib/odd/model03.osim: cannot be read: Permission denied"), "{text}");
    assert!(text.contains("4 written, 2 failed"), "{text}");
    let statuses = column_by_model(&dir.text("done.csv"), "status");
    assert_eq!((&*statuses["secret"], &*statuses["model03.osim"]), ("failed", "failed"));
    assert_eq!(statuses.values().filter(|status| *status == "written").count(), 4);
}

#[test]
fn a_model_removed_or_changed_during_the_run_is_read_when_its_turn_comes() {
    let dir = folder_with_models(3);
    make_pipe(&dir, "pipe.osim");
    let mut child = start(&dir, "pipe.osim lib --target-mass 500 -d out --summary done.csv --jobs 1");
    feed_pipe(&dir, &mut child, "pipe.osim", &model_bytes(50), |_| {
        std::fs::remove_file(dir.path("lib/even/model00.osim")).unwrap();
        dir.write("lib/odd/model01.osim", model_bytes(6));
    });
    let (status, text) = wait_for_output(child);
    assert_eq!(status, Some(1), "{text}");
    assert!(text.contains("error: lib/even/model00.osim: there is no such file"), "{text}");
    assert!(text.contains("4 models: 3 written, 1 failed"), "{text}");
    // What was read when its turn came is what was written.
    let undisturbed = TestDir::new();
    undisturbed.write("model01.osim", model_bytes(6));
    undisturbed.run("model01.osim --target-mass 500 -d out").succeeded();
    assert_eq!(dir.read("out/odd/model01.osim"), undisturbed.read("out/model01.osim"));
    assert_no_temporary_files(&dir);
}

/// Another program saves the file after it was read and before it is replaced.
#[test]
fn a_file_changed_during_the_run_is_not_replaced() {
    for changed in ["forces.xml", "geometry.xml"] {
        let dir = TestDir::with(&[
            ("format/standalone_ForceSet.xml", "forces.xml"),
            ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
        ]);
        make_pipe(&dir, "bones.osim");
        let call = "forces.xml --geometry geometry.xml --model bones.osim --target-mass 500 --in-place";
        let mut child = start(&dir, call);
        let mut edited = dir.read(changed);
        edited.extend(b"<!-- edited -->\n");
        feed_pipe(
            &dir,
            &mut child,
            "bones.osim",
            &fixture("format/standalone_model_without_contacts.osim"),
            |_| {
                dir.write(changed, &edited);
            },
        );
        let (status, text) = wait_for_output(child);
        assert_eq!(status, Some(1), "{changed}: {text}");
        assert!(text.contains("another program changed"), "{changed}: {text}");
        assert_eq!(dir.read(changed), edited);
        assert!(!dir.has("forces.xml.bak") && !dir.has("geometry.xml.bak"), "{changed}");
        assert_no_temporary_files(&dir);
    }
}

#[test]
fn broken_and_circular_links_are_reported() {
    let dir = folder_with_models(2);
    symlink("gone.osim", dir.path("lib/dead.osim")).unwrap();
    symlink("gone", dir.path("lib/dead_folder")).unwrap();
    symlink("gone.mot", dir.path("lib/motion.mot")).unwrap();
    symlink("..", dir.path("lib/odd/up")).unwrap();
    let (status, text) = wait_for_output(start(&dir, CALL));
    assert_eq!(status, Some(1), "{text}");
    assert!(text.contains("error: lib/dead.osim: a link that leads nowhere"), "{text}");
    assert!(text.contains("error: lib/dead_folder: a link that leads nowhere"), "{text}");
    assert!(text.contains("error: lib/odd/up: a link that leads back to lib"), "{text}");
    assert!(!text.contains("motion.mot"), "what was no model is none of our business: {text}");
    assert!(text.contains("2 written"), "{text}");
    assert_eq!(column_by_model(&dir.text("done.csv"), "error_code")["dead.osim"], "unreadable");
}

#[test]
fn a_pipe_in_a_folder_is_refused() {
    let dir = folder_with_models(2);
    make_pipe(&dir, "lib/pipe.osim");
    let (status, text) = wait_for_output(start(&dir, CALL));
    assert_eq!(status, Some(1), "{text}");
    assert!(text.contains("error: lib/pipe.osim: this is not an ordinary file"), "{text}");
    assert!(text.contains("2 written"), "{text}");
}

#[test]
fn an_output_folder_inside_the_input_folder_is_not_read() {
    let dir = folder_with_models(3);
    let call = "lib --target-mass 500 -d lib/out --summary lib/done.csv";
    dir.run(call).succeeded().says(&["3 models: 3 written"]);
    dir.run(&format!("{call} --resume")).succeeded().wrote_nothing().says(&["the output folder is not read"]);
    // The run does not read its own summary as a model.
    assert!(dir.has("lib/out/odd/model01.osim") && !dir.has("lib/out/out"));
}

#[test]
fn names_that_are_not_utf_8_work_and_can_be_resumed() {
    let dir = TestDir::new();
    std::fs::create_dir(dir.path("lib")).unwrap();
    // Two names that are printed alike.
    let names = [OsStr::from_bytes(b"caf\xe9.osim"), OsStr::from_bytes(b"caf\xe8.osim")];
    for (number, name) in names.iter().enumerate() {
        std::fs::write(dir.path("lib").join(name), model_bytes(number)).unwrap();
    }
    let run = |more: &str| wait_for_output(start(&dir, &format!("{CALL} {more}")));
    let (status, text) = run("");
    assert_eq!(status, Some(0), "{text}");
    let outputs: Vec<_> =
        names.iter().map(|name| std::fs::read(dir.path("out").join(name)).unwrap()).collect();
    assert!(outputs[0] != outputs[1]);
    let (status, text) = run("--resume");
    assert_eq!(status, Some(0), "{text}");
    assert!(text.contains("2 done before"), "{text}");
    std::fs::remove_file(dir.path("out").join(names[0])).unwrap();
    assert_eq!(run("--resume").0, Some(0));
    assert_eq!(std::fs::read(dir.path("out").join(names[0])).unwrap(), outputs[0]);
}

#[test]
fn outputs_that_differ_only_in_case_are_refused() {
    let dir = folder_with_models(1);
    dir.write("lib/even/MODEL00.osim", model_bytes(1));
    dir.run(CALL).usage_error().wrote_nothing().says(&["lib/even/MODEL00.osim and lib/even/model00.osim"]);
}

#[test]
fn two_models_with_one_output_are_refused() {
    let dir = folder_with_models(2);
    dir.write("other/even/model00.osim", model_bytes(5));
    dir.run("lib other --target-mass 500 -d out").usage_error().wrote_nothing().says(&[
        "lib/even/model00.osim",
        "other/even/model00.osim",
        "out/even/model00.osim",
    ]);
}

#[test]
fn a_file_with_two_names_is_changed_once() {
    let dir = folder_with_models(1);
    std::fs::create_dir(dir.path("links")).unwrap();
    symlink("../lib/even/model00.osim", dir.path("links/a.osim")).unwrap();
    symlink("../lib/even", dir.path("links/b")).unwrap();
    let call = "set links lib stiffness=x2 --in-place --no-note";
    dir.run(call).succeeded().says(&["a second time"]).wrote(&[
        "lib/even/model00.osim",
        "lib/even/model00.osim.bak",
        "links/a.osim",
        "links/b/model00.osim",
        "links/b/model00.osim.bak",
    ]);
    let undisturbed = folder_with_models(1);
    undisturbed.run("set lib stiffness=x2 --in-place --no-note").succeeded();
    assert_eq!(dir.read("lib/even/model00.osim"), undisturbed.read("lib/even/model00.osim"));
    assert_eq!(dir.read("lib/even/model00.osim.bak"), model_bytes(0));
}

/// The program does not recognise hard links: each name gets the same new file, and the factor is applied once.
#[test]
fn a_file_with_two_hard_links_is_not_changed_twice() {
    let dir = folder_with_models(1);
    std::fs::hard_link(dir.path("lib/even/model00.osim"), dir.path("lib/even/second.osim")).unwrap();
    dir.run("set lib stiffness=x2 --in-place --no-note --no-backup --jobs 1").succeeded();
    let undisturbed = folder_with_models(1);
    undisturbed.run("set lib stiffness=x2 --in-place --no-note --no-backup").succeeded();
    assert_eq!(dir.read("lib/even/model00.osim"), undisturbed.read("lib/even/model00.osim"));
    assert_eq!(dir.read("lib/even/second.osim"), undisturbed.read("lib/even/model00.osim"));
}

/// A symbolic link to a missing file counts as a failed model.
#[test]
fn the_last_line_counts_links_that_lead_nowhere() {
    let dir = folder_with_models(1);
    for number in 0..3 {
        symlink("nowhere", dir.path(&format!("lib/dead{number}.osim"))).unwrap();
    }
    dir.run("lib --target-mass 500 -d out").failed().says(&["remark: 4 models: 1 written, 3 failed"]);
}

/// A table may name only ordinary files. The message must say that the file is a pipe.
#[test]
fn a_pipe_in_a_table_is_not_called_missing() {
    let dir = folder_with_models(1);
    dir.write(
        "m.csv",
        "model,output,target-mass\nlib,o.osim,70\n/dev/null,o.osim,70\nnowhere.osim,o.osim,70\n",
    );
    dir.run("batch m.csv")
        .usage_error()
        .wrote_nothing()
        .says(&["this is not an ordinary file: /dev/null", "there is no such file: nowhere.osim"]);
}

/// The model is at the start of the line, and the message does not repeat it.
#[test]
fn an_error_names_its_model_once() {
    let dir = folder_with_models(1);
    let path = dir.path("lib/even/model00.osim");
    let mut permissions = std::fs::metadata(&path).unwrap().permissions();
    permissions.set_readonly(true);
    std::fs::set_permissions(&path, permissions).unwrap();
    let run = dir.run("set lib/even/model00.osim stiffness=x2 --in-place");
    run.failed().says(&["error: lib/even/model00.osim: is write-protected"]);
}
