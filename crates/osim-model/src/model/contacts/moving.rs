//! Spheres that move, and their radii.

use super::{Force, ForceId, SphereId};
use crate::model::Model;

/// Root of the mean of squared radii; exactly the common value where all are equal.
#[must_use]
pub fn root_mean_square(radii: impl Iterator<Item = f64> + Clone) -> f64 {
    let mut others = radii.clone();
    match others.next() {
        None => f64::NAN,
        Some(first) if others.all(|other| other == first) => first,
        Some(_) => {
            let (sum, count) =
                radii.fold((0.0, 0.0), |(sum, count), radius| (sum + radius * radius, count + 1.0));
            (sum / count).sqrt()
        }
    }
}

/// The spheres of `forces` that are neither on ground nor on a body welded to it, each once, in file order: those whose radii
/// may change.
#[must_use]
pub fn moving_spheres(model: &Model, forces: &[ForceId]) -> Vec<SphereId> {
    let mut spheres: Vec<SphereId> =
        forces.iter().filter_map(|&id| model.force(id)).flat_map(Force::spheres).collect();
    spheres.sort_unstable();
    spheres.dedup();
    spheres.retain(|&index| model.sphere(index).is_some_and(|sphere| !sphere.fixed));
    spheres
}
