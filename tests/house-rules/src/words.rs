//! Words that texts must not use, and what to write instead.

use std::sync::LazyLock;

use regex::{Captures, Regex};
use serde::Deserialize;
use serde::de::{Deserializer, Error};

use crate::source::{self, Tree, blank};

/// A list of words that texts must not use: `words.toml`.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Words {
    /// Words of any text.
    pub word: Vec<Word>,
    /// Words of README.md and docs/ alone.
    #[serde(default)]
    pub book: Vec<Word>,
}

/// One of them, with examples that are refused, and that pass.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Word {
    /// What must not be written: a regular expression for whole words. A blank also fits the end of a line.
    #[serde(deserialize_with = "pattern")]
    pub not: Regex,
    /// What to write instead.
    pub say: String,
    /// Texts around the words in which they are allowed.
    #[serde(default, deserialize_with = "some_pattern")]
    pub unless: Option<Regex>,
    /// Texts that are refused.
    pub wrong: Vec<String>,
    /// Texts that pass the rule.
    #[serde(default)]
    pub right: Vec<String>,
}

impl Words {
    /// What must not be written in a text that people read, which begins on a line.
    #[must_use]
    pub fn in_text(&self, file: &str, line: usize, text: &str) -> Vec<String> {
        self.word.iter().flat_map(|word| word.in_text(file, line, text)).collect()
    }

    /// What must not be written in a page of the book, beside the words of any text.
    #[must_use]
    pub fn in_page(&self, file: &str, text: &str) -> Vec<String> {
        let only_here = self.book.iter().flat_map(|word| word.in_text(file, 1, text));
        self.in_text(file, 1, text).into_iter().chain(only_here).collect()
    }

    /// What must not be written in the strings and doc comments of a crate: names in `{}` and code in backticks aside.
    #[must_use]
    pub fn in_code(&self, tree: &Tree) -> Vec<String> {
        let mut forbidden = Vec::new();
        for module in tree.values() {
            for text in &module.texts {
                let blank_inside =
                    |name: &Captures<'_>| format!("{}{}{}", &name[1], blank(&name[2]), &name[3]);
                let code_pattern = if text.is_doc { &CODE } else { &VALUE };
                forbidden.extend(self.in_text(
                    &module.file,
                    text.line,
                    &code_pattern.replace_all(&text.text, blank_inside),
                ));
            }
        }
        forbidden
    }
}

static CODE: LazyLock<Regex> = LazyLock::new(|| source::pattern(&["(`)([^`]*)(`)"]));
static VALUE: LazyLock<Regex> = LazyLock::new(|| source::pattern(&[r"(\{)([^\s}]*)(\})"]));

impl Word {
    /// Every place of the word in a text that begins on `line`.
    #[must_use]
    pub fn in_text(&self, file: &str, line: usize, text: &str) -> Vec<String> {
        let allowed: Vec<_> = self.unless.iter().flat_map(|unless| unless.find_iter(text)).collect();
        let is_allowed = |matched: &regex::Match<'_>| {
            allowed.iter().any(|around| around.start() <= matched.start() && matched.end() <= around.end())
        };
        let matched = self.not.find_iter(text).filter(|matched| !is_allowed(matched));
        let in_words = |matched: regex::Match<'_>| {
            let line = line + text[..matched.start()].matches('\n').count();
            let written = matched.as_str().split_ascii_whitespace().collect::<Vec<_>>().join(" ");
            format!("{file}:{line}: not '{written}', but {}", self.say)
        };
        matched.map(in_words).collect()
    }
}

fn pattern<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Regex, D::Error> {
    let written = String::deserialize(deserializer)?;
    Regex::new(&format!(r"(?i)\b(?:{})\b", written.replace(' ', r"\s+"))).map_err(D::Error::custom)
}

fn some_pattern<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Regex>, D::Error> {
    let written = String::deserialize(deserializer)?;
    Regex::new(&format!("(?i){}", written.replace(' ', r"\s+"))).map(Some).map_err(D::Error::custom)
}
