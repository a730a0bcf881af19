//! Rules about a model beside another one, or beside published ones.

use super::placement::Reach;
use crate::messages::{Input, Phrase, Verb, phrase, readable};
use crate::model::{
    Example, Finding, FindingCode, Model, Repair, Rule, ScaledSinceNote, Seen, Severity, Sphere, VerdictOn,
};

/// The rules of this crate.
pub const RULES: &[&Rule] =
    &[&FACTORS_DISAGREE, &NOT_A_SCALED_COPY, &SPHERES_LEFT_BEHIND, &SPHERES_MISPLACED, &SPHERES_NOT_COMPARED];

static FACTORS_DISAGREE: Rule = Rule {
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
pub(crate) fn factors_disagree(message: String) -> Finding {
    Finding::new(&FACTORS_DISAGREE, message)
}

static NOT_A_SCALED_COPY: Rule = Rule {
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
pub(crate) fn not_a_scaled_copy(mut message: Phrase) -> Finding {
    message.push(NO_COPY);
    Finding::new(&NOT_A_SCALED_COPY, message)
}

static SPHERES_LEFT_BEHIND: Rule = Rule {
    code: FindingCode::SpheresLeftBehind,
    severity: Severity::Error,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sizes),
    what: "Spheres stand where they were before OpenSim scaled their bodies.",
    why: "OpenSim's Scale Tool scales bones, joints and masses. It leaves contact spheres where they were, as large and as stiff as before, so that they hang beyond the foot of a smaller animal and end short of a larger one's.",
    advice: "Compare with the model that was scaled: `check MODEL from=ORIGINAL` gives the command that moves the spheres with their bodies and makes the contacts right for this mass, too",
    repair: Repair::Command(
        "lets the spheres follow their bodies, where the note has their sizes or the original is named",
    ),
    example: Example::Models { good: "drawn_feet/six_spheres.osim", bad: "drawn_feet/left_behind.osim" },
};

/// By the note, bodies were scaled since.
pub(crate) fn left_behind_since_note(noted: &ScaledSinceNote) -> Finding {
    let bodies: Vec<String> =
        noted.factors.iter().map(|(body, factors)| format!("{body} x{}", size_text(*factors))).collect();
    let text: Phrase = format!(
        "bodies were scaled after the note was written, and the spheres stayed: {}",
        bodies.join(", ")
    )
    .into();
    Finding::new(&SPHERES_LEFT_BEHIND, text)
}

/// A sphere is where it was in the model that was scaled.
pub(crate) fn sphere_left_behind(name: &str, here_mm: &str, belongs_mm: &str) -> Finding {
    Finding::new(
        &SPHERES_LEFT_BEHIND,
        format!("{name} stayed at {here_mm} mm and belongs at {belongs_mm} mm"),
    )
}

/// One number for equal factors.
fn size_text([x, y, z]: [f64; 3]) -> String {
    if x == y && y == z { readable(x) } else { [x, y, z].map(readable).join(",") }
}

static SPHERES_MISPLACED: Rule = Rule {
    code: FindingCode::SpheresMisplaced,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sizes),
    what: "Spheres do not fit their bones, as in no published model, as in one of another size, or as on the other foot.",
    why: "OpenSim scaled the bones and left the spheres behind, the spheres were taken from a model of another size, or left and right were swapped. Then they push where the foot is not.",
    advice: "See where each belongs with `check MODEL from=ORIGINAL`, where ORIGINAL is the model that was scaled: it gives the command that puts them there, if there is one",
    repair: Repair::NotPossible(
        "it needs the model that was scaled, or the ScaleSet, and only you know where they are",
    ),
    example: Example::Models { good: "check/known_contacts.osim", bad: "check/spheres_misplaced.osim" },
};

/// A sphere is neither where it was nor where it belongs.
pub(crate) fn sphere_misplaced(name: &str, here_mm: &str, belongs_mm: &str) -> Finding {
    let again = Input::MovedSpheres.like("replace");
    let text = phrase![
        format!(
            "{name} was moved: it is at {here_mm} mm, and at {belongs_mm} mm by the factors of its body: "
        ),
        again,
        " places it again"
    ];
    Finding::new(&SPHERES_MISPLACED, text)
}

/// Spheres are where the published layout `title` has them, on a `body` that has the size `here` and not `published`.
pub(crate) fn misplaced_for_layout(title: &str, body: &str, here: [f64; 3], published: [f64; 3]) -> Finding {
    let text = format!(
        "the spheres stand where {title} has them on bones of size {}, and {body} has the size {}",
        size_text(published),
        size_text(here)
    );
    Finding::new(&SPHERES_MISPLACED, text)
}

/// Each foot has the places that the published layout `title` has on the other one.
pub(crate) fn misplaced_on_other_foot(title: &str) -> Finding {
    let text = format!(
        "each foot has the spheres where {title} has them on the other foot: left and right are swapped, or z has the wrong sign"
    );
    Finding::new(&SPHERES_MISPLACED, text)
}

/// Spheres reach further than those of published models; `None` without any.
pub(crate) fn misplaced_by_reach(model: &Model, odd: &[Reach]) -> Option<Finding> {
    let named: Vec<(&Reach, &Sphere)> =
        odd.iter().filter_map(|reach| Some((reach, model.sphere(reach.sphere)?))).collect();
    let (reach, sphere) = named.first()?;
    let more = match named.len() {
        1 => String::new(),
        count => format!(" ({} more)", count - 1),
    };
    let text = format!("{} {}{more}", sphere.name, reach.describe());
    let names = named.iter().map(|(_, sphere)| sphere.name.clone()).collect();
    let finding = Finding::new(&SPHERES_MISPLACED, text).about(&sphere.path);
    Some(finding.on_line(Some(sphere.line)).of_spheres(names))
}

static SPHERES_NOT_COMPARED: Rule = Rule {
    code: FindingCode::SpheresNotCompared,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sizes),
    what: "Whether spheres followed a scaling of their bodies cannot be seen in this file.",
    why: "The bones were scaled; OpenSim leaves contact spheres where they were, and this file alone does not show whether somebody moved them afterwards.",
    advice: "Compare with the model that was scaled: `check MODEL from=GENERIC`",
    repair: Repair::NotPossible("only you know which model was scaled"),
    example: Example::Models { good: "check/within_limits.osim", bad: "check/spheres_not_compared.osim" },
};

/// Bones were scaled, and this file alone shows nothing else.
pub(crate) fn scaled_bones_not_compared() -> Finding {
    let generic = Verb::Check.of_model().with(Input::From, "GENERIC");
    let text = phrase![
        "the bones were scaled; whether the spheres followed cannot be seen here: ",
        generic,
        " compares with the model that was scaled"
    ];
    Finding::new(&SPHERES_NOT_COMPARED, text)
}

/// The two models cannot be compared.
pub(crate) fn models_not_compared(why: &Phrase) -> Finding {
    Finding::new(
        &SPHERES_NOT_COMPARED,
        phrase!["the spheres cannot be compared with those of the model that was scaled: ", why],
    )
}

/// A sphere has none that it could be compared with: `why`.
pub(crate) fn sphere_not_compared(why: Phrase) -> Finding {
    Finding::new(&SPHERES_NOT_COMPARED, why)
}
