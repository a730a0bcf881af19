//! What is special about forces without being wrong. A check says it of every force, a change of those that it changes.

use std::collections::HashSet;

use crate::contacts::{Force, ForceId, SphereId};
use crate::finding::{Finding, FindingCode};
use crate::model::Model;

impl Model {
    /// What is special about `forces` without being wrong, in the order of the codes' register.
    #[must_use]
    pub fn remarks_on(&self, forces: &[ForceId]) -> Vec<Finding> {
        let forces = || forces.iter().filter_map(|&id| self.force(id));
        let mut found: Vec<Finding> = forces().filter_map(|force| self.mixed_radii(force)).collect();
        found.extend(forces().filter_map(several_sets));
        found.extend(self.terrain(&forces().flat_map(Force::spheres).collect()));
        found.extend(forces().filter_map(disabled));
        found
    }

    /// One set of parameters for spheres of different radii.
    fn mixed_radii(&self, force: &Force) -> Option<Finding> {
        let set = force.sets.iter().find(|set| {
            let spheres = set.spheres.iter().filter_map(|&id| self.sphere(id));
            let mut radii = spheres.filter(|sphere| !sphere.fixed).map(|sphere| sphere.radius.number);
            radii.next().is_some_and(|first| radii.any(|radius| radius != first))
        })?;
        let text = format!("{} has spheres of different radii: the mean of R squared is used", force.path);
        Some(Finding::at(FindingCode::MixedRadii, set.line, text).about(&force.path))
    }

    /// Spheres on ground or on bodies welded to it.
    fn terrain(&self, spheres: &HashSet<SphereId>) -> Option<Finding> {
        let fixed: Vec<_> =
            self.spheres().iter().filter(|sphere| sphere.fixed && spheres.contains(&sphere.id)).collect();
        let first = fixed.first()?;
        let text = match fixed.len() {
            1 => format!("{} stands on ground: its radius stays", first.path),
            2 => format!("{} and one more sphere stand on ground: their radii stay", first.path),
            count => {
                format!("{} and {} more spheres stand on ground: their radii stay", first.path, count - 1)
            }
        };
        let finding = Finding::at(FindingCode::Terrain, first.line, text).about(&first.path);
        Some(finding.of_spheres(fixed.iter().map(|sphere| sphere.name.clone()).collect()))
    }
}

fn several_sets(force: &Force) -> Option<Finding> {
    let used = force.sets.iter().filter(|set| !set.spheres.is_empty() || set.half_spaces > 0).count();
    let text = format!("{} has {} ContactParameters: all get the same factor", force.path, force.sets.len());
    (used > 1).then(|| Finding::at(FindingCode::SeveralParameterSets, force.line, text).about(&force.path))
}

fn disabled(force: &Force) -> Option<Finding> {
    let text = format!(
        "{} is switched off: it is changed with the others, and its spheres are not counted",
        force.path
    );
    (!force.applies).then(|| Finding::at(FindingCode::DisabledForce, force.line, text).about(&force.path))
}
