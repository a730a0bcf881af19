//! The remedy of a rule about models: the side that is a slip gets the values of the other.
//!
//! Which side that is, the table of known contacts says, or the other forces of the model. Where neither does, there is no remedy:
//! to copy one side would be right as often as wrong.

use osim_model::{Assignment, BothSides, Finding, Force, Model, Property, Side};
use osim_requests::options::ForceOptions;
use osim_requests::{Request, SetRequest};

use crate::findings::{Remedies, exactly};
use crate::known::{KnownSide, odd_side};

/// A number that differs between the sides.
struct Differing {
    property: Property,
    left: f64,
    right: f64,
}

/// Writes the values of the side that is right into the other force of the pair that `finding` is about.
pub(crate) fn remedy(
    remedies: &Remedies<'_>,
    model: &Model,
    sides: &BothSides<'_>,
    known: Option<&KnownSide>,
    finding: &Finding,
) -> Option<Request> {
    let left = sides.force(finding.place.as_deref()?)?;
    let right = sides.right_of(left)?;
    let values = differing(model, sides, left, right)?;
    let odd = odd_side(known, sides, left)?;
    let wrong = if odd == Side::Left { left } else { right };
    let value = |one: &Differing| if odd == Side::Left { one.right } else { one.left };
    let assignments: Vec<(Property, f64)> = values.iter().map(|one| (one.property, value(one))).collect();
    can_be_set(&assignments).then_some(())?;
    if !remedies.options.selection.select.is_empty() {
        return None;
    }
    let assignments = assignments.iter().map(|(property, value)| (*property, Assignment::Value(*value)));
    let set = remedies.set(assignments.collect())?;
    let choice = ForceOptions { select: vec![exactly(&wrong.name)?], ..remedies.choice() };
    Some(SetRequest { choice, ..set }.into())
}

/// Whether nobody refuses to write them; a constant_contact_force of 0 would be.
fn can_be_set(values: &[(Property, f64)]) -> bool {
    values.iter().all(|(property, value)| property.allows(*value))
        && !values.contains(&(Property::ConstantContactForce, 0.0))
}

fn radii(model: &Model, force: &Force) -> Vec<f64> {
    let spheres = force.spheres().into_iter().filter_map(|id| model.sphere(id));
    spheres.map(|sphere| sphere.radius.number).collect()
}

/// What differs between the forces; `None` where one `set` cannot say it.
fn differing(model: &Model, sides: &BothSides<'_>, left: &Force, right: &Force) -> Option<Vec<Differing>> {
    let ([of_left], [of_right]) = (left.sets.as_slice(), right.sets.as_slice()) else { return None };
    let pairs = of_left.values.iter().zip(&of_right.values).filter(|(l, r)| l.number != r.number);
    let mut found: Vec<Differing> =
        pairs.map(|(l, r)| Differing { property: r.property, left: l.number, right: r.number }).collect();
    let (ours, theirs) = (radii(model, left), radii(model, right));
    if ours != theirs {
        // On bones of another size the radius of the other side is wrong, and numbers that follow it are.
        if sides.bones_differ(left, right) {
            return None;
        }
        found.push(Differing { property: Property::Radius, left: only(&ours)?, right: only(&theirs)? });
    }
    Some(found).filter(|found| !found.is_empty())
}

/// The number that all of them are.
fn only(numbers: &[f64]) -> Option<f64> {
    let first = *numbers.first()?;
    numbers.iter().all(|&one| one == first).then_some(first)
}
