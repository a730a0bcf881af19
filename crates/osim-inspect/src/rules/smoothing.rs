//! Rules about smoothing and dissipation: forces before contact, and energy lost in an impact.

use contact_scaling::limits::{
    CONSTANT_INDENTATION, RESTITUTION, SUGGESTED_TRANSITION_WIDTH, TOUCHING_SHARE, TRANSITION_WIDTH,
};
use osim_model::messages::four_significant;
use osim_model::{Example, Property, Repair};
use osim_requests::options::WantedOptions;
use osim_requests::{ConstantIndentation, Positive, Request};

use crate::figures::{Figure, SphereFigures};
use crate::findings::{FindingWithRemedy, Remedies, constant_indentation_for_touching, transition_width_for};
use crate::rules::figure_check::{FigureCheck, value_beyond_limit};
use osim_model::rule;

rule! { pub(super) FLOATS: Floats, Error, Mass;
    what: "The smoothing alone carries body weight: the spheres do not touch the floor.",
    why: "constant_contact_force is far too large for the spheres, or hertz_smoothing far too small: the force before contact holds the body in the air.",
    advice: "Make constant_contact_force smaller and hertz_smoothing larger, until the spheres touch the floor",
    repair: Repair::Command("designs constant_contact_force so that the spheres touch the floor"),
    example: Example::ElementText { tag: "constant_contact_force", good: "9e-07", bad: "0.0001" },
}

/// Finds a body that smoothed forces carry above the floor.
pub(super) fn find_floating_body(check: &FigureCheck<'_>) -> Option<FindingWithRemedy> {
    let above =
        |sphere: &SphereFigures| sphere.value(Figure::IndentationModelLaw).filter(|&x| x <= 0.0).map(|x| -x);
    let affected = check.spheres_with(above)?;
    let text = format!("body weight is carried {} R above the floor", four_significant(affected.largest));
    let finding = check.finding_at_force(&FLOATS, &text, &affected);
    Some(FindingWithRemedy::new(finding, bring_spheres_to_floor(check.remedies, &check.spheres)))
}

/// A remedy that designs the constant indentation so that spheres reach the floor. It also narrows a wide transition, because far above the
/// floor the force of (C.1) is large again.
fn bring_spheres_to_floor(remedies: &Remedies<'_>, spheres: &[&SphereFigures]) -> Option<Request> {
    let (width_for_tenth, width_for_half) =
        (transition_width_for(spheres, TOUCHING_SHARE.value)?, transition_width_for(spheres, 0.5)?);
    let is_wide = |sphere: &&SphereFigures| {
        let width = sphere.value(Figure::TransitionWidth);
        sphere.is_within(Figure::TransitionWidth) == Some(false)
            || width.is_some_and(|width| width > width_for_half)
    };
    let width = spheres.iter().any(is_wide).then_some(width_for_tenth.min(SUGGESTED_TRANSITION_WIDTH));
    let wanted = WantedOptions {
        constant_indentation: Some(
            ConstantIndentation::new(constant_indentation_for_touching(spheres)?).ok()?,
        ),
        state_width: width.map(Positive::new).transpose().ok()?,
        ..WantedOptions::default()
    };
    remedies.design(wanted).map(Request::from)
}

rule! { pub(super) FORCE_BEFORE_CONTACT: ForceBeforeContact, Warning, Solver;
    what: "A sphere that only just touches the floor carries a large part of its share of body weight already.",
    why: "Smoothing gives a force before contact (Fig. C.5): the floor pushes the foot away as if the spheres were larger. In Falisse et al. (2022), where this did no harm, the force is 0.074 of the share.",
    advice: "Make constant_contact_force smaller",
    repair: Repair::Command("designs constant_contact_force so that the share comes down to the limit"),
    example: Example::ElementText { tag: "constant_contact_force", good: "9e-07", bad: "4e-06" },
}

/// Finds spheres that carry too much of the load while they just touch the floor.
pub(super) fn find_force_before_contact(check: &FigureCheck<'_>) -> Option<FindingWithRemedy> {
    let affected = check.spheres_with(|sphere| value_beyond_limit(sphere, Figure::TouchingShare))?;
    let force = affected.worst.value(Figure::ForceJustTouching).map(four_significant).unwrap_or_default();
    let share = four_significant(affected.largest);
    let text = format!("just touching, a sphere carries {force} N, {share} of its share of body weight");
    let finding = check.finding_at_force(&FORCE_BEFORE_CONTACT, &text, &affected);
    let constant = constant_indentation_for_touching(&check.spheres);
    let remedy = constant.and_then(|constant| check.remedies.design_constant_indentation(constant));
    Some(FindingWithRemedy::new(finding, remedy))
}

rule! { pub(super) LARGE_CONSTANT_INDENTATION: LargeConstantIndentation, Warning, Solver;
    what: "The constant indentation of constant_contact_force is a large part of the radius.",
    why: "constant_contact_force is a squared indentation and does not grow with the sphere by itself: OpenSim's default of 1e-5 m2, made for spheres of 32 mm, is 3.2 mm. On smaller spheres it holds the body up before they touch (C.2).",
    advice: "Make constant_contact_force smaller, for a constant indentation of {constant_indentation} of the radius at most; where spheres sink in by less than {indentation} R, of {suggested_indentation}",
    repair: Repair::Command("designs constant_contact_force for the limit"),
    example: Example::ElementText { tag: "constant_contact_force", good: "9e-07", bad: "1.5e-05" },
}

/// Finds spheres whose √cf/R is above the limit.
pub(super) fn find_large_constant_indentation(check: &FigureCheck<'_>) -> Option<FindingWithRemedy> {
    let affected = check.spheres_with(|sphere| value_beyond_limit(sphere, Figure::ConstantIndentation))?;
    let x = four_significant(affected.largest);
    let text = format!("sqrt(constant_contact_force)/R is {x}, limit {}", CONSTANT_INDENTATION.value);
    let remedy = check.remedies.design_constant_indentation(CONSTANT_INDENTATION.value);
    Some(FindingWithRemedy::new(
        check.finding_at_force(&LARGE_CONSTANT_INDENTATION, &text, &affected),
        remedy,
    ))
}

rule! { pub(super) WIDE_TRANSITION: WideTransition, Warning, Solver;
    what: "Smoothing switches contact on over more of the radius than in published models.",
    why: "hertz_smoothing is an inverse length: OpenSim's default of 300 1/m, made for spheres of 32 mm, spreads the onset of contact over 10 mm. On smaller spheres that is a large part of the radius, half of it before they touch (C.7).",
    advice: "Make hertz_smoothing larger, so that contact switches on over {suggested_width} of the radius",
    repair: Repair::Command("designs hertz_smoothing for a width within the limit"),
    example: Example::ElementText { tag: "hertz_smoothing", good: "310", bad: "100" },
}

/// Finds spheres whose contact begins over too wide a range.
pub(super) fn find_wide_transition(check: &FigureCheck<'_>) -> Option<FindingWithRemedy> {
    let affected = check.spheres_with(|sphere| value_beyond_limit(sphere, Figure::TransitionWidth))?;
    let (width, limit) = (four_significant(affected.largest), TRANSITION_WIDTH.value);
    let text = format!("smoothing switches contact on over {width} R, limit {limit} R");
    Some(FindingWithRemedy::new(
        check.finding_at_force(&WIDE_TRANSITION, &text, &affected),
        narrow_transition(check.remedies),
    ))
}

rule! { pub(super) WEAK_AT_REST: WeakAtRest, Warning, Solver;
    what: "The smoothing over speeds takes a part of the force of a sphere at rest.",
    why: "At rest, OpenSim multiplies the force by (1 + tanh(2 bv/(3 α)))/2 with hunt_crossley_smoothing bv and dissipation α (C.9). With published numbers this is 1; else spheres sink in deeper.",
    advice: "Make hunt_crossley_smoothing larger, until a sphere at rest presses with its whole force",
    repair: Repair::NotPossible("only you know the right hunt_crossley_smoothing"),
    example: Example::ElementText { tag: "hunt_crossley_smoothing", good: "52", bad: "0.1" },
}

/// A sphere at rest presses with at least this part of its force; with published numbers it is 1.
const LEAST_FORCE_AT_REST: f64 = 0.9;

/// Finds spheres of whose force the smoothing over speeds takes a part at rest, so that they sink in deeper.
pub(super) fn find_weak_at_rest(check: &FigureCheck<'_>) -> Option<FindingWithRemedy> {
    let affected = check.spheres_with(|sphere| {
        let parameters = &check.force_of(sphere)?.parameters;
        let smoothing = parameters.get(Property::HuntCrossleySmoothing.as_str())?;
        let at_rest = 2.0 * smoothing / (3.0 * parameters.get(Property::Dissipation.as_str())?);
        Some(0.5 - 0.5 * libm::tanh(at_rest)).filter(|lost| *lost > 1.0 - LEAST_FORCE_AT_REST)
    })?;
    let text = format!(
        "a sphere at rest presses with {} of its force, expected {LEAST_FORCE_AT_REST} or more: hunt_crossley_smoothing is too small for \
         the dissipation",
        four_significant(1.0 - affected.largest)
    );
    Some(check.finding_at_force(&WEAK_AT_REST, &text, &affected).into())
}

/// A remedy that gives the contact the suggested transition width.
fn narrow_transition(remedies: &Remedies<'_>) -> Option<Request> {
    let state_width = Some(Positive::new(SUGGESTED_TRANSITION_WIDTH).ok()?);
    remedies.design(WantedOptions { state_width, ..WantedOptions::default() }).map(Request::from)
}

rule! { pub(super) BEYOND_HUNT_CROSSLEY: BeyondHuntCrossley, Remark, Solver;
    what: "Restitution by (13) is so low that the Hunt-Crossley law is not accurate.",
    why: "The Hunt-Crossley law describes materials that give back most of the impact speed. Below a restitution of {restitution} at the impact speed, dissipation is a damper that makes a simulation calm; energies lost in contact are not those of a material.",
    advice: "Nothing, if this is intended; else write a smaller dissipation, for a restitution of {restitution} at least",
    repair: Repair::NotPossible("a remark: most published contacts are outside this limit, and their authors chose that"),
    example: Example::ElementText { tag: "dissipation", good: "0.4", bad: "2" },
}

/// Finds spheres whose restitution is below the limit of the Hunt–Crossley law.
pub(super) fn find_beyond_hunt_crossley(check: &FigureCheck<'_>) -> Option<FindingWithRemedy> {
    let speed = check.inspected.figures.impact_speed_m_s?;
    // The largest dissipation has the least restitution.
    let affected = check.spheres_with(|sphere| {
        let outside = sphere.is_within(Figure::RestitutionApproximate) == Some(false);
        sphere.value(Figure::Dissipation).filter(|_| outside)
    })?;
    let restitution = affected.worst.value(Figure::RestitutionApproximate);
    let restitution = restitution.map_or_else(|| "below 0".to_owned(), four_significant);
    let exact = affected.worst.value(Figure::RestitutionExact);
    let exact = exact.map_or_else(|| "not known".to_owned(), four_significant);
    let text = format!(
        "the restitution at {} m/s is {exact}, by (13) {restitution}, limit {} or more",
        four_significant(speed),
        RESTITUTION.value
    );
    let finding = check.finding_at_force(&BEYOND_HUNT_CROSSLEY, &text, &affected);
    Some(finding.with_measure(affected.largest * speed, "").into())
}
