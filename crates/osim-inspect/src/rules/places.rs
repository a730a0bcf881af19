//! Rules about the places of spheres, compared with the model before scaling if the caller gives it, else by this file alone.

use std::collections::BTreeMap;

use osim_model::compare::{PlacedSphere, SpherePlacements, is_stretched};
use osim_model::messages::{Input, Verb, counted, listed, phrase, readable, shown, three_significant};
use osim_model::{
    Example, Finding, FindingCode, Model, Note, Repair, ScaledSinceNote, Severity, Side, Sphere, has_word,
};
use osim_requests::options::{FollowOptions, MovedChoice, ScalingOptions};
use osim_requests::{Kilograms, Request, RescaleRequest, TransferRequest};

use crate::body_bones::BodyBones;
use crate::findings::{FindingWithRemedy, Remedies, rounded_mass};
use crate::inspection::Inspection;
use crate::place_evidence::PlaceEvidence;
use crate::published_layouts::LayoutMatch;
use crate::reach::Reach;
use crate::rules::skeleton::{FOOT_WORDS, series_of};
use crate::rules::spheres::{finding_about_spheres, other_cases_in_words};
use crate::sides::BothSides;
use osim_model::rule;

/// The evidence about the places of a model's spheres.
pub(crate) struct SpherePlaces<'i> {
    /// The comparison with the model before scaling, if the caller gave one.
    compared: Option<&'i SpherePlacements>,
    /// The evidence in this file alone, if the places cannot be compared with those of another model.
    alone: Option<PlaceEvidence>,
}

/// The scaling of bodies since the note was written, if it decides whether the spheres are at the right places: bodies were scaled since,
/// or the spheres were placed with their bodies when the note was written.
fn noted_sizes(model: &Model) -> Option<ScaledSinceNote> {
    let since = model.scaled_since_note()?;
    let placed = model.note.as_ref().is_some_and(Note::has_placed_spheres);
    (since.spheres_left_behind || placed).then_some(since)
}

/// The finding that spheres are at wrong places, by this file alone, for a change that does not move the spheres.
pub fn find_misplaced_spheres(model: &Model) -> Option<Finding> {
    let evidence = PlaceEvidence::of(model, noted_sizes(model));
    evidence.is_wrong().then(|| find_misplaced_by_file_alone(&evidence, model)).flatten()
}

impl<'i> SpherePlaces<'i> {
    /// The comparison with the model before scaling, if the caller gave one; else, the evidence in this file.
    pub(crate) fn of(model: &Model, inspected: &'i Inspection) -> Self {
        let compared = inspected.placement.as_ref();
        let is_compared = compared.is_some_and(|placement| placement.unknown.is_none());
        let alone = (!is_compared).then(|| PlaceEvidence::of(model, noted_sizes(model)));
        Self { compared, alone }
    }

    /// Whether spheres are known to be at wrong places.
    pub(crate) fn are_wrong(&self) -> bool {
        let are_misplaced = || self.compared.is_some_and(SpherePlacements::is_wrong);
        self.alone.as_ref().map_or_else(are_misplaced, PlaceEvidence::is_wrong)
    }

    /// Whether spheres are known to be at the right places.
    pub(crate) fn are_right(&self) -> bool {
        // The caller who names another model says that the bodies were scaled.
        let are_placed = || self.alone.as_ref().is_some_and(PlaceEvidence::is_right);
        self.compared.map_or_else(are_placed, SpherePlacements::is_right)
    }

    /// The findings about wrong places, with their remedies.
    pub(crate) fn findings(&self, model: &Model, remedies: &Remedies<'_>) -> Vec<FindingWithRemedy> {
        let compared = self.compared.map(find_misplaced_by_comparison).unwrap_or_default().into_iter();
        let original = self.compared.filter(|_| self.alone.is_none());
        let follow = || original.and_then(|placement| follow_by_original(remedies, placement));
        let alone = self.alone.iter().filter_map(|evidence| {
            let is_noted = matches!(evidence, PlaceEvidence::ScaledSinceNote(_));
            let remedy = || is_noted.then(|| follow_by_note(remedies, model)).flatten();
            Some(FindingWithRemedy::new(find_misplaced_by_file_alone(evidence, model)?, remedy()))
        });
        // The finding that the models cannot be compared is enough, if the file alone shows nothing either.
        let is_new = |one: &FindingWithRemedy| one.code() != FindingCode::SpheresNotCompared;
        let alone = alone.filter(|one| self.compared.is_none() || is_new(one));
        compared.map(|finding| FindingWithRemedy::new(finding, follow())).chain(alone).collect()
    }
}

/// A remedy that scales the contacts to the mass of the body, and lets the spheres follow their bodies by the sizes in the note.
fn follow_by_note(remedies: &Remedies<'_>, model: &Model) -> Option<Request> {
    let since = model.scaled_since_note().filter(|_| model.doubt_about_note().is_none())?;
    if !since.has_all_carriers(model) {
        return None;
    }
    // If the bodies do not give the mass, only the user knows it.
    let target_mass_kg = rounded_mass(remedies.body_kg.filter(|_| remedies.masses.mass.is_none())?);
    // Only if no rescaling changed radii since then, the bottoms can be kept level.
    let has_only_note = model.note.as_ref().is_some_and(|note| note.operation() == Verb::Note.name());
    let level = has_only_note && !since.factors.values().any(|factors| is_stretched(*factors));
    Some(
        RescaleRequest {
            models: remedies.models(true)?,
            target_mass: Some(Kilograms::new(target_mass_kg).ok()?),
            follow_bodies: true,
            scaling: ScalingOptions { level, ..ScalingOptions::default() },
            masses: remedies.masses.clone(),
            choice: remedies.choice(),
            set_files: remedies.set_files(),
            ..RescaleRequest::default()
        }
        .into(),
    )
}

/// A remedy that takes the contacts of the model before scaling, and lets the spheres follow their bodies.
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

/// The finding about wrong places from the evidence in this file alone.
fn find_misplaced_by_file_alone(evidence: &PlaceEvidence, model: &Model) -> Option<Finding> {
    match evidence {
        PlaceEvidence::ScaledSinceNote(noted) => Some(left_behind_since_note(noted)),
        PlaceEvidence::OtherSize(LayoutMatch::OtherSize { title, body, growth }) => {
            let text = format!(
                "{} is {} of the bone in {title}, but its spheres are placed as there",
                shown(body),
                percent_text(*growth),
            );
            Some(Finding::new(&SPHERES_MISPLACED, text).with_measure(change_of_size(growth), ""))
        }
        PlaceEvidence::NotOnFeet(bodies) => {
            let text = format!(
                "spheres are on {}, and the feet of the model have none",
                listed(bodies, MOST_BODIES_NAMED)
            );
            let is_there = |sphere: &&Sphere| sphere.body.as_ref().is_some_and(|body| bodies.contains(body));
            finding_about_spheres(&SPHERES_MISPLACED, text, model.spheres().iter().filter(is_there))
        }
        PlaceEvidence::Mirrored(title) => {
            let text = format!(
                "each foot has the spheres where {title} has them on the other foot: left and right are swapped, or z has the wrong sign"
            );
            Some(Finding::new(&SPHERES_MISPLACED, text))
        }
        PlaceEvidence::FarReach(far) => misplaced_by_reach(model, far),
        PlaceEvidence::Unknown => {
            let generic = Verb::Check.call_with_model().with_placeholder(Input::From, "GENERIC");
            let text = phrase![
                "the bones were scaled; whether the spheres followed cannot be seen here: ",
                generic,
                " compares with the model that was scaled"
            ];
            Some(Finding::new(&SPHERES_NOT_COMPARED, text))
        }
        PlaceEvidence::OtherSize(LayoutMatch::AsPublished { .. })
        | PlaceEvidence::Right
        | PlaceEvidence::Unscaled => None,
    }
}

/// The largest number of bodies that a message names.
const MOST_BODIES_NAMED: usize = 4;

/// A finding for all spheres that stayed at their places, and a finding for all that were moved to wrong places; a single finding if the
/// two models cannot be compared.
fn find_misplaced_by_comparison(placement: &SpherePlacements) -> Vec<Finding> {
    if let Some(why) = &placement.unknown {
        let text = phrase!["the spheres cannot be compared with those of the model that was scaled: ", why];
        let finding = Finding::new(&SPHERES_NOT_COMPARED, text);
        if !placement.is_wrong_model {
            return vec![finding];
        }
        let advice =
            phrase!["Name the model that OpenSim scaled, without an error of its own, with ", Input::From];
        return vec![finding.with_severity(Severity::Error).with_advice(advice)];
    }
    // Behind the name of the sphere, one cause has one text.
    let mut unmatched: BTreeMap<String, Vec<Finding>> = BTreeMap::new();
    for why in placement.unmatched.iter().map(ToString::to_string) {
        let cause = why.split_once(' ').map(|(_, cause)| cause.to_owned()).unwrap_or_default();
        unmatched.entry(cause).or_default().push(Finding::new(&SPHERES_NOT_COMPARED, why));
    }
    let unmatched = unmatched.into_values().filter_map(|cases| Finding::join_cases(&cases));
    let misplaced = [true, false].into_iter().filter_map(|stayed| misplaced_spheres(placement, stayed));
    misplaced.chain(unmatched).collect()
}

rule! { pub(super) SPHERES_LEFT_BEHIND: SpheresLeftBehind, Error, Sizes;
    what: "Spheres are where they were before OpenSim scaled their bodies.",
    why: "OpenSim's Scale Tool scales bones, joints and masses. It leaves contact spheres where they were, as large and as stiff as before, so that they hang beyond the foot of a smaller animal and end short of a larger one's.",
    advice: "Compare with the model that was scaled: `check MODEL from=ORIGINAL` gives the command that moves the spheres with their bodies and makes the contacts right for this mass, too",
    repair: Repair::Command("lets the spheres follow their bodies, where the note has their sizes or the original is named"),
    example: Example::Models { good: "drawn_feet/six_spheres.osim", bad: "drawn_feet/left_behind.osim" },
}

/// The finding that bodies were scaled after the note was written, and the spheres stayed at their places.
fn left_behind_since_note(noted: &ScaledSinceNote) -> Finding {
    let bodies: Vec<String> =
        noted.factors.iter().map(|(body, factors)| format!("{body} x{}", size_text(*factors))).collect();
    let text = format!(
        "bodies were scaled after the note was written, and the spheres stayed: {}",
        bodies.join(", ")
    );
    let size = noted.factors.values().map(change_of_size).fold(0.0, f64::max);
    Finding::new(&SPHERES_LEFT_BEHIND, text).with_measure(size, "")
}

/// How much a body grew or shrank along the axis where it did most: the logarithm of its factor.
fn change_of_size(factors: &[f64; 3]) -> f64 {
    factors.iter().map(|factor| factor.ln().abs()).fold(0.0, f64::max)
}

/// Factors along x, y and z in words; one number if they are equal.
fn size_text([x, y, z]: [f64; 3]) -> String {
    if x == y && y == z { readable(x) } else { [x, y, z].map(readable).join(",") }
}

/// Factors along x, y and z in percent; one number if they are equal.
fn percent_text([x, y, z]: [f64; 3]) -> String {
    let percent = |factor: f64| format!("{} %", three_significant(100.0 * factor));
    if x == y && y == z { percent(x) } else { [x, y, z].map(percent).join(" x ") }
}

rule! { pub(super) SPHERES_MISPLACED: SpheresMisplaced, Warning, Sizes;
    what: "Spheres do not fit their bones: no published model has them there, or only one of another size, or only on the other foot.",
    why: "OpenSim scaled the bones and left the spheres behind, the spheres were taken from a model of another size, or left and right were swapped. Then they push where the foot is not.",
    advice: "Compare with the model that was scaled: `check MODEL from=ORIGINAL` says where each belongs, and gives the command that puts them there, if there is one",
    repair: Repair::Command("places spheres again that are more than a radius off, where the model that was scaled is named"),
    example: Example::Models { good: "check/known_contacts.osim", bad: "check/spheres_misplaced.osim" },
}

/// The finding about all spheres that stayed at their places when OpenSim scaled the model (`stayed`), or about all that were moved to a
/// third place.
fn misplaced_spheres(placement: &SpherePlacements, stayed: bool) -> Option<Finding> {
    let all: Vec<&PlacedSphere> =
        placement.spheres.iter().filter(|sphere| !sphere.follows && sphere.stayed == stayed).collect();
    let worst = all.iter().copied().reduce(|a, b| if b.distance_m() > a.distance_m() { b } else { a })?;
    let (count, total) = (all.len(), counted(placement.spheres.len(), "sphere"));
    let distance = format!("{} mm", three_significant(1e3 * worst.distance_m()));
    let most = format!("up to {distance}, {}", worst.name);
    let details = all.iter().map(|sphere| {
        let (here, belongs) = (millimetres(sphere.here_m), millimetres(sphere.belongs_m));
        format!("{} is at {here} mm and belongs at {belongs} mm", sphere.name)
    });
    let details = details.collect();
    let finding = if stayed {
        Finding::new(&SPHERES_LEFT_BEHIND, format!("{count} of {total} did not follow the bones ({most})"))
    } else {
        let text = phrase![
            "{count} of {total} were moved, but not to where the bones have taken them ({most}): {} places them again";
            Input::MovedSpheres.with_placeholder("replace")
        ];
        Finding::new(&SPHERES_MISPLACED, text)
    };
    let finding = finding.with_place(&worst.path).with_position(Some(worst.position)).with_details(details);
    let finding = finding.with_measure(worst.distance_m(), distance).with_advice(
        "Bring each sphere to the place that is named here; the proposed command, if there is one, does it",
    );
    Some(finding.with_spheres(all.into_iter().map(|sphere| sphere.name.clone()).collect()))
}

/// A place in millimetres, as text.
fn millimetres(place: [f64; 3]) -> String {
    let axes = place.map(|metres| {
        let text = format!("{:.2}", metres * 1e3);
        // Write zero without a minus.
        if text == "-0.00" { "0.00".to_owned() } else { text }
    });
    axes.join(" ")
}

/// The finding that the spheres in `far` reach further than spheres of published models.
fn misplaced_by_reach(model: &Model, far: &[Reach]) -> Option<Finding> {
    let spheres: Vec<(&Reach, &Sphere)> =
        far.iter().filter_map(|reach| Some((reach, model.sphere(reach.sphere)?))).collect();
    let (reach, sphere) = spheres.first()?;
    let more = if spheres.len() > 1 { format!(" ({} more)", spheres.len() - 1) } else { String::new() };
    let text = format!("{} {}{more}", sphere.name, reach.describe());
    let size = spheres.iter().map(|(reach, _)| reach.excess()).fold(0.0, f64::max);
    let finding = finding_about_spheres(&SPHERES_MISPLACED, text, spheres.iter().map(|(_, sphere)| *sphere));
    Some(finding?.with_measure(size, ""))
}

/// A sphere that is ahead of the ankle by more than this part of the limb's longest bone does not serve as a heel. The heel of D'Hondt et
/// al. is 0.027 ahead.
const LEAST_AHEAD_OF_ANKLE: f64 = 0.04;

/// The remark that all spheres of a calcaneus are ahead of the ankle. It is about the foot whose rearmost sphere is farthest ahead.
pub(super) fn find_no_heel(sides: &BothSides<'_>) -> Option<Finding> {
    let bones = BodyBones::of(sides.model)?;
    let mut rearmost: BTreeMap<&str, (f64, &Sphere)> = BTreeMap::new();
    for (sphere, body, place_m) in sides.spheres() {
        let Some(ahead_m) = bones.ahead_of_ankle_m(body, place_m) else { continue };
        let least = rearmost.entry(body).or_insert((ahead_m, sphere));
        if ahead_m < least.0 {
            *least = (ahead_m, sphere);
        }
    }
    rearmost.retain(|body, (ahead_m, _)| {
        sides.longest_bone_of_limb_m(body).is_some_and(|bone_m| *ahead_m > LEAST_AHEAD_OF_ANKLE * bone_m)
    });
    let without_heel = rearmost.into_values();
    let (ahead_m, sphere) = without_heel.reduce(|a, b| if b.0 > a.0 { b } else { a })?;
    let text = format!(
        "the heel has no sphere: the rearmost, {}, is {} mm ahead of the ankle",
        shown(&sphere.name),
        three_significant(1e3 * ahead_m)
    );
    let finding = finding_about_spheres(&SPHERES_MISPLACED, text, std::iter::once(sphere))?;
    let advice = "Nothing, if this is intended; else look at the places of the heel's spheres";
    Some(finding.with_severity(Severity::Remark).with_advice(advice))
}

/// A sphere that is named after the toes and is ahead of the ankle by less than this part of the limb's longest bone has the place that it
/// has on the toes. The spheres of published models are at least 0.2 ahead.
const TOES_AHEAD_OF_ANKLE: f64 = 0.15;

/// The finding that spheres of the toes are on a calcaneus, near the ankle.
pub(super) fn find_toes_at_ankle(sides: &BothSides<'_>) -> Option<Finding> {
    let bones = BodyBones::of(sides.model)?;
    let mut near = Vec::new();
    for (sphere, body, place_m) in sides.spheres() {
        let has = |word: &str| has_word(&sphere.name, word);
        let is_toe = !has("heel") && ["toe", "hallux", "phal"].into_iter().any(has);
        let ahead_m = bones.ahead_of_ankle_m(body, place_m).filter(|_| is_toe);
        let Some((ahead_m, bone_m)) = ahead_m.zip(sides.longest_bone_of_limb_m(body)) else { continue };
        if ahead_m < TOES_AHEAD_OF_ANKLE * bone_m {
            near.push((ahead_m, sphere));
        }
    }
    let (ahead_m, first) = near.first()?;
    let text = format!(
        "{} is named after the toes and is {} mm ahead of the ankle, on {}",
        shown(&first.name),
        three_significant(1e3 * ahead_m),
        shown(first.body.as_deref().unwrap_or_default())
    );
    finding_about_spheres(&SPHERES_MISPLACED, text, near.iter().map(|(_, sphere)| *sphere))
}

/// The finding that spheres with a side and a name as those of feet are on the trunk, while others are on the feet. Spheres of a seat can be
/// in one series with those of the feet: they are lower in their body.
pub(super) fn find_foot_spheres_on_trunk(sides: &BothSides<'_>) -> Option<Finding> {
    let bones = BodyBones::of(sides.model)?;
    let on_trunk = sides.spheres().filter(|(sphere, body, _)| {
        let has_sides = [*body, &sphere.name].map(|name| Side::of_name(name).is_some());
        let is_trunk = || has_word(body, "torso") || bones.has_foot_below(body);
        has_sides == [false, true] && is_trunk() && !bones.is_foot(body)
    });
    let mut astray: Vec<_> = on_trunk.collect();
    if astray.is_empty() {
        return None;
    }
    let on_feet = sides.spheres().filter(|(_, body, _)| bones.is_foot(body));
    let of_feet = on_feet.map(|(sphere, _, place_m)| (series_of(&sphere.name), place_m.y));
    let of_feet: Vec<_> = of_feet.collect();
    astray.retain(|(sphere, _, place_m)| {
        let (series, radius_m) = (series_of(&sphere.name), sphere.radius_m().unwrap_or_default());
        FOOT_WORDS.iter().any(|word| has_word(&sphere.name, word))
            || of_feet.iter().any(|(other, y_m)| *other == series && (place_m.y - y_m).abs() < radius_m)
    });
    let (first, body, _) = astray.first().filter(|_| !of_feet.is_empty())?;
    let more = other_cases_in_words(astray.len(), "another sphere, too", "other spheres, too");
    let text = format!("{} belongs to a foot, and is on {}{more}", shown(&first.name), shown(body));
    finding_about_spheres(&SPHERES_MISPLACED, text, astray.iter().map(|(sphere, ..)| *sphere))
}

rule! { pub(super) SPHERES_NOT_COMPARED: SpheresNotCompared, Remark, Sizes;
    what: "Whether spheres followed a scaling of their bodies cannot be seen in this file.",
    why: "The bones were scaled; OpenSim leaves contact spheres where they were, and this file alone does not show whether somebody moved them afterwards.",
    advice: "Compare with the model that was scaled: `check MODEL from=GENERIC`",
    repair: Repair::NotPossible("only you know which model was scaled"),
    example: Example::Models { good: "check/within_limits.osim", bad: "check/spheres_not_compared.osim" },
}
