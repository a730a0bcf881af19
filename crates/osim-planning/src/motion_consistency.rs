//! Whether a motion, the contacts of a model and force plates agree: by the least correction of the motion that makes them agree.

use osim_inspect::{
    ConsistencyRecord, CorrectedErrorRecord, JointMomentsRecord, ResidualRecord, RootResidualRecord,
};
use osim_model::messages::{Input, Phrase, Verb, listed, phrase, readable};
use osim_model::{DVec3, Model};
use osim_motion::correct::{
    Correction, CorrectionError, CorrectionFigures, CorrectionOptions, FootErrors, ForceErrors,
    InverseDynamics, Mismatch, MotionVerdict, RootResidual, correct, mismatches,
};
use osim_motion::{Belt, ContactStates, Foot, MeasuredForces, PressureOnSole, Recording, gaps};
use osim_requests::{MotionRequest, Signed};

/// Something that a reader should know about a motion.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionRemark {
    /// Stable short name of the remark.
    pub code: &'static str,
    pub message: Phrase,
}

/// The value with two significant digits, or with all digits before the decimal point.
pub(crate) fn two_digits(value: f64) -> String {
    // What has no digit here has no sign either.
    let value = if value.abs() < 5e-10 { 0.0 } else { value };
    let digits = if value.abs() >= 10.0 || value == 0.0 { 0 } else { 1 - value.abs().log10().floor() as i32 };
    format!("{value:.*}", usize::try_from(digits.clamp(0, 9)).unwrap_or(0))
}

/// The verdict on a motion, contacts and plates, and the corrected motion.
#[derive(Debug, Clone)]
pub struct Consistency {
    pub verdict: MotionVerdict,
    /// The verdict in a sentence.
    pub why: Phrase,
    /// The verdict and its figures in sentences.
    pub remarks: Vec<MotionRemark>,
    /// The corrected motion; `None` if plates and motion cannot be compared.
    pub correction: Option<Correction>,
}

/// The options of a request, for feet that stand with this mean velocity along the floor.
pub(crate) fn correction_options(
    request: &MotionRequest,
    belt: Option<Belt>,
    standing_m_s: DVec3,
) -> CorrectionOptions {
    let usual = CorrectionOptions::default();
    let (length_m, angle_rad) =
        request.error.map_or((usual.length_m, usual.angle_rad), |error| (error.length_m, error.angle_rad()));
    let floor_up_m = request.floor.map(Signed::get);
    CorrectionOptions { vertical_only: request.vertical, standing_m_s, belt, floor_up_m, length_m, angle_rad }
}

impl Consistency {
    /// Corrects a motion as the `request` says, and judges the correction. `was_corrected` says that it was corrected before.
    ///
    /// # Errors
    /// Why nothing can be judged.
    pub(crate) fn of(
        model: &Model,
        recording: &Recording,
        (states, feet): (&ContactStates, &[Foot]),
        (measured, weight_n): (&MeasuredForces, f64),
        options: &CorrectionOptions,
        (was_corrected, request, soles): (bool, &MotionRequest, &[Option<PressureOnSole>]),
    ) -> Result<Self, String> {
        let given_delay_s = request.plates_delay.map_or(0.0, Signed::get);
        let (common, frames) = (measured.frames_with_data(), recording.frames());
        if frames < LEAST_FRAMES_IN_COMMON {
            return Err(format!(
                "the motion has {frames} rows, and a correction needs {LEAST_FRAMES_IN_COMMON} or more"
            ));
        }
        if let Some(gap) = gaps(&recording.time_s).iter().find(|gap| gap.length_s() > LONGEST_GAP_S) {
            let (from, to) = (readable(gap.from_s), readable(gap.to_s));
            return Err(format!(
                "the motion has no rows from {from} to {to} s: correct the part before or after"
            ));
        }
        if common < LEAST_FRAMES_IN_COMMON {
            return Err(format!(
                "plates and motion have only {common} of {frames} frames in common: have their times the same unit and start?"
            ));
        }
        let seen = mismatches(model, recording, (states, feet), measured, weight_n);
        let mut seen = seen.map_err(|fault| fault.to_string())?;
        // Forces along the floor are no goals then.
        seen.retain(|one| !(options.vertical_only && matches!(one, Mismatch::Reversed { .. })));
        if let Some(cause) = seen.iter().find(|cause| cause.prevents_comparison()) {
            let why =
                phrase!["contacts and plates do not agree: ", &cause_in_words(cause, feet, given_delay_s)];
            let remarks = vec![MotionRemark { code: "disagree", message: why.clone() }];
            return Ok(Consistency { verdict: MotionVerdict::Disagree, why, remarks, correction: None });
        }
        let lost = measured.uses.iter().find(|plate| plate.by.is_none());
        let correction = correct(model, recording, (states, feet), measured, weight_n, options);
        let correction =
            correction.map_err(|fault| match lost.filter(|_| fault == CorrectionError::NoForce) {
                Some(plate) => unknown_foot(&plate.plate, "no foot has a force"),
                None => fault.to_string(),
            })?;
        let (verdict, causes) = correction.figures.verdict(seen, options);
        let why = verdict_in_words(verdict, (&causes, given_delay_s), feet, &correction);
        let mut remarks = vec![MotionRemark { code: verdict.as_str(), message: why.clone() }];
        let corrected = || MotionRemark { code: "corrected", message: CORRECTED_ALREADY.into() };
        remarks.extend(was_corrected.then(corrected));
        if !correction.locked.is_empty() {
            let names = correction.locked.join(", ");
            let text = format!("{names}: locked, so that no foot bends there; unlock them in the model");
            remarks.push(MotionRemark { code: "locked-toes", message: text.into() });
        }
        // Smoothing does not help what is no goal.
        let horizontal = horizontal_error(&correction.figures, request.low_pass.is_some())
            .filter(|_| !options.vertical_only);
        remarks.splice(0..0, horizontal.map(|message| MotionRemark { code: "horizontal-error", message }));
        let figures = figures_in_words(&correction, soles);
        remarks.extend(figures.map(|text| MotionRemark { code: "consistency", message: text.into() }));
        Ok(Consistency { verdict, why, remarks, correction: Some(correction) })
    }

    /// The verdict and its figures as JSON has them; `why` is the sentence in the reader's spelling.
    pub fn record(&self, why: String) -> ConsistencyRecord {
        let correction = self.correction.as_ref();
        let figures = correction.map(|one| &one.figures);
        let feet = || figures.into_iter().flat_map(|figures| &figures.feet);
        let errors = |error: fn(&ForceErrors) -> f64| {
            let of_foot = |foot: &FootErrors| CorrectedErrorRecord {
                foot: foot.foot.clone(),
                before: error(&foot.before),
                after: error(&foot.after),
                null: error(&foot.null),
            };
            feet().map(of_foot).collect()
        };
        ConsistencyRecord {
            verdict: self.verdict.as_str().to_owned(),
            why,
            vertical_rms_bw: errors(|errors| errors.vertical_bw),
            horizontal_rms_bw: errors(|errors| errors.horizontal_bw),
            cop_rms_m: figures.and_then(CorrectionFigures::cop_rms_m),
            floor_up_m: correction.map(|one| one.floor_up_m),
            belt_m_per_s: correction.map(|one| one.belt_m_s.into()),
            lift_rms_m: figures.map(|figures| figures.lift_rms_m),
            lift_p95_m: figures.map(|figures| figures.lift_p95_m),
            joint_rms_rad: figures.map(|figures| figures.largest_of_feet(|foot| foot.joint_rms_rad)),
            left_minus_right_m: figures.and_then(left_minus_right_m),
            largest_relative_indentation: figures.map(|figures| figures.largest_relative_indentation),
            root_residual: correction.map(|one| root_residuals(&one.dynamics)),
            joint_moment_change_nm: correction.map(|one| {
                let [hip, knee, ankle] = one.dynamics.moment_changes_n_m;
                JointMomentsRecord { hip, knee, ankle }
            }),
        }
    }
}

fn root_residuals(dynamics: &InverseDynamics) -> RootResidualRecord {
    let part = |part: fn(&RootResidual) -> Option<f64>| ResidualRecord {
        before: part(&dynamics.before),
        after: part(&dynamics.after),
        with_plates: part(&dynamics.with_plates),
    };
    RootResidualRecord {
        vertical: part(|residual| Some(residual.vertical_bw)),
        horizontal: part(|residual| Some(residual.horizontal_bw)),
        moment: part(|residual| residual.moment_bw_m),
    }
}

fn left_minus_right_m(figures: &CorrectionFigures) -> Option<f64> {
    let sign = if figures.feet.first()?.foot.starts_with("left") { -1.0 } else { 1.0 };
    Some(sign * figures.difference_of_feet_m()?)
}

/// With fewer frames in common, plates and motion cannot be compared.
const LEAST_FRAMES_IN_COMMON: usize = 10;
/// In right recordings, centres of pressure of contacts and plates are within 50 mm after a correction. The result reports a larger
/// distance than this, m.
const FAR_PRESSURE_M: f64 = 0.1;
/// After a correction, 19 of 22 right recordings have an error of the vertical force below 0.12 body weights. One above this is not called
/// usual.
const MOST_USUAL_VERTICAL_BW: f64 = 0.15;
/// In a longer time without rows, s, the motion is not known well enough to be corrected.
const LONGEST_GAP_S: f64 = 0.1;

/// Said of a motion that was corrected before.
pub(crate) const CORRECTED_ALREADY: &str =
    "the motion is corrected to contacts already: no evidence that they are right";

/// Says that the foot on a plate is not known, and what follows.
pub(crate) fn unknown_foot(plate: &str, so: &str) -> String {
    format!(
        "it is not known which foot the force '{plate}' acts on, so {so}: an ExternalLoads file says which"
    )
}

fn millimetres(length_m: f64) -> String {
    format!("{} mm", two_digits(1e3 * length_m.abs()))
}

/// Why contacts and plates disagree, in words.
pub(crate) fn cause_in_words(cause: &Mismatch, feet: &[Foot], given_delay_s: f64) -> Phrase {
    let name = |foot: usize| feet.get(foot).map_or("foot", |foot| foot.name.as_str());
    let text = match *cause {
        Mismatch::Sign { foot } => {
            let whose = foot.map_or_else(String::new, |foot| format!(" under the {}", name(foot)));
            format!("the plates' forces{whose} point down: their sign has to change")
        }
        Mismatch::Axes => {
            "the plates' forces lie along the floor: their axes are not those of the model".to_owned()
        }
        Mismatch::Reversed { along } => {
            let axis = ["x", "y", "z"][along.abs().max_position()];
            let text =
                format!("the plates' forces along {axis} are opposite to the whole body's acceleration");
            text + ": their sign has to change"
        }
        Mismatch::ForceUnit { mean_bw, unit } => {
            let mean = two_digits(mean_bw);
            format!("the plates measure {mean} body weights under load: are their forces in {unit}?")
        }
        Mismatch::Place { foot, distance_m, unit } => {
            let (foot, arm) = (name(foot), two_digits(distance_m));
            let asked = unit.map_or_else(String::new, |unit| format!(": are the plates' {unit}?"));
            format!("the force of the {foot} acts {arm} m from it{asked}")
        }
        Mismatch::Swapped { foot, own_m, other, other_m } => {
            let (foot, own, other) = (name(foot), millimetres(own_m), name(other));
            let away = millimetres(other_m);
            format!(
                "the {foot}'s force lies {own} from it and {away} from the {other}: are the feet swapped?"
            )
        }
        Mismatch::Delay { late_s } => {
            let (ms, when) = (1e3 * late_s.abs(), if late_s > 0.0 { "later" } else { "earlier" });
            let text =
                format!("the plates are {ms:.0} ms {when} than the motion, by the inertia of the whole body");
            let shift_s = format!("{:.3}", late_s + given_delay_s);
            let shift = Verb::Motion.call_with_model().with_value(Input::PlatesDelay, shift_s);
            return phrase![text, " (", shift, " removes it)"];
        }
        Mismatch::OneFoot { apart_m } => {
            let (up, other) = if apart_m > 0.0 { (name(1), name(0)) } else { (name(0), name(1)) };
            format!("the {up} has to go up by {} against the {other}", millimetres(apart_m))
        }
    };
    text.into()
}

/// The verdict in a sentence.
fn verdict_in_words(
    verdict: MotionVerdict,
    (causes, given_delay_s): (&[Mismatch], f64),
    feet: &[Foot],
    correction: &Correction,
) -> Phrase {
    let figures = &correction.figures;
    let side = if correction.floor_up_m < 0.0 { "lower" } else { "higher" };
    let (lift, floor) = (millimetres(figures.lift_p95_m), millimetres(correction.floor_up_m));
    let degrees = two_digits(figures.largest_of_feet(|foot| foot.joint_rms_rad).to_degrees());
    let moves = format!("loaded spheres move up or down by {lift} (95 %), joints by {degrees} degrees (rms)");
    let moves = format!("{moves}; the floor is {floor} {side} than in the model");
    let left_bw = figures.largest_of_feet(|foot| foot.after.vertical_bw);
    let left = two_digits(left_bw);
    let facts = &correction.recording.facts;
    let outside = listed(&facts.outside, 3);
    let jump = facts.jump.as_ref();
    let jump = jump.map(|(name, time_s)| format!(", and {name} jumps after {} s", readable(*time_s)));
    let far = figures.cop_rms_m().filter(|apart_m| *apart_m > FAR_PRESSURE_M).map(millimetres);
    let is_usual = left_bw <= MOST_USUAL_VERTICAL_BW && far.is_none();
    let usual = if is_usual { ", as in half of all recordings" } else { "" };
    let large = format!("contacts and plates agree after a large correction only{usual}");
    let far = far.map(|apart| {
        format!("; centres of pressure stay {apart} apart: have plates and motion the same origin and time?")
    });
    let cause = match (outside.as_str(), jump) {
        ("", Some(jump)) => jump,
        (names, Some(jump)) => format!("{jump}, and {names} leave their ranges"),
        ("", None) if far.is_some() => String::new(),
        ("", None) => ", and no cause is seen".to_owned(),
        (names, None) => format!(", and {names} leave their ranges"),
    };
    let unexplained = format!("contacts and plates do not agree after any correction{cause}");
    let far = far.unwrap_or_default();
    match verdict {
        MotionVerdict::Agree => format!("contacts and plates agree: {moves}{far}").into(),
        MotionVerdict::LargeCorrection => match figures.unexplained_foot() {
            Some(FootErrors { foot, after, null, .. }) => {
                let [after, null] = [after, null].map(|errors| two_digits(errors.vertical_bw));
                let off = format!(
                    "the {foot}'s vertical force is off by {after} body weights ({null} if nothing touched)"
                );
                format!("{unexplained}: {off}; {moves}{far}").into()
            }
            None => format!("{large}: {moves}; the vertical force is off by {left} body weights{far}").into(),
        },
        MotionVerdict::Disagree => {
            let mut text = Phrase::from("contacts and plates do not agree: ");
            for cause in causes {
                text.push(&phrase![&cause_in_words(cause, feet, given_delay_s), "; "]);
            }
            text.push(moves);
            text
        }
    }
}

/// A remark if horizontal forces under a foot are further from the plates than without any contact.
pub(crate) fn horizontal_error(figures: &CorrectionFigures, is_smoothed: bool) -> Option<Phrase> {
    let worse_bw = |foot: &&FootErrors| foot.after.horizontal_bw - foot.null.horizontal_bw;
    // Less than a thousandth is nothing.
    let is_worse = |foot: &&FootErrors| foot.stance_s > 0.0 && worse_bw(foot) > 1e-3;
    let feet = figures.feet.iter().filter(is_worse);
    let foot = feet.max_by(|a, b| worse_bw(a).total_cmp(&worse_bw(b)))?;
    let [after, null] = [foot.after, foot.null].map(|errors| format!("{:.3}", errors.horizontal_bw));
    let mut text = Phrase::from(format!(
        "{}: its horizontal force is further from the plates ({after} body weights) than if nothing touched \
         ({null})",
        foot.foot
    ));
    if !is_smoothed {
        let call = Verb::Motion.call_with_model().with_value(Input::LowPass, "10");
        text.push(&phrase![": smooth the motion, as with ", call]);
    }
    Some(text)
}

/// The figures of a correction in sentences.
fn figures_in_words(correction: &Correction, soles: &[Option<PressureOnSole>]) -> [String; 4] {
    let figures = &correction.figures;
    let errors = |of: fn(&ForceErrors) -> f64| {
        let worst = |which: fn(&FootErrors) -> &ForceErrors| {
            two_digits(figures.largest_of_feet(|foot| of(which(foot))))
        };
        let (after, before) = (worst(|foot| &foot.after), worst(|foot| &foot.before));
        format!("{after} ({before} before; {} if nothing touched)", worst(|foot| &foot.null))
    };
    let centre = figures.cop_rms_m().map(|rms_m| format!("; centre of pressure {}", millimetres(rms_m)));
    let (vertical, across) = (errors(|errors| errors.vertical_bw), errors(|errors| errors.horizontal_bw));
    let force = format!("vertical {vertical}, horizontal {across}{}", centre.unwrap_or_default());
    let apart = figures.difference_of_feet_m().map(millimetres);
    let alike = apart.map(|apart| format!("left and right are lifted alike within {apart}; "));
    let depth = two_digits(figures.largest_relative_indentation);
    let belt_m_s = correction.belt_m_s.length();
    let belt = if belt_m_s > 0.0 { format!("; the belt moves at {belt_m_s:.2} m/s") } else { String::new() };
    let parts = lifts_in_words(figures, soles);
    let depths = format!("{parts}{}spheres are at most {depth} R deep", alike.unwrap_or_default());
    [
        format!("force, error of the worst foot in body weights (rms): {force}"),
        depths + &belt,
        dynamics_in_words(&correction.dynamics),
        "this cannot show that the stiffness is right: stiffer contacts get the same verdict".to_owned(),
    ]
}

/// How far the correction moves heels and forefeet of all feet up or down under load, in words that begin a sentence.
fn lifts_in_words(figures: &CorrectionFigures, soles: &[Option<PressureOnSole>]) -> String {
    let part = |(name, is_heel): (&str, bool)| {
        let of_foot = |(foot, sole): (&FootErrors, &Option<PressureOnSole>)| {
            let spheres = foot.lifts_and_forces.iter().zip(&sole.as_ref()?.spheres_m);
            let own = spheres.filter(|(_, [ahead_m, _])| (*ahead_m < 0.0) == is_heel);
            let [moved, force_n] = own.fold([0.0; 2], |[a, b], ([c, d], _)| [a + c, b + d]);
            (force_n > 0.0).then(|| 1e3 * moved / force_n)
        };
        let all = || figures.feet.iter().zip(soles).filter_map(of_foot);
        let (least, most) = (all().reduce(f64::min)?, all().reduce(f64::max)?);
        let (low, high) = (two_digits(least.abs()), two_digits(most.abs()));
        Some(match (least < 0.0, most < 0.0) {
            (true, true) => format!("{name} {high} to {low} mm down, "),
            (true, false) => format!("{name} {low} mm down to {high} mm up, "),
            _ => format!("{name} {low} to {high} mm up, "),
        })
    };
    [("heels", true), ("forefeet", false)].into_iter().filter_map(part).collect()
}

/// What the correction changes in inverse dynamics, in words.
fn dynamics_in_words(dynamics: &InverseDynamics) -> String {
    // Less than a thousandth is nothing.
    let digits = |value: f64| two_digits((1e3 * value).round() / 1e3);
    let residual = |one: RootResidual| format!("{}, {}", digits(one.vertical_bw), digits(one.horizontal_bw));
    let [after, before, plates] = [dynamics.after, dynamics.before, dynamics.with_plates].map(residual);
    let names = ["hip", "knee", "ankle"].into_iter().zip(dynamics.moment_changes_n_m);
    let known = names.filter_map(|(name, change)| Some((name, two_digits(change?))));
    let (names, changes): (Vec<&str>, Vec<String>) = known.unzip();
    let (names, changes) = (names.join(", "), changes.join(", "));
    let moments = format!("; moments of {names} change by {changes} N m (rms)");
    let moments = if names.is_empty() { String::new() } else { moments };
    let text = "inverse dynamics: root residual, vertical and horizontal,";
    format!("{text} {after} body weights ({before} before; {plates} with the plates){moments}")
}
