//! The structure of this project. [`house_rules`] says what each rule means.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test fails by panicking"
)]

use std::fmt::Display;
use std::path::Path;
use std::sync::LazyLock;

use house_rules::{Ban, Limits, Workspace};

/// From the lowest to the highest. Crates of one layer do not know each other.
const LAYERS: &[&[&str]] = &[
    &["contact-plots", "contact-scaling", "house-rules", "osim-frames", "osim-wording", "osim-xml"],
    &["osim-model"],
    &["osim-feet", "osim-patch"],
    &["osim-inspect"],
    &["osim-values"],
    &["osim-options"],
    &["osim-remarks"],
    &["osim-requests"],
    &["osim-figures", "osim-states"],
    &["osim-library", "osim-report"],
    &["osim-runs", "osim-web"],
    &["osim-contact-scale"],
    &["osim-python"],
];

/// Crates that do not know the command line.
const LIBRARIES: &[&str] = &[
    "contact-plots",
    "contact-scaling",
    "osim-feet",
    "osim-figures",
    "osim-frames",
    "osim-inspect",
    "osim-library",
    "osim-model",
    "osim-options",
    "osim-patch",
    "osim-python",
    "osim-remarks",
    "osim-report",
    "osim-requests",
    "osim-runs",
    "osim-states",
    "osim-values",
    "osim-web",
    "osim-wording",
    "osim-xml",
];

/// The one file below the command that spells options: the dialect of the command line.
const SPELLS_OPTIONS: &str = "osim-report/src/dialect/command_line.rs";

/// The terminal.
const TERMINAL: &[&str] =
    &["std::io::stderr", "std::io::stdout", "print!", "println!", "eprint!", "eprintln!", "dbg!"];

/// The world outside of the program: files, variables, processes, the terminal.
const OUTSIDE: &[&str] = &[
    "std::env",
    "std::fs",
    "std::net",
    "std::process",
    "std::io::stderr",
    "std::io::stdin",
    "std::io::stdout",
    "print!",
    "println!",
    "eprint!",
    "eprintln!",
    "dbg!",
];

const BANS: &[Ban<'_>] = &[
    Ban {
        in_crate: "contact-scaling",
        dependencies: &["clap", "quick-xml", "serde", "serde_json", "toml"],
        paths: OUTSIDE,
    },
    Ban {
        in_crate: "contact-plots",
        dependencies: &["clap", "contact-scaling", "osim-model", "quick-xml", "serde", "toml"],
        paths: OUTSIDE,
    },
    Ban { in_crate: "osim-wording", dependencies: &["clap", "serde", "toml", "walkdir"], paths: OUTSIDE },
    Ban { in_crate: "osim-frames", dependencies: &["clap", "serde", "toml", "walkdir"], paths: OUTSIDE },
    Ban { in_crate: "osim-xml", dependencies: &["clap", "serde", "toml", "walkdir"], paths: OUTSIDE },
    Ban {
        in_crate: "osim-model",
        dependencies: &["clap", "quick-xml", "serde", "toml", "walkdir"],
        paths: OUTSIDE,
    },
    Ban { in_crate: "osim-feet", dependencies: &["clap", "maud", "toml", "walkdir"], paths: OUTSIDE },
    Ban { in_crate: "osim-patch", dependencies: &["clap", "quick-xml", "serde", "toml"], paths: OUTSIDE },
    Ban { in_crate: "osim-inspect", dependencies: &["clap", "maud", "quick-xml", "toml"], paths: OUTSIDE },
    Ban { in_crate: "osim-values", dependencies: &["clap", "maud", "quick-xml", "walkdir"], paths: OUTSIDE },
    Ban { in_crate: "osim-options", dependencies: &["maud", "quick-xml", "walkdir"], paths: OUTSIDE },
    Ban { in_crate: "osim-remarks", dependencies: &["clap", "maud", "quick-xml", "walkdir"], paths: OUTSIDE },
    Ban { in_crate: "osim-requests", dependencies: &["maud", "quick-xml", "walkdir"], paths: OUTSIDE },
    Ban { in_crate: "osim-states", dependencies: &["clap", "maud", "quick-xml", "walkdir"], paths: OUTSIDE },
    Ban { in_crate: "osim-figures", dependencies: &["clap", "maud", "quick-xml", "walkdir"], paths: OUTSIDE },
    Ban { in_crate: "osim-report", dependencies: &["clap", "quick-xml", "toml", "walkdir"], paths: OUTSIDE },
    Ban { in_crate: "osim-library", dependencies: &["clap", "maud", "quick-xml"], paths: TERMINAL },
    Ban { in_crate: "osim-runs", dependencies: &["clap", "maud", "quick-xml"], paths: TERMINAL },
    Ban {
        in_crate: "osim-python",
        dependencies: &["clap", "maud", "quick-xml", "rayon", "toml", "walkdir"],
        paths: OUTSIDE,
    },
    Ban {
        in_crate: "osim-web",
        dependencies: &["clap", "maud", "quick-xml", "rayon", "toml", "walkdir"],
        paths: OUTSIDE,
    },
    Ban {
        in_crate: "osim-contact-scale",
        dependencies: &["contact-scaling", "quick-xml", "rayon", "walkdir"],
        paths: &[],
    },
];

/// Read once for all tests.
static PROJECT: LazyLock<Workspace> = LazyLock::new(|| {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    Workspace::read(&root).unwrap_or_else(|error| panic!("{error}"))
});

#[track_caller]
fn nothing(found: &[impl Display], what: &str) {
    let shown: Vec<String> = found.iter().map(ToString::to_string).collect();
    assert!(shown.is_empty(), "{} {what}:\n{}\n", shown.len(), shown.join("\n"));
}

#[test]
fn modules_go_round_in_no_circle() {
    nothing(&PROJECT.circles(), "circles");
}

#[test]
fn crates_point_downwards() {
    nothing(&PROJECT.arrows(LAYERS), "arrows");
}

#[test]
fn libraries_do_without_the_world_outside() {
    nothing(&PROJECT.banned(BANS).unwrap(), "things that a crate must do without");
}

#[test]
fn nothing_is_too_large() {
    nothing(&PROJECT.too_large(&Limits::default()), "sizes");
}

#[test]
fn libraries_name_no_option() {
    let mut named = PROJECT.options_named(LIBRARIES).unwrap();
    named.retain(|option| !option.file.replace('\\', "/").ends_with(SPELLS_OPTIONS));
    nothing(&named, "options");
}
