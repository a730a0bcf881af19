//! The verb `fit` with recordings: fits contacts to recorded gaits.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use osim_inspect::{ContactsOrigin, Figure, InspectOptions};
use osim_model::files::{FileName, Files, OpenModel};
use osim_model::messages::{Input, Phrase, Verb, phrase, shortest, shown};
use osim_model::{
    Assignment, Fault, FaultKind, HalfSpace, Mass, MassSource, Model, Property, Selected, SphereId,
    Suspicion, YesQuestion,
};
use osim_motion::correct::mismatches;
use osim_motion::fit::{FitBounds, FitError, FitTrial, FittedParameter, FootForces, MotionFit, fit_motion};
use osim_motion::{
    AssignedBy, Belt, ContactStates, Foot, FootSummary, MeasuredForces, Recording, RecordingOptions,
    StatesError, Summary, Table,
};
use osim_patch::{FittedFoot, FittedNumber, Plan, RecordingErrors, Set, set};
use osim_requests::options::{AnswerOptions, InspectionOptions};
use osim_requests::{FitRequest, FittedChoice, HeightChoice, MotionRequest, RequestFault, Result};

use super::fit_remarks::{parameter_in_words, remarks};
use crate::motion::{
    FollowedMotion, MotionResult, PlatesRead, belt_of_motion, mass_and_gravity, read_motion,
    recording_options,
};
use crate::motion_consistency::{MotionRemark, cause_in_words, unknown_foot};
use crate::motion_remarks::{PLATES_ON_ONE_FOOT, weight_mismatch};
use crate::prepared_change::{Planner, PreparedChange, file_name};

/// Number of significant digits of a fitted number that are written. More digits are not determined by the recordings.
const SIGNIFICANT_DIGITS: usize = 5;

/// The data in the files of one recording.
struct TrialInput {
    name: String,
    table: Table,
    options: RecordingOptions,
    plates: PlatesRead,
    belt: Belt,
}

/// Plans the contact parameters that fit recorded gaits.
struct FitPlanner {
    trials: Vec<TrialInput>,
    bounds: FitBounds,
    options: InspectOptions,
    answers: AnswerOptions,
}

/// Checks the request and reads the recordings.
///
/// # Errors
/// Files that are missing or do not go together.
pub(crate) fn prepare(request: FitRequest, files: &dyn Files) -> Result<PreparedChange> {
    let model = request.file.clone().ok_or(RequestFault::Missing { field: "file" })?;
    let (motions, plates, loads) = (&request.motion, &request.plates, &request.loads);
    if plates.len() != motions.len() || !(loads.len() <= 1 || loads.len() == motions.len()) {
        let why = phrase![
            "there are {} motions, {} tables of {} and {} of {}: give one table for each motion, in the same order, \
            and one ExternalLoads for each or for all";
            motions.len().to_string(), plates.len().to_string(), Input::Plates, loads.len().to_string(),
            Input::Loads
        ];
        return Err(RequestFault::refused(Input::Plates, why).into());
    }
    let mut trials = Vec::new();
    for (index, (motion, table_of_plates)) in motions.iter().zip(plates).enumerate() {
        let loads = loads.get(index).or(loads.first()).map(PathBuf::as_path);
        let table = read_motion(motion, (request.start, request.end), files)?;
        let belt = belt_of_motion(motion, &table, request.belt, request.belt_column.as_deref())?;
        trials.push(TrialInput {
            name: file_name(motion),
            belt: belt.unwrap_or_default(),
            table,
            options: recording_options(motion, request.angles, request.low_pass),
            plates: PlatesRead::read(table_of_plates, loads, request.plates_delay, files)?,
        });
    }
    let extra_files = motions.iter().chain(plates).chain(loads).cloned().collect();
    let is_wanted = |choice| request.fit.is_empty() || request.fit.contains(&choice);
    let bounds = FitBounds {
        stiffness: is_wanted(FittedChoice::Stiffness),
        dissipation: is_wanted(FittedChoice::Dissipation),
        height: is_wanted(FittedChoice::Height),
        spheres_move: request.height_in == HeightChoice::Spheres,
        most_relative_indentation: (!request.unbounded).then_some(1.0),
    };
    if bounds.spheres_move && !bounds.height {
        let fit_it = Input::Fit.with_value("height");
        let why = phrase!["no height is fitted: leave out {}, or add {}"; Input::HeightIn, fit_it];
        return Err(RequestFault::refused(Input::HeightIn, why).into());
    }
    let FitRequest { masses, choice, output, answers, set_files, .. } = request;
    let inspection = InspectionOptions {
        masses,
        choice,
        set_files,
        answers: answers.clone(),
        ..InspectionOptions::default()
    };
    let planner = FitPlanner { trials, bounds, options: InspectOptions::from(&inspection), answers };
    Ok(PreparedChange {
        extra_files,
        ..PreparedChange::new(Verb::Fit, vec![model], output, inspection, planner)
    })
}

/// The contacts of a model along one recording, and the forces that the plates measured.
struct TrialStates {
    summary: Summary,
    trial: FitTrial,
    planes: Vec<HalfSpace>,
    measured: MeasuredForces,
}

impl FitPlanner {
    /// Computes the contacts of a model and its feet along a recording.
    fn follow_trial(
        &self,
        trial: &TrialInput,
        model: &Model,
        selected: &Selected,
    ) -> Result<(Recording, ContactStates, Vec<Foot>), Fault> {
        let recording = Recording::of(model, &trial.table, &trial.options)
            .map_err(|fault| Fault::refused(format!("{}: {}", trial.name, fault.message)))?;
        let states = ContactStates::of(model, &recording, &selected.forces, &trial.belt)
            .map_err(|error| fault_of_states(&trial.name, error))?;
        let feet = Foot::all(model, &states, &selected.forces);
        Ok((recording, states, feet))
    }

    /// The contacts of a model along one recording. `first` is the first recording of the fit.
    fn trial_states(
        &self,
        trial: &TrialInput,
        model: &Model,
        selected: &Selected,
        weight_n: f64,
        first: Option<&TrialStates>,
    ) -> Result<TrialStates, Fault> {
        let (recording, states, feet) = self.follow_trial(trial, model, selected)?;
        let measured = MeasuredForces::of(&trial.plates.plates, &feet, &states, weight_n);
        let seen = mismatches(model, &recording, (&states, &feet), &measured, weight_n)
            .map_err(|error| fault_of_states(&trial.name, error))?;
        if let Some(cause) = seen.iter().find(|cause| cause.prevents_comparison()) {
            let cause = cause_in_words(cause, &feet, 0.0);
            return Err(Fault::refused(format!("{}: {cause}", trial.name)));
        }
        let summary = Summary::of(&states, &feet, Some(&measured), weight_n);
        let (parts, can_move) = ((feet.as_slice(), &measured), self.bounds.spheres_move);
        let first = first.map(|first| &first.trial);
        let fitted = FitTrial::of(model, &recording, &states, parts, weight_n, can_move, first)
            .map_err(|error| fault_of_states(&trial.name, error))?;
        Ok(TrialStates { summary, trial: fitted, planes: states.planes, measured })
    }

    /// The new values of parameters and places of spheres after a fit.
    fn changes_of_fit(
        &self,
        model: &Model,
        selected: &Selected,
        fit: &MotionFit,
        states_of_trials: &[TrialStates],
        mass_kg: f64,
    ) -> Result<Set, Fault> {
        let mut assignments = Vec::new();
        let mut summary: Vec<String> = Vec::new();
        if let Some(factor) = &fit.stiffness_factor {
            let assignment = stiffness_assignment(model, selected, factor.value);
            summary.push(format!("stiffness={assignment}"));
            assignments.push((Property::Stiffness, assignment));
        }
        if let Some(dissipation) = &fit.dissipation {
            let assignment = Assignment::Value(with_significant_digits(dissipation.value));
            summary.push(format!("dissipation={assignment}"));
            assignments.push((Property::Dissipation, assignment));
        }
        let mut wanted = Set::new(assignments);
        // Each trial has a floor of its own. The model gets the floor of the first trial, unless spheres move instead.
        if let Some(up) = fit.floor_up_m.first().filter(|_| fit.spheres_down_m.is_none()) {
            let up_m = (up.value * 1e6).round() / 1e6;
            summary.push(format!("floor_up={}", shortest(up_m)));
            for plane in states_of_trials.first().into_iter().flat_map(|first| &first.planes) {
                if !plane.on_ground {
                    let (floor, body) = (&plane.name, plane.body.as_deref().unwrap_or_default());
                    let why = "only a floor on ground has a height that can be fitted";
                    return Err(Fault::refused(format!("the floor {floor} is on the body {body}: {why}")));
                }
                let none =
                    || Fault::refused(format!("the place of half-space {} cannot be read", plane.path));
                wanted.planes.push((plane.clone(), plane.location_moved_up(up_m).ok_or_else(none)?));
            }
        }
        if let Some(down) = &fit.spheres_down_m {
            wanted.centres = fitted_centres(model, states_of_trials, down.value)?;
            summary.push("spheres".to_owned());
        }
        wanted.fitted = Some(summary.join(" "));
        // Contacts are made for the body whose gait they were fitted to.
        wanted.made_for_kg = Some(mass_kg);
        wanted.repeat = true;
        let noted = || Some(Mass { kg: model.note.as_ref()?.contacts_mass_kg?, source: MassSource::Note });
        let origin =
            ContactsOrigin::find(model, &selected.forces, &self.options.masses, &self.options.stance);
        wanted.contacts_mass = origin.ok().map(|origin| origin.mass).or_else(noted);
        Ok(wanted)
    }

    /// A remark with the dimensionless numbers of the fitted contact, which do not change when it is rescaled.
    fn remark_on_dimensionless_numbers(&self, changed: &Model) -> Option<Phrase> {
        let inspected = self.options.inspect(FileName::from(Path::new("model")), changed, None);
        let sphere = inspected.figures.spheres().next()?;
        let depth = sphere.value(Figure::Indentation)?;
        let (stiffness, name) = (sphere.value(Figure::DimensionlessStiffness)?, shown(&sphere.sphere));
        let text = format!("in dimensionless form, at body weight on one limb: x/R {depth:.2} by Hertz");
        Some(format!("{text}, k R n/F {stiffness:.2} ({name}); rescaling keeps both at other sizes").into())
    }
}

impl Planner for FitPlanner {
    fn recording(&self, changed: OpenModel) -> Option<(MotionResult, Vec<MotionRemark>)> {
        let trial = self.trials.first()?;
        let selected = self.options.selection.apply(&changed.model).ok()?;
        let (recording, states, feet) = self.follow_trial(trial, &changed.model, &selected).ok()?;
        let mass_and_gravity = mass_and_gravity(&self.options.masses, &changed.model).ok()?;
        let followed =
            FollowedMotion { recording, states, feet, mass_and_gravity, belt: Some(trial.belt.clone()) };
        let name = FileName::from(Path::new(&trial.name));
        let result = followed.compared_with_plates(changed, name, Some(trial.plates.clone()));
        let remarks = result.remarks_without_options(&MotionRequest::default());
        Some((result, remarks))
    }

    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        let selected = self.options.selection.apply(model)?;
        let (mass_kg, gravity_m_s2) = mass_and_gravity(&self.options.masses, model)?;
        let weight_n = mass_kg * gravity_m_s2;
        let mut states_of_trials: Vec<TrialStates> = Vec::new();
        for trial in &self.trials {
            let states = self.trial_states(trial, model, &selected, weight_n, states_of_trials.first())?;
            states_of_trials.push(states);
        }
        let trials: Vec<FitTrial> = states_of_trials.iter().map(|one| one.trial.clone()).collect();
        let uses = || states_of_trials.iter().flat_map(|one| &one.measured.uses);
        let plate_of_no_foot = uses().find(|one| one.by.is_none()).map(|one| &one.plate);
        let fit =
            fit_motion(&trials, &self.bounds).map_err(|error| fault_of_fit(&error, plate_of_no_foot))?;
        let first = states_of_trials.first().ok_or_else(|| Fault::refused(FitError::NoForce.to_string()))?;
        let wanted = self.changes_of_fit(model, &selected, &fit, &states_of_trials, mass_kg)?;
        let mut plan = set(model, &selected, &wanted)?;
        let changed = plan.changed_model(model)?;
        // The measured forces of the first trial are those of the original, because they do not depend on the contacts.
        let (_, states, feet) = self.follow_trial(&self.trials[0], &changed, &selected)?;
        let after = Summary::of(&states, &feet, Some(&first.measured), weight_n);
        let errors = recording_errors(&fit, &trials, (&first.summary, &after))?;
        self.answers.require_yes(poor_fit(&fit, &errors)).map_err(Fault::new)?;
        // If spheres move, the floor of the first recording stays.
        let first_m = fit.spheres_down_m.as_ref().map(|_| 0.0);
        plan.floor_up_m = first_m.into_iter().chain(fit.floor_up_m.iter().map(|up| up.value)).collect();
        let others = match wanted.planes.is_empty() {
            true => Vec::new(),
            false => other_forces_on(model, &selected, &first.planes),
        };
        let subject =
            states_of_trials.iter().find_map(|one| weight_mismatch(&one.summary, mass_kg, gravity_m_s2));
        plan.remarks.extend(subject.map(Phrase::from));
        let are_on_one_foot = uses().any(|one| one.by == Some(AssignedBy::NearestOfAll));
        plan.remarks.extend(are_on_one_foot.then(|| Phrase::from(PLATES_ON_ONE_FOOT)));
        let gaps = self.trials.iter().filter_map(|trial| trial.plates.gaps_during(&trial.table.time_s));
        plan.remarks.extend(gaps.map(Phrase::from));
        let null_bw = errors.null_vertical_rms_bw;
        let null = format!("a model that never touches has an error of {null_bw:.3} body weights (rms)");
        plan.remarks.push(null.into());
        plan.remarks.extend(remarks(&fit, &trials, (&first.summary, &errors.feet), &self.bounds, &others));
        plan.remarks.extend(self.remark_on_dimensionless_numbers(&changed));
        plan.errors = Some(errors);
        Ok(plan)
    }
}

/// The question whether the caller wants a fit that is hardly better than no contact, or worse than before.
fn poor_fit(fit: &MotionFit, errors: &RecordingErrors) -> Option<Suspicion> {
    let RecordingErrors { vertical_rms_bw, null_vertical_rms_bw, .. } = errors;
    let (after, before) = (fit.after.vertical_rms_bw, fit.before.vertical_rms_bw);
    let text = match after > before {
        true => format!(
            "the fitted model is off by {after:.3} body weights (rms), and the model as it is by {before:.3}"
        ),
        false => format!(
            "the worst foot of the fitted model is off by {vertical_rms_bw:.3} body weights (rms), and a model that never touches by \
             {null_vertical_rms_bw:.3}"
        ),
    };
    let correct = Verb::Motion.call_with_model().with_placeholder(Input::Correct, "FILE");
    let text = phrase![text, ": correct the motion instead, with ", correct];
    (after > before || *vertical_rms_bw > 0.5 * null_vertical_rms_bw)
        .then_some(Suspicion::Other { question: YesQuestion::PoorFit, text })
}

fn fault_of_states(trial: &str, error: StatesError) -> Fault {
    match error {
        StatesError::Model(fault) => *fault,
        other => Fault::refused(format!("{trial}: {other}")),
    }
}

/// Names of forces that are switched on, use one of the `planes`, and were not chosen.
fn other_forces_on(model: &Model, selected: &Selected, planes: &[HalfSpace]) -> Vec<String> {
    let others = model.forces().iter().filter(|force| force.applies && !selected.forces.contains(&force.id));
    let is_same = |one: &HalfSpace| planes.iter().any(|plane| plane.path == one.path);
    let on = |force: &&osim_model::Force| {
        force.sets.iter().any(|set| model.half_spaces_of(set).iter().any(is_same))
    };
    others.filter(on).map(|force| force.name.clone()).collect()
}

/// The fault that no fit was found, with advice.
fn fault_of_fit(error: &FitError, plate_of_no_foot: Option<&String>) -> Fault {
    match (error, plate_of_no_foot) {
        (FitError::NoForce, Some(plate)) => Fault::refused(unknown_foot(plate, "there is nothing to fit to")),
        (FitError::Undetermined(parameters), _) => {
            let ranges: Vec<String> = parameters.iter().map(parameter_in_words).collect();
            Fault::new(FaultKind::NothingDetermined { text: format!("{error} ({})", ranges.join("; ")) })
        }
        _ => Fault::refused(error.to_string()),
    }
}

/// The error of a model that never touches, of the foot with the smallest force, in body weights.
fn null_rms_bw(trials: &[FitTrial]) -> f64 {
    let feet = trials.iter().flat_map(|trial| trial.feet.iter().map(|foot| (foot, trial.weight_n)));
    let rms = |(foot, weight_n): (&FootForces, f64)| {
        let square: f64 = foot.measured_n.iter().map(|force_n| force_n * force_n).sum();
        (square / foot.measured_n.len().max(1) as f64).sqrt() / weight_n
    };
    feet.map(rms).fold(f64::INFINITY, f64::min)
}

/// The errors of the fitted model, compared with the plates. Refused if forces are not finite.
fn recording_errors(
    fit: &MotionFit,
    trials: &[FitTrial],
    (before, after): (&Summary, &Summary),
) -> Result<RecordingErrors, Fault> {
    let is_left_out = |name: &String| trials.iter().take(1).any(|one| one.without_force.contains(name));
    let bw = |force_n: f64| force_n / after.weight_n;
    let foot = |(old, new): (&FootSummary, &FootSummary)| {
        let (name, old, new) = (new.foot.name.clone(), old.comparison?, new.comparison?);
        (!is_left_out(&name)).then(|| FittedFoot {
            name,
            vertical_rms_bw: bw(new.normal_rms_n),
            vertical_rms_before_bw: bw(old.normal_rms_n),
            horizontal_rms_bw: bw(new.horizontal_rms_n),
            cop_rms_m: new.cop_rms_m,
            peak_bw: bw(new.peak_n),
            measured_peak_bw: bw(new.measured_peak_n),
        })
    };
    let feet: Vec<FittedFoot> = before.feet.iter().zip(&after.feet).filter_map(foot).collect();
    let number = |one: &FittedParameter| FittedNumber {
        name: one.name.clone(),
        value: one.value,
        nearly_as_good: one.nearly_as_good,
        at_bound: one.at_bound,
        is_written: one.is_written,
    };
    let contact = fit.stiffness_factor.iter().chain(&fit.dissipation).chain(&fit.spheres_down_m);
    let largest = |a: f64, b: f64| if a.is_nan() || a > b { a } else { b };
    let worst = |of: fn(&FittedFoot) -> f64| feet.iter().map(of).fold(0.0, largest);
    let others = fit.trials_rms_bw.iter().skip(1).copied().fold(0.0, largest);
    let vertical_rms_bw = largest(worst(|one| one.vertical_rms_bw), others);
    let horizontal_rms_bw = worst(|one| one.horizontal_rms_bw);
    if !(vertical_rms_bw.is_finite() && horizontal_rms_bw.is_finite()) {
        return Err(Fault::refused("with these options the forces of the fitted model are not finite"));
    }
    Ok(RecordingErrors {
        vertical_rms_bw,
        held_out_vertical_rms_bw: fit.held_out.iter().map(|one| one.vertical_rms_bw).reduce(f64::max),
        null_vertical_rms_bw: null_rms_bw(trials),
        horizontal_rms_bw,
        cop_rms_m: feet.iter().filter_map(|one| one.cop_rms_m).reduce(f64::max),
        largest_relative_indentation: fit.after.largest_relative_indentation,
        feet,
        parameters: contact.chain(&fit.floor_up_m).chain(&fit.undetermined).map(number).collect(),
        correlations: fit.correlations.clone(),
    })
}

/// The new centres of all fitted spheres in their own frames, m, rounded to micrometres.
fn fitted_centres(
    model: &Model,
    trials: &[TrialStates],
    down_m: f64,
) -> Result<Vec<(SphereId, [f64; 3])>, Fault> {
    let is_fitted =
        |id: &SphereId| trials.iter().flat_map(|one| &one.trial.feet).any(|foot| foot.spheres.contains(id));
    let directions: BTreeMap<_, _> =
        trials.iter().take(1).flat_map(|first| first.trial.down.iter().copied()).collect();
    let mut centres = Vec::new();
    for (id, down) in directions.into_iter().filter(|(id, _)| is_fitted(id)) {
        let Some(sphere) = model.sphere(id) else { continue };
        let by_m = model.rotation_of(sphere)?.inverse().to_body(down_m * down);
        let rounded = |metres: f64| (metres * 1e6).round() / 1e6;
        // A coordinate that does not change keeps all its digits.
        let moved = |at_m: f64, by_m: f64| if rounded(by_m) == 0.0 { at_m } else { rounded(at_m + by_m) };
        centres.push((id, std::array::from_fn(|axis| moved(sphere.location_m[axis], by_m[axis]))));
    }
    Ok(centres)
}

/// The change of stiffness: a new value if all forces have the same stiffness, else a factor.
fn stiffness_assignment(model: &Model, selected: &Selected, factor: f64) -> Assignment {
    let forces = selected.forces.iter().filter_map(|&id| model.force(id));
    let values = forces.flat_map(|force| {
        force.sets.iter().filter_map(|set| force.checked(set.id, Property::Stiffness).ok().flatten())
    });
    let values: Vec<f64> = values.collect();
    match values.first() {
        Some(&first) if values.iter().all(|&value| value == first) => {
            Assignment::Value(with_significant_digits(first * factor))
        }
        _ => Assignment::Factor(with_significant_digits(factor)),
    }
}

/// The value rounded to [`SIGNIFICANT_DIGITS`].
fn with_significant_digits(value: f64) -> f64 {
    format!("{value:.*e}", SIGNIFICANT_DIGITS - 1).parse().unwrap_or(value)
}
