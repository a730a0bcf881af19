//! The book is short: the words of its pages together, and of each sentence.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::fs;
use std::path::Path;

use house_rules::book::sentences;
use walkdir::WalkDir;

/// Words of `README.md` and `docs/` together, as `wc -w` counts them, without the pages of `LOOKED_UP`.
const WORDS: usize = 32_000;
/// Pages that have an entry for each code or word of the program: they grow with it.
const LOOKED_UP: [&str; 3] = ["docs/glossary.md", "docs/reference/errors.md", "docs/reference/warnings.md"];
/// Words of a sentence, on average of a page.
const MEAN: usize = 22;
/// Words of the longest sentence: lists in a sentence are lists.
const LONGEST: usize = 40;

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
fn the_book_is_short() {
    let pages = pages(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."));
    assert!(LOOKED_UP.iter().all(|name| pages.iter().any(|(page, _)| page == name)), "{LOOKED_UP:?}");
    let counted = pages.iter().filter(|(name, _)| !LOOKED_UP.contains(&name.as_str()));
    let sum: usize = counted.map(|(_, text)| text.split_whitespace().count()).sum();
    assert!(sum <= WORDS, "{sum} words, at most {WORDS}");
}

#[test]
fn sentences_are_short() {
    for (name, text) in pages(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")) {
        let lengths = sentences(&text);
        let (sum, longest) = (lengths.iter().sum::<usize>(), lengths.iter().max().copied().unwrap_or(0));
        assert!(
            sum <= MEAN * lengths.len(),
            "{name}: {sum} words in {} sentences, at most {MEAN} each",
            lengths.len()
        );
        assert!(longest <= LONGEST, "{name}: a sentence of {longest} words, at most {LONGEST}");
    }
}
