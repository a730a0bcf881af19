//! The verb `note`: writes into the model for which mass and how many limbs its contacts were made.

use osim_model::messages::{Input, Verb, phrase};
use osim_model::{Model, Selection};
use osim_patch::{note, note_stance_limbs};
use osim_requests::options::{InspectionOptions, MassOptions};
use osim_requests::{Acceleration, Count, NoteRequest, RequestFault};

use crate::prepared_change::PreparedChange;

/// What a new note says about contacts: the mass that they were made for, or only how many limbs share the weight.
enum NewNote {
    /// The mass that the contacts were made for, kg, and perhaps the number of limbs that share the weight.
    Mass(f64, Option<f64>),
    /// The number of limbs that share the weight, without a mass.
    StanceLimbs(f64),
}

/// Checks the request for all of its models.
///
/// # Errors
/// No model, no mass, or no note.
pub(super) fn prepare(request: NoteRequest) -> Result<PreparedChange, RequestFault> {
    let NoteRequest { contacts_mass, contacts_gravity, stance_limbs, output, answers, set_files, .. } =
        request;
    if request.models.is_empty() {
        return Err(RequestFault::Missing { field: "models" });
    }
    let noted = match (contacts_mass, stance_limbs) {
        (Some(mass), limbs) => NewNote::Mass(mass.get(), limbs.map(Count::get)),
        (None, Some(_)) if contacts_gravity.is_some() => {
            return Err(RequestFault::Needs { field: "contacts_gravity", other: "contacts_mass" });
        }
        (None, Some(limbs)) => NewNote::StanceLimbs(limbs.get()),
        (None, None) => {
            return Err(RequestFault::general(phrase![
                "the mass is missing: give the mass that the contacts in the file were made for with {}, or the \
                number of limbs that share the weight with {}";
                Input::ContactsMass.with_placeholder("KG"), Input::StanceLimbs.with_placeholder("N")
            ]));
        }
    };
    if output.no_note {
        return Err(RequestFault::general(phrase!["a note is written or not: leave out ", Input::NoNote]));
    }
    let masses = MassOptions { contacts_mass, ..MassOptions::default() };
    let gravity_m_s2 = contacts_gravity.map(Acceleration::get);
    let known_masses = masses.request();
    let planner = move |model: &Model| {
        // A model without contacts has nothing to note.
        let forces: Vec<_> = model.forces().iter().map(|force| force.id).collect();
        Selection::default().apply_among(model, &forces)?;
        match noted {
            NewNote::Mass(kg, limbs) => {
                let mut plan = note(model, kg, gravity_m_s2.or(model.gravity()), limbs)?;
                plan.findings.extend(known_masses.disagreement_with_note(model));
                Ok(plan)
            }
            NewNote::StanceLimbs(limbs) => Ok(note_stance_limbs(model, limbs)),
        }
    };
    let inspection = InspectionOptions { masses, set_files, answers, ..InspectionOptions::default() };
    Ok(PreparedChange::new(Verb::Note, request.models, output, inspection, planner))
}
