//! What the inertia of the whole body says about the forces of plates: a delay, and a direction with the wrong sign.

use gcv_spline::GcvSpline;
use osim_model::DVec3;

use super::dynamics::{END_FRAMES, Masses};
use crate::Recording;

/// The largest delay of the plates that is looked for, s.
const MOST_DELAY_S: f64 = 0.15;
/// The width of the smoothing before a delay is looked for (a standard deviation), s: recordings at 60 Hz tremble.
const SMOOTHING_S: f64 = 0.012;
/// The least correlation of inertia and force, and the least share of the force in the inertia, that show a delay. They are lower
/// where steps are not on the plates, and where the motion jerks.
const LEAST_INERTIA: f64 = 0.5;

/// The least logarithm of the likelihood, times 2, by which a delay explains more than none: 3 standard deviations.
const LEAST_GAIN: f64 = 9.0;
/// In a shorter time, s, the acceleration along the floor may differ from the force of right plates.
const LEAST_TIME_S: f64 = 0.6;

/// The mass of the whole body, `kg`, times its acceleration, N; `None` at the ends, where it is bad.
pub(super) fn inertia_n(masses: &Masses<'_>, recording: &Recording, kg: f64) -> Vec<Option<DVec3>> {
    let centres_kg_m: Vec<DVec3> =
        masses.centre_along(recording, None).into_iter().map(|at| kg * at).collect();
    accelerations(&recording.time_s, &centres_kg_m)
}

/// Second derivatives of splines through `values`; `None` at the ends, where they are bad.
fn accelerations(time_s: &[f64], values: &[DVec3]) -> Vec<Option<DVec3>> {
    let times = time_s.to_vec();
    let mut all = vec![Some(DVec3::ZERO); values.len()];
    for axis in 0..3 {
        let along: Vec<f64> = values.iter().map(|value| value[axis]).collect();
        let Ok(spline) = GcvSpline::from_data(&times, &along) else { return vec![None; values.len()] };
        for (one, part) in all.iter_mut().flatten().zip(spline.derivative(&times, 2)) {
            one[axis] = part;
        }
    }
    let inner = END_FRAMES..values.len().saturating_sub(END_FRAMES);
    all.iter().enumerate().map(|(frame, one)| one.filter(|_| inner.contains(&frame))).collect()
}

/// Averages of the known values around each known value, weighted by a normal distribution in time.
fn smoothed(values: &[Option<DVec3>], step_s: f64) -> Vec<Option<DVec3>> {
    let reach = (3.0 * SMOOTHING_S / step_s).min(values.len() as f64) as usize;
    let average = |frame: usize| {
        values[frame]?;
        let (mut sum, mut weights) = (DVec3::ZERO, 0.0);
        let around = values.iter().enumerate().take(frame.saturating_add(reach + 1));
        for (near, value) in around.skip(frame.saturating_sub(reach)) {
            let Some(value) = *value else { continue };
            let apart = frame.abs_diff(near) as f64 * step_s / SMOOTHING_S;
            let weight = libm::exp(-0.5 * apart * apart);
            (sum, weights) = (sum + weight * value, weights + weight);
        }
        Some(sum / weights)
    };
    (0..values.len()).map(average).collect()
}

/// The time by which the plates' force is later than the inertia of the whole body (mass times acceleration), s: at the highest
/// correlation over all components. `None` if this inertia does not explain the force.
pub(super) fn delay_s(time_s: &[f64], inertia_n: &[Option<DVec3>], force_n: &[Option<DVec3>]) -> Option<f64> {
    let step_s = (time_s.last()? - time_s.first()?) / time_s.len().checked_sub(1)? as f64;
    let known =
        inertia_n.iter().zip(force_n).filter(|(inertia, force)| inertia.is_some() && force.is_some()).count();
    let most = (MOST_DELAY_S / step_s).min(known as f64 / 3.0) as usize;
    let [inertia_n, force_n] = [inertia_n, force_n].map(|all| smoothed(all, step_s));
    // The correlation, and the slope of the inertia over the force, if enough frames of both are known. The force is later by `shift`
    // frames less `most`.
    let compared = |shift: usize| {
        let (earlier, later) = (
            inertia_n.iter().skip(most.saturating_sub(shift)),
            force_n.iter().skip(shift.saturating_sub(most)),
        );
        let (inertia, force): (Vec<DVec3>, Vec<DVec3>) =
            earlier.zip(later).filter_map(|(inertia, force)| inertia.zip(*force)).unzip();
        if inertia.len() < known / 2 {
            return (f64::NAN, f64::NAN);
        }
        explained(&inertia, &force)
    };
    let all: Vec<(f64, f64)> = (0..=2 * most).map(compared).collect();
    let best = (0..all.len())
        .filter(|&one| all[one].0.is_finite())
        .max_by(|&a, &b| all[a].0.total_cmp(&all[b].0))?;
    let [before, here, after] = [all.get(best.checked_sub(1)?)?.0, all[best].0, all.get(best + 1)?.0];
    let bend = before - 2.0 * here + after;
    let part = if bend < 0.0 { (before - after) / (2.0 * bend) } else { 0.0 };
    // The logarithm of the part of the force that is unexplained without the shift, over that with it, for each independent time.
    let unexplained = |at: usize| 1.0 - all[at].0 * all[at].0;
    let independent = known as f64 * step_s / (2.0 * std::f64::consts::PI.sqrt() * SMOOTHING_S);
    let gain = independent * libm::log(unexplained(most) / unexplained(best));
    (here.min(all[best].1) > LEAST_INERTIA && (best == most || gain > LEAST_GAIN))
        .then_some((best as f64 - most as f64 + part) * step_s)
}

/// The correlation of inertia and force in the same frames, and the slope of the inertia over the force.
fn explained(inertia: &[DVec3], force: &[DVec3]) -> (f64, f64) {
    let mean = |of: &[DVec3]| of.iter().sum::<DVec3>() / of.len() as f64;
    let (inertia_0, force_0) = (mean(inertia), mean(force));
    let sum = |of: fn(DVec3, DVec3) -> f64| -> f64 {
        inertia.iter().zip(force).map(|(one, other)| of(*one - inertia_0, *other - force_0)).sum()
    };
    let product = sum(DVec3::dot);
    let (squares, force_squares) =
        (sum(|one, _| one.length_squared()), sum(|_, other| other.length_squared()));
    (product / (squares * force_squares).sqrt(), product / force_squares)
}

/// A force along the floor that varies less than this, in body weights (standard deviation), may be cross-talk of the vertical one. Walks
/// have 0.06 and more.
const LEAST_REVERSED_BW: f64 = 0.02;

/// The direction along a floor with this normal in which the plates' force is opposite to the inertia of the whole body, although this
/// inertia explains the force along the normal. `None` if there is none, if the force there is small, or if the time is too short to show it.
pub(super) fn reversed_direction(
    time_s: &[f64],
    inertia_n: &[Option<DVec3>],
    force_n: &[Option<DVec3>],
    (normal, weight_n): (DVec3, f64),
) -> Option<DVec3> {
    let step_s = (time_s.last()? - time_s.first()?) / time_s.len().checked_sub(1)? as f64;
    let [inertia_n, force_n] = [inertia_n, force_n].map(|all| smoothed(all, step_s));
    let (inertia, force): (Vec<DVec3>, Vec<DVec3>) =
        inertia_n.iter().zip(&force_n).filter_map(|(inertia, force)| inertia.zip(*force)).unzip();
    let along = |all: &[DVec3], direction: DVec3| -> Vec<DVec3> {
        all.iter().map(|one| one.project_onto(direction)).collect()
    };
    let correlation = |direction: DVec3| explained(&along(&inertia, direction), &along(&force, direction)).0;
    let is_large = |direction: &DVec3| {
        let all = along(&force, *direction);
        let mean = all.iter().sum::<DVec3>() / all.len() as f64;
        let squares: f64 = all.iter().map(|one| (*one - mean).length_squared()).sum();
        (squares / all.len() as f64).sqrt() > LEAST_REVERSED_BW * weight_n
    };
    let is_explained = inertia.len() as f64 * step_s > LEAST_TIME_S && correlation(normal) > LEAST_INERTIA;
    let level = DVec3::AXES.map(|axis| axis.reject_from(normal)).into_iter();
    let mut level = level.filter(|along| is_explained && along.length_squared() > 0.5);
    level.find(|along| is_large(along) && correlation(*along) < -LEAST_INERTIA)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The delay that is found where the force is late by `late_s`, and the motion shows a share of the inertia.
    fn delay_of(late_s: f64, inertia_share: f64) -> Option<f64> {
        let wave_n = |time: f64| {
            let along_y = (9.0 * time).sin() + 0.4 * (23.0 * time).cos();
            DVec3::new(8.0 * (11.0 * time).sin(), 70.0 * along_y, 0.0)
        };
        let times: Vec<f64> = (0..100).map(|frame| 0.01 * f64::from(frame)).collect();
        let inertia = |time: &f64| Some(inertia_share * wave_n(*time));
        let force = |time: &f64| Some(wave_n(time - late_s) + 700.0 * DVec3::Y);
        let inertia: Vec<Option<DVec3>> = times.iter().map(inertia).collect();
        delay_s(&times, &inertia, &times.iter().map(force).collect::<Vec<Option<DVec3>>>())
    }

    #[test]
    fn a_delay_is_found_by_correlation() {
        for late_s in [-0.06, 0.0, 0.033, 0.1] {
            let found_s = delay_of(late_s, 1.0).unwrap();
            assert!((found_s - late_s).abs() < 2e-3, "{found_s} {late_s}");
        }
    }

    #[test]
    fn inertia_that_does_not_explain_the_force_shows_no_delay() {
        assert_eq!(delay_of(0.05, 0.1), None);
    }

    #[test]
    fn a_direction_with_the_wrong_sign_is_found() {
        let times: Vec<f64> = (0..100).map(|frame| 0.01 * f64::from(frame)).collect();
        let wave = |time: &f64| DVec3::new(70.0 * (11.0 * time).sin(), 300.0 * (9.0 * time).cos(), 0.0);
        let inertia: Vec<Option<DVec3>> = times.iter().map(|time| Some(wave(time))).collect();
        let found = |signs: DVec3, rows: usize| {
            let force = times.iter().map(|time| Some(signs * wave(time))).collect::<Vec<_>>();
            reversed_direction(&times[..rows], &inertia[..rows], &force[..rows], (DVec3::Y, 700.0))
        };
        assert_eq!(found(DVec3::new(-1.0, 1.0, 1.0), 100), Some(DVec3::X));
        // Cross-talk of the vertical force; right signs; a force that the inertia does not explain; too short.
        assert_eq!(found(DVec3::new(-0.1, 1.0, 1.0), 100), None);
        assert_eq!(found(DVec3::ONE, 100), None);
        assert_eq!(found(-DVec3::ONE, 100), None);
        assert_eq!(found(DVec3::new(-1.0, 1.0, 1.0), 50), None);
    }

    #[test]
    fn accelerations_are_unknown_at_the_ends() {
        let times: Vec<f64> = (0..40).map(|frame| 0.02 * f64::from(frame)).collect();
        let places: Vec<DVec3> =
            times.iter().map(|time| DVec3::new(1.0, (3.0 * time).sin(), *time)).collect();
        let found = accelerations(&times, &places);
        assert_eq!((found[2], found[37]), (None, None));
        let expected = -9.0 * (3.0 * times[20]).sin() * DVec3::Y;
        assert!((found[20].unwrap() - expected).length() < 1e-6, "{found:?}");
    }
}
