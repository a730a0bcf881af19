//! The structure of this project; `src/lib.rs` says what each rule means, `src/floors.rs` has the table of crates.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::fs;
use std::io::{Write, stderr};
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use house_rules::floors::FLOORS;
use house_rules::project::Project;
use house_rules::{circles, floors, sizes, texts};

/// The one place below the front ends that spells options: a file, or a folder with `/` at its end.
const SPELLER: &str = "crates/osim-requests/src/spell/";

/// Crates that may name files, processes and streams of the system. Printing is clippy's.
const OUTSIDE: &[&str] = &["osim-contact-scale", "osim-library"];

/// osim-python names it only so that Cargo compiles their libraries once for the wheel, which has both.
const BUILT_TOGETHER: &str = "osim-contact-scale";

static PROJECT: LazyLock<Project> =
    LazyLock::new(|| Project::read(&root()).unwrap_or_else(|error| panic!("{error}")));

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

#[track_caller]
fn nothing(found: &[String], what: &str) {
    assert!(found.is_empty(), "{} {what}:\n{}\n", found.len(), found.join("\n"));
}

#[test]
fn modules_go_round_in_no_circle() {
    nothing(&PROJECT.found(circles::circles, &[]), "circles");
}

#[test]
fn crates_point_downwards() {
    let mut crates = floors::crates(&root().join("crates")).unwrap();
    crates.get_mut("osim-python").unwrap().retain(|name| name != BUILT_TOGETHER);
    let calls =
        |file: &&String| fs::read_to_string(root().join(file)).unwrap().contains("osim_contact_scale::");
    let of_python = PROJECT.lines.keys().filter(|file| file.starts_with("crates/osim-python/"));
    nothing(
        &of_python.filter(calls).cloned().collect::<Vec<_>>(),
        "files of osim-python that call the command",
    );
    nothing(&floors::faults(FLOORS, &crates), "faults in the arrows between crates");
}

#[test]
fn options_are_spelled_by_the_front_ends() {
    assert!(root().join(SPELLER).exists(), "{SPELLER}");
    let mut named = PROJECT.found(texts::options, FLOORS.last().unwrap());
    named.retain(|option| !option.starts_with(SPELLER));
    nothing(&named, "options below the front ends");
}

#[test]
fn only_the_library_and_the_command_know_the_system() {
    nothing(&PROJECT.found(texts::outside, OUTSIDE), "uses of files, processes or streams");
}

/// Fails never; straight to standard error, which tests that pass do not hide.
#[test]
fn what_has_grown_large() {
    let large = sizes::large(&PROJECT.lines);
    writeln!(stderr(), "places to look, since they are large: {}\n  {}", large.len(), large.join("\n  "))
        .unwrap();
}
