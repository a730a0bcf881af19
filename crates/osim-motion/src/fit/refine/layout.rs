//! Which unknown is where.

use std::collections::HashMap;

use osim_model::SphereId;

use crate::fit::data::FitTrial;
use crate::fit::problem::Unknowns;
use crate::fit::search::{FitBounds, MOST_DISSIPATION, STIFFNESS_FACTOR};

/// A sphere goes at most this part of its radius up or down from where it was,
const MOST_DOWN: f64 = 0.5;
/// and at most so many radii ahead or back.
const MOST_AHEAD: f64 = 1.0;
/// Floors and feet as a whole go at most this far, m.
const MOST_COMMON_M: f64 = 0.25;

/// Places of the unknowns that all trials share in one list; `None` for what is not fitted.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::fit) struct Layout {
    pub(in crate::fit) stiffness: Option<usize>,
    pub(in crate::fit) dissipation: Option<usize>,
    /// The height of the floor of the first trial that has one; those of the others follow.
    pub(in crate::fit) floor: Option<usize>,
    /// The first trial whose floor moves: where spheres move instead, the floor of the first trial stays.
    pub(in crate::fit) first_floor: usize,
    /// How far all spheres go down.
    pub(in crate::fit) common: Option<usize>,
    /// How far the first group of spheres goes down from the others; those of the other groups follow.
    pub(in crate::fit) heights: Option<usize>,
    /// The same ahead.
    pub(in crate::fit) places: Option<usize>,
    pub(super) size: usize,
    /// The group of each sphere: counterparts are one.
    pub(super) groups: HashMap<SphereId, usize>,
    /// The radius of the smallest sphere of each group, m.
    radius_m: Vec<f64>,
}

impl Layout {
    pub(in crate::fit) fn of(
        trials: &[FitTrial],
        bounds: &FitBounds,
        counterparts: &[(SphereId, SphereId)],
    ) -> Self {
        let mut size = 0;
        let mut take = |is_fitted: bool, count: usize| {
            let place = size;
            size += if is_fitted { count } else { 0 };
            is_fitted.then_some(place)
        };
        let (groups, radius_m) = groups(trials, counterparts);
        let wanted = bounds.wanted;
        let stiffness = take(wanted.stiffness, 1);
        let dissipation = take(wanted.dissipation, 1);
        let first_floor = usize::from(bounds.height_in_spheres);
        let floor = take(wanted.height && trials.len() > first_floor, trials.len() - first_floor);
        let common = take(wanted.height && bounds.height_in_spheres, 1);
        let heights = take(wanted.heights, radius_m.len());
        let places = take(wanted.places, radius_m.len());
        Self { stiffness, dissipation, floor, first_floor, common, heights, places, size, groups, radius_m }
    }

    /// The height of the floor of a trial.
    pub(in crate::fit) fn floor_of(&self, trial: usize) -> Option<usize> {
        Some(self.floor? + trial.checked_sub(self.first_floor)?)
    }

    /// All of them at their start.
    pub(super) fn start(&self, start: &Unknowns) -> Vec<f64> {
        let mut values = vec![0.0; self.size];
        let mut put = |place: Option<usize>, value: f64| {
            if let Some(value_there) = place.and_then(|place| values.get_mut(place)) {
                *value_there = value;
            }
        };
        put(self.stiffness, start.stiffness_log);
        put(self.dissipation, start.dissipation.unwrap_or_default());
        // A floor that goes up is feet that go down.
        let common_m = start.floor_up_m.first().copied().unwrap_or_default();
        put(self.common, common_m);
        let all_m = if self.common.is_some() { common_m } else { 0.0 };
        for (trial, &up_m) in start.floor_up_m.iter().enumerate() {
            put(self.floor_of(trial), up_m - all_m);
        }
        values
    }

    /// Between which values each is.
    pub(in crate::fit) fn limits(&self) -> Vec<(f64, f64)> {
        let mut limits = vec![(-MOST_COMMON_M, MOST_COMMON_M); self.size];
        let mut put = |place: Option<usize>, most: (f64, f64)| {
            if let Some(limit) = place.and_then(|place| limits.get_mut(place)) {
                *limit = most;
            }
        };
        let largest = STIFFNESS_FACTOR.ln();
        put(self.stiffness, (-largest, largest));
        put(self.dissipation, (0.0, MOST_DISSIPATION));
        for (group, radius_m) in self.radius_m.iter().enumerate() {
            let either = |part: f64| (-part * radius_m, part * radius_m);
            put(self.heights.map(|first| first + group), either(MOST_DOWN));
            put(self.places.map(|first| first + group), either(MOST_AHEAD));
        }
        limits
    }

    /// The value at a place; `kept` for an unknown that is not fitted.
    pub(super) fn value(values: &[f64], place: Option<usize>, kept: f64) -> f64 {
        place.and_then(|place| values.get(place)).copied().unwrap_or(kept)
    }

    /// The first three unknowns, as the search knows them.
    pub(super) fn unknowns(&self, values: &[f64], start: &Unknowns) -> Unknowns {
        // The floor of the first trial stays where the spheres move instead.
        let kept_m = |kept: f64| if self.common.is_some() { 0.0 } else { kept };
        let floor = |trial: usize, kept: f64| Self::value(values, self.floor_of(trial), kept_m(kept));
        Unknowns {
            stiffness_log: Self::value(values, self.stiffness, start.stiffness_log),
            dissipation: match self.dissipation {
                Some(_) => Some(Self::value(values, self.dissipation, 0.0)),
                None => start.dissipation,
            },
            floor_up_m: start
                .floor_up_m
                .iter()
                .enumerate()
                .map(|(trial, &kept)| floor(trial, kept))
                .collect(),
        }
    }

    /// How far a group of spheres goes down and ahead in its body, m.
    pub(super) fn moved_m(&self, values: &[f64], group: usize) -> [f64; 2] {
        let common = Self::value(values, self.common, 0.0);
        let own = |first: Option<usize>| Self::value(values, first.map(|first| first + group), 0.0);
        [common + own(self.heights), own(self.places)]
    }
}

/// The group of each sphere, and the smallest radius of each group.
fn groups(
    trials: &[FitTrial],
    counterparts: &[(SphereId, SphereId)],
) -> (HashMap<SphereId, usize>, Vec<f64>) {
    let (mut groups, mut radii): (HashMap<SphereId, usize>, Vec<f64>) = (HashMap::new(), Vec::new());
    for foot in trials.iter().flat_map(|trial| &trial.feet) {
        let spheres = foot.answers.iter().flat_map(|answers| &answers.spheres);
        for (&sphere, &(_, radius_m)) in spheres.zip(&foot.laws) {
            let counterpart = counterparts.iter().find_map(|&(one, other)| match sphere {
                _ if sphere == one => Some(other),
                _ if sphere == other => Some(one),
                _ => None,
            });
            let known = groups.get(&sphere).or(counterpart.and_then(|other| groups.get(&other))).copied();
            let group = known.unwrap_or(radii.len());
            if known.is_none() {
                radii.push(radius_m);
            }
            groups.insert(sphere, group);
            if let Some(least_m) = radii.get_mut(group) {
                *least_m = least_m.min(radius_m);
            }
        }
    }
    (groups, radii)
}
