//! Applies the rules about structure and words to this project; `src/lib.rs` explains each rule.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use house_rules::floors::FLOORS_OF_CRATES;
use house_rules::source::{Tree, project};
use house_rules::words::Words;
use house_rules::{circles, floors, texts};
use walkdir::WalkDir;

/// The only place below the front ends where code may spell options: a file, or a folder with `/` at its end.
const PLACE_THAT_SPELLS_OPTIONS: &str = "crates/osim-requests/src/spell/";

/// Crates that may name files, processes and streams of the system. Clippy checks printing.
const CRATES_THAT_OPEN_FILES: &[&str] = &["osim-contact-scale", "osim-library"];

/// The crate that `osim-python` depends on without using it, so that Cargo compiles the libraries of both only once for the wheel.
const BUILT_TOGETHER: &str = "osim-contact-scale";

/// The heading in the change log of changes that are not released yet. Only their entries can still be corrected.
const UNRELEASED: &str = "## [Unreleased]";

static PROJECT: LazyLock<BTreeMap<String, Vec<Tree>>> =
    LazyLock::new(|| project(&root()).unwrap_or_else(|error| panic!("{error}")));

static WORDS: LazyLock<Words> = LazyLock::new(|| {
    let list = fs::read_to_string(root().join("tests/house-rules/words.toml")).unwrap();
    toml::from_str(&list).unwrap_or_else(|error| panic!("words.toml: {error}"))
});

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The findings of a rule in all crates outside `except`, each finding once, although a library and a program may share a module.
fn findings_of_rule(rule: impl Fn(&Tree) -> Vec<String>, except: &[&str]) -> Vec<String> {
    let crates = PROJECT.iter().filter(|(name, _)| !except.contains(&name.as_str()));
    let mut findings: Vec<String> = crates.flat_map(|(_, trees)| trees).flat_map(rule).collect();
    findings.sort();
    findings.dedup();
    findings
}

#[track_caller]
fn assert_none(findings: &[String], what: &str) {
    assert!(findings.is_empty(), "{} {what}:\n{}\n", findings.len(), findings.join("\n"));
}

#[test]
fn modules_use_each_other_without_circles() {
    assert_none(&findings_of_rule(circles::circles, &[]), "circles");
}

#[test]
fn modules_use_only_lower_floors() {
    for (name, floors) in floors::FLOORS_INSIDE_CRATES {
        let faults: Vec<String> =
            PROJECT[*name].iter().flat_map(|tree| floors::faults_inside(floors, tree)).collect();
        assert_none(&faults, &format!("faults in the arrows between modules of {name}"));
    }
}

#[test]
fn crates_use_only_lower_floors() {
    let mut crates = floors::crates(&root().join("crates")).unwrap();
    crates.get_mut("osim-python").unwrap().retain(|name| name != BUILT_TOGETHER);
    assert_none(&floors::faults(FLOORS_OF_CRATES, &crates), "faults in the arrows between crates");
    let of_python = PROJECT["osim-python"].iter().flat_map(BTreeMap::values);
    let calls = of_python.filter(|module| {
        let imports = module.imports.iter().map(|import| &import.path);
        imports
            .chain(module.mentions.iter().map(|(path, _)| path))
            .any(|path| path[0] == "osim_contact_scale")
    });
    assert_none(
        &calls.map(|module| module.file.clone()).collect::<Vec<_>>(),
        "files of osim-python that call the command",
    );
}

#[test]
fn only_front_ends_spell_options() {
    assert!(root().join(PLACE_THAT_SPELLS_OPTIONS).exists(), "{PLACE_THAT_SPELLS_OPTIONS}");
    let mut options = findings_of_rule(texts::options, FLOORS_OF_CRATES.last().unwrap());
    options.retain(|option| !option.starts_with(PLACE_THAT_SPELLS_OPTIONS));
    assert_none(&options, "options below the front ends");
}

#[test]
fn only_the_library_and_the_command_use_the_system() {
    assert_none(
        &findings_of_rule(texts::outside, CRATES_THAT_OPEN_FILES),
        "uses of files, processes or streams",
    );
}

/// Names and texts of the files in a folder of the project whose names have this ending.
fn files(folder: &str, ending: &str) -> Vec<(String, String)> {
    let entries = WalkDir::new(root().join(folder)).sort_by_file_name().into_iter().map(Result::unwrap);
    let files = entries.filter(|entry| entry.path().extension().is_some_and(|extension| extension == ending));
    files
        .map(|entry| {
            (
                entry.path().strip_prefix(root()).unwrap().to_str().unwrap().replace('\\', "/"),
                fs::read_to_string(entry.path()).unwrap(),
            )
        })
        .collect()
}

#[test]
fn the_code_has_no_forbidden_words() {
    assert_none(&findings_of_rule(|tree| WORDS.in_code(tree), &[]), "words that words.toml forbids");
}

#[test]
fn the_docs_have_no_forbidden_words() {
    let mut pages = [files("docs", "md"), files("crates", "md")].concat();
    assert!(pages.len() > 20, "{}", pages.len());
    for name in ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"] {
        let text = fs::read_to_string(root().join(name)).unwrap();
        let begin = text.find(UNRELEASED).unwrap_or(0);
        let end = text[begin + 1..].find("\n## ").filter(|_| name == "CHANGELOG.md");
        pages.push((name.to_owned(), text[..end.map_or(text.len(), |end| begin + 1 + end)].to_owned()));
    }
    let is_of_the_book = |file: &str| file == "README.md" || file.starts_with("docs/");
    let forbidden = pages.iter().flat_map(|(file, text)| match is_of_the_book(file) {
        true => WORDS.in_page(file, text),
        false => WORDS.in_text(file, 1, text),
    });
    assert_none(&forbidden.collect::<Vec<_>>(), "words that words.toml forbids");
}

#[test]
fn the_schemas_have_no_forbidden_words() {
    let schemas = files("schemas", "json");
    assert!(schemas.len() > 20, "{}", schemas.len());
    // In names, `_` separates the words.
    let forbidden = schemas.iter().flat_map(|(file, text)| WORDS.in_text(file, 1, &text.replace('_', " ")));
    assert_none(&forbidden.collect::<Vec<_>>(), "words that words.toml forbids");
}

/// Each forbidden word is refused in its examples, and is allowed in its examples of allowed texts.
#[test]
fn each_forbidden_word_is_found_in_its_examples() {
    type Refused = fn(&str) -> Vec<String>;
    let kinds: [(_, Refused); 2] = [
        (&WORDS.word, |text| WORDS.in_text("file", 1, text)),
        (&WORDS.book, |text| WORDS.in_page("file", text)),
    ];
    for (words, refused) in kinds {
        for word in words {
            assert!(!word.wrong.is_empty(), "no example: {}", word.not);
            for text in &word.wrong {
                assert!(refused(text).iter().any(|message| message.ends_with(&word.say)), "passes: {text}");
            }
            for text in &word.right {
                assert_eq!(refused(text), Vec::<String>::new());
            }
        }
    }
}
