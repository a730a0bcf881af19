//! The data of a trial for a fit, and the change of contact depth if spheres move down in their bodies.

use contact_scaling::Law;
use osim_model::DVec3;
use osim_model::{Model, SphereId};

use crate::sole::down_in_bodies;
use crate::{ContactState, ContactStates, Foot, MeasuredForces, ON_BW, Recording, StatesError, Wrench};

/// The data of one trial for a fit: the contacts of each foot in the frames in which the plates measured the force under it.
#[derive(Debug, Clone, PartialEq)]
pub struct FitTrial {
    pub feet: Vec<FootForces>,
    pub weight_n: f64,
    /// The number of frames that were left out because a foot probably stands beside the plates.
    pub beside: usize,
    /// Names of feet that are left out because the plates measured no force under them.
    pub without_force: Vec<String>,
    /// The direction down in the frame of the body, for the sphere of each pair; empty if spheres do not move in their
    /// bodies.
    pub down: Vec<DVec3>,
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
    /// Indentation (m) and its rate (m/s) of each sphere, frame by frame.
    pub contacts: Vec<(f64, f64)>,
    /// The change of each element of `contacts` per metre that its sphere moves down in its body; empty if spheres do not
    /// move.
    per_metre_down: Vec<ChangePerMetre>,
}

/// The distances by which fitted heights make contacts deeper.
#[derive(Debug, Clone, Copy)]
pub(super) struct DepthShift {
    /// The distance by which the floor moves up, m.
    pub(super) floor_up_m: f64,
    /// The distance by which the spheres move down in their bodies, m.
    pub(super) spheres_down_m: f64,
}

impl FitTrial {
    /// The data of a trial in the frames in which the force under a foot is known.
    pub fn of(states: &ContactStates, feet: &[Foot], measured: &MeasuredForces, weight_n: f64) -> Self {
        Self::from_measurements(states, feet, measured, weight_n, None)
    }

    /// The data of a trial whose spheres can move down in their bodies. The first trial determines the direction `down`; the
    /// other trials get it from there.
    pub fn with_lowered_spheres(
        model: &Model,
        recording: &Recording,
        states: &ContactStates,
        (feet, measured): (&[Foot], &MeasuredForces),
        weight_n: f64,
        down: Option<&[DVec3]>,
    ) -> Result<Self, StatesError> {
        let lowered = LoweredSpheres::of(model, recording, states, down, (feet, measured))?;
        Ok(Self::from_measurements(states, feet, measured, weight_n, Some(&lowered)))
    }

    fn from_measurements(
        states: &ContactStates,
        feet: &[Foot],
        measured: &MeasuredForces,
        weight_n: f64,
        lowered: Option<&LoweredSpheres<'_>>,
    ) -> Self {
        let one = |(foot, plates): (&Foot, &Vec<Option<Wrench>>)| {
            let (forces, kept) = FootForces::with_frames(states, foot, plates);
            let per_metre_down =
                lowered.map(|lowered| lowered.changes_per_metre(foot, &kept)).unwrap_or_default();
            FootForces { per_metre_down, ..forces }
        };
        let feet: Vec<FootForces> = feet.iter().zip(&measured.feet).map(one).collect();
        // A foot without a measured force cannot be fitted.
        let (feet, others): (Vec<_>, Vec<_>) = feet.into_iter().partition(|foot| foot.has_force(weight_n));
        Self {
            feet,
            weight_n,
            beside: measured.beside.iter().sum(),
            without_force: others.into_iter().map(|foot| foot.name).collect(),
            down: lowered.map(|lowered| lowered.down.clone()).unwrap_or_default(),
        }
    }

    /// The trial with about `most` frames of each foot at most, evenly chosen.
    pub(super) fn thinned(&self, most: usize) -> Self {
        let thin = |foot: &FootForces| {
            let kept = || (0..foot.frames()).step_by(foot.frames().div_ceil(most).max(1));
            FootForces {
                name: foot.name.clone(),
                spheres: foot.spheres.clone(),
                laws: foot.laws.clone(),
                measured_n: kept().filter_map(|frame| foot.measured_n.get(frame)).copied().collect(),
                contacts: kept().flat_map(|frame| foot.frame(frame)).copied().collect(),
                per_metre_down: kept().flat_map(|frame| foot.per_metre_down(frame)).copied().collect(),
            }
        };
        Self { feet: self.feet.iter().map(thin).collect(), ..self.clone() }
    }
}

impl FootForces {
    /// The forces of `foot`, and the frames in which its measured force is known.
    fn with_frames(states: &ContactStates, foot: &Foot, plates: &[Option<Wrench>]) -> (Self, Vec<usize>) {
        let pairs = || foot.pairs.iter().filter_map(|&pair| states.pairs.get(pair));
        let mut forces = Self {
            name: foot.name.clone(),
            spheres: pairs().map(|pair| pair.sphere).collect(),
            laws: pairs().map(|pair| (pair.law, pair.radius_m)).collect(),
            measured_n: Vec::new(),
            contacts: Vec::new(),
            per_metre_down: Vec::new(),
        };
        let contacts = |frame: usize| -> Vec<&ContactState> {
            foot.pairs.iter().filter_map(|&pair| states.frame(frame).get(pair)).collect()
        };
        let normal_n = |frame: usize| {
            let (plate, first) = (plates.get(frame)?.as_ref()?, *contacts(frame).first()?);
            Some(plate.force_n.dot(first.normal))
        };
        let mut kept = Vec::new();
        for frame in 0..states.frames() {
            let Some(force_n) = normal_n(frame) else { continue };
            kept.push(frame);
            forces.measured_n.push(force_n);
            forces.contacts.extend(contacts(frame).iter().map(|state| (state.indentation_m, state.rate_m_s)));
        }
        (forces, kept)
    }

    /// Whether the plates measured a force under the foot.
    pub(crate) fn has_force(&self, weight_n: f64) -> bool {
        self.measured_n.iter().any(|&force_n| force_n > ON_BW * weight_n)
    }

    pub fn frames(&self) -> usize {
        self.measured_n.len()
    }

    /// The data of the frames from `first` up to `end`, without `end`.
    pub(crate) fn frame_range(&self, first: usize, end: usize) -> Self {
        let count = self.laws.len();
        Self {
            name: self.name.clone(),
            spheres: self.spheres.clone(),
            laws: self.laws.clone(),
            measured_n: self.measured_n.get(first..end).unwrap_or_default().to_vec(),
            contacts: self.contacts.get(first * count..end * count).unwrap_or_default().to_vec(),
            per_metre_down: self.per_metre_down.get(first * count..end * count).unwrap_or_default().to_vec(),
        }
    }

    /// Indentation (m) and its rate (m/s) of each contact in one frame.
    pub(crate) fn frame(&self, frame: usize) -> &[(f64, f64)] {
        let count = self.laws.len();
        self.contacts.get(frame * count..(frame + 1) * count).unwrap_or_default()
    }

    fn per_metre_down(&self, frame: usize) -> &[ChangePerMetre] {
        let count = self.laws.len();
        self.per_metre_down.get(frame * count..(frame + 1) * count).unwrap_or_default()
    }

    /// Indentation (m) and its rate (m/s) of each contact in one frame, for other heights of floor and spheres.
    pub(super) fn shifted_contacts(&self, frame: usize, by: DepthShift) -> impl Iterator<Item = (f64, f64)> {
        let per_metre = self.per_metre_down(frame);
        self.frame(frame).iter().enumerate().map(move |(number, &(x, rate))| {
            let change = per_metre.get(number).copied().unwrap_or_default();
            let x = x + by.floor_up_m + by.spheres_down_m * change.indentation;
            (x, rate + by.spheres_down_m * change.rate_s)
        })
    }

    /// x/R of each contact in one frame, for other heights of floor and spheres; empty if the plates measured no force in the
    /// frame.
    pub(super) fn loaded_depths(
        &self,
        frame: usize,
        by: DepthShift,
        weight_n: f64,
    ) -> impl Iterator<Item = f64> {
        let is_loaded = self.measured_n.get(frame).is_some_and(|&force_n| force_n > ON_BW * weight_n);
        let contacts = self.shifted_contacts(frame, by).zip(&self.laws).filter(move |_| is_loaded);
        contacts.map(|((x, _), &(_, radius_m))| x / radius_m)
    }
}

/// The change of a contact per metre that its sphere moves down in its body.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct ChangePerMetre {
    indentation: f64,
    /// Change of the indentation rate per metre, 1/s.
    rate_s: f64,
}

/// The contacts of a model along a recording, with the spheres in place and with each sphere moved by one metre along each axis
/// of its body. Contacts change linearly with these moves.
pub(super) struct LoweredSpheres<'s> {
    unmoved: &'s ContactStates,
    along: [ContactStates; 3],
    /// The direction down in the frame of the body, for the sphere of each pair.
    down: Vec<DVec3>,
}

impl<'s> LoweredSpheres<'s> {
    /// The contacts for spheres that can move. `down` comes from another recording of the same model; without it, this
    /// recording determines the direction.
    pub(super) fn of(
        model: &Model,
        recording: &Recording,
        unmoved: &'s ContactStates,
        down: Option<&[DVec3]>,
        (feet, measured): (&[Foot], &MeasuredForces),
    ) -> Result<Self, StatesError> {
        let by = |axis: DVec3| unmoved.displaced(model, recording, axis);
        let along = [by(DVec3::X)?, by(DVec3::Y)?, by(DVec3::Z)?];
        let mut lowered = Self { unmoved, along, down: down_in_bodies(model, unmoved)? };
        match down {
            Some(down) => lowered.down = down.to_vec(),
            None => lowered.turn_to_floor(feet, measured),
        }
        Ok(lowered)
    }

    /// Sets the direction down to the mean direction into the floor in the frames in which the plates measured a force.
    fn turn_to_floor(&mut self, feet: &[Foot], measured: &MeasuredForces) {
        for (foot, plates) in feet.iter().zip(&measured.feet) {
            for &pair in &foot.pairs {
                let mut sum = DVec3::ZERO;
                for (frame, plate) in plates.iter().enumerate() {
                    let force_n = plate.map_or(0.0, |plate| {
                        self.unmoved
                            .frame(frame)
                            .get(pair)
                            .map_or(0.0, |state| plate.force_n.dot(state.normal))
                    });
                    // The change of indentation along an axis of the body is how far that axis points into the floor.
                    let into = self.change_per_axis(frame, pair, |state| state.indentation_m);
                    sum += force_n.max(0.0) * into;
                }
                let length = sum.length();
                if let Some(down) = self.down.get_mut(pair).filter(|_| length > 0.0) {
                    *down = sum / length;
                }
            }
        }
    }

    /// The change of one number of a contact per metre of the sphere's move along each axis of its body.
    fn change_per_axis(&self, frame: usize, pair: usize, value: impl Fn(&ContactState) -> f64) -> DVec3 {
        let of = |states: &ContactStates| states.frame(frame).get(pair).map(&value);
        let difference = |(moved, unmoved): (f64, f64)| moved - unmoved;
        self.along.each_ref().map(|moved| of(moved).zip(of(self.unmoved)).map_or(0.0, difference)).into()
    }

    /// The change of each contact of `foot` per metre down, in the frames `kept`.
    pub(super) fn changes_per_metre(&self, foot: &Foot, kept: &[usize]) -> Vec<ChangePerMetre> {
        let each = kept.iter().flat_map(|&frame| foot.pairs.iter().map(move |&pair| (frame, pair)));
        each.filter_map(|(frame, pair)| {
            let down = *self.down.get(pair)?;
            Some(ChangePerMetre {
                indentation: down.dot(self.change_per_axis(frame, pair, |state| state.indentation_m)),
                rate_s: down.dot(self.change_per_axis(frame, pair, |state| state.rate_m_s)),
            })
        })
        .collect()
    }
}
