//! A component was found by its name because the path written leads nowhere.

use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::ConnecteeByName,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: None,
    what: "A component was found by its name because the path written leads nowhere.",
    why: "OpenSim may fail to load such a model, or connect it to something else.",
    advice: "Open the model in OpenSim, check the connection and save it",
    repair: Repair::NotPossible("only OpenSim shows what it connects"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<socket_frame>/bodyset/calcn_r</socket_frame>",
        bad: "<socket_frame>calcn_r</socket_frame>",
    },
};

/// `text` of the component `whose` names nothing; what was taken has the path `taken`.
pub(crate) fn of_connectee(text: &str, whose: &str, taken: &str, line: usize) -> Finding {
    let text = format!("'{text}' of {whose} leads nowhere; took {taken}, the only one of that name");
    Finding::at(&RULE, line, text).about(whose)
}
