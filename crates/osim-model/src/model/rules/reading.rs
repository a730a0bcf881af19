//! Rules that are raised where a model is read: by connections, parameter sets, notes and masses.

use crate::messages::{Phrase, phrase, readable};
use crate::model::fault::NoteDoubt;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};

pub(super) static CONNECTEE_BY_NAME: Rule = Rule {
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
pub(crate) fn connectee_by_name(text: &str, whose: &str, taken: &str, line: usize) -> Finding {
    let text = format!("'{text}' of {whose} leads nowhere; took {taken}, the only one of that name");
    Finding::at(&CONNECTEE_BY_NAME, line, text).about(whose)
}

pub(super) static MISNAMED_PARAMETER_SET: Rule = Rule {
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
pub(crate) fn misnamed_parameter_set(name: &str, whose: &str, line: usize) -> Finding {
    let text = format!(
        "{whose}: the parameter set is called '{name}', so OpenSim reads no parameters at all; call it contact_parameters"
    );
    Finding::at(&MISNAMED_PARAMETER_SET, line, text).about(whose)
}

pub(super) static MIXED_PAIR: Rule = Rule {
    code: FindingCode::MixedPair,
    severity: Severity::Error,
    seen: Seen::Model,
    verdict: None,
    what: "A note of another output file was found that does not belong to this one.",
    why: "The force set and the geometry set carry notes of different runs: their stiffnesses and radii do not belong together.",
    advice: "Write both again in one run",
    repair: Repair::NotPossible("only you know which of the two files is the right one"),
    example: Example::InWords {
        good: "force set and geometry set as one run wrote them",
        bad: "the geometry set of another run, with a note of its own",
    },
};

pub(crate) fn mixed_pair() -> Finding {
    Finding::new(&MIXED_PAIR, NoteDoubt::MixedPair.as_str())
}

pub(super) static MASS_SOURCES_DISAGREE: Rule = Rule {
    code: FindingCode::MassSourcesDisagree,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Mass),
    what: "The note, `mass` and the bodies give different masses.",
    why: "The factor of every change follows from the mass the contacts are made for; a wrong one scales all of them wrongly.",
    advice: "Check the mass that was taken (the first line of the output) and say `contacts_mass=KG` if it is not the right one",
    repair: Repair::NotPossible("only you know which of the masses is right"),
    example: Example::Models { good: "walks/child.osim", bad: "walks/scaled_noted.osim" },
};

/// A mass, and where it is from, in words.
pub(crate) struct SaidMass {
    pub(crate) kg: f64,
    pub(crate) source: Phrase,
}

/// Contacts are taken as made for one mass, and something else says another.
pub(crate) fn mass_sources_disagree(taken: &SaidMass, other: &SaidMass) -> Finding {
    let message = phrase![
        format!("contacts are taken as made for {} kg (", readable(taken.kg)),
        &taken.source,
        "), but ",
        &other.source,
        format!(" says {} kg", readable(other.kg)),
    ];
    Finding::new(&MASS_SOURCES_DISAGREE, message)
}
