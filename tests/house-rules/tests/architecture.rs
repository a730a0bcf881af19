//! `docs/architecture.md` agrees with the tree: every path in it is there, every module is in it, and its index answers.
//!
//! Paths are written from the project's root, folders with `/` at their end. They stand in code spans, and in blocks that
//! begin with a folder: there, each line that is indented by two blanks begins with names of what is in that folder.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test fails by panicking"
)]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

const PAGE: &str = "docs/architecture.md";

/// The heading of the index.
const INDEX: &str = "## Where is ...?";

/// Fewer questions than these are no index.
const QUESTIONS: usize = 20;

/// More paths than these are no answer.
const PATHS: usize = 2;

/// Endings by which a name without a folder is known for a file.
const FILES: &[&str] = &[".css", ".json", ".lock", ".md", ".py", ".rs", ".sh", ".snap", ".toml", ".yml"];

static TEXT: LazyLock<String> =
    LazyLock::new(|| fs::read_to_string(root().join(PAGE)).unwrap_or_else(|error| panic!("{PAGE}: {error}")));

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// A path in the page, and its line.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Named {
    line: usize,
    path: String,
}

/// Code spans of a line that look like paths.
fn paths_in(line: &str) -> impl Iterator<Item = &str> {
    line.split('`').skip(1).step_by(2).filter(|span| {
        let is_file = FILES.iter().any(|ending| span.ends_with(ending));
        !span.contains(|letter: char| letter.is_ascii_whitespace()) && (span.contains('/') || is_file)
    })
}

/// Every path of a page.
fn paths(text: &str) -> Vec<Named> {
    let mut found = Vec::new();
    let mut add = |line: usize, path: String| found.push(Named { line, path });
    let mut lines = (1..).zip(text.lines());
    while let Some((number, line)) = lines.next() {
        if !line.starts_with("```") {
            paths_in(line).for_each(|path| add(number, path.to_owned()));
            continue;
        }
        let block: Vec<(usize, &str)> =
            lines.by_ref().take_while(|(_, line)| !line.starts_with("```")).collect();
        let Some((&(number, folder), rest)) = block.split_first() else { continue };
        if !folder.ends_with('/') || folder.contains(|letter: char| letter.is_ascii_whitespace()) {
            continue;
        }
        add(number, folder.to_owned());
        for &(number, line) in rest {
            let entry = line.strip_prefix("  ").filter(|entry| !entry.starts_with(' '));
            let Some(entry) = entry else { continue };
            let names = entry.split_once("  ").map_or(entry, |(names, _)| names);
            names.split(", ").for_each(|name| add(number, format!("{folder}{}", name.trim_ascii())));
        }
    }
    found
}

/// Whether a path names what is there: with `/` at its end a folder, without it a file.
fn is_there(path: &str) -> bool {
    let at = root().join(path);
    if path.ends_with('/') { at.is_dir() } else { at.is_file() }
}

/// Names in a folder, folders with `/` at their end.
fn names_in(folder: &str) -> BTreeSet<String> {
    let entries = fs::read_dir(root().join(folder)).unwrap_or_else(|error| panic!("{folder}: {error}"));
    entries
        .map(|entry| {
            let entry = entry.unwrap();
            let name = entry.file_name().into_string().unwrap();
            if entry.path().is_dir() { format!("{name}/") } else { name }
        })
        .collect()
}

/// Whether Rust is somewhere in a folder: git leaves empty ones behind.
fn has_modules(folder: &str) -> bool {
    names_in(folder)
        .iter()
        .any(|name| name.ends_with(".rs") || name.ends_with('/') && has_modules(&format!("{folder}{name}")))
}

/// The modules in `folder`, from the project's root: its files, where `files`, and its folders with all below.
fn modules(folder: &str, files: bool, found: &mut Vec<String>) {
    for name in names_in(folder) {
        let is_root = ["lib.rs", "main.rs", "mod.rs"].contains(&name.as_str());
        let path = format!("{folder}{name}");
        if name.ends_with('/') {
            if has_modules(&path) {
                modules(&path, false, found);
                found.push(path);
            }
        } else if files && name.ends_with(".rs") && !is_root {
            found.push(path);
        }
    }
}

/// Rows of the tables in the index, without their headers: what is asked, and where the answer is.
fn questions(text: &str) -> Vec<(usize, String, String)> {
    let lines: Vec<&str> = text.lines().collect();
    let begin = lines.iter().position(|line| *line == INDEX);
    let begin = begin.unwrap_or_else(|| panic!("{PAGE}: no heading '{INDEX}'"));
    let is_rule = |line: &str| line.starts_with("|--");
    let mut found = Vec::new();
    for (at, line) in lines.iter().enumerate().skip(begin + 1) {
        if line.starts_with("## ") {
            break;
        }
        let is_header = lines.get(at + 1).is_some_and(|next| is_rule(next));
        if !line.starts_with('|') || is_rule(line) || is_header {
            continue;
        }
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim_ascii).collect();
        let [question, answer] = cells[..] else { panic!("{PAGE}:{}: expected two cells: {line}", at + 1) };
        found.push((at + 1, question.to_owned(), answer.to_owned()));
    }
    found
}

#[test]
fn every_path_is_there() {
    let lost: Vec<String> = paths(&TEXT)
        .into_iter()
        .filter(|named| !is_there(&named.path))
        .map(|named| format!("{PAGE}:{}: {}", named.line, named.path))
        .collect();
    assert!(
        lost.is_empty(),
        "{} paths lead nowhere (from the project's root, folders end with /):\n{}\n",
        lost.len(),
        lost.join("\n")
    );
}

#[test]
fn every_link_leads_somewhere() {
    let lost: Vec<&str> = TEXT
        .split("](")
        .skip(1)
        .filter_map(|rest| rest.split([')', '#']).next())
        .filter(|link| !link.is_empty() && !link.starts_with("https://"))
        .filter(|link| !root().join("docs").join(link).exists())
        .collect();
    assert!(lost.is_empty(), "{PAGE}: links lead nowhere: {lost:?}");
}

#[test]
fn every_crate_and_every_module_is_mentioned() {
    let mentioned: BTreeSet<String> = paths(&TEXT).into_iter().map(|named| named.path).collect();
    let mut there = Vec::new();
    for name in names_in("crates").iter().filter(|name| name.ends_with('/')) {
        let sources = format!("crates/{name}src/");
        modules(&sources, true, &mut there);
        there.push(sources);
    }
    there.retain(|path| !mentioned.contains(path));
    assert!(
        there.is_empty(),
        "{PAGE} does not mention {} of the modules, add each to the block of its crate:\n{}\n",
        there.len(),
        there.join("\n")
    );
}

#[test]
fn the_index_answers() {
    let questions = questions(&TEXT);
    assert!(questions.len() >= QUESTIONS, "{PAGE}: {} questions in '{INDEX}'", questions.len());
    let mut asked = BTreeSet::new();
    for (line, question, answer) in &questions {
        assert!(!question.is_empty() && asked.insert(question), "{PAGE}:{line}: asked twice: {question}");
        let paths: Vec<&str> = paths_in(answer).collect();
        assert!(
            (1..=PATHS).contains(&paths.len()) && paths.iter().all(|path| is_there(path)),
            "{PAGE}:{line}: expected one path or two that are there: {question}: {answer}"
        );
    }
}

#[test]
fn paths_are_found_where_they_stand() {
    let page = "See `a/b.rs`, `c.md`, `two words/` and `x::y`.\n```text\na -> b/\n```\n```text\na/src/\n  x/   the x\n         \
                of `no/path`\n  y.rs, z.rs  both\n```\n`d/`\n";
    let found: Vec<(usize, String)> = paths(page).into_iter().map(|named| (named.line, named.path)).collect();
    let expected = [
        (1, "a/b.rs"),
        (1, "c.md"),
        (6, "a/src/"),
        (7, "a/src/x/"),
        (9, "a/src/y.rs"),
        (9, "a/src/z.rs"),
        (11, "d/"),
    ];
    assert_eq!(found, expected.map(|(line, path)| (line, path.to_owned())));
}
