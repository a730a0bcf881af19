//! Finds out what the names of all modules mean.
//!
//! An import may lead through other imports, in any order and through globs in a ring. So imports are followed in rounds,
//! each by what the round before has found, until nothing new comes up.

use std::collections::{BTreeMap, BTreeSet};

use crate::syntax::{Import, Spaces};
use crate::tree::{Module, ModuleId, Tree};

use super::scopes::{Entry, Scope, Scopes};
use super::target::Target;

/// More than any chain of re-exports is long.
const ROUNDS: usize = 64;

/// Imports, by their module and their place in it.
type Imports = BTreeSet<(ModuleId, usize)>;

/// The names of all modules of a tree.
pub(super) fn scopes<'t>(tree: &'t Tree, crates: &'t [String]) -> Scopes<'t> {
    let mut scopes = Scopes { tree, crates, of: BTreeMap::new() };
    scopes.of = tree.iter().map(|(id, module)| (id, own(tree, id, module))).collect();
    // Guesses only begin when all is known that can be known.
    settle(&mut scopes, &Imports::new());
    let unclear = unclear(&scopes);
    settle(&mut scopes, &unclear);
    scopes
}

/// Follows imports until nothing changes; those of `unclear` may be guessed.
fn settle(scopes: &mut Scopes<'_>, unclear: &Imports) {
    for _ in 0..ROUNDS {
        let tree = scopes.tree;
        let next: BTreeMap<ModuleId, Scope> =
            tree.iter().map(|(id, module)| (id, round(scopes, id, module, unclear))).collect();
        if next == scopes.of {
            return;
        }
        scopes.of = next;
    }
}

/// Imports that lead nowhere so far.
fn unclear(scopes: &Scopes<'_>) -> Imports {
    let mut found = Imports::new();
    for (id, module) in scopes.tree.iter() {
        for (index, import) in module.facts.imports.iter().enumerate() {
            if scopes.follow(id, &import.path, false).is_empty() {
                found.insert((id, index));
            }
        }
    }
    found
}

/// What a module defines.
fn own(tree: &Tree, id: ModuleId, module: &Module) -> Scope {
    let mut scope = Scope::default();
    for item in &module.facts.items {
        let entry = Entry { target: Target::of_item(id, item), seen_in: tree.top(id, item.sight) };
        let names = if item.local { &mut scope.named_inside } else { &mut scope.named };
        names.add(&item.name, entry);
    }
    for child in &module.children {
        let entry = Entry { target: Target::Module(child.id), seen_in: tree.top(id, child.sight) };
        scope.named.add(&child.name, entry);
    }
    scope
}

/// What a module defines and imports, by what `known` says of the others.
fn round(known: &Scopes<'_>, id: ModuleId, module: &Module, unclear: &Imports) -> Scope {
    let mut scope = own(known.tree, id, module);
    for (index, import) in module.facts.imports.iter().enumerate() {
        let targets = known.follow(id, &import.path, unclear.contains(&(id, index)));
        let seen_in = known.tree.top(id, import.sight);
        if import.glob {
            let names = if import.local { &mut scope.globbed_inside } else { &mut scope.globbed };
            for (name, entry) in targets.iter().flat_map(|target| through_glob(known, id, target)) {
                names.add(name, Entry { seen_in: narrower(known.tree, seen_in, entry.seen_in), ..entry });
            }
        } else if let Some(name) = &import.name {
            let names = if import.local { &mut scope.named_inside } else { &mut scope.named };
            for target in targets.into_iter().filter(|target| fits(target, import)) {
                names.add(name, Entry { target, seen_in });
            }
        }
    }
    scope
}

fn fits(target: &Target, import: &Import) -> bool {
    target.spaces().meets(import.spaces)
}

/// What a glob brings in from a module or an enum.
fn through_glob<'k>(known: &'k Scopes<'_>, id: ModuleId, target: &Target) -> Vec<(&'k str, Entry)> {
    match target {
        Target::Module(module) => known.seen(*module, id),
        Target::Item { home, name, .. } => {
            let target = Target::named(*home, name, Spaces::ITEMS);
            let entry = Entry { target, seen_in: ModuleId::ROOT };
            known.variants(*home, name).map(|variant| (variant.as_str(), entry.clone())).collect()
        }
        Target::Outside(_) => Vec::new(),
    }
}

/// The one of two modules that stands in the other.
fn narrower(tree: &Tree, a: ModuleId, b: ModuleId) -> ModuleId {
    if tree.upwards(a).any(|above| above == b) { a } else { b }
}
