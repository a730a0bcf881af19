//! Bodies on more than two limbs: two of them at least carry the weight, and contacts made for a biped's one limb are not scaled to
//! them by mass alone.

use osim_model::messages::{Input, Phrase, Verb, four_significant, phrase, readable};
use osim_model::{Finding, Severity};
use osim_requests::Request;

use super::limits::{CENTRE, Limits};
use crate::findings::Found;

/// Limbs that carry a body on more of them, at least: of a horse that trots.
const CARRIERS: f64 = 2.0;

/// A body on more limbs than a biped's.
pub(super) struct ManyLimbs {
    limbs: usize,
    /// How many of them share the weight, as the caller said.
    said: f64,
}

impl ManyLimbs {
    /// The limbs, if there are more than two; `None` also if the caller said how many spheres share the weight, or if that is not known.
    pub(super) fn of(limits: &Limits<'_>) -> Option<Self> {
        let stance = &limits.remedies.options.stance;
        let limbs = limits.inspected.limbs.as_ref()?.len();
        let is_counted = stance.spheres.is_none() && limits.remedies.counted;
        (limbs > 2 && is_counted).then_some(Self { limbs, said: limits.inspected.stance_limbs })
    }

    /// `finding` about spheres that sink in by `x` of their radius, as it is for a body on so many limbs: what x/R is on two of them, and
    /// what to do about it.
    pub(super) fn sunk_in(&self, finding: Finding, x: f64, limits: &Limits<'_>) -> Found {
        let carriers = self.said.max(CARRIERS);
        // Equal spheres share the load, and x̂ follows F^(2/3) (3).
        let there = x * (self.said / carriers).powf(2.0 / 3.0);
        let on = format!("on {} of its {} limbs", readable(carriers), self.limbs);
        let finding = match self.said < carriers {
            true => {
                let message =
                    phrase![&finding.message, format!("; {on} it is {} R", four_significant(there))];
                finding.with_message(message)
            }
            false => finding,
        };
        match there < CENTRE {
            // No animal stands on one of four limbs: its contacts may be right.
            true => finding.with_advice(self.stands_on_two(carriers)).with_severity(Severity::Warn).into(),
            false => {
                let remedy = limits.remedies.published(Some(carriers)).map(Request::from);
                Found::new(finding.with_advice(of_another_body(carriers)), remedy)
            }
        }
    }

    fn stands_on_two(&self, carriers: f64) -> Phrase {
        let check = Verb::Check.of_model().saying(Input::StanceLimbs, readable(carriers));
        phrase![
            format!("Nothing, if at least two of its {} limbs always carry it: say so, with ", self.limbs),
            check,
            "; else make the contacts stiffer",
        ]
    }
}

/// Why the mass alone does not make contacts right that were made for a body on other limbs.
fn of_another_body(carriers: f64) -> Phrase {
    phrase![
        "If the contacts were made for another body, take those of a known model, as large against this body, with ",
        Input::StanceLimbs.being(readable(carriers)),
        ": scaled by mass alone they are still those of another number of spheres. If they were made for this one, make them stiffer, for \
         the x/R that is meant with so many limbs",
    ]
}
