//! The bones of a foot: which meshes they show, how large they are, where the next joint is.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use crate::model::{Anatomy, AnatomyJoint, Model};
use foldhash::{HashMap, HashMapExt};

use crate::compare::follow::bone_of_mesh;

/// How far a standard bone reaches along x of its body, m, at factor 1: `r_foot.vtp` and `r_bofoot.vtp` of OpenSim's Geometry,
/// their least and largest x.
const HEEL_M: f64 = -0.0098;
const FOOT_TIP_M: f64 = 0.183817;
const TOES_TIP_M: f64 = 0.076918;

/// Factors of OpenSim's own bones, from a mouse's to a giant's: 0.01 to 10. Millimetres are not among them.
const PLAUSIBLE: std::ops::RangeInclusive<f64> = 0.01..=10.0;
/// Words in names of bodies and meshes of a foot.
const FOOT_WORDS: [&str; 9] = ["foot", "calc", "toe", "talus", "tars", "pes", "phal", "hoof", "paw"];

/// What the bones of a model say, body by body.
pub(super) struct Bones {
    anatomy: Anatomy,
    /// Those with meshes, each looked at when somebody first asks.
    bodies: HashMap<String, OnceLock<Bone>>,
    /// For each body the next joint that is farthest from its origin, and the square of its distance, m².
    farthest: HashMap<String, (f64, usize)>,
}

/// What is known of one body.
struct Bone {
    size: Option<[f64; 3]>,
    is_foot: bool,
    /// From the heel to the tip of the standard foot.
    standard_foot: Option<[f64; 2]>,
}

impl Bones {
    /// `None` where the spheres on them cannot be read.
    pub(super) fn of(model: &Model) -> Option<&Self> {
        let mut spheres = model.spheres().iter();
        let are_read = spheres.all(|sphere| sphere.radius_m().is_ok() && model.rotation_of(sphere).is_ok());
        are_read.then(|| model.of_bodies(Self::read))
    }

    fn read(model: &Model) -> Self {
        let anatomy = Anatomy::bones_of(model);
        let mut farthest: HashMap<String, (f64, usize)> = HashMap::new();
        for (at, joint) in anatomy.joints.iter().enumerate() {
            let squared = joint.in_parent_m.iter().map(|along| along * along).sum::<f64>();
            let most = farthest.entry(joint.parent.clone()).or_insert((squared, at));
            if squared.total_cmp(&most.0).is_ge() {
                *most = (squared, at);
            }
        }
        let bodies = anatomy.meshes.keys().map(|body| (body.clone(), OnceLock::new())).collect();
        Self { anatomy, bodies, farthest }
    }

    fn bone(&self, body: &str) -> Option<&Bone> {
        let bone = self.bodies.get(body)?;
        Some(bone.get_or_init(|| Bone {
            size: size(&self.anatomy, body),
            is_foot: is_foot(&self.anatomy, body),
            standard_foot: standard_foot(&self.anatomy, body),
        }))
    }

    /// The factors of the meshes of `body`; `None` without meshes, or where these differ.
    pub(super) fn size(&self, body: &str) -> Option<[f64; 3]> {
        self.bone(body)?.size
    }

    /// The next joint of `body` that is farthest from its origin, and the square of that distance, m².
    pub(super) fn farthest_joint(&self, body: &str) -> Option<(f64, &AnatomyJoint)> {
        let (squared, at) = self.bodies.get(body).and_then(|_| self.farthest.get(body))?;
        Some((*squared, self.anatomy.joints.get(*at)?))
    }

    /// The joint by which `body` hangs on another one.
    pub(super) fn joint_above(&self, body: &str) -> Option<&AnatomyJoint> {
        self.anatomy.joint_above(body)
    }

    /// Whether `body` belongs to a foot, by its name or its meshes.
    pub(super) fn is_foot(&self, body: &str) -> bool {
        self.bone(body).is_some_and(|bone| bone.is_foot)
    }

    /// From the heel to the tip of the standard foot, if `body` is its hind part, along its x, m.
    pub(super) fn standard_foot(&self, body: &str) -> Option<[f64; 2]> {
        self.bone(body)?.standard_foot
    }
}

fn size(anatomy: &Anatomy, body: &str) -> Option<[f64; 3]> {
    let mut factors = anatomy.meshes.get(body)?.values().copied();
    let first = factors.next().filter(|factors| factors.iter().all(|factor| factor.is_finite()))?;
    factors.all(|other| same_size(other, first)).then_some(first)
}

fn is_foot(anatomy: &Anatomy, body: &str) -> bool {
    let names = anatomy.meshes.get(body).into_iter().flat_map(BTreeMap::keys).map(String::as_str);
    names.chain([body]).map(str::to_lowercase).any(|name| FOOT_WORDS.iter().any(|word| name.contains(word)))
}

fn shows(anatomy: &Anatomy, body: &str, bone: &str) -> Option<[f64; 3]> {
    let meshes = anatomy.meshes.get(body)?;
    // A file of another kind, or in another unit, is not that of OpenSim.
    let is_standard = |(file, [x, ..]): &(&String, &[f64; 3])| {
        file.to_lowercase().contains(".vtp") && bone_of_mesh(file) == bone && PLAUSIBLE.contains(x)
    };
    meshes.iter().find(is_standard).map(|(_, factors)| *factors)
}

fn standard_foot(anatomy: &Anatomy, body: &str) -> Option<[f64; 2]> {
    let [foot, ..] = shows(anatomy, body, "foot")?;
    let mut next = anatomy.joints_below(body);
    let toes = next.find_map(|joint| Some((joint, shows(anatomy, &joint.child, "bofoot")?)));
    let tip = match toes {
        Some((joint, [toes, ..])) => joint.in_parent_m[0] - joint.in_child_m[0] + toes * TOES_TIP_M,
        None => foot * FOOT_TIP_M,
    };
    Some([foot * HEEL_M, tip])
}

/// Sizes that differ by no more than this, relatively, are one: a millimetre on a human foot.
const SAME_SIZE: f64 = 0.005;

/// Whether a bone is as large as another one.
pub(super) fn same_size(a: [f64; 3], b: [f64; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= SAME_SIZE * b.abs())
}
