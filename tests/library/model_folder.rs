//! Helpers of tests: folders of different models, and runs that other programs disturb.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{Read, Write};
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;

use crate::support::{TestDir, fixture, report_skip};

pub(crate) type Files = BTreeMap<String, Vec<u8>>;

/// The fixtures that models of a folder are copied from: small and large models of both classes, in old and new format.
const FIXTURES: [&str; 5] = [
    "format/v40000.osim",
    "table1/human_62kg_smooth_sphere.osim",
    "format/v30000.osim",
    "table1/human_62kg_hunt_crossley.osim",
    "format/v20001.osim",
];

pub(crate) fn model_name(number: usize) -> String {
    // In two folders, so that a run has to make folders, too.
    format!("{}/model{number:02}.osim", if number.is_multiple_of(2) { "even" } else { "odd" })
}

/// The bytes of model `number`, which differ from those of all other models.
pub(crate) fn model_bytes(number: usize) -> Vec<u8> {
    let mut bytes = fixture(FIXTURES[number % FIXTURES.len()]);
    writeln!(bytes, "<!-- model {number} -->").unwrap();
    bytes
}

/// A folder with `count` models in its folder `lib`.
pub(crate) fn folder_with_models(count: usize) -> TestDir {
    let dir = TestDir::new();
    for number in 0..count {
        dir.write(&format!("lib/{}", model_name(number)), model_bytes(number));
    }
    dir
}

/// The files whose names begin with `prefix`, with the prefix removed from the names.
pub(crate) fn files_below(files: &Files, prefix: &str) -> Files {
    let strip =
        |(name, bytes): (&String, &Vec<u8>)| Some((name.strip_prefix(prefix)?.to_owned(), bytes.clone()));
    files.iter().filter_map(strip).collect()
}

/// Whether a resumed run removes the file: a temporary file, or an old file that was exchanged with its new version.
pub(crate) fn is_temporary(name: &str) -> bool {
    let name = name.rsplit('/').next().unwrap_or_default();
    name.starts_with(".osim-contact-scale-") || name.contains(".replaced-")
}

#[track_caller]
pub(crate) fn assert_no_temporary_files(dir: &TestDir) {
    let temporary: Vec<_> = dir.files().into_keys().filter(|name| is_temporary(name)).collect();
    assert!(temporary.is_empty(), "left behind: {temporary:?}");
}

/// One column of a summary in CSV, top to bottom, with the model's file name.
pub(crate) fn column_by_model(summary: &str, column: &str) -> BTreeMap<String, String> {
    let mut reader = csv::Reader::from_reader(summary.as_bytes());
    let headers = reader.headers().unwrap().clone();
    let index_of = |wanted_column: &str| headers.iter().position(|header| header == wanted_column).unwrap();
    let (model, wanted_column) = (index_of("model"), index_of(column));
    let row = |row: csv::StringRecord| {
        let name = row[model].rsplit('/').next().unwrap().to_owned();
        (name, row[wanted_column].to_owned())
    };
    reader.records().map(|record| row(record.unwrap())).collect()
}

/// Makes a named pipe. The command reads it like a file, and waits until [`feed_pipe`] writes to it.
pub(crate) fn make_pipe(dir: &TestDir, name: &str) {
    let status = Command::new("mkfifo").arg(dir.path(name)).status().unwrap();
    assert!(status.success());
}

/// Waits until `child` reads the pipe `name`: the end into which to write.
#[track_caller]
pub(crate) fn open_pipe_when_read(dir: &TestDir, child: &mut Child, name: &str) -> File {
    let path = dir.path(name);
    let opening = std::thread::spawn(move || File::options().write(true).open(path).unwrap());
    while !opening.is_finished() {
        if child.try_wait().unwrap().is_some() {
            // No process will read the pipe: end the thread.
            drop(File::options().read(true).write(true).open(dir.path(name)));
            let mut text = String::new();
            child.stderr.take().unwrap().read_to_string(&mut text).unwrap();
            panic!("the command ended before it read {name}: {text}");
        }
        std::thread::sleep(Duration::from_millis(1));
    }
    opening.join().unwrap()
}

/// Waits until `child` reads the pipe `name`, does `meanwhile`, and writes `bytes` into it.
#[track_caller]
pub(crate) fn feed_pipe(
    dir: &TestDir,
    child: &mut Child,
    name: &str,
    bytes: &[u8],
    meanwhile: impl FnOnce(&Child),
) {
    let mut pipe = open_pipe_when_read(dir, child, name);
    meanwhile(child);
    pipe.write_all(bytes).unwrap();
    // Without this, a later look at all files would wait for the pipe.
    std::fs::remove_file(dir.path(name)).unwrap();
}

/// Starts a run whose output [`wait_for_output`] returns.
pub(crate) fn start(dir: &TestDir, arguments: &str) -> Child {
    dir.command(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

/// Exit status and both streams of a run.
pub(crate) fn wait_for_output(child: Child) -> (Option<i32>, String) {
    status_and_output(&child.wait_with_output().unwrap())
}

pub(crate) fn status_and_output(output: &Output) -> (Option<i32>, String) {
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code(), format!("{}{}", text(&output.stdout), text(&output.stderr)))
}

/// Runs `script` in the folder by the shell, with the command as `$COMMAND`.
pub(crate) fn run_shell(dir: &TestDir, script: &str) -> (Option<i32>, String) {
    status_and_output(&shell_command(dir, &["sh", "-c", script]).output().unwrap())
}

/// The command that runs `words` in the folder, with the path of the program in `$COMMAND`.
pub(crate) fn shell_command(dir: &TestDir, words: &[&str]) -> Command {
    let mut command = Command::new(words[0]);
    command
        .args(&words[1..])
        .current_dir(dir.path("."))
        .stdin(Stdio::null())
        .env("COMMAND", env!("CARGO_BIN_EXE_osim-contact-scale"))
        // The date of notes does not change at midnight.
        .env("SOURCE_DATE_EPOCH", "1764115200")
        .env("NO_COLOR", "1");
    command
}

/// The beginning of a command line that runs a call without the rights of root, if the tests run as root. `None` after reporting a
/// skipped test, if the machine cannot do this.
pub(crate) fn unprivileged_prefix(dir: &TestDir, test: &str) -> Option<Vec<&'static str>> {
    use std::os::unix::fs::PermissionsExt;
    let root =
        String::from_utf8(Command::new("id").arg("-u").output().unwrap().stdout).unwrap().trim() == "0";
    if !root {
        return Some(Vec::new());
    }
    std::fs::set_permissions(dir.path("."), PermissionsExt::from_mode(0o777)).unwrap();
    let words = vec!["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups", "--"];
    let mut probe = words.clone();
    probe.extend(["sh", "-c", "\"$COMMAND\" --version && test -r lib && touch probe && rm probe"]);
    if shell_command(dir, &probe).output().is_ok_and(|output| output.status.success()) {
        return Some(words);
    }
    report_skip(test, "the tests run as root, whom no permissions bind, and setpriv cannot change that");
    None
}
