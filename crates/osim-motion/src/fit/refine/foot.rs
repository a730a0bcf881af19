//! Residuals of one foot, frame by frame, with what they answer to.

use contact_scaling::Law;

use super::layout::Layout;
use super::window::{Basis, Window};
use crate::fit::answers::{Answer, Answers};
use crate::fit::data::{FitTrial, FootForces};
use crate::fit::problem::{Unknowns, with_dissipation};
use crate::stance::ON_BW;

/// Steps by which slopes of the law are taken: m, m/s and s/m.
const STEP: f64 = 1e-7;
/// What a sphere costs that is deeper than allowed by its radius, body weights.
const TOO_DEEP_BW: f64 = 200.0;

/// A foot of a trial.
pub(super) struct FittedFoot<'t> {
    pub(super) forces: &'t FootForces,
    answers: &'t Answers,
    weight_n: f64,
    /// Its trial among all.
    trial: usize,
    /// The group of the sphere of each contact.
    groups: Vec<usize>,
    pub(super) windows: Vec<Window>,
    /// What the residuals hold to, beside forces.
    goals: Goals,
}

/// What counts beside the force along the normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Goals {
    /// A centre of pressure that is this far off under a full body weight counts as an error of one body weight, m.
    pub(super) cop_m: Option<f64>,
    /// The largest x/R.
    pub(super) most_relative_indentation: Option<f64>,
}

/// All unknowns at one moment of the search.
pub(super) struct At<'a> {
    pub(super) layout: &'a Layout,
    pub(super) shared: &'a [f64],
    /// The first three of them.
    pub(super) unknowns: &'a Unknowns,
}

/// A residual, and what it answers to.
pub(super) struct Row<'a> {
    pub(super) value: f64,
    /// Its slope by each shared unknown.
    pub(super) shared: &'a [f64],
    /// The first spline, and the slopes by four coefficients of the height and of the pitch.
    pub(super) first: usize,
    pub(super) local: [[f64; 4]; 2],
}

/// A contact with its force and slopes, over body weight.
struct Pushing<'a> {
    answer: &'a Answer,
    group: usize,
    radius_m: f64,
    indentation_m: f64,
    /// Where it acts.
    along_m: [f64; 2],
    force: f64,
    /// By m and by m/s.
    by_indentation: f64,
    by_rate: f64,
    by_dissipation: f64,
}

impl<'t> FittedFoot<'t> {
    /// Those of a trial; a foot without answers is left out.
    pub(super) fn all(
        trial: &'t FitTrial,
        number: usize,
        layout: &Layout,
        goals: Goals,
        has_slack: bool,
    ) -> Vec<Self> {
        let of = |forces: &'t FootForces| {
            let answers = forces.answers.as_ref()?;
            let group = |sphere| layout.groups.get(sphere).copied().unwrap_or_default();
            let windows =
                if has_slack { Window::all(forces, &answers.time_s, trial.weight_n) } else { Vec::new() };
            Some(Self {
                forces,
                answers,
                weight_n: trial.weight_n,
                trial: number,
                groups: answers.spheres.iter().map(group).collect(),
                windows,
                goals,
            })
        };
        trial.feet.iter().filter_map(of).collect()
    }

    /// The laws with the dissipation as it is, and a little larger.
    pub(super) fn laws(&self, unknowns: &Unknowns) -> (Vec<Law>, Vec<Law>) {
        let more = unknowns.dissipation.map(|dissipation| dissipation + STEP);
        (with_dissipation(self.forces, unknowns.dissipation), with_dissipation(self.forces, more))
    }

    /// The splines of a frame with what they add to the foot's height (m, m/s) and pitch (rad, rad/s).
    fn slack(&self, frame: usize, window: Option<(&Window, &[f64])>) -> (Basis, [(f64, f64); 2]) {
        let Some((window, coefficients)) = window else { return Default::default() };
        let basis = window.basis(self.answers.time_s.get(frame).copied().unwrap_or_default());
        let (heights, pitches) = coefficients.split_at(window.splines().min(coefficients.len()));
        (basis, [basis.at(heights), basis.at(pitches)])
    }

    /// What a window adds to the foot's height (m) and pitch (rad).
    pub(super) fn slack_at(&self, frame: usize, window: &Window, coefficients: &[f64]) -> [f64; 2] {
        self.slack(frame, Some((window, coefficients))).1.map(|(value, _)| value)
    }

    /// Its trial among all.
    pub(super) fn trial(&self) -> usize {
        self.trial
    }

    /// The group of each contact.
    pub(super) fn groups(&self) -> &[usize] {
        &self.groups
    }

    /// Whether the plates measured a force in a frame.
    pub(super) fn has_force(&self, frame: usize) -> bool {
        self.forces.measured_n.get(frame).is_some_and(|&force_n| force_n > ON_BW * self.weight_n)
    }

    /// The largest x/R of a frame with a force.
    pub(super) fn deepest(&self, frame: usize, at: &At<'_>, window: Option<(&Window, &[f64])>) -> f64 {
        if !self.has_force(frame) {
            return f64::NEG_INFINITY;
        }
        let (_, slack) = self.slack(frame, window);
        let laws = (with_dissipation(self.forces, None), with_dissipation(self.forces, None));
        let depths = self.pushing(frame, at, &laws, slack).map(|one| one.indentation_m / one.radius_m);
        depths.fold(f64::NEG_INFINITY, f64::max)
    }

    fn pushing<'a>(
        &'a self,
        frame: usize,
        at: &'a At<'_>,
        laws: &'a (Vec<Law>, Vec<Law>),
        slack: [(f64, f64); 2],
    ) -> impl Iterator<Item = Pushing<'a>> {
        let up_m = at.unknowns.floor_up_m.get(self.trial).copied().unwrap_or_default();
        let scale = at.unknowns.stiffness_log.exp() / self.weight_n;
        let contacts = self.forces.frame(frame).iter().zip(self.answers.frame(frame));
        let laws = laws.0.iter().zip(&laws.1).zip(&self.forces.laws);
        contacts.zip(&self.groups).zip(laws).map(
            move |(((&(x_m, rate_m_s), answer), &group), ((law, more), &(_, radius_m)))| {
                let [down_m, ahead_m] = at.layout.moved_m(at.shared, group);
                let [(height_m, height_m_s), (pitch, pitch_s)] = slack;
                let (down, ahead) = (&answer.down, &answer.ahead);
                let x_m = x_m
                    + up_m
                    + down_m * down.indentation
                    + ahead_m * ahead.indentation
                    + height_m
                    + pitch * answer.lever_m;
                let rate_m_s = rate_m_s
                    + down_m * down.rate_s
                    + ahead_m * ahead.rate_s
                    + height_m_s
                    + pitch_s * answer.lever_m;
                let force = law.force(x_m, rate_m_s);
                let slope = |other: f64| scale * (other - force) / STEP;
                Pushing {
                    answer,
                    group,
                    radius_m,
                    indentation_m: x_m,
                    along_m: std::array::from_fn(|axis| {
                        answer.along_m[axis] + down_m * down.along[axis] + ahead_m * ahead.along[axis]
                    }),
                    force: scale * force,
                    by_indentation: slope(law.force(x_m + STEP, rate_m_s)),
                    by_rate: slope(law.force(x_m, rate_m_s + STEP)),
                    by_dissipation: slope(more.force(x_m, rate_m_s)),
                }
            },
        )
    }

    /// The residuals of a frame, body weights: the force; where the centre of pressure counts, the moment about the plates' one along both
    /// axes of the floor; and each sphere that is too deep.
    pub(super) fn rows(
        &self,
        frame: usize,
        at: &At<'_>,
        laws: &(Vec<Law>, Vec<Law>),
        window: Option<(&Window, &[f64])>,
        take: &mut impl FnMut(&Row<'_>),
    ) {
        let (basis, slack) = self.slack(frame, window);
        let pushing: Vec<Pushing<'_>> = self.pushing(frame, at, laws, slack).collect();
        let measured_n = self.forces.measured_n.get(frame).copied().unwrap_or_default();
        let mut slopes = vec![0.0; at.layout.size];
        let mut sum = Sum { foot: self, at, basis: &basis, slopes: &mut slopes };
        take(&sum.row(&pushing, -measured_n / self.weight_n, |_| (1.0, [0.0; 2])));
        let centre_m = self.answers.centre_m.get(frame).copied().flatten();
        if let Some((cop_m, centre_m)) = self.goals.cop_m.zip(centre_m) {
            for (axis, centre_m) in centre_m.into_iter().enumerate() {
                let lever = |one: &Pushing<'_>| {
                    let moved = [one.answer.down.along[axis], one.answer.ahead.along[axis]];
                    ((one.along_m[axis] - centre_m) / cop_m, moved.map(|part| part / cop_m))
                };
                take(&sum.row(&pushing, 0.0, lever));
            }
        }
        let Some(most) = self.goals.most_relative_indentation.filter(|_| self.has_force(frame)) else {
            return;
        };
        for one in &pushing {
            let over = one.indentation_m / one.radius_m - most;
            if over > 0.0 {
                take(&sum.too_deep(one, over));
            }
        }
    }
}

/// Adds what contacts do to one residual.
struct Sum<'a> {
    foot: &'a FittedFoot<'a>,
    at: &'a At<'a>,
    basis: &'a Basis,
    slopes: &'a mut Vec<f64>,
}

impl Sum<'_> {
    /// The sum of all forces, each with a lever of its own, and how that lever changes where its sphere goes down or ahead.
    fn row(
        &mut self,
        pushing: &[Pushing<'_>],
        start: f64,
        lever: impl Fn(&Pushing<'_>) -> (f64, [f64; 2]),
    ) -> Row<'_> {
        self.slopes.fill(0.0);
        let (mut value, mut local) = (start, [[0.0; 4]; 2]);
        for one in pushing {
            let (arm, arm_moves) = lever(one);
            value += arm * one.force;
            self.add(self.at.layout.stiffness, arm * one.force);
            self.add(self.at.layout.dissipation, arm * one.by_dissipation);
            self.depth(one, arm * one.by_indentation, arm * one.by_rate, &mut local);
            self.moved(one, [one.force * arm_moves[0], one.force * arm_moves[1]]);
        }
        Row { value, shared: self.slopes, first: self.basis.first, local }
    }

    fn too_deep(&mut self, one: &Pushing<'_>, over: f64) -> Row<'_> {
        self.slopes.fill(0.0);
        let mut local = [[0.0; 4]; 2];
        self.depth(one, TOO_DEEP_BW / one.radius_m, 0.0, &mut local);
        Row { value: TOO_DEEP_BW * over, shared: self.slopes, first: self.basis.first, local }
    }

    /// What follows from the depth of a contact and its rate.
    fn depth(&mut self, one: &Pushing<'_>, by_indentation: f64, by_rate: f64, local: &mut [[f64; 4]; 2]) {
        let layout = self.at.layout;
        self.add(layout.floor_of(self.foot.trial), by_indentation);
        let (down, ahead) = (&one.answer.down, &one.answer.ahead);
        self.moved(
            one,
            [
                by_indentation * down.indentation + by_rate * down.rate_s,
                by_indentation * ahead.indentation + by_rate * ahead.rate_s,
            ],
        );
        for (spline, (value, slope)) in self.basis.values.iter().zip(&self.basis.slopes).enumerate() {
            let slope = by_indentation * value + by_rate * slope;
            for (part, arm) in local.iter_mut().zip([1.0, one.answer.lever_m]) {
                if let Some(part) = part.get_mut(spline) {
                    *part += arm * slope;
                }
            }
        }
    }

    /// What follows from a sphere that goes down and ahead in its body.
    fn moved(&mut self, one: &Pushing<'_>, [down, ahead]: [f64; 2]) {
        let layout = self.at.layout;
        self.add(layout.common, down);
        self.add(layout.heights.map(|first| first + one.group), down);
        self.add(layout.places.map(|first| first + one.group), ahead);
    }

    fn add(&mut self, place: Option<usize>, part: f64) {
        if let Some(slope) = place.and_then(|place| self.slopes.get_mut(place)) {
            *slope += part;
        }
    }
}
