//! Which of two sides that differ is the slip.

use osim_model::{BothSides, Force, Model, Side};

use super::KnownContacts;
use crate::inspection::Inspection;

/// The side that has published contacts, where the other one has not: from the table of known contacts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct KnownSide {
    pub side: Side,
    pub contacts: KnownContacts,
}

impl KnownSide {
    pub(crate) fn of(model: &Model, sides: &BothSides<'_>, inspected: &Inspection) -> Option<Self> {
        #[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
        let count = inspected.spheres_per_limb.map(|count| count as f64);
        let known = |side| KnownContacts::find(model, &sides.forces_on(side), count, inspected.mass_kg);
        match (known(Side::Right), known(Side::Left)) {
            (Some(contacts), None) => Some(Self { side: Side::Right, contacts }),
            (None, Some(contacts)) => Some(Self { side: Side::Left, contacts }),
            _ => None,
        }
    }
}

/// The side that is the slip where `left` and its counterpart differ: the one that has not the published contacts that the other
/// side has, else the one that is unlike most other contacts of the model; `None` if neither shows it.
pub(crate) fn odd_side(known: Option<KnownSide>, sides: &BothSides<'_>, left: &Force) -> Option<Side> {
    // A slip in every contact of one side is in no majority.
    known.map(|known| known.side.other()).or_else(|| sides.odd_side(left))
}
