//! A motion, seen by the contacts of a model.

use osim_model::files::{Failure, FileName, Files, OpenModel};
use osim_model::{Fault, MassRequest, Model};
use osim_motion::{Belt, ContactStates, Foot, Measured, OnSole, Recording, StatesError, Summary};
use osim_requests::{MotionRequest, RequestError, RequestFault};

use super::beyond;
use super::opened::{belt, failure, recording_options, table};
use super::plates::PlatesRead;
use super::result::MotionResult;
use crate::opening::open_with;

/// Follows the contacts along the motion.
///
/// # Errors
/// A file that cannot be read, a motion of another model, or a model whose place is not known.
pub fn run_motion(request: &MotionRequest, files: &dyn Files) -> Result<MotionResult, RequestError> {
    let Some(subject) = &request.subject else {
        return Err(RequestFault::Missing { field: "subject" }.into());
    };
    let Some(motion) = &request.motion else { return Err(RequestFault::Missing { field: "motion" }.into()) };
    let opened = open_with(subject, request.set_files.beside(), files)?;
    let options = recording_options(motion, request.angles, request.low_pass);
    let table = table(motion, files)?;
    let recording =
        Recording::of(&opened.model, &table, &options).map_err(|fault| failure(motion, &fault))?;
    let loads = request.loads.as_deref();
    let plates = request.plates.as_ref().map(|file| PlatesRead::read(file, loads, files)).transpose()?;
    let (mass_kg, gravity_m_s2) =
        weight(&request.masses.request(), &opened.model).map_err(|fault| opened.failure(fault))?;
    let selected = request.choice.selection().apply(&opened.model).map_err(|fault| opened.failure(fault))?;
    let belt = belt(motion, &table, request.belt, request.belt_column.as_deref())?;
    let states =
        ContactStates::of(&opened.model, &recording, &selected.forces, belt.clone().unwrap_or_default())
            .map_err(|error| match error {
                StatesError::Motion(fault) => failure(motion, &fault),
                StatesError::Model(fault) => opened.failure(*fault),
                StatesError::Pose(fault) => opened.failure(Fault::refused(fault.to_string())),
            })?;
    beyond::refuse_states(&states, mass_kg * gravity_m_s2).map_err(|fault| opened.failure(fault))?;
    let feet = Foot::all(&opened.model, &states, &selected.forces);
    if feet.is_empty() {
        let fault =
            Fault::refused("no applied force presses a sphere on the ground: there is nothing to follow");
        return Err(opened.failure(fault).into());
    }
    let on_ground = OnGround { recording, states, feet, weight: (mass_kg, gravity_m_s2), belt };
    let result = on_ground.beside(opened, FileName::from(motion.as_path()), plates);
    if let (Some(read), Some(measured)) = (&result.plates, &result.measured)
        && measured.total.iter().all(Option::is_none)
    {
        let why = "it has no time in common with the motion";
        return Err(Failure::outside(read.name(), "motion", why).into());
    }
    let plates = result.plates.as_ref().zip(result.measured.as_ref());
    if let Some((read, what)) = plates.and_then(|(read, measured)| Some((read, beyond::of_plates(measured)?)))
    {
        let why = format!("it has {what}: correct the table");
        return Err(Failure::outside(read.name(), "motion", why).into());
    }
    Ok(result)
}

/// Contacts along a motion.
pub(crate) struct OnGround {
    pub(crate) recording: Recording,
    pub(crate) states: ContactStates,
    pub(crate) feet: Vec<Foot>,
    /// What the model weighs, kg, and its gravity, m/s².
    pub(crate) weight: (f64, f64),
    pub(crate) belt: Option<Belt>,
}

impl OnGround {
    /// Beside what plates measured, where there are some.
    pub(crate) fn beside(
        self,
        opened: OpenModel,
        motion: FileName,
        plates: Option<PlatesRead>,
    ) -> MotionResult {
        let Self { recording, states, feet, weight: (mass_kg, gravity_m_s2), belt } = self;
        let weight_n = mass_kg * gravity_m_s2;
        let measured = plates.as_ref().map(|read| Measured::of(&read.plates, &feet, &states, weight_n));
        let summary = Summary::of(&states, &feet, measured.as_ref(), weight_n);
        let with_plates = summary.feet.iter().enumerate().map(|(index, foot)| {
            let plates = measured.as_ref().filter(|measured| measured.has_points.get(index) == Some(&true));
            (foot, plates.and_then(|measured| measured.feet.get(index)).map(Vec::as_slice))
        });
        MotionResult {
            on_soles: OnSole::all(&opened.model, &states, with_plates, weight_n),
            opened,
            motion,
            recording,
            states,
            plates,
            measured,
            summary,
            mass_kg,
            gravity_m_s2,
            belt,
        }
    }
}

/// What `model` weighs, kg and m/s².
///
/// # Errors
/// No mass, or no gravity.
pub(crate) fn weight(masses: &MassRequest, model: &Model) -> Result<(f64, f64), Fault> {
    let mass = masses.of_model(model)?;
    let gravity = model.gravity().filter(|&gravity| gravity > 0.0);
    let needed =
        || Fault::refused("the model has no gravity, so that there is no body weight to compare forces with");
    Ok((mass.kg, gravity.ok_or_else(needed)?))
}
