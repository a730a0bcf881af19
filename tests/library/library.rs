//! Folders of models that differ, and runs that other programs get in the way of.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{Read, Write};
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;

use crate::support::{Bench, fixture, skipped};

pub(crate) type Files = BTreeMap<String, Vec<u8>>;

/// What is built in turn: small and large models of both classes, in old and new spelling.
const FIXTURES: [&str; 5] = [
    "format/v40000.osim",
    "table1/human_62kg_smooth_sphere.osim",
    "format/v30000.osim",
    "table1/human_62kg_hunt_crossley.osim",
    "format/v20001.osim",
];

pub(crate) fn name(number: usize) -> String {
    // In two folders, so that a run has to make folders, too.
    format!("{}/model{number:02}.osim", if number.is_multiple_of(2) { "even" } else { "odd" })
}

/// Model `number`: its bytes are those of no other.
pub(crate) fn model(number: usize) -> Vec<u8> {
    let mut bytes = fixture(FIXTURES[number % FIXTURES.len()]);
    writeln!(bytes, "<!-- model {number} -->").unwrap();
    bytes
}

/// A bench with `count` models in the folder `lib`.
pub(crate) fn library(count: usize) -> Bench {
    let bench = Bench::new();
    for number in 0..count {
        bench.write(&format!("lib/{}", name(number)), model(number));
    }
    bench
}

/// The files whose names begin with `prefix`, named without it.
pub(crate) fn below(files: &Files, prefix: &str) -> Files {
    let strip =
        |(name, bytes): (&String, &Vec<u8>)| Some((name.strip_prefix(prefix)?.to_owned(), bytes.clone()));
    files.iter().filter_map(strip).collect()
}

/// Whether a run that goes on settles it: a temporary file, or what a model and its successor exchanged.
pub(crate) fn is_temporary(name: &str) -> bool {
    let name = name.rsplit('/').next().unwrap_or_default();
    name.starts_with(".osim-contact-scale-") || name.contains(".replaced-")
}

#[track_caller]
pub(crate) fn no_temporary_files(bench: &Bench) {
    let left: Vec<_> = bench.files().into_keys().filter(|name| is_temporary(name)).collect();
    assert!(left.is_empty(), "left behind: {left:?}");
}

/// One column of a summary in CSV, top to bottom, with the model's file name.
pub(crate) fn column(summary: &str, column: &str) -> BTreeMap<String, String> {
    let mut reader = csv::Reader::from_reader(summary.as_bytes());
    let headers = reader.headers().unwrap().clone();
    let at = |wanted: &str| headers.iter().position(|header| header == wanted).unwrap();
    let (model, wanted) = (at("model"), at(column));
    let row = |row: csv::StringRecord| {
        let name = row[model].rsplit('/').next().unwrap().to_owned();
        (name, row[wanted].to_owned())
    };
    reader.records().map(|record| row(record.unwrap())).collect()
}

/// A pipe with a name. The command reads it like a file, and waits there until [`feed`] lets it go on.
pub(crate) fn pipe(bench: &Bench, name: &str) {
    let made = Command::new("mkfifo").arg(bench.path(name)).status().unwrap();
    assert!(made.success());
}

/// Waits until `child` reads the pipe `name`: the end into which to write.
#[track_caller]
pub(crate) fn opened(bench: &Bench, child: &mut Child, name: &str) -> File {
    let path = bench.path(name);
    let opening = std::thread::spawn(move || File::options().write(true).open(path).unwrap());
    while !opening.is_finished() {
        if child.try_wait().unwrap().is_some() {
            // Nobody will ever read it: let the thread go.
            drop(File::options().read(true).write(true).open(bench.path(name)));
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
pub(crate) fn feed(
    bench: &Bench,
    child: &mut Child,
    name: &str,
    bytes: &[u8],
    meanwhile: impl FnOnce(&Child),
) {
    let mut pipe = opened(bench, child, name);
    meanwhile(child);
    pipe.write_all(bytes).unwrap();
    // What looks at all files later must not wait here.
    std::fs::remove_file(bench.path(name)).unwrap();
}

/// Starts a run whose outputs [`ended`] collects.
pub(crate) fn start(bench: &Bench, arguments: &str) -> Child {
    bench.command(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

/// Exit status and both streams of a run.
pub(crate) fn ended(child: Child) -> (Option<i32>, String) {
    told(&child.wait_with_output().unwrap())
}

pub(crate) fn told(output: &Output) -> (Option<i32>, String) {
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code(), format!("{}{}", text(&output.stdout), text(&output.stderr)))
}

/// Runs `script` in the bench by the shell, with the command as `$COMMAND`.
pub(crate) fn shell(bench: &Bench, script: &str) -> (Option<i32>, String) {
    told(&shell_command(bench, &["sh", "-c", script]).output().unwrap())
}

/// The same within programs that prepare something.
pub(crate) fn shell_command(bench: &Bench, words: &[&str]) -> Command {
    let mut command = Command::new(words[0]);
    command
        .args(&words[1..])
        .current_dir(bench.path("."))
        .stdin(Stdio::null())
        .env("COMMAND", env!("CARGO_BIN_EXE_osim-contact-scale"))
        // The date of notes does not change at midnight.
        .env("SOURCE_DATE_EPOCH", "1764115200")
        .env("NO_COLOR", "1");
    command
}

/// Words to put before a call so that permissions bind it, also where the tests run as root; `None` after saying that
/// this machine has no way to do that.
pub(crate) fn bound_by_permissions(bench: &Bench, test: &str) -> Option<Vec<&'static str>> {
    use std::os::unix::fs::PermissionsExt;
    let root =
        String::from_utf8(Command::new("id").arg("-u").output().unwrap().stdout).unwrap().trim() == "0";
    if !root {
        return Some(Vec::new());
    }
    std::fs::set_permissions(bench.path("."), PermissionsExt::from_mode(0o777)).unwrap();
    let words = vec!["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups", "--"];
    let mut probe = words.clone();
    probe.extend(["sh", "-c", "\"$COMMAND\" --version && test -r lib && touch probe && rm probe"]);
    if shell_command(bench, &probe).output().is_ok_and(|output| output.status.success()) {
        return Some(words);
    }
    skipped(test, "the tests run as root, whom no permissions bind, and setpriv cannot change that");
    None
}
