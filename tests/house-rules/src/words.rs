//! Finds words that texts must not use, and gives the words to write instead.

use std::sync::LazyLock;

use regex::{Captures, Regex};
use serde::Deserialize;
use serde::de::{Deserializer, Error};

use crate::source::{self, Tree, blank};

/// A list of words that texts must not use: `words.toml`.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Words {
    /// Words that no text may use.
    pub word: Vec<Word>,
    /// Words that only README.md and docs/ may not use.
    #[serde(default)]
    pub book: Vec<Word>,
}

/// A forbidden word, with examples of refused and of allowed texts.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Word {
    /// A regular expression for the whole forbidden words. A blank in it also matches the end of a line.
    #[serde(deserialize_with = "pattern")]
    pub not: Regex,
    /// The words to write instead.
    pub say: String,
    /// Texts around the words in which they are allowed.
    #[serde(default, deserialize_with = "some_pattern")]
    pub unless: Option<Regex>,
    /// Examples of texts that are refused.
    pub wrong: Vec<String>,
    /// Examples of texts that are allowed.
    #[serde(default)]
    pub right: Vec<String>,
}

impl Words {
    /// The forbidden words in a text for people, which begins on `line`.
    #[must_use]
    pub fn in_text(&self, file: &str, line: usize, text: &str) -> Vec<String> {
        self.word.iter().flat_map(|word| word.in_text(file, line, text)).collect()
    }

    /// The forbidden words in a page of README.md or docs/.
    #[must_use]
    pub fn in_page(&self, file: &str, text: &str) -> Vec<String> {
        let only_here = self.book.iter().flat_map(|word| word.in_text(file, 1, text));
        self.in_text(file, 1, text).into_iter().chain(only_here).collect()
    }

    /// The forbidden words in the strings and doc comments of a crate, except in names in `{}` and in code in backticks.
    #[must_use]
    pub fn in_code(&self, tree: &Tree) -> Vec<String> {
        let mut forbidden = Vec::new();
        for module in tree.values() {
            for text in &module.texts {
                let blank_inside =
                    |name: &Captures<'_>| format!("{}{}{}", &name[1], blank(&name[2]), &name[3]);
                let code_pattern = if text.is_doc { &CODE_SPAN } else { &NAME_IN_BRACES };
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

static CODE_SPAN: LazyLock<Regex> = LazyLock::new(|| source::pattern(&["(`)([^`]*)(`)"]));
static NAME_IN_BRACES: LazyLock<Regex> = LazyLock::new(|| source::pattern(&[r"(\{)([^\s}]*)(\})"]));

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
