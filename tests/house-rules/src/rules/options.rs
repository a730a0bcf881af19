//! No option of the command line is named below the command: a library does not know who calls it.

use std::fmt;

use crate::package::Package;
use crate::syntax::Literal;
use crate::tree::Tree;

/// A text that names an option.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct OptionNamed {
    /// The crate.
    pub in_crate: String,
    /// The file.
    pub file: String,
    /// Where in it.
    pub line: usize,
    /// The option, as `--mass`.
    pub option: String,
}

impl fmt::Display for OptionNamed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { in_crate, file, line, option } = self;
        write!(f, "{file}:{line}: {in_crate} names the option {option}")
    }
}

/// All options that the texts of a crate name.
pub(crate) fn options_named(package: &Package) -> Vec<OptionNamed> {
    let mut found = Vec::new();
    for (_, module) in package.trees.iter().flat_map(Tree::iter) {
        for literal in &module.facts.literals {
            found.extend(options(literal).into_iter().map(|(line, option)| OptionNamed {
                in_crate: package.name.clone(),
                file: module.file.clone(),
                line,
                option,
            }));
        }
    }
    // A module of several targets is read once for each.
    found.sort();
    found.dedup();
    found
}

/// The options in a literal, each with its line.
fn options(literal: &Literal) -> Vec<(usize, String)> {
    let text = literal.without_escapes();
    let mut found = Vec::new();
    for (at, dashes) in text.match_indices("--") {
        let (before, behind) = (&text[..at], &text[at + dashes.len()..]);
        let in_word = before.ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == '-');
        let in_comment_mark = before.ends_with("<!");
        if in_word || in_comment_mark || !behind.starts_with(|c: char| c.is_ascii_lowercase()) {
            continue;
        }
        let end = behind.find(|c: char| !c.is_ascii_alphanumeric() && c != '-').unwrap_or(behind.len());
        let name = behind[..end].trim_end_matches('-');
        found.push((literal.line + before.matches('\n').count(), format!("--{name}")));
    }
    found
}
