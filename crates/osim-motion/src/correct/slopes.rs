//! The contacts along a motion, and how they change with the corrected coordinates.

use std::collections::HashSet;

use osim_model::feet::Couplers;
use osim_model::{DVec3, Model};

use super::unknowns::CorrectedCoordinate;
use crate::joint_paths::JointPaths;
use crate::{Belt, ContactState, ContactStates, Foot, Recording, StatesError};

/// Indentation (m), its rate (m/s), and the slip velocity along the two level directions (m/s) of a sphere.
pub(super) type SphereState = [f64; 4];

/// Numbers of a sphere: its [`SphereState`], and its centre, m.
type SphereNumbers = [f64; 7];

fn sphere_numbers(state: &ContactState, level: [DVec3; 2]) -> SphereNumbers {
    let [slip, across] = level.map(|direction| state.slip_m_s.dot(direction));
    let [x, y, z] = state.centre_m.to_array();
    [state.indentation_m, state.rate_m_s, slip, across, x, y, z]
}

/// The spheres of one foot along a motion.
#[derive(Debug, Clone)]
pub(super) struct FootSlopes {
    /// The numbers of the coordinates that move the foot, among the corrected ones.
    pub(super) coordinates: Vec<usize>,
    /// All spheres in the first frame, then in the next.
    spheres: Vec<SphereNumbers>,
    /// For each element of `spheres`, the slopes by value and by speed of all `coordinates`.
    slopes: Vec<[SphereNumbers; 2]>,
}

/// The change of a value by which slopes are computed, rad or m.
const SLOPE_STEP: f64 = 1e-6;

impl FootSlopes {
    /// Reads the contacts of all `feet` along `recording`, whose speeds are derivatives of its values.
    pub(super) fn all(
        model: &Model,
        (recording, belt): (&Recording, &Belt),
        couplers: &Couplers,
        contacts: &ContactStates,
        (feet, coordinates): (&[Foot], &[CorrectedCoordinate]),
        level: [DVec3; 2],
    ) -> Result<Vec<Self>, StatesError> {
        let along = |recording: &Recording| contacts.along(model, recording, belt);
        let states = along(recording)?;
        let state_of = |states: &ContactStates, frame: usize, pair: usize| {
            let state = states.frame(frame).get(pair);
            state.map(|state| sphere_numbers(state, level)).unwrap_or_default()
        };
        let mut all: Vec<Self> = Vec::new();
        for (foot, Foot { pairs, .. }) in feet.iter().enumerate() {
            let moves = |number: &usize| coordinates[*number].foot.is_none_or(|one| one == foot);
            let numbers: Vec<usize> = (0..coordinates.len()).filter(moves).collect();
            let each = (0..recording.frames()).flat_map(|frame| pairs.iter().map(move |&pair| (frame, pair)));
            let spheres: Vec<_> = each.map(|(frame, pair)| state_of(&states, frame, pair)).collect();
            let slopes = vec![[[0.0; 7]; 2]; spheres.len() * numbers.len()];
            all.push(Self { coordinates: numbers, spheres, slopes });
        }
        // No coordinate of one foot moves another: one of each foot changes at the same time.
        let most = all.iter().map(|foot| foot.coordinates.len()).max().unwrap_or(0);
        for place in 0..most {
            let numbers = all.iter().filter_map(|foot| foot.coordinates.get(place));
            let mut indices: Vec<usize> = numbers.map(|number| coordinates[*number].index).collect();
            indices.dedup();
            let changed = |value: f64, speed: f64| {
                recording.changed(couplers, |_, values, speeds| {
                    indices.iter().for_each(|&index| values[index] += value);
                    indices.iter().for_each(|&index| speeds[index] += speed);
                })
            };
            let (moved, faster) = (along(&changed(SLOPE_STEP, 0.0)?)?, along(&changed(0.0, 1.0)?)?);
            for (foot, slopes) in feet.iter().zip(&mut all) {
                let count = slopes.coordinates.len();
                for (sphere, before) in slopes.spheres.iter().enumerate().filter(|_| place < count) {
                    let (frame, pair) = (sphere / foot.pairs.len(), foot.pairs[sphere % foot.pairs.len()]);
                    let slope = |states: &ContactStates, by: f64| {
                        let after = state_of(states, frame, pair);
                        std::array::from_fn(|place| (after[place] - before[place]) / by)
                    };
                    slopes.slopes[sphere * count + place] = [slope(&moved, SLOPE_STEP), slope(&faster, 1.0)];
                }
            }
        }
        Ok(all)
    }

    /// The slopes of a sphere by value and by speed of all `coordinates`.
    pub(super) fn slopes_of(&self, sphere: usize) -> &[[SphereNumbers; 2]] {
        let count = self.coordinates.len();
        &self.slopes[sphere * count..(sphere + 1) * count]
    }

    pub(super) fn centre_m(&self, sphere: usize) -> DVec3 {
        DVec3::from_slice(&self.spheres[sphere][4..])
    }

    /// The state of a sphere after corrections of all coordinates and their rates; `constants` as unknowns have them.
    pub(super) fn state(&self, sphere: usize, moves: [&[f64]; 2], constants: [f64; 3]) -> SphereState {
        let [values, rates] = moves;
        let mut state: SphereState = std::array::from_fn(|place| self.spheres[sphere][place]);
        for (number, [by_value, by_speed]) in self.coordinates.iter().zip(self.slopes_of(sphere)) {
            for (place, sum) in state.iter_mut().enumerate() {
                *sum += by_value[place] * values[*number] + by_speed[place] * rates[*number];
            }
        }
        let [floor_m, along, across] = constants;
        [state[0] + floor_m, state[1], state[2] - along, state[3] - across]
    }
}

/// The bodies whose place is known, with their masses.
pub(super) struct CentreOfMass<'m> {
    paths: JointPaths<'m>,
    /// Index of the body in `paths`, its share of the mass, and its centre in its frame, m.
    bodies: Vec<(usize, f64, DVec3)>,
}

impl<'m> CentreOfMass<'m> {
    pub(super) fn new(model: &'m Model) -> Result<Self, StatesError> {
        let all = || model.bodies().iter().filter(|body| !body.excluded_from_mass);
        let names: HashSet<&str> = all().map(|body| body.name.as_str()).collect();
        let paths = JointPaths::of(model, &names)?;
        let mut bodies: Vec<_> = Vec::new();
        for body in all() {
            let Some(index) = paths.body(&body.name) else { continue };
            bodies.push((index, body.mass_kg()?, body.centre_of_mass_m));
        }
        let total: f64 = bodies.iter().map(|(_, mass, _)| mass).sum();
        bodies.iter_mut().for_each(|(_, mass, _)| *mass /= total);
        Ok(Self { paths, bodies })
    }

    /// The centre of mass in each frame, m.
    pub(super) fn along(&self, recording: &Recording) -> Vec<DVec3> {
        let mut places = Vec::new();
        let mut in_frame = |frame| {
            let (values, speeds) = (recording.values(frame), recording.speeds(frame));
            self.paths.place_bodies(values, speeds, &recording.has_opensim_speeds, &mut places);
            let bodies =
                self.bodies.iter().filter_map(|(index, share, at)| Some((places.get(*index)?, share, at)));
            bodies.map(|(moving, share, at)| *share * moving.at.point(*at)).sum::<DVec3>()
        };
        (0..recording.frames()).map(&mut in_frame).collect()
    }

    /// Its move with each coordinate (per rad or m): all coordinates in the first frame, then in the next.
    pub(super) fn slopes(
        &self,
        recording: &Recording,
        couplers: &Couplers,
        coordinates: &[CorrectedCoordinate],
    ) -> Result<Vec<DVec3>, StatesError> {
        let at = self.along(recording);
        let mut slopes = vec![DVec3::ZERO; recording.frames() * coordinates.len()];
        for (number, coordinate) in coordinates.iter().enumerate() {
            let moved = recording.changed(couplers, |_, values, _| values[coordinate.index] += SLOPE_STEP)?;
            for (frame, (after, before)) in self.along(&moved).iter().zip(&at).enumerate() {
                slopes[frame * coordinates.len() + number] = (*after - *before) / SLOPE_STEP;
            }
        }
        Ok(slopes)
    }
}
