//! The contacts along a motion, and how they change with the corrected coordinates.

use osim_model::feet::Couplers;
use osim_model::{DVec3, Model};

use super::unknowns::CorrectedCoordinate;
use crate::states::paths_to;
use crate::{Belt, ContactState, ContactStates, Foot, Recording, StatesError};

/// Indentation (m), its rate (m/s), and the slip velocity along the two level directions (m/s) of a sphere.
pub(super) type SphereState = [f64; 4];

/// The numbers of a sphere in a frame, and its centre, m.
fn sphere_numbers(state: &ContactState, level: [DVec3; 2]) -> (SphereState, DVec3) {
    let [slip, across] = level.map(|direction| state.slip_m_s.dot(direction));
    ([state.indentation_m, state.rate_m_s, slip, across], state.centre_m)
}

/// The spheres of one foot along a motion, and how corrections of coordinates change their depth and their speed.
#[derive(Debug, Clone)]
pub(super) struct FootSlopes {
    /// The numbers of the coordinates that move the foot, among the corrected ones.
    pub(super) coordinates: Vec<usize>,
    /// All spheres in the first frame, then in the next.
    spheres: Vec<(SphereState, DVec3)>,
    /// For each element of `spheres`, the slopes by value and by speed of all `coordinates`.
    slopes: Vec<[SphereState; 2]>,
    /// For each element of `spheres`, the slopes of its centre by value of all `coordinates`.
    centre_slopes: Vec<DVec3>,
}

/// The change of a coordinate by which the slopes of spheres are computed, rad or m.
pub(super) const SLOPE_STEP: f64 = 1e-6;

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
        let known = paths_to(model, &contacts.pairs, &contacts.planes)?.motions_of_joints(recording);
        let along = |recording: &Recording| contacts.along_after(model, &known, recording, belt);
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
            let count = spheres.len() * numbers.len();
            let (slopes, centre_slopes) = (vec![[[0.0; 4]; 2]; count], vec![DVec3::ZERO; count]);
            all.push(Self { coordinates: numbers, spheres, slopes, centre_slopes });
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
                for (sphere, (before, centre)) in slopes.spheres.iter().enumerate().filter(|_| place < count)
                {
                    let (frame, pair) = (sphere / foot.pairs.len(), foot.pairs[sphere % foot.pairs.len()]);
                    let (by_value, moved_centre) = state_of(&moved, frame, pair);
                    let (by_speed, _) = state_of(&faster, frame, pair);
                    let slope = |after: SphereState, by: f64| {
                        std::array::from_fn(|place| (after[place] - before[place]) / by)
                    };
                    let index = sphere * count + place;
                    slopes.slopes[index] = [slope(by_value, SLOPE_STEP), slope(by_speed, 1.0)];
                    slopes.centre_slopes[index] = (moved_centre - *centre) / SLOPE_STEP;
                }
            }
        }
        Ok(all)
    }

    /// The slopes of a sphere by value and by speed of all `coordinates`.
    pub(super) fn slopes_of(&self, sphere: usize) -> &[[SphereState; 2]] {
        let count = self.coordinates.len();
        &self.slopes[sphere * count..(sphere + 1) * count]
    }

    /// The slopes of the centre of a sphere by value of all `coordinates`.
    pub(super) fn centre_slopes_of(&self, sphere: usize) -> &[DVec3] {
        let count = self.coordinates.len();
        &self.centre_slopes[sphere * count..(sphere + 1) * count]
    }

    /// The centre of a sphere in ground, m.
    pub(super) fn centre_m(&self, sphere: usize) -> DVec3 {
        self.spheres[sphere].1
    }

    /// The state of a sphere after corrections of all coordinates and their rates; `constants` as unknowns have them.
    pub(super) fn state(&self, sphere: usize, moves: [&[f64]; 2], constants: [f64; 3]) -> SphereState {
        let [values, rates] = moves;
        let (mut state, _) = self.spheres[sphere];
        for (number, [by_value, by_speed]) in self.coordinates.iter().zip(self.slopes_of(sphere)) {
            for (place, sum) in state.iter_mut().enumerate() {
                *sum += by_value[place] * values[*number] + by_speed[place] * rates[*number];
            }
        }
        let [floor_m, along, across] = constants;
        [state[0] + floor_m, state[1], state[2] - along, state[3] - across]
    }
}
