//! Assigns force plates to feet, and sums the measured forces under each foot.

use std::ops::Range;

use osim_model::{DVec3, Side};

use crate::feet::{Foot, LIFT_OFF_BW, TOUCH_DOWN_BW};
use crate::plate_comparison::percentile;
use crate::{ContactState, ContactStates, Plate, Wrench};

/// The source of the knowledge which foot a plate measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AssignedBy {
    /// The body to which an `ExternalLoads` file applies the plate's force.
    Loads,
    /// The side in the names of the plate's columns.
    Name,
    /// The distance to the centre of pressure: in each frame the nearest foot, among those that may be on the plate.
    Nearest,
    /// As `Nearest`, although the loads or names say one foot for all plates: another foot is on one of them.
    NearestOfAll,
    OnlyFoot,
    /// The plate measures nothing, so that its foot does not matter.
    Idle,
}

/// The foot that a plate measured.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PlateAssignment {
    /// Common beginning of the names of the plate's columns.
    pub plate: String,
    /// Index of the foot; `None` if the foot changes from frame to frame, or if no foot is known.
    pub foot: Option<usize>,
    /// The source of the foot; `None` if no foot is known: the plate then only counts in the total force.
    pub by: Option<AssignedBy>,
}

/// Forces that the plates measured under each foot, in the frames of a recording.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredForces {
    /// The foot on each plate.
    pub uses: Vec<PlateAssignment>,
    /// The force for each foot and frame; `None` if a plate under the foot has no data, if the foot on a plate is not known, if no plate
    /// is under the foot, or if the foot stands beside the plates.
    pub feet: Vec<Vec<Option<Wrench>>>,
    /// The number of frames in which each foot probably stands beside the plates.
    pub beside: Vec<usize>,
    /// The sum of the forces of all plates in each frame; `None` if a plate has no data, or if a foot stands beside the
    /// plates.
    pub total: Vec<Option<Wrench>>,
    /// For each foot, whether all its plates have centres of pressure; if not, the centre of pressure of the foot is not
    /// known.
    pub has_points: Vec<bool>,
}

impl MeasuredForces {
    /// Assigns `plates` to `feet` and sums the forces. The nearest foot is only used in frames with a force above 5 % of
    /// `weight_n`.
    pub fn of(plates: &[Plate], feet: &[Foot], states: &ContactStates, weight_n: f64) -> Self {
        // If all forces are as small, they are in kN.
        let any_is_loaded = plates.iter().any(|plate| !plate.is_idle(&states.time_s));
        let assign = |plate: &Plate| match any_is_loaded && plate.is_idle(&states.time_s) {
            true => PlateAssignment { plate: plate.name.clone(), foot: None, by: Some(AssignedBy::Idle) },
            false => assign_plate(plate, feet),
        };
        let mut uses: Vec<PlateAssignment> = plates.iter().map(assign).collect();
        let mut may_be_on: Vec<Vec<usize>> = plates.iter().map(|plate| candidate_feet(plate, feet)).collect();
        let least_n = TOUCH_DOWN_BW * weight_n;
        if let Some(foot) = foot_of_all_plates(&uses)
            && plates.iter().any(|plate| is_under_other(plate, foot, feet, states, least_n))
        {
            let said = uses.iter_mut().zip(&mut may_be_on).filter(|(usage, _)| usage.foot.is_some());
            for (usage, may_be_on) in said {
                (usage.foot, usage.by) = (None, Some(AssignedBy::NearestOfAll));
                *may_be_on = (0..feet.len()).collect();
            }
        }
        let frames = states.frames();
        let mut measured = Self {
            feet: vec![vec![Some(Wrench::default()); frames]; feet.len()],
            total: vec![Some(Wrench::default()); frames],
            beside: vec![0; feet.len()],
            has_points: vec![true; feet.len()],
            uses,
        };
        let all = measured.uses.clone().into_iter().zip(&may_be_on);
        for (plate, (usage, may_be_on)) in plates.iter().zip(all) {
            if usage.by != Some(AssignedBy::Idle) {
                measured.add_plate(plate, (usage.by, may_be_on.as_slice()), feet, states, least_n);
            }
        }
        let is_on_none = |foot: &usize| !may_be_on.iter().any(|feet| feet.contains(foot));
        (0..feet.len()).filter(is_on_none).for_each(|foot| measured.feet[foot].fill(None));
        measured.clear_frames_beside_plates(feet, states, weight_n);
        measured
    }

    /// The forces under the feet that plates carry in some frame.
    pub(crate) fn of_loaded_feet(&self) -> Vec<&[Option<Wrench>]> {
        let is_loaded =
            |forces: &&[Option<Wrench>]| forces.iter().flatten().any(|wrench| wrench.force_n != DVec3::ZERO);
        self.feet.iter().map(Vec::as_slice).filter(is_loaded).collect()
    }

    /// The number of frames in which the plates have data.
    pub fn frames_with_data(&self) -> usize {
        let has_data = |frame: &usize| {
            self.total[*frame].is_some() || self.feet.iter().any(|forces| forces[*frame].is_some())
        };
        (0..self.total.len()).filter(has_data).count()
    }

    /// The longest run of frames in which the force under every foot is known that has one in some frame.
    pub fn longest_known(&self) -> Range<usize> {
        let feet = self.of_loaded_feet();
        let is_known = |frame: usize| feet.iter().all(|forces| matches!(forces.get(frame), Some(Some(_))));
        let (mut longest, mut first) = (0..0, 0);
        for frame in 0..self.total.len() {
            if !is_known(frame) {
                first = frame + 1;
            } else if frame + 1 - first > longest.len() {
                longest = first..frame + 1;
            }
        }
        longest
    }

    /// Sets frames to unknown in which a foot stands beside the plates, because the force under the foot is not measured
    /// then.
    fn clear_frames_beside_plates(&mut self, feet: &[Foot], states: &ContactStates, weight_n: f64) {
        let total = self.total.clone();
        let loads = feet.iter().zip(&self.feet).map(|(foot, plates)| loads_of_foot(states, foot, plates));
        let loads: Vec<Vec<FootLoad<'_>>> = loads.collect();
        for (index, foot) in feet.iter().enumerate() {
            let beside = frames_beside_plates(states, foot, (loads.as_slice(), index), &total, weight_n);
            for frame in (0..beside.len()).filter(|&frame| beside[frame]) {
                (self.feet[index][frame], self.total[frame]) = (None, None);
                self.beside[index] += 1;
            }
        }
    }

    /// Adds the force of a plate to the foot that it measured.
    fn add_plate(
        &mut self,
        plate: &Plate,
        (by, may_be_on): (Option<AssignedBy>, &[usize]),
        feet: &[Foot],
        states: &ContactStates,
        least_n: f64,
    ) {
        for (frame, &time_s) in states.time_s.iter().enumerate() {
            let wrench = plate.at(time_s);
            add_to_frame(&mut self.total, frame, wrench);
            match (by, wrench) {
                (Some(AssignedBy::Nearest | AssignedBy::NearestOfAll), Some(wrench)) => {
                    if let Some(foot) = nearest_foot(&wrench, feet, may_be_on, states, frame, least_n) {
                        add_to_frame(&mut self.feet[foot], frame, Some(wrench));
                    }
                }
                // The force under each candidate is unknown if the plate has no data, or its foot is unknown.
                (by, wrench) => {
                    let known = wrench.filter(|_| by.is_some());
                    may_be_on.iter().for_each(|&foot| add_to_frame(&mut self.feet[foot], frame, known));
                }
            }
        }
        may_be_on.iter().for_each(|&foot| self.has_points[foot] &= plate.has_points);
    }
}

/// Adds a force to that of one frame; if either is unknown, the sum is.
fn add_to_frame(series: &mut [Option<Wrench>], frame: usize, wrench: Option<Wrench>) {
    if let Some(sum) = series.get_mut(frame) {
        *sum = sum.zip(wrench).map(|(sum, wrench)| sum.plus(&wrench));
    }
}

/// Indices of the feet that may be on a plate: the foot with the body of the load, the feet of the side that the load or the
/// columns name, or all feet.
fn candidate_feet(plate: &Plate, feet: &[Foot]) -> Vec<usize> {
    let indices = |matches: &dyn Fn(&Foot) -> bool| -> Vec<usize> {
        feet.iter().enumerate().filter(|(_, foot)| matches(foot)).map(|(index, _)| index).collect()
    };
    let on_side = |side: Side| indices(&|foot| foot.side == Some(side));
    if let Some(body) = &plate.body {
        let with_body = indices(&|foot| foot.bodies.contains(body));
        // A load on another body of the limb, such as the tibia, has the limb's side.
        return if with_body.is_empty() {
            Side::of_name(body).map(on_side).unwrap_or_default()
        } else {
            with_body
        };
    }
    Side::of_name(&plate.name).map_or_else(|| indices(&|_| true), on_side)
}

/// The foot on a plate: by its load, by the side in its name, or the only foot; else the nearest foot in each frame.
fn assign_plate(plate: &Plate, feet: &[Foot]) -> PlateAssignment {
    let (foot, by) = match candidate_feet(plate, feet).as_slice() {
        &[only] if plate.body.is_some() => (Some(only), Some(AssignedBy::Loads)),
        &[only] if Side::of_name(&plate.name).is_some() => (Some(only), Some(AssignedBy::Name)),
        &[only] => (Some(only), Some(AssignedBy::OnlyFoot)),
        [_, _, ..] if plate.has_points => (None, Some(AssignedBy::Nearest)),
        _ => (None, None),
    };
    PlateAssignment { plate: plate.name.clone(), foot, by }
}

/// A centre of pressure that is farther from its foot belongs to another, if that is as near, m.
pub(crate) const SWAPPED_FOOT_DISTANCE_M: f64 = 0.1;

/// The foot that all of several plates are said to measure, without plates that measure nothing.
fn foot_of_all_plates(uses: &[PlateAssignment]) -> Option<usize> {
    let mut loaded = uses.iter().filter(|usage| usage.by != Some(AssignedBy::Idle)).map(|usage| usage.foot);
    let first = loaded.next()?;
    let others: Vec<Option<usize>> = loaded.collect();
    first.filter(|_| !others.is_empty() && others.iter().all(|foot| *foot == first))
}

/// Whether a plate's centre of pressure is far from `foot`, and near another foot.
fn is_under_other(plate: &Plate, foot: usize, feet: &[Foot], states: &ContactStates, least_n: f64) -> bool {
    let is_near = |foot: &Foot| {
        let Some((normal, on_floor_m)) = foot.floor(states) else { return false };
        let pressure = |frame: usize| {
            let wrench = plate.at(states.time_s[frame])?;
            Some(wrench.centre_of_pressure(normal, on_floor_m, least_n)?.point_m)
        };
        let away_m = foot.pressure_distance_m(states, normal, pressure);
        away_m.is_some_and(|away_m| away_m < SWAPPED_FOOT_DISTANCE_M)
    };
    plate.has_points && !is_near(&feet[foot]) && feet.iter().any(is_near)
}

/// The foot among `indices` with the sphere nearest to the centre of pressure; `None` if the force is not above `least_n`. The
/// distance includes the height, because a foot that swings past a standing foot is higher.
fn nearest_foot(
    wrench: &Wrench,
    feet: &[Foot],
    indices: &[usize],
    states: &ContactStates,
    frame: usize,
    least_n: f64,
) -> Option<usize> {
    let all = states.frame(frame);
    let mut best: Option<(f64, usize)> = None;
    for (index, foot) in indices.iter().filter_map(|&index| Some((index, feet.get(index)?))) {
        for &pair in &foot.pairs {
            let (state, radius_m) = (all.get(pair)?, states.pairs.get(pair)?.radius_m);
            let centre = wrench.centre_of_pressure(state.normal, state.on_surface_m(radius_m), least_n)?;
            let distance = centre.point_m.distance_squared(state.centre_m);
            if best.is_none_or(|(least, _)| distance < least) {
                best = Some((distance, index));
            }
        }
    }
    best.map(|(_, index)| index)
}

/// Speed of a foot's slowest sphere against a foot on the plates, m/s, below which the foot stands.
const FASTEST_STILL_FOOT_M_S: f64 = 0.4;
/// Height above that of a foot on the plates, m, below which a foot may stand: motions are wrong by so much.
const MOST_HEIGHT_OF_STANDING_FOOT_M: f64 = 0.03;
/// Plate force, in body weights, above which a frame counts for the usual height and speed of a standing foot.
const LOADED_BW: f64 = 0.2;
/// Quantile of the depths of a foot in frames with a plate force; a foot at this depth or deeper is as low as on a plate.
const LEAST_DEPTH_QUANTILE: f64 = 0.05;

/// Force of all plates together, in body weights, above which the measured feet carry the body.
const CARRIED_BW: f64 = 0.6;
/// The shortest time, s, in which a foot stands beside the plates. A swinging foot is low and still for a moment.
const SHORTEST_STEP_S: f64 = 0.08;
/// A foot that is on no plate carries for at most this time, s, before and after it does so alone.
const LONGEST_STEP_ON_S: f64 = 0.15;

/// The force of the plates under a foot along the normal, N, and its deepest contact, in one frame; `None` without data.
type FootLoad<'s> = Option<(f64, &'s ContactState)>;

/// The loads of `foot`, under which `plates` measured these forces.
fn loads_of_foot<'s>(states: &'s ContactStates, foot: &Foot, plates: &[Option<Wrench>]) -> Vec<FootLoad<'s>> {
    let in_frame = |(frame, plate): (usize, &Option<Wrench>)| {
        let deepest = foot.deepest(states, frame)?;
        Some((plate.as_ref()?.force_n.dot(deepest.normal), deepest))
    };
    plates.iter().enumerate().map(in_frame).collect()
}

/// For each frame, whether the foot with this index of `loads` stands beside the plates: they measure no force under it, but for 80 ms it
/// is about as low and as still as on a plate, and the `total` of all plates does not carry the body. All frames around these count while
/// the foot is as low as on a plate. A foot that is on no plate is compared with the other feet.
fn frames_beside_plates(
    states: &ContactStates,
    foot: &Foot,
    (loads, index): (&[Vec<FootLoad<'_>>], usize),
    total: &[Option<Wrench>],
    weight_n: f64,
) -> Vec<bool> {
    let frames = &loads[index];
    let is_above = |force_n: f64, least_bw: f64| force_n > least_bw * weight_n;
    // A plate whose forces point down carries the foot, too: `mismatches` reports the sign.
    let is_on_plate = frames.iter().flatten().any(|(force_n, _)| is_above(force_n.abs(), LOADED_BW));
    let compared = if is_on_plate { &loads[index..=index] } else { loads };
    let under_load = |least_bw: f64, quantile: f64, of: &dyn Fn(&ContactState) -> f64| {
        let loaded = compared.iter().flatten().flatten().filter(|(force_n, _)| is_above(*force_n, least_bw));
        percentile(&loaded.map(|(_, state)| of(state)).collect::<Vec<f64>>(), quantile)
            .unwrap_or(f64::INFINITY)
    };
    let usual_m = under_load(LOADED_BW, 0.5, &|state| state.indentation_m);
    let usual_m_s =
        DVec3::from([0, 1, 2].map(|axis| under_load(LOADED_BW, 0.5, &|state| state.slip_m_s[axis])));
    let lowest_m = under_load(TOUCH_DOWN_BW, LEAST_DEPTH_QUANTILE, &|state| state.indentation_m);
    let least_m = usual_m - MOST_HEIGHT_OF_STANDING_FOOT_M;
    let least_m = if is_on_plate { lowest_m.max(least_m) } else { least_m };
    let is_low = |one: &FootLoad<'_>| {
        one.as_ref().is_some_and(|(force_n, state)| {
            *force_n < LIFT_OFF_BW * weight_n && state.indentation_m >= least_m
        })
    };
    let stands = |frame: usize| {
        let is_still = |state: &ContactState| {
            (state.slip_m_s - usual_m_s).length().hypot(state.rate_m_s) < FASTEST_STILL_FOOT_M_S
        };
        foot.contacts(states, frame).any(is_still)
    };
    let is_carried = |frame: usize| {
        let sum = total[frame].as_ref().zip(foot.deepest(states, frame));
        sum.is_some_and(|(wrench, state)| wrench.force_n.dot(state.normal) >= CARRIED_BW * weight_n)
    };
    // Half of the time before and after a frame belongs to it.
    let time_s = |frame: usize| states.time_s[frame.min(states.time_s.len() - 1)];
    let duration_s = |frame: usize| 0.5 * (time_s(frame + 1) - time_s(frame.saturating_sub(1)));
    let mut is_beside_in = Vec::with_capacity(frames.len());
    for run in frames.chunk_by(|before, after| is_low(before) == is_low(after)) {
        let first = is_beside_in.len();
        let all = first..first + run.len();
        let alone: Vec<usize> = all.clone().filter(|&frame| stands(frame) && !is_carried(frame)).collect();
        let alone_s: f64 = alone.iter().map(|&frame| duration_s(frame)).sum();
        let is_beside = run.first().is_some_and(is_low) && alone_s >= SHORTEST_STEP_S;
        // How low a foot is that no plate carries is only known roughly: it swings low, too.
        let is_near = |frame: usize| {
            is_on_plate || alone.iter().any(|&one| (time_s(one) - time_s(frame)).abs() <= LONGEST_STEP_ON_S)
        };
        is_beside_in.extend(all.map(|frame| is_beside && is_near(frame)));
    }
    is_beside_in
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::Table;

    fn foot(name: &str, side: Side, body: &str) -> Foot {
        Foot { name: name.to_owned(), side: Some(side), pairs: Vec::new(), bodies: vec![body.to_owned()] }
    }

    /// The foot of a plate whose columns begin with `stem` and whose load acts on `body`, and the source of this knowledge.
    fn foot_of_plate(stem: &str, body: Option<&str>, feet: &[Foot]) -> (Option<usize>, Option<AssignedBy>) {
        let names: Vec<String> = ["v", "p"]
            .iter()
            .flat_map(|kind| ["x", "y", "z"].map(|axis| format!("{stem}{kind}{axis}")))
            .collect();
        let text = format!("endheader\ntime {}\n0 0 9 0 1 0 1\n", names.join(" "));
        let mut plates = Plate::from_columns(&Table::read(text.as_bytes()).unwrap()).unwrap();
        plates[0].body = body.map(str::to_owned);
        let assignment = assign_plate(&plates[0], feet);
        (assignment.foot, assignment.by)
    }

    #[test]
    fn a_side_with_one_foot_assigns_the_plate() {
        let two = [foot("right foot", Side::Right, "calcn_r"), foot("left foot", Side::Left, "calcn_l")];
        assert_eq!(foot_of_plate("ground_force_l_", None, &two), (Some(1), Some(AssignedBy::Name)));
        assert_eq!(foot_of_plate("ground_force_1_", None, &two), (None, Some(AssignedBy::Nearest)));
        assert_eq!(
            foot_of_plate("ground_force_1_", Some("tibia_l"), &two),
            (Some(1), Some(AssignedBy::Loads))
        );
        assert_eq!(foot_of_plate("ground_force_l_", None, &two[..1]), (None, None));
        assert_eq!(foot_of_plate("ground_force_1_", None, &two[..1]), (Some(0), Some(AssignedBy::OnlyFoot)));
    }

    #[test]
    fn a_side_with_two_feet_does_not_assign_the_plate() {
        let horse = [foot("hind", Side::Right, "pes_r"), foot("fore", Side::Right, "manus_r")];
        assert_eq!(foot_of_plate("ground_force_r_", None, &horse), (None, Some(AssignedBy::Nearest)));
        assert_eq!(
            foot_of_plate("ground_force_1_", Some("manus_r"), &horse),
            (Some(1), Some(AssignedBy::Loads))
        );
        assert_eq!(
            foot_of_plate("ground_force_1_", Some("radius_r"), &horse),
            (None, Some(AssignedBy::Nearest))
        );
        assert_eq!(foot_of_plate("ground_force_1_", Some("torso"), &horse), (None, None));
    }
}
