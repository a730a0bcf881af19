//! Tests that the documentation (README.md and docs/) and its sentences are short, and that all paths in its map of the code exist.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::fs;
use std::path::{Path, PathBuf};

use regex::Regex;
use walkdir::WalkDir;

/// Most words in README.md and docs/ together, as `wc -w` counts them, without the pages of [`PAGES_WITHOUT_LIMIT`].
const MOST_WORDS_OF_DOCS: usize = 32_000;
/// Pages with an entry for each code or term of the program, which grow with the program.
const PAGES_WITHOUT_LIMIT: [&str; 3] =
    ["docs/glossary.md", "docs/reference/errors.md", "docs/reference/findings.md"];
/// Most words of a sentence on average over a page.
const MOST_WORDS_ON_AVERAGE: usize = 22;
/// Most words of any sentence.
const MOST_WORDS_OF_SENTENCE: usize = 40;
/// The page with the map of the code.
const CODE_MAP: &str = "docs/developers/architecture.md";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn pages() -> Vec<(String, String)> {
    let docs = WalkDir::new(root().join("docs")).sort_by_file_name().into_iter().map(Result::unwrap);
    let docs =
        docs.map(walkdir::DirEntry::into_path).filter(|path| path.extension().is_some_and(|end| end == "md"));
    let relative_name = |path: &Path| path.strip_prefix(root()).unwrap().to_str().unwrap().replace('\\', "/");
    [root().join("README.md")]
        .into_iter()
        .chain(docs)
        .map(|path| (relative_name(&path), fs::read_to_string(path).unwrap()))
        .collect()
}

#[test]
fn the_book_has_few_words() {
    let pages = pages();
    assert!(
        PAGES_WITHOUT_LIMIT.iter().all(|name| pages.iter().any(|(page, _)| page == name)),
        "{PAGES_WITHOUT_LIMIT:?}"
    );
    let counted = pages.iter().filter(|(name, _)| !PAGES_WITHOUT_LIMIT.contains(&name.as_str()));
    let sum: usize = counted.map(|(_, text)| text.split_whitespace().count()).sum();
    assert!(sum <= MOST_WORDS_OF_DOCS, "{sum} words, at most {MOST_WORDS_OF_DOCS}");
}

/// The number of words in each sentence of a page. Code, tables and headings do not count; a code span is one word.
fn sentences(page: &str) -> Vec<usize> {
    let replace_all =
        |text: &str, pattern: &str, by: &str| Regex::new(pattern).unwrap().replace_all(text, by).into_owned();
    let prose = replace_all(page, r"(?ms)^ *```.*?^ *```|^ *[|#<!][^\n]*", "\n");
    let prose = replace_all(&prose, r"`[^`]*`", "code");
    // Addresses of links are no words; neither abbreviations nor initials end a sentence.
    let prose = replace_all(&prose, r"\]\([^)]*(?:\.md|://|#)[^)]*\)", "]");
    let prose = replace_all(&prose, r"\b(Figs?|e\.g|i\.e|al|Eq|No|[A-Z])\.", "$1");
    let end = Regex::new(r#"(?m)[.!?][)*_"'\]]*(?:\s|$)|\n\s*\n|^\s*(?:[-*>]|\d+\.) "#).unwrap();
    let words = |sentence: &str| {
        sentence.split_whitespace().filter(|word| word.contains(char::is_alphanumeric)).count()
    };
    end.split(&prose).map(words).filter(|count| *count > 0).collect()
}

#[test]
fn sentences_of_the_book_are_short() {
    for (name, text) in pages() {
        let lengths = sentences(&text);
        let (sum, longest) = (lengths.iter().sum::<usize>(), lengths.iter().max().copied().unwrap_or(0));
        assert!(
            sum <= MOST_WORDS_ON_AVERAGE * lengths.len(),
            "{name}: {sum} words in {} sentences, at most {MOST_WORDS_ON_AVERAGE} each",
            lengths.len()
        );
        assert!(
            longest <= MOST_WORDS_OF_SENTENCE,
            "{name}: a sentence of {longest} words, at most {MOST_WORDS_OF_SENTENCE}"
        );
    }
}

#[test]
fn words_of_sentences_are_counted() {
    assert_eq!(sentences("One two. Three (four)? Five"), [2, 2, 1]);
    assert_eq!(sentences("One\ntwo.\n\nThree"), [2, 1]);
    assert_eq!(sentences("- one two\n- three\n  four\n1. five"), [2, 2, 1]);
    assert_eq!(sentences("# Title\n\n|a b|\n\n```text\nc d. e.\n```\n<!-- f -->"), Vec::<usize>::new());
    assert_eq!(sentences("See `a b c. d`, Fig. 4 of P. A. Writer."), [8]);
    assert_eq!(sentences("A 1.5 [link here](../a.md#b) and [b](https://c.org/d.)."), [6]);
    assert_eq!(sentences("one - two = three"), [3]);
}

/// Code spans that begin with a folder of the project must be existing paths, except examples such as `docs/*.md`.
#[test]
fn every_path_in_the_code_map_exists() {
    let text = fs::read_to_string(root().join(CODE_MAP)).unwrap();
    let folders: Vec<String> = fs::read_dir(root())
        .unwrap()
        .map(|entry| format!("{}/", entry.unwrap().file_name().to_string_lossy()))
        .collect();
    let spans = text.split('`').skip(1).step_by(2).filter(|span| !span.contains([' ', '*', '<', '{']));
    let paths: Vec<&str> =
        spans.filter(|span| folders.iter().any(|folder| span.starts_with(folder))).collect();
    assert!(paths.len() > 10, "{CODE_MAP}: {} paths", paths.len());
    let missing: Vec<_> = paths.into_iter().filter(|path| !root().join(path).exists()).collect();
    assert!(missing.is_empty(), "{CODE_MAP} names paths that are not there: {missing:?}");
    for entry in fs::read_dir(root().join("crates")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        assert!(text.contains(&format!("\n- `crates/{name}/src`: ")), "{CODE_MAP}: no paragraph on {name}");
    }
}
