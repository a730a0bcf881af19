//! Findings from the model itself: what reading it showed, and what only matters once it is asked.

use osim_model::{Force, Model, Property, SphereId, WarningCode};

use super::finding::Finding;
use super::remedy::{Remedies, Remedy};
use crate::inspection::Inspection;

/// Everything that the model shows apart from its figures.
pub(super) fn findings(model: &Model, inspected: &Inspection, remedies: &Remedies<'_>) -> Vec<Finding> {
    let mut found: Vec<Finding> = inspected
        .warnings
        .iter()
        .map(|warning| {
            let remedy = remedy(model, warning.code, warning.subject.as_deref(), remedies);
            Finding::from(warning).put_right_by(remedy)
        })
        .collect();
    for force in model.forces() {
        found.extend(mixed_radii(model, force));
        found.extend(several_sets(force));
        found.extend(disabled(model, force));
    }
    found.extend(terrain(model));
    found.extend(unknown(inspected));
    found
}

fn remedy(
    model: &Model,
    code: WarningCode,
    subject: Option<&str>,
    remedies: &Remedies<'_>,
) -> Option<Remedy> {
    match code {
        WarningCode::DefaultStiffness => remedies.preset(),
        WarningCode::ZeroConstantContactForce => remedies.constant_indentation(0.05),
        WarningCode::LeftRightDiffer => {
            let left = model.forces().iter().find(|force| Some(force.path.as_str()) == subject)?;
            remedies.copy(&left.name, &differing(model, left, model.right_of(left)?)?)
        }
        _ => None,
    }
}

/// What to write into `left` so that it is like `right`; `None` where one `set` cannot say it.
fn differing(model: &Model, left: &Force, right: &Force) -> Option<Vec<(Property, f64)>> {
    let ([of_left], [of_right]) = (left.sets.as_slice(), right.sets.as_slice()) else { return None };
    let mut changes: Vec<(Property, f64)> = of_left
        .values
        .iter()
        .zip(&of_right.values)
        .filter(|(l, r)| l.number != r.number)
        .map(|(_, r)| (r.property, r.number))
        .collect();
    let radii = |force: &Force| -> Vec<f64> {
        let spheres = force.spheres().into_iter().filter_map(|id| model.sphere(id));
        spheres.map(|sphere| sphere.radius.number).collect()
    };
    let (ours, theirs) = (radii(left), radii(right));
    if ours != theirs {
        let first = *theirs.first()?;
        if theirs.iter().any(|&radius| radius != first) {
            return None;
        }
        changes.push((Property::Radius, first));
    }
    if changes.contains(&(Property::ConstantContactForce, 0.0)) {
        return None; // It would be refused.
    }
    Some(changes).filter(|changes| !changes.is_empty())
}

/// Spheres of different radii under one modulus.
pub(super) fn mixed_radii(model: &Model, force: &Force) -> Option<Finding> {
    let set = force.sets.iter().find(|set| {
        let mut radii = set
            .spheres
            .iter()
            .filter_map(|&id| model.sphere(id))
            .filter(|sphere| !sphere.fixed)
            .map(|sphere| sphere.radius.number);
        radii.next().is_some_and(|first| radii.any(|radius| radius != first))
    })?;
    let text = format!("{} holds spheres of different radii", force.path);
    Some(Finding::new(WarningCode::MixedRadii, text).at(Some(&force.path), Some(set.line)))
}

fn several_sets(force: &Force) -> Option<Finding> {
    let text = format!("{} has {} ContactParameters", force.path, force.sets.len());
    let several = force.sets.len() > 1;
    several.then(|| {
        Finding::new(WarningCode::SeveralParameterSets, text).at(Some(&force.path), Some(force.line))
    })
}

fn disabled(model: &Model, force: &Force) -> Option<Finding> {
    let text = format!("{} is switched off", force.path);
    let off = !force.applies && model.meets_half_space(force);
    off.then(|| Finding::new(WarningCode::DisabledForce, text).at(Some(&force.path), Some(force.line)))
}

/// Spheres that stand on ground and are used by a contact force.
fn terrain(model: &Model) -> Option<Finding> {
    let used = |id: SphereId| model.forces().iter().any(|force| force.spheres().contains(&id));
    let fixed: Vec<_> = model.spheres().iter().filter(|sphere| sphere.fixed && used(sphere.id)).collect();
    let first = fixed.first()?;
    let text = match fixed.len() {
        1 => format!("{} stands on ground", first.path),
        count => format!("{} and {} more spheres stand on ground", first.path, count - 1),
    };
    let finding = Finding::new(WarningCode::Terrain, text).at(Some(&first.path), Some(first.line));
    Some(finding.about(fixed.iter().map(|sphere| sphere.name.clone()).collect()))
}

/// What keeps figures under body weight away.
fn unknown(inspected: &Inspection) -> Vec<Finding> {
    let mut found = Vec::new();
    if inspected.gravity_m_s2.is_none_or(|gravity| gravity == 0.0) {
        found.push(Finding::new(WarningCode::NoGravity, "the model has no gravity"));
    }
    // Limbs are not known either where forces of several animals are there and nobody chose among them.
    let limbs = &inspected.figures.limbs;
    let counted = !limbs.is_empty() && limbs.iter().all(|limb| limb.sphere_count.is_some());
    if let (None, false, Some(why)) = (&inspected.limbs, counted, &inspected.limbs_unknown) {
        found.push(Finding::new(WarningCode::CountUnknown, why.clone()));
    }
    found
}
