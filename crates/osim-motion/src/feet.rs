//! The contacts of each foot, and its stances: the times in which it is on the ground.

use std::ops::RangeInclusive;

use osim_model::{DVec3, ForceId, Limb, Model, Side};

use crate::pair::ContactPair;
use crate::plate_comparison::percentile;
use crate::states::{ContactState, ContactStates};

/// A foot and its contacts.
#[derive(Debug, Clone, PartialEq)]
pub struct Foot {
    /// `right foot`, `left foot`, or the name of the limb's first body.
    pub name: String,
    pub side: Option<Side>,
    /// Indices of the contact pairs of the foot in [`ContactStates`].
    pub pairs: Vec<usize>,
    pub bodies: Vec<String>,
}

impl Foot {
    /// The normal of the floor under the foot, and a point of this floor, m.
    pub(crate) fn floor(&self, states: &ContactStates) -> Option<(DVec3, DVec3)> {
        let &pair = self.pairs.first()?;
        let state = states.frame(0).get(pair)?;
        Some((state.normal, state.on_surface_m(states.pairs.get(pair)?.radius_m)))
    }

    /// The feet of `model`, one for each limb with applied `forces`; if limbs are not known, one for each side in the names
    /// of the spheres' bodies.
    pub fn all(model: &Model, states: &ContactStates, forces: &[ForceId]) -> Vec<Self> {
        let limbs = model.limbs(forces);
        let groups: Vec<(String, Option<Side>, Vec<usize>)> = match limbs.if_known() {
            Some(limbs) => {
                let group = |limb: &Limb| {
                    let pairs = pairs_with_ground(states, |pair| limb.spheres.contains(&pair.sphere));
                    (limb.name.clone(), Some(limb.side), pairs)
                };
                limbs.iter().map(group).collect()
            }
            None => {
                let names =
                    [("right", Some(Side::Right)), ("left", Some(Side::Left)), ("all contacts", None)];
                let group = |(name, side): (&str, Option<Side>)| {
                    let pairs = pairs_with_ground(states, |pair| Side::of_name(&pair.body) == side);
                    (name.to_owned(), side, pairs)
                };
                names.map(group).into()
            }
        };
        let count = |side: Side| groups.iter().filter(|(_, other, _)| *other == Some(side)).count();
        let [right, left] = [Side::Right, Side::Left].map(count);
        let has_several = |side: Side| (if side == Side::Right { right } else { left }) > 1;
        groups
            .iter()
            .filter(|(_, _, pairs)| !pairs.is_empty())
            .map(|(name, side, pairs)| Self {
                name: match side {
                    Some(side) if !has_several(*side) => format!("{} foot", side.as_str()),
                    _ => name.clone(),
                },
                side: *side,
                bodies: bodies_of_pairs(states, pairs),
                pairs: pairs.clone(),
            })
            .collect()
    }

    /// The median distance along the floor from centres of pressure in each frame to the foot, m.
    pub(crate) fn pressure_distance_m(
        &self,
        states: &ContactStates,
        normal: DVec3,
        point_m: impl Fn(usize) -> Option<DVec3>,
    ) -> Option<f64> {
        let in_frame = |frame: usize| {
            let spheres: Vec<DVec3> = self.contacts(states, frame).map(|state| state.centre_m).collect();
            Some(level_distance_m(point_m(frame)?, &spheres, normal))
        };
        percentile(&(0..states.frames()).filter_map(in_frame).collect::<Vec<f64>>(), 0.5)
    }

    /// The states of the foot's contacts in one frame.
    pub(crate) fn contacts<'s>(
        &self,
        states: &'s ContactStates,
        frame: usize,
    ) -> impl Iterator<Item = &'s ContactState> {
        self.pairs.iter().filter_map(move |&pair| states.frame(frame).get(pair))
    }

    /// The contact of the foot with the largest indentation in one frame.
    pub(crate) fn deepest<'s>(&self, states: &'s ContactStates, frame: usize) -> Option<&'s ContactState> {
        self.contacts(states, frame).max_by(|a, b| a.indentation_m.total_cmp(&b.indentation_m))
    }
}

/// The distance along the floor from a point to the segment between the two spheres that are farthest apart.
fn level_distance_m(point_m: DVec3, spheres: &[DVec3], normal: DVec3) -> f64 {
    let level = |vector: DVec3| vector - normal * vector.dot(normal);
    let all = || spheres.iter().flat_map(|one| spheres.iter().map(move |other| (*one, *other)));
    let length = |(one, other): &(DVec3, DVec3)| level(*other - *one).length();
    let Some((from, to)) = all().max_by(|a, b| length(a).total_cmp(&length(b))) else { return f64::NAN };
    let (along, away) = (level(to - from), level(point_m - from));
    let part = (away.dot(along) / along.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    (away - part * along).length()
}

/// Indices of the contact pairs through which the ground pushes spheres, among those that are wanted.
fn pairs_with_ground(states: &ContactStates, is_wanted: impl Fn(&ContactPair) -> bool) -> Vec<usize> {
    let all = states.pairs.iter().enumerate();
    all.filter(|(_, pair)| pair.applies && pair.is_ground && is_wanted(pair))
        .map(|(index, _)| index)
        .collect()
}

/// The bodies that carry the spheres of these contact pairs, each once.
fn bodies_of_pairs(states: &ContactStates, pairs: &[usize]) -> Vec<String> {
    let mut bodies: Vec<String> = Vec::new();
    for pair in pairs.iter().filter_map(|&index| states.pairs.get(index)) {
        if !bodies.contains(&pair.body) {
            bodies.push(pair.body.clone());
        }
    }
    bodies
}

/// A stance begins when the force along the normal rises above this share of body weight.
pub const TOUCH_DOWN_BW: f64 = 0.05;
/// A stance ends when the force along the normal falls below this share of body weight.
pub(crate) const LIFT_OFF_BW: f64 = 0.03;

/// The frames of one stance: a foot is on the ground in all of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StancePhase {
    pub first: usize,
    pub last: usize,
    /// Time at which the foot touches down, s; `None` if the recording begins during the stance, or if the force before it is
    /// not known.
    pub on_s: Option<f64>,
    /// Time at which the foot lifts off, s; `None` if the recording ends during the stance, or if the force after it is not
    /// known.
    pub off_s: Option<f64>,
}

impl StancePhase {
    /// The stances of a foot by its force along the normal, N; their times are interpolated between frames. A force of NaN is
    /// unknown, and its frame belongs to no stance.
    pub fn all(time_s: &[f64], force_n: &[f64], weight_n: f64) -> Vec<Self> {
        let (on, off) = (TOUCH_DOWN_BW * weight_n, LIFT_OFF_BW * weight_n);
        let mut stances: Vec<Self> = Vec::new();
        let mut open: Option<Self> = None;
        for (frame, &force) in force_n.iter().enumerate() {
            let crossed = |level: f64| crossing_time(time_s, force_n, frame, level);
            match &mut open {
                None if force > on => {
                    open = Some(Self { first: frame, last: frame, on_s: crossed(on), off_s: None });
                }
                Some(stance) if force >= off => stance.last = frame,
                Some(stance) => {
                    stances.push(Self { off_s: crossed(off), ..*stance });
                    open = None;
                }
                None => {}
            }
        }
        stances.extend(open);
        stances
    }

    /// Duration of the stance, s; `None` if its begin or its end is not known.
    pub fn duration_s(&self) -> Option<f64> {
        Some(self.off_s? - self.on_s?)
    }

    /// The frames of the stance.
    pub const fn frames(&self) -> RangeInclusive<usize> {
        self.first..=self.last
    }
}

/// The time between `frame` and the frame before at which a value passes `level`; `None` if one of the two values is not known.
fn crossing_time(time_s: &[f64], values: &[f64], frame: usize, level: f64) -> Option<f64> {
    let before = frame.checked_sub(1)?;
    let (t0, t1) = (*time_s.get(before)?, *time_s.get(frame)?);
    let (v0, v1) = (*values.get(before)?, *values.get(frame)?);
    let part = (level - v0) / (v1 - v0);
    part.is_finite().then(|| t0 + part.clamp(0.0, 1.0) * (t1 - t0))
}

/// Begin and end of each whole stride, s: from one touch-down of a foot to its next.
pub fn strides(stances: &[StancePhase]) -> Vec<(f64, f64)> {
    let on: Vec<f64> = stances.iter().filter_map(|stance| stance.on_s).collect();
    on.windows(2).filter_map(|pair| Some((*pair.first()?, *pair.get(1)?))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stance_begins_and_ends_between_frames() {
        // Body weight 100 N: on at 5 N, off at 3 N.
        let times: Vec<f64> = (0..10).map(f64::from).collect();
        let force = [0.0, 0.0, 10.0, 90.0, 4.0, 3.5, 1.5, 4.9, 6.9, 80.0];
        let stances = StancePhase::all(&times, &force, 100.0);
        assert_eq!(stances.len(), 2);
        // 5 of 10 N between frames 1 and 2; 4 N does not end it; 3 N is a quarter of the way from 3.5 to 1.5.
        assert_eq!((stances[0].first, stances[0].last), (2, 5));
        assert_eq!((stances[0].on_s, stances[0].off_s), (Some(1.5), Some(5.25)));
        assert_eq!(stances[0].duration_s(), Some(3.75));
        // 4.9 N does not begin one; the end is not seen.
        assert_eq!((stances[1].first, stances[1].last, stances[1].off_s), (8, 9, None));
        assert_eq!(strides(&stances), [(1.5, stances[1].on_s.unwrap())]);
        assert_eq!(stances[0].frames(), 2..=5);
    }

    #[test]
    fn a_recording_may_begin_on_the_ground_and_plates_may_end_there() {
        let stances = StancePhase::all(&[0.0, 1.0], &[50.0, f64::NAN], 100.0);
        assert_eq!((stances[0].on_s, stances[0].last, stances[0].off_s), (None, 0, None));
        let stances = StancePhase::all(&[0.0, 1.0, 2.0], &[f64::NAN, 50.0, 0.0], 100.0);
        assert_eq!((stances[0].first, stances[0].on_s), (1, None));
    }

    #[test]
    fn distances_are_level_and_to_the_segment() {
        let spheres = [DVec3::ZERO, DVec3::new(0.2, 0.3, 0.0), DVec3::new(0.1, 0.0, 0.0)];
        assert_eq!(level_distance_m(DVec3::new(0.1, 9.0, 0.05), &spheres, DVec3::Y), 0.05);
        assert!((level_distance_m(DVec3::new(0.5, 0.0, 0.4), &spheres, DVec3::Y) - 0.5).abs() < 1e-12);
    }
}
