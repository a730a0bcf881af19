//! The search for all unknowns together.

use super::cholesky::product;
use super::foot::{At, FittedFoot, Goals, Row};
use super::layout::Layout;
use super::normal::{Block, Normal, Step, add_times};
use crate::fit::data::FitTrial;
use crate::fit::problem::Unknowns;
use crate::fit::result::MovedSphere;
use crate::fit::search::{FitBounds, FitError};

/// An error of the force that costs as much as slack of its usual size, body weights.
const USUAL_BW: f64 = 0.05;
/// Slack in pitch that is as usual as one metre in height, rad.
const PITCH_RAD_M: f64 = 5.0;
/// How much the mean of the heights of a foot's spheres, which is none, counts: body weights for a metre.
const NO_MEAN_BW_M: f64 = 1e6;
/// Steps of the search, tries of one step, and the part of the cost below which a step is the last one.
const STEPS: usize = 100;
const TRIES: usize = 14;
const LAST: f64 = 1e-7;

/// Trials with their feet, as they are fitted.
pub(in crate::fit) struct Refining<'t> {
    pub(super) feet: Vec<FittedFoot<'t>>,
    pub(super) layout: &'t Layout,
    pub(super) start: Unknowns,
    pub(super) slack_m: Option<f64>,
}

/// The best of all unknowns.
pub(in crate::fit) struct Refined {
    /// What is shared, by the layout.
    pub(in crate::fit) shared: Vec<f64>,
    pub(super) slack: Vec<Vec<f64>>,
    pub(super) normal: Normal,
    pub(super) held: Vec<bool>,
}

impl<'t> Refining<'t> {
    pub(in crate::fit) fn new(
        trials: &'t [FitTrial],
        bounds: &FitBounds,
        layout: &'t Layout,
        start: &Unknowns,
    ) -> Self {
        let goals =
            Goals { cop_m: bounds.cop_m, most_relative_indentation: bounds.most_relative_indentation };
        let trials = trials.iter().enumerate();
        let feet = trials.flat_map(|(number, trial)| {
            FittedFoot::all(trial, number, layout, goals, bounds.slack_m.is_some())
        });
        Self { feet: feet.collect(), layout, start: start.clone(), slack_m: bounds.slack_m }
    }

    /// Where the search begins.
    pub(in crate::fit) fn start(&self) -> &Unknowns {
        &self.start
    }

    /// The best unknowns from the start; `first_others` searches for all but stiffness and dissipation first, and for all from there.
    ///
    /// # Errors
    /// [`FitError::NotConverged`] where the equations have no solution.
    pub(in crate::fit) fn search(&self, first_others: bool) -> Result<Refined, FitError> {
        let limits = self.layout.limits();
        let mut shared = self.layout.start(&self.start);
        shared.iter_mut().zip(&limits).for_each(|(value, &(low, high))| *value = value.clamp(low, high));
        let windows = self.feet.iter().flat_map(|foot| &foot.windows);
        let slack: Vec<Vec<f64>> = windows.map(|window| vec![0.0; 2 * window.splines()]).collect();
        let mut best =
            Refined { normal: self.normal(&shared, &slack), held: vec![false; shared.len()], shared, slack };
        if first_others {
            let kept = [self.layout.stiffness, self.layout.dissipation];
            self.go_down(&mut best, &limits, &kept);
        }
        self.go_down(&mut best, &limits, &[]);
        if !best.normal.cost.is_finite() {
            return Err(FitError::NotConverged);
        }
        best.held = held(&best.shared, &limits, &best.normal.slope);
        Ok(best)
    }

    /// Steps to lower costs until none is left, with the unknowns at `kept` as they are.
    fn go_down(&self, best: &mut Refined, limits: &[(f64, f64)], kept: &[Option<usize>]) {
        let mut damping = 1e-3;
        for _ in 0..STEPS {
            let mut held = held(&best.shared, limits, &best.normal.slope);
            for place in kept.iter().flatten() {
                held.iter_mut().skip(*place).take(1).for_each(|one| *one = true);
            }
            let mut gained = None;
            for _ in 0..TRIES {
                let lower = best.normal.step(damping, &held).map(|step| self.stepped(best, &step, limits));
                if let Some(lower) = lower.filter(|lower| lower.normal.cost < best.normal.cost) {
                    gained = Some((best.normal.cost - lower.normal.cost) / best.normal.cost);
                    *best = lower;
                    damping = (damping / 5.0).max(1e-12);
                    break;
                }
                damping *= 6.0;
            }
            if gained.is_none_or(|part| part < LAST) {
                break;
            }
        }
    }

    /// The unknowns a step further.
    fn stepped(&self, from: &Refined, step: &Step, limits: &[(f64, f64)]) -> Refined {
        let mut shared = from.shared.clone();
        for ((value, step), &(low, high)) in shared.iter_mut().zip(&step.shared).zip(limits) {
            *value = (*value + step).clamp(low, high);
        }
        let mut slack = from.slack.clone();
        for (values, steps) in slack.iter_mut().zip(&step.blocks) {
            add_times(values, 1.0, steps);
        }
        let normal = self.normal(&shared, &slack);
        Refined { shared, slack, normal, held: from.held.clone() }
    }

    /// Calls `take` with each residual of the feet, and the window it is in.
    pub(super) fn each(
        &self,
        shared: &[f64],
        slack: Option<&[Vec<f64>]>,
        mut take: impl FnMut(&FittedFoot<'_>, usize, Option<usize>, &Row<'_>),
    ) {
        let unknowns = self.layout.unknowns(shared, &self.start);
        let at = At { layout: self.layout, shared, unknowns: &unknowns };
        let mut before = 0;
        for foot in &self.feet {
            let laws = foot.laws(&unknowns);
            for (number, window) in foot.windows.iter().enumerate().filter(|_| slack.is_some()) {
                let place = before + number;
                let own = slack.and_then(|all| all.get(place)).map(|own| (window, own.as_slice()));
                for frame in window.frames.clone() {
                    foot.rows(frame, &at, &laws, own, &mut |row| take(foot, frame, Some(place), row));
                }
            }
            if slack.is_none() || foot.windows.is_empty() {
                for frame in 0..foot.forces.frames() {
                    foot.rows(frame, &at, &laws, None, &mut |row| take(foot, frame, None, row));
                }
            }
            before += foot.windows.len();
        }
    }

    fn normal(&self, shared: &[f64], slack: &[Vec<f64>]) -> Normal {
        let size = self.layout.size;
        let mut normal = Normal::new(size);
        let windows = self.feet.iter().flat_map(|foot| &foot.windows);
        for (window, values) in windows.zip(slack) {
            let splines = window.splines();
            let mut block = Block::new(2 * splines, size);
            if let Some(slack_m) = self.slack_m {
                let frames_each = (window.frames.len() as f64 / splines as f64).sqrt();
                for (place, &value) in values.iter().enumerate() {
                    let usual = if place < splines { slack_m } else { PITCH_RAD_M * slack_m };
                    let weight = USUAL_BW * frames_each / usual;
                    normal.cost += (weight * value).powi(2);
                    if let Some(cell) = block.own.get_mut(place).and_then(|row| row.get_mut(place)) {
                        *cell += weight * weight;
                    }
                    add_times(&mut block.slope, weight * weight * value, &unit(place, 2 * splines));
                }
            }
            normal.blocks.push(block);
        }
        self.each(shared, Some(slack), |_, _, window, row| {
            normal.add_shared(row.value, row.shared);
            if let Some(block) = window.and_then(|place| normal.blocks.get_mut(place)) {
                block.add(row);
            }
        });
        for (value, slopes) in self.means(shared) {
            normal.add_shared(value, &slopes);
        }
        normal
    }

    /// The heights of a foot's spheres have no mean: that would be the height of the foot.
    fn means(&self, shared: &[f64]) -> Vec<(f64, Vec<f64>)> {
        let Some(first) = self.layout.heights else { return Vec::new() };
        let of = |foot: &FittedFoot<'_>| {
            let groups = foot.groups();
            let weight = NO_MEAN_BW_M / groups.len().max(1) as f64;
            let mut slopes = vec![0.0; self.layout.size];
            for group in groups {
                if let Some(slope) = slopes.get_mut(first + group) {
                    *slope += weight;
                }
            }
            (product(&slopes, shared), slopes)
        };
        self.feet.iter().map(of).collect()
    }
}

impl Refined {
    /// The sum of squares of all residuals.
    pub(in crate::fit) fn cost(&self) -> f64 {
        self.normal.cost
    }

    /// How each sphere moves in its body.
    pub(in crate::fit) fn moved(&self, layout: &Layout) -> Vec<MovedSphere> {
        let mut moved: Vec<MovedSphere> = Vec::new();
        for (&sphere, &group) in &layout.groups {
            let [down_m, ahead_m] = layout.moved_m(&self.shared, group);
            moved.push(MovedSphere { sphere, down_m, ahead_m });
        }
        moved.sort_by_key(|one| one.sphere);
        moved
    }
}

impl Block {
    /// Adds a residual.
    fn add(&mut self, row: &Row<'_>) {
        let splines = self.slope.len() / 2;
        let mut slopes = [0.0; 8];
        let mut places = [0_usize; 8];
        for (half, parts) in row.local.iter().enumerate() {
            for (spline, part) in parts.iter().enumerate() {
                let place = 4 * half + spline;
                if let Some((slope, target)) = slopes.get_mut(place).zip(places.get_mut(place)) {
                    (*slope, *target) = (*part, half * splines + row.first + spline);
                }
            }
        }
        for (&place, &slope) in places.iter().zip(&slopes).filter(|(_, slope)| **slope != 0.0) {
            if let Some(own) = self.own.get_mut(place) {
                for (&other, &part) in places.iter().zip(&slopes) {
                    if let Some(cell) = own.get_mut(other) {
                        *cell += slope * part;
                    }
                }
            }
            if let Some(shared) = self.with_shared.get_mut(place) {
                add_times(shared, slope, row.shared);
            }
            if let Some(sum) = self.slope.get_mut(place) {
                *sum += slope * row.value;
            }
        }
    }
}

fn unit(place: usize, size: usize) -> Vec<f64> {
    (0..size).map(|other| if other == place { 1.0 } else { 0.0 }).collect()
}

/// Which unknowns are at a bound and would go beyond it.
fn held(values: &[f64], limits: &[(f64, f64)], slope: &[f64]) -> Vec<bool> {
    let is_held = |((&value, &(low, high)), &slope): ((&f64, &(f64, f64)), &f64)| {
        (value <= low && slope > 0.0) || (value >= high && slope < 0.0)
    };
    values.iter().zip(limits).zip(slope).map(is_held).collect()
}
