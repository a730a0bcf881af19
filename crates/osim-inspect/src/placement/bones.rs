//! The bones of a foot: which meshes they show, how large they are, where the next joint is.

use std::collections::BTreeMap;

use osim_model::{Anatomy, AnatomyJoint, Model};
use osim_patch::bone_of_mesh;

/// How far a standard bone reaches along x of its body, m, at factor 1: `r_foot.vtp` and `r_bofoot.vtp` of OpenSim's Geometry,
/// their least and largest x.
const HEEL_M: f64 = -0.0098;
const FOOT_TIP_M: f64 = 0.183817;
const TOES_TIP_M: f64 = 0.076918;

/// Factors of OpenSim's own bones, from a mouse's to a giant's: 0.01 to 10. Millimetres are not among them.
const PLAUSIBLE: std::ops::RangeInclusive<f64> = 0.01..=10.0;
/// Words in names of bodies and meshes of a foot.
const FOOT_WORDS: [&str; 9] = ["foot", "calc", "toe", "talus", "tars", "pes", "phal", "hoof", "paw"];

/// What the bones of a model say.
pub(super) struct Bones {
    meshes: BTreeMap<String, BTreeMap<String, [f64; 3]>>,
    joints: Vec<AnatomyJoint>,
}

impl Bones {
    /// `None` where the anatomy cannot be read.
    pub(super) fn of(model: &Model) -> Option<Self> {
        let Anatomy { meshes, joints, .. } = Anatomy::of(model).ok()?;
        Some(Self { meshes, joints })
    }

    /// The factors of the meshes of `body`; `None` without meshes, or where these differ.
    pub(super) fn size(&self, body: &str) -> Option<[f64; 3]> {
        let mut factors = self.meshes.get(body)?.values().copied();
        let first = factors.next().filter(|factors| factors.iter().all(|factor| factor.is_finite()))?;
        factors.all(|other| same_size(other, first)).then_some(first)
    }

    /// The next joints of `body`.
    pub(super) fn next_joints<'b>(&'b self, body: &'b str) -> impl Iterator<Item = &'b AnatomyJoint> {
        self.joints.iter().filter(move |joint| joint.parent == body)
    }

    /// The joint by which `body` hangs on another one.
    pub(super) fn joint_above(&self, body: &str) -> Option<&AnatomyJoint> {
        self.joints.iter().find(|joint| joint.child == body)
    }

    /// Whether `body` belongs to a foot, by its name or its meshes.
    pub(super) fn is_foot(&self, body: &str) -> bool {
        let names = self.meshes.get(body).into_iter().flat_map(BTreeMap::keys).map(String::as_str);
        names
            .chain([body])
            .map(str::to_lowercase)
            .any(|name| FOOT_WORDS.iter().any(|word| name.contains(word)))
    }

    fn shows(&self, body: &str, bone: &str) -> Option<[f64; 3]> {
        let meshes = self.meshes.get(body)?;
        // A file of another kind, or in another unit, is not that of OpenSim.
        let is_standard = |(file, [x, ..]): &(&String, &[f64; 3])| {
            file.to_lowercase().contains(".vtp") && bone_of_mesh(file) == bone && PLAUSIBLE.contains(x)
        };
        meshes.iter().find(is_standard).map(|(_, factors)| *factors)
    }

    /// From the heel to the tip of the standard foot of which `body` is the hind part, along its x, m.
    pub(super) fn standard_foot(&self, body: &str) -> Option<[f64; 2]> {
        let [foot, ..] = self.shows(body, "foot")?;
        let toes =
            self.next_joints(body).find_map(|joint| Some((joint, self.shows(&joint.child, "bofoot")?)));
        let tip = match toes {
            Some((joint, [toes, ..])) => joint.in_parent_m[0] - joint.in_child_m[0] + toes * TOES_TIP_M,
            None => foot * FOOT_TIP_M,
        };
        Some([foot * HEEL_M, tip])
    }
}

/// Sizes that differ by no more than this, relatively, are one: a millimetre on a human foot.
const SAME_SIZE: f64 = 0.005;

/// Whether a bone is as large as another one.
pub(super) fn same_size(a: [f64; 3], b: [f64; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= SAME_SIZE * b.abs())
}
