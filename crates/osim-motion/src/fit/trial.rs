//! What a fit sees of a trial, and how its contacts get deeper where spheres go down in their bodies.

use contact_scaling::Law;
use osim_model::DVec3;
use osim_model::{Model, SphereId};

use crate::assigned::Measured;
use crate::feet::{Foot, ON_BW};
use crate::recording::Recording;
use crate::sole::down_at_default_pose;
use crate::states::{ContactState, ContactStates, StatesError};
use crate::wrench::Wrench;

/// One trial: the contacts of each foot where the plates say what its force is.
#[derive(Debug, Clone, PartialEq)]
pub struct FitTrial {
    pub feet: Vec<FootForces>,
    pub weight_n: f64,
    /// How many frames were left out, because a foot seems to stand beside the plates.
    pub beside: usize,
    /// Feet that are left out, because the plates measured no force under them.
    pub without_force: Vec<String>,
    /// Which way is down for each pair of the recording, in the body of its sphere; empty where spheres stay in their bodies.
    pub down: Vec<DVec3>,
}

#[derive(Debug, Clone, PartialEq)]
pub struct FootForces {
    pub name: String,
    pub spheres: Vec<SphereId>,
    /// The law and the radius (m) of each of its spheres.
    pub laws: Vec<(Law, f64)>,
    /// The measured force along the normal in each frame, N.
    pub measured_n: Vec<f64>,
    /// Indentation (m) and its rate (m/s) of each sphere, frame by frame.
    pub contacts: Vec<(f64, f64)>,
    /// What one metre of its spheres down in their bodies adds to each of them; empty where spheres stay in their bodies.
    down: Vec<PerMetre>,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Deeper {
    /// A floor that goes up, m.
    pub(super) floor_up_m: f64,
    /// Spheres that go down in their bodies, m.
    pub(super) spheres_down_m: f64,
}

impl FitTrial {
    /// What `states` and `measured` say, over the frames in which all plates of a foot are there.
    pub fn of(states: &ContactStates, feet: &[Foot], measured: &Measured, weight_n: f64) -> Self {
        Self::with(states, feet, measured, weight_n, None)
    }

    /// What they say where spheres go down in their bodies. The first trial finds which way is `down`, and the others take it from there.
    pub fn of_lowered(
        model: &Model,
        recording: &Recording,
        states: &ContactStates,
        (feet, measured): (&[Foot], &Measured),
        weight_n: f64,
        down: Option<&[DVec3]>,
    ) -> Result<Self, StatesError> {
        let lowered = Lowered::of(model, recording, states, down, (feet, measured))?;
        Ok(Self::with(states, feet, measured, weight_n, Some(&lowered)))
    }

    fn with(
        states: &ContactStates,
        feet: &[Foot],
        measured: &Measured,
        weight_n: f64,
        lowered: Option<&Lowered<'_>>,
    ) -> Self {
        let one = |(foot, plates): (&Foot, &Vec<Option<Wrench>>)| {
            let (forces, kept) = FootForces::of(states, foot, plates);
            let down = lowered.map(|lowered| lowered.contacts(foot, &kept)).unwrap_or_default();
            FootForces { down, ..forces }
        };
        let feet: Vec<FootForces> = feet.iter().zip(&measured.feet).map(one).collect();
        // A foot in the air fits everything, and one beside the plates nothing.
        let (feet, others): (Vec<_>, Vec<_>) = feet.into_iter().partition(|foot| foot.has_force(weight_n));
        Self {
            feet,
            weight_n,
            beside: measured.beside.iter().sum(),
            without_force: others.into_iter().map(|foot| foot.name).collect(),
            down: lowered.map(|lowered| lowered.down.clone()).unwrap_or_default(),
        }
    }
}

impl FitTrial {
    /// With some of its frames, evenly chosen: at most about `most` of each foot.
    pub(super) fn thinned(&self, most: usize) -> Self {
        let of = |foot: &FootForces| {
            let kept = || (0..foot.frames()).step_by(foot.frames().div_ceil(most).max(1));
            FootForces {
                name: foot.name.clone(),
                spheres: foot.spheres.clone(),
                laws: foot.laws.clone(),
                measured_n: kept().filter_map(|frame| foot.measured_n.get(frame)).copied().collect(),
                contacts: kept().flat_map(|frame| foot.frame(frame)).copied().collect(),
                down: kept().flat_map(|frame| foot.down(frame)).copied().collect(),
            }
        };
        Self { feet: self.feet.iter().map(of).collect(), ..self.clone() }
    }
}

impl FootForces {
    /// Those of `foot`, and the frames they are of.
    fn of(states: &ContactStates, foot: &Foot, plates: &[Option<Wrench>]) -> (Self, Vec<usize>) {
        let pairs = || foot.pairs.iter().filter_map(|&pair| states.pairs.get(pair));
        let mut forces = Self {
            name: foot.name.clone(),
            spheres: pairs().map(|pair| pair.sphere).collect(),
            laws: pairs().map(|pair| (pair.law, pair.radius_m)).collect(),
            measured_n: Vec::new(),
            contacts: Vec::new(),
            down: Vec::new(),
        };
        let own = |frame: usize| -> Vec<&ContactState> {
            foot.pairs.iter().filter_map(|&pair| states.frame(frame).get(pair)).collect()
        };
        let normal_n = |frame: usize| {
            let (plate, first) = (plates.get(frame)?.as_ref()?, *own(frame).first()?);
            Some(plate.force_n.dot(first.normal))
        };
        let mut kept = Vec::new();
        for frame in 0..states.frames() {
            let Some(force_n) = normal_n(frame) else { continue };
            kept.push(frame);
            forces.measured_n.push(force_n);
            forces.contacts.extend(own(frame).iter().map(|state| (state.indentation_m, state.rate_m_s)));
        }
        (forces, kept)
    }

    /// Whether the plates measured a force under it.
    pub(crate) fn has_force(&self, weight_n: f64) -> bool {
        self.measured_n.iter().any(|&force_n| force_n > ON_BW * weight_n)
    }

    pub fn frames(&self) -> usize {
        self.measured_n.len()
    }

    /// The frames from `first` up to `end`, alone.
    pub(crate) fn part(&self, first: usize, end: usize) -> Self {
        let count = self.laws.len();
        Self {
            name: self.name.clone(),
            spheres: self.spheres.clone(),
            laws: self.laws.clone(),
            measured_n: self.measured_n.get(first..end).unwrap_or_default().to_vec(),
            contacts: self.contacts.get(first * count..end * count).unwrap_or_default().to_vec(),
            down: self.down.get(first * count..end * count).unwrap_or_default().to_vec(),
        }
    }

    /// The contacts of a frame.
    pub(crate) fn frame(&self, frame: usize) -> &[(f64, f64)] {
        let count = self.laws.len();
        self.contacts.get(frame * count..(frame + 1) * count).unwrap_or_default()
    }

    fn down(&self, frame: usize) -> &[PerMetre] {
        let count = self.laws.len();
        self.down.get(frame * count..(frame + 1) * count).unwrap_or_default()
    }

    /// The contacts of a frame, deeper.
    pub(super) fn deeper(&self, frame: usize, by: Deeper) -> impl Iterator<Item = (f64, f64)> {
        let down = self.down(frame);
        self.frame(frame).iter().enumerate().map(move |(number, &(x, rate))| {
            let down = down.get(number).copied().unwrap_or_default();
            (x + by.floor_up_m + by.spheres_down_m * down.indentation, rate + by.spheres_down_m * down.rate_s)
        })
    }

    /// x/R of each contact of a frame, deeper; of none in a frame without a measured force.
    pub(super) fn loaded_depths(&self, frame: usize, by: Deeper, weight_n: f64) -> impl Iterator<Item = f64> {
        let is_loaded = self.measured_n.get(frame).is_some_and(|&force_n| force_n > ON_BW * weight_n);
        let contacts = self.deeper(frame, by).zip(&self.laws).filter(move |_| is_loaded);
        contacts.map(|((x, _), &(_, radius_m))| x / radius_m)
    }
}

// How the contacts of a foot get deeper where its spheres go down in their bodies.

/// What one metre of a sphere down in its body adds to a contact.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct PerMetre {
    /// To its indentation.
    indentation: f64,
    /// To the rate of that, 1/s.
    rate_s: f64,
}

/// The contacts of a model along a recording as they are, and with each sphere moved by one metre along each axis of its body: where
/// a sphere is depends on its place in a straight line.
pub(super) struct Lowered<'s> {
    own: &'s ContactStates,
    along: [ContactStates; 3],
    /// Which way is down for each pair, in the body of its sphere.
    down: Vec<DVec3>,
}

impl<'s> Lowered<'s> {
    /// With what is `down` in another recording of the same model, or in this one.
    pub(super) fn of(
        model: &Model,
        recording: &Recording,
        own: &'s ContactStates,
        down: Option<&[DVec3]>,
        (feet, measured): (&[Foot], &Measured),
    ) -> Result<Self, StatesError> {
        let by = |axis: DVec3| own.displaced(model, recording, axis);
        let along = [by(DVec3::X)?, by(DVec3::Y)?, by(DVec3::Z)?];
        let mut lowered = Self { own, along, down: down_at_default_pose(model, own)? };
        match down {
            Some(down) => lowered.down = down.to_vec(),
            None => lowered.turn_to_floor(feet, measured),
        }
        Ok(lowered)
    }

    /// Down is where the floor is while the plates measure a force, whatever the default pose.
    fn turn_to_floor(&mut self, feet: &[Foot], measured: &Measured) {
        for (foot, plates) in feet.iter().zip(&measured.feet) {
            for &pair in &foot.pairs {
                let mut sum = DVec3::ZERO;
                for (frame, plate) in plates.iter().enumerate() {
                    let force_n = plate.map_or(0.0, |plate| {
                        self.own.frame(frame).get(pair).map_or(0.0, |state| plate.force_n.dot(state.normal))
                    });
                    // What an axis of the body does to the indentation is how far it points into the floor.
                    let into = self.per_axis(frame, pair, |state| state.indentation_m);
                    sum += force_n.max(0.0) * into;
                }
                let length = sum.length();
                if let Some(down) = self.down.get_mut(pair).filter(|_| length > 0.0) {
                    *down = sum / length;
                }
            }
        }
    }

    /// What one metre along each axis of its body does to a value of a contact.
    fn per_axis(&self, frame: usize, pair: usize, value: impl Fn(&ContactState) -> f64) -> DVec3 {
        let of = |states: &ContactStates| states.frame(frame).get(pair).map(&value);
        let difference = |(moved, own): (f64, f64)| moved - own;
        self.along.each_ref().map(|moved| of(moved).zip(of(self.own)).map_or(0.0, difference)).into()
    }

    /// What one metre down adds to each contact of `foot` in the frames `kept`.
    pub(super) fn contacts(&self, foot: &Foot, kept: &[usize]) -> Vec<PerMetre> {
        let each = kept.iter().flat_map(|&frame| foot.pairs.iter().map(move |&pair| (frame, pair)));
        each.filter_map(|(frame, pair)| {
            let down = *self.down.get(pair)?;
            Some(PerMetre {
                indentation: down.dot(self.per_axis(frame, pair, |state| state.indentation_m)),
                rate_s: down.dot(self.per_axis(frame, pair, |state| state.rate_m_s)),
            })
        })
        .collect()
    }
}
