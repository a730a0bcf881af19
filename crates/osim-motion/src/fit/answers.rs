//! How the contacts of a foot answer where its spheres move in their bodies, or where the recording is wrong about the foot.

use osim_model::feet::dot;
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
    /// Whether the plates say where their force acts.
    pub(super) fn has_centres(&self) -> bool {
        self.centre_m.iter().any(Option::is_some)
    }

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

/// The contacts of a model along a recording as they are, and with each sphere moved by one metre along each axis of its body: where
/// a sphere is depends on its place in a straight line.
pub(super) struct Displaced<'s> {
    own: &'s ContactStates,
    along: [ContactStates; 3],
    /// Which way is down and ahead for each pair.
    pub(super) axes: Vec<SoleAxes>,
}

impl<'s> Displaced<'s> {
    /// With the `axes` of another recording of the same model, or those of this one.
    pub(super) fn of(
        model: &Model,
        recording: &Recording,
        own: &'s ContactStates,
        axes: Option<&[SoleAxes]>,
        (feet, measured): (&[Foot], &Measured),
    ) -> Result<Self, StatesError> {
        let by = |axis: [f64; 3]| own.displaced(model, recording, &vec![axis; own.pairs.len()]);
        let along = [by([1.0, 0.0, 0.0])?, by([0.0, 1.0, 0.0])?, by([0.0, 0.0, 1.0])?];
        let mut displaced = Self { own, along, axes: SoleAxes::at_default_pose(model, own)? };
        match axes {
            Some(axes) => displaced.axes = axes.to_vec(),
            None => displaced.turn_to_floor(feet, measured),
        }
        Ok(displaced)
    }

    /// Down is where the floor is while the plates measure a force, whatever the default pose.
    fn turn_to_floor(&mut self, feet: &[Foot], measured: &Measured) {
        for (foot, plates) in feet.iter().zip(&measured.feet) {
            for &pair in &foot.pairs {
                let mut down = [0.0; 3];
                for (frame, plate) in plates.iter().enumerate() {
                    let force_n = plate.map_or(0.0, |plate| {
                        self.own.frame(frame).get(pair).map_or(0.0, |state| dot(plate.force_n, state.normal))
                    });
                    // What an axis of the body does to the indentation is how far it points into the floor.
                    let into = self.along.each_ref().map(|moved| self.deeper(moved, frame, pair));
                    down.iter_mut().zip(into).for_each(|(sum, part)| *sum += force_n.max(0.0) * part);
                }
                let length = dot(down, down).sqrt();
                if let Some(axes) = self.axes.get_mut(pair).filter(|_| length > 0.0) {
                    let down = down.map(|part| part / length);
                    *axes = SoleAxes { down, ahead: level(axes.ahead, down) };
                }
            }
        }
    }

    fn deeper(&self, moved: &ContactStates, frame: usize, pair: usize) -> f64 {
        let depth = |states: &ContactStates| states.frame(frame).get(pair).map(|state| state.indentation_m);
        depth(moved).zip(depth(self.own)).map_or(0.0, |(moved, own)| moved - own)
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
        let own = self.own.frame(frame);
        let Some(first) = foot.pairs.first().copied() else { return Vec::new() };
        let Some((state, first_axes)) = own.get(first).zip(self.axes.get(first)) else { return Vec::new() };
        let floor = axes_of(state.normal);
        let centre =
            |states: &ContactStates, pair: usize| states.frame(frame).get(pair).map(|one| one.centre_m);
        let turned = |pair: usize, direction: [f64; 3]| {
            let mut sum = [0.0; 3];
            for (moved, part) in self.along.iter().zip(direction) {
                if let Some((there, here)) = centre(moved, pair).zip(centre(self.own, pair)) {
                    sum.iter_mut()
                        .zip(there.iter().zip(here))
                        .for_each(|(sum, (a, b))| *sum += part * (a - b));
                }
            }
            sum
        };
        let ahead = level(turned(first, first_axes.ahead), state.normal);
        let count = foot.pairs.len().max(1) as f64;
        let places = foot.pairs.iter().filter_map(|&pair| own.get(pair));
        let middle_m: f64 = places.map(|state| dot(ahead, state.centre_m)).sum::<f64>() / count;
        let answer = |&pair: &usize| {
            let (state, axes) = own.get(pair).zip(self.axes.get(pair))?;
            let per_metre = |direction: [f64; 3]| {
                let mut sum = PerMetre::default();
                for (moved, part) in self.along.iter().zip(direction) {
                    let Some(moved) = moved.frame(frame).get(pair) else { continue };
                    sum.indentation += part * (moved.indentation_m - state.indentation_m);
                    sum.rate_s += part * (moved.rate_m_s - state.rate_m_s);
                }
                sum.along = floor.map(|axis| dot(axis, turned(pair, direction)));
                sum
            };
            Some(Answer {
                along_m: floor.map(|axis| dot(axis, state.centre_m)),
                lever_m: dot(ahead, state.centre_m) - middle_m,
                down: per_metre(axes.down),
                ahead: per_metre(axes.ahead),
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
