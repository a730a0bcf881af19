//! Contacts fitted to recordings of a gait.

use std::path::PathBuf;

use osim_messages::{Input, phrase, shortest};
use osim_model::files::Files;
use osim_model::{
    Assignment, Fault, HalfSpace, Mass, MassRequest, MassSource, Model, Property, Selected, Selection,
};
use osim_motion::fit::{FitBounds, FitError, FitTrial, FitWanted, MotionFit, fit_motion};
use osim_motion::{ContactStates, Foot, Measured, Recording, RecordingOptions, StatesError, Summary, Table};
use osim_patch::{Plan, RecordingErrors, Set, set};
use osim_requests::options::{InspectionOptions, StanceOptions};
use osim_requests::{FitRequest, FittedChoice, RequestError, RequestFault};
use serde_json::json;
use sha2::{Digest, Sha256};

use super::asking::Asking;
use super::fitted_words::remarks;
use crate::motion::PlatesRead;
use crate::motion::opened::{recording_options, table};
use crate::motion::run::weight;
use crate::opening::read;
use crate::planner::{Change, Planner, file_name};

/// Digits that are kept of a fitted number: more are not determined.
const DIGITS: usize = 5;

/// One recording.
struct TrialFiles {
    name: String,
    table: Table,
    options: RecordingOptions,
    plates: PlatesRead,
}

struct Fitting {
    trials: Vec<TrialFiles>,
    bounds: FitBounds,
    selection: Selection,
    masses: MassRequest,
    inspection: InspectionOptions,
    files: Vec<PathBuf>,
    settings: String,
}

/// Checks the request and reads the recordings.
///
/// # Errors
/// Files that are missing or do not go together.
pub(crate) fn prepare(request: FitRequest, files: &dyn Files) -> Result<Change, RequestError> {
    let Some(model) = request.file.clone() else {
        return Err(RequestFault::Missing { field: "file" }.into());
    };
    let (motions, plates, loads) = (&request.motion, &request.plates, &request.loads);
    if plates.len() != motions.len() || !(loads.len() <= 1 || loads.len() == motions.len()) {
        let why = phrase![
            format!("there are {} motions, {} tables of ", motions.len(), plates.len()),
            Input::Plates,
            format!(" and {} of ", loads.len()),
            Input::Loads,
            ": give one table for each motion, in the same order, and one ExternalLoads for each or for all"
        ];
        return Err(RequestFault::refused(Input::Plates, why).into());
    }
    let mut trials = Vec::new();
    for (index, (motion, table_of_plates)) in motions.iter().zip(plates).enumerate() {
        let loads = loads.get(index).or(loads.first()).map(PathBuf::as_path);
        trials.push(TrialFiles {
            name: file_name(motion),
            table: table(motion, files)?,
            options: recording_options(motion, request.angles, request.low_pass),
            plates: PlatesRead::read(table_of_plates, loads, files)?,
        });
    }
    let read_files: Vec<PathBuf> = motions.iter().chain(plates).chain(loads).cloned().collect();
    let mut digests = Vec::new();
    for path in &read_files {
        let digest = Sha256::digest(read(path, files)?);
        digests.push(digest.iter().map(|byte| format!("{byte:02x}")).collect::<String>());
    }
    let all = request.fit.is_empty();
    let is_wanted = |choice| all || request.fit.contains(&choice);
    let wanted = FitWanted {
        stiffness: is_wanted(FittedChoice::Stiffness),
        dissipation: is_wanted(FittedChoice::Dissipation),
        height: is_wanted(FittedChoice::Height),
    };
    let FitRequest { fit, unbounded, angles, low_pass, masses, choice, output, answers, set_files, .. } =
        request;
    let planner = Fitting {
        trials,
        bounds: FitBounds { wanted, most_relative_indentation: (!unbounded).then_some(1.0) },
        selection: choice.selection(),
        masses: masses.request(),
        files: read_files,
        settings: json!(["fit", fit, unbounded, angles, low_pass, masses, choice, digests]).to_string(),
        inspection: InspectionOptions::new(StanceOptions::default(), masses, choice, set_files.clone()),
    };
    let asking = Asking { masses: planner.masses.clone(), answers, planner };
    Ok(Change::new(vec![model], output, set_files, asking))
}

/// One trial, seen by a model.
struct Seen {
    summary: Summary,
    trial: FitTrial,
    planes: Vec<HalfSpace>,
    /// Forces of plates of which nobody knows the foot, by their columns.
    of_no_foot: Vec<String>,
}

impl Fitting {
    fn see(
        &self,
        trial: &TrialFiles,
        model: &Model,
        selected: &Selected,
        weight_n: f64,
    ) -> Result<Seen, Fault> {
        let refused = |why: String| Fault::refused(format!("{}: {why}", trial.name));
        let recording =
            Recording::of(model, &trial.table, &trial.options).map_err(|fault| refused(fault.message))?;
        let states =
            ContactStates::of(model, &recording, &selected.forces, [0.0; 3]).map_err(
                |error| match error {
                    StatesError::Model(fault) => *fault,
                    other => refused(other.to_string()),
                },
            )?;
        let feet = Foot::all(model, &states, &selected.forces);
        let measured = Measured::of(&trial.plates.plates, &feet, &states, weight_n);
        let summary = Summary::of(&states, &feet, Some(&measured), weight_n);
        let fitted = FitTrial::of(&states, &feet, &measured, weight_n);
        let planes = states.planes.clone();
        let of_no_foot = measured.uses.into_iter().filter(|one| one.by.is_none()).map(|one| one.plate);
        Ok(Seen { summary, trial: fitted, planes, of_no_foot: of_no_foot.collect() })
    }

    /// The values and places that a fit comes to.
    fn wanted(
        &self,
        model: &Model,
        selected: &Selected,
        fit: &MotionFit,
        planes: &[HalfSpace],
        mass_kg: f64,
    ) -> Result<Set, Fault> {
        let mut assignments = Vec::new();
        let mut said: Vec<String> = Vec::new();
        if let Some(factor) = fit.stiffness_factor {
            let assignment = stiffness(model, selected, factor.value);
            said.push(format!("stiffness={assignment}"));
            assignments.push((Property::Stiffness, assignment));
        }
        if let Some(dissipation) = fit.dissipation {
            let assignment = Assignment::Value(rounded(dissipation.value));
            said.push(format!("dissipation={assignment}"));
            assignments.push((Property::Dissipation, assignment));
        }
        let mut wanted = Set::new(assignments);
        // Of several trials, each has a floor of its own: the model gets that of the first.
        if let Some(up) = fit.floor_up_m.first() {
            let up_m = (up.value * 1e6).round() / 1e6;
            said.push(format!("floor_up={}", shortest(up_m)));
            for plane in planes {
                if !plane.on_ground {
                    return Err(Fault::refused(format!(
                        "the floor {} is on the body {}: only a floor on ground has a height that can be fitted",
                        plane.name,
                        plane.body.as_deref().unwrap_or_default()
                    )));
                }
                let none =
                    || Fault::refused(format!("the place of half-space {} cannot be read", plane.path));
                wanted.planes.push((plane.clone(), plane.location_moved_up(up_m).ok_or_else(none)?));
            }
        }
        wanted.fitted = Some(said.join(" "));
        // What was fitted to a body carries that body.
        wanted.made_for_kg = Some(mass_kg);
        wanted.again = true;
        let noted = || Some(Mass { kg: model.note.as_ref()?.contacts_mass_kg?, source: MassSource::Note });
        wanted.contacts_mass = self.masses.of_contacts(model).ok().map(|(mass, _)| mass).or_else(noted);
        Ok(wanted)
    }
}

impl Planner for Fitting {
    fn name(&self) -> &'static str {
        "fit"
    }

    fn inspection(&self) -> InspectionOptions {
        self.inspection.clone()
    }

    fn settings(&self) -> String {
        self.settings.clone()
    }

    fn reads(&self) -> Vec<PathBuf> {
        self.files.clone()
    }

    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        let selected = self.selection.apply(model)?;
        let (mass_kg, gravity_m_s2) = weight(&self.masses, model)?;
        let weight_n = mass_kg * gravity_m_s2;
        let seen: Vec<Seen> = self
            .trials
            .iter()
            .map(|trial| self.see(trial, model, &selected, weight_n))
            .collect::<Result<_, _>>()?;
        let trials: Vec<FitTrial> = seen.iter().map(|one| one.trial.clone()).collect();
        let of_no_foot = seen.iter().flat_map(|one| &one.of_no_foot).next();
        let fit = fit_motion(&trials, &self.bounds).map_err(|error| no_fit(&error, of_no_foot))?;
        let planes = seen.first().map(|one| one.planes.clone()).unwrap_or_default();
        let wanted = self.wanted(model, &selected, &fit, &planes, mass_kg)?;
        let mut plan = set(model, &selected, &wanted)?;
        let changed = plan.changed(model)?;
        // The floor of the model is that of the first trial.
        let after = match self.trials.first() {
            Some(trial) => Some(self.see(trial, &changed, &selected, weight_n)?),
            None => None,
        };
        let before = seen.first().map(|one| &one.summary);
        plan.errors = after.as_ref().map(|after| errors(&fit, &after.summary));
        let after = after.as_ref().map(|after| &after.summary);
        plan.remarks.extend(remarks(&fit, before, after, &self.bounds));
        Ok(plan)
    }
}

/// Why there is no fit, and what would help.
fn no_fit(error: &FitError, of_no_foot: Option<&String>) -> Fault {
    match (error, of_no_foot) {
        (FitError::NoForce, Some(plate)) => Fault::refused(format!(
            "nothing says which foot the force '{plate}' is under, so there is nothing to fit to: an ExternalLoads file says it"
        )),
        _ => Fault::refused(error.to_string()),
    }
}

fn errors(fit: &MotionFit, after: &Summary) -> RecordingErrors {
    let feet = || after.feet.iter().filter_map(|foot| foot.comparison.as_ref());
    let worst = |of: fn(&osim_motion::Comparison) -> f64| feet().map(of).fold(0.0, f64::max);
    RecordingErrors {
        vertical_rms_bw: worst(|one| one.normal_rms_n) / after.weight_n,
        held_out_vertical_rms_bw: fit.held_out_rms_bw(),
        horizontal_rms_bw: worst(|one| one.horizontal_rms_n) / after.weight_n,
        cop_rms_m: feet().filter_map(|one| one.cop_rms_m).reduce(f64::max),
        largest_relative_indentation: fit.after.largest_relative_indentation,
    }
}

/// The stiffness as one value where all forces have the same, else as a factor.
fn stiffness(model: &Model, selected: &Selected, factor: f64) -> Assignment {
    let forces = selected.forces.iter().filter_map(|&id| model.force(id));
    let values = forces.flat_map(|force| {
        force.sets.iter().filter_map(|set| force.checked(set.id, Property::Stiffness).ok().flatten())
    });
    let values: Vec<f64> = values.collect();
    match values.first() {
        Some(&first) if values.iter().all(|&value| value == first) => {
            Assignment::Value(rounded(first * factor))
        }
        _ => Assignment::Factor(rounded(factor)),
    }
}

/// With as many digits as a fit can give.
fn rounded(value: f64) -> f64 {
    format!("{value:.*e}", DIGITS - 1).parse().unwrap_or(value)
}
