//! Remarks and a verdict on contacts along a motion.

use std::path::Path;

use osim_inspect::describe_unmatched_patterns;
use osim_model::files::Files;
use osim_model::messages::{Input, Phrase, Verb, four_significant, listed, phrase, readable};
use osim_model::{DVec3, Finding};
use osim_motion::{AngleUnit, FootSummary, LeftOutForces, ON_BW, PlateAssignment, PressureOnSole, Summary};
use osim_requests::options::InspectionOptions;
use osim_requests::{CheckRequest, MotionRequest, RequestError};

use crate::{MotionResult, rules, run_motion};

/// If the force differs from the force of the plates by a larger ratio, tuning the contacts cannot correct it.
const TUNABLE_RATIO: f64 = 1.5;
/// If the mean force of the plates over whole strides differs from the model's weight by more than this (relative), plates and model do not
/// belong together.
const WEIGHT_TOLERANCE: f64 = 0.05;
/// If feet in stance move over the floor faster than this, m/s, the person is probably on a treadmill.
const BELT_M_S: f64 = 0.3;
/// If the centres of pressure of model and plates differ by more than this along the foot, m, a remark says so.
const DISPLACED_COP_M: f64 = 0.02;
/// The largest number of names that a remark lists.
const NAMES_LISTED: usize = 6;

/// Something that a reader should know about a motion.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionRemark {
    /// Stable short name of the remark.
    pub code: &'static str,
    pub message: Phrase,
}

impl MotionResult {
    /// The [`remarks`](Self::remarks) for `check` and `fit`. Remarks about the treadmill are left out, because these verbs have no option
    /// for it, and so are remarks about patterns that match nothing, because these verbs report them themselves.
    pub(crate) fn remarks_without_options(&self, request: &MotionRequest) -> Vec<MotionRemark> {
        let mut remarks = self.remarks(request);
        remarks.retain(|remark| !["treadmill", "unmatched-pattern"].contains(&remark.code));
        remarks
    }

    /// All remarks: a sentence for each foot, then remarks about the files and the model.
    pub fn remarks(&self, request: &MotionRequest) -> Vec<MotionRemark> {
        let mut remarks = RemarkList::default();
        self.add_weight(&mut remarks);
        for foot in &self.summary.feet {
            remarks.add("foot", self.foot_sentence(foot));
        }
        for (foot, on_sole) in self.summary.feet.iter().zip(&self.on_soles) {
            let apart_m = on_sole.as_ref().and_then(PressureOnSole::mean_difference_m);
            if let Some(message) =
                apart_m.and_then(|[ahead_m, _]| displaced_centre_of_pressure(&foot.foot.name, ahead_m))
            {
                remarks.add("centre-of-pressure", message);
            }
        }
        let (selection, masses) = (request.choice.selection(), request.masses.request());
        for message in describe_unmatched_patterns(&selection, &masses, &self.opened.model) {
            remarks.add("unmatched-pattern", message);
        }
        self.add_treadmill(request, &mut remarks);
        self.add_recording_facts(&mut remarks);
        self.add_plate_facts(&mut remarks);
        remarks.0
    }

    fn add_weight(&self, remarks: &mut RemarkList) {
        if let Some(message) = weight_mismatch(&self.summary, self.mass_kg, self.gravity_m_s2) {
            remarks.add("subject-weight", message);
        }
    }

    fn foot_sentence(&self, foot: &FootSummary) -> Phrase {
        let name = &foot.foot.name;
        let bw = |force_n: f64| two_digits(force_n / self.summary.weight_n);
        if foot.deepest_m >= 0.0 && foot.peak_n <= 0.0 {
            return format!(
                "{name}: it never pushes, although it is up to {} mm inside the floor: it moves up faster than its dissipation allows",
                two_digits(1e3 * foot.deepest_m)
            )
            .into();
        }
        if foot.deepest_m < 0.0 {
            let above = -1e3 * foot.deepest_m;
            let plate = foot.comparison.as_ref().filter(|plate| plate.measured_peak_n > 0.0);
            let where_measured = plate.map(|plate| {
                format!(", where the plates measured up to {} body weights", bw(plate.measured_peak_n))
            });
            return format!(
                "{name}: it never touches: its lowest sphere stays {} mm above the floor{}",
                two_digits(above),
                where_measured.unwrap_or_default()
            )
            .into();
        }
        // If there are plates, only the frames count in which they measured.
        let peak_n = foot.comparison.as_ref().map_or(foot.peak_n, |plate| plate.peak_n);
        let mut text = format!("{name}: up to {} body weights", bw(peak_n));
        if let Some(plate) = &foot.comparison {
            text.push_str(&format!(" where the plates measured up to {}", bw(plate.measured_peak_n)));
        }
        if let Some(depth_m) = foot.stance_depth_m {
            let (mm, side) = (1e3 * depth_m.abs(), if depth_m < 0.0 { "above" } else { "inside" });
            text.push_str(&format!(
                "; in stance its deepest sphere is {} mm {side} the floor",
                two_digits(mm)
            ));
            if let Some(radius_m) = self.deepest_radius_m(foot) {
                text.push_str(&format!(" (R {} mm)", two_digits(1e3 * radius_m)));
            }
        }
        if let Some(plate) = &foot.comparison {
            let times = plate.peak_n / plate.measured_peak_n;
            if plate.measured_peak_n <= ON_BW * self.summary.weight_n {
                text.push_str(": hardly any step of it is on a plate");
            } else if times > TUNABLE_RATIO {
                text.push_str(": the floor is too high for this recording, or the contacts too stiff");
            } else if times < 1.0 / TUNABLE_RATIO {
                text.push_str(": the floor is too low for this recording, or the contacts too soft");
            }
        }
        text.into()
    }

    /// The radius of the sphere that goes deepest, among the spheres of the foot.
    fn deepest_radius_m(&self, foot: &FootSummary) -> Option<f64> {
        let by_depth = |pair: &usize| self.states.pairs.get(*pair).map(|pair| pair.radius_m);
        let deepest = foot
            .spheres
            .iter()
            .max_by(|a, b| a.largest_relative_indentation.total_cmp(&b.largest_relative_indentation))?;
        by_depth(&deepest.pair)
    }

    fn add_treadmill(&self, request: &MotionRequest, remarks: &mut RemarkList) {
        if request.belt.is_some() || request.belt_column.is_some() {
            return;
        }
        let slips: Vec<DVec3> = self.summary.feet.iter().filter_map(|foot| foot.stance_slip_m_s).collect();
        let Some(count) = Some(slips.len()).filter(|&count| count > 0) else { return };
        let mean = slips.iter().sum::<DVec3>() / count as f64;
        let speed = mean.length();
        if speed > BELT_M_S {
            remarks.add(
                "treadmill",
                phrase![
                    "in stance the feet move over the floor at {} m/s. On a treadmill, give {}, and slip is measured \
                    against the belt";
                    two_digits(speed).to_string(), Input::Belt.with_value(two_digits(-mean.x))
                ],
            );
        }
    }

    fn add_recording_facts(&self, remarks: &mut RemarkList) {
        let facts = &self.recording.facts;
        if !facts.kept.is_empty() {
            remarks.add(
                "kept-coordinates",
                format!(
                    "the motion has no column for {}: kept at the default of the model",
                    listed(&facts.kept, NAMES_LISTED)
                ),
            );
        }
        if !facts.unused.is_empty() {
            remarks.add(
                "unused-columns",
                format!(
                    "columns that belong to no coordinate of the model: {}",
                    listed(&facts.unused, NAMES_LISTED)
                ),
            );
        }
        if !facts.declared {
            let unit = match facts.angles {
                AngleUnit::Degrees => "degrees",
                AngleUnit::Radians => "radians",
            };
            remarks.add(
                "undeclared-angles",
                format!(
                    "the header does not say the unit of angles; they are taken for {unit}, as OpenSim does"
                ),
            );
        }
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
            remarks.add(
                "loop",
                format!("joint {joint} closes a loop of joints, which nothing keeps closed here"),
            );
        }
    }

    fn add_plate_facts(&self, remarks: &mut RemarkList) {
        let Some((read, measured)) = self.plates.as_ref().zip(self.measured.as_ref()) else { return };
        if let Some(other) = &read.other_data_file {
            remarks.add(
                "other-data-file",
                format!(
                    "the ExternalLoads name '{other}' as their data; what was given is read: {}",
                    read.file.display()
                ),
            );
        }
        if let Some(gaps) = read.gaps_during(&self.recording.time_s) {
            remarks.add("gaps-in-plates", gaps);
        }
        let names = self.summary.feet.iter().map(|foot| &foot.foot.name);
        for (name, frames) in names.zip(&measured.beside).filter(|(_, frames)| **frames > 0) {
            remarks.add(
                "beside-plates",
                format!(
                    "{name}: in {frames} frames it seems to stand beside the plates: it is as low and as still as on them, but no force is measured. These frames are not compared"
                ),
            );
        }
        let lost = |one: &&PlateAssignment| one.by.is_none();
        for plate in measured.uses.iter().filter(lost) {
            remarks.add("plate-of-no-foot", format!(
                "it is not known which foot the force '{}' acts on, so it counts only in the total: an ExternalLoads file says which",
                plate.plate
            ));
        }
        if read.plates.iter().any(|plate| !plate.has_points) {
            remarks.add(
                "no-centre-of-pressure",
                "the plates' points are all 0 or missing: their centre of pressure is not known".to_owned(),
            );
        }
    }
}

#[derive(Default)]
struct RemarkList(Vec<MotionRemark>);

impl RemarkList {
    fn add(&mut self, code: &'static str, message: impl Into<Phrase>) {
        self.0.push(MotionRemark { code, message: message.into() });
    }
}

/// A remark if the mean force of the plates over whole strides differs from the model's weight.
pub(crate) fn weight_mismatch(summary: &Summary, mass_kg: f64, gravity_m_s2: f64) -> Option<String> {
    let mean_n = summary.measured_stride_mean_n?;
    let part = mean_n / summary.weight_n;
    ((part - 1.0).abs() > WEIGHT_TOLERANCE).then(|| {
        format!(
            "over whole strides the plates measured {} of the model's weight: the model weighs {} kg, and the subject {} kg, \
             unless a plate is missing",
            two_digits(part),
            readable(mass_kg),
            four_significant(mean_n / gravity_m_s2)
        )
    })
}

/// A remark if the model's centre of pressure is nearer to the toes, or to the heel, than the centre of pressure of the plates.
fn displaced_centre_of_pressure(foot: &str, ahead_m: f64) -> Option<String> {
    let side = if ahead_m < 0.0 { "heel" } else { "toes" };
    (ahead_m.abs() > DISPLACED_COP_M).then(|| {
        format!(
            "{foot}: its centre of pressure is on average {} mm nearer to the {side} than that of the plates",
            two_digits(1e3 * ahead_m.abs())
        )
    })
}

/// The value with two significant digits, or with all digits before the decimal point.
fn two_digits(value: f64) -> String {
    let digits = if value.abs() >= 10.0 || value == 0.0 { 0 } else { 1 - value.abs().log10().floor() as i32 };
    format!("{value:.*}", usize::try_from(digits.clamp(0, 9)).unwrap_or(0))
}

/// Contacts fit a recording if the error is at most this, in body weights (root mean square per foot). Fits of three numbers reach this on
/// measured gaits.
const FITS_BW: f64 = 0.2;

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
    pub(crate) fn follow(
        &self,
        path: &Path,
        files: &dyn Files,
    ) -> Result<(MotionResult, Vec<MotionRemark>), RequestError> {
        let request = MotionRequest { subject: Some(path.to_owned()), ..self.0.clone() };
        let result = run_motion(&request, files)?;
        let remarks = result.remarks_without_options(&request);
        Ok((result, remarks))
    }

    /// Whether the contacts of the model at `path` fit the recording: a sentence if they fit, a finding if not, or the reason why it is not
    /// known.
    pub(crate) fn answer(&self, path: &Path, files: &dyn Files) -> Result<Result<Phrase, Finding>, Phrase> {
        match self.follow(path, files) {
            Ok((result, _)) => judge_fit(&result),
            Err(RequestError::Failure(failure)) => {
                Err(phrase![failure.model.to_string(), ": ", &failure.message])
            }
            Err(RequestError::Fault(fault)) => Err(fault.phrase()),
        }
    }
}

fn judge_fit(result: &MotionResult) -> Result<Result<Phrase, Finding>, Phrase> {
    let weight_n = result.summary.weight_n;
    let feet = result.summary.feet.iter();
    let compared: Vec<_> = feet.filter_map(|foot| Some((foot, foot.comparison.as_ref()?))).collect();
    let worst = compared.iter().max_by(|a, b| a.1.normal_rms_n.total_cmp(&b.1.normal_rms_n));
    let (foot, worst) = worst.ok_or("no plate measured a force under a foot during the recording")?;
    let rms: Vec<String> = compared
        .iter()
        .map(|(foot, one)| format!("{} {:.2}", foot.foot.name, one.normal_rms_n / weight_n))
        .collect();
    let rms = format!("errors of the force in body weights (rms): {}", rms.join(", "));
    if worst.normal_rms_n / weight_n <= FITS_BW {
        return Ok(Ok(Phrase::from(rms)));
    }
    let call = Verb::Fit
        .call_with_model()
        .with_placeholder(Input::Motion, "MOTION")
        .with_placeholder(Input::Plates, "PLATES");
    let text = phrase![
        "{}: up to {} body weights where the plates measured up to {}; {rms}. {} finds what would fit";
        foot.foot.name.to_string(), format!("{:.2}", worst.peak_n / weight_n),
        format!("{:.2}", worst.measured_peak_n / weight_n), call
    ];
    Ok(Err(rules::unlike_recording(text)))
}
