//! What is read: ordinary files up to a size that is known, and pipes only where they were named themselves. Nothing else
//! makes the program wait, or takes memory.

use std::fs::File;
use std::os::unix::fs::symlink;
use std::os::unix::net::UnixListener;
use std::process::Stdio;
use std::time::{Duration, Instant};

use crate::left_over::{dead_process, temporary, this_host};
use crate::library::{ended, feed, library, model, pipe, shell_command, start, told};
use crate::support::{Bench, HUMAN, fixture};

/// A byte more than the most that is read of one file, as `docs/reference/errors.md` says.
const TOO_LARGE: u64 = 2 * 1024 * 1024 * 1024 + 1;

/// Runs a call that must end soon, with 3 GB of memory at most.
#[track_caller]
fn soon(bench: &Bench, call: &str) -> (Option<i32>, String) {
    let script = format!("ulimit -v 3000000; exec \"$COMMAND\" {call}");
    let mut command = shell_command(bench, &["bash", "-c", &script]);
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
    told(&child.wait_with_output().unwrap())
}

/// What a call says that fails soon, with this exit status.
#[track_caller]
fn refused(bench: &Bench, call: &str, status: i32, says: &[&str]) {
    let (got, text) = soon(bench, call);
    assert_eq!(got, Some(status), "{call}: {text}");
    for word in says {
        assert!(text.contains(word), "'{word}' is not in what {call} says:\n{text}");
    }
}

/// A model that includes the file `name`.
fn including(bench: &Bench, name: &str) {
    let text = String::from_utf8(fixture("format/file_forceset.osim")).unwrap();
    assert!(text.contains("standalone_ForceSet.xml"));
    bench.write("model.osim", text.replace("standalone_ForceSet.xml", name));
}

#[test]
fn a_pipe_named_like_a_leftover_stops_no_run() {
    let bench = library(2);
    let name = format!("out/even/{}", temporary(&this_host(), dead_process()));
    bench.write("out/even/other.txt", "");
    pipe(&bench, &name);
    let (status, text) = soon(&bench, "lib --target-mass 500 -d out");
    assert_eq!(status, Some(0), "{text}");
    assert!(bench.path(&name).exists(), "what this program never makes, it does not remove");
    std::fs::remove_file(bench.path(&name)).unwrap();
}

#[test]
fn an_included_pipe_is_not_waited_for() {
    let bench = Bench::new();
    including(&bench, "forces.xml");
    pipe(&bench, "forces.xml");
    for call in ["inspect model.osim", "model.osim --target-mass 500"] {
        refused(&bench, call, 1, &["file=\"forces.xml\"", "pipe"]);
    }
    std::fs::remove_file(bench.path("forces.xml")).unwrap();
}

#[test]
fn an_included_device_is_not_read() {
    let bench = Bench::new();
    for device in ["/dev/zero", "/dev/stdin", "/dev/tty"] {
        including(&bench, device);
        refused(&bench, "inspect model.osim", 1, &["model.osim", &format!("file=\"{device}\"")]);
    }
    including(&bench, "/dev/zero");
    refused(&bench, "inspect model.osim", 1, &["device"]);
    symlink("/dev/zero", bench.path("forces.xml")).unwrap();
    including(&bench, "forces.xml");
    refused(&bench, "inspect model.osim", 1, &["device"]);
    std::fs::remove_file(bench.path("forces.xml")).unwrap();
}

#[test]
fn folders_and_sockets_are_refused_in_plain_words() {
    let bench = Bench::human();
    std::fs::create_dir(bench.path("folder.toml")).unwrap();
    refused(&bench, "transfer human.osim --from folder.toml", 1, &["is a folder"]);
    let _socket = UnixListener::bind(bench.path("socket.osim")).unwrap();
    refused(&bench, "inspect socket.osim", 1, &["socket"]);
    std::fs::remove_file(bench.path("socket.osim")).unwrap();
}

/// Whatever a device gives, it does not end.
#[test]
fn a_device_that_never_ends_is_left_soon() {
    let bench = Bench::human();
    let says = ["16 MiB"];
    refused(&bench, "inspect /dev/zero", 1, &says);
    refused(&bench, "inspect - < /dev/zero", 1, &says);
    refused(&bench, "transfer human.osim --from /dev/zero", 1, &says);
    refused(&bench, "batch /dev/zero", 2, &says);
    refused(&bench, "fit /dev/zero --radius 0.03", 1, &says);
    refused(&bench, "request /dev/zero", 2, &says);
    refused(&bench, "presets --presets /dev/zero", 2, &says);
}

#[test]
fn what_a_table_names_is_an_ordinary_file() {
    let bench = Bench::human();
    pipe(&bench, "pipe.osim");
    bench.write("table.csv", "model,verb,from\nhuman.osim,transfer,pipe.osim\n");
    refused(&bench, "batch table.csv", 2, &["pipe"]);
    bench.write("table.csv", "model,verb,from\nhuman.osim,transfer,/dev/zero\n");
    refused(&bench, "batch table.csv", 2, &["device"]);
    std::fs::remove_file(bench.path("pipe.osim")).unwrap();
}

#[test]
fn a_summary_that_is_a_pipe_is_not_waited_for() {
    for name in ["done.csv", "done.csv.partial"] {
        let bench = library(1);
        pipe(&bench, name);
        for how in ["--resume", "--force"] {
            refused(&bench, &format!("lib --target-mass 500 -d out --summary done.csv {how}"), 2, &[name]);
        }
        std::fs::remove_file(bench.path(name)).unwrap();
    }
}

#[test]
fn an_output_that_is_a_pipe_now_is_not_waited_for() {
    let bench = library(2);
    let call = "lib --target-mass 500 -d out --summary done.csv";
    assert_eq!(soon(&bench, call).0, Some(0));
    std::fs::remove_file(bench.path("out/even/model00.osim")).unwrap();
    pipe(&bench, "out/even/model00.osim");
    refused(&bench, &format!("{call} --resume"), 1, &["model00.osim"]);
    std::fs::remove_file(bench.path("out/even/model00.osim")).unwrap();
    // In the place of a backup and of a page, too.
    let bench = Bench::human();
    pipe(&bench, "human.osim.bak");
    assert_eq!(soon(&bench, "human.osim --target-mass 500 --in-place").0, Some(0));
    assert!(bench.has("human.osim.bak2"));
    pipe(&bench, "page.html");
    let call = "human.osim --target-mass 400 -d out --summary done.csv --resume --report page.html";
    refused(&bench, call, 2, &["page.html"]);
    std::fs::remove_file(bench.path("page.html")).unwrap();
    std::fs::remove_file(bench.path("human.osim.bak")).unwrap();
}

#[test]
fn a_pipe_that_was_named_itself_is_read() {
    let bench = Bench::new();
    for call in ["pipe.osim --target-mass 500 -o out.osim --force", "inspect pipe.osim"] {
        pipe(&bench, "pipe.osim");
        let mut child = start(&bench, call);
        feed(&bench, &mut child, "pipe.osim", &model(0), |_| {});
        let (status, text) = ended(child);
        assert_eq!(status, Some(0), "{call}: {text}");
    }
    // As shells spell a command's output, and standard input.
    bench.write("human.osim", fixture(HUMAN.0));
    bench.write("mouse.osim", model(1));
    for call in [
        "inspect <(cat human.osim)",
        "inspect <(sleep 0.3; cat human.osim)",
        "inspect /dev/stdin < human.osim",
        "inspect - < human.osim",
        "transfer mouse.osim --from <(cat human.osim) --dry-run --spheres 6 --reference-spheres 6",
    ] {
        let (status, text) = soon(&bench, call);
        assert_eq!(status, Some(0), "{call}: {text}");
    }
    let words = ["bash", "-c", "cat human.osim | \"$COMMAND\" inspect /dev/stdin"];
    assert!(shell_command(&bench, &words).output().unwrap().status.success());
}

#[test]
fn a_file_that_is_too_large_is_not_read() {
    let bench = Bench::human();
    // A file of zeros that takes no room on the disk.
    let large = |name: &str| File::create(bench.path(name)).unwrap().set_len(TOO_LARGE).unwrap();
    large("large.osim");
    refused(&bench, "inspect large.osim", 1, &["larger than 2 GiB", "check that it is the right file"]);
    refused(&bench, "transfer human.osim --from large.osim", 1, &["larger than 2 GiB"]);
    including(&bench, "large.osim");
    refused(&bench, "inspect model.osim", 1, &["file=\"large.osim\"", "larger than 2 GiB"]);
    std::fs::remove_file(bench.path("large.osim")).unwrap();
}

#[test]
fn too_many_open_files_are_named() {
    let bench = library(4);
    // What the process has open at its start is not known: every number up to one that is enough.
    let mut named = 0;
    for most in 3..24 {
        let call = "lib --target-mass 500 -d out --force --jobs 8 --summary done.csv --report page.html";
        let script = format!("ulimit -n {most}; exec \"$COMMAND\" {call}");
        let output = shell_command(&bench, &["bash", "-c", &script]).output().unwrap();
        let (_, text) = told(&output);
        assert!(!text.contains("uncategorized"), "{most}: {text}");
        // With too few the system cannot even start a program, and says so itself.
        if text.contains("oo many open files") && !text.contains("error while loading") {
            assert!(text.contains("ulimit -n"), "{most}: {text}");
            named += 1;
        }
    }
    assert!(named > 0, "no number of files was too small");
}
