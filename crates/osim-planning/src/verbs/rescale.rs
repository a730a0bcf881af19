//! A model's own contacts at another mass, with spheres that follow their bodies.

use osim_inspect::find_misplaced_spheres;
use osim_model::compare::ScaleFile;
use osim_model::files::Files;
use osim_model::messages::{Input, Verb, phrase, readable};
use osim_model::{
    Fault, MassRequest, Model, Needed, Note, NoteDoubt, RadiusRule, ScaledSinceNote, Selection,
};
use osim_patch::{FOLLOWING, FOLLOWING_NOTE, Plan, Rescale, rescale};
use osim_requests::options::{InspectionOptions, ScalingOptions};
use osim_requests::{Acceleration, Radius, RequestError, RequestFault, RescaleRequest};

use crate::opening::scale_file;
use crate::planner::{Change, Planner};
use crate::remarks::{operation, refuse_again, refuse_known};

struct Rescaling {
    target_mass_kg: f64,
    masses: MassRequest,
    selection: Selection,
    scaling: ScalingOptions,
    following: Following,
    may_repeat: bool,
}

/// Checks the request and reads the ScaleSet where one is named, for all of its models.
///
/// # Errors
/// The target mass is missing, the options leave nothing to do, or the ScaleSet cannot be read.
pub(super) fn prepare(request: RescaleRequest, files: &dyn Files) -> Result<Change, RequestError> {
    let bodies = request.body_scale_file.as_deref().map(|path| scale_file(path, files)).transpose()?;
    Ok(with_bodies(request, bodies)?)
}

/// Rescaling with what the ScaleSet says.
///
/// # Errors
/// The target mass is missing, or the options leave nothing to do.
pub(crate) fn with_bodies(
    request: RescaleRequest,
    bodies: Option<ScaleFile>,
) -> Result<Change, RequestFault> {
    let RescaleRequest {
        models,
        target_mass,
        masses,
        scaling,
        body_scale_file,
        follow_bodies,
        choice,
        output,
        run: _,
        answers,
        set_files,
    } = request;
    let Some(target_mass) = target_mass else {
        return Err(RequestFault::refused(
            Input::TargetMass,
            phrase![
                "the target is missing: say which mass the contacts should be made for with ",
                Input::TargetMass.with_placeholder("KG"),
            ],
        ));
    };
    scaling.check()?;
    let target_mass_kg = Some(target_mass.get());
    let target_gravity_m_s2 = scaling.target_gravity.map(Acceleration::get);
    let planner = Rescaling {
        target_mass_kg: target_mass.get(),
        masses: MassRequest { target_mass_kg, ..masses.request() },
        selection: choice.selection(),
        scaling,
        following: match bodies {
            Some(file) => Following::File(file),
            None if follow_bodies => Following::Note,
            None => Following::Nothing,
        },
        may_repeat: output.may_repeat(),
    };
    let inspection = InspectionOptions { masses, choice, set_files, answers, ..InspectionOptions::default() };
    Ok(Change {
        target_mass_kg,
        target_gravity_m_s2,
        reads: body_scale_file.into_iter().collect(),
        ..Change::new(Verb::Rescale, models, output, inspection, planner)
    })
}

impl Planner for Rescaling {
    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        let selected = self.selection.apply(model)?;
        let scaling = &self.scaling;
        let radius = scaling.radius.map(Radius::rule);
        let operation = operation(self.following.operation(), radius);
        if matches!(radius, Some(RadiusRule::Factor(_))) {
            refuse_again(model, &operation, self.may_repeat)?;
        }
        let (contacts_mass, mut warnings) = self.masses.contacts_mass(model)?;
        refuse_known(model, &selected, &contacts_mass, Input::ContactsMass)?;
        let bodies = self.following.factors(model)?;
        if bodies.is_some() && !contacts_mass.source.is_about_contacts() {
            // What the bodies weigh now, the contacts were not made for.
            return Err(Fault::new(Needed::ContactsMass {
                noted_kg: None,
                doubt: NoteDoubt::Absent,
                input: Input::ContactsMass,
            }));
        }
        if bodies.is_none() {
            warnings.extend(find_misplaced_spheres(model));
        }
        let mut wanted = Rescale::new(self.target_mass_kg, contacts_mass);
        wanted.radius = radius.unwrap_or(RadiusRule::Isometric);
        wanted.properties = scaling.properties();
        wanted.dissipation_by = scaling.dissipation();
        wanted.target_gravity_m_s2 = scaling.target_gravity.map(Acceleration::get);
        wanted.contacts_gravity_m_s2 = scaling.contacts_gravity.map(Acceleration::get);
        wanted.level = scaling.level_axis(model.gravity_m_s2);
        wanted.bodies = bodies;
        let mut plan = rescale(model, &selected, &wanted)?;
        plan.name_operation(&operation);
        plan.warnings.append(&mut warnings);
        Ok(plan)
    }
}

// By how much bodies were scaled, where a rescaling moves spheres with them.

/// Factors that differ by more than this (relative) are not the same.
const SAME_FACTOR: f64 = 1e-4;

/// Where the factors come from.
pub(super) enum Following {
    /// Spheres stay.
    Nothing,
    /// From the sizes in the note.
    Note,
    /// From the ScaleSet that the Scale Tool applied.
    File(ScaleFile),
}

impl Following {
    pub(super) const fn operation(&self) -> &'static str {
        match self {
            Self::Nothing => "rescale",
            Self::Note => FOLLOWING_NOTE,
            Self::File(_) => FOLLOWING,
        }
    }

    /// The factors for `model`; `None` where spheres stay.
    ///
    /// # Errors
    /// The note does not say them, says others than the ScaleSet, or says that spheres followed already.
    pub(super) fn factors(&self, model: &Model) -> Result<Option<ScaleFile>, Fault> {
        match self {
            Self::Nothing => Ok(None),
            Self::Note => of_note(model).map(Some),
            Self::File(file) => {
                match model.scaled_since_note() {
                    Some(since) if since.is_scaled() => compare(&since, file)?,
                    Some(_) if model.note.as_ref().is_some_and(Note::has_placed_spheres) => {
                        return Err(Fault::new(Needed::AlreadyFollowed));
                    }
                    _ => {}
                }
                Ok(Some(file.clone()))
            }
        }
    }
}

fn of_note(model: &Model) -> Result<ScaleFile, Fault> {
    let unknown = || Fault::new(Needed::NotedSizes);
    let since = model.scaled_since_note().ok_or_else(unknown)?;
    if !since.has_all_carriers(model) {
        return Err(unknown());
    }
    Ok(ScaleFile::from_factors(since.factors))
}

/// Checks that the ScaleSet is that of this model.
fn compare(since: &ScaledSinceNote, file: &ScaleFile) -> Result<(), Fault> {
    for (body, noted) in &since.factors {
        let given = file.required_factors(body)?;
        let same = |(a, b): (&f64, &f64)| (a - b).abs() <= SAME_FACTOR * b.abs();
        if !noted.iter().zip(&given).all(same) {
            return Err(Fault::refused(format!(
                "the ScaleSet scales {body} by {}, and by the note in the file it was scaled by {}: expected the ScaleSet \
                 that was applied to this model",
                in_words(given),
                in_words(*noted)
            )));
        }
    }
    Ok(())
}

/// Factors along x, y and z.
fn in_words(factors: [f64; 3]) -> String {
    factors.map(readable).join(", ")
}
