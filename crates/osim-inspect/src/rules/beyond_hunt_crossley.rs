//! Restitution by (13) is so low that the Hunt-Crossley law is not accurate.

use contact_scaling::limits::RESTITUTION;
use osim_model::messages::four_significant;
use osim_model::{Example, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};

use super::limits::Limits;
use crate::figures::Figure;
use crate::findings::Found;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::BeyondHuntCrossley,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Solver),
    what: "Restitution by (13) is so low that the Hunt-Crossley law is not accurate.",
    why: "The Hunt-Crossley law describes materials that give back most of the impact speed. Below a restitution of {restitution} at the impact speed, dissipation is a damper that makes a simulation calm; energies lost in contact are not those of a material.",
    advice: "Nothing, if that is meant; else a smaller dissipation, for a restitution of {restitution} at least",
    repair: Repair::NotPossible("a remark: most published contacts are so, and their authors meant it"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<dissipation>0.4</dissipation>",
        bad: "<dissipation>2</dissipation>",
    },
};

pub(crate) fn find(limits: &Limits<'_>) -> Option<Found> {
    let speed = limits.inspected.figures.impact_speed_m_s?;
    // The largest dissipation has the least restitution.
    let found = limits.concerned(|sphere| {
        let outside = sphere.is_within(Figure::RestitutionApproximate) == Some(false);
        sphere.value(Figure::Dissipation).filter(|_| outside)
    })?;
    let restitution = found.worst.value(Figure::RestitutionApproximate);
    let restitution = restitution.map_or_else(|| "below 0".to_owned(), four_significant);
    let text = format!(
        "at an impact speed of {} m/s the restitution is {restitution} by (13), {}",
        four_significant(speed),
        RESTITUTION.in_words()
    );
    Some(limits.about_force(&RULE, &text, &found).into())
}
