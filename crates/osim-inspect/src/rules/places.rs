//! Findings about the places of spheres: from the model that was scaled if it was given, else from this file alone.

use osim_model::compare::{PlacedSphere, SpherePlacements, is_stretched};
use osim_model::messages::{Input, Verb, phrase, readable};
use osim_model::{
    Example, Finding, FindingCode, Model, Note, Repair, Rule, ScaledSinceNote, Severity, Sphere, VerdictOn,
};
use osim_requests::options::{FollowOptions, MovedChoice, ScalingOptions};
use osim_requests::{Kilograms, Request, RescaleRequest, TransferRequest};

use crate::evidence::{Evidence, LayoutAnswer};
use crate::findings::{Found, Remedies, rounded};
use crate::inspection::Inspection;
use crate::reach::Reach;
use crate::rules::spheres::about_spheres;

/// What is known of the places of spheres.
pub(crate) enum Places<'i> {
    Compared(&'i SpherePlacements),
    Alone(Evidence),
    /// They cannot be compared: what this file alone shows.
    NotCompared(&'i SpherePlacements, Evidence),
}

/// What the note in the file says about sizes, where that settles it: bodies were scaled since, or the spheres were placed with
/// their bodies when it was written.
fn noted_sizes(model: &Model) -> Option<ScaledSinceNote> {
    let since = model.scaled_since_note()?;
    let placed = model.note.as_ref().is_some_and(Note::has_placed_spheres);
    (since.is_scaled() || placed).then_some(since)
}

/// What one file alone shows of spheres that are where they should not be: for changes that leave them there.
pub fn misplaced_spheres(model: &Model) -> Option<Finding> {
    let evidence = Evidence::of(model, noted_sizes(model));
    evidence.is_wrong().then(|| find_in_file(&evidence, model)).flatten()
}

impl<'i> Places<'i> {
    pub(crate) fn of(model: &Model, inspected: &'i Inspection) -> Self {
        match &inspected.placement {
            Some(placement) if placement.unknown.is_none() => Self::Compared(placement),
            Some(placement) => Self::NotCompared(placement, Evidence::of(model, noted_sizes(model))),
            None => Self::Alone(Evidence::of(model, noted_sizes(model))),
        }
    }

    /// Spheres are where they should not be.
    pub(crate) fn are_wrong(&self) -> bool {
        match self {
            Self::Compared(placement) => placement.is_wrong(),
            Self::Alone(evidence) | Self::NotCompared(_, evidence) => evidence.is_wrong(),
        }
    }

    /// They are certain to be where they were before their bodies were scaled.
    pub(crate) fn were_left_behind(&self) -> bool {
        match self {
            Self::Compared(placement) => placement.was_left_behind(),
            Self::Alone(evidence) | Self::NotCompared(_, evidence) => {
                matches!(evidence, Evidence::Note(_) | Evidence::OtherSize(_))
            }
        }
    }

    /// They are known to be where they belong.
    pub(crate) fn are_right(&self) -> bool {
        match self {
            Self::Compared(placement) => placement.is_right(),
            Self::Alone(evidence) | Self::NotCompared(_, evidence) => evidence.is_right(),
        }
    }

    pub(crate) fn findings(&self, model: &Model, remedies: &Remedies<'_>) -> Vec<Found> {
        match self {
            Self::Alone(evidence) => {
                let is_noted = matches!(evidence, Evidence::Note(_));
                let remedy = || is_noted.then(|| follow_by_note(remedies, model)).flatten();
                find_in_file(evidence, model)
                    .into_iter()
                    .map(|finding| Found::new(finding, remedy()))
                    .collect()
            }
            Self::NotCompared(placement, evidence) => {
                let alone = Self::Alone(evidence.clone()).findings(model, remedies);
                // If the file shows nothing, one finding says that it cannot be compared.
                let shown = alone.into_iter().filter(|one| one.code() != FindingCode::SpheresNotCompared);
                find_compared(placement).into_iter().map(Found::from).chain(shown).collect()
            }
            Self::Compared(placement) => {
                let found = find_compared(placement).into_iter();
                found.map(|finding| Found::new(finding, follow_by_original(remedies, placement))).collect()
            }
        }
    }
}

/// The model's own contacts at the mass of its body, on spheres that follow it by the sizes in the note.
fn follow_by_note(remedies: &Remedies<'_>, model: &Model) -> Option<Request> {
    let since = model.scaled_since_note().filter(|_| model.doubt_about_note().is_none())?;
    if !since.has_all_carriers(model) {
        return None;
    }
    // What the model weighs otherwise is for the user to say.
    let target_mass_kg = rounded(remedies.body_kg.filter(|_| remedies.load.masses.mass.is_none())?);
    // A rescaling since then may have changed radii, and bottoms with them.
    let untouched = model.note.as_ref().is_some_and(|note| note.operation() == Verb::Note.name());
    let level = untouched && !since.factors.values().any(|factors| is_stretched(*factors));
    Some(
        RescaleRequest {
            models: remedies.models(true)?,
            target_mass: Some(Kilograms::new(target_mass_kg).ok()?),
            follow_bodies: true,
            scaling: ScalingOptions { level, ..ScalingOptions::default() },
            masses: remedies.load.masses.clone(),
            choice: remedies.choice(),
            set_files: remedies.set_files(),
            ..RescaleRequest::default()
        }
        .into(),
    )
}

/// Contacts of the model that OpenSim scaled, on spheres that follow their bodies.
fn follow_by_original(remedies: &Remedies<'_>, placement: &SpherePlacements) -> Option<Request> {
    if !placement.can_follow() {
        return None;
    }
    let follow = FollowOptions {
        follow_bodies: true,
        body_scale_file: placement.body_scale_file.clone(),
        moved_spheres: placement.has_changed_spheres().then_some(MovedChoice::Replace),
        ..FollowOptions::default()
    };
    let scaling = ScalingOptions { level: placement.suits_level, ..ScalingOptions::default() };
    Some(TransferRequest { follow, scaling, ..remedies.transfer(placement.from.clone())? }.into())
}

// What this file alone shows, or the model that was scaled.

/// The finding that this file alone is.
fn find_in_file(evidence: &Evidence, model: &Model) -> Option<Finding> {
    match evidence {
        Evidence::Note(noted) => Some(left_behind_since_note(noted)),
        Evidence::OtherSize(LayoutAnswer::OtherSize { title, body, here, published }) => {
            let text = format!(
                "the spheres stand where {title} has them on bones of size {}, and {body} has the size {}",
                size_text(*published),
                size_text(*here)
            );
            Some(Finding::new(&SPHERES_MISPLACED, text))
        }
        Evidence::Mirrored(title) => {
            let text = format!(
                "each foot has the spheres where {title} has them on the other foot: left and right are swapped, or z has the wrong sign"
            );
            Some(Finding::new(&SPHERES_MISPLACED, text))
        }
        Evidence::Reach(odd) => misplaced_by_reach(model, odd),
        Evidence::Unknown => {
            let generic = Verb::Check.call_with_model().with_placeholder(Input::From, "GENERIC");
            let text = phrase![
                "the bones were scaled; whether the spheres followed cannot be seen here: ",
                generic,
                " compares with the model that was scaled"
            ];
            Some(Finding::new(&SPHERES_NOT_COMPARED, text))
        }
        Evidence::OtherSize(LayoutAnswer::AsPublished) | Evidence::Right | Evidence::Unscaled => None,
    }
}

/// One finding for each sphere that is not where it belongs; one alone where the two models cannot be compared.
fn find_compared(placement: &SpherePlacements) -> Vec<Finding> {
    if let Some(why) = &placement.unknown {
        let text = phrase!["the spheres cannot be compared with those of the model that was scaled: ", why];
        return vec![Finding::new(&SPHERES_NOT_COMPARED, text)];
    }
    let unmatched = placement.unmatched.iter().cloned().map(|why| Finding::new(&SPHERES_NOT_COMPARED, why));
    let placed = placement.spheres.iter().filter(|sphere| !sphere.follows).map(misplaced_sphere);
    placed.chain(unmatched).collect()
}

pub(super) static SPHERES_LEFT_BEHIND: Rule = Rule {
    code: FindingCode::SpheresLeftBehind,
    severity: Severity::Error,
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
fn left_behind_since_note(noted: &ScaledSinceNote) -> Finding {
    let bodies: Vec<String> =
        noted.factors.iter().map(|(body, factors)| format!("{body} x{}", size_text(*factors))).collect();
    let text = format!(
        "bodies were scaled after the note was written, and the spheres stayed: {}",
        bodies.join(", ")
    );
    Finding::new(&SPHERES_LEFT_BEHIND, text)
}

/// One number for equal factors.
fn size_text([x, y, z]: [f64; 3]) -> String {
    if x == y && y == z { readable(x) } else { [x, y, z].map(readable).join(",") }
}

pub(super) static SPHERES_MISPLACED: Rule = Rule {
    code: FindingCode::SpheresMisplaced,
    severity: Severity::Warning,
    verdict: Some(VerdictOn::Sizes),
    what: "Spheres do not fit their bones, as in no published model, as in one of another size, or as on the other foot.",
    why: "OpenSim scaled the bones and left the spheres behind, the spheres were taken from a model of another size, or left and right were swapped. Then they push where the foot is not.",
    advice: "See where each belongs with `check MODEL from=ORIGINAL`, where ORIGINAL is the model that was scaled: it gives the command that puts them there, if there is one",
    repair: Repair::NotPossible(
        "it needs the model that was scaled, or the ScaleSet, and only you know where they are",
    ),
    example: Example::Models { good: "check/known_contacts.osim", bad: "check/spheres_misplaced.osim" },
};

/// A sphere is where it was in the model that was scaled, or neither there nor where it belongs.
fn misplaced_sphere(sphere: &PlacedSphere) -> Finding {
    let PlacedSphere { name, path, line, .. } = sphere;
    let (here, belongs) = (millimetres(sphere.here_m), millimetres(sphere.belongs_m));
    let finding = if sphere.stayed() {
        Finding::new(&SPHERES_LEFT_BEHIND, format!("{name} stayed at {here} mm and belongs at {belongs} mm"))
    } else {
        let text = phrase![
            format!("{name} was moved: it is at {here} mm, and at {belongs} mm by the factors of its body: "),
            Input::MovedSpheres.with_placeholder("replace"),
            " places it again"
        ];
        Finding::new(&SPHERES_MISPLACED, text)
    };
    finding.with_place(path).with_line(Some(*line)).with_spheres(vec![name.clone()])
}

fn millimetres(place: [f64; 3]) -> String {
    let axes = place.map(|metres| {
        let text = format!("{:.2}", metres * 1e3);
        // No sign before a zero.
        if text == "-0.00" { "0.00".to_owned() } else { text }
    });
    axes.join(" ")
}

/// Spheres reach further than those of published models; `None` without any.
fn misplaced_by_reach(model: &Model, odd: &[Reach]) -> Option<Finding> {
    let named: Vec<(&Reach, &Sphere)> =
        odd.iter().filter_map(|reach| Some((reach, model.sphere(reach.sphere)?))).collect();
    let (reach, sphere) = named.first()?;
    let more = match named.len() {
        1 => String::new(),
        count => format!(" ({} more)", count - 1),
    };
    let text = format!("{} {}{more}", sphere.name, reach.describe());
    about_spheres(&SPHERES_MISPLACED, text, named.iter().map(|(_, sphere)| *sphere))
}

pub(super) static SPHERES_NOT_COMPARED: Rule = Rule {
    code: FindingCode::SpheresNotCompared,
    severity: Severity::Remark,
    verdict: Some(VerdictOn::Sizes),
    what: "Whether spheres followed a scaling of their bodies cannot be seen in this file.",
    why: "The bones were scaled; OpenSim leaves contact spheres where they were, and this file alone does not show whether somebody moved them afterwards.",
    advice: "Compare with the model that was scaled: `check MODEL from=GENERIC`",
    repair: Repair::NotPossible("only you know which model was scaled"),
    example: Example::Models { good: "check/within_limits.osim", bad: "check/spheres_not_compared.osim" },
};
