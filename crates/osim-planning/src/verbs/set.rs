//! The verb `set`: gives properties new values, and brings the bottoms of each foot to one height.

use osim_inspect::{ContactsOrigin, Stance};
use osim_model::feet::{NotLevelled, levelled_spheres};
use osim_model::messages::{Input, Verb, phrase};
use osim_model::{Fault, ForceId, Mass, MassSource, Model, SphereId};
use osim_patch::{Set, set};
use osim_requests::options::InspectionOptions;
use osim_requests::{RequestFault, SetRequest};

use crate::prepared_change::PreparedChange;

/// Checks the request for all of its models.
///
/// # Errors
/// No model, or nothing to set.
pub(crate) fn prepare(request: SetRequest) -> Result<PreparedChange, RequestFault> {
    let SetRequest { models, set: assignments, level, masses, choice, output, run: _, answers, set_files } =
        request;
    if models.is_empty() {
        return Err(RequestFault::Missing { field: "models" });
    }
    if assignments.is_empty() && !level {
        return Err(RequestFault::general(phrase![
            "nothing to set, expected PROPERTY=VALUE or PROPERTY=xFACTOR, for example stiffness=x2, or ",
            Input::Level,
        ]));
    }
    let (selection, known_masses) = (choice.selection(), masses.request());
    let may_repeat = output.may_repeat();
    let planner = move |model: &Model| {
        let selected = selection.apply(model)?;
        // This change needs no mass; if one is known, the new note has it.
        let noted_mass =
            || Some(Mass { kg: model.note.as_ref()?.contacts_mass_kg?, source: MassSource::Note });
        let origin = ContactsOrigin::find(model, &selected.forces, &known_masses, &Stance::default());
        let (contacts_mass, findings) = match origin {
            Ok(origin) => (Some(origin.mass), origin.findings),
            Err(_) => (noted_mass(), Vec::new()),
        };
        let mut wanted = Set::new(assignments.as_slice().to_vec());
        wanted.contacts_mass = contacts_mass;
        wanted.repeat = may_repeat;
        if level && assignments.is_empty() {
            wanted.level = Some(level_places(model, &selected.forces)?);
        } else if level {
            // The radii of the spheres are the new ones.
            let changed = set(model, &selected, &wanted)?.changed_model(model)?;
            wanted.level = Some(level_places(&changed, &selected.forces)?);
        }
        let mut plan = set(model, &selected, &wanted)?;
        plan.findings.extend(findings);
        Ok(plan)
    };
    let inspection = InspectionOptions { masses, choice, set_files, answers, ..InspectionOptions::default() };
    Ok(PreparedChange::new(Verb::Set, models, output, inspection, planner))
}

/// The new centres of the spheres of `forces`, with which all bottoms of a foot are as low as its lowest bottom; m, in the frames of the
/// spheres. Spheres that stay at their places are left out.
///
/// # Errors
/// Limbs, floors or the default pose are not known, or a foot leans.
pub(super) fn level_places(model: &Model, forces: &[ForceId]) -> Result<Vec<(SphereId, [f64; 3])>, Fault> {
    let levelled_spheres = levelled_spheres(model, forces).map_err(|fault| match fault {
        NotLevelled::Frame(fault) => *fault,
        other => Fault::refused(other.to_string()),
    })?;
    Ok(levelled_spheres.into_iter().map(|one| (one.sphere, one.location_m)).collect())
}
