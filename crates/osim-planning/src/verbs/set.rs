//! Plain changes, and feet whose bottoms are made level.

use osim_model::feet::{NotLevelled, levelled_spheres};
use osim_model::messages::{Input, Verb, phrase};
use osim_model::{Fault, ForceId, Mass, MassRequest, MassSource, Model, Selected, Selection, SphereId};
use osim_patch::{Plan, Set, set};
use osim_requests::options::InspectionOptions;
use osim_requests::{Assignments, RequestFault, SetRequest};

use crate::planner::{Change, Planner};

struct Setting {
    assignments: Assignments,
    level: bool,
    selection: Selection,
    masses: MassRequest,
    may_repeat: bool,
}

/// Checks the request, for all of its models.
///
/// # Errors
/// No model, or nothing to set.
pub(crate) fn prepare(request: SetRequest) -> Result<Change, RequestFault> {
    let SetRequest { models, set, level, masses, choice, output, run: _, answers, set_files } = request;
    if models.is_empty() {
        return Err(RequestFault::Missing { field: "models" });
    }
    if set.is_empty() && !level {
        return Err(RequestFault::general(phrase![
            "nothing to set, expected PROPERTY=VALUE or PROPERTY=xFACTOR, for example stiffness=x2, or ",
            Input::Level,
        ]));
    }
    let planner = Setting {
        assignments: set,
        level,
        selection: choice.selection(),
        masses: masses.request(),
        may_repeat: output.may_repeat(),
    };
    let inspection = InspectionOptions { masses, choice, set_files, answers, ..InspectionOptions::default() };
    Ok(Change::new(Verb::Set, models, output, inspection, planner))
}

impl Planner for Setting {
    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        let selected = self.selection.apply(model)?;
        // A plain change needs no mass; if one is known, the new note has it, too.
        let of_note = || Some(Mass { kg: model.note.as_ref()?.contacts_mass_kg?, source: MassSource::Note });
        let (contacts_mass, mut warnings) = match self.masses.contacts_mass(model) {
            Ok((mass, warnings)) => (Some(mass), warnings),
            Err(_) => (of_note(), Vec::new()),
        };
        let mut wanted = Set::new(self.assignments.as_slice().to_vec());
        wanted.contacts_mass = contacts_mass;
        wanted.again = self.may_repeat;
        if self.level {
            wanted.level = Some(self.level_places(model, &selected, &wanted)?);
        }
        let mut plan = set(model, &selected, &wanted)?;
        plan.warnings.append(&mut warnings);
        Ok(plan)
    }
}

impl Setting {
    /// Where spheres have to be for level feet, with the radii that they get.
    fn level_places(
        &self,
        model: &Model,
        selected: &Selected,
        wanted: &Set,
    ) -> Result<Vec<(SphereId, [f64; 3])>, Fault> {
        let changed;
        let model = match self.assignments.is_empty() {
            true => model,
            false => {
                changed = set(model, selected, wanted)?.changed(model)?;
                &changed
            }
        };
        level_places(model, &selected.forces)
    }
}

/// Where spheres of `forces` have to be in `model` for the bottoms of each foot to be as low as its lowest one, in their own frames, m;
/// those that are right are left out.
///
/// # Errors
/// Limbs, floors or the default pose are not known; a foot leans.
pub(super) fn level_places(model: &Model, forces: &[ForceId]) -> Result<Vec<(SphereId, [f64; 3])>, Fault> {
    let found = levelled_spheres(model, forces).map_err(|fault| match fault {
        NotLevelled::Frame(fault) => *fault,
        other => Fault::refused(other.to_string()),
    })?;
    Ok(found.into_iter().map(|one| (one.sphere, one.location_m)).collect())
}
