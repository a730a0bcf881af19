//! Rules about friction and dissipation of contacts.

use osim_model::messages::readable;
use osim_model::{Example, Finding, Model, Property, Repair, Severity, Value};

use crate::rules::forces::finding_about_forces;
use osim_model::rule;

/// The largest plausible coefficient of static or dynamic friction: that of the stickiest rubber.
const LARGEST_FRICTION: f64 = 2.0;
/// A coefficient of viscous friction above this, s/m, glues feet to the floor. Published models have up to 0.6.
const LARGEST_VISCOUS_FRICTION: f64 = 10.0;
/// A coefficient of viscous friction above this, s/m, is a remark.
const UNUSUAL_VISCOUS_FRICTION: f64 = 2.0;

rule! { pub(super) LARGE_FRICTION: LargeFriction, Warning, Sizes;
    what: "A coefficient of friction is larger than that of any surface. It is a remark for a viscous friction from 2 to 10 s/m.",
    why: "Between a foot and a floor it is about 0.3 to 1, and for the stickiest rubber about 2. More mostly is a percentage, or lacks its decimal point; a foot that slides is then stopped by a force of many times its weight. Published models have a viscous friction of up to 0.6 s/m.",
    advice: "Write the right coefficient, such as 0.8",
    repair: Repair::NotPossible("only you know the right number"),
    example: Example::ElementText { tag: "static_friction", good: "0.81", bad: "81" },
}

/// Finds coefficients of friction and transition velocities that are unlikely: at most one finding for each rule.
pub(super) fn find_odd_friction(model: &Model) -> Vec<Finding> {
    [find_large_friction(model), find_dynamic_above_static(model), find_odd_transition_velocity(model)]
        .into_iter()
        .flatten()
        .collect()
}

/// Finds coefficients of friction that are larger than any material has.
fn find_large_friction(model: &Model) -> Option<Finding> {
    let above = |largest_viscous: f64| {
        let limits = [
            (Property::StaticFriction, LARGEST_FRICTION),
            (Property::DynamicFriction, LARGEST_FRICTION),
            (Property::ViscousFriction, largest_viscous),
        ];
        finding_about_forces(model, &LARGE_FRICTION, |force, set| {
            let (large, limit) = limits.iter().find_map(|(property, limit)| {
                let is_large = |value: &&Value| value.number > *limit && value.number.is_finite();
                Some((set.value(*property).filter(is_large)?, limit))
            })?;
            let number = format!("{} {}", readable(large.number), large.property.unit());
            let (property, path, number) = (large.property, &force.path, number.trim_ascii_end());
            let text = format!("{property} of {path} is {number}, expected at most {limit}");
            Some((large.number / limit, text))
        })
    };
    let unusual = || Some(above(UNUSUAL_VISCOUS_FRICTION)?.with_severity(Severity::Remark));
    above(LARGEST_VISCOUS_FRICTION).or_else(unusual)
}

rule! { pub(super) DYNAMIC_ABOVE_STATIC: DynamicAboveStatic, Warning, Sizes;
    what: "The dynamic friction is larger than the static friction.",
    why: "No pair of materials is so: a foot that slides would be held more than one that rests. Mostly the two numbers were exchanged, or one lost its decimal point.",
    advice: "Write the larger of the two as static_friction; most published models have 0.8 for both",
    repair: Repair::NotPossible("only you know the right numbers"),
    example: Example::ElementText { tag: "static_friction", good: "0.81", bad: "0.18" },
}

/// Finds forces whose dynamic friction is larger than their static friction.
fn find_dynamic_above_static(model: &Model) -> Option<Finding> {
    finding_about_forces(model, &DYNAMIC_ABOVE_STATIC, |force, set| {
        let [sliding, resting] = [Property::DynamicFriction, Property::StaticFriction]
            .map(|property| set.value(property).map_or(0.0, |value| value.number));
        // One that is negative or not finite has another finding.
        (resting >= 0.0 && sliding > resting && sliding.is_finite()).then(|| {
            let ([more, less], path) = ([sliding, resting].map(readable), &force.path);
            let text = format!("dynamic_friction of {path} is {more}, but its static_friction {less}");
            (sliding - resting, text)
        })
    })
}

/// A transition velocity above this, m/s, is faster than feet slide.
const LARGEST_TRANSITION_VELOCITY: f64 = 5.0;
/// A transition velocity up to this, m/s, is plain Coulomb friction. Published models have 0.01 to 0.2.
const LEAST_TRANSITION_VELOCITY: f64 = 1e-4;

rule! { pub(super) ODD_TRANSITION_VELOCITY: OddTransitionVelocity, Warning, Solver;
    what: "The transition velocity is above 5 m/s. It is a remark up to 0.0001 m/s.",
    why: "Friction grows with the slip speed up to transition_velocity. Above 5 m/s a walking foot has hardly any friction; mostly the number is in mm/s. With 0 the friction is Coulomb's law: the dynamic coefficient at every speed, and no force at rest. A solver takes very small steps there. Published models have 0.01 to 0.2 m/s.",
    advice: "Nothing, if Coulomb's law is intended; else write the velocity in m/s, such as 0.2",
    repair: Repair::NotPossible("only you know the right number"),
    example: Example::ElementText { tag: "transition_velocity", good: "0.17", bad: "170" },
}

/// Finds transition velocities that are far too large or too small.
fn find_odd_transition_velocity(model: &Model) -> Option<Finding> {
    let where_odd = |is_odd: fn(f64) -> bool, what: &str| {
        finding_about_forces(model, &ODD_TRANSITION_VELOCITY, |force, set| {
            let speed = force.value(set.id, Property::TransitionVelocity)?.number;
            let text = || format!("transition_velocity of {} is {} m/s, {what}", force.path, readable(speed));
            (speed.is_finite() && is_odd(speed)).then(|| (speed.max(1.0 / speed), text()))
        })
    };
    let coulomb =
        || where_odd(|speed| (0.0..=LEAST_TRANSITION_VELOCITY).contains(&speed), "as in Coulomb's law");
    let large = where_odd(|speed| speed > LARGEST_TRANSITION_VELOCITY, "expected at most 5 m/s");
    large.or_else(|| Some(coulomb()?.with_severity(Severity::Remark)))
}

rule! { pub(super) NO_FRICTION: NoFriction, Remark, Solver;
    what: "No contact has friction.",
    why: "With all coefficients of friction 0, nothing stops a foot from sliding: a body that stands slides away at the first push.",
    advice: "Nothing, if this is intended; else write the coefficients, such as 0.8",
    repair: Repair::NotPossible("only you know the right numbers"),
    example: Example::Models { good: "check/known_contacts.osim", bad: "check/no_friction.osim" },
}

/// A dissipation below this, s/m, takes away almost no energy: 0.008 would take half a percent of the speed of an impact at 1 m/s.
const LEAST_DISSIPATION_S_M: f64 = 1e-3;

rule! { pub(super) NO_DISSIPATION: NoDissipation, Remark, Solver;
    what: "No contact has dissipation.",
    why: "Contacts that take away no energy bounce for ever: a body that lands on them does not come to rest.",
    advice: "Nothing, if this is intended; else write the dissipation, for example for a restitution of {restitution}",
    repair: Repair::NotPossible("only you know the right number"),
    example: Example::ElementText { tag: "dissipation", good: "0.4", bad: "0" },
}

/// Finds models in which no force on a floor has friction, or none has dissipation.
pub(super) fn find_no_friction_or_dissipation(model: &Model) -> Vec<Finding> {
    let on_floors = || model.forces().iter().filter(|force| model.meets_half_space(force));
    let Some(first) = on_floors().next() else { return Vec::new() };
    let are_all_below = |properties: &[Property], limit: f64| {
        let sets = on_floors().flat_map(|force| &force.sets);
        let mut values = sets.flat_map(|set| properties.iter().filter_map(|&property| set.value(property)));
        values.all(|value| (0.0..limit).contains(&value.number))
    };
    let frictions = [Property::StaticFriction, Property::DynamicFriction, Property::ViscousFriction];
    let no_friction = are_all_below(&frictions, f64::MIN_POSITIVE)
        .then(|| Finding::at(&NO_FRICTION, first.position, "all coefficients of friction are 0"));
    let no_dissipation = are_all_below(&[Property::Dissipation], LEAST_DISSIPATION_S_M).then(|| {
        Finding::at(&NO_DISSIPATION, first.position, "the dissipation of all contacts is 0 s/m or nearly 0")
    });
    no_friction.into_iter().chain(no_dissipation).map(|finding| finding.with_place(&first.path)).collect()
}
