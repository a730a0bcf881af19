//! What a correction reached, and its size.

use osim_model::DVec3;

use super::residuals::CorrectionInputs;
use crate::plate_comparison::{Comparison, ComparisonPlane, percentile};
use crate::{ContactStates, CoordinateKind, Foot, MeasuredForces, TOUCH_DOWN_BW, Wrench};

/// Root mean squares of the differences from the plates, in body weights.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ForceErrors {
    pub vertical_bw: f64,
    pub horizontal_bw: f64,
}

/// The differences between one foot and its plates.
#[derive(Debug, Clone, PartialEq)]
pub struct FootErrors {
    pub foot: String,
    pub before: ForceErrors,
    pub after: ForceErrors,
    /// The errors of a model that never touches.
    pub null: ForceErrors,
    /// The distance of the centres of pressure after the correction, m.
    pub cop_rms_m: Option<f64>,
    /// The largest angle of the leg's corrections in stance as a root mean square, without toes, rad.
    pub joint_rms_rad: f64,
    /// The force-weighted mean of the foot's vertical moves, without that of the floor, m.
    pub mean_lift_m: f64,
    /// The force-weighted standard deviation of these moves, m.
    pub lift_scatter_m: f64,
    /// For each sphere of the foot, the sum of these moves times its forces, and of its forces.
    pub lifts_and_forces: Vec<[f64; 2]>,
    /// The time for which the plates carry the foot, s.
    pub stance_s: f64,
}

/// The numbers by which the correction of a motion is judged, such as the move of the spheres.
#[derive(Debug, Clone, PartialEq)]
pub struct CorrectionFigures {
    pub feet: Vec<FootErrors>,
    /// Root mean square and 95th percentile of the vertical moves of loaded spheres in stance, without that of the floor, m.
    pub lift_rms_m: f64,
    pub lift_p95_m: f64,
    pub largest_relative_indentation: f64,
    /// How much higher the floor would be under the second of two feet, m, if it had one of its own, and the share of the cost of the
    /// correction that would remain.
    pub two_floors: (f64, f64),
}

/// A sphere with more than this share of body weight counts for the lift.
const LEAST_LOAD_OF_SPHERE_BW: f64 = 0.02;

impl CorrectionFigures {
    /// Computes the numbers from the contacts `before` and `after` the correction.
    pub(super) fn new(
        setting: &CorrectionInputs<'_>,
        (before, after): (&ContactStates, &ContactStates),
        (feet, measured): (&[Foot], &MeasuredForces),
        (normal, point_m): (DVec3, DVec3),
        (unknowns, floor_up_m, two_floors): (&[f64], f64, (f64, f64)),
    ) -> Self {
        let weight_n = setting.weight_n;
        let pairs = &before.pairs;
        let mut lifts = Vec::new();
        let mut of_feet = Vec::new();
        let mut deepest: f64 = 0.0;
        let time_s = &before.time_s;
        let all_s = time_s.last().zip(time_s.first()).map_or(0.0, |(end, start)| end - start);
        for (number, (foot, plates)) in feet.iter().zip(&measured.feet).enumerate() {
            let has_points = measured.has_points.get(number) == Some(&true);
            let on = ComparisonPlane { normal, point_m, least_n: TOUCH_DOWN_BW * weight_n, has_points };
            let compared = |states: Option<&ContactStates>| {
                let wrench = |frame: usize| {
                    let states = states.map(|states| states.frame(frame)).unwrap_or_default();
                    Wrench::from_states(foot.pairs.iter().filter_map(|&pair| states.get(pair)))
                };
                let wrenches: Vec<Wrench> = (0..plates.len()).map(wrench).collect();
                Comparison::of(&wrenches, plates, &on)
            };
            let errors = |compared: &Option<Comparison>| {
                let error_bw = |of: fn(&Comparison) -> f64| compared.as_ref().map_or(0.0, of) / weight_n;
                let (vertical_bw, horizontal_bw) =
                    (error_bw(|one| one.normal_rms_n), error_bw(|one| one.horizontal_rms_n));
                ForceErrors { vertical_bw, horizontal_bw }
            };
            let (mut squares, mut stance) = (vec![0.0; setting.coordinates.len()], 0.0);
            let (mut lifts_and_forces, mut moved_squares) = (vec![[0.0; 2]; foot.pairs.len()], 0.0);
            for (frame, plate) in plates.iter().enumerate() {
                if !plate.is_some_and(|plate| plate.force_n.dot(normal) > TOUCH_DOWN_BW * weight_n) {
                    continue;
                }
                stance += 1.0;
                let corrections = setting.corrections(unknowns, frame, 0);
                squares.iter_mut().zip(corrections).for_each(|(sum, value)| *sum += value * value);
                let both = |pair: usize| before.frame(frame).get(pair).zip(after.frame(frame).get(pair));
                for (&pair, [moved, force_n]) in foot.pairs.iter().zip(&mut lifts_and_forces) {
                    let Some((before, after)) = both(pair) else { continue };
                    let radius_m = pairs[pair].radius_m;
                    deepest = deepest.max(after.indentation_m / radius_m);
                    if after.normal_force_n > LEAST_LOAD_OF_SPHERE_BW * weight_n {
                        let lift = (after.centre_m - before.centre_m).dot(normal) + floor_up_m;
                        lifts.push(lift.abs());
                        *moved += lift * after.normal_force_n;
                        moved_squares += lift * lift * after.normal_force_n;
                        *force_n += after.normal_force_n;
                    }
                }
            }
            let [moved, force_n]: [f64; 2] =
                [0, 1].map(|part| lifts_and_forces.iter().map(|sums| sums[part]).sum());
            let mean = |sum: f64| if force_n > 0.0 { sum / force_n } else { 0.0 };
            let mean_lift_m = mean(moved);
            let compared_after = compared(Some(after));
            let of_leg = setting.coordinates.iter().zip(squares).filter(|(coordinate, _)| {
                let is_angle = coordinate.kind != CoordinateKind::Translational;
                coordinate.foot == Some(number) && is_angle && !coordinate.moves_toes
            });
            let largest = of_leg.map(|(_, sum)| sum).fold(0.0, f64::max);
            of_feet.push(FootErrors {
                foot: foot.name.clone(),
                before: errors(&compared(Some(before))),
                after: errors(&compared_after),
                null: errors(&compared(None)),
                cop_rms_m: compared_after.and_then(|compared| compared.cop_rms_m),
                joint_rms_rad: if stance > 0.0 { f64::sqrt(largest / stance) } else { 0.0 },
                mean_lift_m,
                lift_scatter_m: (mean(moved_squares) - mean_lift_m * mean_lift_m).max(0.0).sqrt(),
                lifts_and_forces,
                stance_s: stance / time_s.len() as f64 * all_s,
            });
        }
        let square: f64 = lifts.iter().map(|lift| lift * lift).sum();
        Self {
            feet: of_feet,
            lift_rms_m: (square / lifts.len().max(1) as f64).sqrt(),
            lift_p95_m: percentile(&lifts, 0.95).unwrap_or_default(),
            largest_relative_indentation: deepest,
            two_floors,
        }
    }
}
