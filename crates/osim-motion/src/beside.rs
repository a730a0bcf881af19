//! Feet that stand beside the plates.

use osim_model::feet::dot;

use crate::feet::Foot;
use crate::percentile::percentile;
use crate::stance::{OFF_BW, ON_BW};
use crate::states::{ContactState, ContactStates};
use crate::wrench::Wrench;

/// A foot that moves up or down faster than this does not stand, m/s.
const STILL_M_S: f64 = 0.2;
/// A plate with more than this part of body weight has a foot on it.
const LOADED_BW: f64 = 0.5;
/// A foot on a plate is lower than in this part of the frames in which it stands there.
const LEAST_PART: f64 = 0.05;

/// In which frames `foot` stands beside the plates: it comes as low as in half of the frames on a plate and as still, but without a force.
/// Frames before and after belong to it while the foot is as low as on plates. What it stands on then is not known.
pub(crate) fn beside(
    states: &ContactStates,
    foot: &Foot,
    plates: &[Option<Wrench>],
    weight_n: f64,
) -> Vec<bool> {
    let seen: Vec<Option<(f64, &ContactState)>> = plates
        .iter()
        .enumerate()
        .map(|(frame, plate)| {
            let deepest = deepest(states, foot, frame)?;
            Some((dot(plate.as_ref()?.force_n, deepest.normal), deepest))
        })
        .collect();
    let depth_m = |least_bw: f64, part: f64| {
        let loaded = seen.iter().flatten().filter(|(force_n, _)| *force_n > least_bw * weight_n);
        percentile(&loaded.map(|(_, state)| state.indentation_m).collect::<Vec<f64>>(), part)
    };
    let usual_m = depth_m(LOADED_BW, 0.5).unwrap_or(f64::INFINITY);
    let least_m = depth_m(ON_BW, LEAST_PART).unwrap_or(f64::INFINITY);
    let is_low = |one: &Option<(f64, &ContactState)>| {
        one.as_ref()
            .is_some_and(|(force_n, state)| *force_n < OFF_BW * weight_n && state.indentation_m >= least_m)
    };
    let stands = |one: &Option<(f64, &ContactState)>| {
        one.as_ref()
            .is_some_and(|(_, state)| state.indentation_m >= usual_m && state.rate_m_s.abs() < STILL_M_S)
    };
    let mut found = Vec::with_capacity(seen.len());
    for run in seen.chunk_by(|before, after| is_low(before) == is_low(after)) {
        let is_beside = run.first().is_some_and(is_low) && run.iter().any(stands);
        found.extend(std::iter::repeat_n(is_beside, run.len()));
    }
    found
}

fn deepest<'s>(states: &'s ContactStates, foot: &Foot, frame: usize) -> Option<&'s ContactState> {
    let own = foot.pairs.iter().filter_map(|&pair| states.frame(frame).get(pair));
    own.max_by(|a, b| a.indentation_m.total_cmp(&b.indentation_m))
}
