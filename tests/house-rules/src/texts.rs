//! What code must not write: options below the front ends, and the world outside of the program.

use crate::module::{Module, Tree};

/// Files, processes and streams of the system, by their paths in the standard library. Printing by macros is clippy's.
pub const OUTSIDE: &[&str] = &[
    "std::env",
    "std::fs",
    "std::net",
    "std::process",
    "std::io::stderr",
    "std::io::stdin",
    "std::io::stdout",
];

/// The options that the texts of a crate name, each with its place.
#[must_use]
pub fn options(tree: &Tree) -> Vec<String> {
    let mut found = Vec::new();
    for module in tree.values() {
        for token in module.texts.iter().filter(|token| token.is_string()) {
            let named = options_in(&token.text).into_iter();
            found.extend(
                named.map(|(lines, option)| format!("{}:{}: {option}", module.file, token.line + lines)),
            );
        }
    }
    found
}

/// The options in a text, each with the lines before it.
fn options_in(text: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    for (at, dashes) in text.match_indices("--") {
        let (before, after) = (&text[..at], &text[at + dashes.len()..]);
        let in_word = before.ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == '-');
        if in_word || before.ends_with("<!") || !after.starts_with(|c: char| c.is_ascii_lowercase()) {
            continue;
        }
        let end = after.find(|c: char| !c.is_ascii_alphanumeric() && c != '-').unwrap_or(after.len());
        found.push((before.matches('\n').count(), format!("--{}", after[..end].trim_end_matches('-'))));
    }
    found
}

/// Places at which a crate names something of [`OUTSIDE`].
#[must_use]
pub fn outside(tree: &Tree) -> Vec<String> {
    let mut found = Vec::new();
    for module in tree.values() {
        let imports = module.imports.iter().map(|import| (full(module, &import.path), import.line));
        let mentions = module.mentions.iter().map(|(path, line)| (full(module, path), *line));
        for (path, line) in imports.chain(mentions) {
            if OUTSIDE.iter().any(|banned| path == *banned || path.starts_with(&format!("{banned}::"))) {
                found.push(format!("{}:{line}: {path}", module.file));
            }
        }
    }
    found
}

/// A path with the import that it begins with in the place of its first name.
fn full(module: &Module, path: &[String]) -> String {
    let import = module
        .imports
        .iter()
        .find(|import| path.len() > 1 && import.path[0] == "std" && import.name == path[0]);
    match import {
        Some(import) => [import.path.as_slice(), &path[1..]].concat().join("::"),
        None => path.join("::"),
    }
}
