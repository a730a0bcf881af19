//! No circle between the modules of a crate.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use crate::package::Package;
use crate::tree::{ModuleId, Tree};
use crate::uses::{Use, uses};

/// One module names what another one defines, in one place.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Arrow {
    /// The module that names something, as `crate::a`.
    pub from: String,
    /// The module that defines it.
    pub to: String,
    /// The file in which it is named.
    pub file: String,
    /// Where in the file.
    pub line: usize,
    /// The path as it is written. Names of a group stand behind what is before the group.
    pub path: String,
}

impl fmt::Display for Arrow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { from, to, file, line, path } = self;
        write!(f, "{from} -> {to}: {path} ({file}:{line})")
    }
}

/// Modules each of which uses all others, directly or through others.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Circle {
    /// The crate.
    pub in_crate: String,
    /// Its modules, sorted.
    pub modules: Vec<String>,
    /// The shortest way round: each module uses the next, and the last the first.
    pub shortest: Vec<String>,
    /// Every place where one of them uses another.
    pub arrows: Vec<Arrow>,
}

/// For each arrow one place, and how many there are besides. `{:#}` shows all places.
impl fmt::Display for Circle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { in_crate, modules, shortest, arrows } = self;
        write!(
            f,
            "{in_crate}: {} modules use each other in a circle: {}",
            modules.len(),
            modules.join(", ")
        )?;
        if let Some(first) = shortest.first().filter(|_| shortest.len() < modules.len()) {
            write!(f, "\n  shortest way round: {} -> {first}", shortest.join(" -> "))?;
        }
        let mut by_modules: BTreeMap<(&str, &str), Vec<&Arrow>> = BTreeMap::new();
        for arrow in arrows {
            by_modules.entry((&arrow.from, &arrow.to)).or_default().push(arrow);
        }
        for places in by_modules.values() {
            let shown = if f.alternate() { places.len() } else { 1 };
            for arrow in places.iter().take(shown) {
                write!(f, "\n  {arrow}")?;
            }
            if places.len() > shown {
                write!(f, " and {} more", places.len() - shown)?;
            }
        }
        Ok(())
    }
}

/// All circles of a crate. Its library and its programs are crates of their own to the compiler, and so here.
pub(crate) fn circles(package: &Package) -> Vec<Circle> {
    let crates = package.crates();
    let of_tree = |tree: &Tree| {
        let uses = uses(tree, &crates);
        let groups = groups(tree, &uses);
        groups.into_iter().map(|group| circle(&package.name, tree, &uses, &group)).collect::<Vec<_>>()
    };
    let mut found: Vec<Circle> = Vec::new();
    for circle in package.trees.iter().flat_map(of_tree) {
        // A module of two targets is read for both.
        if !found.contains(&circle) {
            found.push(circle);
        }
    }
    found
}

/// Every arrow between modules of a crate, whether it is part of a circle or not.
pub(crate) fn arrows_of(package: &Package) -> Vec<Arrow> {
    let crates = package.crates();
    let of_tree = |tree: &Tree| {
        let uses = uses(tree, &crates);
        arrows(tree, uses.iter())
    };
    let found: BTreeSet<Arrow> = package.trees.iter().flat_map(of_tree).collect();
    found.into_iter().collect()
}

type Next = BTreeMap<ModuleId, BTreeSet<ModuleId>>;

/// Groups of two or more modules that reach each other.
fn groups(tree: &Tree, uses: &[Use]) -> Vec<BTreeSet<ModuleId>> {
    let mut next = Next::new();
    for one in uses {
        next.entry(one.from).or_default().insert(one.to);
    }
    let reached: BTreeMap<ModuleId, BTreeSet<ModuleId>> =
        tree.iter().map(|(id, _)| (id, reached(&next, id))).collect();
    let reaches = |a: ModuleId, b: ModuleId| reached.get(&a).is_some_and(|found| found.contains(&b));
    let mut groups = BTreeSet::new();
    for (id, _) in tree.iter() {
        let others = tree.iter().map(|(other, _)| other);
        let group: BTreeSet<ModuleId> =
            others.filter(|other| reaches(id, *other) && reaches(*other, id)).collect();
        if group.len() > 1 {
            groups.insert(group);
        }
    }
    groups.into_iter().collect()
}

/// All modules that one reaches.
fn reached(next: &Next, start: ModuleId) -> BTreeSet<ModuleId> {
    let mut found = BTreeSet::new();
    let mut open = vec![start];
    while let Some(id) = open.pop() {
        for other in next.get(&id).into_iter().flatten() {
            if found.insert(*other) {
                open.push(*other);
            }
        }
    }
    found
}

fn circle(in_crate: &str, tree: &Tree, uses: &[Use], group: &BTreeSet<ModuleId>) -> Circle {
    let inside: Vec<&Use> =
        uses.iter().filter(|one| group.contains(&one.from) && group.contains(&one.to)).collect();
    let mut modules: Vec<String> = group.iter().map(|id| path(tree, *id)).collect();
    modules.sort();
    let shortest = shortest(group, &inside).into_iter().map(|id| path(tree, id)).collect();
    let arrows = arrows(tree, inside.iter().copied());
    Circle { in_crate: in_crate.to_owned(), modules, shortest, arrows }
}

fn arrows<'u>(tree: &Tree, uses: impl Iterator<Item = &'u Use>) -> Vec<Arrow> {
    let arrow = |one: &Use| Arrow {
        from: path(tree, one.from),
        to: path(tree, one.to),
        file: tree.get(one.from).map_or_else(String::new, |module| module.file.clone()),
        line: one.line,
        path: one.path.clone(),
    };
    let mut arrows: Vec<Arrow> = uses.map(arrow).collect();
    arrows.sort();
    arrows
}

fn path(tree: &Tree, id: ModuleId) -> String {
    tree.get(id).map_or_else(String::new, |module| module.path.clone())
}

/// The shortest way from a module back to itself.
fn shortest(group: &BTreeSet<ModuleId>, inside: &[&Use]) -> Vec<ModuleId> {
    let mut next = Next::new();
    for one in inside {
        next.entry(one.from).or_default().insert(one.to);
    }
    let ways = group.iter().filter_map(|start| way_round(&next, *start));
    ways.min_by_key(Vec::len).unwrap_or_default()
}

fn way_round(next: &Next, start: ModuleId) -> Option<Vec<ModuleId>> {
    let mut ways = vec![vec![start]];
    let mut seen = BTreeSet::new();
    while !ways.is_empty() {
        let mut longer = Vec::new();
        for way in ways {
            for other in way.last().and_then(|last| next.get(last)).into_iter().flatten() {
                if *other == start {
                    return Some(way);
                }
                if seen.insert(*other) {
                    longer.push(way.iter().copied().chain([*other]).collect());
                }
            }
        }
        ways = longer;
    }
    None
}
