//! Places of a file that name objects which were removed: OpenSim still reads the file, and finds less.

use foldhash::{HashMap, HashMapExt, HashSet, HashSetExt};
use osim_model::{ElementId, Tree, opensim_text};

use super::rebuilt::{Deed, Rebuilt};
use super::sets::{FORCE_SET, GEOMETRY_SET};

/// An object of a model that names others which the model does not have any more.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Leftover {
    /// Its class and its name, such as `ObjectGroup feet`.
    pub object: String,
    /// What it names, in its order.
    pub names: Vec<String>,
}

/// Objects of `rebuilt` that name what went with it: groups by names, reporters and others by paths.
#[must_use]
pub fn leftovers(rebuilt: &Rebuilt) -> Vec<Leftover> {
    let paths = |deed: Deed| {
        let own = rebuilt.objects.iter().filter(move |object| object.deed == deed);
        own.map(|object| object.path.as_str()).collect::<HashSet<&str>>()
    };
    let new = paths(Deed::Added);
    let gone: HashSet<&str> = paths(Deed::Removed).into_iter().filter(|path| !new.contains(path)).collect();
    let mut found: Vec<Leftover> = Vec::new();
    if gone.is_empty() {
        return found;
    }
    let tree = rebuilt.model().document().tree();
    let (mut by_owner, mut said) = (HashMap::new(), HashSet::new());
    for leaf in tree.elements().filter(|&id| tree.children(id).next().is_none()) {
        let names = named_in(tree, leaf, &gone);
        if names.is_empty() {
            continue;
        }
        let owner = owner(tree, leaf);
        let at = *by_owner.entry(owner).or_insert_with(|| {
            found.push(Leftover { object: called(tree, owner), names: Vec::new() });
            found.len() - 1
        });
        if let Some(leftover) = found.get_mut(at) {
            leftover.names.extend(names.into_iter().filter(|name| said.insert((at, name.clone()))));
        }
    }
    found
}

/// What of `gone` the text of `leaf` names.
fn named_in(tree: &Tree, leaf: ElementId, gone: &HashSet<&str>) -> Vec<String> {
    let set = if tree.name(leaf) == "members" { set_of_group(tree, leaf) } else { None };
    let text = tree.text_of(leaf);
    // Most texts are numbers.
    if set.is_none() && !text.contains('/') {
        return Vec::new();
    }
    let path = |word: &str| match &set {
        Some(set) => Some(format!("/{set}/{word}")).filter(|path| gone.contains(path.as_str())),
        None => object_of(word, gone),
    };
    opensim_text::list(&text)
        .filter_map(path)
        .map(|path| path.rsplit('/').next().unwrap_or_default().to_owned())
        .collect()
}

/// The set whose groups `members` belongs to, as paths call it.
fn set_of_group(tree: &Tree, members: ElementId) -> Option<String> {
    let groups = tree.parent(tree.parent(members)?)?;
    let set = tree.name(tree.parent(groups)?);
    [FORCE_SET.tag, GEOMETRY_SET.tag].contains(&set).then(|| set.to_ascii_lowercase())
}

/// The path of `gone` that a path leads to or into: `/forceset/heel|force` is an output of `/forceset/heel`.
fn object_of(word: &str, gone: &HashSet<&str>) -> Option<String> {
    let path = word.split('|').next().unwrap_or(word).trim_start_matches(['.', '/']);
    let path = format!("/{path}");
    let ends = path.match_indices('/').map(|(at, _)| at).skip(1).chain([path.len()]);
    let mut objects = ends.filter_map(|end| path.get(..end));
    objects.find(|object| gone.contains(object)).map(str::to_owned)
}

/// The object that `leaf` belongs to.
fn owner(tree: &Tree, leaf: ElementId) -> Option<ElementId> {
    std::iter::successors(tree.parent(leaf), |&id| tree.parent(id))
        .find(|&id| tree.attribute(id, "name").is_some())
}

fn called(tree: &Tree, owner: Option<ElementId>) -> String {
    let name = |id: ElementId| Some(format!("{} {}", tree.name(id), tree.attribute(id, "name")?));
    owner.and_then(name).unwrap_or_default()
}
