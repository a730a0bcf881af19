//! Whether motion, contacts and plates agree, and what is wrong with them, seen before anything is solved.

use osim_model::messages::named;
use osim_model::{DVec3, Model};

use super::dynamics::Masses;
use super::figures::{CorrectionFigures, FootErrors};
use super::inertia::{delay_s, inertia_n, reversed_direction};
use super::unknowns::CorrectionOptions;
use crate::plate_assignment::SWAPPED_FOOT_DISTANCE_M;
use crate::plate_comparison::percentile;
use crate::{ContactStates, Foot, MeasuredForces, Recording, StatesError, TOUCH_DOWN_BW, Wrench};

/// Why plates, motion and contacts do not go together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Mismatch {
    /// The plates' forces point down: those of one foot, or of all.
    Sign { foot: Option<usize> },
    /// The plates' forces lie along the floor.
    Axes,
    /// The forces along this direction on the floor are opposite to the acceleration of the whole body.
    Reversed { along: DVec3 },
    /// The plates' mean force under load, in body weights, and the unit that explains it.
    ForceUnit { mean_bw: f64, unit: &'static str },
    /// The centre of pressure is this far from the foot, or moments have this arm, m; and the unit that explains it, if one does.
    Place { foot: usize, distance_m: f64, unit: Option<&'static str> },
    /// The centre of pressure is nearer to another foot.
    Swapped { foot: usize, own_m: f64, other: usize, other_m: f64 },
    /// The plates are late by this time, s.
    Delay { late_s: f64 },
    /// The correction lifts the second foot this much more than the first, m.
    OneFoot { apart_m: f64 },
}

/// Units of force, with their number in a newton, and the largest factor between measured and needed forces that they explain. Nothing
/// else makes forces as small as kilonewtons do.
const FORCE_UNITS: [(&str, f64, f64); 3] =
    [("kN", 1e-3, 3.0), ("pounds", 0.2248, 1.25), ("kgf or daN", 0.101, 1.25)];
/// In all these units, forces under load are smaller on average, body weights.
const LARGEST_IN_ANOTHER_UNIT_BW: f64 = 0.5;
/// The largest arm of the moment about a centre of pressure that N mm explain, m.
const MOST_ARM_IN_N_MM_M: f64 = 50.0;
/// A centre of pressure that is farther from its foot is in a wrong place, m.
const LARGEST_PRESSURE_DISTANCE_M: f64 = 0.5;
/// Forces lie along the floor, or point down, by this part of their size.
const LARGER_PART: f64 = 0.5;
/// A plate is under load above this part of its largest force.
const LOADED_SHARE: f64 = 0.2;
/// The smallest delay of the plates that counts, s.
const LEAST_DELAY_S: f64 = 0.015;

impl Mismatch {
    /// Whether plates and motion cannot be compared at all.
    pub const fn prevents_comparison(&self) -> bool {
        !matches!(self, Self::Delay { .. } | Self::OneFoot { .. })
    }
}

/// Finds why plates, motion and contacts do not go together, before the motion is corrected: a sign, a unit, swapped feet or a delay.
///
/// # Errors
/// A model whose centre of mass is not known.
pub fn mismatches(
    model: &Model,
    recording: &Recording,
    (states, feet): (&ContactStates, &[Foot]),
    measured: &MeasuredForces,
    weight_n: f64,
) -> Result<Vec<Mismatch>, StatesError> {
    let floor = feet.first().and_then(|foot| foot.floor(states));
    let Some((normal, on_floor_m)) = floor else { return Ok(Vec::new()) };
    let along = |wrench: &Wrench| wrench.force_n.dot(normal);
    let kg = weight_n / DVec3::from(model.gravity_m_s2.unwrap_or_default()).length();
    let inertia_n = inertia_n(&Masses::new(model)?, recording, kg);
    let total = LoadedForces::new(&measured.total, normal);
    if total.across_n < LARGER_PART * total.size_n {
        return Ok(vec![Mismatch::Axes]);
    }
    let needed_n = |frame: &usize| weight_n + inertia_n[*frame].map_or(0.0, |force_n| force_n.dot(normal));
    let needed_n: f64 = total.frames.iter().map(needed_n).sum();
    let mean_bw = total.across_n / total.frames.len().max(1) as f64 / weight_n;
    let is_complete = measured.beside.iter().all(|&frames| frames == 0);
    let unit = unit_of_forces(total.across_n / needed_n, weight_n, is_complete);
    if let Some(unit) = unit.filter(|_| mean_bw < LARGEST_IN_ANOTHER_UNIT_BW) {
        return Ok(vec![Mismatch::ForceUnit { mean_bw, unit }]);
    }
    let of_feet = measured.feet.iter().map(|forces| LoadedForces::new(forces, normal)).enumerate();
    let (down, up): (Vec<_>, Vec<_>) = of_feet
        .filter(|(_, forces)| forces.largest_n > LOADED_SHARE * total.largest_n)
        .partition(|(_, forces)| forces.points_down());
    match down.as_slice() {
        &[(foot, _)] if !up.is_empty() => return Ok(vec![Mismatch::Sign { foot: Some(foot) }]),
        down if !down.is_empty() || total.points_down() => return Ok(vec![Mismatch::Sign { foot: None }]),
        _ => {}
    }
    // The centre of pressure of one foot, and the force along the normal.
    let pressure = |foot: usize, frame: usize| {
        let wrench = measured.feet.get(foot)?.get(frame)?.as_ref()?;
        let centre = wrench.centre_of_pressure(normal, on_floor_m, TOUCH_DOWN_BW * weight_n)?;
        Some((centre, along(wrench)))
    };
    // The distance from the centre of pressure, times `scale`, to a foot.
    let distance_m = |foot: usize, other: usize, scale: f64| {
        let point_m = |frame: usize| Some(pressure(foot, frame)?.0.point_m * scale);
        feet[other].pressure_distance_m(states, normal, point_m)
    };
    let mut found = Vec::new();
    for foot in (0..feet.len()).filter(|&foot| measured.has_points.get(foot) == Some(&true)) {
        let all = (0..states.frames()).filter_map(|frame| pressure(foot, frame));
        let arms_m = all.map(|(centre, force_n)| (centre.free_moment_n_m / force_n).abs());
        let arm_m = percentile(&arms_m.collect::<Vec<f64>>(), 0.5);
        if let Some(distance_m) = arm_m.filter(|arm_m| *arm_m > LARGEST_PRESSURE_DISTANCE_M) {
            let unit = (distance_m < MOST_ARM_IN_N_MM_M).then_some("moments in N mm");
            found.push(Mismatch::Place { foot, distance_m, unit });
            continue;
        }
        let Some(own_m) = distance_m(foot, foot, 1.0).filter(|own_m| *own_m > SWAPPED_FOOT_DISTANCE_M) else {
            continue;
        };
        let others = (0..feet.len()).filter_map(|other| Some((other, distance_m(foot, other, 1.0)?)));
        let near = others
            .filter(|(_, other_m)| *other_m < SWAPPED_FOOT_DISTANCE_M)
            .min_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((other, other_m)) = near {
            found.push(Mismatch::Swapped { foot, own_m, other, other_m });
        } else if own_m > LARGEST_PRESSURE_DISTANCE_M {
            let scaled_m = distance_m(foot, foot, 1e-3);
            let is_near = scaled_m.is_some_and(|scaled_m| scaled_m < SWAPPED_FOOT_DISTANCE_M);
            let unit = is_near.then_some("points in mm, or moments about a fixed point in N mm");
            found.push(Mismatch::Place { foot, distance_m: own_m, unit });
        }
    }
    // Without the force of each foot, the whole body's inertia explains nothing. A foot may stay in the air.
    let has_force =
        |foot: usize| measured.beside[foot] == 0 && measured.feet[foot].iter().any(Option::is_some);
    let are_known = (0..feet.len()).all(has_force) || measured.of_loaded_feet().len() == feet.len();
    if found.is_empty() && are_known {
        let force_n: Vec<Option<DVec3>> =
            measured.total.iter().map(|wrench| Some(wrench.as_ref()?.force_n)).collect();
        let reversed = reversed_direction(&recording.time_s, &inertia_n, &force_n, (normal, weight_n));
        found.extend(reversed.map(|along| Mismatch::Reversed { along }));
        let late_s = delay_s(&recording.time_s, &inertia_n, &force_n);
        let late_s = late_s.filter(|late_s| late_s.abs() > LEAST_DELAY_S);
        found.extend(late_s.map(|late_s| Mismatch::Delay { late_s }));
    }
    Ok(found)
}

/// The forces of plates in the frames with more than a small part of the largest.
struct LoadedForces {
    frames: Vec<usize>,
    largest_n: f64,
    /// The sums of the sizes of the forces, of their sizes along the normal of the floor, and of the forces along it.
    size_n: f64,
    across_n: f64,
    up_n: f64,
}

impl LoadedForces {
    /// Sums up the `forces` of plates, frame by frame, over a floor with this normal.
    fn new(forces: &[Option<Wrench>], normal: DVec3) -> Self {
        let size = |frame: usize| forces[frame].map_or(0.0, |wrench| wrench.force_n.length());
        let largest_n = (0..forces.len()).map(size).fold(0.0, f64::max);
        let frames: Vec<usize> =
            (0..forces.len()).filter(|&frame| size(frame) > LOADED_SHARE * largest_n).collect();
        let up = || frames.iter().filter_map(|&frame| Some(forces[frame]?.force_n.dot(normal)));
        let (up_n, across_n) = (up().sum(), up().map(f64::abs).sum());
        Self { size_n: frames.iter().map(|&frame| size(frame)).sum(), largest_n, across_n, up_n, frames }
    }

    /// Whether most of the force pulls at the feet, as no floor does.
    fn points_down(&self) -> bool {
        self.up_n < -LARGER_PART * self.across_n
    }
}

/// The unit of forces that are `share` of what the motion needs. If forces are missing, only a very small share shows a unit.
fn unit_of_forces(share: f64, weight_n: f64, is_complete: bool) -> Option<&'static str> {
    let is_near = |factor: f64, within: f64| (1.0 / within..within).contains(&(share / factor));
    let mut units = FORCE_UNITS.iter().filter(|(_, factor, _)| is_complete || *factor < 0.01);
    let &(unit, ..) = units.find(|(_, factor, within)| is_near(*factor, *within))?;
    let in_weights = unit == FORCE_UNITS[0].0 && is_near(1.0 / weight_n, 1.25);
    Some(if in_weights { "kN or body weights" } else { unit })
}

named! {
    /// The verdict on a recording: whether contacts, motion and force plates agree.
    pub enum MotionVerdict {
        Agree = "agree",
        LargeCorrection = "large-correction",
        Disagree = "disagree",
    }
}

/// The largest error of the vertical force with which contacts and plates agree, body weights.
const MOST_VERTICAL_BW: f64 = 0.1;
/// The largest error of the vertical force as a share of that of a model that never touches, with which the contacts explain a force.
const MOST_SHARE_OF_NULL: f64 = 0.5;
/// An error of the vertical force that is too small to say anything, body weights.
const SMALL_VERTICAL_BW: f64 = 0.02;
/// The largest vertical move of spheres that agrees (of 95 % of them), as a multiple of a usual error of places.
const MOST_LIFT: f64 = 2.0;
/// If a floor of its own under one foot leaves less than this share of the cost of the correction, this foot is off.
const MOST_SHARE_OF_COST: f64 = 0.25;
/// A foot that the plates carry for a shorter time, s, hardly shows its height.
const LEAST_STANCE_S: f64 = 0.3;
/// It shows it only by a lift larger than this multiple of the lift's scatter.
const LEAST_LIFT_IN_SCATTERS: f64 = 5.0;
/// If one foot is lifted more than the other by this multiple of a usual error of places, the feet do not agree.
const MOST_DIFFERENCE_OF_FEET: f64 = 2.5;

impl CorrectionFigures {
    /// How much more the second of two feet is lifted than the first, m; `None` unless plates carry two.
    pub fn difference_of_feet_m(&self) -> Option<f64> {
        match self.feet.as_slice() {
            [first, second] if first.stance_s.min(second.stance_s) > 0.0 => {
                Some(second.mean_lift_m - first.mean_lift_m)
            }
            _ => None,
        }
    }

    /// The largest distance of centres of pressure of a foot, m; `None` if they are not known.
    pub fn cop_rms_m(&self) -> Option<f64> {
        self.feet.iter().filter_map(|foot| foot.cop_rms_m).reduce(f64::max)
    }

    /// The largest of a figure of all feet.
    pub fn largest_of_feet(&self, figure: impl Fn(&FootErrors) -> f64) -> f64 {
        self.feet.iter().map(figure).fold(0.0, f64::max)
    }

    /// The first foot on a plate whose vertical force the corrected motion hardly explains better than a model that never touches.
    pub fn unexplained_foot(&self) -> Option<&FootErrors> {
        let most_bw = |foot: &FootErrors| (MOST_SHARE_OF_NULL * foot.null.vertical_bw).max(SMALL_VERTICAL_BW);
        self.feet.iter().find(|foot| foot.stance_s > 0.0 && foot.after.vertical_bw > most_bw(foot))
    }

    /// Whether each foot is loaded long enough, or moves alike enough, to show that it is off by `apart_m`.
    fn shows_height(&self, apart_m: f64) -> bool {
        self.feet.iter().all(|foot| {
            foot.stance_s >= LEAST_STANCE_S || apart_m > LEAST_LIFT_IN_SCATTERS * foot.lift_scatter_m
        })
    }

    /// The verdict, with what is wrong: the `causes` that were seen before, and one foot that is off.
    pub fn verdict(
        &self,
        mut causes: Vec<Mismatch>,
        options: &CorrectionOptions,
    ) -> (MotionVerdict, Vec<Mismatch>) {
        let is_apart = |apart_m: &f64| apart_m.abs() > MOST_DIFFERENCE_OF_FEET * options.length_m;
        let by_lift = self
            .difference_of_feet_m()
            .filter(|apart_m| self.unexplained_foot().is_none() && self.shows_height(apart_m.abs()))
            .filter(is_apart);
        let (floor_m, cost_share) = self.two_floors;
        let is_explained = self.largest_of_feet(|foot| foot.after.vertical_bw) <= MOST_VERTICAL_BW
            && self.unexplained_foot().is_none();
        let are_loaded = self.feet.iter().all(|foot| foot.stance_s > 0.0);
        let by_cost = (is_explained && are_loaded && cost_share < MOST_SHARE_OF_COST).then_some(-floor_m);
        causes.extend(by_cost.filter(is_apart).or(by_lift).map(|apart_m| Mismatch::OneFoot { apart_m }));
        let agrees = is_explained && self.lift_p95_m <= MOST_LIFT * options.length_m;
        let verdict = match (causes.is_empty(), agrees) {
            (false, _) => MotionVerdict::Disagree,
            (true, true) => MotionVerdict::Agree,
            (true, false) => MotionVerdict::LargeCorrection,
        };
        (verdict, causes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::correct::figures::ForceErrors;

    /// 80 kg weigh 784.5 N; a newton is 0.001 kN, 0.2248 pounds, 0.102 kgf or 0.1 daN.
    #[test]
    fn a_unit_is_named_if_its_factor_explains_the_forces() {
        let unit = |share: f64| unit_of_forces(share, 700.0, true);
        assert_eq!([0.001, 0.0004, 0.003 / 1.1].map(unit), [Some("kN"); 3]);
        assert_eq!(unit(1.0 / 700.0), Some("kN or body weights"));
        assert_eq!([0.2248, 0.19, 0.27].map(unit), [Some("pounds"); 3]);
        assert_eq!([0.102, 0.1].map(unit), [Some("kgf or daN"); 2]);
        // A child in the model of an adult, half a body, another subject.
        assert_eq!([0.36, 0.5, 1.0, 2.0, 0.0].map(unit), [None; 5]);
        assert_eq!(unit_of_forces(0.2248, 700.0, false), None);
        assert_eq!(unit_of_forces(0.001, 700.0, false), Some("kN"));
    }

    #[test]
    fn forces_point_down_or_lie_along_the_floor() {
        let of = |forces: [DVec3; 3]| {
            let wrench = |force_n| Some(Wrench { force_n, moment_n_m: DVec3::ZERO });
            LoadedForces::new(&forces.map(wrench), DVec3::Y)
        };
        let up = DVec3::new(30.0, 700.0, 0.0);
        let down = of([-up, -up, DVec3::Y]);
        assert!(down.points_down() && down.frames == [0, 1], "{:?}", down.frames);
        assert!(!of([up, up, -up]).points_down() && !of([up, -up, DVec3::ZERO]).points_down());
        let lying = of([DVec3::new(30.0, 50.0, 700.0); 3]);
        assert!(lying.across_n < LARGER_PART * lying.size_n);
    }

    fn figures(
        after_bw: f64,
        null_bw: f64,
        apart_m: f64,
        (stance_s, lift_scatter_m): (f64, f64),
    ) -> CorrectionFigures {
        let errors = |vertical_bw| ForceErrors { vertical_bw, horizontal_bw: 0.0 };
        let foot = |mean_lift_m| FootErrors {
            foot: "foot".to_owned(),
            before: errors(1.0),
            after: errors(after_bw),
            null: errors(null_bw),
            cop_rms_m: None,
            joint_rms_rad: 0.01,
            mean_lift_m,
            lift_scatter_m,
            lifts_and_forces: Vec::new(),
            stance_s,
        };
        let feet = vec![foot(0.0), foot(apart_m)];
        CorrectionFigures {
            feet,
            lift_rms_m: 0.005,
            lift_p95_m: 0.01,
            largest_relative_indentation: 0.5,
            two_floors: (0.0, 1.0),
        }
    }

    #[test]
    fn only_what_is_better_than_nothing_agrees() {
        let verdict =
            |figures: &CorrectionFigures| figures.verdict(Vec::new(), &CorrectionOptions::default()).0;
        let whole = (1.0, 0.007);
        assert_eq!(verdict(&figures(0.03, 0.7, 0.0, whole)), MotionVerdict::Agree);
        // In kgf the plates have 0.07 body weights, and so has a model that never touches.
        let kilograms = figures(0.07, 0.07, 0.03, whole);
        assert_eq!(verdict(&kilograms), MotionVerdict::LargeCorrection);
        assert!(kilograms.unexplained_foot().is_some());
        // Nothing carries a foot that is on no plate, and its height is not known.
        assert_eq!(verdict(&figures(0.05, 0.0, 0.03, (0.0, 0.0))), MotionVerdict::Agree);
        assert_eq!(verdict(&figures(0.03, 0.7, 0.018, whole)), MotionVerdict::Disagree);
        assert_eq!(verdict(&figures(0.03, 0.7, 0.018, (0.2, 0.007))), MotionVerdict::Agree);
        assert_eq!(verdict(&figures(0.03, 0.7, 0.03, (0.1, 0.001))), MotionVerdict::Disagree);
        let with_floors = |two_floors, stance_s| {
            verdict(&CorrectionFigures { two_floors, ..figures(0.03, 0.7, 0.003, (stance_s, 0.002)) })
        };
        assert_eq!(with_floors((-0.03, 0.1), 0.05), MotionVerdict::Disagree);
        assert_eq!(
            [((-0.03, 0.3), 0.05), ((-0.03, 0.1), 0.0), ((-0.01, 0.1), 0.05)]
                .map(|(floors, stance_s)| with_floors(floors, stance_s)),
            [MotionVerdict::Agree; 3]
        );
    }
}
