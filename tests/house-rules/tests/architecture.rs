//! `docs/developers/architecture.md` agrees with the tree: what it names is there, and every crate has its paragraph.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::fs;
use std::path::{Path, PathBuf};

const PAGE: &str = "docs/developers/architecture.md";

/// A code span that begins so is a path from the project's root.
const FOLDERS: &[&str] = &[
    "crates/",
    "demonstrations/",
    "dev/",
    "docs/",
    "fixtures/",
    "fuzz/",
    "matlab/",
    "python/",
    "schemas/",
    "tests/",
    "web/",
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The paths that a page names in code spans, each with its line. Those with blanks, `*` or `<` are not paths but examples.
fn paths(text: &str) -> Vec<(usize, &str)> {
    let spans = (1..)
        .zip(text.lines())
        .flat_map(|(line, text)| text.split('`').skip(1).step_by(2).map(move |span| (line, span)));
    spans
        .filter(|(_, span)| {
            FOLDERS.iter().any(|folder| span.starts_with(folder)) && !span.contains([' ', '*', '<', '{'])
        })
        .collect()
}

/// Whether a line begins with the name of a crate in a code span, alone or in its path; signs of headings, lists and tables aside.
fn begins_with(line: &str, name: &str) -> bool {
    let line = line.trim_start_matches(|c: char| c.is_ascii_whitespace() || "#*-|>".contains(c));
    let span = line.strip_prefix('`').and_then(|rest| rest.split('`').next()).unwrap_or_default();
    span.trim_start_matches("crates/").trim_end_matches(['/', ':']).trim_end_matches("/src") == name
}

#[test]
fn every_path_is_there() {
    let text = fs::read_to_string(root().join(PAGE)).unwrap();
    let lost: Vec<String> = paths(&text)
        .into_iter()
        .filter(|(_, path)| !root().join(path).exists())
        .map(|(line, path)| format!("{PAGE}:{line}: {path}"))
        .collect();
    assert!(paths(&text).len() > 10, "{PAGE}: {} paths", paths(&text).len());
    assert!(lost.is_empty(), "{} paths lead nowhere:\n{}\n", lost.len(), lost.join("\n"));
}

#[test]
fn every_crate_has_its_paragraph() {
    let text = fs::read_to_string(root().join(PAGE)).unwrap();
    let crates = fs::read_dir(root().join("crates"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let lost: Vec<String> = crates.filter(|name| !text.lines().any(|line| begins_with(line, name))).collect();
    assert!(
        lost.is_empty(),
        "{PAGE}: no paragraph begins with the name of these crates in backticks: {lost:?}"
    );
}

#[test]
fn paths_and_paragraphs_are_found() {
    let page = "See `crates/a/src/`, `docs/*.md` and `a/b`.\n`tests/c.rs`, `dev/x y`";
    assert_eq!(paths(page), [(1, "crates/a/src/"), (2, "tests/c.rs")]);
    for line in ["`a`: b", "- **`crates/a/`** b", "### `crates/a`", "| `a` | b |", "`crates/a/src/` b"] {
        assert!(begins_with(line, "a"), "{line}");
    }
    for line in ["see `a`", "`ab`", "a", "`crates/a/src/b.rs`"] {
        assert!(!begins_with(line, "a"), "{line}");
    }
}
