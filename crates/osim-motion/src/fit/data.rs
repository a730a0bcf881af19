//! What a fit sees of a trial.

use contact_scaling::Law;
use osim_model::Model;
use osim_model::feet::dot;

use super::answers::{Answers, Displaced};
use crate::assigned::Measured;
use crate::feet::Foot;
use crate::recording::Recording;
use crate::sole::SoleAxes;
use crate::stance::ON_BW;
use crate::states::{ContactState, ContactStates, StatesError};
use crate::wrench::Wrench;

/// One trial: the contacts of each foot where the plates say what its force is.
#[derive(Debug, Clone, PartialEq)]
pub struct FitTrial {
    /// Each foot.
    pub feet: Vec<FootForces>,
    /// Body weight, N.
    pub weight_n: f64,
    /// How many frames were left out, because a foot seems to stand beside the plates.
    pub beside: usize,
    /// Feet that are left out, because the plates measured no force under them.
    pub without_force: Vec<String>,
    /// Which way is down and ahead for each pair of the recording; empty where nobody asked.
    pub axes: Vec<SoleAxes>,
}

/// One foot of a trial.
#[derive(Debug, Clone, PartialEq)]
pub struct FootForces {
    /// Its name.
    pub name: String,
    /// The law and the radius (m) of each of its spheres.
    pub laws: Vec<(Law, f64)>,
    /// The measured force along the normal in each frame, N.
    pub measured_n: Vec<f64>,
    /// Indentation (m) and its rate (m/s) of each sphere, frame by frame.
    pub contacts: Vec<(f64, f64)>,
    /// How the contacts answer to spheres that move in their bodies; `None` where nobody asked.
    pub(super) answers: Option<Answers>,
}

impl FitTrial {
    /// What `states` and `measured` say, over the frames in which all plates of a foot are there.
    #[must_use]
    pub fn of(states: &ContactStates, feet: &[Foot], measured: &Measured, weight_n: f64) -> Self {
        Self::with(states, feet, measured, weight_n, None)
    }

    /// The same, with how the contacts answer where spheres move in their bodies, or the feet of the recording are shifted. `axes` are those
    /// of the first trial, where this is another one.
    ///
    /// # Errors
    /// It is not known where a body is.
    pub fn with_answers(
        model: &Model,
        recording: &Recording,
        states: &ContactStates,
        (feet, measured): (&[Foot], &Measured),
        weight_n: f64,
        axes: Option<&[SoleAxes]>,
    ) -> Result<Self, StatesError> {
        let displaced = Displaced::of(model, recording, states, axes, (feet, measured))?;
        Ok(Self::with(states, feet, measured, weight_n, Some(&displaced)))
    }

    fn with(
        states: &ContactStates,
        feet: &[Foot],
        measured: &Measured,
        weight_n: f64,
        displaced: Option<&Displaced<'_>>,
    ) -> Self {
        let one = |(number, (foot, plates)): (usize, (&Foot, &Vec<Option<Wrench>>))| {
            let (mut forces, kept) = FootForces::of(states, foot, plates);
            forces.answers =
                displaced.map(|displaced| displaced.answers(number, foot, measured, &kept, weight_n));
            forces
        };
        let feet: Vec<FootForces> = feet.iter().zip(&measured.feet).enumerate().map(one).collect();
        // A foot in the air fits everything, and one beside the plates nothing.
        let (feet, others): (Vec<_>, Vec<_>) = feet.into_iter().partition(|foot| foot.has_force(weight_n));
        Self {
            feet,
            weight_n,
            beside: measured.beside.iter().sum(),
            without_force: others.into_iter().map(|foot| foot.name).collect(),
            axes: displaced.map(|displaced| displaced.axes.clone()).unwrap_or_default(),
        }
    }
}

impl FitTrial {
    /// The same with some of its frames, evenly chosen: at most about `most` of each foot, and no answers.
    pub(super) fn thinned(&self, most: usize) -> Self {
        let of = |foot: &FootForces| {
            let kept = || (0..foot.frames()).step_by(foot.frames().div_ceil(most).max(1));
            FootForces {
                name: foot.name.clone(),
                laws: foot.laws.clone(),
                measured_n: kept().filter_map(|frame| foot.measured_n.get(frame)).copied().collect(),
                contacts: kept().flat_map(|frame| foot.frame(frame)).copied().collect(),
                answers: None,
            }
        };
        Self { feet: self.feet.iter().map(of).collect(), ..self.clone() }
    }
}

impl FootForces {
    /// Those of `foot`, and the frames they are of.
    fn of(states: &ContactStates, foot: &Foot, plates: &[Option<Wrench>]) -> (Self, Vec<usize>) {
        let pairs = foot.pairs.iter().filter_map(|&pair| states.pairs.get(pair));
        let mut forces = Self {
            name: foot.name.clone(),
            laws: pairs.map(|pair| (pair.law, pair.radius_m)).collect(),
            measured_n: Vec::new(),
            contacts: Vec::new(),
            answers: None,
        };
        let own = |frame: usize| -> Vec<&ContactState> {
            foot.pairs.iter().filter_map(|&pair| states.frame(frame).get(pair)).collect()
        };
        let normal_n = |frame: usize| {
            let (plate, first) = (plates.get(frame)?.as_ref()?, *own(frame).first()?);
            Some(dot(plate.force_n, first.normal))
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
    #[must_use]
    pub fn has_force(&self, weight_n: f64) -> bool {
        self.measured_n.iter().any(|&force_n| force_n > ON_BW * weight_n)
    }

    /// How many frames there are.
    #[must_use]
    pub fn frames(&self) -> usize {
        self.measured_n.len()
    }

    /// The frames from `first` up to `end`, alone.
    #[must_use]
    pub(crate) fn part(&self, first: usize, end: usize) -> Self {
        let count = self.laws.len();
        Self {
            name: self.name.clone(),
            laws: self.laws.clone(),
            measured_n: self.measured_n.get(first..end).unwrap_or_default().to_vec(),
            contacts: self.contacts.get(first * count..end * count).unwrap_or_default().to_vec(),
            answers: self.answers.as_ref().map(|answers| answers.part(first, end)),
        }
    }

    /// The contacts of a frame.
    pub(crate) fn frame(&self, frame: usize) -> &[(f64, f64)] {
        let count = self.laws.len();
        self.contacts.get(frame * count..(frame + 1) * count).unwrap_or_default()
    }
}
