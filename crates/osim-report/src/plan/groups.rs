//! Equal changes together, so that twelve spheres are one line.

use osim_patch::Change;

/// Equal changes together, in the order of the first of each.
pub(crate) fn groups(changes: &[Change]) -> Vec<Vec<&Change>> {
    let mut groups: Vec<Vec<&Change>> = Vec::new();
    for change in changes {
        match groups.iter_mut().find(|group| group.first().is_some_and(|first| alike(first, change))) {
            Some(group) => group.push(change),
            None => groups.push(vec![change]),
        }
    }
    groups
}

fn alike(a: &Change, b: &Change) -> bool {
    (a.property, a.from.to_bits(), a.to.to_bits(), a.equation, a.inserted)
        == (b.property, b.from.to_bits(), b.to.to_bits(), b.equation, b.inserted)
}

/// The force or sphere of a group, or how many there are.
pub(crate) fn whose(group: &[&Change]) -> String {
    let one = group.first().and_then(|change| change.sphere.clone().or_else(|| change.force.clone()));
    match (group.len(), group.first().is_some_and(|change| change.sphere.is_some())) {
        (1, _) => one.unwrap_or_default(),
        (count, true) => format!("{count} spheres"),
        (count, false) => format!("{count} forces"),
    }
}
