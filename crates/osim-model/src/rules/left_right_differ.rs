//! Left and right contacts differ.

use contact_scaling::Ratios;

use crate::contacts::Force;
use crate::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::Model;
use crate::property::Property;
use crate::side::{Side, without_side};
use crate::sides::{Bones, close, right_forces, spheres};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::LeftRightDiffer,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sides),
    what: "Left and right contacts differ.",
    why: "Contacts of a symmetric model are nearly always meant to be symmetric; a difference usually is a slip of the hand.",
    advice: "Compare the two sides with `inspect` and correct the one that is wrong",
    repair: Repair::Command(
        "writes the values of the right side into the left force, where they can be written in one call",
    ),
    example: Example::Piece {
        model: "table1/human_62kg_smooth_sphere.osim",
        good: "<stiffness>1000000</stiffness>",
        bad: "<stiffness>2000000</stiffness>",
    },
};

/// Forces whose names differ only in the side should have equal parameters, or such as follow bones that were scaled unlike.
pub(super) fn find(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    let right = right_forces(model);
    let mut bones: Option<Bones> = None;
    let side = |name: &str| Side::of_name(name);
    for force in model.forces().iter().filter(|force| side(&force.name) == Some(Side::Left)) {
        let Some(other) = right.get(&without_side(&force.name)).copied() else {
            continue;
        };
        let Some(what) = difference(model, force, other) else { continue };
        let what = match bones.get_or_insert_with(|| Bones::of(model)).explain_radii(model, force, other) {
            Some(ratios) => match unlike(force, other, &ratios) {
                Some(what) => what,
                None => continue,
            },
            None => what,
        };
        let text = format!("{} and {} differ: {what}", force.path, other.path);
        found.push(Finding::at(&RULE, force.line, text).about(&force.path));
    }
    found
}

/// The first difference between them, in words.
fn difference(model: &Model, left: &Force, right: &Force) -> Option<String> {
    let differing = left.sets.iter().zip(&right.sets).find_map(|(left, right)| {
        left.values.iter().zip(&right.values).find(|(l, r)| l.number != r.number && !l.number.is_nan())
    });
    let radii = |force: &Force| -> Vec<u64> {
        spheres(model, force).into_iter().map(|sphere| sphere.radius.number.to_bits()).collect()
    };
    match differing {
        Some((left, right)) => Some(format!("{} is {} and {}", left.property, left.number, right.number)),
        None => (radii(left) != radii(right)).then(|| "radii differ".to_owned()),
    }
}

/// The first parameter that does not follow the radii, in words. The modulus has to; of the others some stay as they are, as the
/// caller of a change wants it.
fn unlike(left: &Force, right: &Force, ratios: &Ratios) -> Option<String> {
    left.sets.iter().zip(&right.sets).find_map(|(left, right)| {
        let mut pairs = left.values.iter().zip(&right.values).filter(|(l, _)| !l.number.is_nan());
        let (l, r) = pairs.find(|(l, r)| {
            let follows = factor(l.property, ratios).is_some_and(|factor| close(l.number, factor * r.number));
            !follows && (l.number != r.number || l.property == Property::Stiffness)
        })?;
        Some(format!(
            "{} is {} and {}, which does not follow the radii of the two sides",
            l.property, l.number, r.number
        ))
    })
}

/// By what a parameter is multiplied where radii alone change.
fn factor(property: Property, ratios: &Ratios) -> Option<f64> {
    Some(match property {
        Property::Stiffness => ratios.plane_strain_modulus(),
        Property::Dissipation => ratios.dissipation(),
        Property::ConstantContactForce => ratios.constant_contact_force(),
        Property::HertzSmoothing => ratios.hertz_smoothing(),
        Property::HuntCrossleySmoothing => ratios.hunt_crossley_smoothing(),
        Property::TransitionVelocity => ratios.transition_velocity(),
        Property::ViscousFriction => ratios.viscous_friction(),
        _ => return None,
    })
}
