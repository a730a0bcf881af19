//! A sphere that only just touches the floor carries a large part of its share of body weight already.

use osim_model::messages::four_significant;
use osim_model::{Example, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};

use super::limits::{Limits, beyond};
use crate::figures::Figure;
use crate::findings::{Found, touching_indentation};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::ForceBeforeContact,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Solver),
    what: "A sphere that only just touches the floor carries a large part of its share of body weight already.",
    why: "Smoothing lets force through before contact (Fig. C.5): the floor repels the foot, as if the spheres were larger. In Falisse et al. (2022), where that did no harm, it is 0.074 of the share.",
    advice: "Make constant_contact_force smaller",
    repair: Repair::Command("designs constant_contact_force so that the share comes down to the limit"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<constant_contact_force>9e-07</constant_contact_force>",
        bad: "<constant_contact_force>4e-06</constant_contact_force>",
    },
};

pub(crate) fn find(limits: &Limits<'_>) -> Option<Found> {
    let found = limits.concerned(|sphere| beyond(sphere, Figure::TouchingShare))?;
    let force = found.worst.value(Figure::ForceJustTouching).map(four_significant).unwrap_or_default();
    let share = four_significant(found.most);
    let text = format!("just touching, a sphere carries {force} N, {share} of its share of body weight");
    let finding = limits.about_force(&RULE, &text, &found);
    // Down to a tenth of the share of the weight.
    let below = touching_indentation(&limits.spheres);
    Some(Found::new(finding, below.and_then(|below| limits.remedies.constant_indentation(below))))
}
