//! The friction of SmoothSphereHalfSpaceForce is not exactly similar.

use osim_model::{
    Example, Finding, FindingCode, Force, ForceKind, Property, PropertySet, Repair, Rule, Seen, Severity,
};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::FrictionNotSimilar,
    severity: Severity::Info,
    seen: Seen::Change,
    verdict: None,
    what: "The friction of SmoothSphereHalfSpaceForce is not exactly similar.",
    why: "Simbody adds constant_contact_force to the squared slip speed, where similarity wants a term in proportion to g R: friction of the smooth force is similar only as far as that term is small.",
    advice: "Compare slip speeds with the root of constant_contact_force before relying on it",
    repair: Repair::NotPossible("it lies in how OpenSim computes friction"),
    example: Example::Request {
        good: r#"{"verb": "rescale", "models": ["table1/human_62kg_smooth_sphere.osim"], "target_mass": 90}"#,
        bad: r#"{"verb": "rescale", "models": ["table1/human_62kg_smooth_sphere.osim"], "target_mass": 90, "friction": true}"#,
    },
};

/// Whether the friction of one of `forces` is scaled and not exactly similar.
pub(crate) fn of_forces<'f>(
    mut forces: impl Iterator<Item = &'f Force>,
    properties: &PropertySet,
) -> Option<Finding> {
    let scaled = properties.contains(Property::TransitionVelocity)
        && forces.any(|force| force.kind == ForceKind::SmoothSphereHalfSpace);
    let text = "friction of SmoothSphereHalfSpaceForce scales only as far as constant_contact_force is small \
                against the squared slip speed";
    scaled.then(|| Finding::new(&RULE, text))
}
