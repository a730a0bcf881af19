//! No circle between the modules of a crate.

use std::collections::{BTreeMap, BTreeSet};

use crate::module::{Import, Module, Tree};

type Path = Vec<String>;

/// Which module uses which, each with the first place where it does: file, line and the path that is written.
pub type Uses = BTreeMap<(Path, Path), String>;

/// What a path leads to.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Target {
    Module(Path),
    /// Something that this module defines.
    ItemOf(Path),
}

/// Imports of imports, and so on, are followed so far: those that go round would never end.
const DEEPEST: usize = 20;

/// Every arrow between two modules of a tree.
#[must_use]
pub fn uses(tree: &Tree) -> Uses {
    let mut found = Uses::new();
    for module in tree.values() {
        let mut add = |to: &Path, path: &[String], line: usize| {
            if *to != module.path {
                let place = format!("{} ({}:{line})", path.join("::"), module.file);
                found.entry((module.path.clone(), to.clone())).or_insert(place);
            }
        };
        for import in module.imports.iter().filter(|import| import.line > 0) {
            for to in used_by_import(tree, module, import) {
                add(&to, &import.path, import.line);
            }
        }
        for (path, line) in &module.mentions {
            for found in targets(tree, &module.path, path, false, 0) {
                let (Target::Module(to) | Target::ItemOf(to)) = found;
                add(&to, path, *line);
            }
        }
    }
    found
}

fn used_by_import(tree: &Tree, module: &Module, import: &Import) -> Vec<Path> {
    let mut used = Vec::new();
    for found in targets(tree, &module.path, &import.path, import.name == "*", 0) {
        match found {
            Target::ItemOf(home) => used.push(home),
            Target::Module(whole) if import.name == "*" => used.extend(through_glob(tree, &whole)),
            // A module that is imported is used where a path goes on from its name.
            Target::Module(whole) if import.is_passed_on || !leads_on(module, &import.name) => {
                used.push(whole);
            }
            Target::Module(_) => {}
        }
    }
    // `pub use child::Item` uses `child`, even where `child` has the item from elsewhere.
    if let (true, Some((_, before))) = (import.is_passed_on, import.path.split_last()) {
        let passed = targets(tree, &module.path, before, true, 0).into_iter();
        used.extend(passed.filter_map(|found| match found {
            Target::Module(passed) if passed.starts_with(&module.path) => Some(passed),
            _ => None,
        }));
    }
    used
}

/// What `use a::*` uses: `a`, and whatever `a` passes on, since nobody says which of it is meant.
fn through_glob(tree: &Tree, whole: &Path) -> Vec<Path> {
    let Some(module) = tree.get(whole) else { return Vec::new() };
    let passed = module.imports.iter().filter(|import| import.is_passed_on && import.name != "*");
    let homes = passed.flat_map(|import| used_by_import(tree, module, import));
    homes.chain([whole.clone()]).collect()
}

fn leads_on(module: &Module, name: &str) -> bool {
    let begins = |path: &Path| path.len() > 1 && path[0] == name;
    module.mentions.iter().any(|(path, _)| begins(path))
        || module.imports.iter().any(|import| begins(&import.path))
}

/// What a path leads to that is written in module `at`; nothing if that is in another crate. `goes_on` if only a module is meant.
fn targets(tree: &Tree, at: &[String], path: &[String], goes_on: bool, depth: usize) -> Vec<Target> {
    let Some((first, rest)) = path.split_first().filter(|_| depth < DEEPEST) else { return Vec::new() };
    match first.as_str() {
        "crate" => below(tree, &[], rest, goes_on, depth),
        "self" => below(tree, at, rest, goes_on, depth),
        "super" => {
            let above = at.split_last().map_or(at, |(_, above)| above);
            let is_higher = rest.first().is_some_and(|next| next == "super");
            if is_higher {
                targets(tree, above, rest, goes_on, depth + 1)
            } else {
                below(tree, above, rest, goes_on, depth)
            }
        }
        _ => named(tree, at, path, goes_on, depth),
    }
}

/// What the names of a path lead to in module `at`. What no module defines, a macro is taken to have made there.
fn below(tree: &Tree, at: &[String], path: &[String], goes_on: bool, depth: usize) -> Vec<Target> {
    if path.is_empty() {
        return vec![Target::Module(at.to_vec())];
    }
    let found = named(tree, at, path, goes_on, depth);
    let is_imported =
        tree.get(at).is_some_and(|module| module.imports.iter().any(|import| import.name == path[0]));
    let is_known = is_imported || tree.contains_key([at, &path[..1]].concat().as_slice());
    if found.is_empty() && !is_known { vec![Target::ItemOf(at.to_vec())] } else { found }
}

/// The same for names that are known in module `at`: modules in it, what it imports, and what it defines.
fn named(tree: &Tree, at: &[String], path: &[String], goes_on: bool, depth: usize) -> Vec<Target> {
    let (Some((first, rest)), Some(module)) = (path.split_first(), tree.get(at)) else { return Vec::new() };
    let mut found = Vec::new();
    let child = [at, std::slice::from_ref(first)].concat();
    let is_item = module.items.contains(first);
    let leads_on = goes_on || !rest.is_empty();
    if tree.contains_key(&child) && (leads_on || !is_item) {
        return below(tree, &child, rest, goes_on, depth);
    }
    let imports = module.imports.iter().filter(|import| import.name == *first && import.path != path[..1]);
    for import in imports.filter(|_| leads_on || !is_item) {
        for target in targets(tree, at, &import.path, leads_on, depth + 1) {
            match target {
                Target::Module(to) => found.extend(below(tree, &to, rest, goes_on, depth + 1)),
                Target::ItemOf(_) => found.push(target),
            }
        }
    }
    if found.is_empty() && is_item {
        found.push(Target::ItemOf(at.to_vec()));
    }
    let globs = module.imports.iter().filter(|import| import.name == "*" && found.is_empty());
    let mut through = Vec::new();
    for target in globs.flat_map(|import| targets(tree, at, &import.path, true, depth + 1)) {
        if let Target::Module(whole) = target
            && whole != at
        {
            through.extend(named(tree, &whole, path, goes_on, depth + 1));
        }
    }
    found.extend(through);
    found
}

/// The circles of a tree, each as its modules with an arrow from each to the next ones.
#[must_use]
pub fn circles(tree: &Tree) -> Vec<String> {
    let uses = uses(tree);
    let reached: BTreeMap<&Path, BTreeSet<&Path>> =
        tree.keys().map(|start| (start, reached(&uses, start))).collect();
    let mut groups: BTreeSet<Vec<&Path>> = BTreeSet::new();
    for (start, found) in &reached {
        if found.contains(*start) {
            groups.insert(found.iter().copied().filter(|other| reached[*other].contains(*start)).collect());
        }
    }
    let shown = |group: Vec<&Path>| {
        let inside = uses.iter().filter(|((from, to), _)| group.contains(&from) && group.contains(&to));
        let arrows: Vec<String> = inside
            .map(|((from, to), place)| format!("\n  {} -> {}: {place}", name(from), name(to)))
            .collect();
        format!("{} modules use each other in a circle:{}", group.len(), arrows.concat())
    };
    groups.into_iter().map(shown).collect()
}

fn name(path: &[String]) -> String {
    ["crate"].into_iter().chain(path.iter().map(String::as_str)).collect::<Vec<_>>().join("::")
}

/// All modules that one uses, directly or through others.
fn reached<'u>(uses: &'u Uses, start: &Path) -> BTreeSet<&'u Path> {
    let mut found = BTreeSet::new();
    let mut open = vec![start];
    while let Some(from) = open.pop() {
        for (_, to) in uses.keys().filter(|(used_by, _)| used_by == from) {
            if found.insert(to) {
                open.push(to);
            }
        }
    }
    found
}
