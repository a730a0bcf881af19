//! Restitution by (13) is so low that the Hunt-Crossley law is not accurate.

use contact_scaling::limits::RESTITUTION;
use osim_messages::four_significant;
use osim_model::{Example, FindingCode, Property, Repair, Rule, Seen, Severity, VerdictOn};
use osim_requests::options::WantedOptions;
use osim_requests::{Positive, Request, RestitutionCoefficient};

use super::limits::Limits;
use crate::figures::Figure;
use crate::findings::{Found, Remedies, two_digits_below};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::BeyondHuntCrossley,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Solver),
    what: "Restitution by (13) is so low that the Hunt-Crossley law is not accurate.",
    why: "The Hunt-Crossley law describes materials that give back most of the impact speed. Below a restitution of {restitution} at the impact speed, dissipation is a damper that makes a simulation calm; energies lost in contact are not those of a material.",
    advice: "Nothing, if that is meant; else `design MODEL restitution={restitution}`",
    repair: Repair::Command(
        "designs the dissipation for the limit; where one force has several, multiplies them",
    ),
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
    let remedy = remedy(limits.remedies, speed, found.most);
    Some(Found::new(limits.about_force(&RULE, &text, &found), remedy))
}

/// Brings the restitution up to the limit, from the largest dissipation that is there.
fn remedy(remedies: &Remedies<'_>, impact_speed_m_s: f64, dissipation_s_m: f64) -> Option<Request> {
    let limit = RESTITUTION.value;
    if remedies.joined {
        let factor = (1.0 - limit) / impact_speed_m_s / dissipation_s_m;
        return remedies.factor(Property::Dissipation, two_digits_below(factor));
    }
    let wanted = WantedOptions {
        restitution: Some(RestitutionCoefficient::new(limit).ok()?),
        impact_speed: Some(Positive::new((impact_speed_m_s * 1e4).ceil() / 1e4).ok()?),
        ..WantedOptions::default()
    };
    remedies.design(wanted).map(Request::from)
}
