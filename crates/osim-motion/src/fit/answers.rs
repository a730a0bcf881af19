//! How the contacts of a foot answer where its spheres move in their bodies, or where the recording is wrong about the foot.

use osim_feet::dot;
use osim_model::{Model, SphereId, cross};

use crate::assigned::Measured;
use crate::feet::Foot;
use crate::recording::Recording;
use crate::sole::{SoleAxes, level};
use crate::stance::ON_BW;
use crate::states::{ContactStates, StatesError};
use crate::wrench::Wrench;

/// What a step of one metre of a sphere in its body changes.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct PerMetre {
    /// Its indentation.
    pub(super) indentation: f64,
    /// The rate of that, 1/s.
    pub(super) rate_s: f64,
    /// Where its force acts, along the two axes of the floor.
    pub(super) along: [f64; 2],
}

/// One contact in one frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Answer {
    /// Where its force acts, along the two axes of the floor, m.
    pub(super) along_m: [f64; 2],
    /// How far it is ahead of the middle of the foot's contacts, m.
    pub(super) lever_m: f64,
    /// If the sphere goes down in its body.
    pub(super) down: PerMetre,
    /// If it goes ahead.
    pub(super) ahead: PerMetre,
}

/// One foot in the frames of its plates.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Answers {
    /// Its spheres, one for each contact of a frame.
    pub(super) spheres: Vec<SphereId>,
    /// The time of each frame, s.
    pub(super) time_s: Vec<f64>,
    /// Where the plates' force acts along the axes of the floor, m; `None` where they do not say it.
    pub(super) centre_m: Vec<Option<[f64; 2]>>,
    contacts: Vec<Answer>,
}

impl Answers {
    /// The contacts of a frame.
    pub(super) fn frame(&self, frame: usize) -> &[Answer] {
        let count = self.spheres.len();
        self.contacts.get(frame * count..(frame + 1) * count).unwrap_or_default()
    }

    /// The frames from `first` up to `end`, alone.
    pub(super) fn part(&self, first: usize, end: usize) -> Self {
        let count = self.spheres.len();
        Self {
            spheres: self.spheres.clone(),
            time_s: self.time_s.get(first..end).unwrap_or_default().to_vec(),
            centre_m: self.centre_m.get(first..end).unwrap_or_default().to_vec(),
            contacts: self.contacts.get(first * count..end * count).unwrap_or_default().to_vec(),
        }
    }
}

/// The contacts of a model along a recording as they are, and with each sphere one metre lower and one metre ahead in its body: where
/// a sphere is depends on its place in a straight line.
pub(super) struct Displaced<'s> {
    own: &'s ContactStates,
    lower: ContactStates,
    further: ContactStates,
}

impl<'s> Displaced<'s> {
    pub(super) fn of(
        model: &Model,
        recording: &Recording,
        own: &'s ContactStates,
        axes: &[SoleAxes],
    ) -> Result<Self, StatesError> {
        let by = |of: fn(&SoleAxes) -> [f64; 3]| axes.iter().map(of).collect::<Vec<[f64; 3]>>();
        Ok(Self {
            own,
            lower: own.displaced(model, recording, &by(|axes| axes.down))?,
            further: own.displaced(model, recording, &by(|axes| axes.ahead))?,
        })
    }

    /// The answers of `foot` in the frames `kept`.
    pub(super) fn answers(
        &self,
        foot: usize,
        own: &Foot,
        measured: &Measured,
        kept: &[usize],
        weight_n: f64,
    ) -> Answers {
        let pairs = own.pairs.iter().filter_map(|&pair| self.own.pairs.get(pair));
        let mut answers = Answers {
            spheres: pairs.map(|pair| pair.sphere).collect(),
            time_s: kept.iter().filter_map(|&frame| self.own.time_s.get(frame)).copied().collect(),
            centre_m: Vec::with_capacity(kept.len()),
            contacts: Vec::with_capacity(kept.len() * own.pairs.len()),
        };
        let has_points = measured.has_points.get(foot).copied().unwrap_or(false);
        for &frame in kept {
            let plate = measured.feet.get(foot).and_then(|series| series.get(frame)).copied().flatten();
            let plate = plate.filter(|_| has_points);
            answers.centre_m.push(plate.and_then(|plate| self.centre_m(&plate, own, frame, weight_n)));
            answers.contacts.extend(self.frame(own, frame));
        }
        answers
    }

    /// Where the plates' force acts, along the axes of the floor.
    fn centre_m(&self, plate: &Wrench, foot: &Foot, frame: usize, weight_n: f64) -> Option<[f64; 2]> {
        let first = *foot.pairs.first()?;
        let state = self.own.frame(frame).get(first)?;
        let on_plane_m = state.on_surface_m(self.own.pairs.get(first)?.radius_m);
        let centre = plate.centre_of_pressure(state.normal, on_plane_m, ON_BW * weight_n)?;
        Some(axes_of(state.normal).map(|axis| dot(axis, centre.point_m)))
    }

    fn frame(&self, foot: &Foot, frame: usize) -> Vec<Answer> {
        let (own, lower, further) =
            (self.own.frame(frame), self.lower.frame(frame), self.further.frame(frame));
        let Some(first) = foot.pairs.first().copied() else { return Vec::new() };
        let Some((state, moved)) = own.get(first).zip(further.get(first)) else { return Vec::new() };
        let axes = axes_of(state.normal);
        let ahead: [f64; 3] = std::array::from_fn(|i| moved.centre_m[i] - state.centre_m[i]);
        let ahead = level(ahead, state.normal);
        let count = foot.pairs.len().max(1) as f64;
        let places = foot.pairs.iter().filter_map(|&pair| own.get(pair));
        let middle_m: f64 = places.map(|state| dot(ahead, state.centre_m)).sum::<f64>() / count;
        let along_m = |point_m: [f64; 3]| axes.map(|axis| dot(axis, point_m));
        let answer = |&pair: &usize| {
            let (own, lower, further) = (own.get(pair)?, lower.get(pair)?, further.get(pair)?);
            let at_m = along_m(own.centre_m);
            let per_metre = |other: &crate::states::ContactState| {
                let there_m = along_m(other.centre_m);
                PerMetre {
                    indentation: other.indentation_m - own.indentation_m,
                    rate_s: other.rate_m_s - own.rate_m_s,
                    along: [there_m[0] - at_m[0], there_m[1] - at_m[1]],
                }
            };
            Some(Answer {
                along_m: at_m,
                lever_m: dot(ahead, own.centre_m) - middle_m,
                down: per_metre(lower),
                ahead: per_metre(further),
            })
        };
        foot.pairs.iter().filter_map(answer).collect()
    }
}

/// Two directions along a floor, at right angles.
fn axes_of(normal: [f64; 3]) -> [[f64; 3]; 2] {
    let along = if normal[0].abs() > 0.9 { [0.0, 1.0, 0.0] } else { [1.0, 0.0, 0.0] };
    let first = level(along, normal);
    [first, cross(first, normal)]
}
