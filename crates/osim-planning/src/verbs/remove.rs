//! The verb `remove`: removes contacts from models.

use osim_inspect::describe_unmatched_patterns;
use osim_model::messages::{Input, Phrase, Verb, counted, phrase, readable};
use osim_model::{Fault, MassRequest, Model, Note, Selection};
use osim_patch::{ObjectAction, Plan, added_forces, note_of_remaining, remove};
use osim_requests::options::InspectionOptions;
use osim_requests::{RemoveRequest, RequestFault};

use crate::prepared_change::PreparedChange;
use crate::remarks::{refuse_geometry_output, remarks_on_missing_names};

/// Checks the request for all of its models.
///
/// # Errors
/// No model.
pub(super) fn prepare(request: RemoveRequest) -> Result<PreparedChange, RequestFault> {
    let RemoveRequest { models, choice, output, run: _, answers } = request;
    if models.is_empty() {
        return Err(RequestFault::Missing { field: "models" });
    }
    refuse_geometry_output(&output)?;
    let selection = choice.selection();
    let planner = move |model: &Model| plan_removal(model, &selection);
    // The result is judged by the forces that are left.
    let inspection = InspectionOptions { answers, ..InspectionOptions::default() };
    Ok(PreparedChange::new(Verb::Remove, models, output, inspection, planner))
}

/// Plans the removal of the chosen contacts; without a choice, of those that this program added, if there are any.
fn plan_removal(model: &Model, selection: &Selection) -> Result<Plan, Fault> {
    // Without a choice, the forces that this program added are removed: there is no need to ask.
    let added = added_forces(model).filter(|_| selection.select.is_empty());
    let selected = match added {
        Some(added) => selection.apply_among(model, &added)?,
        None => selection.apply(model)?,
    };
    let rebuilt = remove(model, &selected, &[])?;
    let count = |class: &str| {
        let removed = rebuilt.objects.iter().filter(|object| object.action == ObjectAction::Removed);
        removed.filter(|object| object.class == class).count()
    };
    let spheres = count("ContactSphere") + count("ContactEllipsoid");
    let planes = count("ContactHalfSpace");
    let forces = rebuilt.objects.len() - spheres - planes;
    let floor = if planes > 0 { ", and the floor that was made for them" } else { "" };
    let (forces, spheres) = (counted(forces, "force"), counted(spheres, "sphere"));
    let summary = format!("removes {forces} and {spheres}{floor}; no other number changes");
    let note = note_of_remaining(model, &rebuilt);
    let missing_names = remarks_on_missing_names(&rebuilt);
    let mut plan = Plan::from_objects(rebuilt, summary.into());
    plan.remarks.extend(missing_names);
    plan.remarks.extend(describe_unmatched_patterns(selection, &MassRequest::default(), model));
    if let Some(note) = &note {
        plan.remarks.push(remark_on_kept_note(note));
    }
    Ok(plan.with_note(note))
}

/// The remark that the note stays, because the model still has contacts.
fn remark_on_kept_note(note: &Note) -> Phrase {
    let mut remark = phrase![
        "some contacts are left, and the note in the file now counts as one about a part of the contacts"
    ];
    if let Some(kg) = note.contacts_mass_kg {
        remark.push(": for the next change give ");
        remark.push(Input::ContactsMass.with_value(readable(kg)));
        remark.push(" if these are still made for that mass");
    }
    remark
}
