//! How large the bones around a sphere are, and spheres that are larger.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

use foldhash::{HashMap, HashMapExt};

use crate::model::anatomy::joints::AnatomyJoint;
use crate::model::contacts::Sphere;
use crate::model::fault::NeedsAnswer;
use crate::model::side::Side;

/// Joints of one body whose distance from all others is looked at: more than a body has.
const OUTERMOST: usize = 32;
/// How many times as long as a sphere's radius bones are, if nothing else is known: a shank of 0.43 m, a radius of 0.032 m.
const BONES: f64 = 13.0;

/// How far apart the joints of each body are, from [`Model::joint_distances`](crate::model::Model::joint_distances): a measure of how large the bones around a sphere are.
#[derive(Debug, Clone, Default)]
pub struct JointDistances {
    /// The longest distance between two joints of one body, m: of the body of this name and of those that it is joined to.
    around_m: BTreeMap<String, f64>,
    /// The same, of the body alone.
    own_m: BTreeMap<String, f64>,
    /// The same, of the body and those above it on its limb.
    of_limb_m: HashMap<String, Option<f64>>,
    longest_of_all_m: Option<f64>,
}

impl JointDistances {
    /// The distances between these joints of bodies, such as [`Anatomy::joints`](crate::model::Anatomy::joints).
    #[must_use]
    pub fn of_joints(joints: &[AnatomyJoint]) -> Self {
        let mut neighbours: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        let mut places: BTreeMap<String, Vec<[f64; 3]>> = BTreeMap::new();
        for joint in joints {
            places.entry(joint.parent.clone()).or_default().push(joint.in_parent_m);
            places.entry(joint.child.clone()).or_default().push(joint.in_child_m);
            neighbours.entry(joint.parent.clone()).or_default().insert(joint.child.clone());
            neighbours.entry(joint.child.clone()).or_default().insert(joint.parent.clone());
        }
        let longest = |(body, places): (String, Vec<[f64; 3]>)| Some((body, longest_m(&places)?));
        let longest_m: BTreeMap<String, f64> = places.into_iter().filter_map(longest).collect();
        let around = |(body, next_to): (&String, &BTreeSet<String>)| {
            let near = next_to.iter().chain([body]).filter_map(|body| longest_m.get(body));
            Some((body.clone(), near.copied().reduce(f64::max)?))
        };
        Self {
            around_m: neighbours.iter().filter_map(around).collect(),
            of_limb_m: of_limbs(joints, &longest_m),
            longest_of_all_m: longest_m.values().copied().reduce(f64::max),
            own_m: longest_m,
        }
    }

    /// The longest distance between two joints of `body`; `None` if it has no two that are apart.
    #[must_use]
    pub fn of_body(&self, body: &str) -> Option<f64> {
        self.own_m.get(body).copied()
    }

    /// The longest bone of the limb: the longest distance between two joints of `body`, or of one above it up to where the limb
    /// leaves the trunk. `None` if none of these has two joints that are apart.
    #[must_use]
    pub fn of_limb(&self, body: &str) -> Option<f64> {
        self.of_limb_m.get(body).copied().flatten()
    }

    /// The longest distance between two joints of one body: of the body that carries `sphere` and of those that it is joined to.
    /// If none of these has two joints that are apart, all bodies count; `None` if no body has any.
    #[must_use]
    pub fn around(&self, sphere: &Sphere) -> Option<f64> {
        self.around_body(sphere.body.as_ref()?)
    }

    /// The same of a body.
    #[must_use]
    pub fn around_body(&self, body: &str) -> Option<f64> {
        self.around_m.get(body).copied().or(self.longest_of_all_m)
    }

    /// Whether `sphere` would be larger than the bones around it with this radius. `said` if the caller gave it as a length,
    /// which may be in another unit.
    #[must_use]
    pub fn radius_slip(&self, sphere: &Sphere, radius_m: f64, said: bool) -> Option<NeedsAnswer> {
        let longest_m = self.around(sphere)?;
        // A sphere that is new has the radius that the caller gave.
        let usual = if sphere.radius.number == radius_m { longest_m / BONES } else { sphere.radius.number };
        let said_for = said.then_some(usual);
        let sphere = sphere.name.clone();
        (radius_m > longest_m).then_some(NeedsAnswer::Radius { sphere, radius_m, longest_m, said_for })
    }
}

/// For each body that hangs on another one or carries one, the longest bone of its limb, each joint looked at once. A limb ends where
/// the names above it are not of its side.
fn of_limbs(joints: &[AnatomyJoint], own_m: &BTreeMap<String, f64>) -> HashMap<String, Option<f64>> {
    let mut above: HashMap<&str, &str> = HashMap::new();
    for joint in joints {
        above.entry(&joint.child).or_insert(&joint.parent);
    }
    let mut of_limb_m: HashMap<String, Option<f64>> = HashMap::new();
    for body in joints.iter().flat_map(|joint| [joint.child.as_str(), joint.parent.as_str()]) {
        let (mut way, mut at) = (Vec::new(), Some(body));
        while let Some(body) = at.filter(|&body| !of_limb_m.contains_key(body)) {
            // A loop of joints ends here, too.
            of_limb_m.insert(body.to_owned(), None);
            way.push(body);
            let side = Side::of_name(body);
            at = above.get(body).copied().filter(|up| side.is_none() || Side::of_name(up) == side);
        }
        let mut longest_m = at.and_then(|body| of_limb_m.get(body).copied().flatten());
        for body in way.into_iter().rev() {
            longest_m = [longest_m, own_m.get(body).copied()].into_iter().flatten().reduce(f64::max);
            of_limb_m.insert(body.to_owned(), longest_m);
        }
    }
    of_limb_m
}

/// The longest distance between two of `places`. Where very many are about equally far from their middle (joints on a circle), only
/// pairs with one of the [`OUTERMOST`] are looked at. What is found is then at least 0.57 (1/√3) of the longest: the outermost place is
/// as far out along some axis as 1/√3 of half the longest, and on the other side of the middle there is a place as far out.
fn longest_m(places: &[[f64; 3]]) -> Option<f64> {
    let mut places: Vec<[f64; 3]> =
        places.iter().copied().filter(|place| place.iter().all(|value| value.is_finite())).collect();
    places.sort_unstable_by(|a, b| {
        a.iter().zip(b).map(|(a, b)| a.total_cmp(b)).fold(Ordering::Equal, Ordering::then)
    });
    places.dedup();
    let middle = std::array::from_fn(|axis| {
        let along = || places.iter().map(|place| place[axis]);
        along().fold(f64::INFINITY, f64::min) / 2.0 + along().fold(f64::NEG_INFINITY, f64::max) / 2.0
    });
    // From the outermost one inwards: two places are no farther apart than both are from the middle together.
    let mut by_distance: Vec<(f64, [f64; 3])> =
        places.into_iter().map(|place| (distance_m(place, middle), place)).collect();
    by_distance.sort_unstable_by(|a, b| b.0.total_cmp(&a.0));
    let mut longest: Option<f64> = None;
    for (at, (far, a)) in by_distance.iter().enumerate().take(OUTERMOST) {
        for (near, b) in by_distance.iter().skip(at + 1) {
            // Far enough above rounding to lose no pair.
            if longest.is_some_and(|longest| (far + near) * (1.0 + 1e-9) < longest) {
                break;
            }
            let apart = distance_m(*a, *b);
            if apart.is_finite() && apart > 0.0 {
                longest = Some(longest.map_or(apart, |longest| longest.max(apart)));
            }
        }
        if longest.is_some_and(|longest| 2.0 * far * (1.0 + 1e-9) < longest) {
            break;
        }
    }
    longest
}

fn distance_m(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}
