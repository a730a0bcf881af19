//! Contacts out of models.

use osim_model::messages::{Input, Phrase, Verb, counted, phrase, readable};
use osim_model::{Fault, Model, Note, Selection};
use osim_patch::{Deed, Plan, added_forces, note_of_rest, remove};
use osim_requests::options::InspectionOptions;
use osim_requests::{RemoveRequest, RequestFault};

use crate::planner::{Change, Planner};
use crate::remarks::{refuse_geometry_output, still_named};

struct Removing {
    selection: Selection,
}

/// Checks the request, for all of its models.
///
/// # Errors
/// No model.
pub(super) fn prepare(request: RemoveRequest) -> Result<Change, RequestFault> {
    let RemoveRequest { models, choice, output, run: _, answers } = request;
    if models.is_empty() {
        return Err(RequestFault::Missing { field: "models" });
    }
    refuse_geometry_output(&output)?;
    let planner = Removing { selection: choice.selection() };
    let inspection = InspectionOptions { choice, answers, ..InspectionOptions::default() };
    Ok(Change::new(Verb::Remove, models, output, inspection, planner))
}

impl Planner for Removing {
    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        // What was added is known, also where a change of it would have to be asked about.
        let added = added_forces(model).filter(|_| self.selection.select.is_empty());
        let selected = match added {
            Some(added) => self.selection.apply_among(model, &added)?,
            None => self.selection.apply(model)?,
        };
        let rebuilt = remove(model, &selected)?;
        let count = |class: &str| {
            let gone = rebuilt.objects.iter().filter(|object| object.deed == Deed::Removed);
            gone.filter(|object| object.class == class).count()
        };
        let spheres = count("ContactSphere");
        let planes = count("ContactHalfSpace");
        let forces = rebuilt.objects.len() - spheres - planes;
        let floor = if planes > 0 { ", and the floor that was made for them" } else { "" };
        let (forces, spheres) = (counted(forces, "force"), counted(spheres, "sphere"));
        let taken = format!("removes {forces} and {spheres}{floor}; no other number changes");
        let note = note_of_rest(model, &rebuilt);
        let named = still_named(&rebuilt);
        let mut plan = Plan::of_objects(rebuilt, taken.into());
        plan.remarks.extend(named);
        if let Some(note) = &note {
            plan.remarks.push(note_stays(note));
        }
        Ok(plan.with_note(note))
    }
}

/// The remark about a note if contacts are left.
fn note_stays(note: &Note) -> Phrase {
    let mut said = phrase!["contacts are left, and so is the note in the file, as one about a part of them"];
    if let Some(kg) = note.contacts_mass_kg {
        said.push(": for the next change say ");
        said.push(Input::ContactsMass.with_value(readable(kg)));
        said.push(" if these are still made for that mass");
    }
    said
}
