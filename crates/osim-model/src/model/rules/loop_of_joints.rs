//! A body has more than one joint: joints form a loop, or OpenSim ignores some.

use crate::messages::listed;

use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};
use crate::model::typed_model::Model;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::LoopOfJoints,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: None,
    what: "A body has more than one joint: joints form a loop, or OpenSim ignores some.",
    why: "Of joints inside a body, as documents up to version 3 have them, OpenSim takes the first and ignores the others. Elsewhere it cuts a loop of joints: it divides a body into equal parts that a constraint holds together, and their masses still make the body's. Where a WeldJoint or a FreeJoint between two bodies is in the loop it divides nothing, and counts the mass of a body twice. Left, right and limbs follow the first joint of each body.",
    advice: "Say what the model weighs with `mass=KG` where it is asked for; in OpenSim, close a loop with a constraint instead of a joint",
    repair: Repair::NotPossible("only numbers of contacts are changed"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/loop_of_joints.osim" },
};

/// Joints of a loop that a text names.
const NAMED: usize = 6;

pub(super) fn find(model: &Model) -> Vec<Finding> {
    let (components, skeleton) = (model.components(), model.skeleton());
    let finding = |joint, text| Finding::at(&RULE, components.line(joint), text);
    let ignored = skeleton.ignored_joints().iter().map(|&joint| {
        let text =
            format!("{} is not the first joint of its body: OpenSim ignores it", components.tree.path(joint));
        finding(joint, text)
    });
    let loops = skeleton.loops();
    let cut = loops.joints.first().map(|&first| {
        let joints: Vec<_> = loops.joints.iter().map(|&joint| components.name(joint).into_owned()).collect();
        let named = listed(&joints, NAMED);
        let what = if loops.mass_is_in_doubt {
            "counts the mass of a body in it twice"
        } else {
            "divides a body in it, whose parts weigh together what the body weighs"
        };
        finding(first, format!("joints form a loop ({named}): OpenSim {what}"))
    });
    ignored.chain(cut).collect()
}
