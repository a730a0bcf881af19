//! The program reads ordinary files up to a limit of size, and pipes only if the user named them. All other files neither make the
//! program wait nor fill the memory.

use std::fs::File;
use std::os::unix::fs::symlink;
use std::os::unix::net::UnixListener;
use std::process::Stdio;
use std::time::{Duration, Instant};

use crate::leftover_files::{dead_process, temporary_name, this_host};
use crate::model_folder::{
    feed_pipe, folder_with_models, make_pipe, model_bytes, shell_command, start, status_and_output,
    wait_for_output,
};
use crate::support::{HUMAN, TestDir, fixture};

/// One byte more than the largest file that the program reads, as in `docs/reference/errors.md`.
const TOO_MANY_BYTES: u64 = 2 * 1024 * 1024 * 1024 + 1;

/// Runs a call that must end within 20 s and with at most 3 GB of memory.
#[track_caller]
fn run_within_20_s(dir: &TestDir, call: &str) -> (Option<i32>, String) {
    let script = format!("ulimit -v 3000000; exec \"$COMMAND\" {call}");
    let mut command = shell_command(dir, &["bash", "-c", &script]);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let end = Instant::now() + Duration::from_secs(20);
    while child.try_wait().unwrap().is_none() {
        if Instant::now() > end {
            child.kill().unwrap();
            child.wait().unwrap();
            panic!("{call} waits for ever");
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    status_and_output(&child.wait_with_output().unwrap())
}

/// Asserts that the call ends within 20 s with this exit status and prints these words.
#[track_caller]
fn assert_refused_soon(dir: &TestDir, call: &str, status: i32, says: &[&str]) {
    let (exit_status, text) = run_within_20_s(dir, call);
    assert_eq!(exit_status, Some(status), "{call}: {text}");
    for word in says {
        assert!(text.contains(word), "'{word}' is not in what {call} says:\n{text}");
    }
}

/// A model that includes the file `name`.
fn write_model_that_includes(dir: &TestDir, name: &str) {
    let text = String::from_utf8(fixture("format/file_forceset.osim")).unwrap();
    assert!(text.contains("standalone_ForceSet.xml"));
    dir.write("model.osim", text.replace("standalone_ForceSet.xml", name));
}

#[test]
fn a_pipe_with_a_temporary_name_does_not_block_a_run() {
    let dir = folder_with_models(2);
    let name = format!("out/even/{}", temporary_name(&this_host(), dead_process()));
    dir.write("out/even/other.txt", "");
    make_pipe(&dir, &name);
    let (status, text) = run_within_20_s(&dir, "lib --target-mass 500 -d out");
    assert_eq!(status, Some(0), "{text}");
    assert!(dir.path(&name).exists(), "what this program never makes, it does not remove");
    std::fs::remove_file(dir.path(&name)).unwrap();
}

#[test]
fn an_included_pipe_is_refused() {
    let dir = TestDir::new();
    write_model_that_includes(&dir, "forces.xml");
    make_pipe(&dir, "forces.xml");
    for call in ["inspect model.osim", "model.osim --target-mass 500"] {
        assert_refused_soon(&dir, call, 1, &["file=\"forces.xml\"", "pipe"]);
    }
    std::fs::remove_file(dir.path("forces.xml")).unwrap();
}

#[test]
fn an_included_device_is_refused() {
    let dir = TestDir::new();
    for device in ["/dev/zero", "/dev/stdin", "/dev/tty"] {
        write_model_that_includes(&dir, device);
        assert_refused_soon(&dir, "inspect model.osim", 1, &["model.osim", &format!("file=\"{device}\"")]);
    }
    write_model_that_includes(&dir, "/dev/zero");
    assert_refused_soon(&dir, "inspect model.osim", 1, &["device"]);
    symlink("/dev/zero", dir.path("forces.xml")).unwrap();
    write_model_that_includes(&dir, "forces.xml");
    assert_refused_soon(&dir, "inspect model.osim", 1, &["device"]);
    std::fs::remove_file(dir.path("forces.xml")).unwrap();
}

#[test]
fn folders_and_sockets_are_refused_in_plain_words() {
    let dir = TestDir::with_human();
    std::fs::create_dir(dir.path("folder.toml")).unwrap();
    assert_refused_soon(&dir, "transfer human.osim --from folder.toml", 1, &["is a folder"]);
    let _socket = UnixListener::bind(dir.path("socket.osim")).unwrap();
    assert_refused_soon(&dir, "inspect socket.osim", 1, &["socket"]);
    std::fs::remove_file(dir.path("socket.osim")).unwrap();
}

/// A device may give bytes without end.
#[test]
fn a_device_without_an_end_is_refused_after_16_mib() {
    let dir = TestDir::with_human();
    let says = ["16 MiB"];
    assert_refused_soon(&dir, "inspect /dev/zero", 1, &says);
    assert_refused_soon(&dir, "inspect - < /dev/zero", 1, &says);
    assert_refused_soon(&dir, "transfer human.osim --from /dev/zero", 1, &says);
    assert_refused_soon(&dir, "batch /dev/zero", 2, &says);
    assert_refused_soon(&dir, "fit /dev/zero --radius 0.03", 1, &says);
    assert_refused_soon(&dir, "request /dev/zero", 2, &says);
    assert_refused_soon(&dir, "presets --presets /dev/zero", 2, &says);
}

#[test]
fn pipes_and_devices_in_a_table_are_refused() {
    let dir = TestDir::with_human();
    make_pipe(&dir, "pipe.osim");
    dir.write("table.csv", "model,verb,from\nhuman.osim,transfer,pipe.osim\n");
    assert_refused_soon(&dir, "batch table.csv", 2, &["pipe"]);
    dir.write("table.csv", "model,verb,from\nhuman.osim,transfer,/dev/zero\n");
    assert_refused_soon(&dir, "batch table.csv", 2, &["device"]);
    std::fs::remove_file(dir.path("pipe.osim")).unwrap();
}

#[test]
fn a_summary_that_is_a_pipe_is_refused() {
    for name in ["done.csv", "done.csv.partial"] {
        let dir = folder_with_models(1);
        make_pipe(&dir, name);
        for option in ["--resume", "--force"] {
            assert_refused_soon(
                &dir,
                &format!("lib --target-mass 500 -d out --summary done.csv {option}"),
                2,
                &[name],
            );
        }
        std::fs::remove_file(dir.path(name)).unwrap();
    }
}

#[test]
fn an_output_that_is_a_pipe_is_refused() {
    let dir = folder_with_models(2);
    let call = "lib --target-mass 500 -d out --summary done.csv";
    assert_eq!(run_within_20_s(&dir, call).0, Some(0));
    std::fs::remove_file(dir.path("out/even/model00.osim")).unwrap();
    make_pipe(&dir, "out/even/model00.osim");
    assert_refused_soon(&dir, &format!("{call} --resume"), 1, &["model00.osim"]);
    std::fs::remove_file(dir.path("out/even/model00.osim")).unwrap();
    // Also if a backup or a page is a pipe.
    let dir = TestDir::with_human();
    make_pipe(&dir, "human.osim.bak");
    assert_eq!(run_within_20_s(&dir, "human.osim --target-mass 500 --in-place").0, Some(0));
    assert!(dir.has("human.osim.bak2"));
    make_pipe(&dir, "page.html");
    let call = "human.osim --target-mass 400 -d out --summary done.csv --resume --report page.html";
    assert_refused_soon(&dir, call, 2, &["page.html"]);
    std::fs::remove_file(dir.path("page.html")).unwrap();
    std::fs::remove_file(dir.path("human.osim.bak")).unwrap();
}

#[test]
fn a_pipe_in_the_arguments_is_read() {
    let dir = TestDir::new();
    for call in ["pipe.osim --target-mass 500 -o out.osim --force", "inspect pipe.osim"] {
        make_pipe(&dir, "pipe.osim");
        let mut child = start(&dir, call);
        feed_pipe(&dir, &mut child, "pipe.osim", &model_bytes(0), |_| {});
        let (status, text) = wait_for_output(child);
        assert_eq!(status, Some(0), "{call}: {text}");
    }
    // The names that shells give to the output of a command and to standard input.
    dir.write("human.osim", fixture(HUMAN.0));
    dir.write("mouse.osim", model_bytes(1));
    for call in [
        "inspect <(cat human.osim)",
        "inspect <(sleep 0.3; cat human.osim)",
        "inspect /dev/stdin < human.osim",
        "inspect - < human.osim",
        "transfer mouse.osim --from <(cat human.osim) --dry-run --spheres 6 --reference-spheres 6",
    ] {
        let (status, text) = run_within_20_s(&dir, call);
        assert_eq!(status, Some(0), "{call}: {text}");
    }
    let words = ["bash", "-c", "cat human.osim | \"$COMMAND\" inspect /dev/stdin"];
    assert!(shell_command(&dir, &words).output().unwrap().status.success());
}

#[test]
fn a_file_over_2_gib_is_refused() {
    let dir = TestDir::with_human();
    // A file of zeros that takes no room on the disk.
    let large = |name: &str| File::create(dir.path(name)).unwrap().set_len(TOO_MANY_BYTES).unwrap();
    large("large.osim");
    assert_refused_soon(
        &dir,
        "inspect large.osim",
        1,
        &["larger than 2 GiB", "check that it is the right file"],
    );
    assert_refused_soon(&dir, "transfer human.osim --from large.osim", 1, &["larger than 2 GiB"]);
    write_model_that_includes(&dir, "large.osim");
    assert_refused_soon(&dir, "inspect model.osim", 1, &["file=\"large.osim\"", "larger than 2 GiB"]);
    std::fs::remove_file(dir.path("large.osim")).unwrap();
}

#[test]
fn too_many_open_files_are_reported() {
    let dir = folder_with_models(4);
    // How many files the process has open at its start varies, so the test tries every limit up to one that is enough.
    let mut refusals = 0;
    for most in 3..24 {
        let call = "lib --target-mass 500 -d out --force --jobs 8 --summary done.csv --report page.html";
        let script = format!("ulimit -n {most}; exec \"$COMMAND\" {call}");
        let output = shell_command(&dir, &["bash", "-c", &script]).output().unwrap();
        let (_, text) = status_and_output(&output);
        assert!(!text.contains("uncategorized"), "{most}: {text}");
        // With too few the system cannot even start a program, and says so itself.
        if text.contains("oo many open files") && !text.contains("error while loading") {
            assert!(text.contains("ulimit -n"), "{most}: {text}");
            refusals += 1;
        }
    }
    assert!(refusals > 0, "no number of files was too small");
}
