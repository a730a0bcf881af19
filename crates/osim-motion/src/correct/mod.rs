//! Corrects a motion by the least that makes the contacts of a model give the forces of the plates. Also finds a default pose in which
//! the soles lie flat.
//!
//! The unknowns are the height of the floor, the velocity of a belt, and splines in time: of the root's height, and of each
//! coordinate that moves the spheres of one foot. Contacts are soft at first, so that spheres above the floor feel it. After that,
//! the contacts are read again along the corrected motion.

mod dynamics;
mod figures;
mod inertia;
mod residuals;
mod solve;
mod unknowns;
mod verdict;

use osim_model::feet::Couplers;
use osim_model::{DVec3, Model};

use crate::{
    Belt, ContactStates, CoordinateKind, Foot, MeasuredForces, MotionFault, Recording, StancePhase,
    StatesError, TOUCH_DOWN_BW, Wrench,
};
use dynamics::Masses;
use inertia::inertia_n;
use residuals::{CorrectionInputs, FootGoals, FootSlopes, PlateGoal, Stage, StageProblem, minimise};
use solve::CONSTANTS;
use unknowns::{SplineBasis, find_coordinates, knot_distance_s};

pub use dynamics::{InverseDynamics, RootResidual};
pub use figures::{CorrectionFigures, FootErrors, ForceErrors};
pub use unknowns::CorrectionOptions;
pub use verdict::{Mismatch, MotionVerdict, mismatches};

/// A corrected motion.
#[derive(Debug, Clone)]
pub struct Correction {
    /// The motion, with locked coordinates at their defaults. On a treadmill it moves against the belt.
    pub recording: Recording,
    /// The coordinate that is the height of the root.
    pub root_height: String,
    /// The distance by which the floor is higher than in the model, m; the root is lower by it.
    pub floor_up_m: f64,
    /// The mean velocity of the belt, m/s; 0 without a treadmill.
    pub belt_m_s: DVec3,
    /// The way of the belt since the first frame, m; the plates' points move back by it.
    pub belt_way_m: Vec<DVec3>,
    pub figures: CorrectionFigures,
    pub dynamics: InverseDynamics,
    /// The names of locked coordinates inside feet, such as toe joints, which no correction touches.
    pub locked: Vec<String>,
}

/// A part of a correction, or the reason why there is none.
type Result<T, E = CorrectionError> = std::result::Result<T, E>;

/// Why a motion cannot be corrected.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CorrectionError {
    /// No free coordinate moves all spheres along the normal of the floor by its own value.
    #[error("no free coordinate lifts the whole model: its motion cannot be corrected")]
    NoRootHeight,
    /// The root cannot follow the belt.
    #[error(
        "no free coordinate moves the whole model along the belt: its motion cannot be corrected on this treadmill"
    )]
    NoRootAlongBelt,
    #[error("the plates measured no force under a foot")]
    NoForce,
    #[error(transparent)]
    States(#[from] StatesError),
}

impl From<MotionFault> for CorrectionError {
    fn from(fault: MotionFault) -> Self {
        Self::States(StatesError::Motion(fault))
    }
}

/// The depth over which contacts begin in each stage of the search for a correction, m; with 0, they have the model's law. The search
/// begins with soft contacts.
const SOFT_DEPTHS_OF_STAGES_M: [f64; 8] = [0.02, 0.01, 0.005, 0.002, 0.002, 0.0, 0.0, 0.0];
/// The factor of the transition velocity in each stage of the search for a correction; with 0, there is no friction.
const TRANSITION_FACTORS_OF_STAGES: [f64; 8] = [0.0, 0.0, 0.0, 0.0, 10.0, 10.0, 3.0, 1.0];
/// The index of the last stage of the search for a correction. Later passes have only this stage.
const LAST_STAGE: usize = 7;

/// The contacts are read along the corrected motion at least this many times.
const LEAST_PASSES: usize = 2;
/// The contacts are read along the corrected motion at most this many times.
const MOST_PASSES: usize = 8;
/// The search for a correction ends if the cost changes by less than this (relative) when the contacts are read again.
const LARGEST_COST_CHANGE_AT_END: f64 = 0.001;
/// If loaded feet are on average slower than this, m/s, they stand on a floor at rest, and not on a belt.
const FASTEST_STANDING_FOOT_M_S: f64 = 0.4;
/// The largest part of a belt's velocity that no coordinate of the root may follow, m/s; a larger part is an error.
const LARGEST_UNFOLLOWED_BELT_M_S: f64 = 0.01;

/// The largest force along the normal that is taken for the force of a foot beside the plates, body weights.
const MOST_MISSING_BW: f64 = 1.5;
/// A stance that is shorter than this, s, is a contact by chance, and does not decide how fine a correction may be.
const SHORTEST_STANCE_S: f64 = 0.08;
/// The duration of a stance that is assumed if the recording has no whole stance, s.
const USUAL_STANCE_S: f64 = 0.5;

/// Corrects `recording`, along which a model has the contacts `states`, to the forces that were `measured` under its `feet`.
///
/// # Errors
/// No coordinate for the height of the root, no measured force, or a motion whose states cannot be computed.
pub fn correct(
    model: &Model,
    recording: &Recording,
    (states, feet): (&ContactStates, &[Foot]),
    measured: &MeasuredForces,
    weight_n: f64,
    options: &CorrectionOptions,
) -> Result<Correction> {
    let couplers = Couplers::of(model);
    // Locked coordinates are at their defaults, and speeds follow from the values, as OpenSim's tools take them.
    let locked = recording.changed(couplers, |_, values, _| {
        for (value, coordinate) in values.iter_mut().zip(&recording.coordinates) {
            if let Some(default) = coordinate.default.filter(|_| coordinate.locked) {
                *value = default;
            }
        }
    })?;
    let unmoved = locked.with_splined_speeds(couplers, |_| true)?;
    let floor = feet.first().and_then(|foot| foot.floor(states));
    let (normal, on_floor_m) = floor.ok_or(CorrectionError::NoForce)?;
    let forward = (DVec3::X - normal * normal.x).try_normalize().unwrap_or(DVec3::Z);
    let level = [forward, forward.cross(normal)];
    let found = find_coordinates(model, &unmoved, couplers, states, (feet, normal))?;
    let root = found.corrected.first().ok_or(CorrectionError::NoRootHeight)?.index;
    let goal = |foot: usize, wrench: &Wrench| PlateGoal {
        normal_n: wrench.force_n.dot(normal).max(0.0),
        level_n: level.map(|direction| wrench.force_n.dot(direction)),
        centre_m: wrench
            .centre_of_pressure(normal, on_floor_m, TOUCH_DOWN_BW * weight_n)
            .filter(|_| measured.has_points.get(foot) == Some(&true) && wrench.force_n.dot(normal) > 0.0)
            .map(|centre| centre.point_m),
    };
    let masses = Masses::new(model)?;
    let gravity_m_s2 = DVec3::from(model.gravity_m_s2.unwrap_or_default());
    let kg = weight_n / gravity_m_s2.length();
    let is_partly_known =
        |forces: &Vec<Option<Wrench>>| forces.chunk_by(|a, b| a.is_some() == b.is_some()).nth(1).is_some();
    let has_gaps = measured.feet.iter().any(is_partly_known);
    let inertia_n = if has_gaps { inertia_n(&masses, &unmoved, kg) } else { Vec::new() };
    // Beside the plates, a foot has what the motion of the whole body needs, less the forces of the other feet.
    let missing = |foot: usize, frame: usize| {
        let others = measured.feet.iter().enumerate().filter(|(other, _)| *other != foot);
        let others_n = others.map(|(_, forces)| Some(forces[frame]?.force_n)).sum::<Option<DVec3>>()?;
        let force_n = (*inertia_n.get(frame)?)? - kg * gravity_m_s2 - others_n;
        let normal_n = force_n.dot(normal).clamp(0.0, MOST_MISSING_BW * weight_n);
        let level_n = level.map(|direction| if normal_n > 0.0 { force_n.dot(direction) } else { 0.0 });
        force_n.is_finite().then_some(PlateGoal { normal_n, level_n, centre_m: None })
    };
    let goals_of_foot = |(foot, wrenches): (usize, &Vec<Option<Wrench>>)| {
        let in_frame = |(frame, wrench): (usize, &Option<Wrench>)| match wrench {
            Some(wrench) => Some(goal(foot, wrench)),
            None => missing(foot, frame).filter(|_| is_partly_known(wrenches)),
        };
        FootGoals {
            pairs: feet[foot].pairs.iter().filter_map(|&pair| states.pairs.get(pair)).collect(),
            goals: wrenches.iter().enumerate().map(in_frame).collect(),
        }
    };
    let goals: Vec<FootGoals<'_>> = measured.feet.iter().enumerate().map(goals_of_foot).collect();
    let mut all = goals.iter().flat_map(|foot| &foot.goals).flatten();
    if !all.any(|goal| goal.normal_n > TOUCH_DOWN_BW * weight_n) {
        return Err(CorrectionError::NoForce);
    }
    // Without goals along the floor, the feet themselves show the belt.
    let standing = options.standing_m_s;
    let moves = standing.length() >= FASTEST_STANDING_FOOT_M_S;
    let belt = match &options.belt {
        Some(belt) => belt.clone(),
        None if moves && options.vertical_only => Belt::Constant(standing),
        None => Belt::default(),
    };
    let searches_belt = options.belt.is_none() && moves && !options.vertical_only;
    // The root of a planar model follows a belt in one direction only; one that follows in none is an error below.
    let follows =
        level.map(|direction| found.level.iter().any(|(_, along)| along.dot(direction).abs() > 0.5));
    let free_belt = follows.map(|follows_it| searches_belt && (follows_it || follows == [false; 2]));
    let time_s = unmoved.time_s.last().zip(unmoved.time_s.first()).map_or(1.0, |(end, start)| end - start);
    let frame_s = time_s / unmoved.frames() as f64;
    let knots_s = knot_distance_s(shortest_stance_s(&unmoved.time_s, &goals, weight_n), frame_s);
    let original = match options.floor_up_m {
        Some(up_m) => unmoved.changed(couplers, |_, values, _| values[root] -= up_m)?,
        None => unmoved.clone(),
    };
    let setting = CorrectionInputs {
        basis: SplineBasis::new(&original.time_s, knots_s),
        centre_of_mass: masses.centre_slopes(&original, couplers, &found.corrected)?,
        coordinates: found.corrected.clone(),
        feet: goals,
        level,
        weight_n,
        options: options.clone(),
        free: [options.floor_up_m.is_none(), free_belt[0], free_belt[1], feet.len() == 2],
    };
    let search = Search { model, couplers, original, states, feet, belt };
    let mut unknowns = vec![0.0; setting.coefficients() + CONSTANTS];
    let place = setting.coefficients();
    let two_floors = search.run(&setting, &mut unknowns)?;
    let found_belt = level[0] * unknowns[place + 1] + level[1] * unknowns[place + 2];
    let belt = if searches_belt { Belt::Constant(found_belt) } else { search.belt.clone() };
    let in_place = search.corrected(&setting, &unknowns)?;
    let floor_up_m = options.floor_up_m.unwrap_or(unknowns[place]);
    let along = |recording: &Recording| states.along(model, recording, &belt);
    let (before, after) = (along(&unmoved)?, along(&in_place)?);
    let (both, floor) = ((&before, &after), (normal, on_floor_m));
    let found_values = (&*unknowns, floor_up_m, two_floors);
    let figures = CorrectionFigures::new(&setting, both, (feet, measured), floor, found_values);
    let motions = [(&unmoved, &before), (&in_place, &after)];
    let dynamics =
        InverseDynamics::compare(&masses, search.couplers, motions, (feet, measured), &found, weight_n)?;
    let way_m = belt.way_m(&in_place.time_s);
    let follow = |way: DVec3| found.level.iter().map(|(_, along)| way.dot(*along) * *along).sum::<DVec3>();
    let belt_m_s = way_m.last().copied().unwrap_or_default() / time_s;
    if (belt_m_s - follow(belt_m_s)).length() > LARGEST_UNFOLLOWED_BELT_M_S {
        return Err(CorrectionError::NoRootAlongBelt);
    }
    let recording = in_place.changed(search.couplers, |frame, values, _| {
        found.level.iter().for_each(|(index, along)| values[*index] -= way_m[frame].dot(*along));
    })?;
    let root_height = recording.coordinates[root].name.clone();
    let (belt_way_m, locked) = (way_m, found.locked_in_feet);
    Ok(Correction { recording, root_height, floor_up_m, belt_m_s, belt_way_m, figures, dynamics, locked })
}

/// The model, its recording and its contacts, for which a correction is searched.
struct Search<'s> {
    model: &'s Model,
    couplers: &'s Couplers,
    original: Recording,
    states: &'s ContactStates,
    feet: &'s [Foot],
    /// The known part of the belt's motion.
    belt: Belt,
}

impl Search<'_> {
    /// Searches the correction: reads the contacts along the motion in several passes, and makes the cost small in each, stage after
    /// stage. Returns how much higher the floor would be under the second of two feet, m, and the share of the cost that would remain.
    fn run(&self, setting: &CorrectionInputs<'_>, unknowns: &mut Vec<f64>) -> Result<(f64, f64)> {
        let (mut cost, mut pass) = (f64::INFINITY, 0);
        loop {
            let moved = self.corrected(setting, unknowns)?;
            let parts = (self.feet, setting.coordinates.as_slice());
            let (model, states) = (self.model, self.states);
            let slopes =
                FootSlopes::all(model, (&moved, &self.belt), self.couplers, states, parts, setting.level)?;
            let mut problem = StageProblem::new(setting, slopes, unknowns.clone());
            let ends = pass >= LEAST_PASSES
                && (problem.cost(unknowns) - cost).abs() <= LARGEST_COST_CHANGE_AT_END * cost;
            let first = [0, LAST_STAGE][usize::from(pass > 0)];
            for stage in (first..=LAST_STAGE).filter(|_| !ends) {
                let (soft_m, transition) =
                    (SOFT_DEPTHS_OF_STAGES_M[stage], TRANSITION_FACTORS_OF_STAGES[stage]);
                problem.stage = Stage { soft_m, transition, has_two_floors: false };
                cost = minimise(&problem, unknowns);
            }
            pass += 1;
            if ends || pass == MOST_PASSES {
                problem.stage.has_two_floors = true;
                let (mut apart, before) = (unknowns.clone(), problem.cost(unknowns));
                let after = minimise(&problem, &mut apart);
                return Ok((apart[setting.coefficients() + 3], after / before));
            }
        }
    }

    /// The motion after corrections; the height of the floor moves the root.
    fn corrected(&self, setting: &CorrectionInputs<'_>, unknowns: &[f64]) -> Result<Recording> {
        let floor_up_m = unknowns[setting.coefficients()];
        let moved = self.original.changed(self.couplers, |frame, values, _| {
            let corrections = setting.corrections(unknowns, frame, 0);
            for (coordinate, by) in setting.coordinates.iter().zip(corrections) {
                values[coordinate.index] += if coordinate.foot.is_none() { by - floor_up_m } else { by };
            }
        })?;
        let is_corrected = |index: &usize| setting.coordinates.iter().any(|one| one.index == *index);
        Ok(moved.with_splined_speeds(self.couplers, is_corrected)?)
    }
}

/// The duration of the shortest whole stance in the plates' forces, s.
fn shortest_stance_s(time_s: &[f64], feet: &[FootGoals<'_>], weight_n: f64) -> f64 {
    let stances = feet.iter().flat_map(|foot| {
        let force_n: Vec<f64> =
            foot.goals.iter().map(|goal| goal.map_or(f64::NAN, |goal| goal.normal_n)).collect();
        StancePhase::all(time_s, &force_n, weight_n)
    });
    let whole = stances.filter_map(|stance| stance.duration_s()).filter(|&time| time > SHORTEST_STANCE_S);
    whole.reduce(f64::min).unwrap_or(USUAL_STANCE_S)
}

/// A sole is flat if the lowest points of its spheres are at heights that differ by no more than this, m: spheres may be laid so.
const FLAT_M: f64 = 0.01;
/// How often the joints of a leg are turned, one after the other, to lay its foot flat.
const ROUNDS: usize = 20;
/// The change of a joint's angle that shows how the foot moves with it, rad.
const NUDGE_RAD: f64 = 1e-4;
/// The weight of a move of the foot, compared with unequal heights of its spheres, in the search for a flat foot.
const STAYING: f64 = 0.05;

/// New default values of the coordinates with which the feet lie flat; none if all feet do already. Locked coordinates stay.
///
/// # Errors
/// States that cannot be computed.
pub fn flat_feet(
    model: &Model,
    recording: &Recording,
    states: &ContactStates,
    feet: &[Foot],
) -> Result<Vec<(String, f64)>, StatesError> {
    let couplers = Couplers::of(model);
    let default = recording.default_pose(couplers)?;
    let Some(normal) = states.frame(0).first().map(|state| state.normal) else { return Ok(Vec::new()) };
    let coordinates = find_coordinates(model, &default, couplers, states, (feet, normal))?.corrected;
    let mut pose = default.clone();
    for (number, foot) in feet.iter().enumerate() {
        let bottoms = |pose: &Recording| -> Result<Vec<DVec3>, StatesError> {
            let states = states.along(model, pose, &Belt::default())?;
            let bottom = |&pair: &usize| {
                Some(states.frame(0).get(pair)?.centre_m - states.pairs.get(pair)?.radius_m * normal)
            };
            Ok(foot.pairs.iter().filter_map(bottom).collect())
        };
        let mean = |points: &[DVec3]| points.iter().sum::<DVec3>() / points.len() as f64;
        let start = bottoms(&pose)?;
        let heights = || start.iter().map(|point| point.dot(normal));
        if heights().fold(f64::MIN, f64::max) - heights().fold(f64::MAX, f64::min) <= FLAT_M {
            continue;
        }
        let errors = |pose: &Recording| -> Result<Vec<f64>, StatesError> {
            let points = bottoms(pose)?;
            let tilts = points.iter().map(|point| (*point - mean(&points)).dot(normal));
            let moved = STAYING * (mean(&points) - mean(&start));
            Ok(tilts.chain(moved.to_array()).collect())
        };
        // From the foot up: the ankle turns before the hip.
        let is_own = |angle: usize| {
            coordinates[angle].foot == Some(number) && coordinates[angle].kind == CoordinateKind::Rotational
        };
        let angles: Vec<usize> = (0..coordinates.len()).rev().filter(|&angle| is_own(angle)).collect();
        for angle in std::iter::repeat_n(angles, ROUNDS).flatten() {
            let index = coordinates[angle].index;
            let turned = |by: f64| pose.changed(couplers, |_, values, _| values[index] += by);
            let before = errors(&pose)?;
            let after = errors(&turned(NUDGE_RAD)?)?;
            let slope = |(after, before): (&f64, &f64)| (after - before) / NUDGE_RAD;
            let slopes: Vec<f64> = after.iter().zip(&before).map(slope).collect();
            let (along, size): (f64, f64) =
                slopes.iter().zip(&before).fold((0.0, 0.0), |(along, size), (slope, error)| {
                    (along + slope * error, size + slope * slope)
                });
            if size > 0.0 {
                pose = turned(-along / size)?;
            }
        }
    }
    let names = pose.coordinates.iter().map(|coordinate| coordinate.name.clone());
    let values = names.zip(pose.values(0).to_vec()).zip(default.values(0));
    Ok(values.filter(|((_, value), before)| value != *before).map(|(pair, _)| pair).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::Table;
    use crate::{RecordingOptions, StatesError};

    /// A body of 1 kg with one sphere that moves in a plane above the floor.
    fn ball_model() -> Model {
        let text = "<OpenSimDocument Version=\"40000\"><Model><BodySet><objects><Body name=\"b\"><mass>1</mass></Body></objects></BodySet>\
         <JointSet><objects><PlanarJoint name=\"j\"><socket_parent_frame>/ground</socket_parent_frame><socket_child_frame>/bodyset/b\
         </socket_child_frame><coordinates><Coordinate name=\"turn\"/><Coordinate name=\"x\"/><Coordinate name=\"y\"/></coordinates>\
         </PlanarJoint></objects></JointSet><ContactGeometrySet><objects><ContactSphere name=\"s\"><socket_frame>/bodyset/b</socket_frame>\
         <location>0 0 0</location><radius>0.03</radius></ContactSphere><ContactHalfSpace name=\"floor\"><socket_frame>/ground\
         </socket_frame><orientation>0 0 -1.5707963267948966</orientation></ContactHalfSpace></objects></ContactGeometrySet><ForceSet>\
         <objects><HuntCrossleyForce name=\"f\"><contact_parameters><HuntCrossleyForce::ContactParametersSet><objects>\
         <HuntCrossleyForce::ContactParameters><geometry>s floor</geometry><stiffness>1e6</stiffness><dissipation>1</dissipation>\
         </HuntCrossleyForce::ContactParameters></objects></HuntCrossleyForce::ContactParametersSet></contact_parameters>\
         </HuntCrossleyForce></objects></ForceSet></Model></OpenSimDocument>";
        Model::parse(text).unwrap()
    }

    /// The ball bounces 5 mm deep into the floor twice; the whole motion is higher by `up_m`.
    fn bounces(model: &Model, up_m: f64) -> Result<(Recording, ContactStates), StatesError> {
        let mut text = "inDegrees=no\nendheader\ntime\tturn\tx\ty\n".to_owned();
        for frame in 0..220 {
            let time = 0.01 * f64::from(frame);
            let y = 0.025 + 0.02 * (1.0 + (std::f64::consts::TAU * time).cos()) + up_m;
            text.push_str(&format!("{time}\t0\t0\t{y}\n"));
        }
        let recording =
            Recording::of(model, &Table::read(text.as_bytes()).unwrap(), &RecordingOptions::default())?;
        let states = ContactStates::of(model, &recording, &model.force_ids(), &Belt::default())?;
        Ok((recording, states))
    }

    #[test]
    fn a_motion_that_is_too_high_comes_down() {
        let (model, weight_n) = (ball_model(), 20.0);
        let (_, truth) = bounces(&model, 0.0).unwrap();
        let feet = Foot::all(&model, &truth, &model.force_ids());
        let wrenches: Vec<Option<Wrench>> =
            (0..truth.frames()).map(|frame| Some(Wrench::from_states(truth.frame(frame)))).collect();
        let measured = MeasuredForces {
            uses: Vec::new(),
            total: wrenches.clone(),
            feet: vec![wrenches],
            beside: vec![0],
            has_points: vec![true],
        };
        for up_m in [0.0, 0.02, -0.01] {
            let (recording, states) = bounces(&model, up_m).unwrap();
            let options = CorrectionOptions::default();
            let found = correct(&model, &recording, (&states, &feet), &measured, weight_n, &options).unwrap();
            let figures = &found.figures;
            assert!((found.floor_up_m - up_m).abs() < 3e-4, "{found:?}");
            assert!(figures.feet[0].after.vertical_bw < 0.005 && figures.lift_p95_m < 3e-4, "{figures:?}");
            assert_eq!(found.belt_m_s, DVec3::ZERO);
        }
    }
}
