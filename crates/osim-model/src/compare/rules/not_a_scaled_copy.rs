//! A model is not a scaled copy of the reference whose contacts follow its bodies.

use crate::messages::Phrase;
use crate::model::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::NotAScaledCopy,
    severity: Severity::Warn,
    seen: Seen::Change,
    verdict: None,
    what: "A model is not a scaled copy of the reference whose contacts follow its bodies.",
    why: "In a scaled copy, joint offsets and meshes give each factor exactly. Between different models offsets are not factors: a body then gets the ratio of the mesh factors of the same bone, else one ratio of distances to a joint below it, and the last body of a limb the factors of the body it hangs on.",
    advice: "Nothing, if another model is meant; else name the generic model that this one was scaled from, or say `body_scale=BODY=x,y,z`",
    repair: Repair::NotPossible("only you know which model this one was scaled from"),
    example: Example::Request {
        good: r#"{"verb": "inspect", "models": ["scale_tool/scaled_smooth.osim"], "from": "scale_tool/generic_smooth.osim"}"#,
        bad: r#"{"verb": "inspect", "models": ["scale_tool/scaled_smooth.osim"], "from": "feet/human_40000.osim"}"#,
    },
};

/// What follows from a difference, after it.
const NO_COPY: &str = "no factors per body and axis lead from the reference to this model; factors are those of the same bone's \
                       mesh, or ratios of distances between joints";

/// `message` says what differs.
pub(crate) fn of_difference(mut message: Phrase) -> Finding {
    message.push(NO_COPY);
    Finding::new(&RULE, message)
}
