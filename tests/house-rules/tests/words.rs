//! The words of the project: `words.toml` says which texts must not use, and what to write instead.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test fails by panicking"
)]

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use house_rules::{Forbidden, Words, Workspace};
use walkdir::WalkDir;

static WORDS: LazyLock<Words> = LazyLock::new(|| {
    let list = Path::new(env!("CARGO_MANIFEST_DIR")).join("words.toml");
    Words::read(&list).unwrap_or_else(|error| panic!("{error}"))
});

/// The heading of what is not released yet: only there can a change log be corrected.
const UNRELEASED: &str = "## [Unreleased]";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Files in a folder of the project with this ending, as findings show them, with their texts.
fn texts(folder: &str, ending: &str) -> Vec<(String, String)> {
    let root = root();
    let entries = WalkDir::new(root.join(folder)).sort_by_file_name();
    let files = entries.into_iter().map(Result::unwrap).filter(|entry| entry.file_type().is_file());
    let files = files.filter(|entry| entry.path().extension().is_some_and(|found| found == ending));
    files
        .map(|entry| {
            let shown = entry.path().strip_prefix(&root).unwrap().to_str().unwrap().replace('\\', "/");
            (shown, fs::read_to_string(entry.path()).unwrap())
        })
        .collect()
}

#[track_caller]
fn nothing(found: &[Forbidden]) {
    let shown: Vec<String> = found.iter().map(ToString::to_string).collect();
    assert!(
        shown.is_empty(),
        "{} words that tests/house-rules/words.toml forbids:\n{}\n",
        shown.len(),
        shown.join("\n")
    );
}

/// What people read of a change log: up to the first release.
fn unreleased(text: &str) -> String {
    let begin = text.find(UNRELEASED).unwrap_or_else(|| panic!("CHANGELOG.md: no '{UNRELEASED}'"));
    let end = text[begin + 1..].find("\n## ").map_or(text.len(), |end| begin + 1 + end);
    text[..end].to_owned()
}

#[test]
fn texts_and_doc_comments() {
    let workspace = Workspace::read(&root()).unwrap_or_else(|error| panic!("{error}"));
    let mut found = workspace.forbidden(&WORDS);
    found.retain(|found| found.file.starts_with("crates/"));
    nothing(&found);
}

#[test]
fn docs() {
    let mut pages = texts("docs", "md");
    assert!(pages.len() > 20, "{}", pages.len());
    pages.extend(texts("crates", "md"));
    for name in ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"] {
        let text = fs::read_to_string(root().join(name)).unwrap();
        let text = if name == "CHANGELOG.md" { unreleased(&text) } else { text };
        pages.push((name.to_owned(), text));
    }
    let found: Vec<Forbidden> = pages.iter().flat_map(|(file, text)| WORDS.in_prose(file, text)).collect();
    nothing(&found);
}

#[test]
fn schemas() {
    let schemas = texts("schemas", "json");
    assert!(schemas.len() > 20, "{}", schemas.len());
    let found: Vec<Forbidden> = schemas.iter().flat_map(|(file, text)| WORDS.in_schema(file, text)).collect();
    nothing(&found);
}

/// Each word of the list is refused in its examples, and passes where the list says so.
#[test]
fn examples() {
    for example in WORDS.examples() {
        let text = example.text;
        let found =
            if example.is_field { WORDS.in_schema("file", text) } else { WORDS.in_prose("file", text) };
        let found: Vec<&str> = found.iter().map(|found| found.say.as_str()).collect();
        match example.say {
            Some(say) => assert!(found.contains(&say), "passes: {text}"),
            None => assert!(found.is_empty(), "refused: {text}"),
        }
    }
}
