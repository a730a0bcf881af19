//! What a figure shows: bodies, units, the fall.

use std::path::Path;

use contact_scaling::Ratios;
use osim_inspect::Stance;
use osim_inspect::series::Body;
use osim_inspect::unexplained_slip;
use osim_model::files::Files;
use osim_model::messages::{Input, phrase, readable};
use osim_model::{Fault, MassRequest};
use osim_requests::{MotionRequest, PlotRequest, RequestError, RequestFault};

use crate::feet::ModelFeet;
use crate::heat_table::HeatTable;
use crate::motion::{MotionResult, run_motion};
use crate::subject::Subject;

/// The table that a column is drawn from, if the request names one.
///
/// # Errors
/// As [`HeatTable::read`].
pub fn plot_table(request: &PlotRequest, files: &dyn Files) -> Result<Option<HeatTable>, RequestError> {
    let Some(path) = request.heat.table.as_deref() else { return Ok(None) };
    Ok(Some(HeatTable::read(path, &request.heat, files)?))
}

/// The states of the feet that a figure shows, the later one last: those of a model, of the same with radii scaled to the
/// target mass, or of two models.
///
/// # Errors
/// A preset, which has no places, too many models, or a model that cannot be read or has no feet.
pub fn plot_feet(request: &PlotRequest, files: &dyn Files) -> Result<Vec<ModelFeet>, RequestError> {
    let states = request.models.len() + usize::from(request.target_mass.is_some());
    if states > 2 {
        return Err(RequestFault::general(phrase![
            "a figure of feet shows one model, or two (before and after): leave out others, and ",
            Input::TargetMass,
            " beside two",
        ])
        .into());
    }
    let mut feet = Vec::new();
    for path in &request.models {
        let (own, scaled) = feet_of(request, path, files)?;
        feet.push(own);
        feet.extend(scaled);
    }
    Ok(feet)
}

fn feet_of(
    request: &PlotRequest,
    path: &Path,
    files: &dyn Files,
) -> Result<(ModelFeet, Option<ModelFeet>), RequestError> {
    let open = match Subject::find(path, request.presets.as_deref(), &request.set_files, files)? {
        Subject::Model(open) => open,
        Subject::Preset(preset) => {
            let why = format!("{} is a preset, which has no feet: name a model", preset.name);
            return Err(RequestFault::general(why).into());
        }
    };
    let name = short_name(path);
    let mut feet = ModelFeet::of(&name, &open, &request.choice.selection())?;
    let geometry = request.geometry_dir.as_deref();
    // Of a standalone set, the model beside it says where the bones are.
    let beside = request.set_files.model.as_deref().unwrap_or(path);
    feet.add_bones(&open.model, beside, geometry, files);
    let Some(target_mass) = request.target_mass else { return Ok((feet, None)) };
    let failed = |fault| open.failure(fault);
    let (contacts_mass, _) = request.masses.request().of_contacts(&open.model).map_err(failed)?;
    let ratios =
        Ratios::isometric(target_mass.get() / contacts_mass.kg).map_err(|error| failed(Fault::new(error)))?;
    let scaled = feet.with_radii(format!("scaled to {} kg", readable(target_mass.get())), ratios.radius());
    Ok((feet, Some(scaled)))
}

/// What a figure of motion shows.
///
/// # Errors
/// More than one model, or none; a recording that cannot be read.
pub fn plot_motion(request: &PlotRequest, files: &dyn Files) -> Result<MotionResult, RequestError> {
    let [model] = request.models.as_slice() else {
        return Err(RequestFault::general("a figure of motion shows one model: name it alone").into());
    };
    let motion = MotionRequest {
        subject: Some(model.clone()),
        motion: request.motion.clone(),
        plates: request.plates.clone(),
        loads: request.loads.clone(),
        angles: request.angles,
        masses: request.masses.clone(),
        choice: request.choice.clone(),
        set_files: request.set_files.clone(),
        ..MotionRequest::default()
    };
    run_motion(&motion, files)
}

/// All bodies of the figure: those that were named, each followed by its scaled self if a target mass is given.
///
/// # Errors
/// A name that is neither a model's nor a preset's, or a model that cannot be read.
pub fn plot_bodies(request: &PlotRequest, files: &dyn Files) -> Result<Vec<Body>, RequestError> {
    let mut bodies = Vec::new();
    for path in &request.models {
        let body = body(request, path, &name_of(request, path), files)?;
        let scaled =
            request.target_mass_kg().map(|target_mass_kg| body.scaled(target_mass_kg)).transpose()?;
        bodies.push(body);
        bodies.extend(scaled);
    }
    Ok(bodies)
}

/// A model's name, with its folder where another model has the same.
fn name_of(request: &PlotRequest, path: &Path) -> String {
    let name = short_name(path);
    let alike = request.models.iter().filter(|other| short_name(other) == name).count() > 1;
    match path.parent().and_then(Path::file_name).filter(|_| alike) {
        Some(folder) => format!("{}/{name}", folder.to_string_lossy()),
        None => name,
    }
}

fn body(request: &PlotRequest, path: &Path, name: &str, files: &dyn Files) -> Result<Body, RequestError> {
    let masses = request.masses.request();
    let stance = Stance::from(&request.counts.stance_options(None, request.gravity));
    match Subject::find(path, request.presets.as_deref(), &request.set_files, files)? {
        Subject::Preset(preset) => {
            let body = Body::of_preset(&preset, &masses, &stance);
            Ok(body.map_err(|error| RequestFault::general(error.to_string()))?)
        }
        Subject::Model(open) => {
            let said = MassRequest { target_mass_kg: request.target_mass_kg(), ..masses.clone() };
            let selection = request.choice.selection();
            let asked = request.answers.ask(unexplained_slip(&said, &open.model, &selection));
            asked.map_err(|kind| open.failure(Fault::new(kind)))?;
            let selected = selection.apply(&open.model).map_err(|fault| open.failure(fault))?;
            let failed = |fault| open.failure(fault);
            Ok(Body::of_model(name.to_owned(), &open.model, &selected.forces, &masses, &stance, &failed)?)
        }
    }
}

/// The file's name without its folders, which would fill a legend.
fn short_name(path: &Path) -> String {
    path.file_stem().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned())
}
