//! Whether a model is a scaled copy of another model; and the ScaleSet file that OpenSim's Scale Tool writes.

use std::collections::BTreeMap;

use foldhash::{HashMap, HashMapExt};
use glam::DVec3;

use super::body_factors::{AXIS_NAMES, BonePair, bone_pairs};
use crate::messages::Phrase;
use crate::model::{Anatomy, AnatomyJoint, Document, FactorQuestion, Fault, FaultKind, MissingFact};

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
            AXIS_NAMES
                .iter()
                .enumerate()
                .find_map(|(axis, name)| unexplained_offset(body, &meshes, joints, axis, name))
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

/// Offsets of one joint on one body, in the reference and in the scaled model.
#[derive(Clone, Copy)]
pub(super) struct SharedOffset<'a> {
    pub(super) joint: &'a str,
    pub(super) reference_m: DVec3,
    pub(super) scaled_m: DVec3,
}

/// The joints that connect the same bodies in both models, listed under each of these bodies.
pub(super) struct SharedJoints<'a>(HashMap<&'a str, Vec<SharedOffset<'a>>>);

impl<'a> SharedJoints<'a> {
    pub(super) fn of(scaled: &'a Anatomy, reference: &'a Anatomy) -> Self {
        let ends = |joint: &'a AnatomyJoint| [&joint.name, &joint.parent, &joint.child].map(String::as_str);
        let mut there: HashMap<[&str; 3], &AnatomyJoint> = HashMap::new();
        for joint in &reference.joints {
            there.entry(ends(joint)).or_insert(joint);
        }
        let mut shared = Self(HashMap::new());
        for joint in &scaled.joints {
            let Some(old) = there.get(&ends(joint)) else { continue };
            let offset = |reference_m, scaled_m| SharedOffset { joint: &joint.name, reference_m, scaled_m };
            shared.push(&joint.parent, offset(old.in_parent_m, joint.in_parent_m));
            shared.push(&joint.child, offset(old.in_child_m, joint.in_child_m));
        }
        shared
    }

    fn push(&mut self, body: &'a str, offset: SharedOffset<'a>) {
        self.0.entry(body).or_default().push(offset);
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
    name: &'static str,
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
        return Some(CopyDifference::Meshes { body: body.to_owned(), axis: name });
    }
    // Without a factor, both offsets have to be next to nothing.
    let wrong = offsets.iter().find(|(_, old, new)| match factor {
        Some(factor) => !positive(factor) || (new - factor * old).abs() > EXPLAINED_OFFSET_M,
        None => new.abs() > EXPLAINED_OFFSET_M,
    });
    wrong.map(|(joint, old, new)| CopyDifference::Offset {
        body: body.to_owned(),
        joint: (*joint).to_owned(),
        axis: name,
        here_m: *new,
        there_m: *old,
    })
}

// The file in which the Scale Tool says what it did.

/// If a joint is farther than this part of its distance from the place that the file's factors give, the file was applied to another model.
const LARGEST_JOINT_ERROR: f64 = 0.01;
/// Offsets may differ by this length, m, because numbers are rounded when they are written.
const SPELLING_DIFFERENCE_M: f64 = 1e-6;

/// The factors in the ScaleSet file that the Scale Tool wrote, by body name: see [`Factors`](crate::compare::follow::Factors) for an
/// example.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ScaleFile(BTreeMap<String, [f64; 3]>);

impl ScaleFile {
    /// The factors along x, y and z of each body from other data than a file.
    pub fn from_factors(factors: BTreeMap<String, [f64; 3]>) -> Self {
        Self(factors)
    }

    /// Reads the factors from `<ScaleSet>`: `<Scale><scales>sx sy sz</scales><segment>body</segment><apply>true</apply></Scale>`.
    ///
    /// # Errors
    /// The document is not a ScaleSet, a body's factors are not three numbers above 0, or two entries of one body differ.
    pub fn read(document: &Document) -> Result<Self, Fault> {
        Self::read_unlocated(document).map_err(|fault| fault.located(document.bytes()))
    }

    /// The scale factors of `body` along x, y and z.
    ///
    /// # Errors
    /// The file has no factors of this body.
    pub fn required_factors(&self, body: &str) -> Result<[f64; 3], Fault> {
        self.factors(body).ok_or_else(|| {
            Fault::refused(format!(
                "no factors of {body} are known, expected some for each body with spheres"
            ))
        })
    }

    fn read_unlocated(document: &Document) -> Result<Self, Fault> {
        let tree = document.tree();
        let root = document.data_root();
        if tree.name(root) != "ScaleSet" {
            let text = format!(
                "the document holds a <{}>, expected the <ScaleSet> that the Scale Tool writes (its output_scale_file)",
                tree.name(root)
            );
            return Err(Fault::at_span(FaultKind::Refused(text), tree.open_span(root)));
        }
        let mut factors: BTreeMap<String, [f64; 3]> = BTreeMap::new();
        let scales = tree.child(root, "objects").into_iter().flat_map(|objects| tree.children(objects));
        for scale in scales.filter(|&scale| tree.name(scale) == "Scale") {
            let Some(segment) =
                tree.child(scale, "segment").map(|segment| tree.text_of(segment).into_owned())
            else {
                continue;
            };
            let applied = document.flag(scale, "apply")?.unwrap_or(true);
            let values = if applied { document.triple(scale, "scales") } else { Some([1.0; 3]) };
            let Some(values) =
                values.filter(|values| values.iter().all(|value| *value > 0.0 && value.is_finite()))
            else {
                let text = format!("the scales of segment {segment} are not three numbers above 0");
                return Err(Fault::at_span(FaultKind::Refused(text), tree.span(scale)));
            };
            if factors.insert(segment.clone(), values).is_some_and(|other| other != values) {
                let text = format!("segment {segment} appears twice with different scales");
                return Err(Fault::at_span(FaultKind::Refused(text), tree.span(scale)));
            }
        }
        Ok(Self(factors))
    }

    pub(super) fn factors(&self, body: &str) -> Option<[f64; 3]> {
        self.0.get(body).copied()
    }

    /// Checks that the file's factors take the joints of `reference` to their places in `scaled`, on all bodies with spheres.
    ///
    /// # Errors
    /// A joint is somewhere else: the file belongs to another generic model.
    pub(super) fn refuse_other_reference(
        &self,
        scaled: &Anatomy,
        reference: &Anatomy,
        bodies: &[&str],
    ) -> Result<(), Fault> {
        let joints = SharedJoints::of(scaled, reference);
        for &body in bodies {
            let Some(factors) = self.factors(body) else { continue };
            for &SharedOffset { joint, reference_m: old, scaled_m: new } in joints.on(body) {
                let expected = old * DVec3::from(factors);
                let apart_m = new.distance(expected);
                if apart_m > SPELLING_DIFFERENCE_M + LARGEST_JOINT_ERROR * expected.length() {
                    let (body, joint) = (body.to_owned(), joint.to_owned());
                    let question = FactorQuestion::OtherReference { body, joint, apart_m };
                    return Err(Fault::new(MissingFact::Factors(question)));
                }
            }
        }
        Ok(())
    }
}
