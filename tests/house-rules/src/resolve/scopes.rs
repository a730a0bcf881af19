//! For each module, what its names mean; and what a path means by that.

use std::collections::BTreeMap;

use crate::syntax::{Path, Spaces};
use crate::tree::{ModuleId, Tree};

use super::target::Target;

/// Crates that every crate has.
const STANDARD: [&str; 4] = ["std", "core", "alloc", "proc_macro"];

/// Something that a name means.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Entry {
    pub(super) target: Target,
    /// It is seen in this module and in those below it.
    pub(super) seen_in: ModuleId,
}

/// Names with all that they mean.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Names(BTreeMap<String, Vec<Entry>>);

impl Names {
    pub(super) fn add(&mut self, name: &str, entry: Entry) {
        let entries = self.0.entry(name.to_owned()).or_default();
        if !entries.contains(&entry) {
            entries.push(entry);
        }
    }

    fn get(&self, name: &str) -> impl Iterator<Item = &Entry> {
        self.0.get(name).into_iter().flatten()
    }
}

/// The names of one module.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Scope {
    /// Defined here, or imported by name.
    pub(super) named: Names,
    /// Imported by a glob.
    pub(super) globbed: Names,
    /// The same of what stands in functions, which the module alone sees.
    pub(super) named_inside: Names,
    pub(super) globbed_inside: Names,
}

/// The names of all modules.
pub(super) struct Scopes<'t> {
    pub(super) tree: &'t Tree,
    /// Names of crates that this one depends on.
    pub(super) crates: &'t [String],
    pub(super) of: BTreeMap<ModuleId, Scope>,
}

impl<'t> Scopes<'t> {
    /// Everything that a path can mean. Where no name is found, and `guess` allows it, the path is taken to lead to
    /// another crate, or to something that a macro has made.
    pub(super) fn follow(&self, from: ModuleId, path: &Path, guess: bool) -> Vec<Target> {
        let Some((first, rest)) = path.segments.split_first() else { return Vec::new() };
        if path.global {
            return vec![Target::Outside(path.segments.clone())];
        }
        let mut targets = self.first(from, first, !rest.is_empty(), guess);
        for segment in rest {
            let holders = targets.into_iter().filter(|target| target.spaces().meets(Spaces::TYPES));
            targets = holders.flat_map(|holder| self.step(holder, segment, from, guess)).collect();
        }
        targets
    }

    /// All entries of a module that `viewer` sees, with their names. What is named outright hides what a glob brings.
    pub(super) fn seen(&self, module: ModuleId, viewer: ModuleId) -> Vec<(&str, Entry)> {
        let Some(scope) = self.of.get(&module) else { return Vec::new() };
        let names = scope
            .named
            .0
            .keys()
            .chain(scope.globbed.0.keys().filter(|name| !scope.named.0.contains_key(*name)));
        names
            .flat_map(|name| {
                self.entries(module, name, viewer, false).into_iter().map(|entry| (name.as_str(), entry))
            })
            .collect()
    }

    /// The variants of an enum.
    pub(super) fn variants(&self, home: ModuleId, name: &str) -> impl Iterator<Item = &'t String> {
        let items = self.tree.get(home).into_iter().flat_map(|module| &module.facts.items);
        let name = name.to_owned();
        items.filter(move |item| item.name == name).flat_map(|item| &item.variants)
    }

    fn first(&self, from: ModuleId, name: &str, more: bool, guess: bool) -> Vec<Target> {
        match name {
            "crate" | "$crate" => return vec![Target::Module(ModuleId::ROOT)],
            "self" => return vec![Target::Module(from)],
            "super" => return self.parent(from),
            "Self" => return Vec::new(),
            _ => {}
        }
        let mut found = self.targets(from, name, from, true);
        if more {
            found.retain(|target| target.spaces().meets(Spaces::TYPES));
        }
        if found.is_empty() && self.is_own_crate(name) {
            found.push(Target::Module(ModuleId::ROOT));
        } else if found.is_empty() && (self.is_crate(name) || (more && guess)) {
            found.push(Target::Outside(vec![name.to_owned()]));
        }
        found
    }

    /// `extern crate self as name`, which holds in every module.
    fn is_own_crate(&self, name: &str) -> bool {
        let imports = self.tree.get(ModuleId::ROOT).into_iter().flat_map(|root| &root.facts.imports);
        let mut named = imports.filter(|import| import.name.as_deref() == Some(name));
        named.any(|import| matches!(import.path.segments.as_slice(), [only] if only == "crate"))
    }

    fn is_crate(&self, name: &str) -> bool {
        STANDARD.contains(&name) || self.crates.iter().any(|known| known == name)
    }

    fn parent(&self, module: ModuleId) -> Vec<Target> {
        self.tree.upwards(module).nth(1).map(Target::Module).into_iter().collect()
    }

    /// One name further. What stands behind a type belongs to the type.
    fn step(&self, holder: Target, name: &str, viewer: ModuleId, guess: bool) -> Vec<Target> {
        match holder {
            Target::Outside(mut path) => {
                path.push(name.to_owned());
                vec![Target::Outside(path)]
            }
            Target::Item { home, name, .. } => vec![Target::named(home, &name, Spaces::ALL)],
            Target::Module(module) if name == "super" => self.parent(module),
            Target::Module(module) => {
                let found = self.targets(module, name, viewer, false);
                if found.is_empty() && guess { self.unknown(module, name) } else { found }
            }
        }
    }

    /// A name that the module does not seem to have: a macro has made it, or it is an exported macro.
    fn unknown(&self, module: ModuleId, name: &str) -> Vec<Target> {
        let exported = if module == ModuleId::ROOT { self.tree.macros.get(name) } else { None };
        let homes = exported.cloned().unwrap_or_else(|| vec![module]);
        homes.into_iter().map(|home| Target::named(home, name, Spaces::ALL)).collect()
    }

    fn targets(&self, module: ModuleId, name: &str, viewer: ModuleId, inside: bool) -> Vec<Target> {
        self.entries(module, name, viewer, inside).into_iter().map(|entry| entry.target).collect()
    }

    /// What a module calls by this name, as far as `viewer` sees it; with what its functions define if `inside`.
    fn entries(&self, module: ModuleId, name: &str, viewer: ModuleId, inside: bool) -> Vec<Entry> {
        let Some(scope) = self.of.get(&module) else { return Vec::new() };
        let both = |outside: &'_ Names, within: &'_ Names| {
            let within = within.get(name).filter(|_| inside).cloned();
            let outside = outside.get(name).filter(|entry| self.sees(viewer, entry)).cloned();
            outside.chain(within).collect::<Vec<Entry>>()
        };
        let mut found = both(&scope.named, &scope.named_inside);
        let taken = found.iter().fold(Spaces::NONE, |taken, entry| taken.with(entry.target.spaces()));
        let globbed = both(&scope.globbed, &scope.globbed_inside);
        found.extend(globbed.into_iter().filter(|entry| !entry.target.spaces().meets(taken)));
        found
    }

    fn sees(&self, viewer: ModuleId, entry: &Entry) -> bool {
        self.tree.upwards(viewer).any(|above| above == entry.seen_in)
    }
}
