//! The bones of the bodies of a model: their sizes by their meshes, their next joints, and which of them are parts of a foot.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use std::sync::OnceLock;

use foldhash::{HashMap, HashSet};
use osim_model::compare::bone_of_mesh;
use osim_model::opensim_text::list_words;
use osim_model::{Anatomy, AnatomyJoint, ComponentId, Components, DVec3, ElementId, Model, has_word};

/// The heel of OpenSim's foot: the least x of `r_foot.vtp` in OpenSim's Geometry at factor 1, m.
const HEEL_OF_OPENSIM_FOOT_X_M: f64 = -0.0098;
/// The front end of OpenSim's foot without toes: the largest x of `r_foot.vtp` in OpenSim's Geometry at factor 1, m.
const TIP_OF_OPENSIM_FOOT_X_M: f64 = 0.183817;
/// The tip of OpenSim's toes: the largest x of `r_bofoot.vtp` in OpenSim's Geometry at factor 1, m.
const TIP_OF_OPENSIM_TOES_X_M: f64 = 0.076918;
/// The height of the ankle over the sole of OpenSim's foot at factor 1, m: 0.04195 over the origin of the calcaneus, and the least y of
/// `r_foot.vtp`, -0.009839.
const ANKLE_TO_SOLE_OF_OPENSIM_FOOT_M: f64 = 0.051789;
/// Half the extent of `r_foot.vtp` along z at factor 1, m: from -0.039235 to 0.045631.
const HALF_WIDTH_OF_OPENSIM_FOOT_M: f64 = 0.042433;
/// Place of the toe joint on the x axis of the foot in OpenSim's models, at factor 1, m.
const TOES_BEGIN_X_M: f64 = 0.1788;

/// Factors that OpenSim's bones can have, from a mouse to a giant. The factor 0.001 of meshes in millimetres is not among them.
const PLAUSIBLE_FACTORS: RangeInclusive<f64> = 0.01..=10.0;
/// Words in the names of bodies and meshes that belong to a foot.
const FOOT_WORDS: [&str; 9] = ["foot", "calc", "toe", "talus", "tars", "pes", "phal", "hoof", "paw"];

/// The bones of the bodies of a model.
pub(crate) struct BodyBones {
    anatomy: Anatomy,
    /// The bone of each body that has meshes. A bone is computed at its first use.
    bodies: HashMap<String, OnceLock<BodyBone>>,
    /// The bodies on which the mesh of OpenSim's foot is elsewhere than in OpenSim's models.
    moved: HashSet<String>,
}

/// The size of the bone of one body, and its part in a foot, from the name, the meshes and the joints of the body.
struct BodyBone {
    /// The scale factors of the meshes; `None` without meshes, or if the factors of the meshes differ.
    size: Option<[f64; 3]>,
    is_foot: bool,
    /// The ends of the foot, if the body has the mesh of the hind part of OpenSim's standard foot.
    standard_foot: Option<StandardFoot>,
}

/// Ends of OpenSim's standard foot along x of the body that is its hind part, m.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StandardFoot {
    pub(crate) heel: f64,
    /// The tip of the bones that the model has.
    pub(crate) tip: f64,
    /// The tip of a foot with toes. It differs from `tip` only in a model without toes.
    pub(crate) longest_tip: f64,
    /// The height of the ankle over the sole of the bones, m.
    pub(crate) ankle_to_sole: f64,
    /// Half the width of the bones, m.
    pub(crate) half_width: f64,
}

impl BodyBones {
    /// Measures the bones of all bodies of `model`, once for each model; `None` if the radius or place of a sphere cannot be read.
    pub(crate) fn of(model: &Model) -> Option<&Self> {
        let mut spheres = model.spheres().iter();
        let are_read = spheres.all(|sphere| sphere.radius_m().is_ok() && model.rotation_of(sphere).is_ok());
        are_read.then(|| model.derived_from_bodies(Self::read))
    }

    /// Reads the bones from bodies, meshes and joints of `model`.
    fn read(model: &Model) -> Self {
        let anatomy = Anatomy::bones_of(model);
        let bodies = anatomy.bodies.iter().map(|body| (body.clone(), OnceLock::new())).collect();
        let components = model.components();
        let all = components.tree.iter().map(|(id, _)| id).filter(|&id| components.tag(id) == "Body");
        let moved = all.filter(|&id| has_moved_foot(components, id));
        let moved = moved.map(|id| components.name(id).into_owned()).collect();
        Self { anatomy, bodies, moved }
    }

    /// The bone of a body, which is computed at the first call.
    fn bone_of_body(&self, body: &str) -> Option<&BodyBone> {
        let bone = self.bodies.get(body)?;
        Some(bone.get_or_init(|| BodyBone {
            size: common_factors(&self.anatomy, body),
            is_foot: is_foot(&self.anatomy, body),
            standard_foot: standard_foot(&self.anatomy, body).filter(|_| !self.moved.contains(body)),
        }))
    }

    /// The scale factors of the meshes of `body`; `None` without meshes, or if the factors of the meshes differ.
    pub(crate) fn size(&self, body: &str) -> Option<[f64; 3]> {
        self.bone_of_body(body)?.size
    }

    /// The distance from the origin of `body` to the next joint of its foot, or, where no bone follows, to the joint above, m. Skeletons
    /// without meshes have it, too. `None` if the origin is at the joint.
    pub(crate) fn length_by_joints(&self, body: &str) -> Option<f64> {
        let next_m = self.farthest_joint(body).map(|next| next.in_parent_m);
        let length_m = next_m.or(self.joint_above(body).map(|above| above.in_child_m))?.length();
        (length_m > 0.0).then_some(length_m)
    }

    /// How far `place_m`, in the frame of the calcaneus `body`, is ahead of the ankle, m.
    pub(crate) fn ahead_of_ankle_m(&self, body: &str, place_m: DVec3) -> Option<f64> {
        let (ankle_m, forward) = self.ankle_and_forward(body)?;
        Some((place_m - ankle_m).dot(forward))
    }

    /// The place of the ankle in the calcaneus `body`, m, and the direction in which the foot points, both in the frame of `body`.
    pub(crate) fn ankle_and_forward(&self, body: &str) -> Option<(DVec3, DVec3)> {
        if !has_word(body, "calc") {
            return None;
        }
        let above = self.joint_above(body)?;
        let mut ankle_m = above.in_child_m;
        if self.is_foot(&above.parent) {
            // The talus is between shank and calcaneus.
            ankle_m += self.joint_above(&above.parent)?.in_child_m - above.in_parent_m;
        } else if ankle_m == DVec3::ZERO {
            // The origin of OpenSim's calcaneus is at the heel: here it is not known where the ankle is.
            return None;
        }
        let forward = match self.farthest_joint(body) {
            Some(joint) => joint.in_parent_m - ankle_m,
            None => self.standard_foot(body).map(|_| DVec3::X)?,
        };
        Some((ankle_m, forward.try_normalize()?))
    }

    /// Whether any body of the model belongs to a foot.
    pub(crate) fn has_feet(&self) -> bool {
        self.bodies.keys().any(|body| self.is_foot(body))
    }

    /// The joint to the next bone of the foot that is farthest from the origin of `body`. A shoe is not a bone.
    pub(crate) fn farthest_joint(&self, body: &str) -> Option<&AnatomyJoint> {
        let next = self.anatomy.joints_below(body).filter(|joint| self.is_foot(&joint.child));
        next.max_by(|a, b| a.in_parent_m.length_squared().total_cmp(&b.in_parent_m.length_squared()))
    }

    /// Whether a foot hangs on `body`, directly or by other bodies.
    pub(crate) fn has_foot_below(&self, body: &str) -> bool {
        let mut feet = self.bodies.keys().filter(|body| self.is_foot(body));
        feet.any(|foot| self.above(foot).any(|one| one == body))
    }

    /// Whether `body` hangs on a foot, as a shoe does, and no foot hangs on it.
    pub(crate) fn is_worn_by_foot(&self, body: &str) -> bool {
        self.above(body).any(|one| self.is_foot(one)) && !self.has_foot_below(body)
    }

    /// The bodies above `body`, from its parent to the root.
    fn above<'b>(&'b self, body: &'b str) -> impl Iterator<Item = &'b str> {
        let parent = move |body: &&str| self.joint_above(body).map(|joint| joint.parent.as_str());
        std::iter::successors(Some(body), parent).skip(1).take(self.bodies.len())
    }

    /// The joint between `body` and its parent.
    pub(crate) fn joint_above(&self, body: &str) -> Option<&AnatomyJoint> {
        self.anatomy.joint_above(body)
    }

    /// Whether `body` belongs to a foot, by its name or its meshes.
    pub(crate) fn is_foot(&self, body: &str) -> bool {
        self.bone_of_body(body).is_some_and(|bone| bone.is_foot)
    }

    /// The ends of OpenSim's standard foot, if `body` is its hind part.
    pub(crate) fn standard_foot(&self, body: &str) -> Option<StandardFoot> {
        self.bone_of_body(body)?.standard_foot
    }
}

/// The scale factors that all meshes of a body have in common; `None` if they differ.
fn common_factors(anatomy: &Anatomy, body: &str) -> Option<[f64; 3]> {
    let mut factors = anatomy.meshes.get(body)?.values().copied();
    let first = factors.next().filter(|factors| factors.iter().all(|factor| factor.is_finite()))?;
    factors.all(|other| same_size(other, first)).then_some(first)
}

/// Whether the name or the meshes of a body are those of a foot.
fn is_foot(anatomy: &Anatomy, body: &str) -> bool {
    // The meshes of a hand have phalanges, too.
    let names = anatomy.meshes.get(body).into_iter().flat_map(BTreeMap::keys).map(String::as_str);
    !has_word(body, "hand") && names.chain([body]).any(is_named_after_foot)
}

/// Whether the name of a body or of a mesh has a word for a foot.
pub(crate) fn is_named_after_foot(name: &str) -> bool {
    FOOT_WORDS.iter().any(|word| has_word(name, word))
}

/// The scale factors of the mesh of OpenSim's bone `bone`, if `body` has this mesh.
fn factors_of_opensim_bone(anatomy: &Anatomy, body: &str, bone: &str) -> Option<[f64; 3]> {
    let meshes = anatomy.meshes.get(body)?;
    // A file of another kind, or in another unit, is not that of OpenSim.
    let is_standard = |(file, [x, ..]): &(&String, &[f64; 3])| {
        has_word(file, ".vtp") && bone_of_mesh(file) == bone && PLAUSIBLE_FACTORS.contains(x)
    };
    meshes.iter().find(is_standard).map(|(_, factors)| *factors)
}

/// A mesh is moved if a number of its transform, rad or m, is more than this.
const LEAST_MOVE_OF_MESH: f64 = 1e-3;

/// Whether the mesh of OpenSim's foot on the body `id` has a transform of its own, as documents before version 4 can have it.
fn has_moved_foot(components: &Components, id: ComponentId) -> bool {
    let tree = components.document_of(id).tree();
    let Some(visible) = tree.child(components.element(id), "VisibleObject") else { return false };
    let is_moved = |object: ElementId| {
        let file = tree.child(object, "geometry_file").map(|file| bone_of_mesh(&tree.text_of(file)));
        let transform = tree.child(object, "transform").filter(|_| file.is_none_or(|bone| bone == "foot"));
        let far = |word: &str| word.parse::<f64>().is_ok_and(|number| number.abs() > LEAST_MOVE_OF_MESH);
        transform.is_some_and(|transform| list_words(&tree.text_of(transform)).any(far))
    };
    let mut found = false;
    tree.walk(visible, |object| {
        found |= is_moved(object);
        !found
    });
    found
}

/// The ends of OpenSim's standard foot on `body`, if the body has the mesh of its hind part.
fn standard_foot(anatomy: &Anatomy, body: &str) -> Option<StandardFoot> {
    let [foot, height, width] = factors_of_opensim_bone(anatomy, body, "foot")?;
    let plausible = |factor| if PLAUSIBLE_FACTORS.contains(&factor) { factor } else { f64::NAN };
    let ankle_to_sole = plausible(height) * ANKLE_TO_SOLE_OF_OPENSIM_FOOT_M;
    let half_width = plausible(width) * HALF_WIDTH_OF_OPENSIM_FOOT_M;
    let mut next = anatomy.joints_below(body);
    let toes =
        next.find_map(|joint| Some((joint, factors_of_opensim_bone(anatomy, &joint.child, "bofoot")?)));
    let heel = foot * HEEL_OF_OPENSIM_FOOT_X_M;
    let with_toes = toes.map(|(joint, [toes, ..])| {
        joint.in_parent_m[0] - joint.in_child_m[0] + toes * TIP_OF_OPENSIM_TOES_X_M
    });
    let tip = with_toes.unwrap_or(foot * TIP_OF_OPENSIM_FOOT_X_M);
    let longest_tip = with_toes.unwrap_or(foot * (TOES_BEGIN_X_M + TIP_OF_OPENSIM_TOES_X_M));
    Some(StandardFoot { heel, tip, longest_tip, ankle_to_sole, half_width })
}

/// Factors whose relative difference is no more than this are equal: a millimetre on a human foot.
const SAME_SIZE_TOLERANCE: f64 = 0.005;

/// Whether the factors of two bones are equal.
pub(crate) fn same_size(a: [f64; 3], b: [f64; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= SAME_SIZE_TOLERANCE * b.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sole_under_a_foot_does_not_show_where_the_toes_are() {
        let body = |name: &str, parent: &str, in_parent: &str, in_child: &str| {
            format!(
                "<Body name=\"{name}\"><mass>1</mass><Joint><PinJoint name=\"{name}_joint\">\
                 <parent_body>{parent}</parent_body><location_in_parent>{in_parent}</location_in_parent>\
                 <location>{in_child}</location></PinJoint></Joint></Body>"
            )
        };
        let calcaneus = body("calcn_r", "tibia_r", "0 -0.4 0", "0.05 0.05 0");
        let toes = body("toes_r", "calcn_r", "0.18 0 0", "0 0 0");
        let forward = |bodies: &str| {
            let text = format!(
                "<OpenSimDocument Version=\"30000\"><Model name=\"m\"><BodySet><objects><Body name=\"tibia_r\">\
                 <mass>1</mass></Body>{bodies}</objects></BodySet></Model></OpenSimDocument>"
            );
            BodyBones::of(&Model::parse(text).unwrap()).unwrap().ankle_and_forward("calcn_r")
        };
        let with_toes = format!("{calcaneus}{toes}");
        assert!(forward(&with_toes).is_some());
        for place in ["0 0 0", "0.2 0.1 0"] {
            let sole = body("sole_r", "calcn_r", place, "0 0 0");
            assert_eq!(forward(&format!("{calcaneus}{sole}")), None);
            assert_eq!(forward(&format!("{with_toes}{sole}")), forward(&with_toes));
        }
    }

    #[test]
    fn a_mesh_with_a_transform_of_its_own_shows_no_ends_of_the_foot() {
        let has_ends = |transform: &str| {
            let geometry = format!(
                "<VisibleObject><GeometrySet><objects><DisplayGeometry><geometry_file>foot.vtp</geometry_file>\
                 <transform>{transform}</transform></DisplayGeometry></objects></GeometrySet></VisibleObject>"
            );
            let text = format!(
                "<OpenSimDocument Version=\"30000\"><Model name=\"m\"><BodySet><objects><Body name=\"calcn_r\">\
                 <mass>1</mass>{geometry}</Body></objects></BodySet></Model></OpenSimDocument>"
            );
            BodyBones::of(&Model::parse(text).unwrap()).unwrap().standard_foot("calcn_r").is_some()
        };
        assert!(has_ends("-0 0 -0 0 0 0"));
        assert!(!has_ends(" 0 0 0 -0.04877 -0.04195 0"));
    }
}
