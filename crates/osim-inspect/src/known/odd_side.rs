//! Which of two sides that differ is the slip.

use osim_model::{BothSides, Force, Model, Side};

use super::KnownContacts;
use crate::inspection::Inspection;

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
