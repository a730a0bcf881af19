//! Sphere and half-space of a converted force have parameters of their own.

use osim_model::{Example, Finding, FindingCode, Force, Repair, Rule, Seen, Severity};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::CompositeSurfaces,
    severity: Severity::Warn,
    seen: Seen::Change,
    verdict: None,
    what: "Sphere and half-space of a converted force have parameters of their own.",
    why: "A force of one sphere has one set of parameters. It gets those that both surfaces have together (A.3), which gives the same force; but Simbody moves the point of contact towards the softer surface, so that accelerations can differ by up to 3 %.",
    advice: "Nothing, if 3 % do not matter; otherwise give both surfaces the same parameters first",
    repair: Repair::NotPossible("only you know which parameters are meant"),
    example: Example::Request {
        good: r#"{"verb": "convert", "models": ["format/v40000.osim"], "to": "hunt-crossley"}"#,
        bad: r#"{"verb": "convert", "models": ["format/three_materials.osim"], "to": "hunt-crossley"}"#,
    },
};

/// The message about the new force for `sphere` and `plane`. A strict change is refused with it.
pub(crate) fn message(force: &Force, sphere: &str, plane: &str) -> String {
    format!(
        "{}: {sphere} and {plane} have parameters of their own; the new force has those of both together (A.3), and as Simbody \
         moves the contact point by the moduli, accelerations differ by up to 2.9 %",
        force.path
    )
}

pub(crate) fn of_force(force: &Force, message: String) -> Finding {
    Finding::at(&RULE, force.line, message).about(&force.path)
}
