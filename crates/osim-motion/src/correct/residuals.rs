//! The sum of squares that a correction makes small: the differences from the plates, and the sizes of the correction. The contacts along
//! a motion change with the corrected coordinates by slopes.

use osim_model::feet::Couplers;
use osim_model::{DVec3, Model};

use super::solve::{CONSTANTS, NormalEquations, dot_product};
use super::unknowns::{CorrectedCoordinate, CorrectionOptions, SplineBasis};
use crate::states::paths_to;
use crate::{Belt, ContactPair, ContactState, ContactStates, Foot, Recording, StatesError};

/// Differences from the plates' force along the normal, and along the floor, that count as much as a correction of usual size, body
/// weights. Friction depends on the speed of a spline, which is less certain than a depth.
const USUAL_FORCE_ERRORS_BW: [f64; 2] = [0.025, 0.042];
/// A difference from the plates' centre of pressure that counts as much as a correction of usual size, m.
const USUAL_PRESSURE_ERROR_M: f64 = 0.01;
/// An acceleration of the whole body, added by a correction, that counts as much as a correction of usual size, m/s².
const USUAL_ADDED_ACCELERATION_M_S2: f64 = 0.03 * 9.81;
/// The moves of all spheres of a foot together count as much as those of this many spheres.
const COUNTED_SPHERES: f64 = 3.0;
/// Usual sizes of the constants of a correction: the height of the floor (m), two velocities of the belt (m/s), and another height.
const USUAL_CONSTANTS: [f64; CONSTANTS] = [0.03, 2.0, 2.0, 0.03];
/// The share of the frames in which usual corrections cost as much as one constant of its usual size.
const SHARE_OF_FRAMES_PER_CONSTANT: f64 = 0.01;
/// The usual size of a constant that has to stay 0: small, so that a change of it would cost very much.
const USUAL_SIZE_OF_FIXED_CONSTANT: f64 = 1e-9;

/// What a plate measured under a foot in one frame: the force along the normal and along both level directions, N, and the
/// centre of pressure, m.
#[derive(Debug, Clone, Copy)]
pub(super) struct PlateGoal {
    pub(super) normal_n: f64,
    pub(super) level_n: [f64; 2],
    pub(super) centre_m: Option<DVec3>,
}

/// The plates' goals for one foot, frame by frame, and its contacts.
pub(super) struct FootGoals<'p> {
    pub(super) pairs: Vec<&'p ContactPair>,
    pub(super) goals: Vec<Option<PlateGoal>>,
}

/// The data for the correction of a motion that all passes of its search share.
pub(super) struct CorrectionInputs<'p> {
    pub(super) basis: SplineBasis,
    pub(super) coordinates: Vec<CorrectedCoordinate>,
    pub(super) feet: Vec<FootGoals<'p>>,
    pub(super) level: [DVec3; 2],
    pub(super) weight_n: f64,
    pub(super) options: CorrectionOptions,
    /// Which constants are unknown.
    pub(super) free: [bool; CONSTANTS],
    /// The move of the whole body's centre of mass with each coordinate in each frame.
    pub(super) centre_of_mass: Vec<DVec3>,
}

impl CorrectionInputs<'_> {
    /// The number of coefficients of all splines.
    pub(super) fn coefficients(&self) -> usize {
        self.basis.count * self.coordinates.len()
    }

    /// The corrections of all coordinates in a frame; with `order` 1 their rates.
    pub(super) fn corrections(&self, unknowns: &[f64], frame: usize, order: usize) -> Vec<f64> {
        let count = self.coordinates.len();
        let start = self.basis.first[frame] * count;
        let mut sums = vec![0.0; count];
        for (row, weight) in unknowns[start..].chunks_exact(count).zip(self.basis.weights[frame][order]) {
            sums.iter_mut().zip(row).for_each(|(sum, value)| *sum += weight * value);
        }
        sums
    }
}

/// A residual of one frame with its derivatives by corrections, by their rates, and by the constants.
#[derive(Debug, Clone)]
struct Row {
    residual: f64,
    /// For each coordinate of the foot, the derivatives by value and by rate.
    by_coordinate: Vec<[f64; 2]>,
    by_constant: [f64; CONSTANTS],
}

/// The least-squares problem of a correction, along one motion and in one stage of the search.
pub(super) struct StageProblem<'s> {
    pub(super) setting: &'s CorrectionInputs<'s>,
    pub(super) slopes: Vec<FootSlopes>,
    /// The unknowns with which `slopes` were read.
    pub(super) read_at: Vec<f64>,
    pub(super) stage: Stage,
    /// The squares of the corrections.
    pub(super) sizes: NormalEquations,
}

impl<'s> StageProblem<'s> {
    /// The problem for the contacts in `slopes`, which were read along the motion after the corrections `read_at`.
    pub(super) fn new(setting: &'s CorrectionInputs<'s>, slopes: Vec<FootSlopes>, read_at: Vec<f64>) -> Self {
        let stage = Stage { soft_m: 0.0, transition: 1.0, has_two_floors: false };
        Self { setting, sizes: correction_sizes(setting, &slopes), slopes, read_at, stage }
    }

    /// Calls `take` with the residuals of each foot in each frame; without `slopes`, rows have no derivatives.
    fn residuals(&self, unknowns: &[f64], slopes: bool, mut take: impl FnMut(usize, usize, &Row)) {
        let CorrectionInputs { level, weight_n, ref options, .. } = *self.setting;
        let difference: Vec<f64> = unknowns.iter().zip(&self.read_at).map(|(now, then)| now - then).collect();
        let place = self.setting.coefficients();
        let [unit, level_unit] = USUAL_FORCE_ERRORS_BW.map(|error_bw| 1.0 / (error_bw * weight_n));
        let mut sum = Row { residual: 0.0, by_coordinate: Vec::new(), by_constant: [0.0; CONSTANTS] };
        for frame in 0..self.setting.basis.first.len() {
            let [values, rates] = [0, 1].map(|order| self.setting.corrections(&difference, frame, order));
            for (number, (foot, along)) in self.setting.feet.iter().zip(&self.slopes).enumerate() {
                let own = f64::from(u8::from(self.stage.has_two_floors && number == 1));
                let floor_m = difference[place] + own * unknowns[place + 3];
                let constants = [floor_m, unknowns[place + 1], unknowns[place + 2]];
                let Some(goal) = foot.goals[frame] else { continue };
                let first = frame * foot.pairs.len();
                let force = |(number, pair): (usize, &&ContactPair)| {
                    let state = along.state(first + number, [&values, &rates], constants);
                    let force = force_n(pair, normal_force_n(pair, state, self.stage), state, self.stage);
                    let touches = force != [0.0; 3];
                    let by_state = || force_slopes(pair, state, self.stage, force);
                    touches.then(|| (first + number, force, if slopes { by_state() } else { [[0.0; 3]; 4] }))
                };
                let forces: Vec<_> = foot.pairs.iter().enumerate().filter_map(force).collect();
                // The sum of the forces of all spheres, each component times its factor.
                let mut row = |goal: f64, factors: &dyn Fn(usize) -> [f64; 3]| {
                    let count = if slopes { along.coordinates.len() } else { 0 };
                    (sum.residual, sum.by_constant) = (-goal, [0.0; CONSTANTS]);
                    sum.by_coordinate.clear();
                    sum.by_coordinate.resize(count, [0.0; 2]);
                    for (sphere, force, slopes) in &forces {
                        let factors = factors(*sphere);
                        sum.residual += dot_product(&factors, force);
                        let by = slopes.map(|by| dot_product(&factors, &by));
                        for (sums, by_both) in sum.by_coordinate.iter_mut().zip(along.slopes_of(*sphere)) {
                            sums.iter_mut()
                                .zip(by_both)
                                .for_each(|(sum, numbers)| *sum += dot_product(&by, numbers));
                        }
                        sum.by_constant[0] += by[0];
                        sum.by_constant[1] -= by[2];
                        sum.by_constant[2] -= by[3];
                        sum.by_constant[3] += own * by[0];
                    }
                    take(frame, number, &sum);
                };
                row(goal.normal_n * unit, &|_| [unit, 0.0, 0.0]);
                if let Some(centre_m) = goal.centre_m {
                    for direction in level.map(|direction| direction / (USUAL_PRESSURE_ERROR_M * weight_n)) {
                        row(0.0, &|sphere| [(along.centre_m(sphere) - centre_m).dot(direction), 0.0, 0.0]);
                    }
                }
                if !options.vertical_only && self.stage.transition > 0.0 {
                    row(goal.level_n[0] * level_unit, &|_| [0.0, level_unit, 0.0]);
                    row(goal.level_n[1] * level_unit, &|_| [0.0, 0.0, level_unit]);
                }
            }
        }
    }

    /// The sum of squares at these unknowns.
    pub(super) fn cost(&self, unknowns: &[f64]) -> f64 {
        let mut sum: f64 = self.sizes.times_vector(unknowns).iter().zip(unknowns).map(|(a, b)| a * b).sum();
        self.residuals(unknowns, false, |_, _, row| sum += row.residual * row.residual);
        sum
    }

    /// The linearised problem at these unknowns.
    fn normal_equations(&self, unknowns: &[f64]) -> NormalEquations {
        let mut equations = self.sizes.clone();
        equations.gradient = self.sizes.times_vector(unknowns);
        let (basis, count) = (&self.setting.basis, self.setting.coordinates.len());
        // The rows of one foot in one frame depend on the same unknowns.
        let (mut block, mut places) = ((usize::MAX, 0), Vec::new());
        let (mut slopes, mut residuals) = (Vec::new(), Vec::new());
        self.residuals(unknowns, true, |frame, foot, row| {
            let [values, rates, _] = &basis.weights[frame];
            if block != (frame, foot) {
                equations.add(&places, &slopes, &residuals);
                block = (frame, foot);
                places.clear();
                slopes.clear();
                residuals.clear();
                let starts = (basis.first[frame]..).take(values.len()).map(|spline| spline * count);
                let of_foot = &self.slopes[foot].coordinates;
                places.extend(starts.flat_map(|start| of_foot.iter().map(move |number| start + number)));
                places.extend((0..CONSTANTS).map(|number| basis.count * count + number));
            }
            for (value, rate) in values.iter().zip(rates) {
                slopes.extend(row.by_coordinate.iter().map(|by| value * by[0] + rate * by[1]));
            }
            slopes.extend(row.by_constant);
            residuals.push(row.residual);
        });
        equations.add(&places, &slopes, &residuals);
        equations
    }
}

/// The largest number of Gauss-Newton steps in one search.
const MOST_STEPS: usize = 40;
/// The relative decrease of the cost at which a stage ends.
const SMALLEST_DECREASE: f64 = 1e-3;

/// Makes the cost small by damped Gauss-Newton steps, until it decreases by less than a part of itself, and returns it.
pub(super) fn minimise(problem: &StageProblem<'_>, unknowns: &mut Vec<f64>) -> f64 {
    let (mut cost, mut damping) = (problem.cost(unknowns), 1e-4);
    for _ in 0..MOST_STEPS {
        let equations = problem.normal_equations(unknowns);
        let mut decrease = 0.0;
        while damping < 1e6 {
            let step = equations.damped_step(damping).unwrap_or_default();
            let next: Vec<f64> = unknowns.iter().zip(&step).map(|(value, change)| value + change).collect();
            let after = if next.len() == unknowns.len() { problem.cost(&next) } else { f64::INFINITY };
            if after <= cost {
                decrease = cost - after;
                (*unknowns, cost, damping) = (next, after, (damping / 10.0_f64).max(1e-9));
                break;
            }
            damping *= 8.0;
        }
        if decrease <= SMALLEST_DECREASE * cost {
            break;
        }
    }
    cost
}

/// The normal equations of all terms that keep a correction small: changes of coordinates, moves of spheres, accelerations and constants.
fn correction_sizes(setting: &CorrectionInputs<'_>, slopes: &[FootSlopes]) -> NormalEquations {
    let (basis, coordinates) = (&setting.basis, &setting.coordinates);
    let count = coordinates.len();
    let mut sizes = NormalEquations::new(setting.coefficients(), count);
    let (mut places, mut slopes_of_row) = (Vec::new(), Vec::new());
    // Adds the square of a sum over coordinates of a frame; `order` 2 takes the accelerations.
    let mut add = |sizes: &mut NormalEquations, frame: usize, order: usize, by: &[(usize, f64)]| {
        places.clear();
        slopes_of_row.clear();
        for (spline, weight) in basis.weights[frame][order].iter().enumerate() {
            let start = (basis.first[frame] + spline) * count;
            places.extend(by.iter().map(|(number, _)| start + number));
            slopes_of_row.extend(by.iter().map(|(_, slope)| weight * slope));
        }
        sizes.add(&places, &slopes_of_row, &[0.0]);
    };
    for frame in 0..basis.first.len() {
        for (number, coordinate) in coordinates.iter().enumerate() {
            add(&mut sizes, frame, 0, &[(number, 1.0 / coordinate.usual_correction(&setting.options))]);
        }
        for (foot, along) in setting.feet.iter().zip(slopes) {
            let spheres = foot.pairs.len();
            let unit = (COUNTED_SPHERES / spheres as f64).sqrt() / setting.options.length_m;
            let of_foot = along.coordinates.len();
            let mut products = vec![0.0; of_foot * of_foot];
            for sphere in frame * spheres..(frame + 1) * spheres {
                let slopes = along.centre_slopes_of(sphere);
                for (row, by) in products.chunks_exact_mut(of_foot).zip(slopes) {
                    row.iter_mut().zip(slopes).for_each(|(sum, other)| *sum += unit * unit * by.dot(*other));
                }
            }
            let blocks = basis.weights[frame][0].iter().enumerate();
            let blocks = blocks.map(|(spline, weight)| ((basis.first[frame] + spline) * count, *weight));
            sizes.add_products(&blocks.collect::<Vec<_>>(), &along.coordinates, &products);
        }
        let moves = &setting.centre_of_mass[frame * count..(frame + 1) * count];
        for axis in 0..3 {
            let by: Vec<(usize, f64)> =
                moves.iter().map(|by| by[axis] / USUAL_ADDED_ACCELERATION_M_S2).enumerate().collect();
            add(&mut sizes, frame, 2, &by);
        }
    }
    let counted = (SHARE_OF_FRAMES_PER_CONSTANT * basis.first.len() as f64).sqrt();
    for (number, size) in USUAL_CONSTANTS.into_iter().enumerate() {
        let size = if setting.free[number] { size } else { USUAL_SIZE_OF_FIXED_CONSTANT };
        sizes.add(&[setting.coefficients() + number], &[counted / size], &[0.0]);
    }
    sizes
}

// The force of a sphere and its slopes, at first with a softened law.

/// How forces are computed in one stage of the search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stage {
    /// The depth over which contacts begin, m; 0 for the law of the model.
    pub(super) soft_m: f64,
    /// The factor of the transition velocity; 0 without friction.
    pub(super) transition: f64,
    /// Whether the floor of the second foot has a height of its own.
    pub(super) has_two_floors: bool,
}

/// The width over which a soft force falls to 0 when a sphere leaves the floor fast, as a share of the force at rest.
const RELEASE_WIDTH_SHARE: f64 = 0.1;
/// The steps by which slopes of a force are computed: depth, its rate, and both components of the slip.
const SLOPE_STEPS: SphereState = [1e-7, 1e-6, 1e-6, 1e-6];

/// The force on a sphere along the normal, N.
fn normal_force_n(pair: &ContactPair, [x, rate, ..]: SphereState, Stage { soft_m, .. }: Stage) -> f64 {
    if soft_m > 0.0 {
        let depth = soft_positive(x, soft_m);
        let damping = soft_positive(1.0 + 1.5 * pair.law.dissipation() * rate, RELEASE_WIDTH_SHARE);
        pair.law.hertz().coefficient() * depth * depth.sqrt() * damping
    } else {
        pair.law.force(x, rate)
    }
}

/// The force on a sphere along the normal, which is known, and along the two level directions, N.
fn force_n(pair: &ContactPair, normal_n: f64, state: SphereState, stage: Stage) -> [f64; 3] {
    let ([_, _, slip @ ..], Stage { soft_m, transition, .. }) = (state, stage);
    if normal_n == 0.0 || transition == 0.0 {
        return [normal_n, 0.0, 0.0];
    }
    let smoothing = pair.smoothing.filter(|_| soft_m == 0.0).unwrap_or(0.0);
    let speed = (slip[0] * slip[0] + slip[1] * slip[1] + smoothing).sqrt().max(SLOPE_STEPS[2]);
    // A transition velocity that is larger by the factor.
    let share = pair.friction.coefficient(speed / transition) / speed;
    [normal_n, -normal_n * share * slip[0], -normal_n * share * slip[1]]
}

/// The slopes of the `force` in a state by each number of this state.
fn force_slopes(pair: &ContactPair, state: SphereState, stage: Stage, force: [f64; 3]) -> [[f64; 3]; 4] {
    std::array::from_fn(|place| {
        let mut above = state;
        above[place] += SLOPE_STEPS[place];
        // The slip does not change the normal force.
        let normal_n = if place < 2 { normal_force_n(pair, above, stage) } else { force[0] };
        let above = force_n(pair, normal_n, above, stage);
        std::array::from_fn(|axis| (above[axis] - force[axis]) / SLOPE_STEPS[place])
    })
}

/// w ln(1 + e^(x/w)), which is nearly 0 below 0 and nearly x above.
fn soft_positive(x: f64, width: f64) -> f64 {
    x.max(0.0) + width * libm::log1p(libm::exp(-(x / width).abs()))
}

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_soft_part_is_far_away_exact() {
        assert!((soft_positive(1.0, 0.01) - 1.0).abs() < 1e-15);
        assert!(soft_positive(-1.0, 0.01) < 1e-40);
        assert!((soft_positive(0.0, 0.5) - 0.5 * 2.0_f64.ln()).abs() < 1e-15);
    }
}
