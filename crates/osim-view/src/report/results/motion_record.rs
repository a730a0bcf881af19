//! The JSON record of contacts along a motion.

use osim_inspect::{ConsistencyRecord, SCHEMA_VERSION};
use osim_model::DVec3;
use osim_model::messages::Dialect;
use osim_motion::{
    Comparison, ContactPair, FootSummary, PressureOnSole, SphereSummary, StanceSummary, TouchDown,
};
use osim_planning::{MotionRemark, MotionResult};

osim_inspect::json_records! {
    /// A motion, as the JSON has it.
    MotionRecord from (result, remarks, dialect): (&MotionResult, &[MotionRemark], &dyn Dialect) {
        /// Version of this JSON, which rises when a field changes its meaning or goes away.
        schema_version: u32 = SCHEMA_VERSION,
        /// Name of the model's file.
        model: String = result.opened.name().clone().into_parts().0,
        /// The model's name in bytes, if it is not UTF-8.
        #[serde(skip_serializing_if = "Option::is_none")]
        model_bytes: Option<Vec<u8>> = result.opened.name().clone().into_parts().1,
        /// Name of the motion's file.
        motion: String = result.motion.clone().into_parts().0,
        /// The motion's name in bytes, if it is not UTF-8.
        #[serde(skip_serializing_if = "Option::is_none")]
        motion_bytes: Option<Vec<u8>> = result.motion.clone().into_parts().1,
        /// How many frames the motion has.
        frames: usize = result.states.frames(),
        /// Time of the first frame, s.
        from_s: f64 = result.states.time_s.first().copied().unwrap_or_default(),
        /// Time of the last frame, s.
        to_s: f64 = result.states.time_s.last().copied().unwrap_or_default(),
        /// Mass of the model, kg.
        mass_kg: f64 = result.mass_kg,
        /// Gravity of the model, m/s².
        gravity_m_s2: f64 = result.gravity_m_s2,
        /// Body weight, N: what forces in body weights are divided by.
        weight_n: f64 = result.summary.weight_n,
        /// The mean force over whole strides, N, of the model.
        stride_mean_n: Option<f64> = result.summary.stride_mean_n,
        /// The mean force of the plates over whole strides, N: what the subject weighs.
        measured_stride_mean_n: Option<f64> = result.summary.measured_stride_mean_n,
        /// The part of whole strides in which more than one foot stands.
        double_support: Option<f64> = result.summary.double_support,
        /// The largest force of all feet along the normal of the floor, N.
        peak_n: f64 = result.summary.peak_n,
        /// The forces of all feet, compared with those of all plates.
        comparison: Option<MotionComparisonRecord> = compared(result, result.summary.comparison.as_ref()),
        /// Results for each foot.
        feet: Vec<MotionFootRecord> =
            result.summary.feet.iter().zip(&result.on_soles).map(|(foot, sole)| (result, foot, sole).into()).collect(),
        /// Whether motion, contacts and plates agree, if a corrected motion is wanted.
        #[serde(skip_serializing_if = "Option::is_none")]
        consistency: Option<ConsistencyRecord> = result.consistency.as_ref().map(|one| one.record(one.why.spelled(dialect))),
        /// Remarks in words.
        remarks: Vec<MotionRemarkRecord> = remarks.iter().map(|remark| (remark, dialect).into()).collect(),
    }

    /// Something that a reader should know of a motion.
    MotionRemarkRecord from (remark, dialect): (&MotionRemark, &dyn Dialect) {
        /// Stable short name of the remark.
        code: String = remark.code.to_owned(),
        /// The message in words.
        message: String = remark.message.spelled(dialect),
    }

    /// One foot of a motion.
    MotionFootRecord from (result, foot, sole): (&MotionResult, &FootSummary, &Option<PressureOnSole>) {
        /// `right foot`, `left foot`, or the name of the limb's first body.
        name: String = foot.foot.name.clone(),
        /// `right` or `left`, where names say it.
        side: Option<String> = foot.foot.side.map(|side| side.as_str().to_owned()),
        /// Bodies of the foot that have spheres.
        bodies: Vec<String> = foot.foot.bodies.clone(),
        /// Largest force of the foot along the normal of the floor, N.
        peak_n: f64 = foot.peak_n,
        /// Time of the largest force, s.
        peak_at_s: f64 = foot.peak_at_s,
        /// Whether its stances are those of the plates; else they are those of the model.
        stands_by_plates: bool = foot.stands_by_plates,
        /// The median depth of its deepest sphere in stance, m; below 0 it is above the floor.
        stance_depth_m: Option<f64> = foot.stance_depth_m,
        /// Range from the 5th to the 95th percentile of the depth of the foot's deepest sphere in stance, m.
        stance_scatter_m: Option<f64> = foot.stance_scatter_m,
        /// The energy that its contacts take up in a stride, J: the mean over whole strides.
        lost_in_stride_j: Option<f64> = foot.lost_in_stride_j,
        /// The depth of its deepest sphere in the whole recording, m.
        deepest_m: f64 = foot.deepest_m,
        /// The median velocity of its deepest sphere along the floor in stance, m/s.
        stance_slip_m_s: Option<[f64; 3]> = foot.stance_slip_m_s.map(DVec3::into),
        /// Stances of the foot.
        stances: Vec<MotionStanceRecord> = foot.stances.iter().map(Into::into).collect(),
        /// Results for each sphere of the foot.
        spheres: Vec<MotionSphereRecord> = foot.spheres.iter().map(|sphere| (result, sphere).into()).collect(),
        /// How far the model's centre of pressure is ahead of the plates' along the foot, m: the mean over frames.
        cop_ahead_m: Option<f64> = apart_m(sole).map(|[ahead, _]| ahead),
        /// How far the model's centre of pressure is to the right of the plates', m: the mean over frames.
        cop_right_m: Option<f64> = apart_m(sole).map(|[_, right]| right),
        /// The forces of the foot, compared with those of its plates.
        comparison: Option<MotionComparisonRecord> = compared(result, foot.comparison.as_ref()),
    }

    /// One stance of a foot.
    MotionStanceRecord from stance: &StanceSummary {
        /// Time at which the foot touches down, s; absent where the recording begins in the stance.
        on_s: Option<f64> = stance.stance.on_s,
        /// Time at which the foot lifts off, s; absent where the recording ends in the stance.
        off_s: Option<f64> = stance.stance.off_s,
        /// The model's largest force along the normal, N.
        peak_n: f64 = stance.peak_n,
        /// The model's impulse along the normal, N s.
        impulse_n_s: f64 = stance.impulse_n_s,
        /// The steepest rise of the model's force between two frames, N/s.
        loading_rate_n_s: f64 = stance.loading_rate_n_s,
    }

    /// One sphere of a foot.
    MotionSphereRecord from (result, sphere): (&MotionResult, &SphereSummary) {
        /// Name of the sphere.
        sphere: String = name_of(result, sphere, |pair| Some(&result.opened.model.sphere(pair.sphere)?.name)),
        /// The force that presses it.
        force: String = name_of(result, sphere, |pair| Some(&result.opened.model.force(pair.force)?.name)),
        /// Largest force of the sphere along the normal, N.
        peak_n: f64 = sphere.peak_n,
        /// Largest x/R of the sphere; below 0 it never touches.
        largest_relative_indentation: f64 = sphere.largest_relative_indentation,
        /// Time of the largest x/R, s.
        largest_at_s: f64 = sphere.largest_at_s,
        /// The largest mean stress on its contact patch, N/m²; smoothed forces count where x exceeds √cf.
        mean_stress_n_m2: Option<f64> = sphere.largest_stress_n_m2.map(|(mean, _)| mean),
        /// The stress at the middle of the patch then, by Hertz: 1.5 times the mean, N/m².
        peak_stress_n_m2: Option<f64> = sphere.largest_stress_n_m2.map(|(mean, _)| 1.5 * mean),
        /// Time for which x/R is beyond what the Hertz law holds for, s.
        beyond_hertz_s: f64 = sphere.beyond_hertz_s,
        /// Time for which the sphere's centre is below the plane, s.
        beyond_radius_s: f64 = sphere.beyond_radius_s,
        /// The median of its slip speed while it is in the plane, m/s.
        slip_m_s: Option<f64> = sphere.slip_m_s,
        /// Each touch-down of the sphere.
        touch_downs: Vec<MotionTouchDownRecord> = sphere.touch_downs.iter().map(Into::into).collect(),
    }

    /// A sphere that meets its plane.
    MotionTouchDownRecord from touch: &TouchDown {
        /// Time of the touch-down, s.
        time_s: f64 = touch.time_s,
        /// Speed of the sphere at touch-down, m/s.
        impact_speed_m_s: f64 = touch.impact_speed_m_s,
        /// The coefficient of restitution at this speed, by (12) without gravity.
        restitution: Option<f64> = touch.restitution,
    }

    /// Forces of the model beside those that plates measured.
    MotionComparisonRecord from (one, weight_n): (&Comparison, f64) {
        /// How many frames were compared.
        frames: usize = one.frames,
        /// Root mean square of the difference along the normal of the floor, N.
        normal_rms_n: f64 = one.normal_rms_n,
        /// Root mean square of the difference along the normal of the floor, body weights.
        vertical_rms_bw: f64 = one.normal_rms_n / weight_n,
        /// Root mean square of the difference across the normal, N.
        horizontal_rms_n: f64 = one.horizontal_rms_n,
        /// Root mean square of the difference across the normal, body weights.
        horizontal_rms_bw: f64 = one.horizontal_rms_n / weight_n,
        /// The model's largest force along the normal in these frames, N.
        peak_n: f64 = one.peak_n,
        /// The largest measured force, N.
        measured_peak_n: f64 = one.measured_peak_n,
        /// Root mean square of the distance between both centres of pressure, m.
        cop_rms_m: Option<f64> = one.cop_rms_m,
        /// The number of frames in which model and plates have a centre of pressure.
        cop_frames: usize = one.cop_frames,
    }
}

impl MotionRecord {
    pub fn new(result: &MotionResult, remarks: &[MotionRemark], dialect: &dyn Dialect) -> Self {
        (result, remarks, dialect).into()
    }
}

fn compared(result: &MotionResult, comparison: Option<&Comparison>) -> Option<MotionComparisonRecord> {
    comparison.map(|one| (one, result.summary.weight_n).into())
}

fn apart_m(sole: &Option<PressureOnSole>) -> Option<[f64; 2]> {
    sole.as_ref().and_then(PressureOnSole::mean_difference_m)
}

fn name_of<'r>(
    result: &'r MotionResult,
    sphere: &SphereSummary,
    name: impl Fn(&'r ContactPair) -> Option<&'r String>,
) -> String {
    result.states.pairs.get(sphere.pair).and_then(name).cloned().unwrap_or_default()
}
