//! Runs every ```` ```console ```` example of README.md and docs/ from the top of the repository, and compares its output.
//!
//! "The top of the repository" is a temporary folder with a copy of `fixtures/`, so that examples may write files. A command that
//! names a fixture must be in a `console` block, because a command that is never run may be wrong for years. To write the present
//! output into the documents: `TRYCMD=overwrite cargo test --test documents`, then read the difference.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap()
}

fn copy_fixtures(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let target = to.join(entry.file_name());
        if entry.path().is_dir() {
            copy_fixtures(&entry.path(), &target);
        } else if !is_result(&target) {
            // What a reader's commands wrote stays behind: the examples start from the fixtures alone.
            std::fs::copy(entry.path(), target).unwrap();
        }
    }
}

/// Whether a documented command wrote the file at `path`: such names are in `.gitignore`.
fn is_result(path: &Path) -> bool {
    path.to_string_lossy().ends_with(".scaled.osim")
        || path.parent().is_some_and(|folder| {
            ["libraries/table1", "walks/subjects"]
                .iter()
                .any(|folder_of_results| folder.ends_with(folder_of_results))
        })
}

/// Commands in `document` that name a fixture but are in a block that is not run.
fn commands_that_are_not_run(document: &Path) -> Vec<String> {
    let text = std::fs::read_to_string(document).unwrap();
    let blocks = text.split("\n```").skip(1).step_by(2).filter(|block| !block.starts_with("console"));
    let lines =
        blocks.flat_map(|block| block.lines().skip(1)).map(|line| line.trim_start_matches("$ ").to_owned());
    lines.filter(|line| line.starts_with("osim-contact-scale ") && line.contains("fixtures/")).collect()
}

/// README.md and all pages in docs/ that have examples.
fn pages_with_examples() -> Vec<PathBuf> {
    let mut documents = vec![root().join("README.md")];
    let mut folders = vec![root().join("docs")];
    while let Some(folder) = folders.pop() {
        for path in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            if path.is_dir() { folders.push(path) } else { documents.push(path) }
        }
    }
    documents.retain(|path| {
        path.extension().is_some_and(|extension| extension == "md")
            && std::fs::read_to_string(path).is_ok_and(|text| text.contains("```console"))
    });
    documents.sort();
    documents
}

#[test]
fn pages_in_folders_of_docs_are_included() {
    let documents = pages_with_examples();
    for page in ["README.md", "docs/check.md", "docs/reference/errors.md"] {
        assert!(documents.contains(&root().join(page)), "{page}");
    }
}

#[test]
fn commands_with_fixtures_are_in_blocks_that_are_run() {
    for document in pages_with_examples() {
        let not_run = commands_that_are_not_run(&document);
        assert!(not_run.is_empty(), "{}: {not_run:#?}", document.display());
    }
}

// One test for all pages: they share the process's working folder.
#[test]
fn examples_in_the_documents_match_the_output() {
    let documents = pages_with_examples();
    assert!(!documents.is_empty(), "neither README.md nor docs/ holds a ```console example");
    for document in documents {
        // Each page starts with untouched fixtures.
        let folder = tempfile::tempdir().unwrap();
        copy_fixtures(&root().join("fixtures"), &folder.path().join("fixtures"));
        std::env::set_current_dir(folder.path()).unwrap();
        let cases = trycmd::TestCases::new();
        cases.register_bin("osim-contact-scale", Path::new(env!("CARGO_BIN_EXE_osim-contact-scale")));
        // The date of notes: 2025-11-26.
        cases.env("NO_COLOR", "1").env("SOURCE_DATE_EPOCH", "1764115200").case(&document).run();
        std::env::set_current_dir(root()).unwrap();
    }
}
