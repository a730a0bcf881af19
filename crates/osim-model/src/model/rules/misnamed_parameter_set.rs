//! A ContactParametersSet has a name OpenSim does not look for.

use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::MisnamedParameterSet,
    severity: Severity::Error,
    seen: Seen::Model,
    verdict: None,
    what: "A ContactParametersSet has a name OpenSim does not look for.",
    why: "OpenSim finds the set by its name: with another one the force has no parameters and never pushes.",
    advice: "Name the set contact_parameters",
    repair: Repair::NotPossible("names are left alone: only numbers are changed"),
    example: Example::Piece {
        model: "format/v40000.osim",
        good: r#"<HuntCrossleyForce::ContactParametersSet name="contact_parameters">"#,
        bad: r#"<HuntCrossleyForce::ContactParametersSet name="parameters">"#,
    },
};

/// The set of the force `whose` is called `name`.
pub(crate) fn of_set(name: &str, whose: &str, line: usize) -> Finding {
    let text = format!(
        "{whose}: the parameter set is called '{name}', so OpenSim reads no parameters at all; call it contact_parameters"
    );
    Finding::at(&RULE, line, text).about(whose)
}
