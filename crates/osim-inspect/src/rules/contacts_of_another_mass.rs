//! The contacts are published ones, made for a body of another mass.

use osim_model::messages::{four_significant, readable};
use osim_model::same_mass;
use osim_model::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use osim_requests::options::MassOptions;
use osim_requests::{Kilograms, Request, RescaleRequest};

use crate::findings::{Found, Remedies, rounded};
use crate::inspection::Inspection;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::ContactsOfAnotherMass,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Mass),
    what: "The contacts are published ones, made for a body of another mass.",
    why: "Radius, stiffness, dissipation and number of spheres are those of a published model, but the body weighs something else: contacts that are not scaled sink in more or less than they did there.",
    advice: "If OpenSim scaled this model, `check MODEL from=GENERIC` compares it with the one that was scaled. If its spheres are where they belong, scale the contacts from the mass they were made for to the mass of this body",
    repair: Repair::Command(
        "scales the contacts from the mass they were made for to that of this body, where the places of the spheres are known to be right",
    ),
    example: Example::Piece {
        model: "check/known_contacts.osim",
        good: "<mass>60</mass>",
        bad: "<mass>88</mass>",
    },
};

/// Known contacts under a body of another mass, where no note says that this is known. They can be scaled where the places of
/// the spheres are right.
pub(crate) fn find(inspected: &Inspection, remedies: &Remedies<'_>, places_are_right: bool) -> Option<Found> {
    let mass = inspected.mass_kg?;
    let known = inspected.known_contacts?;
    let unsaid = inspected.contacts_mass_kg.as_ref().is_some_and(|made_for| made_for.source == "bodies");
    if !unsaid || same_mass(mass, known.made_for_kg) {
        return None;
    }
    let made_for = known.made_for_kg;
    let text = format!(
        "the contacts are those of {}, made for {} kg, and the body weighs {} kg",
        known.title,
        readable(made_for),
        four_significant(mass)
    );
    let remedy = places_are_right.then(|| remedy(remedies, made_for, mass)).flatten();
    Some(Found::new(Finding::new(&RULE, text), remedy))
}

/// Scales contacts that were made for another body to this one.
fn remedy(remedies: &Remedies<'_>, contacts_mass_kg: f64, target_mass_kg: f64) -> Option<Request> {
    let contacts_mass = Some(Kilograms::new(rounded(contacts_mass_kg)).ok()?);
    Some(
        RescaleRequest {
            models: remedies.models(true)?,
            target_mass: Some(Kilograms::new(rounded(target_mass_kg)).ok()?),
            masses: MassOptions { contacts_mass, ..MassOptions::default() },
            choice: remedies.choice(),
            set_files: remedies.set_files(),
            ..RescaleRequest::default()
        }
        .into(),
    )
}
