//! Finds circles between the modules of a crate: modules that use each other, directly or through others.

use std::collections::{BTreeMap, BTreeSet};

use crate::source::{Module, Tree};

type Path = Vec<String>;

/// Pairs of modules of which the first uses the second, with the first place: file, line and the path in the code.
pub type Uses = BTreeMap<(Path, Path), String>;

/// Most imports of imports that are followed, because imports in a circle never end.
const MOST_FOLLOWED_IMPORTS: usize = 20;

/// The module or item that a path in the code names.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Target {
    Module(Path),
    /// A function, type or constant of the module with this path.
    ItemOf(Path),
}

/// All uses between two modules of a tree.
#[must_use]
pub fn uses(tree: &Tree) -> Uses {
    let mut arrows = Uses::new();
    for module in tree.values() {
        let mut add = |to: Path, path: &[String], line: usize| {
            if to != module.path {
                let place = format!("{} ({}:{line})", path.join("::"), module.file);
                arrows.entry((module.path.clone(), to)).or_insert(place);
            }
        };
        for import in module.imports.iter().filter(|import| import.line > 0) {
            for target in targets_of_path(tree, module, &import.path, 0) {
                match target {
                    Target::ItemOf(home) => add(home, &import.path, import.line),
                    // An imported module is used where a path continues from it.
                    Target::Module(whole) if import.is_passed_on || import.name == "*" => {
                        add(whole, &import.path, import.line);
                    }
                    Target::Module(_) => {}
                }
            }
            // `pub use child::Item` uses `child`, even where `child` has the item from elsewhere.
            if let Some((_, before)) = import.path.split_last().filter(|_| import.is_passed_on) {
                for target in targets_of_path(tree, module, before, 0) {
                    if let Target::Module(child) = target
                        && child.starts_with(&module.path)
                    {
                        add(child, &import.path, import.line);
                    }
                }
            }
        }
        for (path, line) in &module.mentions {
            for target in targets_of_path(tree, module, path, 0) {
                let (Target::Module(to) | Target::ItemOf(to)) = target;
                add(to, path, *line);
            }
        }
    }
    arrows
}

/// The targets of a path in the code of a module; none if it leads to another crate.
fn targets_of_path(tree: &Tree, at: &Module, path: &[String], depth: usize) -> Vec<Target> {
    let Some((first, rest)) = path.split_first() else { return vec![Target::Module(at.path.clone())] };
    let above = at.path.split_last().map_or(&[][..], |(_, above)| above);
    match first.as_str() {
        "crate" => targets_below(tree, &[], rest, depth),
        "self" => targets_below(tree, &at.path, rest, depth),
        "super" if rest.first().is_some_and(|next| next == "super") => {
            tree.get(above).map_or_else(Vec::new, |above| targets_of_path(tree, above, rest, depth))
        }
        "super" => targets_below(tree, above, rest, depth),
        _ => targets_from_module(tree, at, path, depth),
    }
}

/// The targets of the rest of a path after the module `at`. An item that no module defines counts as defined in `at` by a macro.
fn targets_below(tree: &Tree, at: &[String], path: &[String], depth: usize) -> Vec<Target> {
    let Some(module) = tree.get(at) else { return Vec::new() };
    let targets = if path.is_empty() {
        vec![Target::Module(at.to_vec())]
    } else {
        targets_from_module(tree, module, path, depth)
    };
    let is_known = || {
        tree.contains_key([at, &path[..1]].concat().as_slice())
            || module.imports.iter().any(|import| import.name == path[0] || import.name == "*")
    };
    if targets.is_empty() && !is_known() { vec![Target::ItemOf(at.to_vec())] } else { targets }
}

/// The targets of a path that begins with a name of the module: a child module, an item or an import.
fn targets_from_module(tree: &Tree, at: &Module, path: &[String], depth: usize) -> Vec<Target> {
    let Some((first, rest)) = path.split_first().filter(|_| depth < MOST_FOLLOWED_IMPORTS) else {
        return Vec::new();
    };
    let is_item = at.items.contains(first);
    let child = [at.path.as_slice(), std::slice::from_ref(first)].concat();
    if tree.contains_key(&child) && (!rest.is_empty() || !is_item) {
        return targets_below(tree, &child, rest, depth);
    }
    let imports = at.imports.iter().filter(|import| import.name == *first && import.path != path[..1]);
    let imports = imports.filter(|_| !rest.is_empty() || !is_item);
    let through =
        imports.flat_map(|import| targets_of_path(tree, at, &[&import.path, rest].concat(), depth + 1));
    let mut targets: Vec<Target> = through.collect();
    if targets.is_empty() && is_item {
        targets.push(Target::ItemOf(at.path.clone()));
    }
    targets
}

/// The circles of a tree, each as a text with its modules and arrows from each module to the modules that it uses.
#[must_use]
pub fn circles(tree: &Tree) -> Vec<String> {
    let uses = uses(tree);
    let used_by: BTreeMap<&Path, BTreeSet<&Path>> =
        tree.keys().map(|start| (start, modules_used_by(&uses, start))).collect();
    let mut groups: BTreeSet<Vec<&Path>> = BTreeSet::new();
    for (start, used) in &used_by {
        if used.contains(*start) {
            groups.insert(used.iter().copied().filter(|other| used_by[*other].contains(*start)).collect());
        }
    }
    let describe = |group: Vec<&Path>| {
        let inside = uses.iter().filter(|((from, to), _)| group.contains(&from) && group.contains(&to));
        let arrows: Vec<String> = inside
            .map(|((from, to), place)| format!("\n  {} -> {}: {place}", module_name(from), module_name(to)))
            .collect();
        format!("{} modules use each other in a circle:{}", group.len(), arrows.concat())
    };
    groups.into_iter().map(describe).collect()
}

fn module_name(path: &[String]) -> String {
    ["crate"].into_iter().chain(path.iter().map(String::as_str)).collect::<Vec<_>>().join("::")
}

/// All modules that the module `start` uses, directly or through other modules.
fn modules_used_by<'u>(uses: &'u Uses, start: &Path) -> BTreeSet<&'u Path> {
    let mut reached = BTreeSet::new();
    let mut pending = vec![start];
    while let Some(from) = pending.pop() {
        for (_, to) in uses.keys().filter(|(used_by, _)| used_by == from) {
            if reached.insert(to) {
                pending.push(to);
            }
        }
    }
    reached
}
