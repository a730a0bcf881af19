//! Words that texts must not use, and what to write instead.

use std::fmt;
use std::fs;
use std::path::Path;

use regex::Regex;
use serde::Deserialize;
use serde::de::Error as _;

use crate::error::Error;
use crate::package::Package;
use crate::syntax::{Doc, Literal};
use crate::tree::Tree;

/// A list of words that texts must not use.
///
/// In a TOML file, each `[[word]]` has
///
/// - `not`: what must not be written, a regular expression for whole words. Capitals are as good as small letters, and a
///   blank also fits the end of a line;
/// - `say`: what to write instead;
/// - `unless`: where it may be written nevertheless, a regular expression for the words with what is around them;
/// - `wrong` and `right`: texts that are refused, and that pass.
///
/// Each `[[field]]` is the same for names of fields in JSON Schemas.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Words {
    #[serde(default)]
    word: Vec<Word>,
    #[serde(default)]
    field: Vec<Word>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Word {
    #[serde(deserialize_with = "pattern")]
    not: Regex,
    say: String,
    #[serde(default, deserialize_with = "some_pattern")]
    unless: Option<Regex>,
    wrong: Vec<String>,
    #[serde(default)]
    right: Vec<String>,
}

/// A text that shows what a list refuses, or what it lets pass.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Example<'w> {
    /// The text.
    pub text: &'w str,
    /// What to write instead; `None` where it passes.
    pub say: Option<&'w str>,
    /// It is the name of a field.
    pub is_field: bool,
}

/// A word that must not be used.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Forbidden {
    /// The file.
    pub file: String,
    /// Where in it.
    pub line: usize,
    /// The word, as it is written.
    pub written: String,
    /// What to write instead.
    pub say: String,
}

impl fmt::Display for Forbidden {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { file, line, written, say } = self;
        write!(f, "{file}:{line}: not '{written}', but {say}")
    }
}

impl Words {
    /// Reads a list.
    ///
    /// # Errors
    /// A file that cannot be read, or that is no list.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let text =
            fs::read_to_string(path).map_err(|source| Error::Read { path: path.to_owned(), source })?;
        toml::from_str(&text)
            .map_err(|error| Error::Words { path: path.to_owned(), message: error.to_string() })
    }

    /// The examples in the list.
    pub fn examples(&self) -> impl Iterator<Item = Example<'_>> {
        let words = self.word.iter().map(|word| (word, false));
        words.chain(self.field.iter().map(|field| (field, true))).flat_map(|(word, is_field)| {
            let wrong = word.wrong.iter().map(move |text| Example { text, say: Some(&word.say), is_field });
            wrong.chain(word.right.iter().map(move |text| Example { text, say: None, is_field }))
        })
    }

    /// What must not be written in a text that people read.
    #[must_use]
    pub fn in_prose(&self, file: &str, text: &str) -> Vec<Forbidden> {
        self.in_text(file, 1, text)
    }

    /// What must not be written in a JSON Schema. In names, `_` separates the words.
    #[must_use]
    pub fn in_schema(&self, file: &str, text: &str) -> Vec<Forbidden> {
        let mut found = self.in_text(file, 1, &text.replace('_', " "));
        for field in &self.field {
            found.extend(field.in_text(file, 1, text, |rest| rest.starts_with("\":")));
        }
        found.sort();
        found
    }

    /// What must not be written in the texts and doc comments of a crate.
    pub(crate) fn in_package(&self, package: &Package) -> Vec<Forbidden> {
        let mut found = Vec::new();
        for (_, module) in package.trees.iter().flat_map(Tree::iter) {
            let literals = module.facts.literals.iter().map(prose_of_literal);
            let docs = module.facts.docs.iter().map(prose_of_doc);
            for (line, text) in literals.chain(docs) {
                found.extend(self.in_text(&module.file, line, &text));
            }
        }
        // A module of several targets is read once for each.
        found.sort();
        found.dedup();
        found
    }

    fn in_text(&self, file: &str, line: usize, text: &str) -> Vec<Forbidden> {
        let mut found: Vec<Forbidden> =
            self.word.iter().flat_map(|word| word.in_text(file, line, text, |_| true)).collect();
        found.sort();
        found
    }
}

impl Word {
    /// Every place of the word in a text that begins on `line`, where `fits` holds for what comes after it.
    fn in_text(&self, file: &str, line: usize, text: &str, fits: impl Fn(&str) -> bool) -> Vec<Forbidden> {
        let allowed: Vec<_> = self.unless.iter().flat_map(|unless| unless.find_iter(text)).collect();
        let is_allowed = |found: &regex::Match<'_>| {
            allowed.iter().any(|around| around.start() <= found.start() && found.end() <= around.end())
        };
        let found = self.not.find_iter(text).filter(|found| !is_allowed(found));
        found
            .filter(|found| fits(&text[found.end()..]))
            .map(|found| Forbidden {
                file: file.to_owned(),
                line: line + text[..found.start()].matches('\n').count(),
                written: found.as_str().split_ascii_whitespace().collect::<Vec<_>>().join(" "),
                say: self.say.clone(),
            })
            .collect()
    }
}

/// A literal without names of variables, as in `{name}`.
fn prose_of_literal(literal: &Literal) -> (usize, String) {
    let is_name = |inside: &str| !inside.contains(|letter: char| letter.is_ascii_whitespace());
    (literal.line, without(&literal.without_escapes(), ['{', '}'], is_name))
}

/// A doc comment without code.
fn prose_of_doc(doc: &Doc) -> (usize, String) {
    (doc.line, without(&doc.text, ['`', '`'], |_| true))
}

/// A text with blanks in the place of what is between two marks, where it `fits`. Lines stay.
fn without(text: &str, [open, close]: [char; 2], fits: impl Fn(&str) -> bool) -> String {
    let mut left = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, behind)) = rest.split_once(open) {
        left.push_str(before);
        left.push(open);
        rest = behind;
        if let Some((inside, after)) = behind.split_once(close).filter(|(inside, _)| fits(inside)) {
            left.extend(inside.chars().map(|c| if c == '\n' { c } else { ' ' }));
            left.push(close);
            rest = after;
        }
    }
    left.push_str(rest);
    left
}

fn pattern<'de, D: serde::Deserializer<'de>>(deserializer: D) -> Result<Regex, D::Error> {
    let written = String::deserialize(deserializer)?;
    Regex::new(&format!(r"(?i)\b(?:{})\b", written.replace(' ', r"\s+"))).map_err(D::Error::custom)
}

fn some_pattern<'de, D: serde::Deserializer<'de>>(deserializer: D) -> Result<Option<Regex>, D::Error> {
    let written = String::deserialize(deserializer)?;
    Regex::new(&format!("(?i){}", written.replace(' ', r"\s+"))).map(Some).map_err(D::Error::custom)
}
