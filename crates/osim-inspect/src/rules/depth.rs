//! How deep spheres sink in under the body: up to their centres, or beyond what Hertz' law is accurate for.

use contact_scaling::limits::INDENTATION;
use osim_model::messages::{Input, Phrase, Verb, four_significant, phrase, readable};
use osim_model::{Example, Finding, FindingCode, Repair, Rule, Severity, VerdictOn, same_mass};
use osim_requests::Request;

use crate::figures::{Figure, SphereFigures};
use crate::findings::Found;
use crate::rules::limits::{CENTRE, Limits, beyond};

pub(super) static SUNK_IN: Rule = Rule {
    code: FindingCode::SunkIn,
    severity: Severity::Error,
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

pub(super) fn find_sunk_in(limits: &Limits<'_>) -> Option<Found> {
    sunk_in_level(limits).or_else(|| sunk_in_at_own_heights(limits))
}

/// Whether a sphere is as deep as its centre where its limb carries the body and each sphere is at its own height.
fn is_own_height_too_deep(sphere: &SphereFigures) -> Option<f64> {
    sphere.value(Figure::StandingIndentationModelLaw).filter(|&x| x >= CENTRE)
}

fn sunk_in_level(limits: &Limits<'_>) -> Option<Found> {
    let found = limits.concerned(|sphere| sphere.value(Figure::Indentation).filter(|&x| x >= CENTRE))?;
    let x = four_significant(found.most);
    let text = format!(
        "too soft: at body weight on {} spheres sink {x} R into the floor (x/R by Hertz)",
        carriers(limits)
    );
    let finding = limits.about(&SUNK_IN, &text, &found);
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
            INDENTATION.value
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
fn sunk_in_at_own_heights(limits: &Limits<'_>) -> Option<Found> {
    let found = limits.concerned(is_own_height_too_deep)?;
    let x = four_significant(found.most);
    let text = format!(
        "at body weight on {} the lower spheres carry the body alone, and sink {x} R into the floor (x/R with each sphere at its own \
         height at the default pose)",
        carriers(limits)
    );
    Some(Found::new(limits.about(&SUNK_IN, &text, &found), limits.remedies.level()))
}

/// Limbs that carry a body on more of them, at least: of a horse that trots.
const CARRIERS: f64 = 2.0;

/// A body on more limbs than a biped's.
struct ManyLimbs {
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
    fn sunk_in(&self, finding: Finding, x: f64, limits: &Limits<'_>) -> Found {
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
            true => finding.with_advice(self.stands_on_two(carriers)).with_severity(Severity::Warning).into(),
            false => {
                let remedy = limits.remedies.published(Some(carriers)).map(Request::from);
                Found::new(finding.with_advice(of_another_body(carriers)), remedy)
            }
        }
    }

    fn stands_on_two(&self, carriers: f64) -> Phrase {
        let check = Verb::Check.call_with_model().with_value(Input::StanceLimbs, readable(carriers));
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
        Input::StanceLimbs.with_value(readable(carriers)),
        ": scaled by mass alone they are still those of another number of spheres. If they were made for this one, make them stiffer, for \
         the x/R that is meant with so many limbs",
    ]
}

pub(super) static BEYOND_HERTZ: Rule = Rule {
    code: FindingCode::BeyondHertz,
    severity: Severity::Remark,
    verdict: Some(VerdictOn::Mass),
    what: "Spheres sink in deeper than Hertz' law is accurate for, at body weight on one limb.",
    why: "Hertz' law was found accurate up to a relative indentation of {indentation}, a contact patch of 0.4 R. Beyond, the contact is a non-linear spring and no longer a material; most published gait models are there (Falisse et al. 2022: 0.353).",
    advice: "Nothing, if a spring is meant; else stiffer, larger or more spheres, for a relative indentation of {indentation} at most",
    repair: Repair::NotPossible("a remark: most published contacts are so, and their authors meant it"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<stiffness>4.4876e7</stiffness>",
        bad: "<stiffness>1e7</stiffness>",
    },
};

pub(super) fn find_beyond_hertz(limits: &Limits<'_>) -> Option<Found> {
    let found = limits.concerned(|sphere| beyond(sphere, Figure::Indentation).filter(|&x| x < CENTRE))?;
    let (x, limit) = (four_significant(found.most), INDENTATION.in_words());
    let text = format!("at body weight on one limb x/R is {x} by Hertz, {limit}");
    Some(limits.about(&BEYOND_HERTZ, &text, &found).into())
}

pub(super) static BEYOND_HERTZ_AT_TWO: Rule = Rule {
    code: FindingCode::BeyondHertzAtTwo,
    severity: Severity::Remark,
    verdict: Some(VerdictOn::Mass),
    what: "Spheres sink in deeper than Hertz' law is accurate for, at two body weights and not at one.",
    why: "A foot carries more than body weight in running and landing. At twice body weight the relative indentation is above {indentation}, up to which Hertz' law is accurate.",
    advice: "Nothing, if the model only walks; else stiffer, larger or more spheres, for a relative indentation of {indentation} at two body weights",
    repair: Repair::NotPossible("walking is within the limit; whether the model runs, only you know"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<stiffness>4.4876e7</stiffness>",
        bad: "<stiffness>2.5e7</stiffness>",
    },
};

pub(super) fn find_beyond_hertz_at_two(limits: &Limits<'_>) -> Option<Found> {
    let only_at_two = |sphere: &SphereFigures| {
        beyond(sphere, Figure::IndentationAtTwo)
            .filter(|_| sphere.is_within(Figure::Indentation) == Some(true))
    };
    let found = limits.concerned(only_at_two)?;
    let (x, limit) = (four_significant(found.most), INDENTATION.in_words());
    let text = format!("at two body weights on one limb x/R is {x} by Hertz, {limit}");
    Some(limits.about(&BEYOND_HERTZ_AT_TWO, &text, &found).into())
}
