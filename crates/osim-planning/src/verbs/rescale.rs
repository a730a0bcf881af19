//! The verb `rescale`: scales the contacts of a model to another mass. Spheres can follow their bodies.

use osim_inspect::{ContactsOrigin, Stance};
use osim_model::compare::ScaleFile;
use osim_model::files::Files;
use osim_model::messages::{Input, Verb, phrase, readable};
use osim_model::{Fault, MassRequest, MissingFact, Model, Note, NoteDoubt, RadiusRule, ScaledSinceNote};
use osim_patch::{OPERATION_FOLLOWING_NOTE, OPERATION_FOLLOWING_SCALE_FILE, Plan, Rescale, rescale};
use osim_requests::options::InspectionOptions;
use osim_requests::{Acceleration, RequestFault, RescaleRequest, Result};

use crate::opening::read_scale_file;
use crate::prepared_change::PreparedChange;
use crate::remarks::{level_axis, operation_with_radius, refuse_repetition};

/// Checks the request for all of its models, and reads the ScaleSet if the request names one.
///
/// # Errors
/// The target mass is missing, the options leave nothing to do, or the ScaleSet cannot be read.
pub(super) fn prepare(request: RescaleRequest, files: &dyn Files) -> Result<PreparedChange> {
    let bodies = request.body_scale_file.as_deref().map(|path| read_scale_file(path, files)).transpose()?;
    Ok(prepare_with_factors(request, bodies)?)
}

/// Checks the request. `bodies` are the scale factors in its ScaleSet.
///
/// # Errors
/// The target mass is missing, or the options leave nothing to do.
pub(crate) fn prepare_with_factors(
    request: RescaleRequest,
    bodies: Option<ScaleFile>,
) -> Result<PreparedChange, RequestFault> {
    let RescaleRequest { models, masses, scaling, choice, output, answers, set_files, .. } = request;
    let Some(target_mass) = request.target_mass else {
        return Err(RequestFault::refused(
            Input::TargetMass,
            phrase![
                "the target is missing: give the mass that the contacts should be made for with ",
                Input::TargetMass.with_placeholder("KG"),
            ],
        ));
    };
    scaling.check()?;
    scaling.refuse_radii_of_bodies()?;
    let target_mass_kg = target_mass.get();
    let target_gravity_m_s2 = scaling.target_gravity.map(Acceleration::get);
    let mass_request = MassRequest { target_mass_kg: Some(target_mass_kg), ..masses.request() };
    let selection = choice.selection();
    let following = match bodies {
        Some(file) => BodyFactors::File(file),
        None if request.follow_bodies => BodyFactors::Note,
        None => BodyFactors::Nothing,
    };
    let may_repeat = output.may_repeat();
    let plan = move |model: &Model| -> Result<Plan, Fault> {
        let selected = selection.apply(model)?;
        let radius = scaling.radius();
        let operation = operation_with_radius(following.operation(), radius);
        if matches!(radius, Some(RadiusRule::Factor(_))) {
            refuse_repetition(model, &operation, may_repeat)?;
        }
        let origin = ContactsOrigin::find(model, &selected.forces, &mass_request, &Stance::default())?;
        origin.refuse_other_body(model, &mass_request, Input::ContactsMass)?;
        let ContactsOrigin { mass: contacts_mass, mut findings, .. } = origin;
        let bodies = following.factors(model)?;
        if bodies.is_some() && !contacts_mass.source.is_about_contacts() {
            // The bodies were scaled, so their mass is not the one that the contacts were made for.
            return Err(Fault::new(MissingFact::ContactsMass {
                noted_kg: None,
                doubt: NoteDoubt::Absent,
                input: Input::ContactsMass,
            }));
        }
        let mut wanted = Rescale::new(target_mass_kg, contacts_mass);
        wanted.radius = radius.unwrap_or(RadiusRule::Isometric);
        wanted.properties = scaling.properties();
        wanted.dissipation_by = scaling.dissipation();
        wanted.target_gravity_m_s2 = target_gravity_m_s2;
        wanted.contacts_gravity_m_s2 = scaling.contacts_gravity.map(Acceleration::get);
        wanted.level = level_axis(&scaling, model)?;
        wanted.bodies = bodies;
        let mut plan = rescale(model, &selected, &wanted)?;
        plan.name_operation(&operation);
        plan.findings.append(&mut findings);
        Ok(plan)
    };
    let inspection = InspectionOptions { masses, choice, set_files, answers, ..InspectionOptions::default() };
    Ok(PreparedChange {
        target_mass_kg: Some(target_mass_kg),
        target_gravity_m_s2,
        extra_files: request.body_scale_file.into_iter().collect(),
        ..PreparedChange::new(Verb::Rescale, models, output, inspection, plan)
    })
}

/// The factors in a ScaleSet and in a note agree if they differ by at most this (relative).
const EQUAL_FACTORS_TOLERANCE: f64 = 1e-4;

/// The source of the scale factors with which spheres follow their bodies.
pub(super) enum BodyFactors {
    /// No source: the spheres stay at their places.
    Nothing,
    /// The factors follow from the sizes of bodies in the note.
    Note,
    /// The factors are in the ScaleSet that OpenSim's Scale Tool applied.
    File(ScaleFile),
}

impl BodyFactors {
    /// The name of this rescaling in notes.
    pub(super) const fn operation(&self) -> &'static str {
        match self {
            Self::Nothing => "rescale",
            Self::Note => OPERATION_FOLLOWING_NOTE,
            Self::File(_) => OPERATION_FOLLOWING_SCALE_FILE,
        }
    }

    /// The scale factors for `model`; `None` if the spheres stay at their places.
    ///
    /// # Errors
    /// The note does not have them, has others than the ScaleSet, or says that spheres followed already.
    pub(super) fn factors(&self, model: &Model) -> Result<Option<ScaleFile>, Fault> {
        match self {
            Self::Nothing => Ok(None),
            Self::Note => factors_since_note(model).map(Some),
            Self::File(file) => {
                match model.scaled_since_note() {
                    Some(since) if since.spheres_left_behind => check_factors_agree(&since, file)?,
                    Some(_) if model.note.as_ref().is_some_and(Note::has_placed_spheres) => {
                        return Err(Fault::new(MissingFact::AlreadyFollowed));
                    }
                    _ => {}
                }
                Ok(Some(file.clone()))
            }
        }
    }
}

/// The scale factors of bodies from the time of the note to now.
fn factors_since_note(model: &Model) -> Result<ScaleFile, Fault> {
    let unknown = || Fault::new(MissingFact::NotedSizes);
    let since = model.scaled_since_note().ok_or_else(unknown)?;
    if since.has_all_carriers(model) { Ok(ScaleFile::from_factors(since.factors)) } else { Err(unknown()) }
}

/// Refuses a ScaleSet whose factors differ from the scaling of the bodies since the note was written.
fn check_factors_agree(since: &ScaledSinceNote, file: &ScaleFile) -> Result<(), Fault> {
    for (body, noted) in &since.factors {
        let given = file.required_factors(body)?;
        let same = |(a, b): (&f64, &f64)| (a - b).abs() <= EQUAL_FACTORS_TOLERANCE * b.abs();
        if !noted.iter().zip(&given).all(same) {
            return Err(Fault::refused(format!(
                "the ScaleSet scales {body} by {}, and by the note in the file it was scaled by {}: expected the ScaleSet \
                 that was applied to this model",
                listed_factors(given),
                listed_factors(*noted)
            )));
        }
    }
    Ok(())
}

/// The factors along x, y and z in words.
fn listed_factors(factors: [f64; 3]) -> String {
    factors.map(readable).join(", ")
}
