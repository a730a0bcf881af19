//! A folder with models, in which a test runs the command, and the result of such a run.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Stdio;

use tempfile::TempDir;

#[path = "schema_validation.rs"]
pub(crate) mod schema_validation;

/// The human of 62 kg with smoothed contacts, under the name that most tests use.
pub(crate) const HUMAN: (&str, &str) = ("table1/human_62kg_smooth_sphere.osim", "human.osim");

/// The top of the repository.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

pub(crate) fn fixture(name: &str) -> Vec<u8> {
    std::fs::read(root().join("fixtures").join(name))
        .unwrap_or_else(|error| panic!("fixtures/{name}: {error}"))
}

/// The folder of published models, or `None` after reporting that the test is skipped.
pub(crate) fn corpus_folder(test: &str) -> Option<PathBuf> {
    let folder = std::env::var_os("OSIM_CORPUS").map(PathBuf::from).filter(|folder| folder.is_dir());
    if folder.is_none() {
        report_skip(test, "OSIM_CORPUS is not set to the folder of real models");
    }
    folder
}

/// Reports that `test`, or a part of it, is skipped. `.ci/run` compares such lines with `tests/skips.txt`.
pub(crate) fn report_skip(test: &str, why: &str) {
    let line = format!("skipped: {test}: {why}\n");
    // Straight to the terminal: the test harness does not show what a passing test prints.
    let _ = std::io::Write::write_all(&mut std::io::stderr(), line.as_bytes());
}

/// A temporary folder for one test.
pub(crate) struct TestDir {
    dir: TempDir,
}

type Files = BTreeMap<String, Vec<u8>>;

impl TestDir {
    pub(crate) fn new() -> Self {
        Self { dir: tempfile::tempdir().unwrap() }
    }

    /// A temporary folder with copies of fixtures, each `(fixture, name of the copy)`.
    pub(crate) fn with(fixtures: &[(&str, &str)]) -> Self {
        let dir = Self::new();
        for (from, to) in fixtures {
            dir.write(to, fixture(from));
        }
        dir
    }

    pub(crate) fn with_human() -> Self {
        Self::with(&[HUMAN])
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.dir.path().join(name)
    }

    pub(crate) fn write(&self, name: &str, bytes: impl AsRef<[u8]>) {
        let path = self.path(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, bytes).unwrap();
    }

    #[track_caller]
    pub(crate) fn read(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    #[track_caller]
    pub(crate) fn text(&self, name: &str) -> String {
        String::from_utf8(self.read(name)).unwrap()
    }

    pub(crate) fn has(&self, name: &str) -> bool {
        self.path(name).exists()
    }

    /// Every file below the folder, with its bytes; links are followed.
    pub(crate) fn files(&self) -> Files {
        fn walk(folder: &Path, prefix: &str, files: &mut Files) {
            for entry in std::fs::read_dir(folder).unwrap() {
                let entry = entry.unwrap();
                let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
                if entry.path().is_dir() {
                    walk(&entry.path(), &format!("{name}/"), files);
                } else {
                    files.insert(name, std::fs::read(entry.path()).unwrap_or_default());
                }
            }
        }
        let mut files = Files::new();
        walk(self.dir.path(), "", &mut files);
        files
    }

    /// Runs the command with `arguments`, split at blanks.
    pub(crate) fn run(&self, arguments: &str) -> CommandRun {
        self.run_with_stdin(arguments, b"")
    }

    /// Runs the command with bytes on standard input.
    pub(crate) fn run_with_stdin(&self, arguments: &str, stdin: &[u8]) -> CommandRun {
        let before = self.files();
        let output = assert_cmd::Command::from(self.command(arguments)).write_stdin(stdin).output().unwrap();
        let mut changed: Vec<String> = Vec::new();
        let after = self.files();
        for (name, bytes) in &after {
            if before.get(name) != Some(bytes) {
                changed.push(name.clone());
                schema_validation::validate_file(name, bytes);
            }
        }
        // Partial tables, and those of parts of a sweep, may disappear when the whole table is written.
        let is_part =
            |name: &str| name.ends_with(".csv") && (name.contains(".point-") || name.contains(".shard-"));
        let stays = |name: &&String| !name.ends_with(".partial") && !is_part(name);
        let lost: Vec<_> = before.keys().filter(stays).filter(|name| !after.contains_key(*name)).collect();
        assert!(lost.is_empty(), "files are gone: {lost:?}");
        schema_validation::validate_stdout(arguments, &output.stdout);
        CommandRun {
            call: format!("osim-contact-scale {arguments}"),
            folder: self.dir.path().canonicalize().unwrap(),
            status: output.status.code(),
            stdout: output.stdout,
            stderr: output.stderr,
            changed,
        }
    }

    /// Runs the command with arguments that may contain blanks.
    pub(crate) fn run_words(&self, words: &[&str]) -> std::process::Output {
        let mut command = self.command("");
        command.args(words);
        let output = command.output().unwrap();
        schema_validation::validate_stdout(&words.join(" "), &output.stdout);
        output
    }

    /// The command, ready to be spawned.
    pub(crate) fn command(&self, arguments: &str) -> std::process::Command {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_osim-contact-scale"));
        command
            .args(split_arguments(arguments))
            .current_dir(self.dir.path())
            .stdin(Stdio::null())
            .env_remove("COLUMNS")
            // The date of notes: 2025-11-26.
            .env("SOURCE_DATE_EPOCH", "1764115200")
            .env_remove("CLICOLOR_FORCE")
            .env("NO_COLOR", "1");
        command
    }
}

/// Splits arguments as a shell does if some are quoted, and else at blanks, because paths of Windows have backslashes.
fn split_arguments(arguments: &str) -> Vec<String> {
    if arguments.contains('"') {
        shlex::split(arguments).unwrap()
    } else {
        arguments.split_whitespace().map(str::to_owned).collect()
    }
}

/// What a run of the command printed, and its exit status.
pub(crate) struct CommandRun {
    call: String,
    folder: PathBuf,
    pub(crate) status: Option<i32>,
    pub(crate) stdout: Vec<u8>,
    pub(crate) stderr: Vec<u8>,
    /// New files and files with other bytes than before.
    pub(crate) changed: Vec<String>,
}

impl CommandRun {
    pub(crate) fn out(&self) -> String {
        String::from_utf8(self.stdout.clone()).expect("standard output is UTF-8")
    }

    pub(crate) fn err(&self) -> String {
        String::from_utf8(self.stderr.clone()).expect("standard error is UTF-8")
    }

    #[track_caller]
    pub(crate) fn exited_with(self, status: i32) -> Self {
        assert_eq!(self.status, Some(status), "{}\n{}{}", self.call, self.out(), self.err());
        self
    }

    /// Fails unless the exit status is 0.
    #[track_caller]
    pub(crate) fn succeeded(self) -> Self {
        self.exited_with(0)
    }

    /// Fails unless the exit status is 1: a model failed.
    #[track_caller]
    pub(crate) fn failed(self) -> Self {
        self.exited_with(1)
    }

    /// Fails unless the exit status is 2: wrong usage.
    #[track_caller]
    pub(crate) fn usage_error(self) -> Self {
        self.exited_with(2)
    }

    /// Fails unless exactly these files are new or have other bytes than before.
    #[track_caller]
    pub(crate) fn wrote(self, files: &[&str]) -> Self {
        assert_eq!(self.changed, files, "{}\n{}{}", self.call, self.out(), self.err());
        self
    }

    /// Fails if the run wrote a file.
    #[track_caller]
    pub(crate) fn wrote_nothing(self) -> Self {
        self.wrote(&[])
    }

    /// Fails unless the run printed all of `words`, on either stream.
    #[track_caller]
    pub(crate) fn says(self, words: &[&str]) -> Self {
        let text = format!("{}{}", self.out(), self.err());
        for word in words {
            assert!(text.contains(word), "'{word}' is not in:\n{text}");
        }
        self
    }

    /// Fails if the run printed one of `words`, on either stream.
    #[track_caller]
    pub(crate) fn says_not(self, words: &[&str]) -> Self {
        let text = format!("{}{}", self.out(), self.err());
        for word in words {
            assert!(!text.contains(word), "'{word}' is in:\n{text}");
        }
        self
    }

    /// The arguments, exit status, output and written files of the run, as text for a snapshot.
    fn transcript(&self) -> String {
        let mut text = format!("$ {}\n", self.call);
        let status = self.status.map_or("killed".to_owned(), |status| status.to_string());
        text.push_str(&format!("exit status {status}; "));
        if self.changed.is_empty() {
            text.push_str("nothing written\n");
        } else {
            text.push_str(&format!("written: {}\n", self.changed.join(", ")));
        }
        for (name, stream) in [("standard output", self.out()), ("standard error", self.err())] {
            if !stream.is_empty() {
                text.push_str(&format!("----- {name}\n{stream}"));
            }
        }
        let text = text.replace(&self.folder.display().to_string(), "[FOLDER]");
        let text = without_temporary_names(&text);
        text.replace(
            concat!("osim-contact-scale ", env!("CARGO_PKG_VERSION")),
            "osim-contact-scale [VERSION]",
        )
    }

    /// Compares the run with `tests/snapshots/NAME.snap`.
    #[track_caller]
    pub(crate) fn matches_snapshot(self, name: &str) -> Self {
        assert_snapshot(name, &self.transcript());
        self
    }
}

/// Compares a text with `tests/snapshots/NAME.snap`.
#[track_caller]
pub(crate) fn assert_snapshot(name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("tests/snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

/// The text with fixed names in place of temporary names, which end in six random letters.
fn without_temporary_names(text: &str) -> String {
    const START_OF_TEMPORARY_NAMES: &str = "/.osim-contact-scale-";
    let mut parts = text.split(START_OF_TEMPORARY_NAMES);
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        out.push_str("/[TEMPORARY]");
        out.push_str(part.trim_start_matches(|c: char| c.is_ascii_alphanumeric()));
    }
    out
}
