//! The remedy of a rule about models: the values of the right side.

use osim_model::{Assignment, BothSides, Finding, Force, Model, Property};
use osim_requests::options::ForceOptions;
use osim_requests::{Request, SetRequest};

use crate::findings::{Remedies, exactly};

/// Writes the values of the right side into the force that `finding` is about.
pub(crate) fn remedy(
    remedies: &Remedies<'_>,
    model: &Model,
    sides: &BothSides<'_>,
    finding: &Finding,
) -> Option<Request> {
    let left = sides.force(finding.place.as_deref()?)?;
    let values = differing(model, sides, left, sides.right_of(left)?)?;
    // A value that nobody may set is no repair of the other side.
    let can_be_set = values.iter().all(|(property, value)| property.allows(*value));
    if !can_be_set || !remedies.options.selection.select.is_empty() {
        return None;
    }
    let assignments = values.iter().map(|(property, value)| (*property, Assignment::Value(*value)));
    let set = remedies.set(assignments.collect())?;
    let choice = ForceOptions { select: vec![exactly(&left.name)?], ..remedies.choice() };
    Some(SetRequest { choice, ..set }.into())
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
