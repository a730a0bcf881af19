//! Bottoms of one foot that differ a little, or because the foot leans.

use osim_model::{Example, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};

use super::limits::Limits;
use super::uneven_bottoms::Uneven;
use crate::findings::Found;

/// Bottoms that differ by more than this, in the radius of the lowest sphere, are a remark.
const REMARK: f64 = 0.3;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::UnlevelFoot,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Standing),
    what: "The bottoms of a limb's spheres differ in height by more than 0.3 radii at the default pose; by more than half a radius only because the foot leans there.",
    why: "The lower spheres are deeper than the figures of a level foot say. Of 134 published models with level floors 16 differ so much.",
    advice: "Nothing, if that is meant; `inspect MODEL` says how deep each sphere is at its own height. Where radii change, a rescaling can keep bottoms where they are",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Models { good: "check/known_contacts.osim", bad: "format/mixed_radii.osim" },
};

/// The limb whose bottoms differ most, unless that is a warning.
pub(crate) fn find(limits: &Limits<'_>) -> Option<Found> {
    let worst = Uneven::worst(limits).filter(|worst| worst.is_beyond(REMARK) && !worst.is_too_much())?;
    Some(worst.finding(&RULE).into())
}
