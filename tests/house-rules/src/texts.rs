//! Finds names that code must not contain: options below the front ends, and files, processes and streams of the system.

use std::sync::LazyLock;

use regex::Regex;

use crate::source::{Module, Text, Tree, pattern};

/// Files, processes and streams of the system, by their paths in the standard library. Clippy forbids printing by macros.
pub const OUTSIDE: &[&str] = &[
    "std::env",
    "std::fs",
    "std::net",
    "std::process",
    "std::io::stderr",
    "std::io::stdin",
    "std::io::stdout",
];

/// Matches an option such as `--mass`, but neither hyphens within a word nor a comment of HTML.
static SPELLED_OPTION: LazyLock<Regex> =
    LazyLock::new(|| pattern(&[r"(?:^|[^\w!-])(--[a-z](?:-?[[:alnum:]])*)"]));

/// The options of the command line in the strings of a crate, each with its place.
#[must_use]
pub fn options(tree: &Tree) -> Vec<String> {
    let mut options = Vec::new();
    for module in tree.values() {
        for Text { text, line, .. } in module.texts.iter().filter(|text| !text.is_doc) {
            options.extend(SPELLED_OPTION.captures_iter(text).filter_map(|option| option.get(1)).map(
                |option| {
                    let line = line + text[..option.start()].matches('\n').count();
                    format!("{}:{line}: {}", module.file, option.as_str())
                },
            ));
        }
    }
    options
}

/// Places at which the code of a crate names one of the paths [`OUTSIDE`].
#[must_use]
pub fn outside(tree: &Tree) -> Vec<String> {
    let mut uses = Vec::new();
    for module in tree.values() {
        let imports = module.imports.iter().map(|import| (full_path(module, &import.path), import.line));
        let mentions = module.mentions.iter().map(|(path, line)| (full_path(module, path), *line));
        for (path, line) in imports.chain(mentions) {
            if OUTSIDE.iter().any(|banned| path == *banned || path.starts_with(&format!("{banned}::"))) {
                uses.push(format!("{}:{line}: {path}", module.file));
            }
        }
    }
    uses
}

/// The path with its first name replaced by the path of the import of this name.
fn full_path(module: &Module, path: &[String]) -> String {
    let import = module
        .imports
        .iter()
        .find(|import| path.len() > 1 && import.path[0] == "std" && import.name == path[0]);
    match import {
        Some(import) => [import.path.as_slice(), &path[1..]].concat().join("::"),
        None => path.join("::"),
    }
}
