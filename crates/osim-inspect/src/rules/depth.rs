//! Rules about spheres that sink too deep into the floor under the body: up to their centres, or so deep that the Hertz law is not
//! accurate.

use std::cell::LazyCell;

use contact_scaling::limits::{INDENTATION, growth_to_indentation_limit};
use osim_model::messages::{Input, Phrase, Verb, four_significant, phrase, readable};
use osim_model::{Example, Finding, Repair, Rule, Severity, are_equal_masses, has_word};
use osim_requests::Request;

use crate::body_bones::is_named_after_foot;
use crate::figures::{ROUNDING_RADII, UP_TO_CENTRE_RADII};
use crate::rules::figure_check::{FigureCheck, value_beyond_limit};
use crate::rules::standing::{UnevenLimb, bottoms_by_path, level_feet};
use crate::{Figure, FindingWithRemedy, SphereFigures};
use osim_model::rule;

rule! { pub(super) SUNK_IN: SunkIn, Error, Mass;
    what: "The contacts are far too soft: at body weight on one limb, spheres sink into the floor up to their centres or deeper. If only the default pose causes this depth, it is a remark.",
    why: "No contact law holds at this depth, but OpenSim continues with the same formula. Usually the contacts were made for a lighter body, or the spheres are too small.",
    advice: "If the contacts were made for another body, scale them to this one; else make them stiffer, for a relative indentation of {indentation}",
    repair: Repair::Command("designs or multiplies the stiffness as for beyond-hertz; on more than two limbs takes over published contacts for two stance limbs; makes the lowest points level where the lower spheres carry the body alone"),
    example: Example::ElementText { tag: "stiffness", good: "4.4876e7", bad: "1e6" },
}

/// Finds spheres that sink in up to their centres under the body weight.
pub(super) fn find_sunk_in_spheres(check: &FigureCheck<'_>) -> Option<FindingWithRemedy> {
    sunk_in_level(check).or_else(|| sunk_in_at_own_heights(check)).or_else(|| soft_beside_stiffer(check))
}

/// A remark on spheres that an equal share of the load would press in up to their centres, if stiffer ones carry the body.
fn soft_beside_stiffer(check: &FigureCheck<'_>) -> Option<FindingWithRemedy> {
    let carries = LazyCell::new(|| can_carry(check));
    let affected = check.spheres_with(|sphere| {
        let x = sphere.value(Figure::Indentation);
        x.filter(|&x| x > UP_TO_CENTRE_RADII + ROUNDING_RADII && (*carries)(sphere))
    })?;
    let x = four_significant(affected.largest);
    let text = format!(
        "with an equal share of the weight on {} spheres would sink {x} R into the floor (x/R by Hertz); stiffer ones beside them carry it",
        check.inspected.carriers
    );
    Some(check.finding_at_sphere(&SUNK_IN, &text, &affected).with_severity(Severity::Remark).into())
}

/// Words in the names of hands, and of what they hold.
const HAND_WORDS: [&str; 4] = ["hand", "crutch", "pole", "stick"];

/// Whether the limb of a sphere can carry the body alone. No body stands on a wall, or, if it has feet, on one hand or crutch.
fn can_carry(check: &FigureCheck<'_>) -> impl Fn(&SphereFigures) -> bool {
    let on_floors = bottoms_by_path(check);
    let carriers = check.inspected.spheres.iter().filter_map(|one| Some((&one.path, one.body.as_deref()?)));
    let has_feet = carriers.clone().any(|(_, body)| is_named_after_foot(body));
    let is_of_hand = |body: &str| HAND_WORDS.iter().any(|word| has_word(body, word));
    let on_hands = carriers.filter(|(_, body)| has_feet && is_of_hand(body));
    let on_hands: Vec<&String> = on_hands.map(|(path, _)| path).collect();
    move |sphere| {
        let is_on_floor = on_floors.is_empty() || on_floors.contains_key(sphere.path.as_str());
        is_on_floor && !on_hands.contains(&&sphere.path)
    }
}

/// Finds spheres that sink in up to their centres even if all bottoms are level.
fn sunk_in_level(check: &FigureCheck<'_>) -> Option<FindingWithRemedy> {
    let carries = LazyCell::new(|| can_carry(check));
    let affected = check.spheres_with(|sphere| {
        sphere.value(Figure::Indentation).filter(|_| sphere.is_in_to_centre() && (*carries)(sphere))
    })?;
    let x = four_significant(affected.largest);
    let text = format!(
        "too soft: at body weight on {} spheres sink {x} R into the floor (x/R by Hertz)",
        check.inspected.carriers
    );
    let mut finding = check.finding_at_sphere(&SUNK_IN, &text, &affected);
    Some(match ManyLimbs::of(check) {
        Some(limbs) => limbs.sunk_in(finding, affected.largest, check),
        None => {
            finding.advice = advice_if_made_for_this_body(check).unwrap_or(finding.advice);
            FindingWithRemedy::new(finding, check.remedies.reduce_indentation(&check.spheres))
        }
    })
}

/// Advice if the contacts are recorded as made for this mass. Scaling them does not help then.
fn advice_if_made_for_this_body(check: &FigureCheck<'_>) -> Option<Phrase> {
    let made_for = check.inspected.contacts_mass_kg.as_ref().filter(|mass| mass.from.is_about_contacts())?;
    let weighs_kg = check.inspected.figures.mass_kg.filter(|&kg| are_equal_masses(kg, made_for.value))?;
    Some(phrase![
        "They were made for {} kg ({}), which the body weighs: make them stiffer, for a relative indentation of {}";
        four_significant(weighs_kg), &made_for.description, INDENTATION.value.to_string()
    ])
}

/// Finds limbs whose lower spheres alone carry the weight that all spheres should carry. The contacts are not too soft. The finding is a
/// remark if the foot leans, because then the pose decides which spheres are low.
fn sunk_in_at_own_heights(check: &FigureCheck<'_>) -> Option<FindingWithRemedy> {
    let carries = LazyCell::new(|| can_carry(check));
    let bottoms = LazyCell::new(|| bottoms_by_path(check));
    let limb_leans = |sphere: &SphereFigures| {
        let mut limbs = check.inspected.figures.limbs.iter();
        let limb = limbs.find(|limb| limb.spheres.iter().any(|one| one.path == sphere.path));
        limb.and_then(|limb| UnevenLimb::of(&bottoms, limb)).is_some_and(|limb| limb.leans())
    };
    let too_deep = |leans: bool| {
        check.spheres_with(|sphere| {
            let x = sphere.value(Figure::StandingIndentationModelLaw);
            x.filter(|&x| x >= UP_TO_CENTRE_RADII && (*carries)(sphere) && limb_leans(sphere) == leans)
        })
    };
    if let Some(affected) = too_deep(true).filter(|_| too_deep(false).is_none()) {
        let text = format!(
            "at the default pose the foot is tilted, and at body weight on {} its lower spheres alone carry the body and sink {} R into the \
             floor",
            check.inspected.carriers,
            four_significant(affected.largest)
        );
        let finding = check.finding_at_sphere(&SUNK_IN, &text, &affected).with_severity(Severity::Remark);
        return Some(finding.with_advice(ADVICE_FOR_LEANING_FOOT).into());
    }
    let affected = too_deep(false)?;
    let x = four_significant(affected.largest);
    let text = format!(
        "at body weight on {} the lower spheres carry the body alone, and sink {x} R into the floor (x/R with each sphere at its own \
         height at the default pose)",
        check.inspected.carriers
    );
    Some(FindingWithRemedy::new(check.finding_at_sphere(&SUNK_IN, &text, &affected), level_feet(check)))
}

/// Advice about a foot that stands on an edge because of the default pose.
const ADVICE_FOR_LEANING_FOOT: &str = "Nothing, if simulations start from a pose of their own; else give the joints default values at which the foot lies flat";

/// The least number of limbs that carry a body with more than two limbs, as in a trotting horse.
const LEAST_CARRYING_LIMBS: f64 = 2.0;

/// A body with more than two limbs.
struct ManyLimbs {
    limbs: usize,
    /// Number of limbs that share the weight in the figures.
    stance_limbs: f64,
}

impl ManyLimbs {
    /// The limbs of the body; `None` for two limbs or fewer, if the caller gives the number of spheres that share the weight, or if this
    /// number is not known.
    fn of(check: &FigureCheck<'_>) -> Option<Self> {
        let stance = &check.remedies.options.stance;
        let limbs = check.inspected.limbs.as_ref()?.len();
        let is_counted = stance.spheres.is_none() && check.remedies.is_counted;
        (limbs > 2 && is_counted).then_some(Self { limbs, stance_limbs: check.inspected.stance_limbs })
    }

    /// The least number of limbs that carry the body, and x/R on them, if it is `x` in the figures.
    fn on_carrying_limbs(&self, x: f64) -> (f64, f64) {
        let carrying = self.stance_limbs.max(LEAST_CARRYING_LIMBS);
        // Equal spheres share the load, and x̂ follows F^(2/3) (3).
        (carrying, x * (self.stance_limbs / carrying).powf(2.0 / 3.0))
    }

    /// x/R on more limbs than in the figures, in words; empty if so many carry the body there.
    fn on_more_limbs(&self, x: f64) -> String {
        let (carrying, x_hat) = self.on_carrying_limbs(x);
        let on = format!("; on {} of its {} limbs it is ", readable(carrying), self.limbs);
        if self.stance_limbs < carrying { on + &four_significant(x_hat) + " R" } else { String::new() }
    }

    /// Adapts `finding`, that spheres sink in by `x` of their radius, to a body with many limbs: adds x/R on two limbs, and advice.
    fn sunk_in(&self, mut finding: Finding, x: f64, check: &FigureCheck<'_>) -> FindingWithRemedy {
        let (carrying, x_hat) = self.on_carrying_limbs(x);
        finding.message.push(self.on_more_limbs(x));
        match x_hat < UP_TO_CENTRE_RADII {
            // The contacts may be right, because no animal stands on one of four limbs.
            true => {
                finding.with_advice(self.advice_to_stand_on(carrying)).with_severity(Severity::Warning).into()
            }
            false => {
                let remedy = check.remedies.transfer_published(Some(carrying)).map(Request::from);
                let advice = advice_for_other_number_of_limbs(carrying);
                FindingWithRemedy::new(finding.with_advice(advice), remedy)
            }
        }
    }

    /// Advice for a body that always stands on at least this many limbs.
    fn advice_to_stand_on(&self, carrying: f64) -> Phrase {
        let check = Verb::Check.call_with_model().with_value(Input::StanceLimbs, readable(carrying));
        phrase![
            format!("Nothing, if at least two of its {} limbs always carry it: say so, with ", self.limbs),
            check,
            "; else make the contacts stiffer",
        ]
    }
}

/// Advice for contacts that were made for a body on another number of limbs: scaling by mass alone does not make them right.
fn advice_for_other_number_of_limbs(carrying: f64) -> Phrase {
    phrase![
        "If the contacts were made for another body, take those of a known model, at the size of this body, with ",
        Input::StanceLimbs.with_value(readable(carrying)),
        ": scaled by mass alone they are still those of another number of spheres. If they were made for this one, make them stiffer, for the x/R that you want with so many limbs",
    ]
}

/// Contacts whose spheres sink in by less than this, x/R, are too stiff. Published contacts sink in by 0.03 or more.
const LEAST_PLAUSIBLE_INDENTATION: f64 = 1e-3;
/// Contacts whose spheres sink in by less than this, x/R, are a remark. A thousand times the stiffness of published gait models gives less.
const LEAST_USUAL_INDENTATION: f64 = 1e-2;

rule! { pub(super) TOO_STIFF: TooStiff, Warning, Solver;
    what: "The contacts are far too stiff: at body weight on one limb, spheres sink in by less than 0.001 R. It is a remark up to 0.01 R.",
    why: "No foot is so stiff, and a solver takes steps of microseconds, or fails. Published contacts sink in by 0.03 R or more. Mostly the stiffness is in another unit, or has a digit too many.",
    advice: "Write the stiffness in N/m2, such as 1e6 for a human",
    repair: Repair::NotPossible("only you know the right stiffness"),
    example: Example::ElementText { tag: "stiffness", good: "4.4876e7", bad: "4.4876e13" },
}

/// Finds contacts that are so stiff that their spheres hardly sink in.
pub(crate) fn find_too_stiff_contacts(check: &FigureCheck<'_>) -> Option<FindingWithRemedy> {
    let below = |least: f64| {
        // The smallest of them is the worst.
        let too_small = |sphere: &SphereFigures| sphere.value(Figure::Indentation).filter(|x| *x < least);
        let affected = check.spheres_with(|sphere| too_small(sphere).map(|x| -x))?;
        let x = four_significant(-affected.largest);
        let text = format!(
            "too stiff: at body weight on {} spheres sink {x} R into the floor (x/R by Hertz), expected at least {least}",
            check.inspected.carriers
        );
        Some(check.finding_at_sphere(&TOO_STIFF, &text, &affected))
    };
    let unusual = || Some(below(LEAST_USUAL_INDENTATION)?.with_severity(Severity::Remark));
    below(LEAST_PLAUSIBLE_INDENTATION).or_else(unusual).map(FindingWithRemedy::from)
}

rule! { pub(super) BEYOND_HERTZ: BeyondHertz, Remark, Mass;
    what: "Spheres sink in deeper than Hertz' law is accurate for, at body weight on one limb.",
    why: "Hertz' law was found accurate up to a relative indentation of {indentation}, a contact patch of 0.4 R. Beyond it, the contact acts as a non-linear spring, no longer as a material. Most published gait models are beyond it (Falisse et al. 2022: 0.353).",
    advice: "Nothing, if a spring is intended; else make the spheres stiffer, larger or more, for a relative indentation of {indentation} at most",
    repair: Repair::NotPossible("a remark: most published contacts are outside this limit, and their authors chose that"),
    example: Example::ElementText { tag: "stiffness", good: "4.4876e7", bad: "1e7" },
}

/// Finds spheres that sink in beyond the limit of the Hertz law under the body weight.
pub(super) fn find_beyond_hertz(check: &FigureCheck<'_>) -> Option<FindingWithRemedy> {
    find_beyond(check, &BEYOND_HERTZ, (Figure::Indentation, "body weight"), |_, x| x < UP_TO_CENTRE_RADII)
}

/// Finds spheres whose `figure`, at the load `under`, is beyond the limit of the Hertz law, and which the rule is about.
fn find_beyond(
    check: &FigureCheck<'_>,
    rule: &'static Rule,
    (figure, under): (Figure, &str),
    is_about: impl Fn(&SphereFigures, f64) -> bool,
) -> Option<FindingWithRemedy> {
    let beyond = |sphere: &SphereFigures| value_beyond_limit(sphere, figure).filter(|&x| is_about(sphere, x));
    let affected = check.spheres_with(beyond)?;
    let (x, limit) = (four_significant(affected.largest), INDENTATION.value);
    let text = format!(
        "under {under} on {} spheres sink in {x} R, and Hertz theory holds up to {limit} R",
        check.inspected.carriers
    );
    let finding = check.finding_at_sphere(rule, &text, &affected);
    let Some(ways) = ways_within_hertz(affected.largest) else { return Some(finding.into()) };
    let more = ManyLimbs::of(check).map(|limbs| limbs.on_more_limbs(affected.largest));
    let message = phrase![&finding.message, more.unwrap_or_default(), "; ", ways];
    Some(finding.with_message(message).into())
}

/// What brings spheres that sink in by `x` of their radius to the limit of Hertz' law, each change alone; `None` within the limit.
pub fn ways_within_hertz(x: f64) -> Option<String> {
    // Rounded down, a factor would leave the spheres beyond the limit.
    let up = |factor: f64| {
        let unit = 10_f64.powf(factor.log10().floor() - 3.0);
        four_significant((factor / unit - 1e-9).ceil() * unit)
    };
    let [radius, stiffness] = growth_to_indentation_limit(x)?.map(up);
    let limit = INDENTATION.value;
    Some(format!(
        "one of these alone gives {limit} R: radius x{radius}, stiffness x{stiffness}, or {stiffness} times as many spheres"
    ))
}

rule! { pub(super) BEYOND_HERTZ_AT_TWO: BeyondHertzAtTwo, Remark, Mass;
    what: "Spheres sink in deeper than Hertz' law is accurate for, at two body weights and not at one.",
    why: "A foot carries more than body weight in running and landing. At twice body weight the relative indentation is above {indentation}, up to which Hertz' law is accurate.",
    advice: "Nothing, if the model only walks; else make the spheres stiffer, larger or more, for a relative indentation of {indentation} at two body weights",
    repair: Repair::NotPossible("walking is within the limit; whether the model runs, only you know"),
    example: Example::ElementText { tag: "stiffness", good: "4.4876e7", bad: "2.5e7" },
}

/// Finds spheres that are beyond the limit of the Hertz law only under twice the body weight.
pub(super) fn find_beyond_hertz_at_two(check: &FigureCheck<'_>) -> Option<FindingWithRemedy> {
    find_beyond(check, &BEYOND_HERTZ_AT_TWO, (Figure::IndentationAtTwo, "two body weights"), |sphere, _| {
        sphere.is_within(Figure::Indentation) == Some(true)
    })
}
