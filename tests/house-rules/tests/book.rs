//! The pages of the book are as short as `book.toml` says.

#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "a test fails by panicking")]

use std::fs;
use std::path::Path;

use house_rules::book::Book;
use walkdir::WalkDir;

fn pages(root: &Path) -> Vec<(String, String)> {
    let docs = WalkDir::new(root.join("docs")).sort_by_file_name().into_iter().map(Result::unwrap);
    let docs =
        docs.map(walkdir::DirEntry::into_path).filter(|path| path.extension().is_some_and(|end| end == "md"));
    let named = |path: &Path| path.strip_prefix(root).unwrap().to_str().unwrap().replace('\\', "/");
    [root.join("README.md")]
        .into_iter()
        .chain(docs)
        .map(|path| (named(&path), fs::read_to_string(path).unwrap()))
        .collect()
}

#[test]
fn pages_and_sentences_are_short() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let book = fs::read_to_string(here.join("book.toml")).unwrap();
    let book: Book = toml::from_str(&book).unwrap_or_else(|error| panic!("book.toml: {error}"));
    let pages = pages(&here.join("../.."));
    assert!(pages.len() > 20, "{}", pages.len());
    let found = book.faults(&pages);
    assert!(found.is_empty(), "{} pages that book.toml does not allow:\n{}\n", found.len(), found.join("\n"));
}
