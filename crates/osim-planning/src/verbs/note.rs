//! Notes of what the user knows.

use osim_messages::{Input, phrase};
use osim_model::{Fault, Model};
use osim_patch::{Plan, note};
use osim_requests::options::{ForceOptions, InspectionOptions, MassOptions, StanceOptions};
use osim_requests::{Acceleration, Count, NoteRequest, RequestFault};
use serde_json::json;

use super::asking::Asking;
use crate::planner::{Change, Planner};

struct Noting {
    contacts_mass_kg: f64,
    gravity_m_s2: Option<f64>,
    stance_limbs: Option<f64>,
    inspection: InspectionOptions,
    settings: String,
}

/// Checks the request, for all of its models.
///
/// # Errors
/// No model, no mass, or no note.
pub(super) fn prepare(request: NoteRequest) -> Result<Change, RequestFault> {
    let NoteRequest {
        models,
        contacts_mass,
        contacts_gravity,
        stance_limbs,
        output,
        run: _,
        answers,
        set_files,
    } = request;
    if models.is_empty() {
        return Err(RequestFault::Missing { field: "models" });
    }
    let Some(contacts_mass) = contacts_mass else {
        return Err(RequestFault::general(phrase![
            "the mass is missing: say which mass the contacts in the file were made for with ",
            Input::ContactsMass.like("KG"),
        ]));
    };
    if output.no_note {
        return Err(RequestFault::general(phrase!["a note is written or not: leave out ", Input::NoNote]));
    }
    let masses = MassOptions { contacts_mass: Some(contacts_mass), ..MassOptions::default() };
    let planner = Noting {
        contacts_mass_kg: contacts_mass.get(),
        gravity_m_s2: contacts_gravity.map(Acceleration::get),
        stance_limbs: stance_limbs.map(Count::get),
        inspection: InspectionOptions::new(
            StanceOptions::default(),
            masses,
            ForceOptions::default(),
            set_files.clone(),
        ),
        settings: json!(["note", contacts_mass, contacts_gravity, stance_limbs]).to_string(),
    };
    let asking = Asking { masses: planner.inspection.masses.request(), answers, planner };
    Ok(Change::new(models, output, set_files, asking))
}

impl Planner for Noting {
    fn name(&self) -> &'static str {
        "note"
    }

    fn inspection(&self) -> InspectionOptions {
        self.inspection.clone()
    }

    fn settings(&self) -> String {
        self.settings.clone()
    }

    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        note(model, self.contacts_mass_kg, self.gravity_m_s2.or(model.gravity()), self.stance_limbs)
    }
}
