//! Summarises the contacts of each foot along a recording.

use std::ops::Range;

use contact_scaling::{limits, patch, restitution};
use osim_model::DVec3;

use crate::feet::{Foot, StancePhase, TOUCH_DOWN_BW, strides};
use crate::plate_assignment::MeasuredForces;
use crate::plate_comparison::{Comparison, ComparisonPlane, percentile};
use crate::states::{CentreOfPressure, ContactState, ContactStates, Wrench};

/// Summary of a sphere along a recording.
#[derive(Debug, Clone, PartialEq)]
pub struct SphereSummary {
    /// Index of the sphere's contact pair.
    pub pair: usize,
    /// Largest force of the sphere along the normal, N.
    pub peak_n: f64,
    /// Largest x/R of the sphere; below 0 if it never touches.
    pub largest_relative_indentation: f64,
    /// The time of the largest x/R, s.
    pub largest_at_s: f64,
    /// The largest mean stress on the contact patch (15), N/m², and its time, s. Smoothed forces count where x exceeds √cf: below, the
    /// patch is nearly 0, and the force is not. `None` without such a frame.
    pub largest_stress_n_m2: Option<(f64, f64)>,
    /// Time for which x/R is above the limit of the Hertz law, s.
    pub beyond_hertz_s: f64,
    /// Time for which the centre of the sphere is below the plane (x/R above 1), s.
    pub beyond_radius_s: f64,
    /// The median slip speed of the sphere in frames with contact, m/s.
    pub slip_m_s: Option<f64>,
    /// All touch-downs of the sphere.
    pub touch_downs: Vec<TouchDown>,
}

/// The moment at which a sphere touches its plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TouchDown {
    /// The time at which the lowest point of the sphere passes the plane, s.
    pub time_s: f64,
    /// The rate of the indentation at this time, m/s.
    pub impact_speed_m_s: f64,
    /// The coefficient of restitution at the impact speed, by (12) without gravity.
    pub restitution: Option<f64>,
}

/// Summary of a foot along a recording.
#[derive(Debug, Clone, PartialEq)]
pub struct FootSummary {
    pub foot: Foot,
    /// The model's contact forces on the foot, frame by frame.
    pub wrenches: Vec<Wrench>,
    /// The largest force along the normal, N.
    pub peak_n: f64,
    /// The time of the largest force, s.
    pub peak_at_s: f64,
    /// Stances of the foot, from the plates if they measured it, else from the model's forces.
    pub stances: Vec<StanceSummary>,
    /// Whether the stances come from the plates.
    pub stands_by_plates: bool,
    /// The median depth of the deepest sphere in stance, m; negative above the plane. `None` if the foot never stands.
    pub stance_depth_m: Option<f64>,
    /// The range of the depth of the deepest sphere in stance, from the 5th to the 95th percentile, m.
    pub stance_scatter_m: Option<f64>,
    /// The energy that normal forces and friction of the foot take up in a stride, J: the mean over whole strides. `None` without one.
    pub lost_in_stride_j: Option<f64>,
    /// The largest depth of a sphere of the foot in the whole recording, m.
    pub deepest_m: f64,
    /// The median slip velocity of the deepest sphere in stance, m/s.
    pub stance_slip_m_s: Option<DVec3>,
    pub spheres: Vec<SphereSummary>,
    pub comparison: Option<Comparison>,
}

/// Summary of one stance of a foot.
#[derive(Debug, Clone, PartialEq)]
pub struct StanceSummary {
    pub stance: StancePhase,
    /// The model's largest force along the normal during the stance, N.
    pub peak_n: f64,
    /// The model's impulse along the normal during the stance, N s.
    pub impulse_n_s: f64,
    /// The model's steepest rise of the normal force between two frames of the stance, N/s.
    pub loading_rate_n_s: f64,
}

/// A summary of all contacts of a model along a recording.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// Body weight, N, by which forces are divided.
    pub weight_n: f64,
    pub feet: Vec<FootSummary>,
    /// Forces of all feet together, frame by frame.
    pub total: Vec<Wrench>,
    /// The largest force of all feet along the normal, N.
    pub peak_n: f64,
    /// The force of all feet compared with that of all plates.
    pub comparison: Option<Comparison>,
    pub smallest_radius_m: Option<f64>,
    /// The model's mean force along the normal over whole strides, N.
    pub stride_mean_n: Option<f64>,
    /// The mean normal force of the plates over whole strides, N; it equals the weight of the subject.
    pub measured_stride_mean_n: Option<f64>,
    /// The part of the time of whole strides in which more than one foot stands; `None` for one foot, or without a whole
    /// stride.
    pub double_support: Option<f64>,
}

impl Summary {
    /// Summarises the contacts of a model along a recording, beside the `measured` forces.
    pub fn of(
        states: &ContactStates,
        feet: &[Foot],
        measured: Option<&MeasuredForces>,
        weight_n: f64,
    ) -> Self {
        let feet: Vec<FootSummary> = feet
            .iter()
            .enumerate()
            .map(|(index, foot)| {
                let plates = measured.and_then(|measured| {
                    Some((measured.feet.get(index)?.as_slice(), *measured.has_points.get(index)?))
                });
                FootSummary::of(states, foot, plates, weight_n)
            })
            .collect();
        let mut total = vec![Wrench::default(); states.frames()];
        for foot in &feet {
            total.iter_mut().zip(&foot.wrenches).for_each(|(sum, wrench)| *sum = sum.plus(wrench));
        }
        let on = feet.first().and_then(|foot| comparison_plane(states, &foot.foot, weight_n, false));
        let normal = on.map_or(DVec3::ZERO, |on| on.normal);
        // Adding 0 removes the sign of a negative zero.
        let along = |wrench: &Wrench| wrench.force_n.dot(normal) + 0.0;
        let comparison = on.zip(measured).and_then(|(on, measured)| {
            let has_points = measured.has_points.iter().all(|&has_points| has_points);
            Comparison::of(&total, &measured.total, &ComparisonPlane { has_points, ..on })
        });
        let spans: Vec<(f64, f64)> = feet.iter().flat_map(FootSummary::strides).collect();
        let modelled: Vec<Option<f64>> = total.iter().map(|wrench| Some(along(wrench))).collect();
        let plates =
            measured.map(|measured| measured.total.iter().map(|one| one.as_ref().map(along)).collect());
        Self {
            weight_n,
            peak_n: total.iter().map(along).fold(f64::NEG_INFINITY, f64::max),
            smallest_radius_m: states.pairs.iter().map(|pair| pair.radius_m).reduce(f64::min),
            stride_mean_n: mean_over(&states.time_s, &modelled, &spans),
            measured_stride_mean_n: plates
                .and_then(|plates: Vec<Option<f64>>| mean_over(&states.time_s, &plates, &spans)),
            double_support: double_support(&states.time_s, &feet, &spans),
            feet,
            total,
            comparison,
        }
    }
}

/// The part of the time in `spans` in which more than one foot stands.
fn double_support(time_s: &[f64], feet: &[FootSummary], spans: &[(f64, f64)]) -> Option<f64> {
    let mut in_stride = vec![false; time_s.len()];
    for &span in spans {
        in_stride.get_mut(frames_between(time_s, span)).unwrap_or_default().fill(true);
    }
    let mut standing = vec![0_usize; time_s.len()];
    for stance in feet.iter().flat_map(|foot| &foot.stances).map(|one| one.stance) {
        standing.get_mut(stance.frames()).unwrap_or_default().iter_mut().for_each(|feet| *feet += 1);
    }
    let is_in_stride = |frame: usize| in_stride.get(frame) == Some(&true);
    let is_double = |frame: usize| is_in_stride(frame) && standing.get(frame).is_some_and(|&feet| feet > 1);
    let strides_s = duration_s(time_s, is_in_stride);
    (feet.len() > 1 && strides_s > 0.0).then(|| duration_s(time_s, is_double) / strides_s)
}

impl FootSummary {
    /// Summarises one foot, beside the forces of its plates.
    fn of(
        states: &ContactStates,
        foot: &Foot,
        plates: Option<(&[Option<Wrench>], bool)>,
        weight_n: f64,
    ) -> Self {
        let wrenches: Vec<Wrench> =
            (0..states.frames()).map(|frame| Wrench::from_states(foot.contacts(states, frame))).collect();
        let on = comparison_plane(states, foot, weight_n, plates.is_some_and(|(_, has_points)| has_points));
        let normal = on.map_or(DVec3::ZERO, |on| on.normal);
        let forces: Vec<f64> = wrenches.iter().map(|wrench| wrench.force_n.dot(normal) + 0.0).collect();
        let (peak_at, peak_n) = largest_with_index(&forces);
        let measured = plates.filter(|(measured, _)| measured.iter().any(Option::is_some));
        let standing = measured.map(|(measured, _)| {
            let force = |one: &Option<Wrench>| one.as_ref().map_or(f64::NAN, |one| one.force_n.dot(normal));
            measured.iter().map(force).collect::<Vec<f64>>()
        });
        let stances = StancePhase::all(&states.time_s, standing.as_deref().unwrap_or(&forces), weight_n);
        let deepest: Vec<Option<&ContactState>> =
            (0..states.frames()).map(|frame| foot.deepest(states, frame)).collect();
        let depth_in_frames = deepest.iter().flatten().map(|state| state.indentation_m);
        let standing_states: Vec<&ContactState> =
            stances.iter().flat_map(StancePhase::frames).filter_map(|frame| *deepest.get(frame)?).collect();
        let depths: Vec<f64> = standing_states.iter().map(|state| state.indentation_m).collect();
        let percentile = |part: f64| percentile(&depths, part);
        Self {
            peak_n,
            peak_at_s: states.time_s.get(peak_at).copied().unwrap_or_default(),
            stances: stances.iter().map(|stance| StanceSummary::of(states, stance, &forces)).collect(),
            stands_by_plates: measured.is_some(),
            lost_in_stride_j: lost_in_stride_j(states, foot, &strides(&stances)),
            stance_depth_m: percentile(0.5),
            stance_scatter_m: percentile(0.95).zip(percentile(0.05)).map(|(high, low)| high - low),
            deepest_m: depth_in_frames.fold(f64::NEG_INFINITY, f64::max),
            stance_slip_m_s: median_slip_m_s(&standing_states),
            spheres: foot.pairs.iter().map(|&pair| SphereSummary::of(states, pair)).collect(),
            comparison: on
                .zip(plates)
                .and_then(|(on, (measured, _))| Comparison::of(&wrenches, measured, &on)),
            wrenches,
            foot: foot.clone(),
        }
    }

    /// The model's centre of pressure in a frame; `None` if the normal force is too small.
    pub fn centre_of_pressure(
        &self,
        states: &ContactStates,
        frame: usize,
        weight_n: f64,
    ) -> Option<CentreOfPressure> {
        let on = comparison_plane(states, &self.foot, weight_n, false)?;
        self.wrenches.get(frame)?.centre_of_pressure(on.normal, on.point_m, on.least_n)
    }

    /// Begin and end of each whole stride of the foot, s.
    pub fn strides(&self) -> Vec<(f64, f64)> {
        let stances: Vec<StancePhase> = self.stances.iter().map(|one| one.stance).collect();
        strides(&stances)
    }
}

/// The plane in which the forces of a foot are compared: the plane of its first pair in the first frame.
fn comparison_plane(
    states: &ContactStates,
    foot: &Foot,
    weight_n: f64,
    has_points: bool,
) -> Option<ComparisonPlane> {
    let (normal, point_m) = foot.floor(states)?;
    Some(ComparisonPlane { normal, point_m, least_n: TOUCH_DOWN_BW * weight_n, has_points })
}

impl StanceSummary {
    /// Summarises one stance; `forces` are along the normal, N.
    fn of(states: &ContactStates, stance: &StancePhase, forces: &[f64]) -> Self {
        let times = states.time_s.get(stance.first..=stance.last).unwrap_or_default();
        let forces = forces.get(stance.first..=stance.last).unwrap_or_default();
        let steps = || times.windows(2).zip(forces.windows(2));
        let (mut impulse_n_s, mut loading_rate_n_s) = (0.0, 0.0_f64);
        for (times, forces) in steps() {
            let ([t0, t1], [f0, f1]) = (times, forces) else { continue };
            impulse_n_s += (t1 - t0) * (f0 + f1) / 2.0;
            loading_rate_n_s = loading_rate_n_s.max((f1 - f0) / (t1 - t0));
        }
        let peak_n = forces.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Self { stance: *stance, peak_n, impulse_n_s, loading_rate_n_s }
    }
}

impl SphereSummary {
    /// Summarises the sphere of one contact pair.
    fn of(states: &ContactStates, pair: usize) -> Self {
        let (radius_m, dissipation) =
            states.pairs.get(pair).map_or((1.0, 0.0), |pair| (pair.radius_m, pair.law.dissipation()));
        let all: Vec<&ContactState> = states.pair(pair).collect();
        let relative: Vec<f64> = all.iter().map(|state| state.indentation_m / radius_m).collect();
        let (deepest, largest_relative_indentation) = largest_with_index(&relative);
        let beyond =
            |limit: f64| duration_s(&states.time_s, |frame| relative.get(frame).is_some_and(|&x| x > limit));
        let touching = all.iter().filter(|state| state.indentation_m > 0.0);
        let slips: Vec<f64> = touching.map(|state| state.slip_speed_m_s()).collect();
        Self {
            pair,
            // Adding 0 removes the sign of a negative zero.
            peak_n: all.iter().map(|state| state.normal_force_n + 0.0).fold(f64::NEG_INFINITY, f64::max),
            largest_relative_indentation,
            largest_at_s: states.time_s.get(deepest).copied().unwrap_or_default(),
            largest_stress_n_m2: largest_stress(states, pair, &all),
            beyond_hertz_s: beyond(limits::INDENTATION.value),
            beyond_radius_s: beyond(1.0),
            slip_m_s: percentile(&slips, 0.5),
            touch_downs: touch_downs(&states.time_s, &all, dissipation),
        }
    }
}

/// The largest mean stress (15) of a pair, N/m², and its time, s.
fn largest_stress(states: &ContactStates, pair: usize, all: &[&ContactState]) -> Option<(f64, f64)> {
    let pair = states.pairs.get(pair)?;
    let (radius_m, least_m) = (pair.law.hertz().radius_m(), pair.smoothing.unwrap_or(0.0).sqrt());
    let deep = all.iter().zip(&states.time_s).filter(|(state, _)| state.indentation_m > least_m);
    let stress = |(state, time_s): (&&ContactState, &f64)| {
        let x = state.indentation_m / radius_m;
        Some((patch::mean_stress(state.normal_force_n, radius_m, x).ok()?, *time_s))
    };
    deep.filter_map(stress).max_by(|a, b| a.0.total_cmp(&b.0))
}

/// The energy that goes into the contacts of a foot in each of the strides `spans`, J: the mean. What springs hold at the begin of a stride
/// they hold at its end.
fn lost_in_stride_j(states: &ContactStates, foot: &Foot, spans: &[(f64, f64)]) -> Option<f64> {
    let power = |frame: usize| -> f64 {
        let into =
            |state: &ContactState| state.normal_force_n * state.rate_m_s - state.force_n.dot(state.slip_m_s);
        foot.contacts(states, frame).map(into).sum()
    };
    let lost = |&span: &(f64, f64)| -> f64 {
        let frames = frames_between(&states.time_s, span);
        let steps = frames.clone().zip(frames.skip(1));
        steps.map(|(a, b)| (states.time_s[b] - states.time_s[a]) * (power(a) + power(b)) / 2.0).sum()
    };
    (!spans.is_empty()).then(|| spans.iter().map(lost).sum::<f64>() / spans.len() as f64)
}

/// Every moment at which the bottom of a sphere comes to its plane.
fn touch_downs(time_s: &[f64], states: &[&ContactState], dissipation: f64) -> Vec<TouchDown> {
    let mut found = Vec::new();
    for (times, pair) in time_s.windows(2).zip(states.windows(2)) {
        let ([t0, t1], [before, after]) = (times, pair) else { continue };
        if before.indentation_m > 0.0 || after.indentation_m <= 0.0 {
            continue;
        }
        let part = -before.indentation_m / (after.indentation_m - before.indentation_m);
        let impact_speed_m_s = before.rate_m_s + part * (after.rate_m_s - before.rate_m_s);
        let restitution = restitution::exact(dissipation, impact_speed_m_s).ok();
        found.push(TouchDown { time_s: t0 + part * (t1 - t0), impact_speed_m_s, restitution });
    }
    found
}

/// The time for which `holds` is true, s; each frame counts for half of the time to its neighbours.
fn duration_s(time_s: &[f64], holds: impl Fn(usize) -> bool) -> f64 {
    let steps =
        time_s.windows(2).enumerate().filter_map(|(frame, pair)| Some((frame, pair.get(1)? - pair.first()?)));
    let half = |frame: usize, step: f64| if holds(frame) { step / 2.0 } else { 0.0 };
    steps.map(|(frame, step)| half(frame, step) + half(frame + 1, step)).sum()
}

/// The frames from the first time up to the second, without the frame at the second time.
fn frames_between(time_s: &[f64], (from_s, to_s): (f64, f64)) -> Range<usize> {
    let before = |limit: f64| time_s.partition_point(|&time| time < limit);
    before(from_s)..before(to_s)
}

/// The index of the largest value, and the value.
fn largest_with_index(values: &[f64]) -> (usize, f64) {
    let all = values.iter().copied().enumerate();
    all.fold((0, f64::NEG_INFINITY), |best, one| if one.1 > best.1 { one } else { best })
}

/// The median slip velocity of the states, component by component, m/s.
fn median_slip_m_s(states: &[&ContactState]) -> Option<DVec3> {
    let median = |axis: usize| {
        let parts: Vec<f64> = states.iter().map(|state| state.slip_m_s[axis]).collect();
        percentile(&parts, 0.5)
    };
    Some(DVec3::new(median(0)?, median(1)?, median(2)?))
}

/// The mean of `values` over all frames in `spans`, weighted with time; a span with unknown values does not count.
fn mean_over(time_s: &[f64], values: &[Option<f64>], spans: &[(f64, f64)]) -> Option<f64> {
    let (mut sum, mut all_s) = (0.0, 0.0);
    for &span in spans {
        let frames = frames_between(time_s, span);
        let known: Option<Vec<f64>> = frames.clone().map(|frame| *values.get(frame)?).collect();
        for (frame, value) in frames.zip(known.into_iter().flatten()) {
            let step_s = time_s.get(frame + 1).map_or(0.0, |next| next - time_s[frame]);
            sum += step_s * value;
            all_s += step_s;
        }
    }
    (all_s > 0.0).then(|| sum / all_s)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_frame_lasts_to_the_middle_of_its_neighbours() {
        assert_eq!(duration_s(&[0.0, 1.0, 3.0, 4.0], |frame| frame == 1), 1.5);
        assert_eq!(duration_s(&[0.0, 1.0, 3.0, 4.0], |_| true), 4.0);
    }

    #[test]
    fn means_over_time_need_values_in_the_whole_span() {
        let times = [0.0, 1.0, 2.0, 3.0];
        assert_eq!(mean_over(&times, &[Some(1.0), Some(3.0), Some(9.0), None], &[(0.0, 2.0)]), Some(2.0));
        assert_eq!(mean_over(&times, &[Some(1.0), None, Some(9.0), None], &[(0.0, 2.0)]), None);
        // A frame lasts until the next, here 2 s.
        let values = [Some(1.0), Some(4.0), Some(9.0)];
        assert_eq!(mean_over(&[0.0, 1.0, 3.0], &values, &[(0.0, 3.0)]), Some(3.0));
    }
}
