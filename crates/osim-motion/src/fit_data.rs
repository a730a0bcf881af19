//! The data of a fit of contacts to recordings: of each trial, the contacts of feet and the forces that plates measured under them; of the
//! result, fitted parameters with their ranges, and errors before and after.

use contact_scaling::Law;
use osim_model::feet::DefaultPose;
use osim_model::{DVec3, Model, SphereId};

use crate::{
    Belt, ContactPair, ContactState, ContactStates, Foot, MeasuredForces, Recording, StatesError,
    TOUCH_DOWN_BW, TouchedSurface, Wrench,
};

/// The data of one trial for a fit: the contacts of each foot in the frames in which the plates measured the force under it.
#[derive(Debug, Clone, PartialEq)]
pub struct FitTrial {
    pub feet: Vec<FootForces>,
    pub weight_n: f64,
    /// The number of frames that were left out because a foot probably stands beside the plates.
    pub beside: usize,
    /// Names of feet that are left out because the plates measured no force under them.
    pub without_force: Vec<String>,
    /// The sphere of each contact pair, with the direction down in the frame of its body; empty if spheres do not move.
    pub down: Vec<(SphereId, DVec3)>,
}

/// The contacts of one foot, and the force that plates measured under it.
#[derive(Debug, Clone, PartialEq)]
pub struct FootForces {
    pub name: String,
    pub spheres: Vec<SphereId>,
    /// The contact law and the radius (m) of each sphere of the foot.
    pub laws: Vec<(Law, f64)>,
    /// The measured force along the normal in each frame, N.
    pub measured_n: Vec<f64>,
    /// Indentation (m) and its rate (m/s) of each sphere, frame by frame, and the changes of both per metre that the sphere moves down
    /// in its body.
    pub contacts: Vec<[(f64, f64); 2]>,
}

impl FitTrial {
    /// The data of a trial in the frames in which the force under a foot is known. If spheres `can_move`, they move down in their
    /// bodies; the `first` trial determines the directions.
    ///
    /// # Errors
    /// As [`ContactStates::of`].
    pub fn of(
        model: &Model,
        recording: &Recording,
        states: &ContactStates,
        (feet, measured): (&[Foot], &MeasuredForces),
        weight_n: f64,
        can_move: bool,
        first: Option<&Self>,
    ) -> Result<Self, StatesError> {
        let moved = |by_m: DVec3| {
            let mut moved = states.clone();
            moved.pairs.iter_mut().for_each(|pair| pair.centre_m += by_m);
            moved.along(model, recording, &Belt::default())
        };
        let along =
            if can_move { vec![moved(DVec3::X)?, moved(DVec3::Y)?, moved(DVec3::Z)?] } else { Vec::new() };
        // Contacts change linearly with the places of spheres.
        let per_axis = |frame: usize, pair: usize, value: fn(&ContactState) -> f64| -> DVec3 {
            let of = |states: &ContactStates| states.frame(frame).get(pair).map_or(0.0, value);
            along.iter().zip(DVec3::AXES).map(|(moved, axis)| (of(moved) - of(states)) * axis).sum()
        };
        let pose = DefaultPose::of(model);
        let direction = |(index, pair): (usize, &ContactPair)| -> Result<(SphereId, DVec3), StatesError> {
            let plates = feet.iter().zip(&measured.feet).find(|(foot, _)| foot.pairs.contains(&index));
            // The mean direction into the floor in the frames in which the plates measured a force.
            let into = |(frame, plate): (usize, &Option<Wrench>)| {
                let force_n = plate.as_ref()?.force_n.dot(states.frame(frame).get(index)?.normal);
                Some(force_n.max(0.0) * per_axis(frame, index, |state| state.indentation_m))
            };
            let sum: DVec3 =
                plates.into_iter().flat_map(|(_, plates)| plates).enumerate().filter_map(into).sum();
            let length = sum.length();
            if length > 0.0 {
                return Ok((pair.sphere, sum / length));
            }
            let normal = match pair.touched {
                TouchedSurface::Plane(plane) => states.planes.get(plane).and_then(|plane| plane.normal),
                TouchedSurface::Sphere(_) => None,
            };
            let to_body = pose.placement(&pair.body)?.rotation.inverse();
            Ok((pair.sphere, to_body.to_body(-normal.unwrap_or(model.up()))))
        };
        let down = match first {
            Some(first) => first.down.clone(),
            None if !can_move => Vec::new(),
            None => states.pairs.iter().enumerate().map(direction).collect::<Result<_, _>>()?,
        };
        let change = |frame: usize, pair: usize| {
            let down = down.get(pair).map_or(DVec3::ZERO, |(_, down)| *down);
            let of = |value| down.dot(per_axis(frame, pair, value));
            (of(|state| state.indentation_m), of(|state| state.rate_m_s))
        };
        let one =
            |(foot, plates): (&Foot, &Vec<Option<Wrench>>)| FootForces::of(states, foot, plates, change);
        let feet = feet.iter().zip(&measured.feet).map(one);
        // A foot without a measured force cannot be fitted.
        let (feet, others): (Vec<_>, Vec<_>) = feet.partition(|foot| foot.has_force(weight_n));
        let without_force = others.into_iter().map(|foot| foot.name).collect();
        Ok(Self { feet, weight_n, beside: measured.beside.iter().sum(), without_force, down })
    }

    /// The trial with other data of its feet.
    pub(crate) fn with_feet(&self, feet: Vec<FootForces>) -> Self {
        Self { feet, ..self.clone() }
    }
}

impl FootForces {
    /// The forces of `foot` in the frames in which its measured force is known.
    fn of(
        states: &ContactStates,
        foot: &Foot,
        plates: &[Option<Wrench>],
        per_metre_down: impl Fn(usize, usize) -> (f64, f64),
    ) -> Self {
        let pairs = || foot.pairs.iter().filter_map(|&pair| states.pairs.get(pair));
        let (mut measured_n, mut contacts) = (Vec::new(), Vec::new());
        for (frame, plate) in plates.iter().enumerate() {
            let own = || foot.pairs.iter().filter_map(|&pair| Some((pair, states.frame(frame).get(pair)?)));
            let Some((plate, (_, first))) = plate.as_ref().zip(own().next()) else { continue };
            measured_n.push(plate.force_n.dot(first.normal));
            contacts.extend(
                own().map(|(pair, state)| {
                    [(state.indentation_m, state.rate_m_s), per_metre_down(frame, pair)]
                }),
            );
        }
        Self {
            name: foot.name.clone(),
            spheres: pairs().map(|pair| pair.sphere).collect(),
            laws: pairs().map(|pair| (pair.law, pair.radius_m)).collect(),
            measured_n,
            contacts,
        }
    }

    /// Whether the plates measured a force under the foot.
    pub(crate) fn has_force(&self, weight_n: f64) -> bool {
        self.measured_n.iter().any(|&force_n| force_n > TOUCH_DOWN_BW * weight_n)
    }

    /// The foot in these frames only.
    pub(crate) fn in_frames(&self, frames: impl Iterator<Item = usize>) -> Self {
        let count = self.laws.len();
        let mut part = Self { measured_n: Vec::new(), contacts: Vec::new(), ..self.clone() };
        for frame in frames {
            part.measured_n.push(self.measured_n[frame]);
            part.contacts.extend_from_slice(&self.contacts[frame * count..(frame + 1) * count]);
        }
        part
    }

    /// The measured force of each frame, N, with indentation (m) and rate (m/s) of each sphere for a floor that is higher and spheres
    /// that are lower by these distances, m.
    pub(crate) fn frames(
        &self,
        [up_m, down_m]: [f64; 2],
    ) -> impl Iterator<Item = (f64, impl Iterator<Item = (f64, f64)>)> {
        let moved = move |&[(x, rate), (by_x, by_rate)]: &[(f64, f64); 2]| {
            (x + up_m + down_m * by_x, rate + down_m * by_rate)
        };
        let contacts = self.contacts.chunks(self.laws.len().max(1));
        self.measured_n.iter().copied().zip(contacts.map(move |frame| frame.iter().map(moved)))
    }

    /// Indentation and radius (m) of each sphere in each frame; no sphere in frames in which the plates measured no force.
    pub(crate) fn loaded_spheres(
        &self,
        moves_m: [f64; 2],
        weight_n: f64,
    ) -> impl Iterator<Item = impl Iterator<Item = (f64, f64)>> {
        self.frames(moves_m).map(move |(measured_n, contacts)| {
            let spheres = contacts.zip(&self.laws).filter(move |_| measured_n > TOUCH_DOWN_BW * weight_n);
            spheres.map(|((x, _), &(_, radius_m))| (x, radius_m))
        })
    }
}

/// Why contacts cannot be fitted to recordings.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FitError {
    #[error("the plates measured no force under a foot during the recording: there is nothing to fit to")]
    NoForce,
    #[error("no height of the floor within the bounds gives the feet a force like the plates'")]
    NoContact,
    #[error("the search did not converge")]
    NotConverged,
    /// What was left out last, after which nothing is left to fit.
    #[error("the recordings determine nothing of what was to be fitted")]
    Undetermined(Vec<FittedParameter>),
}

/// A parameter of contacts that was fitted to recordings, with the range in which a fit is nearly as good.
#[derive(Debug, Clone, PartialEq)]
pub struct FittedParameter {
    /// The name for scripts, with the unit: `stiffness_factor`, `dissipation_s_m`, `spheres_down_m`, `floor_up_m`, and for the second
    /// trial `floor_2_up_m`.
    pub name: String,
    pub value: f64,
    /// The lowest and highest value at which a fit of the other parameters is nearly as good (rms within 5 %, or 0.005 body
    /// weights).
    pub nearly_as_good: (f64, f64),
    pub at_bound: bool,
    /// Whether a model gets the value: the recordings determine it, and it is not the floor of a further trial.
    pub is_written: bool,
}

/// The differences between the fitted forces and the forces of the plates.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct FitErrors {
    /// Root mean square of the difference along the normal, over all feet, in body weights.
    pub vertical_rms_bw: f64,
    /// The largest x/R of a sphere in frames in which the plates measured a force.
    pub largest_relative_indentation: f64,
}

/// A fit of one part of the data, tested on the other part.
#[derive(Debug, Clone, PartialEq)]
pub struct HeldOut {
    /// The fitted part of the data, in words.
    pub fitted: String,
    pub tested: String,
    /// The root mean square error on the tested part, in body weights.
    pub vertical_rms_bw: f64,
}

/// The result of a fit: contact parameters with which the forces of a model are like those of the plates.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionFit {
    /// The factor of all stiffnesses; `None` if it was not fitted, or is not determined.
    pub stiffness_factor: Option<FittedParameter>,
    /// The dissipation, s/m; `None` if it was not fitted, or is not determined.
    pub dissipation: Option<FittedParameter>,
    /// The distance by which all spheres move down in their bodies, m; `None` if it was not fitted.
    pub spheres_down_m: Option<FittedParameter>,
    /// The distance by which the floor moves up in each trial, m, without the first if spheres move; empty if no height was fitted.
    pub floor_up_m: Vec<FittedParameter>,
    /// What was fitted first, but not written and not fitted again, because the recordings do not determine it.
    pub undetermined: Vec<FittedParameter>,
    /// The names of each two fitted parameters with their correlation, which is not a number if one is at its bound.
    pub correlations: Vec<([String; 2], f64)>,
    pub before: FitErrors,
    pub after: FitErrors,
    /// The root mean square error of each trial, in body weights.
    pub trials_rms_bw: Vec<f64>,
    /// Fits of one part of the data, tested on the other part: one foot against the others, or one half against the other.
    pub held_out: Vec<HeldOut>,
    /// The number of frames that were left out because a foot probably stands beside the plates.
    pub beside: usize,
}
