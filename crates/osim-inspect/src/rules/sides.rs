//! Which of two sides that differ is the slip, and the remedy: it gets the values of the other.

use osim_model::{Assignment, BothSides, Finding, Force, Model, Property, Side};
use osim_requests::options::ForceOptions;
use osim_requests::{Request, SetRequest};

use crate::findings::{Remedies, exactly};
use crate::inspection::Inspection;
use crate::known_contacts::KnownContacts;

/// The side that has contacts that are known, where the other one has not: those of the reference that the caller named, or published
/// ones, from the table of known contacts.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct KnownSide {
    pub side: Side,
    /// Whose contacts these are.
    pub title: String,
}

impl KnownSide {
    pub(crate) fn of(model: &Model, sides: &BothSides<'_>, inspected: &Inspection) -> Option<Self> {
        let reference = inspected.reference_contacts.as_ref();
        if let Some((side, reference)) = reference.and_then(|one| Some((one.side(model, sides)?, one))) {
            return Some(Self { side, title: reference.title() });
        }
        #[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
        let count = inspected.spheres_per_limb.map(|count| count as f64);
        let known = |side| KnownContacts::find(model, &sides.forces_on(side), count, inspected.mass_kg);
        match (known(Side::Right), known(Side::Left)) {
            (Some(contacts), None) => Some(Self { side: Side::Right, title: contacts.title.to_string() }),
            (None, Some(contacts)) => Some(Self { side: Side::Left, title: contacts.title.to_string() }),
            _ => None,
        }
    }
}

/// The side that is the slip where `left` and its counterpart differ: the one that has not the known contacts that the other
/// side has, else the one that is unlike most other contacts of the model; `None` if neither shows it.
pub(crate) fn odd_side(known: Option<&KnownSide>, sides: &BothSides<'_>, left: &Force) -> Option<Side> {
    // A slip in every contact of one side is in no majority.
    known.map(|known| known.side.other()).or_else(|| sides.odd_side(left))
}

/// A number that differs between the sides.
struct Differing {
    property: Property,
    left: f64,
    right: f64,
}

/// Writes the values of the side that is right into the other force of the pair that `finding` is about. `None` if neither the table of
/// known contacts nor the other forces say which side that is: to copy one would be right as often as wrong.
pub(crate) fn copy_other_side(
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
