//! A model along a recording, frame by frame: bodies, the forces of its contacts, and what plates measured.

use osim_model::messages::Dialect;
use osim_motion::{FootSummary, ON_BW, Poses, Wrench};
use osim_requests::MotionRequest;
use serde::Serialize;

use super::rounded::rounded;
use crate::motion::MotionResult;

/// Frames that are shown at most: those of a longer recording are left out evenly.
const MOST_FRAMES: usize = 600;

/// A model along a recording.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Played {
    /// The time of each frame, s.
    pub time_s: Vec<f64>,
    /// Bodies that have a place.
    pub bodies: Vec<String>,
    /// For each frame, of each body axes x, y and z and the origin in ground, in hundred-thousandths.
    pub poses: Vec<i32>,
    /// Each foot.
    pub feet: Vec<PlayedFoot>,
    /// What the recording shows, and what is odd, in words.
    pub remarks: Vec<String>,
}

/// A foot along a recording.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PlayedFoot {
    /// Its name.
    pub name: String,
    /// `right` or `left`.
    pub side: Option<&'static str>,
    /// What the contacts of the model do.
    pub model: PlayedForce,
    /// What plates measured; `None` without plates.
    pub plates: Option<PlayedForce>,
}

/// A force along a recording.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PlayedForce {
    /// In each frame, body weights, in ground; `None` where it is not known.
    pub forces_bw: Vec<Option<[f64; 3]>>,
    /// Where it acts on the floor, m; `None` where it is too small, or where that is not known.
    pub points_m: Vec<Option<[f64; 3]>>,
}

impl Played {
    /// What `result` shows of what `request` asked for, its words spelled by `dialect`.
    #[must_use]
    pub fn of(result: &MotionResult, request: &MotionRequest, dialect: &dyn Dialect) -> Self {
        let states = &result.states;
        let step = states.frames().div_ceil(MOST_FRAMES).max(1);
        let frames: Vec<usize> = (0..states.frames()).step_by(step).collect();
        let poses = Poses::of(&result.opened.model, &result.recording, &frames);
        let feet = result.summary.feet.iter().enumerate().map(|(index, foot)| {
            let measured = result.measured.as_ref();
            let has_points = measured.is_some_and(|measured| measured.has_points.get(index) == Some(&true));
            let plates = measured.and_then(|measured| measured.feet.get(index));
            let seen = Seen { result, foot, frames: &frames };
            PlayedFoot {
                name: foot.foot.name.clone(),
                side: foot.foot.side.map(osim_model::Side::as_str),
                model: seen.force(|frame| foot.wrenches.get(frame).copied(), true),
                plates: plates
                    .map(|plates| seen.force(|frame| plates.get(frame).copied().flatten(), has_points)),
            }
        });
        Self {
            time_s: frames.iter().filter_map(|&frame| states.time_s.get(frame).copied()).collect(),
            poses: (0..frames.len()).flat_map(|number| poses.frame(number)).flat_map(numbers).collect(),
            bodies: poses.bodies,
            feet: feet.collect(),
            remarks: result.remarks(request).iter().map(|remark| remark.message.spelled(dialect)).collect(),
        }
    }
}

/// A foot in the frames that are shown.
struct Seen<'r> {
    result: &'r MotionResult,
    foot: &'r FootSummary,
    frames: &'r [usize],
}

impl Seen<'_> {
    fn force(&self, of: impl Fn(usize) -> Option<Wrench>, has_points: bool) -> PlayedForce {
        let weight_n = self.result.summary.weight_n;
        let forces = self
            .frames
            .iter()
            .map(|&frame| of(frame).map(|wrench| wrench.force_n.map(|part| part / weight_n)));
        let points = self.frames.iter().map(|&frame| self.point(frame, &of(frame)?).filter(|_| has_points));
        PlayedForce { forces_bw: forces.collect(), points_m: points.collect() }
    }

    /// Where a force acts on the floor below the foot.
    fn point(&self, frame: usize, wrench: &Wrench) -> Option<[f64; 3]> {
        let states = &self.result.states;
        let first = *self.foot.foot.pairs.first()?;
        let (state, pair) = (states.frame(frame).get(first)?, states.pairs.get(first)?);
        let least_n = ON_BW * self.result.summary.weight_n;
        let centre = wrench.centre_of_pressure(state.normal, state.on_surface_m(pair.radius_m), least_n)?;
        Some(centre.point_m)
    }
}

fn numbers(placement: &osim_model::Placement) -> Vec<i32> {
    super::view::frame(placement).into_iter().flatten().map(rounded).collect()
}
