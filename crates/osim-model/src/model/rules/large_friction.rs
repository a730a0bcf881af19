//! A coefficient of friction that no surface has.

use crate::messages::readable;

use crate::model::contacts::Force;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::property::Property;
use crate::model::typed_model::Model;

/// Between a foot and a floor it is about 0.3 to 1; of the stickiest rubber some 2.
const MOST: f64 = 10.0;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::LargeFriction,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sizes),
    what: "A coefficient of friction is larger than that of any surface.",
    why: "Between a foot and a floor it is about 0.3 to 1. More than 10 mostly is a percentage, or lacks its decimal point; a foot that slides is then stopped by a force of many times its weight.",
    advice: "Write the coefficient that is meant, such as 0.8",
    repair: Repair::NotPossible("only you know the number that is meant"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<static_friction>0.81</static_friction>",
        bad: "<static_friction>81</static_friction>",
    },
};

pub(super) fn find(model: &Model) -> Vec<Finding> {
    model.forces().iter().filter_map(of_force).collect()
}

/// The first coefficient of a force that is too large.
fn of_force(force: &Force) -> Option<Finding> {
    let is_friction = |property| {
        matches!(property, Property::StaticFriction | Property::DynamicFriction | Property::ViscousFriction)
    };
    let values = force.sets.iter().flat_map(|set| set.values.iter().map(move |value| (set, value)));
    let (set, large) = { values }.find(|(_, value)| is_friction(value.property) && value.number > MOST)?;
    let text = format!(
        "{} of {} is {}, expected at most {MOST}",
        large.property,
        force.path,
        readable(large.number)
    );
    Some(Finding::at(&RULE, set.line, text).about(&force.path))
}
