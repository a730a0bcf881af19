//! Findings from the model itself: what reading it showed, and what only matters once it is asked.

use std::cell::LazyCell;

use contact_scaling::limits;
use osim_model::{BothSides, Finding, FindingCode, Force, ForceId, GravityFor, Model, Needed, Property};
use osim_requests::Request;

use super::found::Found;
use super::remedy::Remedies;
use crate::inspection::Inspection;

/// Everything that the model shows apart from its figures.
pub(super) fn findings(model: &Model, inspected: &Inspection, remedies: &Remedies<'_>) -> Vec<Found> {
    let sides = LazyCell::new(|| model.both_sides());
    let with_remedy =
        |finding: &Finding| Found::new(finding.clone(), remedy(model, &sides, finding, remedies));
    let mut found: Vec<Found> = inspected.warnings.iter().map(with_remedy).collect();
    found.extend(model.remarks_on(&meeting_half_space(model)).into_iter().map(Found::from));
    found.extend(unknown(inspected).into_iter().map(Found::from));
    found
}

/// Forces that a change takes by default.
fn meeting_half_space(model: &Model) -> Vec<ForceId> {
    let forces = model.forces().iter().filter(|force| model.meets_half_space(force));
    forces.map(|force| force.id).collect()
}

fn remedy<'m>(
    model: &'m Model,
    sides: &LazyCell<BothSides<'m>, impl FnOnce() -> BothSides<'m>>,
    finding: &Finding,
    remedies: &Remedies<'_>,
) -> Option<Request> {
    match finding.code {
        FindingCode::DefaultStiffness => remedies.preset(),
        FindingCode::ZeroConstantContactForce => {
            remedies.constant_indentation(limits::SUGGESTED_CONSTANT_INDENTATION)
        }
        FindingCode::SeveralSpheres => {
            let path = finding.place.as_deref()?;
            let force = model.forces().iter().find(|force| force.path == path)?;
            remedies.one_sphere_each(model, force)
        }
        FindingCode::LeftRightDiffer => {
            let left = sides.force(finding.place.as_deref()?)?;
            remedies.copy(&left.name, &differing(model, sides, left, sides.right_of(left)?)?)
        }
        _ => None,
    }
}

/// What to write into `left` so that it is like `right`; `None` where one `set` cannot say it.
fn differing(
    model: &Model,
    sides: &BothSides<'_>,
    left: &Force,
    right: &Force,
) -> Option<Vec<(Property, f64)>> {
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
        // On bones of another size the radius of the other side is wrong, and numbers that follow it are.
        if sides.bones_differ(left, right) {
            return None;
        }
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

/// What keeps figures under body weight away.
fn unknown(inspected: &Inspection) -> Vec<Finding> {
    let mut found = Vec::new();
    let own = inspected.gravity_m_s2.filter(|&gravity| gravity != 0.0);
    // Where figures are made, it may also have been given.
    if own.or(inspected.figures.gravity_m_s2).is_none() {
        let needed = Needed::Gravity { purpose: GravityFor::Figures };
        found.push(Finding::new(FindingCode::NoGravity, needed.phrase()));
    }
    // Limbs are not known either where forces of several animals are there and nobody chose among them.
    let limbs = &inspected.figures.limbs;
    let counted = !limbs.is_empty() && limbs.iter().all(|limb| limb.sphere_count.is_some());
    if let (None, false, Some(why)) = (&inspected.limbs, counted, &inspected.limbs_unknown) {
        found.push(Finding::new(FindingCode::CountUnknown, why.clone()));
    }
    found
}
