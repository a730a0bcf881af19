//! The scale factors of one body, and their sources: distances between joints, and meshes of one bone in both models.

use std::cell::OnceCell;
use std::collections::BTreeMap;

use foldhash::{HashMap, HashMapExt};
use glam::DVec3;

use crate::messages::named;
use crate::model::{Anatomy, AnatomyJoint, BoneLengths, Fault};

/// The names of the axes of a body, for messages.
pub(super) const AXIS_NAMES: [&str; 3] = ["x", "y", "z"];

named! {
    /// The source of a scale factor. A source that is listed earlier is preferred.
    pub enum FactorSource {
        /// The caller gave the factor.
        Given = "given",
        /// The ScaleSet that the Scale Tool applied has the factor.
        ScaleFile = "scale file",
        /// The ratio of the `scale_factors` of two meshes of one bone, both attached to the body.
        Mesh = "mesh",
        /// The ratio of the translations of frames that are fixed to the body: offsets of joints.
        Joint = "joint offset",
        /// The ratio of the distances from the body's origin to a joint below the body. All three axes get this one factor. Only for two
        /// different models.
        Distance = "joint distance",
        /// The body takes the factors of its parent body.
        Above = "body above",
    }
}

/// The scale factor of a body along one axis, and its source.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisFactor {
    /// The new length over the old length.
    pub factor: f64,
    pub source: FactorSource,
}

/// The scale factors of one body along x, y and z, and the sources that they were chosen from.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyFactors {
    pub body: String,
    /// The chosen factors along x, y and z of the body; `None` for an axis without a source.
    pub axes: [Option<AxisFactor>; 3],
    /// The factors that each source gives along x, y and z, in the order of preference.
    pub sources: Vec<(FactorSource, [Option<f64>; 3])>,
    /// Why the factors are not known, or cannot be right: the error for a caller who needs them.
    pub why_unknown: Option<Fault>,
}

/// The index of each body by its name. Where several bodies have one name, the first counts.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct BodyIndex(HashMap<String, usize>);

impl BodyIndex {
    /// The index of each of `bodies`.
    pub(super) fn of(bodies: &[BodyFactors]) -> Self {
        let mut places = HashMap::new();
        for (at, factors) in bodies.iter().enumerate() {
            places.entry(factors.body.clone()).or_insert(at);
        }
        Self(places)
    }

    /// Index of `body` in the list of all bodies.
    pub(super) fn index_of(&self, body: &str) -> Option<usize> {
        self.0.get(body).copied()
    }

    pub(super) fn axes_of_body(&self, bodies: &[BodyFactors], body: &str) -> [Option<AxisFactor>; 3] {
        let found = self.index_of(body).and_then(|at| bodies.get(at));
        found.map(|factors| factors.axes).unwrap_or([None; 3])
    }
}

// How far a joint is from the origin of a body, in two models.

/// A joint that is nearer to the body's origin than this length, m, is not used to measure the size of the body. In a small animal,
/// [`SHORTEST_SHARE_OF_LONGEST_BONE`] allows a shorter distance.
const SHORTEST_JOINT_DISTANCE_M: f64 = 0.02;
/// A joint is far enough to measure the size of the body if its distance is this part of the longest bone of the limb: in a rat, bones are
/// shorter than [`SHORTEST_JOINT_DISTANCE_M`].
const SHORTEST_SHARE_OF_LONGEST_BONE: f64 = 0.2;

/// Offsets of one joint on one body, in the reference and in the scaled model.
#[derive(Clone, Copy)]
pub(super) struct SharedOffset<'a> {
    pub(super) joint: &'a str,
    pub(super) reference_m: DVec3,
    pub(super) scaled_m: DVec3,
}

impl SharedOffset<'_> {
    /// The distance to the joint in the scaled model over that in the reference.
    pub(super) fn ratio(&self) -> f64 {
        self.scaled_m.length() / self.reference_m.length()
    }
}

/// The joints that have the same name in both models, listed under the body that is the joint's parent in one of the models.
pub(super) struct ComparedJoints<'a> {
    scaled: &'a Anatomy,
    reference: &'a Anatomy,
    on_body: HashMap<&'a str, Vec<[&'a AnatomyJoint; 2]>>,
    /// The distances between joints in the reference and in the scaled model.
    bones: [BoneLengths; 2],
}

impl<'a> ComparedJoints<'a> {
    /// The joints of the same name in both models, with their places seen from their bodies.
    pub(super) fn of(scaled: &'a Anatomy, reference: &'a Anatomy) -> Self {
        let mut on_body: HashMap<&str, Vec<[&AnatomyJoint; 2]>> = HashMap::new();
        for joint in &scaled.joints {
            let Some(there) = reference.joint(&joint.name) else { continue };
            on_body.entry(&joint.parent).or_default().push([joint, there]);
            if there.parent != joint.parent {
                on_body.entry(&there.parent).or_default().push([joint, there]);
            }
        }
        let bones = [reference, scaled].map(|anatomy| BoneLengths::from_joints(&anatomy.joints));
        Self { scaled, reference, on_body, bones }
    }

    /// The farthest joint that lies below `body` in both models, at the default pose. Its parent is `body` in at least one of them.
    pub(super) fn farthest(&self, body: &str) -> Option<SharedOffset<'a>> {
        let places = self.on_body.get(body).into_iter().flatten().filter_map(|[joint, there]| {
            let reference_m = self.reference.joint_place_seen_from(body, there)?;
            let scaled_m = self.scaled.joint_place_seen_from(body, joint)?;
            Some(SharedOffset { joint: &joint.name, reference_m, scaled_m })
        });
        let [least_m, least_scaled_m] = self.bones.each_ref().map(|bones| shortest_m(bones, body));
        places
            .filter(|one| one.reference_m.length() >= least_m && one.scaled_m.length() >= least_scaled_m)
            .max_by(|a, b| a.reference_m.length().total_cmp(&b.reference_m.length()))
    }
}

/// The shortest distance, m, at which a joint measures the size of `body`.
fn shortest_m(bones: &BoneLengths, body: &str) -> f64 {
    let longest_m = bones.longest_in_limb(body).or_else(|| bones.longest_around_body(body));
    longest_m.map_or(SHORTEST_JOINT_DISTANCE_M, |longest_m| {
        SHORTEST_JOINT_DISTANCE_M.min(SHORTEST_SHARE_OF_LONGEST_BONE * longest_m)
    })
}

// Which mesh of one model shows the same bone as which of the other.

/// Marks of right and left at the beginning of a mesh file's name. They do not belong to the name of the bone.
const SIDE_PREFIXES: [&str; 2] = ["r_", "l_"];
/// Marks of right and left at the end of a mesh file's name, without its ending. They do not belong to the name of the bone.
const SIDE_SUFFIXES: [&str; 4] = ["_rv", "_lv", "_r", "_l"];

/// The meshes of one bone in two models, with the factor between their sizes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct BonePair {
    pub(super) mesh: String,
    /// Factors along x, y and z: those of the scaled model over those of the reference.
    pub(super) factors: [Option<f64>; 3],
}

/// The pairs of meshes of one bone that `body` has in both models, in the order of the file names.
pub(super) fn bone_pairs(scaled: &Anatomy, reference: &Anatomy, body: &str) -> Vec<BonePair> {
    let (Some(new), Some(old)) = (scaled.meshes.get(body), reference.meshes.get(body)) else {
        return Vec::new();
    };
    let bones = OnceCell::new();
    let pair = |(mesh, new): (&String, &[f64; 3])| {
        let same_bone = || bones.get_or_init(|| MeshFactorsByBone::of(old)).same_bone(mesh);
        let same_file = old.get(mesh);
        let old = same_file.or_else(same_bone)?;
        let factors = std::array::from_fn(|axis| {
            let ratio = (old[axis] != 0.0).then(|| new[axis] / old[axis])?;
            // A mirrored mesh of the other side may have a negative factor.
            Some(if same_file.is_some() { ratio } else { ratio.abs() })
        });
        Some(BonePair { mesh: mesh.clone(), factors })
    };
    new.iter().filter_map(pair).collect()
}

/// The factors of the meshes of one body, by the names of their bones. Where several meshes are of one bone, the first counts.
struct MeshFactorsByBone<'a> {
    by_bone: HashMap<String, &'a [f64; 3]>,
    by_side: HashMap<(String, Option<char>), &'a [f64; 3]>,
}

impl<'a> MeshFactorsByBone<'a> {
    /// Sorts the meshes of a body by their bones and sides.
    fn of(meshes: &'a BTreeMap<String, [f64; 3]>) -> Self {
        let mut bones = Self { by_bone: HashMap::new(), by_side: HashMap::new() };
        for (mesh, factors) in meshes {
            let bone = bone_of_mesh(mesh);
            bones.by_bone.entry(bone.clone()).or_insert(factors);
            bones.by_side.entry((bone, side_mark(mesh))).or_insert(factors);
        }
        bones
    }

    /// The factors of a mesh of the same bone as `mesh`. The best match is the same file, then a mesh of the same side, then its mirror
    /// image.
    fn same_bone(&self, mesh: &str) -> Option<&'a [f64; 3]> {
        let sided = (bone_of_mesh(mesh), side_mark(mesh));
        self.by_side.get(&sided).or_else(|| self.by_bone.get(&sided.0)).copied()
    }
}

/// The name of the bone of a mesh: the name of the file in small letters, without folder, ending and side mark.
///
/// ```
/// assert_eq!(osim_model::compare::bone_of_mesh("Geometry/R_Foot.VTP"), osim_model::compare::bone_of_mesh("foot_lv.obj"));
/// ```
pub fn bone_of_mesh(file: &str) -> String {
    let name = file_stem(file);
    let name = SIDE_PREFIXES.iter().find_map(|mark| name.strip_prefix(mark)).unwrap_or(&name);
    let name = SIDE_SUFFIXES.iter().find_map(|mark| name.strip_suffix(mark)).unwrap_or(name);
    name.to_owned()
}

/// The side mark of a file's name, `l` or `r`.
fn side_mark(file: &str) -> Option<char> {
    let name = file_stem(file);
    let before = SIDE_PREFIXES.iter().find(|mark| name.starts_with(**mark));
    let after = SIDE_SUFFIXES.iter().find(|mark| name.ends_with(**mark));
    before.or(after).and_then(|mark| mark.chars().find(|c| *c != '_'))
}

fn file_stem(file: &str) -> String {
    let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
    let name = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    name.to_lowercase()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Model;

    const HUMAN: &str = include_str!("../../../../../fixtures/feet/human_40000.osim");

    /// The human model with the translations of all joints multiplied by `factor`.
    fn with_offsets_times(text: &str, factor: f64) -> String {
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
            let distances = ComparedJoints::of(one, other);
            let ratio = distances.farthest("calcn_r").map(|distance| distance.ratio());
            match (ratio, expected) {
                (Some(ratio), Some(expected)) => assert!((ratio / expected - 1.0).abs() < 1e-12, "{ratio}"),
                _ => assert_eq!(ratio, expected),
            }
        }
    }

    #[test]
    fn a_short_bone_of_a_small_animal_is_measured() {
        // The toes' joint is 178 mm from the calcaneus' origin, and the shank is 462 mm long.
        assert_ratio(&with_offsets_times(HUMAN, 0.1), Some(0.1));
        assert_ratio(&with_offsets_times(HUMAN, 0.01), Some(0.01));
    }

    #[test]
    fn a_joint_near_the_origin_of_a_long_limb_is_not_measured() {
        let near = HUMAN.replacen("<translation>0.17799999999999999 ", "<translation>0.0178 ", 1);
        assert_ne!(near, HUMAN);
        assert_ratio(&near, None);
    }

    #[test]
    fn file_names_of_one_bone_give_one_name() {
        for name in [
            "foot.vtp",
            "r_foot.vtp",
            "l_foot.vtp",
            "foot_r.stl",
            "Geometry/R_Foot.VTP",
            "bones\\foot_lv.obj",
            "foot.vtp #2",
        ] {
            assert_eq!(bone_of_mesh(name), "foot", "{name}");
        }
        for name in ["bofoot.vtp", "footprint.vtp", "l_bofoot.vtp", "talus_rv.vtp"] {
            assert_ne!(bone_of_mesh(name), "foot", "{name}");
        }
        assert_eq!(
            (side_mark("r_foot.vtp"), side_mark("talus_lv.vtp"), side_mark("foot.vtp")),
            (Some('r'), Some('l'), None)
        );
    }
}
