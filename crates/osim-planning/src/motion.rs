//! Computes the forces of contacts along a recorded motion, and compares them with force plates. Finds the velocity
//! of a treadmill's belt if nobody gave it.

use std::path::{Path, PathBuf};

use osim_model::files::{Failure, FileName, Files, OpenModel};
use osim_model::messages::{Input, Phrase, phrase, readable, shown};
use osim_model::{DVec3, Fault, MassRequest, Model};
use osim_motion::correct::Correction;
use osim_motion::{
    AngleUnit, Belt, ContactStates, ExternalLoads, Foot, Gap, LONGEST_BRIDGED_GAP_S, MeasuredForces,
    MotionFault, Plate, PressureOnSole, Recording, RecordingOptions, StatesError, Summary, Table, gaps,
};
use osim_requests::{AngleChoice, CheckRequest, MotionRequest, Positive, RequestFault, Result, Signed};

use crate::motion_consistency::{Consistency, correction_options};
use crate::opening::{open_with, read};

/// The contacts of a model along a recorded motion, compared with force plates if the request has some.
pub struct MotionResult {
    pub opened: OpenModel,
    pub motion: FileName,
    /// The coordinates of the model in each frame.
    pub recording: Recording,
    /// The state of each sphere on each plane in each frame.
    pub states: ContactStates,
    pub plates: Option<PlatesRead>,
    pub measured: Option<MeasuredForces>,
    pub summary: Summary,
    /// The centre of pressure on the sole of each foot; `None` where the default pose is not known.
    pub on_soles: Vec<Option<PressureOnSole>>,
    /// Mass of the model, kg.
    pub mass_kg: f64,
    pub gravity_m_s2: f64,
    /// The motion of the treadmill's belt; `None` without a treadmill.
    pub belt: Option<Belt>,
    /// Whether the motion was corrected to contacts.
    pub is_corrected: bool,
    /// The lines of rows of the motion that were left out, because they repeat the row before them.
    pub repeated_rows: Vec<usize>,
    /// Whether motion, contacts and plates agree, if the request wants a corrected motion.
    pub consistency: Option<Consistency>,
    /// The velocity of a treadmill's belt that nobody gave, m/s: slip and lost energy are against it.
    pub found_belt_m_s: Option<DVec3>,
}

/// If loaded feet are faster than this, m/s, they stand on a belt.
pub(crate) const FASTEST_STANDING_FOOT_M_S: f64 = 0.4;

/// The floor of a trial is at most this much higher or lower than in the model, m.
const MOST_FLOOR_UP_M: f64 = 1.0;

/// Computes the contacts along the motion.
///
/// # Errors
/// A file that cannot be read, a motion of another model, or a model whose pose is not known.
pub fn run_motion(request: &MotionRequest, files: &dyn Files) -> Result<MotionResult> {
    let subject = request.subject.as_ref().ok_or(RequestFault::Missing { field: "subject" })?;
    let opened = open_with(subject, request.set_files.companion_paths(), files)?;
    run_opened(request, opened, files)
}

/// As [`run_motion`], for a model that is open.
pub(crate) fn run_opened(
    request: &MotionRequest,
    opened: OpenModel,
    files: &dyn Files,
) -> Result<MotionResult> {
    let Some(motion) = &request.motion else { return Err(RequestFault::Missing { field: "motion" }.into()) };
    if request.floor.is_some_and(|up| up.get().abs() > MOST_FLOOR_UP_M) {
        let why = phrase![Input::Floor, " is in metres, and at most 1: is it in mm?"];
        return Err(RequestFault::refused(Input::Floor, why).into());
    }
    let options = recording_options(motion, request.angles, request.low_pass);
    let table = read_motion(motion, (request.start, request.end), files)?;
    let recording =
        Recording::of(&opened.model, &table, &options).map_err(|fault| failure(motion, &fault))?;
    let loads = request.loads.as_deref();
    let read_plates = |file: &PathBuf| PlatesRead::read(file, loads, request.plates_delay, files);
    let plates = request.plates.as_ref().map(read_plates).transpose()?;
    let (mass_kg, gravity_m_s2) =
        mass_and_gravity(&request.masses.request(), &opened.model).map_err(|fault| opened.failure(fault))?;
    let selected = request.choice.selection().apply(&opened.model).map_err(|fault| opened.failure(fault))?;
    let belt = belt_of_motion(motion, &table, request.belt, request.belt_column.as_deref())?;
    let states =
        ContactStates::of(&opened.model, &recording, &selected.forces, &belt.clone().unwrap_or_default())
            .map_err(|error| match error {
                StatesError::Motion(fault) => failure(motion, &fault),
                StatesError::Model(fault) => opened.failure(*fault),
                StatesError::Pose(fault) => opened.failure(Fault::refused(fault.to_string())),
            })?;
    refuse_states(&states, mass_kg * gravity_m_s2).map_err(|fault| opened.failure(fault))?;
    let feet = Foot::all(&opened.model, &states, &selected.forces);
    if feet.is_empty() {
        let fault =
            Fault::refused("no applied force presses a sphere on the ground: there is nothing to follow");
        return Err(opened.failure(fault).into());
    }
    let followed =
        FollowedMotion { recording, states, feet, mass_and_gravity: (mass_kg, gravity_m_s2), belt };
    let mut result = followed.compared_with_plates(opened, FileName::from(motion.as_path()), plates);
    if let (Some(read), Some(measured)) = (&result.plates, &result.measured)
        && measured.frames_with_data() == 0
    {
        let why = "it has no time in common with the motion";
        return Err(Failure::outside(read.file.as_path(), "motion", why).into());
    }
    let plates = result.plates.as_ref().zip(result.measured.as_ref());
    if let Some((read, what)) =
        plates.and_then(|(read, measured)| Some((read, unusable_force_of_plates(measured)?)))
    {
        let why = format!("it has {what}: correct the table");
        return Err(Failure::outside(read.file.as_path(), "motion", why).into());
    }
    (result.is_corrected, result.repeated_rows) = (table.corrected, table.repeated);
    if request.correct.is_some() {
        let judged = result.judge(request);
        result.consistency = Some(judged.map_err(|why| Failure::outside(motion.as_path(), "motion", why))?);
    }
    result.find_belt();
    Ok(result)
}

/// Reads a motion, without the rows before the first and after the second time of `window`.
///
/// # Errors
/// It cannot be read, or no row remains.
pub(crate) fn read_motion(
    path: &Path,
    (start, end): (Option<Signed>, Option<Signed>),
    files: &dyn Files,
) -> Result<Table, Failure> {
    let mut table = read_table(path, files)?;
    table.keep_window(start.map_or(f64::NEG_INFINITY, Signed::get), end.map_or(f64::INFINITY, Signed::get));
    let why = "it has no row between the times of the start and of the end that are wanted";
    if table.rows() > 0 { Ok(table) } else { Err(Failure::outside(path, "motion", why)) }
}

/// The contacts along a motion, before they are compared with force plates.
pub(crate) struct FollowedMotion {
    pub(crate) recording: Recording,
    pub(crate) states: ContactStates,
    pub(crate) feet: Vec<Foot>,
    /// Mass of the model, kg, and its gravity, m/s².
    pub(crate) mass_and_gravity: (f64, f64),
    pub(crate) belt: Option<Belt>,
}

impl MotionResult {
    /// The correction of the motion, if the request wants one, and it is possible.
    pub fn correction(&self) -> Option<&Correction> {
        self.consistency.as_ref()?.correction.as_ref()
    }

    pub(crate) fn feet(&self) -> Vec<Foot> {
        self.summary.feet.iter().map(|foot| foot.foot.clone()).collect()
    }

    /// The mean velocity of standing feet along the floor, m/s.
    pub(crate) fn standing_m_s(&self) -> DVec3 {
        let slips: Vec<DVec3> = self.summary.feet.iter().filter_map(|foot| foot.stance_slip_m_s).collect();
        slips.iter().sum::<DVec3>() / slips.len().max(1) as f64
    }

    /// Finds the velocity of the belt, if nobody gave it, and computes slip and lost energy against it.
    fn find_belt(&mut self) {
        let standing_m_s = self.correction().map_or_else(|| self.standing_m_s(), |one| one.belt_m_s);
        let moves = standing_m_s.length() >= FASTEST_STANDING_FOOT_M_S;
        self.found_belt_m_s = (self.belt.is_none() && moves).then_some(standing_m_s);
        let Some(belt_m_s) = self.found_belt_m_s else { return };
        let belt = Belt::Constant(belt_m_s);
        let Ok(states) = self.states.along(&self.opened.model, &self.recording, &belt) else { return };
        let feet = self.feet();
        let on_belt = Summary::of(&states, &feet, self.measured.as_ref(), self.summary.weight_n);
        for (foot, on_belt) in self.summary.feet.iter_mut().zip(on_belt.feet) {
            foot.lost_in_stride_j = on_belt.lost_in_stride_j;
            let spheres = foot.spheres.iter_mut().zip(on_belt.spheres);
            spheres.for_each(|(sphere, on_belt)| sphere.slip_m_s = on_belt.slip_m_s);
        }
    }

    /// Corrects the motion and judges the correction.
    ///
    /// # Errors
    /// Why nothing can be judged.
    pub(crate) fn judge(&self, request: &MotionRequest) -> Result<Consistency, String> {
        let measured = self.measured.as_ref().ok_or("there are no force plates to compare with")?;
        let feet = self.feet();
        let options = correction_options(request, self.belt.clone(), self.standing_m_s());
        let (contacts, plates) = ((&self.states, feet.as_slice()), (measured, self.summary.weight_n));
        let known = (self.is_corrected, request, self.on_soles.as_slice());
        Consistency::of(&self.opened.model, &self.recording, contacts, plates, &options, known)
    }
}

impl FollowedMotion {
    /// Compares the contacts with `plates`, if there are any.
    pub(crate) fn compared_with_plates(
        self,
        opened: OpenModel,
        motion: FileName,
        plates: Option<PlatesRead>,
    ) -> MotionResult {
        let Self { recording, states, feet, mass_and_gravity: (mass_kg, gravity_m_s2), belt } = self;
        let weight_n = mass_kg * gravity_m_s2;
        let measured = plates.as_ref().map(|read| MeasuredForces::of(&read.plates, &feet, &states, weight_n));
        let summary = Summary::of(&states, &feet, measured.as_ref(), weight_n);
        let with_plates = summary.feet.iter().enumerate().map(|(index, foot)| {
            let plates = measured.as_ref().filter(|measured| measured.has_points.get(index) == Some(&true));
            (foot, plates.and_then(|measured| measured.feet.get(index)).map(Vec::as_slice))
        });
        MotionResult {
            on_soles: PressureOnSole::all(&opened.model, &states, with_plates, weight_n),
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
            is_corrected: false,
            repeated_rows: Vec::new(),
            consistency: None,
            found_belt_m_s: None,
        }
    }
}

/// The mass of `model`, kg, and its gravity, m/s².
///
/// # Errors
/// No mass, or no gravity.
pub(crate) fn mass_and_gravity(masses: &MassRequest, model: &Model) -> Result<(f64, f64), Fault> {
    let mass = masses.model_mass(model)?;
    let gravity = model.gravity().filter(|&gravity| gravity > 0.0);
    let needed =
        || Fault::refused("the model has no gravity, so that there is no body weight to compare forces with");
    Ok((mass.kg, gravity.ok_or_else(needed)?))
}

// Force plates as files have them.

/// The force plates that were read from the files of a request.
#[derive(Debug, Clone)]
pub struct PlatesRead {
    /// The file of the table with the forces of the plates.
    pub file: PathBuf,
    /// The ExternalLoads file that names the columns of the plate's table.
    pub loads: Option<PathBuf>,
    /// The data file that the ExternalLoads file names, if this name differs from the name of the table.
    pub other_data_file: Option<String>,
    pub plates: Vec<Plate>,
    /// Intervals of time for which the table has no rows.
    pub gaps: Vec<Gap>,
    /// The lines of rows that were left out, because they repeat the row before them.
    pub repeated_rows: Vec<usize>,
}

impl PlatesRead {
    /// Reads the plates from the table `file`, which is late by `delay_s`. The ExternalLoads file at `loads` names its columns.
    ///
    /// # Errors
    /// A file that cannot be read, or columns that are not there.
    pub(crate) fn read(
        file: &Path,
        loads: Option<&Path>,
        delay_s: Option<Signed>,
        files: &dyn Files,
    ) -> Result<Self, Failure> {
        let mut table = read_table(file, files)?;
        table.check_unit_of_time().map_err(|fault| failure(file, &fault))?;
        if let Some(delay_s) = delay_s {
            table.time_s.iter_mut().for_each(|time_s| *time_s -= delay_s.get());
        }
        let (gaps, repeated_rows) = (gaps(&table.time_s), std::mem::take(&mut table.repeated));
        let file = file.to_owned();
        let Some(path) = loads else {
            let plates = Plate::from_columns(&table).map_err(|fault| failure(&file, &fault))?;
            return Ok(Self { file, loads: None, other_data_file: None, plates, gaps, repeated_rows });
        };
        let loads = read_loads(path, files)?;
        // A fault with a line is one of the table.
        let place = |fault: &MotionFault| if fault.line.is_some() { file.as_path() } else { path };
        let plates = Plate::from_loads(&table, &loads).map_err(|fault| failure(place(&fault), &fault))?;
        let own_name = file.file_name().map(|name| name.to_string_lossy().into_owned());
        let other_data_file =
            loads.data_file_name().map(str::to_owned).filter(|named| Some(named) != own_name.as_ref());
        Ok(Self { file, loads: Some(path.to_owned()), other_data_file, plates, gaps, repeated_rows })
    }

    /// A remark about missing rows between the first and the last of the times `time_s`; `None` if no rows are missing.
    pub(crate) fn gaps_during(&self, time_s: &[f64]) -> Option<String> {
        let (first, last) = (time_s.first()?, time_s.last()?);
        let during = || self.gaps.iter().filter(|gap| gap.from_s < *last && gap.to_s > *first);
        let longest = during().max_by(|a, b| a.length_s().total_cmp(&b.length_s()))?;
        let count = match during().count() {
            1 => "1 gap".to_owned(),
            count => format!("{count} gaps, the longest"),
        };
        let name = self.file.file_name().unwrap_or_default().to_string_lossy();
        let (file, from, to) = (shown(&name), readable(longest.from_s), readable(longest.to_s));
        let text = match longest.length_s() > LONGEST_BRIDGED_GAP_S {
            true => "in gaps above 50 ms no force is known",
            false => "the measured forces are taken along straight lines there",
        };
        Some(format!("{file}: rows are missing in {count} from {from} to {to} s; {text}"))
    }
}

// Tables over time, through whatever holds the files.

/// Reads the table at `path`.
///
/// # Errors
/// It cannot be read, with the line.
pub(crate) fn read_table(path: &Path, files: &dyn Files) -> Result<Table, Failure> {
    Table::read(&read(path, files)?).map_err(|fault| failure(path, &fault))
}

fn read_loads(path: &Path, files: &dyn Files) -> Result<ExternalLoads, Failure> {
    ExternalLoads::read(&read(path, files)?).map_err(|fault| failure(path, &fault))
}

/// Why a file of the recording that a check names cannot be read; `None` if all can. Pipes are read once, by the check itself.
pub fn unreadable_recording(request: &CheckRequest, files: &dyn Files) -> Option<Failure> {
    let is_pipe = |path: &Path| path.exists() && !path.is_file() && !path.is_dir();
    let is_file = |path: &&PathBuf| path.as_os_str() != "-" && !is_pipe(path);
    let motion = request.motion.as_ref().filter(is_file).and_then(|path| read_table(path, files).err());
    let loads = request.loads.as_ref();
    let are_files = |plates: &&PathBuf| is_file(plates) && loads.is_none_or(|loads| is_file(&loads));
    let plates = request.plates.as_ref().filter(are_files);
    motion.or_else(|| PlatesRead::read(plates?, loads.map(PathBuf::as_path), None, files).err())
}

/// The failure for a fault in a motion file, with its line.
fn failure(path: &Path, fault: &MotionFault) -> Failure {
    let place = fault.line.map(|line| format!("line {line}: ")).unwrap_or_default();
    let text = format!("{place}{}", fault.message);
    // Only the text of the program has templates: the fault may quote the file.
    let mut message = if fault.line.is_some() { Phrase::from(text) } else { Phrase::template(&text) };
    if fault.needs_angles {
        message.push(&phrase![
            ": give {} or {}";
            Input::Angles.with_value("degrees"), Input::Angles.with_value("radians")
        ]);
    }
    let mut failure = Failure::outside(path, "motion", message);
    (failure.line, failure.needs_answer) = (fault.line, fault.needs_angles);
    failure
}

/// The treadmill's belt under the feet of the motion at `path`, if the caller gave its speed or named a column of `table`.
///
/// # Errors
/// No such column.
pub(crate) fn belt_of_motion(
    path: &Path,
    table: &Table,
    speed: Option<Signed>,
    column: Option<&str>,
) -> Result<Option<Belt>, Failure> {
    match (speed, column) {
        (Some(speed), _) => Ok(Some(Belt::against_x(speed.get()))),
        (None, Some(name)) => Belt::from_column(table, name).map(Some).map_err(|fault| failure(path, &fault)),
        (None, None) => Ok(None),
    }
}

pub(crate) fn recording_options(
    path: &Path,
    angles: Option<AngleChoice>,
    low_pass: Option<Positive>,
) -> RecordingOptions {
    RecordingOptions {
        angles: angles.map(|choice| match choice {
            AngleChoice::Degrees => AngleUnit::Degrees,
            _ => AngleUnit::Radians,
        }),
        undeclared: usual_unit_of_angles(path),
        low_pass_hz: low_pass.map(Positive::get),
    }
}

/// The unit that OpenSim assumes for angles in a file with this name, if the header of the file has no unit and no version.
fn usual_unit_of_angles(path: &Path) -> Option<AngleUnit> {
    let ending = path.extension()?.to_string_lossy().to_ascii_lowercase();
    match ending.as_str() {
        "mot" => Some(AngleUnit::Degrees),
        "sto" => Some(AngleUnit::Radians),
        _ => None,
    }
}

// Numbers so large or small that results calculated from them are not finite.

/// The largest value of a body that is accepted, in SI units. Squares of larger values are not finite.
const LARGEST_VALUE: f64 = 1e100;

/// Refuses contacts whose numbers are too large to compute with.
///
/// # Errors
///
/// A force, place or speed of a sphere, or the weight, is too large.
fn refuse_states(states: &ContactStates, weight_n: f64) -> Result<(), Fault> {
    if !(1.0 / LARGEST_VALUE..=LARGEST_VALUE).contains(&weight_n) {
        return Err(Fault::refused(format!(
            "the body weight is {weight_n:e} N: forces cannot be compared with that, correct mass and gravity of the model"
        )));
    }
    for (index, pair) in states.pairs.iter().enumerate() {
        for (state, time_s) in states.pair(index).zip(&states.time_s) {
            let depth = state.indentation_m / pair.radius_m;
            let sum = |vector: DVec3| vector.abs().element_sum();
            let sizes = [
                ("a force of", sum(state.force_n), "N"),
                ("x/R of", depth, ""),
                ("a speed of", state.slip_speed_m_s(), "m/s"),
                ("a centre at", sum(state.centre_m), "m"),
            ];
            if let Some((what, value, unit)) = sizes.into_iter().find(|(_, value, _)| !is_computable(*value))
            {
                let (radius_m, text) = (pair.radius_m, "correct what the model says of it");
                let fault =
                    format!("at {time_s} s a sphere of radius {radius_m:e} m has {what} {value:e} {unit}");
                return Err(Fault::refused(format!("{fault}: {text}")));
            }
        }
    }
    Ok(())
}

/// A force or a moment of the plates that is too large to compute with, in words; `None` if all can be used.
fn unusable_force_of_plates(measured: &MeasuredForces) -> Option<String> {
    let mut all = measured.total.iter().chain(measured.feet.iter().flatten()).flatten();
    all.find_map(|wrench| {
        let beyond = |vector: DVec3| vector.to_array().into_iter().find(|value| !is_computable(*value));
        let force = beyond(wrench.force_n).map(|force| format!("a force of {force:e} N"));
        force.or_else(|| Some(format!("a moment of {:e} N m about ground", beyond(wrench.moment_n_m)?)))
    })
}

/// Whether the square of a value is finite.
fn is_computable(value: f64) -> bool {
    value.abs() <= LARGEST_VALUE
}
