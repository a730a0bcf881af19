//! Left and right contacts that differ.

use std::collections::HashMap;

use crate::contacts::Force;
use crate::finding::{Finding, FindingCode};
use crate::model::Model;
use crate::side::{Side, without_side};

impl Model {
    /// The force on the right that has the name of `left` but for the side.
    #[must_use]
    pub fn right_of(&self, left: &Force) -> Option<&Force> {
        let name = without_side(&left.name);
        let is_right = |force: &&Force| Side::of_name(&force.name) == Some(Side::Right);
        self.forces().iter().filter(is_right).find(|force| without_side(&force.name) == name)
    }
}

/// Forces whose names differ only in the side should have equal parameters.
pub(super) fn left_and_right(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    let mut right: HashMap<String, &Force> = HashMap::new();
    let side = |name: &str| Side::of_name(name);
    for force in model.forces() {
        if side(&force.name) == Some(Side::Right) {
            right.entry(without_side(&force.name)).or_insert(force);
        }
    }
    for force in model.forces().iter().filter(|force| side(&force.name) == Some(Side::Left)) {
        let Some(other) = right.get(&without_side(&force.name)).copied() else {
            continue;
        };
        let differing = force.sets.iter().zip(&other.sets).find_map(|(left, right)| {
            left.values.iter().zip(&right.values).find(|(l, r)| l.number != r.number && !l.number.is_nan())
        });
        let radii = |force: &Force| -> Vec<u64> {
            let spheres = force.spheres().into_iter().filter_map(|id| model.sphere(id));
            spheres.map(|sphere| sphere.radius.number.to_bits()).collect()
        };
        let what = match differing {
            Some((left, right)) => format!("{} is {} and {}", left.property, left.number, right.number),
            None if radii(force) != radii(other) => "radii differ".to_owned(),
            None => continue,
        };
        let text = format!("{} and {} differ: {what}", force.path, other.path);
        found.push(Finding::at(FindingCode::LeftRightDiffer, force.line, text).about(&force.path));
    }
    found
}
