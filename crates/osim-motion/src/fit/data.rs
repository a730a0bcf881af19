//! What a fit sees of a trial.

use contact_scaling::Law;
use osim_feet::dot;

use crate::assigned::Measured;
use crate::feet::Foot;
use crate::states::{ContactState, ContactStates};

/// One trial: the contacts of each foot where the plates say what its force is.
#[derive(Debug, Clone, PartialEq)]
pub struct FitTrial {
    /// Each foot.
    pub feet: Vec<FootForces>,
    /// Body weight, N.
    pub weight_n: f64,
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
    /// How many frames were left out, because the foot seems to stand beside the plates.
    pub beside: usize,
}

impl FitTrial {
    /// What `states` and `measured` say, over the frames in which all plates of a foot are there.
    #[must_use]
    pub fn of(states: &ContactStates, feet: &[Foot], measured: &Measured, weight_n: f64) -> Self {
        let feet = feet.iter().zip(&measured.feet);
        Self {
            feet: feet.map(|(foot, plates)| FootForces::of(states, foot, plates, weight_n)).collect(),
            weight_n,
        }
    }
}

impl FootForces {
    fn of(
        states: &ContactStates,
        foot: &Foot,
        plates: &[Option<crate::wrench::Wrench>],
        weight_n: f64,
    ) -> Self {
        let pairs = foot.pairs.iter().filter_map(|&pair| states.pairs.get(pair));
        let mut forces = Self {
            name: foot.name.clone(),
            laws: pairs.map(|pair| (pair.law, pair.radius_m)).collect(),
            measured_n: Vec::new(),
            contacts: Vec::new(),
            beside: 0,
        };
        let own = |frame: usize| -> Vec<&ContactState> {
            foot.pairs.iter().filter_map(|&pair| states.frame(frame).get(pair)).collect()
        };
        let normal_n = |frame: usize| {
            let (plate, first) = (plates.get(frame)?.as_ref()?, *own(frame).first()?);
            Some(dot(plate.force_n, first.normal))
        };
        let beside = Beside::of(states, &own, &normal_n, weight_n);
        for frame in 0..states.frames() {
            let Some(force_n) = normal_n(frame) else { continue };
            if beside.has(&own(frame), force_n) {
                forces.beside += 1;
                continue;
            }
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
            beside: 0,
        }
    }

    /// The contacts of a frame.
    pub(crate) fn frame(&self, frame: usize) -> &[(f64, f64)] {
        let count = self.laws.len();
        self.contacts.get(frame * count..(frame + 1) * count).unwrap_or_default()
    }
}

/// What a foot is like on a plate: as low and as slow as this without a force, it stands beside the plates.
struct Beside {
    /// The median depth of its deepest sphere on a plate, m.
    depth_m: Option<f64>,
    weight_n: f64,
}

/// A foot that moves up or down faster than this does not stand, m/s.
const STILL_M_S: f64 = 0.2;

impl Beside {
    fn of<'s>(
        states: &ContactStates,
        own: &impl Fn(usize) -> Vec<&'s ContactState>,
        normal_n: &impl Fn(usize) -> Option<f64>,
        weight_n: f64,
    ) -> Self {
        let loaded = |frame: &usize| normal_n(*frame).is_some_and(|force_n| force_n > 0.5 * weight_n);
        let depths: Vec<f64> = (0..states.frames())
            .filter(loaded)
            .filter_map(|frame| deepest(&own(frame)).map(|(depth_m, _)| depth_m))
            .collect();
        Self { depth_m: crate::summary::percentile(&depths, 0.5), weight_n }
    }

    fn has(&self, states: &[&ContactState], force_n: f64) -> bool {
        let Some((depth_m, rate_m_s)) = deepest(states) else { return false };
        let is_low = self.depth_m.is_some_and(|usual_m| depth_m >= usual_m);
        is_low && rate_m_s.abs() < STILL_M_S && force_n < crate::stance::OFF_BW * self.weight_n
    }
}

fn deepest(states: &[&ContactState]) -> Option<(f64, f64)> {
    let deepest = states.iter().max_by(|a, b| a.indentation_m.total_cmp(&b.indentation_m))?;
    Some((deepest.indentation_m, deepest.rate_m_s))
}
