//! Rules about which contacts a model has, for which mass they were made, and who published them.

use osim_model::messages::{Input, Phrase, counted, four_significant, phrase, three_significant};
use osim_model::opensim_text::trimmed;
use osim_model::{
    Example, Fault, FaultKind, Finding, MassRequest, MassSource, Model, Pattern, Repair, Selection, Severity,
    Sphere, are_equal_masses,
};
use osim_requests::options::{MassOptions, ScalingOptions};
use osim_requests::{Kilograms, Request, RescaleRequest};

use crate::findings::{FindingWithRemedy, Remedies, rounded_mass};
use crate::rules::spheres::finding_about_spheres;
use crate::{Inspection, KnownContacts};
use osim_model::rule;

rule! { pub(crate) BARE_MODEL: BareModel, Remark;
    what: "The model has no contacts.",
    why: "Nothing carries the model: it has no HuntCrossleyForce or SmoothSphereHalfSpaceForce whose moving spheres meet a half-space.",
    advice: "`add` gives it contacts: those of another model, spheres under its own bones, or places from a table",
    repair: Repair::NotPossible("only you know which contacts it should have"),
    example: Example::Models { good: "format/v40000.osim", bad: "bad/no_contacts.osim" },
}

/// Finds a model that has no contacts which can be chosen.
pub(crate) fn find_bare_model(fault: &Fault, model: &Model) -> Option<Finding> {
    // Contacts of another class have a finding of their own.
    let is_bare = matches!(fault.kind, FaultKind::NoContacts { replaces: false, .. });
    is_bare.then(|| {
        let tree = model.document().tree();
        let wrapped = tree.elements().filter(|&id| tree.name(id) == "socket_contact_geometry");
        let wrapped: Vec<_> = wrapped.map(|id| tree.text_of(id)).collect();
        let is_left = |one: &&Sphere| {
            // A path of a muscle can wrap around a sphere.
            let is_wrapped =
                wrapped.iter().any(|path| trimmed(path).rsplit('/').next() == Some(one.name.as_str()));
            one.body.is_some() && model.forces().iter().all(|force| force.sets.is_empty()) && !is_wrapped
        };
        let moving = model.spheres().iter().filter(is_left);
        let text = format!(
            "no force presses with {}: the model has no contacts",
            counted(moving.clone().count(), "sphere")
        );
        // Whoever left spheres did not mean a model without contacts.
        let left = finding_about_spheres(&BARE_MODEL, text, moving);
        left.map_or_else(
            || Finding::new(&BARE_MODEL, fault.phrase()),
            |one| one.with_severity(Severity::Warning),
        )
    })
}

rule! { pub(crate) UNMATCHED_PATTERN: UnmatchedPattern, Remark;
    what: "A choice of forces or bodies matches no name in the model.",
    why: "So it chooses nothing and leaves nothing out. Usually the name has a typing error, or belongs to another model.",
    advice: "Correct the name",
    repair: Repair::NotPossible("only you know which name is right"),
    example: Example::Request {
        good: r#"{"verb": "inspect", "models": ["table1/human_62kg_smooth_sphere.osim"], "exclude": ["contact_s1_*"]}"#,
        bad: r#"{"verb": "inspect", "models": ["table1/human_62kg_smooth_sphere.osim"], "exclude": ["contact_sl_*"]}"# },
}

/// A message for each pattern of `selection` and of `masses` that fits no name in `model`.
pub fn describe_unmatched_patterns(
    selection: &Selection,
    masses: &MassRequest,
    model: &Model,
) -> Vec<Phrase> {
    let message = |input: Input, pattern: &Pattern, what: &str| {
        phrase![input.with_value(pattern.to_string()), format!(": no {what} of the model has such a name")]
    };
    let forces = selection.unmatched_patterns(model).into_iter();
    let forces = forces.map(|(input, pattern)| message(input, pattern, "contact force"));
    let bodies = masses.unmatched_patterns(model).map(|pattern| message(Input::ExcludeBody, pattern, "body"));
    forces.chain(bodies).collect()
}

/// Finds patterns of forces and bodies that fit no name.
pub(crate) fn find_unmatched_patterns(
    selection: &Selection,
    masses: &MassRequest,
    model: &Model,
) -> Vec<Finding> {
    let messages = describe_unmatched_patterns(selection, masses, model).into_iter();
    messages.map(|message| Finding::new(&UNMATCHED_PATTERN, message)).collect()
}

rule! { pub(crate) MASS_UNKNOWN: MassUnknown, Warning, Mass;
    what: "The mass of the model, or the mass that its contacts are made for, is not known.",
    why: "Every factor follows from these masses.",
    advice: "Give `mass=KG` or `contacts_mass=KG`, or correct the masses of the bodies",
    repair: Repair::NotPossible("only you know the mass of the model"),
    example: Example::ElementText { tag: "mass", good: "61.5", bad: "0" },
}

rule! { pub(crate) STALE_NOTE: StaleNote, Remark, Mass;
    what: "The note that this program left in the file no longer fits its contacts.",
    why: "The note says which mass the contacts were made for. Contacts were changed after it was written, or only some of them were scaled, or the note is damaged.",
    advice: "Give the mass that the contacts are made for with `contacts_mass=KG`",
    repair: Repair::NotPossible("only you know for which mass the contacts were made"),
    example: Example::Models { good: "check/noted.osim", bad: "check/stale_note.osim" },
}

/// The finding that a mass is not known, perhaps because the note is out of date. `fault` says why.
pub(crate) fn mass_unknown(fault: &Fault) -> Finding {
    let is_stale = fault.code() == STALE_NOTE.code.as_str();
    Finding::new(if is_stale { &STALE_NOTE } else { &MASS_UNKNOWN }, fault.phrase())
}

rule! { pub(crate) COUNT_UNKNOWN: CountUnknown, Remark, Mass;
    what: "How many spheres share the weight is not known.",
    why: "Limbs are found by left and right sides below the joint tree. Where that does not work, values under body weight are absent, and indentations are not judged.",
    advice: "Give it with `spheres=N`; where spheres are on separate bodies, such as a player and a ball, choose those of one with `select=GLOB`",
    repair: Repair::NotPossible("only you know how many spheres share the weight"),
    example: Example::Models { good: "check/within_limits.osim", bad: "format/no_sides.osim" },
}

/// Finds a model whose number of spheres per limb is not known. The number is also unknown if a model of several animals has forces of
/// several animals, and the caller chose no forces.
pub(crate) fn find_count_unknown(inspected: &Inspection) -> Option<Finding> {
    let limbs = &inspected.figures.limbs;
    let is_counted = !limbs.is_empty() && limbs.iter().all(|limb| limb.sphere_count.is_some());
    let why = inspected.limbs_unknown.clone().filter(|_| inspected.limbs.is_none() && !is_counted)?;
    Some(Finding::new(&COUNT_UNKNOWN, why))
}

rule! { pub(crate) KNOWN_CONTACTS: KnownContacts, Remark;
    what: "The contacts are published ones, and are used as they were published.",
    why: "What is unusual about the published contacts is a remark here. A warning says what is wrong for this model.",
    advice: "Nothing, if you chose these contacts",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Models { good: "check/within_limits.osim", bad: "check/known_contacts.osim" },
}

/// The remark that the contacts are published ones, and for which mass.
pub(crate) fn known_contacts(known: KnownContacts) -> Finding {
    let text = format!(
        "the contact parameters are those of {} for a body of {} kg",
        known.title,
        four_significant(known.made_for_kg)
    );
    Finding::new(&KNOWN_CONTACTS, text)
}

rule! { pub(crate) CONTACTS_OF_ANOTHER_MASS: ContactsOfAnotherMass, Warning, Mass;
    what: "The contacts are published ones, made for a body of another mass.",
    why: "Radius, stiffness, dissipation and number of spheres are those of a published model, but the body weighs something else: contacts that are not scaled sink in more or less than they did there.",
    advice: "If OpenSim scaled this model, `check MODEL from=GENERIC` compares it with the one that was scaled. If its spheres are where they belong, scale the contacts from the mass they were made for to the mass of this body",
    repair: Repair::Command("scales the contacts from the mass they were made for to that of this body, where the places of the spheres are known to be right"),
    example: Example::Piece { model: "check/known_contacts.osim", good: "<mass>60</mass>",
        bad: "<mass>88</mass>" },
}

/// A body is this many times as dense as the published one, or as light, at most: more is another unit, or a mass that was mistyped.
const LARGEST_DENSITY_RATIO: f64 = 2.5;

/// Finds published contacts under a body of another mass, unless the note or the caller gives the mass of the contacts. The remedy scales
/// the contacts, if the places of the spheres are right and the mass fits the bones: `bone_volume` is their volume over the published one.
pub(crate) fn find_contacts_of_another_mass(
    inspected: &Inspection,
    remedies: &Remedies<'_>,
    places_are_right: bool,
    bone_volume: Option<f64>,
) -> Option<FindingWithRemedy> {
    let mass = inspected.mass_kg?;
    let known = inspected.known_contacts?;
    let made_for = known.made_for_kg;
    let is_as_published =
        inspected.contacts_mass_kg.as_ref().is_some_and(|mass| matches!(mass.from, MassSource::Known(_)));
    if !is_as_published || are_equal_masses(mass, made_for) {
        return None;
    }
    let text = format!(
        "the contacts are for {} kg ({}), the body weighs {} kg",
        four_significant(made_for),
        known.title.replace(['(', ')'], ""),
        four_significant(mass)
    );
    let bottoms = inspected.standing.iter().flat_map(|body| &body.bottoms);
    let largest_m = bottoms.map(|bottom| bottom.radius_m).fold(0.0, f64::max);
    let level = largest_m * ((mass / made_for).cbrt() - 1.0).abs() > LARGE_MOVE_OF_SOLES_M;
    let of_bones_kg = bone_volume.map_or(mass, |volume| made_for * volume);
    let fits_bones = (mass / of_bones_kg).ln().abs() <= LARGEST_DENSITY_RATIO.ln();
    let remedy =
        (places_are_right && fits_bones).then(|| scale_to_body(remedies, [made_for, mass], level)).flatten();
    let measure = format!("{} for {} kg", four_significant(made_for), four_significant(mass));
    let mut finding =
        Finding::new(&CONTACTS_OF_ANOTHER_MASS, text).with_measure((mass / made_for).ln().abs(), measure);
    if !fits_bones {
        finding.advice = format!(
            "Correct the masses of the bodies: the bones are those of a body of about {} kg",
            three_significant(of_bones_kg)
        )
        .into();
    } else if inspected.placement.is_some() {
        // The caller named the model that was scaled.
        finding.advice =
            "Scale the contacts from the mass they were made for to the mass of this body".into();
    }
    Some(FindingWithRemedy::new(finding, remedy))
}

/// A rescaling whose radii move bottoms by more than this, m, keeps them where they are.
const LARGE_MOVE_OF_SOLES_M: f64 = 0.005;

/// A remedy that rescales the contacts from one mass to another, and with `level` keeps bottoms where they are.
fn scale_to_body(remedies: &Remedies<'_>, masses_kg: [f64; 2], level: bool) -> Option<Request> {
    let [contacts_mass, target_mass] = masses_kg.map(|kg| Kilograms::new(rounded_mass(kg)).ok());
    Some(
        RescaleRequest {
            models: remedies.models(true)?,
            target_mass: Some(target_mass?),
            masses: MassOptions { contacts_mass: Some(contacts_mass?), ..MassOptions::default() },
            scaling: ScalingOptions { level, ..ScalingOptions::default() },
            choice: remedies.choice(),
            set_files: remedies.set_files(),
            ..RescaleRequest::default()
        }
        .into(),
    )
}
