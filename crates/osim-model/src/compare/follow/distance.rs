//! How far a joint is from the origin of a body, in two models.

use crate::model::{Anatomy, AnatomyJoint, JointDistances};
use foldhash::{HashMap, HashMapExt};

use super::body_factors::length;

/// A joint nearer to the body's origin than this does not show its size, m...
const SHORTEST_DISTANCE_M: f64 = 0.02;
/// ... unless it is at this part of the limb's longest bone, or farther: bones of a rat are that short.
const SHORTEST_OF_BONE: f64 = 0.2;

/// Where a joint below a body is in both models, seen from the origin of the body at the default pose.
#[derive(Debug)]
pub(super) struct Distance<'a> {
    pub(super) joint: &'a str,
    /// In the reference, m.
    pub(super) old_m: [f64; 3],
    new_m: [f64; 3],
}

/// The joints of one name in both models, by the bodies on which they are in one of them.
pub(super) struct Distances<'a> {
    scaled: &'a Anatomy,
    reference: &'a Anatomy,
    on_body: HashMap<&'a str, Vec<[&'a AnatomyJoint; 2]>>,
    /// How large the bones of both models are.
    bones: [JointDistances; 2],
}

impl<'a> Distances<'a> {
    pub(super) fn of(scaled: &'a Anatomy, reference: &'a Anatomy) -> Self {
        let mut on_body: HashMap<&str, Vec<[&AnatomyJoint; 2]>> = HashMap::new();
        for joint in &scaled.joints {
            let Some(there) = reference.joint(&joint.name) else { continue };
            on_body.entry(&joint.parent).or_default().push([joint, there]);
            if there.parent != joint.parent {
                on_body.entry(&there.parent).or_default().push([joint, there]);
            }
        }
        let bones = [reference, scaled].map(|anatomy| JointDistances::of_joints(&anatomy.joints));
        Self { scaled, reference, on_body, bones }
    }

    /// The farthest joint of one name in both models that lies below `body` and is on it in one of them.
    pub(super) fn farthest(&self, body: &str) -> Option<Distance<'a>> {
        let places = self.on_body.get(body).into_iter().flatten().filter_map(|[joint, there]| {
            let old_m = self.reference.place_below(body, there)?;
            let new_m = self.scaled.place_below(body, joint)?;
            Some(Distance { joint: &joint.name, old_m, new_m })
        });
        let [old_m, new_m] = self.bones.each_ref().map(|bones| shortest_m(bones, body));
        places
            .filter(|place| length(place.old_m) >= old_m && length(place.new_m) >= new_m)
            .max_by(|a, b| length(a.old_m).total_cmp(&length(b.old_m)))
    }
}

/// A joint of `body` that is nearer to its origin does not show its size, m.
fn shortest_m(bones: &JointDistances, body: &str) -> f64 {
    let longest_m = bones.of_limb(body).or_else(|| bones.around_body(body));
    longest_m.map_or(SHORTEST_DISTANCE_M, |longest_m| SHORTEST_DISTANCE_M.min(SHORTEST_OF_BONE * longest_m))
}

impl Distance<'_> {
    /// New over old.
    pub(super) fn ratio(&self) -> f64 {
        length(self.new_m) / length(self.old_m)
    }
}

#[cfg(test)]
mod tests {
    use crate::model::Model;

    use super::*;

    const HUMAN: &str = include_str!("../../../../../fixtures/feet/human_40000.osim");

    /// The human with all translations of joints multiplied.
    fn times(text: &str, factor: f64) -> String {
        let scaled = |part: &str| {
            let (numbers, rest) = part.split_once('<').unwrap();
            let number = |value: &str| (factor * value.parse::<f64>().unwrap()).to_string();
            format!("{}<{rest}", numbers.split(' ').map(number).collect::<Vec<_>>().join(" "))
        };
        let mut parts = text.split("<translation>");
        let first = parts.next().unwrap().to_owned();
        parts.fold(first, |text, part| format!("{text}<translation>{}", scaled(part)))
    }

    #[track_caller]
    fn assert_ratio(text: &str, expected: Option<f64>) {
        let [scaled, reference] =
            [text, HUMAN].map(|text| Anatomy::of(&Model::parse(text).unwrap()).unwrap());
        for (one, other, expected) in
            [(&scaled, &reference, expected), (&reference, &scaled, expected.map(f64::recip))]
        {
            let distances = Distances::of(one, other);
            let ratio = distances.farthest("calcn_r").map(|distance| distance.ratio());
            match (ratio, expected) {
                (Some(ratio), Some(expected)) => assert!((ratio / expected - 1.0).abs() < 1e-12, "{ratio}"),
                _ => assert_eq!(ratio, expected),
            }
        }
    }

    #[test]
    fn a_short_bone_of_a_small_animal_shows_its_size() {
        // The toes' joint is 178 mm from the calcaneus' origin, and the shank is 462 mm long.
        assert_ratio(&times(HUMAN, 0.1), Some(0.1));
        assert_ratio(&times(HUMAN, 0.01), Some(0.01));
    }

    #[test]
    fn a_joint_near_the_origin_of_a_long_limb_shows_nothing() {
        let near = HUMAN.replacen("<translation>0.17799999999999999 ", "<translation>0.0178 ", 1);
        assert_ne!(near, HUMAN);
        assert_ratio(&near, None);
    }
}
