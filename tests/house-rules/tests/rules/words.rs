//! Words that texts and doc comments must not use.

use std::fs;

use house_rules::{Error, Words};

use crate::support::{fixture, shown, sources};

fn list(name: &str) -> Words {
    Words::read(&fixture("words").join(name).join("words.toml")).unwrap()
}

/// A list in a file of its own.
fn read(text: &str) -> Result<Words, Error> {
    let file = tempfile::NamedTempFile::new().unwrap();
    fs::write(file.path(), text).unwrap();
    Words::read(file.path())
}

/// In doc comments of crates, modules, items, variants and fields, over the end of a line and in macros; in texts of functions,
/// attributes and macros, behind escapes, in raw texts, in bytes, and over the ends of lines.
#[test]
fn refused() {
    let expected = [
        "src/lib.rs:1: not 'told', but known",
        "src/lib.rs:3: not 'told', but known",
        "src/lib.rs:4: not 'stands for', but made for",
        "src/lib.rs:9: not 'tells', but known",
        "src/lib.rs:11: not 'told', but known",
        "src/lib.rs:13: not 'Told', but known",
        "src/lib.rs:16: not 'Told', but known",
        "src/lib.rs:23: not 'told', but known",
        "src/lib.rs:24: not 'told', but known",
        "src/lib.rs:25: not 'told', but known",
        "src/lib.rs:26: not 'stands for', but made for",
        "src/lib.rs:30: not 'told', but known",
        "src/lib.rs:32: not 'told', but known",
        "src/lib.rs:37: not 'Told', but known",
        "src/lib.rs:38: not 'told', but known",
        "src/shown.rs:1: not 'Told', but known",
        "src/shown.rs:4: not 'Told', but known",
    ];
    assert_eq!(shown(&sources("words", "refused").forbidden(&list("refused"))), expected);
}

/// Code in doc comments, longer words, names of variables, comments for those who change the code, and tests.
#[test]
fn passes() {
    assert_eq!(shown(&sources("words", "passes").forbidden(&list("passes"))), [""; 0]);
}

/// In schemas, `_` separates words, and there are words that no field is called.
#[test]
fn schemas() {
    let words = "[[word]]\nnot = 'told by'\nsay = 'source'\nwrong = []\n\
        [[field]]\nnot = 'said'\nsay = 'by_source'\nwrong = []\n";
    let words = read(words).unwrap();
    let schema = "{\n\"told_by\": {},\n\"said\": {},\n\"description\": \"said\"\n}";
    let expected = ["file:2: not 'told by', but source", "file:3: not 'said', but by_source"];
    assert_eq!(shown(&words.in_schema("file", schema)), expected);
    assert_eq!(shown(&words.in_prose("file", "it said")), [""; 0]);
}

/// A list with a mistake is an error, not a list that refuses less.
#[test]
fn lists_are_read_strictly() {
    let whole = "[[word]]\nnot = 'told'\nsay = 'known'\nwrong = ['told']\n";
    assert!(read(whole).is_ok());
    for (wrong, why) in [
        ("[[word]]\nnot = '('\nsay = 'x'\nwrong = []\n", "unclosed group"),
        ("[[word]]\nnot = 'told'\nwrong = []\n", "missing field `say`"),
        ("[[words]]\nnot = 'told'\n", "unknown field `words`"),
    ] {
        let error = read(wrong).unwrap_err().to_string();
        assert!(error.contains(why), "{error}");
    }
}
