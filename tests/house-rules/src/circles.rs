//! No circle between the modules of a crate.

use std::collections::{BTreeMap, BTreeSet};

use crate::source::{Module, Tree};

type Path = Vec<String>;

/// Which module uses which, each with the first place where it does: file, line and the path that is written.
pub type Uses = BTreeMap<(Path, Path), String>;

/// Imports of imports, and so on, are followed so far: those that go round would never end.
const DEEPEST: usize = 20;

/// What a path leads to.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Target {
    Module(Path),
    /// Something that this module defines.
    ItemOf(Path),
}

/// Every arrow between two modules of a tree.
#[must_use]
pub fn uses(tree: &Tree) -> Uses {
    let mut found = Uses::new();
    for module in tree.values() {
        let mut add = |to: Path, path: &[String], line: usize| {
            if to != module.path {
                let place = format!("{} ({}:{line})", path.join("::"), module.file);
                found.entry((module.path.clone(), to)).or_insert(place);
            }
        };
        for import in module.imports.iter().filter(|import| import.line > 0) {
            for target in targets(tree, module, &import.path, 0) {
                match target {
                    Target::ItemOf(home) => add(home, &import.path, import.line),
                    // Where a path goes on from a module that is imported, it says what is used.
                    Target::Module(whole) if import.is_passed_on || import.name == "*" => {
                        add(whole, &import.path, import.line);
                    }
                    Target::Module(_) => {}
                }
            }
            // `pub use child::Item` uses `child`, even where `child` has the item from elsewhere.
            if let Some((_, before)) = import.path.split_last().filter(|_| import.is_passed_on) {
                for target in targets(tree, module, before, 0) {
                    if let Target::Module(child) = target
                        && child.starts_with(&module.path)
                    {
                        add(child, &import.path, import.line);
                    }
                }
            }
        }
        for (path, line) in &module.mentions {
            for target in targets(tree, module, path, 0) {
                let (Target::Module(to) | Target::ItemOf(to)) = target;
                add(to, path, *line);
            }
        }
    }
    found
}

/// What a path leads to that is written in a module; nothing if that is in another crate.
fn targets(tree: &Tree, at: &Module, path: &[String], depth: usize) -> Vec<Target> {
    let Some((first, rest)) = path.split_first() else { return vec![Target::Module(at.path.clone())] };
    let above = at.path.split_last().map_or(&[][..], |(_, above)| above);
    match first.as_str() {
        "crate" => below(tree, &[], rest, depth),
        "self" => below(tree, &at.path, rest, depth),
        "super" if rest.first().is_some_and(|next| next == "super") => {
            tree.get(above).map_or_else(Vec::new, |above| targets(tree, above, rest, depth))
        }
        "super" => below(tree, above, rest, depth),
        _ => named(tree, at, path, depth),
    }
}

/// What a path leads to from a module that it names. What no module defines, a macro is taken to have made there.
fn below(tree: &Tree, at: &[String], path: &[String], depth: usize) -> Vec<Target> {
    let Some(module) = tree.get(at) else { return Vec::new() };
    let found =
        if path.is_empty() { vec![Target::Module(at.to_vec())] } else { named(tree, module, path, depth) };
    let is_known = || {
        tree.contains_key([at, &path[..1]].concat().as_slice())
            || module.imports.iter().any(|import| import.name == path[0] || import.name == "*")
    };
    if found.is_empty() && !is_known() { vec![Target::ItemOf(at.to_vec())] } else { found }
}

/// What a path leads to that begins with a name which a module knows: a module in it, what it defines or imports.
fn named(tree: &Tree, at: &Module, path: &[String], depth: usize) -> Vec<Target> {
    let Some((first, rest)) = path.split_first().filter(|_| depth < DEEPEST) else { return Vec::new() };
    let is_item = at.items.contains(first);
    let child = [at.path.as_slice(), std::slice::from_ref(first)].concat();
    if tree.contains_key(&child) && (!rest.is_empty() || !is_item) {
        return below(tree, &child, rest, depth);
    }
    let imports = at.imports.iter().filter(|import| import.name == *first && import.path != path[..1]);
    let imports = imports.filter(|_| !rest.is_empty() || !is_item);
    let through = imports.flat_map(|import| targets(tree, at, &[&import.path, rest].concat(), depth + 1));
    let mut found: Vec<Target> = through.collect();
    if found.is_empty() && is_item {
        found.push(Target::ItemOf(at.path.clone()));
    }
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
