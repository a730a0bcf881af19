//! What a correction changes: coordinates, by cubic B-splines over time.

use osim_model::feet::Couplers;
use osim_model::{DVec3, Model};

use crate::coordinates::CoordinateKind;
use crate::states::paths_to;
use crate::{Belt, ContactStates, Foot, Recording, StatesError};

/// The options for the correction of a motion.
#[derive(Debug, Clone, PartialEq)]
pub struct CorrectionOptions {
    /// Whether horizontal forces are left out.
    pub vertical_only: bool,
    /// The mean velocity of standing feet along the floor, m/s; on a treadmill it is that of the belt.
    pub standing_m_s: DVec3,
    /// The motion of a treadmill's belt; `None` if it is found.
    pub belt: Option<Belt>,
    /// How much higher the floor is than in the model, m; `None` if it is found.
    pub floor_up_m: Option<f64>,
    /// A usual error of the places of spheres and of the root's height, m.
    pub length_m: f64,
    /// A usual error of joint angles, rad; 2.5 times as much for toes.
    pub angle_rad: f64,
}

impl Default for CorrectionOptions {
    /// Errors of 6 mm and 2 degrees, on a floor at rest.
    fn default() -> Self {
        Self {
            vertical_only: false,
            standing_m_s: DVec3::ZERO,
            belt: None,
            floor_up_m: None,
            length_m: 0.006,
            angle_rad: std::f64::consts::PI / 90.0,
        }
    }
}

/// A coordinate that the correction changes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct CorrectedCoordinate {
    /// Index among the coordinates of the model.
    pub(super) index: usize,
    /// The foot that the coordinate moves; `None` for the height of the root.
    pub(super) foot: Option<usize>,
    /// Whether the coordinate moves only some spheres of its foot, as a toe joint does.
    pub(super) moves_toes: bool,
    pub(super) kind: CoordinateKind,
}

/// The change of a value that shows which spheres a coordinate moves, rad or m.
const TRIAL_STEP: f64 = 1e-4;
/// The largest number of frames in which it is tried, out of all.
const MOST_TRIAL_FRAMES: usize = 50;
/// A sphere that moves by less than this part of the change of a coordinate does not follow it.
const LEAST_MOVE: f64 = 1e-6;

/// The coordinates that the correction of a motion changes.
#[derive(Debug, Clone, Default)]
pub(super) struct CoordinatesOfCorrection {
    /// The height of the root, and then all coordinates that move the spheres of one foot; none if no coordinate is such a
    /// height.
    pub(super) corrected: Vec<CorrectedCoordinate>,
    /// The coordinates that move all spheres along the floor by their own value, with the direction.
    pub(super) level: Vec<(usize, DVec3)>,
    /// The names of locked coordinates that move only some spheres of a foot, as a toe joint does.
    pub(super) locked_in_feet: Vec<String>,
}

/// Finds the coordinates that a correction uses.
///
/// # Errors
/// States that cannot be computed.
pub(super) fn find_coordinates(
    model: &Model,
    recording: &Recording,
    couplers: &Couplers,
    states: &ContactStates,
    (feet, normal): (&[Foot], DVec3),
) -> Result<CoordinatesOfCorrection, StatesError> {
    let recording = &recording.thinned(recording.frames().div_ceil(MOST_TRIAL_FRAMES).max(1));
    let known = paths_to(model, &states.pairs, &states.planes)?.motions_of_joints(recording);
    let along = |moved: &Recording| states.along_after(model, &known, moved, &Belt::default());
    let before = along(recording)?;
    let (mut legs, mut level, mut locked_in_feet) = (Vec::new(), Vec::new(), Vec::new());
    let mut root = None;
    for (index, coordinate) in recording.coordinates.iter().enumerate() {
        let is_dependent = recording.facts.coupled.contains(&coordinate.name);
        if coordinate.prescribed.is_some() || is_dependent {
            continue;
        }
        let nudged = recording.changed(couplers, |_, values, _| values[index] += TRIAL_STEP)?;
        let after = along(&nudged)?;
        let moves = |pair: usize| {
            let both = before.pair(pair).zip(after.pair(pair));
            both.map(|(before, after)| (after.centre_m - before.centre_m) / TRIAL_STEP)
        };
        let follows = |&pair: &usize| moves(pair).any(|by| by.length() > LEAST_MOVE);
        let moved = feet.iter().map(|foot| foot.pairs.iter().filter(|&pair| follows(pair)).count());
        let moved: Vec<(usize, usize)> = moved.enumerate().filter(|(_, count)| *count > 0).collect();
        let is_in_foot = |&(foot, count): &(usize, usize)| count < feet[foot].pairs.len();
        if coordinate.locked {
            locked_in_feet.extend(moved.iter().any(is_in_foot).then(|| coordinate.name.clone()));
            continue;
        }
        let all = || feet.iter().flat_map(|foot| &foot.pairs).flat_map(|&pair| moves(pair));
        let direction = all().next().unwrap_or_default();
        if (direction.length() - 1.0).abs() < 1e-6 && all().all(|by| (by - direction).length() < 1e-6) {
            if root.is_none() && (direction - normal).length() < 1e-6 {
                root =
                    Some(CorrectedCoordinate { index, foot: None, moves_toes: false, kind: coordinate.kind });
            } else if direction.dot(normal).abs() < 1e-6 {
                level.push((index, direction));
            }
        }
        if let [one @ (foot, _)] = *moved
            && feet.len() > 1
            && !is_frontal_knee(&coordinate.name)
        {
            let moves_toes = is_in_foot(&one);
            legs.push(CorrectedCoordinate { index, foot: Some(foot), moves_toes, kind: coordinate.kind });
        }
    }
    let corrected = root.into_iter().flat_map(|root| std::iter::once(root).chain(legs.clone())).collect();
    Ok(CoordinatesOfCorrection { corrected, level, locked_in_feet })
}

/// Whether a coordinate is the adduction of a knee, which inverse kinematics hardly sees.
fn is_frontal_knee(name: &str) -> bool {
    let name = name.to_ascii_lowercase();
    name.contains("knee") && ["add", "abd", "var", "valg"].iter().any(|part| name.contains(part))
}

impl CorrectedCoordinate {
    /// The size of a usual correction, rad or m.
    pub(super) fn usual_correction(&self, options: &CorrectionOptions) -> f64 {
        match self.kind {
            CoordinateKind::Translational => options.length_m,
            _ if self.moves_toes => 2.5 * options.angle_rad,
            _ => options.angle_rad,
        }
    }
}

/// Cubic B-splines with equal distances of their knots. At each time four of them differ from 0.
#[derive(Debug, Clone)]
pub(super) struct SplineBasis {
    /// The number of splines.
    pub(super) count: usize,
    /// For each frame, the first spline that differs from 0.
    pub(super) first: Vec<usize>,
    /// For each frame, the values of the four splines, their rates (1/s) and their accelerations (1/s²).
    pub(super) weights: Vec<[[f64; 4]; 3]>,
}

impl SplineBasis {
    /// Splines whose knots are at least `knots_s` apart.
    pub(super) fn new(time_s: &[f64], knots_s: f64) -> Self {
        let start = time_s.first().copied().unwrap_or_default();
        let length = time_s.last().map_or(0.0, |end| end - start);
        let pieces = (length / knots_s).floor().max(1.0) as usize;
        let step = if length > 0.0 { length / pieces as f64 } else { 1.0 };
        let (mut first, mut weights) = (Vec::new(), Vec::new());
        for time in time_s {
            let place = (time - start) / step;
            let piece = (place as usize).min(pieces - 1);
            first.push(piece);
            weights.push(cubic_weights(place - piece as f64, step));
        }
        Self { count: pieces + 3, first, weights }
    }
}

/// The four splines at `u`, between 0 and 1, between two knots that are `step` apart: values, rates and accelerations.
fn cubic_weights(u: f64, step: f64) -> [[f64; 4]; 3] {
    let (v, uu) = (1.0 - u, u * u);
    let values = [
        v * v * v / 6.0,
        uu * (u / 2.0 - 1.0) + 2.0 / 3.0,
        v * v * (v / 2.0 - 1.0) + 2.0 / 3.0,
        uu * u / 6.0,
    ];
    let rates = [-v * v / 2.0, u * (1.5 * u - 2.0), v * (2.0 - 1.5 * v), uu / 2.0];
    let accelerations = [v, 3.0 * u - 2.0, 3.0 * v - 2.0, u];
    [values, rates.map(|rate| rate / step), accelerations.map(|one| one / (step * step))]
}

/// The distance of knots, s: a tenth of the shortest stance, 25 to 50 ms, at least 1.5 frames.
pub(super) fn knot_distance_s(shortest_stance_s: f64, frame_s: f64) -> f64 {
    (shortest_stance_s / 10.0).clamp(0.025, 0.05).max(1.5 * frame_s)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn splines_with_the_coefficients_of_a_parabola_are_a_parabola() {
        // Σ B_j j = u and Σ B_j (j² - 1/3) = u², where u counts knots and spline j is at knot j - 1.
        let times: Vec<f64> = (0..=57).map(|frame| 3.0 + 0.01 * f64::from(frame)).collect();
        let basis = SplineBasis::new(&times, 0.1);
        let step = 0.57 / 5.0;
        assert_eq!((basis.count, basis.first[0], basis.first[57]), (8, 0, 4));
        for (frame, time) in times.iter().enumerate() {
            let sum = |order: usize, coefficient: &dyn Fn(f64) -> f64| -> f64 {
                let splines = basis.weights[frame][order].iter().enumerate();
                splines
                    .map(|(one, weight)| weight * coefficient((basis.first[frame] + one) as f64 - 1.0))
                    .sum()
            };
            let u = (time - 3.0) / step;
            let parabola = |knot: f64| knot * knot - 1.0 / 3.0;
            assert!((sum(0, &|_| 1.0) - 1.0).abs() < 1e-12);
            assert!((sum(0, &|knot| knot) - u).abs() < 1e-12);
            assert!((sum(0, &parabola) - u * u).abs() < 1e-11);
            assert!((sum(1, &parabola) - 2.0 * u / step).abs() < 1e-9);
            assert!((sum(2, &parabola) - 2.0 / (step * step)).abs() < 1e-9);
        }
    }

    #[test]
    fn knots_follow_the_shortest_stance() {
        assert_eq!(knot_distance_s(0.6, 0.01), 0.05);
        assert_eq!(knot_distance_s(0.3, 0.01), 0.03);
        assert_eq!(knot_distance_s(0.1, 0.01), 0.025);
        assert_eq!(knot_distance_s(0.1, 0.02), 0.03);
    }
}
