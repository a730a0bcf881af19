//! The JSON record of contacts along a motion.

use osim_inspect::SCHEMA_VERSION;
use osim_model::DVec3;
use osim_model::messages::Dialect;
use osim_motion::correct::{FootErrors, ForceErrors};
use osim_motion::{Comparison, FootSummary, PressureOnSole, SphereSummary, StanceSummary, TouchDown};
use osim_planning::{Consistency, MotionRemark, MotionResult};
use serde::Serialize;

/// A motion, as the JSON has it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct MotionRecord {
    /// Version of this JSON, which rises when a field changes its meaning or goes away.
    pub schema_version: u32,
    /// Name of the model's file.
    pub model: String,
    /// The model's name in bytes, if it is not UTF-8.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model_bytes: Option<Vec<u8>>,
    /// Name of the motion's file.
    pub motion: String,
    /// The motion's name in bytes, if it is not UTF-8.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub motion_bytes: Option<Vec<u8>>,
    /// How many frames the motion has.
    pub frames: usize,
    /// Time of the first frame, s.
    pub from_s: f64,
    /// Time of the last frame, s.
    pub to_s: f64,
    /// Mass of the model, kg.
    pub mass_kg: f64,
    /// Gravity of the model, m/s².
    pub gravity_m_s2: f64,
    /// Body weight, N: what forces in body weights are divided by.
    pub weight_n: f64,
    /// The mean force over whole strides, N, of the model.
    pub stride_mean_n: Option<f64>,
    /// The mean force of the plates over whole strides, N: what the subject weighs.
    pub measured_stride_mean_n: Option<f64>,
    /// The part of whole strides in which more than one foot stands.
    pub double_support: Option<f64>,
    /// The largest force of all feet along the normal of the floor, N.
    pub peak_n: f64,
    /// The forces of all feet, compared with those of all plates.
    pub comparison: Option<MotionComparisonRecord>,
    /// Results for each foot.
    pub feet: Vec<MotionFootRecord>,
    /// Whether motion, contacts and plates agree, if a corrected motion is wanted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub consistency: Option<ConsistencyRecord>,
    /// Remarks in words.
    pub remarks: Vec<MotionRemarkRecord>,
}

/// Whether a motion, contacts and plates agree: by the least correction of the motion that makes them agree.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct ConsistencyRecord {
    /// `agree`, `large-correction` or `disagree`.
    pub verdict: String,
    /// The verdict in words.
    pub why: String,
    /// Errors of the vertical force of each foot (rms), body weights.
    pub vertical_rms_bw: Vec<CorrectedErrorRecord>,
    /// Errors of the horizontal force of each foot (rms), body weights.
    pub horizontal_rms_bw: Vec<CorrectedErrorRecord>,
    /// Root mean square of the distance between both centres of pressure after the correction, of the worst foot, m.
    pub cop_rms_m: Option<f64>,
    /// How much higher the floor is than in the model, m.
    pub floor_up_m: Option<f64>,
    /// Velocity of the treadmill's belt, m/s.
    pub belt_m_per_s: Option<[f64; 3]>,
    /// Root mean square of the vertical moves of loaded spheres, without that of the floor, m.
    pub lift_rms_m: Option<f64>,
    /// The 95th percentile of the size of these moves, m.
    pub lift_p95_m: Option<f64>,
    /// The largest correction of an angle of a leg in stance (rms), without toes, rad.
    pub joint_rms_rad: Option<f64>,
    /// How much more the left foot is lifted than the right, m.
    pub left_minus_right_m: Option<f64>,
    /// Largest x/R after the correction.
    pub largest_relative_indentation: Option<f64>,
}

/// An error of one foot.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct CorrectedErrorRecord {
    /// The foot.
    pub foot: String,
    /// Before the correction.
    pub before: f64,
    /// After the correction.
    pub after: f64,
    /// Of a model that never touches.
    pub null: f64,
}

impl From<&Consistency> for ConsistencyRecord {
    fn from(one: &Consistency) -> Self {
        let correction = one.correction.as_ref();
        let figures = correction.map(|correction| &correction.figures);
        let errors = |of: fn(&ForceErrors) -> f64| {
            let feet = figures.into_iter().flat_map(|figures| &figures.feet);
            let record = |foot: &FootErrors| CorrectedErrorRecord {
                foot: foot.foot.clone(),
                before: of(&foot.before),
                after: of(&foot.after),
                null: of(&foot.null),
            };
            feet.map(record).collect()
        };
        let left_minus_right_m = figures.and_then(|figures| {
            let sign = if figures.feet.first()?.foot.starts_with("left") { -1.0 } else { 1.0 };
            Some(sign * figures.difference_of_feet_m()?)
        });
        Self {
            verdict: one.verdict.as_str().to_owned(),
            why: one.why.clone(),
            vertical_rms_bw: errors(|errors| errors.vertical_bw),
            horizontal_rms_bw: errors(|errors| errors.horizontal_bw),
            cop_rms_m: figures
                .and_then(|figures| figures.feet.iter().filter_map(|foot| foot.cop_rms_m).reduce(f64::max)),
            floor_up_m: correction.map(|correction| correction.floor_up_m),
            belt_m_per_s: correction.map(|correction| correction.belt_m_s.into()),
            lift_rms_m: figures.map(|figures| figures.lift_rms_m),
            lift_p95_m: figures.map(|figures| figures.lift_p95_m),
            joint_rms_rad: figures.map(|figures| figures.worst(|foot| foot.joint_rms_rad)),
            left_minus_right_m,
            largest_relative_indentation: figures.map(|figures| figures.largest_relative_indentation),
        }
    }
}

/// Something that a reader should know of a motion.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct MotionRemarkRecord {
    /// Stable short name of the remark.
    pub code: String,
    /// The message in words.
    pub message: String,
}

/// One foot of a motion.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct MotionFootRecord {
    /// `right foot`, `left foot`, or the name of the limb's first body.
    pub name: String,
    /// `right` or `left`, where names say it.
    pub side: Option<String>,
    /// Bodies of the foot that have spheres.
    pub bodies: Vec<String>,
    /// Largest force of the foot along the normal of the floor, N.
    pub peak_n: f64,
    /// Time of the largest force, s.
    pub peak_at_s: f64,
    /// Whether its stances are those of the plates; else they are those of the model.
    pub stands_by_plates: bool,
    /// The median depth of its deepest sphere in stance, m; below 0 it is above the floor.
    pub stance_depth_m: Option<f64>,
    /// Range from the 5th to the 95th percentile of the depth of the foot's deepest sphere in stance, m.
    pub stance_scatter_m: Option<f64>,
    /// The depth of its deepest sphere in the whole recording, m.
    pub deepest_m: f64,
    /// The median velocity of its deepest sphere along the floor in stance, m/s.
    pub stance_slip_m_s: Option<[f64; 3]>,
    /// Stances of the foot.
    pub stances: Vec<MotionStanceRecord>,
    /// Results for each sphere of the foot.
    pub spheres: Vec<MotionSphereRecord>,
    /// How far the model's centre of pressure is ahead of the plates' along the foot, m: the mean over frames.
    pub cop_ahead_m: Option<f64>,
    /// How far the model's centre of pressure is to the right of the plates', m: the mean over frames.
    pub cop_right_m: Option<f64>,
    /// The forces of the foot, compared with those of its plates.
    pub comparison: Option<MotionComparisonRecord>,
}

/// One stance of a foot.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct MotionStanceRecord {
    /// Time at which the foot touches down, s; absent where the recording begins in the stance.
    pub on_s: Option<f64>,
    /// Time at which the foot lifts off, s; absent where the recording ends in the stance.
    pub off_s: Option<f64>,
    /// The model's largest force along the normal, N.
    pub peak_n: f64,
    /// The model's impulse along the normal, N s.
    pub impulse_n_s: f64,
    /// The steepest rise of the model's force between two frames, N/s.
    pub loading_rate_n_s: f64,
}

/// One sphere of a foot.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct MotionSphereRecord {
    /// Name of the sphere.
    pub sphere: String,
    /// The force that presses it.
    pub force: String,
    /// Largest force of the sphere along the normal, N.
    pub peak_n: f64,
    /// Largest x/R of the sphere; below 0 it never touches.
    pub largest_relative_indentation: f64,
    /// Time of the largest x/R, s.
    pub largest_at_s: f64,
    /// Time for which x/R is beyond what the Hertz law holds for, s.
    pub beyond_hertz_s: f64,
    /// Time for which the sphere's centre is below the plane, s.
    pub beyond_radius_s: f64,
    /// The median of its slip speed while it is in the plane, m/s.
    pub slip_m_s: Option<f64>,
    /// Each touch-down of the sphere.
    pub touch_downs: Vec<MotionTouchDownRecord>,
}

/// A sphere that meets its plane.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct MotionTouchDownRecord {
    /// Time of the touch-down, s.
    pub time_s: f64,
    /// Speed of the sphere at touch-down, m/s.
    pub impact_speed_m_s: f64,
    /// The coefficient of restitution at this speed, by (12) without gravity.
    pub restitution: Option<f64>,
}

/// Forces of the model beside those that plates measured.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct MotionComparisonRecord {
    /// How many frames were compared.
    pub frames: usize,
    /// Root mean square of the difference along the normal of the floor, N.
    pub normal_rms_n: f64,
    /// Root mean square of the difference along the normal of the floor, body weights.
    pub vertical_rms_bw: f64,
    /// Root mean square of the difference across the normal, N.
    pub horizontal_rms_n: f64,
    /// Root mean square of the difference across the normal, body weights.
    pub horizontal_rms_bw: f64,
    /// The model's largest force along the normal in these frames, N.
    pub peak_n: f64,
    /// The largest measured force, N.
    pub measured_peak_n: f64,
    /// Root mean square of the distance between both centres of pressure, m.
    pub cop_rms_m: Option<f64>,
    /// The number of frames in which model and plates have a centre of pressure.
    pub cop_frames: usize,
}

impl MotionRecord {
    pub fn new(result: &MotionResult, remarks: &[MotionRemark], dialect: &dyn Dialect) -> Self {
        let (model, model_bytes) = result.opened.name().clone().into_parts();
        let (motion, motion_bytes) = result.motion.clone().into_parts();
        let summary = &result.summary;
        let times = &result.states.time_s;
        Self {
            schema_version: SCHEMA_VERSION,
            model,
            model_bytes,
            motion,
            motion_bytes,
            frames: times.len(),
            from_s: times.first().copied().unwrap_or_default(),
            to_s: times.last().copied().unwrap_or_default(),
            mass_kg: result.mass_kg,
            gravity_m_s2: result.gravity_m_s2,
            weight_n: summary.weight_n,
            stride_mean_n: summary.stride_mean_n,
            measured_stride_mean_n: summary.measured_stride_mean_n,
            double_support: summary.double_support,
            peak_n: summary.peak_n,
            comparison: summary.comparison.as_ref().map(|one| comparison_record(one, summary.weight_n)),
            feet: summary
                .feet
                .iter()
                .zip(&result.on_soles)
                .map(|(foot, on_sole)| foot_record(result, foot, on_sole.as_ref()))
                .collect(),
            consistency: result.consistency.as_ref().map(ConsistencyRecord::from),
            remarks: remarks
                .iter()
                .map(|remark| MotionRemarkRecord {
                    code: remark.code.to_owned(),
                    message: remark.message.spelled(dialect),
                })
                .collect(),
        }
    }
}

fn foot_record(
    result: &MotionResult,
    foot: &FootSummary,
    on_sole: Option<&PressureOnSole>,
) -> MotionFootRecord {
    let apart_m = on_sole.and_then(PressureOnSole::mean_difference_m);
    MotionFootRecord {
        name: foot.foot.name.clone(),
        side: foot.foot.side.map(|side| side.as_str().to_owned()),
        bodies: foot.foot.bodies.clone(),
        peak_n: foot.peak_n,
        peak_at_s: foot.peak_at_s,
        stands_by_plates: foot.stands_by_plates,
        stance_depth_m: foot.stance_depth_m,
        stance_scatter_m: foot.stance_scatter_m,
        deepest_m: foot.deepest_m,
        stance_slip_m_s: foot.stance_slip_m_s.map(DVec3::into),
        stances: foot.stances.iter().map(stance_record).collect(),
        spheres: foot.spheres.iter().map(|sphere| sphere_record(result, sphere)).collect(),
        cop_ahead_m: apart_m.map(|[ahead, _]| ahead),
        cop_right_m: apart_m.map(|[_, right]| right),
        comparison: foot.comparison.as_ref().map(|one| comparison_record(one, result.summary.weight_n)),
    }
}

fn stance_record(stance: &StanceSummary) -> MotionStanceRecord {
    MotionStanceRecord {
        on_s: stance.stance.on_s,
        off_s: stance.stance.off_s,
        peak_n: stance.peak_n,
        impulse_n_s: stance.impulse_n_s,
        loading_rate_n_s: stance.loading_rate_n_s,
    }
}

fn sphere_record(result: &MotionResult, sphere: &SphereSummary) -> MotionSphereRecord {
    let (model, pair) = (&result.opened.model, result.states.pairs.get(sphere.pair));
    let name = pair.and_then(|pair| model.sphere(pair.sphere)).map(|sphere| sphere.name.clone());
    let force = pair.and_then(|pair| model.force(pair.force)).map(|force| force.name.clone());
    MotionSphereRecord {
        sphere: name.unwrap_or_default(),
        force: force.unwrap_or_default(),
        peak_n: sphere.peak_n,
        largest_relative_indentation: sphere.largest_relative_indentation,
        largest_at_s: sphere.largest_at_s,
        beyond_hertz_s: sphere.beyond_hertz_s,
        beyond_radius_s: sphere.beyond_radius_s,
        slip_m_s: sphere.slip_m_s,
        touch_downs: sphere.touch_downs.iter().map(touch_down_record).collect(),
    }
}

fn touch_down_record(touch: &TouchDown) -> MotionTouchDownRecord {
    let TouchDown { time_s, impact_speed_m_s, restitution, .. } = *touch;
    MotionTouchDownRecord { time_s, impact_speed_m_s, restitution }
}

fn comparison_record(one: &Comparison, weight_n: f64) -> MotionComparisonRecord {
    MotionComparisonRecord {
        frames: one.frames,
        normal_rms_n: one.normal_rms_n,
        vertical_rms_bw: one.normal_rms_n / weight_n,
        horizontal_rms_n: one.horizontal_rms_n,
        horizontal_rms_bw: one.horizontal_rms_n / weight_n,
        peak_n: one.peak_n,
        measured_peak_n: one.measured_peak_n,
        cop_rms_m: one.cop_rms_m,
        cop_frames: one.cop_frames,
    }
}
