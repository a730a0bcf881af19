//! What a fit sees of a trial.

use contact_scaling::Law;
use osim_feet::dot;

use crate::assigned::Measured;
use crate::feet::Foot;
use crate::states::{ContactState, ContactStates};
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
}

impl FitTrial {
    /// What `states` and `measured` say, over the frames in which all plates of a foot are there.
    #[must_use]
    pub fn of(states: &ContactStates, feet: &[Foot], measured: &Measured, weight_n: f64) -> Self {
        let feet = feet.iter().zip(&measured.feet);
        Self {
            feet: feet.map(|(foot, plates)| FootForces::of(states, foot, plates)).collect(),
            weight_n,
            beside: measured.beside.iter().sum(),
        }
    }
}

impl FootForces {
    fn of(states: &ContactStates, foot: &Foot, plates: &[Option<Wrench>]) -> Self {
        let pairs = foot.pairs.iter().filter_map(|&pair| states.pairs.get(pair));
        let mut forces = Self {
            name: foot.name.clone(),
            laws: pairs.map(|pair| (pair.law, pair.radius_m)).collect(),
            measured_n: Vec::new(),
            contacts: Vec::new(),
        };
        let own = |frame: usize| -> Vec<&ContactState> {
            foot.pairs.iter().filter_map(|&pair| states.frame(frame).get(pair)).collect()
        };
        let normal_n = |frame: usize| {
            let (plate, first) = (plates.get(frame)?.as_ref()?, *own(frame).first()?);
            Some(dot(plate.force_n, first.normal))
        };
        for frame in 0..states.frames() {
            let Some(force_n) = normal_n(frame) else { continue };
            forces.measured_n.push(force_n);
            forces.contacts.extend(own(frame).iter().map(|state| (state.indentation_m, state.rate_m_s)));
        }
        forces
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
        }
    }

    /// The contacts of a frame.
    pub(crate) fn frame(&self, frame: usize) -> &[(f64, f64)] {
        let count = self.laws.len();
        self.contacts.get(frame * count..(frame + 1) * count).unwrap_or_default()
    }
}
