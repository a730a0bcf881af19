//! Whether a model is a scaled copy of another model.

use foldhash::{HashMap, HashMapExt};

use super::body_factors::{AXIS_NAMES, BonePair, SharedOffset, bone_pairs};
use crate::messages::Phrase;
use crate::model::{Anatomy, AnatomyJoint};

/// Largest error of an offset of a joint, m, at which a scale factor still explains the offset.
const EXPLAINED_OFFSET_M: f64 = 1e-6;
/// Mesh factors that differ by more than this (relative) are different.
const SAME_MESH_FACTOR: f64 = 1e-6;
/// An offset of a joint that is shorter than this, m, gives no scale factor.
pub(super) const SHORTEST_OFFSET_M: f64 = 1e-6;

/// A difference which proves that a model is not a scaled copy of another model.
#[derive(Debug, Clone, PartialEq)]
pub enum CopyDifference {
    /// The reference has too few bodies for an answer: some factors always explain one joint.
    Fragment,
    /// A joint connects other bodies in the model than in the reference.
    Joint { joint: String, here: [String; 2], there: [String; 2] },
    /// No factor explains the offset of a joint along an axis, in its frame on the body.
    Offset { body: String, joint: String, axis: &'static str, here_m: f64, there_m: f64 },
    /// Two meshes of one body have different factors.
    Meshes { body: String, axis: &'static str },
}

impl CopyDifference {
    /// The difference as the beginning of a sentence.
    pub fn phrase(&self) -> Phrase {
        let text = match self {
            Self::Fragment => "the reference has some bodies only: ".to_owned(),
            Self::Joint { joint, here: [parent, child], there: [old_parent, old_child] } => format!(
                "joint {joint} is between {parent} and {child}, in the reference between {old_parent} and {old_child}: "
            ),
            Self::Offset { body, joint, axis, here_m, there_m } => format!(
                "joint {joint} is at {axis} = {here_m:.5} m on {body}, in the reference at {there_m:.5} m: "
            ),
            Self::Meshes { body, axis } => {
                format!("the meshes of {body} were not scaled along {axis} by one factor above 0: ")
            }
        };
        text.into()
    }
}

/// The first difference, in file order, that no factors of bodies explain; `None` if `scaled` is a scaled copy of `reference`.
pub(super) fn first_difference(scaled: &Anatomy, reference: &Anatomy) -> Option<CopyDifference> {
    if reference.is_fragment {
        return Some(CopyDifference::Fragment);
    }
    joint_of_other_bodies(scaled, reference).or_else(|| {
        let joints = SharedJoints::of(scaled, reference);
        let shared = scaled.bodies.iter().filter(|body| reference.has_body(body));
        shared.into_iter().find_map(|body| {
            let meshes = bone_pairs(scaled, reference, body);
            let joints = joints.on(body);
            (0..3).find_map(|axis| unexplained_offset(body, &meshes, joints, axis))
        })
    })
}

fn joint_of_other_bodies(scaled: &Anatomy, reference: &Anatomy) -> Option<CopyDifference> {
    let in_both = |body: &String| scaled.has_body(body) && reference.has_body(body);
    scaled.joints.iter().find_map(|joint| {
        let there = reference.joint(&joint.name)?;
        let shared = [joint, there].into_iter().any(|joint| in_both(&joint.parent) && in_both(&joint.child));
        let same = joint.parent == there.parent && joint.child == there.child;
        (shared && !same).then(|| CopyDifference::Joint {
            joint: joint.name.clone(),
            here: [joint.parent.clone(), joint.child.clone()],
            there: [there.parent.clone(), there.child.clone()],
        })
    })
}

/// The joints that connect the same bodies in both models, listed under each of these bodies.
pub(super) struct SharedJoints<'a>(HashMap<&'a str, Vec<SharedOffset<'a>>>);

impl<'a> SharedJoints<'a> {
    /// The joints that have the same name and bodies in both models.
    pub(super) fn of(scaled: &'a Anatomy, reference: &'a Anatomy) -> Self {
        let ends = |joint: &'a AnatomyJoint| [&joint.name, &joint.parent, &joint.child].map(String::as_str);
        let mut there: HashMap<[&str; 3], &AnatomyJoint> = HashMap::new();
        for joint in &reference.joints {
            there.entry(ends(joint)).or_insert(joint);
        }
        let mut shared: HashMap<&str, Vec<SharedOffset<'_>>> = HashMap::new();
        for joint in &scaled.joints {
            let Some(old) = there.get(&ends(joint)) else { continue };
            let offset = |reference_m, scaled_m| SharedOffset { joint: &joint.name, reference_m, scaled_m };

            shared.entry(joint.parent.as_str()).or_default().push(offset(old.in_parent_m, joint.in_parent_m));
            shared.entry(joint.child.as_str()).or_default().push(offset(old.in_child_m, joint.in_child_m));
        }
        Self(shared)
    }

    /// Offsets of the joints' frames on `body`, in file order.
    pub(super) fn on(&self, body: &str) -> &[SharedOffset<'a>] {
        self.0.get(body).map(Vec::as_slice).unwrap_or_default()
    }
}

fn unexplained_offset(
    body: &str,
    meshes: &[BonePair],
    joints: &[SharedOffset<'_>],
    axis: usize,
) -> Option<CopyDifference> {
    let meshes: Vec<f64> = meshes.iter().filter_map(|pair| pair.factors[axis]).collect();
    let offsets: Vec<(&str, f64, f64)> =
        joints.iter().map(|offset| (offset.joint, offset.reference_m[axis], offset.scaled_m[axis])).collect();
    let longest = offsets
        .iter()
        .filter(|(_, old, _)| old.abs() > SHORTEST_OFFSET_M)
        .max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    let factor = meshes.first().copied().or(longest.map(|(_, old, new)| new / old));
    let positive = |value: f64| value.is_finite() && value > 0.0;
    let same = |value: f64, factor: f64| (value - factor).abs() <= SAME_MESH_FACTOR * factor;
    if meshes.iter().any(|&value| !positive(value) || factor.is_some_and(|factor| !same(value, factor))) {
        return Some(CopyDifference::Meshes { body: body.to_owned(), axis: AXIS_NAMES[axis] });
    }
    // Without a factor, both offsets have to be next to nothing.
    let wrong = offsets.iter().find(|(_, old, new)| match factor {
        Some(factor) => !positive(factor) || (new - factor * old).abs() > EXPLAINED_OFFSET_M,
        None => new.abs() > EXPLAINED_OFFSET_M,
    });
    wrong.map(|(joint, old, new)| CopyDifference::Offset {
        body: body.to_owned(),
        joint: (*joint).to_owned(),
        axis: AXIS_NAMES[axis],
        here_m: *new,
        there_m: *old,
    })
}
