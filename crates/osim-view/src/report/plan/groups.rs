//! Equal changes together, so that twelve spheres are one line.

use std::collections::{HashMap, HashSet};

use osim_model::Property;
use osim_patch::Change;

/// Equal changes together, in the order of the first of each.
pub fn groups(changes: &[Change]) -> Vec<Vec<&Change>> {
    let mut groups: Vec<Vec<&Change>> = Vec::new();
    let mut places = HashMap::new();
    for change in changes {
        // What a group has in common.
        let key =
            (change.property, change.from.to_bits(), change.to.to_bits(), change.equation, change.inserted);
        let place = *places.entry(key).or_insert(groups.len());
        match groups.get_mut(place) {
            Some(group) => group.push(change),
            None => groups.push(vec![change]),
        }
    }
    groups
}

/// The force or sphere of a group, or how many there are.
pub fn whose(group: &[&Change]) -> String {
    let one = group.first().and_then(|change| change.sphere.clone().or_else(|| change.force.clone()));
    match (group.len(), group.first().is_some_and(|change| change.sphere.is_some())) {
        (1, _) => one.unwrap_or_default(),
        (count, true) => format!("{count} spheres"),
        (count, false) => format!("{count} forces"),
    }
}

/// The properties with several groups, which need names.
pub fn several_groups(groups: &[Vec<&Change>]) -> HashSet<Property> {
    let mut seen = HashSet::new();
    let properties = groups.iter().filter_map(|group| group.first()).map(|change| change.property);
    properties.filter(|&property| !seen.insert(property)).collect()
}

/// The spheres or forces of a group.
pub fn names<'c>(group: &[&'c Change]) -> Vec<&'c str> {
    group.iter().filter_map(|change| change.sphere.as_deref().or(change.force.as_deref())).collect()
}
