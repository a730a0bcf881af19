//! Two sources give different scale factors of a body.

use crate::model::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::FactorsDisagree,
    severity: Severity::Warn,
    seen: Seen::Change,
    verdict: None,
    what: "Two sources give different scale factors of a body.",
    why: "A sphere's place and size follow from its body's factors; the first source in the order given, scale file, mesh, joint offset was taken.",
    advice: "Look at `inspect from`, and say `body_scale=BODY=x,y,z` where another source is right",
    repair: Repair::NotPossible("only you know which source is right"),
    example: Example::Request {
        good: r#"{"verb": "transfer", "models": ["scale_tool/scaled_smooth.osim"], "from": "scale_tool/generic_smooth.osim", "follow_bodies": true}"#,
        bad: r#"{"verb": "transfer", "models": ["scale_tool/scaled_smooth.osim"], "from": "scale_tool/generic_smooth.osim", "follow_bodies": true, "body_scale": {"calcn_r": [1.02, 0.91, 0.95]}}"#,
    },
};

/// Sources that say different sizes, in words.
pub(crate) fn of_sources(message: String) -> Finding {
    Finding::new(&RULE, message)
}
