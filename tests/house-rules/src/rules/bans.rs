//! What a crate must not depend on, and what it must not name: a file system, a terminal.

use std::fmt;

use crate::package::Package;
use crate::resolve::{Resolver, Target};
use crate::syntax::{Import, Mention, Path, Spaces};
use crate::tree::{Module, ModuleId, Tree};

/// What is kept out of one crate.
#[derive(Debug, Clone, Copy)]
pub struct Ban<'a> {
    /// The crate.
    pub in_crate: &'a str,
    /// Crates that it must not depend on, tests aside.
    pub dependencies: &'a [&'a str],
    /// Paths of other crates that its code must not name, with all below them: `std::fs`, `std::io::stdout`. A name with
    /// a `!` is a macro: `println!`.
    pub paths: &'a [&'a str],
}

/// Something in a crate that a [`Ban`] keeps out.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Banned {
    /// The crate.
    pub in_crate: String,
    /// The source, or its `Cargo.toml`.
    pub file: String,
    /// Where in it.
    pub line: usize,
    /// What is kept out.
    pub banned: String,
    /// How it is written.
    pub written: String,
}

impl fmt::Display for Banned {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { in_crate, file, line, banned, written } = self;
        write!(f, "{file}:{line}: {in_crate} must do without {banned}")?;
        if written != banned { write!(f, ", written as {written}") } else { Ok(()) }
    }
}

/// All that `ban` keeps out of its crate and that is there nevertheless.
pub(crate) fn banned(package: &Package, ban: &Ban<'_>) -> Vec<Banned> {
    let crates = package.crates();
    let mut found: Vec<Banned> = Vec::new();
    for dependency in package.dependencies.iter().filter(|dependency| !dependency.for_tests) {
        if ban.dependencies.contains(&dependency.package.as_str()) {
            found.push(Banned {
                in_crate: package.name.clone(),
                file: package.manifest.clone(),
                line: dependency.line,
                banned: dependency.package.clone(),
                written: dependency.key.clone(),
            });
        }
    }
    for tree in &package.trees {
        let search = Search { name: &package.name, resolver: Resolver::new(tree, &crates), ban };
        found.extend(search.tree(tree));
    }
    found.sort();
    found.dedup();
    found
}

struct Search<'a> {
    name: &'a str,
    resolver: Resolver<'a>,
    ban: &'a Ban<'a>,
}

impl Search<'_> {
    fn tree(&self, tree: &Tree) -> Vec<Banned> {
        let mut found = Vec::new();
        for (id, module) in tree.iter() {
            for import in &module.facts.imports {
                found.extend(self.import(id, module, import));
            }
            for mention in &module.facts.mentions {
                found.extend(self.mention(id, module, mention));
            }
        }
        found
    }

    fn import(&self, id: ModuleId, module: &Module, import: &Import) -> Vec<Banned> {
        let targets = self.resolver.import(id, import);
        let star = if import.glob { "::*" } else { "" };
        let written = format!("{}{star}", import.path);
        let paths = targets.iter().flat_map(|target| self.paths_met(target, import.glob));
        paths.map(|path| self.finding(module, import.line, path, written.clone())).collect()
    }

    fn mention(&self, id: ModuleId, module: &Module, mention: &Mention) -> Vec<Banned> {
        let written = mention.path.to_string();
        if mention.want == Spaces::MACROS {
            let called = self.macro_met(&mention.path);
            return called
                .map(|path| self.finding(module, mention.line, path, format!("{written}!")))
                .into_iter()
                .collect();
        }
        let targets = self.resolver.path(id, &mention.path, mention.want);
        let paths = targets.iter().flat_map(|target| self.paths_met(target, false));
        paths.map(|path| self.finding(module, mention.line, path, written.clone())).collect()
    }

    /// The banned paths that a target is, or is in. A glob also names what is below it.
    fn paths_met(&self, target: &Target, glob: bool) -> Vec<&str> {
        let Target::Outside(full) = target else { return Vec::new() };
        let met = |banned: &&&str| {
            let banned: Vec<&str> = banned.split("::").collect();
            let inside = full.len() >= banned.len() && banned.iter().zip(full).all(|(a, b)| a == b);
            let over =
                glob && full.len() + 1 == banned.len() && full.iter().zip(&banned).all(|(a, b)| a == b);
            inside || over
        };
        self.ban.paths.iter().filter(met).copied().collect()
    }

    /// The banned macro that is called, by its last name.
    fn macro_met(&self, path: &Path) -> Option<&str> {
        let last = path.segments.last()?;
        self.ban.paths.iter().copied().find(|banned| banned.strip_suffix('!') == Some(last))
    }

    fn finding(&self, module: &Module, line: usize, banned: &str, written: String) -> Banned {
        let (in_crate, file) = (self.name.to_owned(), module.file.clone());
        Banned { in_crate, file, line, banned: banned.to_owned(), written }
    }
}
