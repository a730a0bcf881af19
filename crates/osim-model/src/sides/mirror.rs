//! The mirror between two bodies: which axis of their frames changes its sign from one side to the other.

use std::collections::BTreeMap;

use super::bones::Bones;
use crate::model::Model;
use crate::side::{Side, without_side};

/// Frames of two bodies are mirror images where their joints and centres of mass are that close, as a part of the limb's longest bone.
const SURE: f64 = 0.05;
/// Up to here, the mirror of the other bodies is taken: the bones of some people differ that much, and centres of mass of some models are
/// not mirrored.
const LIKELY: f64 = 0.15;
/// Another mirror than z has to be that much closer: a body with all joints in one plane shows none.
const CLOSER: f64 = 0.5;

/// OpenSim's own models have z to the right on both sides, so z comes first; some models have another lateral axis, and some have a
/// left frame in which all three axes are reversed.
const MIRRORS: [[f64; 3]; 4] = [[1.0, 1.0, -1.0], [1.0, -1.0, 1.0], [-1.0, 1.0, 1.0], [-1.0, -1.0, -1.0]];

/// A body on the right and its counterpart on the left.
///
/// Places are compared in the frames of the two bodies, not in ground: the default pose of many models is a step, in which one foot
/// is ahead of the other, while the frames of a foot are the same in every pose.
#[derive(Debug, Clone)]
pub(crate) struct BodyPair<'m> {
    pub right: &'m str,
    pub left: &'m str,
    /// The signs that lead from the right frame to the left one; `None` where the frames are not mirror images.
    signs: Option<[f64; 3]>,
    /// Left over right.
    sizes: Option<[f64; 3]>,
    /// The longest bone of the limb, m.
    pub bone_m: Option<f64>,
}

impl BodyPair<'_> {
    /// Where a place on the right body belongs on the left one: as far from its origin, and as the sizes of the bones have it.
    pub(crate) fn images(&self, right_m: [f64; 3]) -> Option<[[f64; 3]; 2]> {
        let mirrored = times(self.signs?, right_m);
        Some([mirrored, times(self.sizes.unwrap_or([1.0; 3]), mirrored)])
    }

    /// The only axis that changes its sign (0, 1 or 2): in the frames of both bodies it leads sideways.
    pub(crate) fn reversed_axis(&self) -> Option<usize> {
        let signs = self.signs?;
        let mut reversed = (0..3).filter(|&axis| signs[axis] < 0.0);
        reversed.next().filter(|_| reversed.next().is_none())
    }

    /// How far a place on the left body is from the mirror image of one on the right body, m.
    pub(crate) fn apart_m(&self, right_m: [f64; 3], left_m: [f64; 3]) -> Option<f64> {
        nearest(self.images(right_m)?, left_m)
    }

    /// The axis that would have to change its sign on the left body for the places to be mirror images; `None` if none would
    /// bring them closer than `within_m`.
    pub(crate) fn other_sign(&self, right_m: [f64; 3], left_m: [f64; 3], within_m: f64) -> Option<char> {
        let images = self.images(right_m)?;
        let axis = (0..3).find(|&axis| {
            let mut other = left_m;
            other[axis] = -other[axis];
            nearest(images, other).is_some_and(|apart| apart <= within_m)
        })?;
        ['x', 'y', 'z'].get(axis).copied()
    }
}

fn nearest(images: [[f64; 3]; 2], place: [f64; 3]) -> Option<f64> {
    images.into_iter().map(|image| distance(image, place)).reduce(f64::min)
}

pub(crate) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

fn times(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|axis| a[axis] * b[axis])
}

/// The bodies of a model that have counterparts.
#[derive(Debug)]
pub(crate) struct BodyPairs {
    /// By the name without its side; in order, so that sums have the same last bit in each run.
    named: BTreeMap<String, [Option<String>; 2]>,
    /// By body: its centre of mass and its joints, with names without a side.
    marks: BTreeMap<String, BTreeMap<String, [f64; 3]>>,
    /// The mirror that fits most bodies.
    usual: [f64; 3],
}

impl BodyPairs {
    pub(crate) fn of(model: &Model) -> Self {
        let mut named: BTreeMap<String, [Option<String>; 2]> = BTreeMap::new();
        for body in model.bodies().iter().filter(|body| !body.fixed) {
            let Some(side) = Side::of_name(&body.name) else { continue };
            let [right, left] = named.entry(without_side(&body.name)).or_default();
            let own = if side == Side::Right { right } else { left };
            own.get_or_insert_with(|| body.name.clone());
        }
        let pairs = Self { named, marks: marks(model), usual: MIRRORS[0] };
        Self { usual: pairs.usual(), ..pairs }
    }

    /// The mirror in which the marks of all bodies together are closest.
    fn usual(&self) -> [f64; 3] {
        let bodies =
            || self.named.values().filter_map(|[right, left]| Some((right.as_ref()?, left.as_ref()?)));
        let apart_m = |signs: [f64; 3]| -> f64 {
            bodies()
                .flat_map(|(right, left)| self.both_marks(right, left))
                .map(|(r, l)| distance(times(signs, r), l))
                .sum()
        };
        let of_z = apart_m(MIRRORS[0]);
        let others = MIRRORS.into_iter().map(|signs| (apart_m(signs), signs));
        let best = others.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|(apart_m, _)| *apart_m < CLOSER * of_z);
        best.map_or(MIRRORS[0], |(_, signs)| signs)
    }

    /// The places of marks that both bodies have.
    fn both_marks<'b>(
        &'b self,
        right: &str,
        left: &str,
    ) -> impl Iterator<Item = ([f64; 3], [f64; 3])> + use<'b> {
        let both = self.marks.get(right).zip(self.marks.get(left));
        both.into_iter().flat_map(|(right, left)| {
            right.iter().filter_map(|(name, &right_m)| Some((right_m, *left.get(name)?)))
        })
    }

    /// Whether some body is on `side`.
    pub(crate) fn has(&self, side: Side) -> bool {
        self.named.values().any(|[right, left]| if side == Side::Right { right } else { left }.is_some())
    }

    /// The pair to which `body` belongs; `None` if it has no counterpart.
    pub(crate) fn pair(&self, body: &str, bones: &Bones<'_>) -> Option<BodyPair<'_>> {
        let [right, left] = self.named.get(&without_side(body))?;
        let (right, left) = (right.as_deref()?, left.as_deref()?);
        let bone_m =
            [right, left].into_iter().filter_map(|body| bones.longest_of_limb_m(body)).reduce(f64::max);
        let sizes = bones.ratios(left, right);
        let pair = BodyPair { right, left, signs: Some(self.usual), sizes, bone_m };
        Some(BodyPair { signs: bone_m.map_or(Some(self.usual), |bone_m| self.signs(&pair, bone_m)), ..pair })
    }

    /// The mirror in which the marks of the two bodies are close; `None` if there is none.
    fn signs(&self, pair: &BodyPair<'_>, bone_m: f64) -> Option<[f64; 3]> {
        let apart = |signs: [f64; 3]| {
            let pair = BodyPair { signs: Some(signs), ..pair.clone() };
            let marks = self.both_marks(pair.right, pair.left);
            marks.filter_map(|(right_m, left_m)| pair.apart_m(right_m, left_m)).fold(0.0, f64::max) / bone_m
        };
        if apart(self.usual) <= LIKELY {
            return Some(self.usual);
        }
        MIRRORS.into_iter().find(|&signs| apart(signs) <= SURE)
    }
}

/// Centres of mass and joints, by body.
fn marks(model: &Model) -> BTreeMap<String, BTreeMap<String, [f64; 3]>> {
    let components = model.components();
    let mut marks: BTreeMap<String, BTreeMap<String, [f64; 3]>> = BTreeMap::new();
    for (id, _) in components.tree.iter().filter(|(id, _)| components.tag(*id) == "Body") {
        if let Some(centre) = components.doc(id).triple(components.element(id), "mass_center") {
            marks.entry(components.name(id).into_owned()).or_default().insert(String::new(), centre);
        }
    }
    for joint in model.body_facts.joints.between_bodies(components) {
        let name = without_side(&joint.name);
        marks.entry(joint.parent.clone()).or_default().insert(format!("{name} below"), joint.in_parent_m);
        marks.entry(joint.child.clone()).or_default().insert(format!("{name} above"), joint.in_child_m);
    }
    marks
}
