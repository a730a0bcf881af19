//! Spheres sink in by their whole radius or more at body weight on one limb.

use contact_scaling::limits;
use osim_model::messages::{Phrase, four_significant, phrase, readable};
use osim_model::{Example, FindingCode, Repair, Rule, Seen, Severity, VerdictOn, same_mass};

use super::limits::{CENTRE, Limits};
use super::many_limbs::ManyLimbs;
use crate::figures::{Figure, SphereFigures};
use crate::findings::Found;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::SunkIn,
    severity: Severity::Error,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Mass),
    what: "The contacts are far too soft: at body weight on one limb, spheres sink into the floor up to their centres or deeper.",
    why: "No contact law holds so deep, but OpenSim goes on with the same formula. Nearly always the contacts were made for a lighter body, or the spheres are too small.",
    advice: "If the contacts were made for another body, scale them to this one; else make them stiffer, for a relative indentation of {indentation}",
    repair: Repair::Command(
        "designs or multiplies the stiffness as for beyond-hertz; on more than two limbs takes over published contacts for two stance limbs; makes bottoms level where the lower spheres carry the body alone",
    ),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<stiffness>4.4876e7</stiffness>",
        bad: "<stiffness>1e6</stiffness>",
    },
};

pub(crate) fn find(limits: &Limits<'_>) -> Option<Found> {
    level(limits).or_else(|| at_their_own_heights(limits))
}

/// Whether a sphere is as deep as its centre where its limb carries the body and each sphere is at its own height.
pub(super) fn is_own_height_too_deep(sphere: &SphereFigures) -> Option<f64> {
    sphere.value(Figure::StandingIndentationModelLaw).filter(|&x| x >= CENTRE)
}

fn level(limits: &Limits<'_>) -> Option<Found> {
    let found = limits.concerned(|sphere| sphere.value(Figure::Indentation).filter(|&x| x >= CENTRE))?;
    let x = four_significant(found.most);
    let text = format!(
        "too soft: at body weight on {} spheres sink {x} R into the floor (x/R by Hertz)",
        carriers(limits)
    );
    let finding = limits.about(&RULE, &text, &found);
    Some(match ManyLimbs::of(limits) {
        Some(limbs) => limbs.sunk_in(finding, found.most, limits),
        None => {
            let finding = match made_for_this_body(limits) {
                Some(advice) => finding.with_advice(advice),
                None => finding,
            };
            Found::new(finding, limits.remedies.indentation(&limits.spheres))
        }
    })
}

/// What to do if somebody said that the contacts were made for a body of this mass: no scaling helps then.
fn made_for_this_body(limits: &Limits<'_>) -> Option<Phrase> {
    let made_for = limits.inspected.contacts_mass_kg.as_ref().filter(|mass| mass.recorded)?;
    let weighs_kg = limits.inspected.figures.mass_kg.filter(|&kg| same_mass(kg, made_for.value))?;
    Some(phrase![
        format!("They were made for {} kg (", readable(weighs_kg)),
        &made_for.description,
        format!(
            "), which the body weighs: make them stiffer, for a relative indentation of {}",
            limits::INDENTATION.value
        ),
    ])
}

/// What carries the body, as the caller said.
fn carriers(limits: &Limits<'_>) -> String {
    match limits.inspected.stance_limbs {
        1.0 => "one limb".to_owned(),
        limbs => format!("{} limbs", readable(limbs)),
    }
}

/// Softer contacts are not what is wrong then: the lower spheres carry what all should carry.
fn at_their_own_heights(limits: &Limits<'_>) -> Option<Found> {
    let found = limits.concerned(is_own_height_too_deep)?;
    let x = four_significant(found.most);
    let text = format!(
        "at body weight on {} the lower spheres carry the body alone, and sink {x} R into the floor (x/R with each sphere at its own \
         height at the default pose)",
        carriers(limits)
    );
    Some(Found::new(limits.about(&RULE, &text, &found), limits.remedies.level()))
}
