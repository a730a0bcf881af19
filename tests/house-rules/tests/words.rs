//! The words of the project: `words.toml` says which texts must not use, and what to write instead.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use house_rules::project::Project;
use house_rules::words::Words;
use walkdir::WalkDir;

/// The heading of what is not released yet: only there can a change log be corrected.
const UNRELEASED: &str = "## [Unreleased]";

static WORDS: LazyLock<Words> = LazyLock::new(|| {
    let list = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("words.toml")).unwrap();
    toml::from_str(&list).unwrap_or_else(|error| panic!("words.toml: {error}"))
});

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Files in a folder of the project with this ending, with their texts.
fn files(folder: &str, ending: &str) -> Vec<(String, String)> {
    let entries = WalkDir::new(root().join(folder)).sort_by_file_name().into_iter().map(Result::unwrap);
    let files = entries.filter(|entry| entry.path().extension().is_some_and(|found| found == ending));
    files
        .map(|entry| {
            (
                entry.path().strip_prefix(root()).unwrap().to_str().unwrap().replace('\\', "/"),
                fs::read_to_string(entry.path()).unwrap(),
            )
        })
        .collect()
}

#[track_caller]
fn nothing(found: &[String], what: &str) {
    assert!(found.is_empty(), "{} {what}:\n{}\n", found.len(), found.join("\n"));
}

#[test]
fn words_of_the_code() {
    let project = Project::read(&root()).unwrap_or_else(|error| panic!("{error}"));
    nothing(&project.found(|tree| WORDS.in_code(tree), &[]), "words that words.toml forbids");
}

#[test]
fn words_of_the_docs() {
    let mut pages = [files("docs", "md"), files("crates", "md")].concat();
    assert!(pages.len() > 20, "{}", pages.len());
    for name in ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"] {
        let text = fs::read_to_string(root().join(name)).unwrap();
        let begin = text.find(UNRELEASED).unwrap_or(0);
        let end = text[begin + 1..].find("\n## ").filter(|_| name == "CHANGELOG.md");
        pages.push((name.to_owned(), text[..end.map_or(text.len(), |end| begin + 1 + end)].to_owned()));
    }
    let is_of_the_book = |file: &str| file == "README.md" || file.starts_with("docs/");
    let found = pages.iter().flat_map(|(file, text)| match is_of_the_book(file) {
        true => WORDS.in_page(file, text),
        false => WORDS.in_text(file, 1, text),
    });
    let found: Vec<String> = found.collect();
    nothing(&found, "words that words.toml forbids");
}

#[test]
fn words_of_the_schemas() {
    let schemas = files("schemas", "json");
    assert!(schemas.len() > 20, "{}", schemas.len());
    let found: Vec<String> = schemas.iter().flat_map(|(file, text)| WORDS.in_schema(file, text)).collect();
    nothing(&found, "words that words.toml forbids");
}

/// Each word of the list is refused in its examples, and passes where the list says so.
#[test]
fn words_are_refused_in_their_examples() {
    type Refused = fn(&str) -> Vec<String>;
    let kinds: [(_, Refused); 3] = [
        (&WORDS.word, |text| WORDS.in_text("file", 1, text)),
        (&WORDS.book, |text| WORDS.in_page("file", text)),
        (&WORDS.field, |text| WORDS.in_schema("file", text)),
    ];
    for (words, refused) in kinds {
        for word in words {
            assert!(!word.wrong.is_empty(), "no example: {}", word.not);
            for text in &word.wrong {
                assert!(refused(text).iter().any(|found| found.ends_with(&word.say)), "passes: {text}");
            }
            for text in &word.right {
                assert_eq!(refused(text), Vec::<String>::new());
            }
        }
    }
}
