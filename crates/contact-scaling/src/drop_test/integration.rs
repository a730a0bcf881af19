//! The values of a drop test, the falling body, and the integration of its motion.

use differential_equations::methods::ExplicitRungeKutta;
use differential_equations::ode::{ODE, solve_ode};
use differential_equations::prelude::{ControlFlag, Error, Interpolation, Solout, Solution};

use crate::{DomainError, Law, Spheres};

/// The values of a drop test, by name and not yet checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DropValues {
    /// Body mass M, in kg.
    pub mass_kg: f64,
    /// Gravity g, in m/s².
    pub gravity_m_s2: f64,
    /// Height of the spheres' bottoms above the ground at the start, in m.
    pub height_m: f64,
    /// Duration of the computed motion, in s.
    pub duration_s: f64,
    /// Number of samples in the series, with both ends.
    pub samples: usize,
}

/// The reason why a drop test has no result.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DropError {
    /// A number is outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// The integration failed: the contact is too stiff or too dissipative for the duration.
    #[error(
        "the drop could not be followed past {time_s:?} s, expected a softer contact or a shorter duration"
    )]
    Integration {
        /// Time up to which the drop was computed, in s.
        time_s: f64,
    },
}

/// A body with spheres, and the length, time and force by which its motion is made dimensionless.
#[derive(Debug, Clone, Copy)]
pub(super) struct FallingBody<'a> {
    pub(super) spheres: &'a [Spheres],
    /// Body weight M g, in N.
    pub(super) weight_n: f64,
    /// Reference length L = √(Σ R_i² / n), in m.
    pub(super) length_m: f64,
    /// Reference time √(L / g), in s.
    pub(super) time_s: f64,
}

impl<'a> FallingBody<'a> {
    /// The body, with the length, time and force that follow from its spheres, its mass and gravity.
    pub(super) fn new(spheres: &'a [Spheres], mass_kg: f64, gravity_m_s2: f64) -> Self {
        let weigh = |f: fn(&Spheres) -> f64| spheres.iter().map(|s| s.count() * f(s)).sum::<f64>();
        let square = weigh(|s| s.law().hertz().radius_m() * s.law().hertz().radius_m());
        let length_m = (square / weigh(|_| 1.0)).sqrt();
        Self { spheres, weight_n: mass_kg * gravity_m_s2, length_m, time_s: (length_m / gravity_m_s2).sqrt() }
    }

    /// Reference speed √(g L), in m/s.
    pub(super) fn speed_m_s(&self) -> f64 {
        self.length_m / self.time_s
    }

    /// Normal force of all spheres, in N.
    pub(super) fn force_n(&self, indentation_m: f64, speed_m_s: f64) -> f64 {
        self.spheres.iter().map(|s| s.force(indentation_m, speed_m_s)).sum()
    }

    /// Normal force of all spheres divided by body weight, from the dimensionless state.
    pub(super) fn force(&self, state: [f64; 2]) -> f64 {
        self.force_n(state[0] * self.length_m, state[1] * self.speed_m_s()) / self.weight_n
    }

    /// Normal force divided by body weight of the spheres with a smoothed law, which have a force before contact, too.
    fn flight_force(&self, state: [f64; 2]) -> f64 {
        let smooth = self.spheres.iter().filter(|s| matches!(s.law(), Law::Smooth(_)));
        let (x, rate) = (state[0] * self.length_m, state[1] * self.speed_m_s());
        smooth.map(|s| s.force(x, rate)).sum::<f64>() / self.weight_n
    }

    /// Mean of a quantity over the spheres.
    pub(super) fn mean(&self, quantity: impl Fn(&Spheres) -> f64) -> f64 {
        let count: f64 = self.spheres.iter().map(Spheres::count).sum();
        self.spheres.iter().map(|s| s.count() * quantity(s)).sum::<f64>() / count
    }

    /// The common α of all spheres, in s/m. At equal x their forces add up to one Hunt–Crossley law; its α is the mean of α_i
    /// with the weights √R_i E*_i, while no force is limited to 0.
    pub(super) fn dissipation(&self) -> f64 {
        let strength = |s: &Spheres| s.count() * s.law().hertz().coefficient();
        let all: f64 = self.spheres.iter().map(strength).sum();
        self.spheres.iter().map(|s| strength(s) / all * s.law().dissipation()).sum()
    }
}

// The integration of a drop, in dimensionless form: dx/dt = v, dv/dt = 1 − F(x, v)/(M g).
//
// The Hertz force is only once differentiable where contact begins. There the integration stops, on the point
// itself, and starts again; in between the motion is smooth.

/// The dimensionless state: indentation and its rate.
pub(super) type DepthAndSpeed = [f64; 2];

/// Relative bound of the local error. Not the steps, but the interpolation within them limits the accuracy: with the bounds 1e-11
/// and 1e-12, the series of the 62 kg human has an error of 1.1e-8 R; with 3e-13 and 3e-14 of 6e-10 R
/// (`tests/scaling/drop_test.rs`), in 0.5 ms instead of 0.3.
const LARGEST_RELATIVE_STEP_ERROR: f64 = 3e-13;
/// Absolute bound of the local error of the dimensionless height and speed.
const LARGEST_ABSOLUTE_STEP_ERROR: f64 = 3e-14;
/// The largest number of steps between two contact events; the paper's drops need some hundreds.
const MOST_STEPS: usize = 1_000_000;
/// The largest number of contact events in one drop.
const MOST_CONTACT_EVENTS: usize = 100_000;
/// Number of points of a step at which the force is computed to find its peak.
const SAMPLES_PER_STEP_FOR_PEAK: u32 = 8;
/// A step is searched for a larger force if its largest computed force is at most this share below the largest force so far.
const PEAK_MARGIN: f64 = 1e-3;

/// The dimensionless states and events that are recorded during a drop.
#[derive(Debug, Default)]
pub(super) struct RecordedDrop {
    pub(super) states: Vec<DepthAndSpeed>,
    pub(super) peak_force: f64,
    /// Dimensionless times and speeds at the crossings of x = 0; the first crossing is downwards, then the direction
    /// alternates.
    pub(super) crossings: Vec<(f64, f64)>,
}

/// Integrates the motion of the body from its release at speed 0.
pub(super) fn integrate(body: &FallingBody<'_>, values: &DropValues) -> Result<RecordedDrop, DropError> {
    let end = values.duration_s / body.time_s;
    let mut state = [-values.height_m / body.length_m, 0.0];
    let mut time = 0.0;
    let mut contact = values.height_m == 0.0;
    let restart = body.spheres.iter().any(|s| matches!(s.law(), Law::HuntCrossley(_)));
    let mut observer = DropObserver {
        body,
        record: RecordedDrop::default(),
        samples: values.samples,
        end,
        contact,
        restart,
    };
    if contact {
        observer.record.crossings.push((0.0, 0.0));
    }
    for _ in 0..MOST_CONTACT_EVENTS {
        observer.contact = contact;
        let before = observer.record.crossings.len();
        let fall = FallEquation { body, contact };
        let mut method = ExplicitRungeKutta::dop853()
            .rtol(LARGEST_RELATIVE_STEP_ERROR)
            .atol(LARGEST_ABSOLUTE_STEP_ERROR)
            .max_steps(MOST_STEPS);
        let solution = solve_ode(&mut method, &fall, time, end, &state, &mut observer)
            .map_err(|error| DropError::Integration { time_s: time_reached(&error, time) * body.time_s })?;
        let crossed = observer.record.crossings.get(before).filter(|_| restart).copied();
        match crossed {
            Some((at, speed)) if end - at > 1e-12 * end => {
                (time, state, contact) = (at, [0.0, speed], !contact);
            }
            Some((_, speed)) => return Ok(observer.finish([0.0, speed])),
            None => {
                let last = solution.y.last().copied().unwrap_or(state);
                return Ok(observer.finish(last));
            }
        }
    }
    Err(DropError::Integration { time_s: time * body.time_s })
}

/// The dimensionless time until which an integration came that ended by an error.
fn time_reached(error: &Error<f64, DepthAndSpeed>, start: f64) -> f64 {
    match error {
        Error::MaxSteps { t, .. } | Error::StepSize { t, .. } | Error::Stiffness { t, .. } => *t,
        _ => start,
    }
}

/// The equation of motion. In flight only smoothed forces act, even if a stage of the integrator is below the ground.
struct FallEquation<'a> {
    body: &'a FallingBody<'a>,
    contact: bool,
}

impl ODE<f64, DepthAndSpeed> for FallEquation<'_> {
    fn diff(&self, _time: f64, state: &DepthAndSpeed, rate: &mut DepthAndSpeed) {
        rate[0] = state[1];
        rate[1] = 1.0 - if self.contact { self.body.force(*state) } else { self.body.flight_force(*state) };
    }
}

/// Observes the steps of the integrator: records samples, the peak force and the crossings of x = 0.
struct DropObserver<'a> {
    body: &'a FallingBody<'a>,
    record: RecordedDrop,
    samples: usize,
    end: f64,
    contact: bool,
    restart: bool,
}

impl DropObserver<'_> {
    /// Dimensionless time of the next sample; `None` if all samples are recorded.
    fn next_sample(&self) -> Option<f64> {
        let next = self.record.states.len();
        (next < self.samples).then(|| self.end * (next as f64 / (self.samples - 1) as f64))
    }

    /// Records the last samples if the integration ends earlier by a rounding error.
    fn finish(mut self, last: DepthAndSpeed) -> RecordedDrop {
        self.record.states.resize(self.samples, last);
        self.record
    }

    /// Computes the force at some points of a step. If the largest of them is nearly as large as the peak so far, the maximum
    /// between its neighbours is searched: if a step begins just before the peak, the forces at its later points can all be
    /// smaller than the peak.
    fn find_peak(&mut self, from: f64, to: f64, at: &mut impl FnMut(f64) -> Option<DepthAndSpeed>) {
        let width = (to - from) / f64::from(SAMPLES_PER_STEP_FOR_PEAK);
        let mut force = |time: f64| at(time).map_or(0.0, |state| self.body.force(state));
        let (mut best, mut top) = (from, force(from));
        for point in 1..=SAMPLES_PER_STEP_FOR_PEAK {
            let time = if point == SAMPLES_PER_STEP_FOR_PEAK { to } else { from + width * f64::from(point) };
            let here = force(time);
            if here > top {
                (best, top) = (time, here);
            }
        }
        if top > 0.0 && top >= self.record.peak_force * (1.0 - PEAK_MARGIN) {
            let closer = golden_section_maximum((best - width).max(from), (best + width).min(to), &mut force);
            self.record.peak_force = self.record.peak_force.max(top).max(closer);
        }
    }
}

/// The largest value of `f` between `low` and `high`; `f` has one maximum there.
fn golden_section_maximum(mut low: f64, mut high: f64, f: &mut impl FnMut(f64) -> f64) -> f64 {
    const GOLDEN_SHARE: f64 = 0.618_033_988_749_894_9;
    let (mut a, mut b) = (high - GOLDEN_SHARE * (high - low), low + GOLDEN_SHARE * (high - low));
    let (mut fa, mut fb) = (f(a), f(b));
    let mut best = fa.max(fb);
    for _ in 0..36 {
        if fa < fb {
            (low, a, fa) = (a, b, fb);
            b = low + GOLDEN_SHARE * (high - low);
            fb = f(b);
        } else {
            (high, b, fb) = (b, a, fa);
            a = high - GOLDEN_SHARE * (high - low);
            fa = f(a);
        }
        best = best.max(fa).max(fb);
    }
    best
}

impl Solout<f64, DepthAndSpeed> for DropObserver<'_> {
    fn solout<I>(
        &mut self,
        now: f64,
        before: f64,
        state: &DepthAndSpeed,
        _state_before: &DepthAndSpeed,
        step: &mut I,
        solution: &mut Solution<f64, DepthAndSpeed>,
    ) -> ControlFlag<f64, DepthAndSpeed>
    where
        I: Interpolation<f64, DepthAndSpeed> + ?Sized,
    {
        if now == before {
            if self.next_sample() == Some(now) {
                self.record.states.push(*state);
            }
            return ControlFlag::Continue;
        }
        let mut at = |time: f64| step.interpolate(time).ok();
        let crossed = if self.contact { state[0] < 0.0 } else { state[0] > 0.0 };
        let mut stop = now;
        if crossed {
            let (time, speed) = crossing_time_and_speed(before, now, self.contact, &mut at);
            self.record.crossings.push((time, speed));
            if self.restart {
                stop = time;
            } else {
                self.contact = !self.contact;
            }
        }
        while let Some(time) = self.next_sample().filter(|&time| time <= stop) {
            let sample = if time == now { Some(*state) } else { at(time) };
            self.record.states.push(sample.unwrap_or(*state));
        }
        self.find_peak(before, stop, &mut at);
        // Only the last state is asked for.
        solution.truncate(0);
        solution.push(now, *state);
        if crossed && self.restart { ControlFlag::Terminate } else { ControlFlag::Continue }
    }
}

/// Time and speed at which x changes its sign between two times; the time is exact to the last bit.
fn crossing_time_and_speed(
    before: f64,
    now: f64,
    upward: bool,
    at: &mut impl FnMut(f64) -> Option<DepthAndSpeed>,
) -> (f64, f64) {
    let (mut out, mut within) = (before, now);
    for _ in 0..100 {
        let middle = 0.5 * (out + within);
        if middle <= out || middle >= within {
            break;
        }
        let x = at(middle).map_or(0.0, |state| state[0]);
        if (x < 0.0) == upward { within = middle } else { out = middle }
    }
    (within, at(within).map_or(0.0, |state| state[1]))
}
