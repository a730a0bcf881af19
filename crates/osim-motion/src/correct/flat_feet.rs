//! Finds a default pose in which the soles lie flat.

use osim_model::feet::Couplers;
use osim_model::{DVec3, Model};

use super::unknowns::find_coordinates;
use crate::{Belt, ContactStates, CoordinateKind, Foot, Recording, StatesError};

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
    let default = recording.default_pose(&couplers)?;
    let Some(normal) = states.frame(0).first().map(|state| state.normal) else { return Ok(Vec::new()) };
    let coordinates = find_coordinates(model, &default, &couplers, states, (feet, normal))?.corrected;
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
            let turned = |by: f64| pose.changed(&couplers, |_, values, _| values[index] += by);
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
