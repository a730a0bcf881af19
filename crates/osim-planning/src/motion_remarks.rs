//! Remarks and a verdict on contacts along a motion.

use std::path::Path;

use osim_inspect::{ConsistencyRecord, describe_unmatched_patterns};
use osim_model::Finding;
use osim_model::files::Files;
use osim_model::messages::{Input, Phrase, Verb, counted, four_significant, listed, phrase, readable, shown};
use osim_motion::correct::{MotionVerdict, mismatches};
use osim_motion::{
    AngleUnit, AssignedBy, Comparison, FootSummary, LeftOutForces, Plate, PlateAssignment, PressureOnSole,
    SphereSummary, Summary, TOUCH_DOWN_BW,
};
use osim_requests::options::InspectionOptions;
use osim_requests::{CheckRequest, MotionRequest, RequestError, Result};

use crate::motion::FASTEST_STANDING_FOOT_M_S;
use crate::motion_consistency::{
    CORRECTED_ALREADY, MotionRemark, cause_in_words, horizontal_error, two_digits, unknown_foot,
};
use crate::{MotionResult, rules, run_motion};

/// If the mean force of the plates over whole strides differs from the model's weight by more than this (relative), plates and model do not
/// belong together.
const WEIGHT_TOLERANCE: f64 = 0.05;
/// No subject has less than this part of the weight of its model.
const LEAST_WEIGHT: f64 = 0.01;
/// Said of plates that are all assigned to one foot, although another foot is on one of them.
pub(crate) const PLATES_ON_ONE_FOOT: &str = "all plates are said to be under one foot, and another foot is on one of them: each force counts for the foot nearest to it";
/// If the centres of pressure of model and plates differ by more than this along the foot, m, a remark says so.
const DISPLACED_COP_M: f64 = 0.02;
/// The largest number of names that a remark lists.
const NAMES_LISTED: usize = 6;

impl MotionResult {
    /// The [`remarks`](Self::remarks) for `check` and `fit`, which report patterns that match nothing themselves.
    pub(crate) fn remarks_without_options(&self, request: &MotionRequest) -> Vec<MotionRemark> {
        let mut remarks = self.remarks(request);
        remarks.retain(|remark| remark.code != "unmatched-pattern");
        remarks
    }

    /// All remarks: a sentence for each foot, then remarks about the files and the model.
    pub fn remarks(&self, request: &MotionRequest) -> Vec<MotionRemark> {
        let mut remarks = RemarkList::default();
        if let (None, Some(measured)) = (&self.consistency, &self.measured) {
            let (feet, weight_n) = (self.feet(), self.summary.weight_n);
            let contacts = (&self.states, feet.as_slice());
            let seen = mismatches(&self.opened.model, &self.recording, contacts, measured, weight_n);
            let seen = seen.unwrap_or_default();
            if let Some(cause) = seen.iter().find(|cause| cause.prevents_comparison()) {
                remarks.add("disagree", cause_in_words(cause, &feet, 0.0));
            }
        }
        // What prevents a comparison is also why weights and centres of pressure differ.
        let judged = self.consistency.as_ref();
        let is_comparable = remarks.0.is_empty() && judged.is_none_or(|one| one.correction.is_some());
        let weight = weight_mismatch(&self.summary, self.mass_kg, self.gravity_m_s2);
        weight.filter(|_| is_comparable).into_iter().for_each(|text| remarks.add("subject-weight", text));
        remarks.0.extend(self.consistency.iter().flat_map(|one| one.remarks.clone()));
        for foot in &self.summary.feet {
            remarks.add("foot", self.foot_sentence(foot));
        }
        for (foot, on_sole) in self.summary.feet.iter().zip(&self.on_soles).filter(|_| is_comparable) {
            let apart_m = on_sole.as_ref().and_then(PressureOnSole::mean_difference_m);
            let name = self.name_of(foot);
            let text = apart_m.and_then(|[ahead_m, _]| displaced_centre_of_pressure(&name, ahead_m));
            text.into_iter().for_each(|text| remarks.add("centre-of-pressure", text));
        }
        let (selection, masses) = (request.choice.selection(), request.masses.request());
        for message in describe_unmatched_patterns(&selection, &masses, &self.opened.model) {
            remarks.add("unmatched-pattern", message);
        }
        self.add_recording_facts(&mut remarks);
        self.add_plate_facts(&mut remarks);
        remarks.0
    }

    /// The name of a foot; with a correction, the sentences before are about the corrected motion.
    fn name_of(&self, foot: &FootSummary) -> String {
        let when = if self.correction().is_some() { ", uncorrected" } else { "" };
        format!("{}{when}", foot.foot.name)
    }

    /// A sentence about the contacts of one foot.
    fn foot_sentence(&self, foot: &FootSummary) -> Phrase {
        let name = self.name_of(foot);
        let bw = |force_n: f64| two_digits(force_n / self.summary.weight_n);
        let deepest = two_digits(1e3 * foot.deepest_m.abs());
        if foot.deepest_m >= 0.0 && foot.peak_n <= 0.0 {
            let text = format!("{name}: it never pushes, although it is up to {deepest} mm inside the floor");
            return format!("{text}: it moves up faster than its dissipation allows").into();
        }
        if foot.deepest_m < 0.0 {
            let plate = foot.comparison.as_ref().filter(|plate| plate.measured_peak_n > 0.0);
            let measured = plate.map(|plate| bw(plate.measured_peak_n));
            let measured = measured.map(|bw| format!(", where the plates measured up to {bw} body weights"));
            let text =
                format!("{name}: it never touches: its lowest sphere stays {deepest} mm above the floor");
            return (text + &measured.unwrap_or_default()).into();
        }
        // If there are plates, only the frames count in which they measured.
        let peak_n = foot.comparison.as_ref().map_or(foot.peak_n, |plate| plate.peak_n);
        let mut text = format!("{name}: up to {} body weights", bw(peak_n));
        if let Some(plate) = &foot.comparison {
            text.push_str(&format!(" where the plates measured up to {}", bw(plate.measured_peak_n)));
        }
        if let Some(depth_m) = foot.stance_depth_m {
            let (mm, side) =
                (two_digits(1e3 * depth_m.abs()), if depth_m < 0.0 { "above" } else { "inside" });
            text.push_str(&format!("; in stance its deepest sphere is {mm} mm {side} the floor"));
            if let Some(radius_m) = self.deepest_radius_m(foot) {
                text.push_str(&format!(" (R {} mm)", two_digits(1e3 * radius_m)));
            }
        }
        let hardly = |plate: &Comparison| plate.measured_peak_n <= TOUCH_DOWN_BW * self.summary.weight_n;
        if foot.comparison.as_ref().is_some_and(hardly) {
            text.push_str(": hardly any step of it is on a plate");
        }
        text.into()
    }

    /// The radius of the sphere that goes deepest, among the spheres of the foot.
    fn deepest_radius_m(&self, foot: &FootSummary) -> Option<f64> {
        let depth = |sphere: &&SphereSummary| sphere.largest_relative_indentation;
        let deepest = foot.spheres.iter().max_by(|a, b| depth(a).total_cmp(&depth(b)))?;
        self.states.pairs.get(deepest.pair).map(|pair| pair.radius_m)
    }

    /// Adds remarks on how the recording was read, and on forces that OpenSim may leave out.
    fn add_recording_facts(&self, remarks: &mut RemarkList) {
        let facts = &self.recording.facts;
        let names = |names: &[String]| listed(names, NAMES_LISTED);
        if !facts.kept.is_empty() {
            let kept = names(&facts.kept);
            let text = format!("the motion has no column for {kept}: kept at the default of the model");
            remarks.add("kept-coordinates", text);
        }
        if !facts.outside.is_empty() {
            let text = format!("{}: outside the range in most frames;", names(&facts.outside));
            let text = text + " are the motion's signs and units those of this model?";
            remarks.add("outside-range", text);
        }
        if let Some((name, time_s)) = &facts.jump {
            let time = readable(*time_s);
            let text = format!("{name} jumps after {time} s: by a full turn, or are rows filled with 0?");
            remarks.add("jump", text);
        }
        if !facts.unused.is_empty() {
            let text = format!("columns that belong to no coordinate of the model: {}", names(&facts.unused));
            remarks.add("unused-columns", text);
        }
        if !facts.declared {
            let unit = if facts.angles == AngleUnit::Degrees { "degrees" } else { "radians" };
            let text = "the header does not say the unit of angles; they are taken for";
            remarks.add("undeclared-angles", format!("{text} {unit}, as OpenSim does"));
        }
        if let Some(belt_m_s) = self.found_belt_m_s {
            let speed = format!("{:.2}", belt_m_s.length());
            let text = phrase![
                "standing feet move at {} m/s, as on a treadmill: slip and lost energy are against a belt at this speed, \
                as with {}";
                speed.clone(), Input::Belt.with_value(speed)
            ];
            remarks.add("treadmill", text);
        }
        let against_belt_m_s = self.standing_m_s().length();
        if self.belt.is_some() && against_belt_m_s >= FASTEST_STANDING_FOOT_M_S {
            let text = format!("standing feet move at {against_belt_m_s:.2} m/s against the belt:");
            remarks.add("belt-unlike-feet", format!("{text} is its speed, in m/s against x, right?"));
        }
        remarks.add_repeated_rows(&self.motion.to_string(), &self.repeated_rows);
        if let Some(left_out) = LeftOutForces::of(&self.states) {
            let text = format!(
                "in {} frames a sphere of a HuntCrossleyForce leaves the floor so fast that it would pull. OpenSim may then leave out \
                 other spheres of the same force, which push with up to {} N; here they count. One force for each sphere avoids it: ",
                left_out.frames,
                two_digits(left_out.most_n)
            );
            remarks.add("left-out-by-opensim", phrase![text, Verb::Convert.call_with_model()]);
        }
        for constraint in &facts.unenforced {
            remarks.add("constraint", format!("not enforced here: {constraint}"));
        }
        for joint in &self.states.loops {
            let text = format!("joint {joint} closes a loop of joints, which nothing keeps closed here");
            remarks.add("loop", text);
        }
    }

    /// Adds remarks on the force plates and on the feet that they measured.
    fn add_plate_facts(&self, remarks: &mut RemarkList) {
        let Some((read, measured)) = self.plates.as_ref().zip(self.measured.as_ref()) else { return };
        if let Some(other) = &read.other_data_file {
            let given = read.file.display();
            let text =
                format!("the ExternalLoads name '{other}' as their data; what was given is read: {given}");
            remarks.add("other-data-file", text);
        }
        if let Some(gaps) = read.gaps_during(&self.recording.time_s) {
            remarks.add("gaps-in-plates", gaps);
        }
        let names = self.summary.feet.iter().map(|foot| &foot.foot.name);
        for (name, frames) in names.zip(&measured.beside).filter(|(_, frames)| **frames > 0) {
            let text =
                format!("{name}: in {frames} frames it seems to stand beside the plates: it is as low and");
            let why = "as still as a foot on them, but no force is measured. These frames are not compared";
            remarks.add("beside-plates", format!("{text} {why}"));
        }
        let lost = |one: &&PlateAssignment| one.by.is_none();
        for plate in measured.uses.iter().filter(lost) {
            remarks.add("plate-of-no-foot", unknown_foot(&plate.plate, "it counts only in the total"));
        }
        if measured.uses.iter().any(|plate| plate.by == Some(AssignedBy::NearestOfAll)) {
            remarks.add("plates-on-one-foot", PLATES_ON_ONE_FOOT);
        }
        let is_unmeasured = |foot: &&FootSummary| {
            foot.comparison.is_none() && !measured.uses.iter().any(|plate| plate.by.is_none())
        };
        for foot in self.summary.feet.iter().filter(is_unmeasured) {
            let text = "its force is not known, and is not compared: no plate is under it";
            remarks.add("foot-without-plate", format!("{}: {text}", foot.foot.name));
        }
        let name = read.file.file_name().unwrap_or_default().to_string_lossy();
        remarks.add_repeated_rows(&name, &read.repeated_rows);
        let has_no_points =
            |(plate, one): (&Plate, &PlateAssignment)| !plate.has_points && one.by != Some(AssignedBy::Idle);
        if read.plates.iter().zip(&measured.uses).any(has_no_points) {
            let text = "the plates' points are all 0 or missing: their centre of pressure is not known";
            remarks.add("no-centre-of-pressure", text);
        }
    }
}

/// The remarks about a motion, in the order in which they are shown.
#[derive(Default)]
struct RemarkList(Vec<MotionRemark>);

impl RemarkList {
    fn add(&mut self, code: &'static str, message: impl Into<Phrase>) {
        self.0.push(MotionRemark { code, message: message.into() });
    }

    /// Adds a remark if rows of a file were left out, because they repeat the row before them.
    fn add_repeated_rows(&mut self, file: &str, lines: &[usize]) {
        let Some(first) = lines.first() else { return };
        let (file, rows) = (shown(file), counted(lines.len(), "row"));
        let text = format!("{file}: {rows} left out, equal to the row before (first: line {first})");
        self.add("repeated-rows", text);
    }
}

/// A remark if the mean force of the plates over whole strides differs from the model's weight.
pub(crate) fn weight_mismatch(summary: &Summary, mass_kg: f64, gravity_m_s2: f64) -> Option<String> {
    let mean_n = summary.measured_stride_mean_n?;
    let part = mean_n / summary.weight_n;
    let (part_said, model, subject) =
        (two_digits(part), readable(mass_kg), four_significant(mean_n / gravity_m_s2));
    let text = format!("over whole strides the plates measured {part_said} of the model's weight:");
    let missing = if part < 1.0 { ", unless a plate is missing" } else { "" };
    let text = format!("{text} the model weighs {model} kg, and the subject {subject} kg{missing}");
    (part > LEAST_WEIGHT && (part - 1.0).abs() > WEIGHT_TOLERANCE).then_some(text)
}

/// A remark if the model's centre of pressure is nearer to the toes, or to the heel, than the centre of pressure of the plates.
fn displaced_centre_of_pressure(foot: &str, ahead_m: f64) -> Option<String> {
    let side = if ahead_m < 0.0 { "heel" } else { "toes" };
    let mm = two_digits(1e3 * ahead_m.abs());
    let text = format!("{foot}: its centre of pressure is on average {mm} mm nearer to the {side} than that");
    (ahead_m.abs() > DISPLACED_COP_M).then(|| text + " of the plates")
}

/// The recording with which `check` compares the contacts.
#[derive(Debug, Clone)]
pub(crate) struct CheckedMotion(MotionRequest);

impl CheckedMotion {
    /// The recording that the request names; `None` if it names none.
    pub(crate) fn of(request: &CheckRequest) -> Option<Self> {
        request.motion.as_ref()?;
        let InspectionOptions { masses, choice, set_files, .. } = request.options.clone();
        Some(Self(MotionRequest {
            motion: request.motion.clone(),
            plates: request.plates.clone(),
            loads: request.loads.clone(),
            angles: request.angles,
            masses,
            choice,
            set_files,
            ..MotionRequest::default()
        }))
    }

    /// Computes the contacts of the model at `path` along the recording.
    pub(crate) fn follow(&self, path: &Path, files: &dyn Files) -> Result<(MotionResult, Vec<MotionRemark>)> {
        let request = MotionRequest { subject: Some(path.to_owned()), ..self.0.clone() };
        let result = run_motion(&request, files)?;
        let remarks = result.remarks_without_options(&request);
        Ok((result, remarks))
    }

    /// Whether the contacts of the model at `path` fit the recording: a sentence if they fit, a finding if not, or the reason why it is not
    /// known. With it a finding about horizontal forces, if there is one, and the figures of the correction.
    pub(crate) fn answer(&self, path: &Path, files: &dyn Files) -> RecordingAnswer {
        let mut weight = None;
        let judged = match self.follow(path, files) {
            Ok((result, _)) if result.is_corrected => Err(CORRECTED_ALREADY.into()),
            Ok((result, _)) => {
                weight = weight_mismatch(&result.summary, result.mass_kg, result.gravity_m_s2);
                result.judge(&MotionRequest::default()).map_err(Phrase::from)
            }
            Err(RequestError::Failure(failure)) => {
                Err(phrase![failure.model.to_string(), ": ", &failure.message])
            }
            Err(RequestError::Fault(fault)) => Err(fault.phrase()),
        };
        let correction = judged.as_ref().ok().and_then(|judged| judged.correction.as_ref());
        let horizontal = correction.and_then(|one| horizontal_error(&one.figures, false));
        let remark = horizontal.map(|text| Finding::new(&rules::HORIZONTAL_ERROR, text));
        let weight = weight.filter(|_| correction.is_some()).map(|text| text + "; ").unwrap_or_default();
        let record = judged.as_ref().ok().map(|judged| judged.record(judged.why.to_string()));
        let answer = judged.map(|judged| match (judged.verdict, phrase![weight, &judged.why]) {
            (MotionVerdict::Agree, why) => Ok(why),
            (MotionVerdict::LargeCorrection, why) => Err(Finding::new(&rules::LARGE_CORRECTION, why)),
            (_, why) => Err(Finding::new(&rules::UNLIKE_RECORDING, why)),
        });
        (answer, remark, record)
    }
}

type RecordingAnswer = (Result<Result<Phrase, Finding>, Phrase>, Option<Finding>, Option<ConsistencyRecord>);
