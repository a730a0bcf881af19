//! The note gives another gravity than the model.

use osim_model::messages::{Input, phrase, readable};
use osim_model::{
    Example, Finding, FindingCode, Model, Repair, Rule, Seen, Severity, VerdictOn, same_gravity,
};

use crate::options::InspectOptions;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::GravitySourcesDisagree,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Mass),
    what: "The note gives another gravity than the model.",
    why: "Under another gravity than they were made for, spheres sink in more or less; figures are those under the model's own.",
    advice: "Set gravity in OpenSim, or look at the model under the gravity of its contacts with `check MODEL gravity=G`",
    repair: Repair::NotPossible("only you know which gravity is meant"),
    example: Example::Piece {
        model: "check/earlier_note.osim",
        good: "<gravity>0 -9.81 0</gravity>",
        bad: "<gravity>0 -1.62 0</gravity>",
    },
};

/// The finding, where the note in the file gives a gravity, the model another, and nobody says which is meant.
pub(crate) fn find(model: &Model, options: &InspectOptions) -> Option<Finding> {
    let noted = model.note.as_ref()?.gravity_m_s2?;
    let own = model.gravity().filter(|&gravity| gravity > 0.0)?;
    if options.stance.gravity_m_s2.is_some() || same_gravity(noted, own) {
        return None;
    }
    let (noted, own) = (readable(noted), readable(own));
    let message = phrase![
        format!(
            "its contacts are made for {noted} m/s2 (note in the file), and its gravity is {own} m/s2: set <gravity>"
        ),
        Input::Gravity.either(phrase![", or say ", Input::Gravity.being(noted)], ""),
    ];
    Some(Finding::new(&RULE, message))
}
