//! How far spheres reach along the bones of a foot, and whether that is further than in any published model. These measures are used:
//!
//! - towards the next joint: the sphere's centre is projected on the line from its body's origin, or from the joint above, to the body's
//!   farthest next joint, and divided by their distance. Published models reach 1.341. A joint that is welded does not end the bone.
//! - along the foot: where the foremost centre is between the heel (0) and the tip of the toes (1) of OpenSim's standard foot, by the
//!   extents of the bones' meshes. Published models have 0.691 to 1.007. If the model has no toes, their tip is where toes of the foot's size
//!   would end, because the foot may carry their spheres.
//! - below the ankle: where bottoms of spheres on OpenSim's standard foot end, between its ankle (0) and the sole of its bones (1).
//!   Published models have 1.00 to 1.98; a thick shoe adds 0.8.
//! - behind the heel, along the foot, and beside the middle of the foot, in half widths of its bones. The rearmost centres of published
//!   models are at 0.037 or more, the ones nearest to the middle at most 0.36 beside it.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use std::sync::OnceLock;

use foldhash::{HashMap, HashMapExt, HashSet};
use osim_model::compare::bone_of_mesh;
use osim_model::messages::four_significant;
use osim_model::opensim_text::list_words;
use osim_model::{Anatomy, AnatomyJoint, ComponentId, Components, DVec3, ElementId, Model, SphereId};

/// A sphere that reaches at most this far towards the next joint is usual.
const LARGEST_TOWARDS_JOINT: f64 = 1.4;
/// A sphere that reaches at least this far towards the next joint is usual. The number is negative, because some spheres are nearer to the
/// heel than the origin of their body, or than the ankle where no talus is.
const LEAST_TOWARDS_JOINT: f64 = -0.5;
/// The middle of the usual reach towards the next joint.
const MIDDLE_TOWARDS_JOINT: f64 = 0.45;
/// Usual reach of the foremost sphere along the foot, between heel (0) and tip of the toes (1).
const USUAL_ALONG_FOOT: RangeInclusive<f64> = 0.65..=1.05;
/// Usual reach of a foot's bottoms below the ankle, between the ankle (0) and the sole of the bones (1).
const USUAL_BELOW_ANKLE: RangeInclusive<f64> = 0.6..=2.85;
/// The middle of this range.
const MIDDLE_BELOW_ANKLE: f64 = 1.725;
/// Usual reach of the rearmost sphere along the foot.
const USUAL_FROM_HEEL: RangeInclusive<f64> = -0.15..=f64::INFINITY;
/// Usual reach of the sphere that is nearest to the middle of the foot, beside it.
const USUAL_BESIDE_FOOT: RangeInclusive<f64> = 0.0..=1.5;

/// How far one sphere reaches, towards the next joint or along the foot.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Reach {
    pub sphere: SphereId,
    pub value: f64,
    /// Name of the next joint, or of the body that is the hind part of the foot.
    pub towards: String,
    measure: ReachMeasure,
    /// The usual reach of this sphere.
    usual: RangeInclusive<f64>,
}

/// The length to which the reach of a sphere is compared: the distance to the next joint, the length of the foot from its heel, the height
/// of the ankle over the sole of the bones, or half the width of the foot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum ReachMeasure {
    TowardsJoint,
    AlongFoot,
    FromHeel,
    BelowAnkle,
    BesideFoot,
}

impl Reach {
    /// Whether no published sphere reaches this far.
    pub(crate) fn is_odd(&self) -> bool {
        self.value < *self.usual.start() || self.value > *self.usual.end()
    }

    /// The reach in words, to follow the name of the sphere in a sentence.
    pub(crate) fn describe(&self) -> String {
        let (value, towards) = (four_significant(self.value), &self.towards);
        match self.measure {
            ReachMeasure::TowardsJoint if self.value < 0.0 => {
                format!(
                    "lies at {value} of the way to the next joint, {towards}: on the other side of its body"
                )
            }
            ReachMeasure::TowardsJoint => format!(
                "lies at {value} of the way to the next joint, {towards}; no published sphere is beyond 1.34"
            ),
            ReachMeasure::AlongFoot => format!(
                "is the foremost of {towards} and lies at {value} of the foot's length, published ones at 0.69 to 1.01"
            ),
            ReachMeasure::FromHeel => format!(
                "lies behind the heel of {towards}: at {value} of the foot's length, published ones at 0.037 or more"
            ),
            ReachMeasure::BesideFoot => format!(
                "lies beside {towards}: {value} half widths from its middle, published ones at most 0.36"
            ),
            ReachMeasure::BelowAnkle => format!(
                "ends at {value} of the way from the ankle of {towards} down to the sole of the bones, published ones at 1.00 to 1.98"
            ),
        }
    }
}

/// The reach of each foot sphere towards the next joint; and of the sphere of each foot that is foremost, rearmost, most usual below the
/// ankle, and nearest to the middle. Only if the last two are unusual, all spheres of the foot were moved.
pub(crate) fn reaches(model: &Model, bones: &BodyBones) -> Vec<Reach> {
    let reach = |sphere, value, towards, measure, usual| Reach { sphere, value, towards, measure, usual };
    let mut reaches = Vec::new();
    // For each foot the most usual reach along it, and of each sphere the reaches along it, below the ankle and beside the middle.
    let mut feet: BTreeMap<String, (f64, Vec<(SphereId, DVec3)>)> = BTreeMap::new();
    for id in model.loaded_spheres(&model.force_ids()) {
        let (Some(sphere), Some(centre)) = (model.sphere(id), model.centre_m(id)) else { continue };
        let Some(body) = sphere.body.as_deref().filter(|body| bones.is_foot(body)) else { continue };
        // Of several next joints, the one that is farthest from the body's origin. A joint nearer than a radius does not show how long
        // the bone is.
        let radius_m = sphere.radius.number;
        let next = bones.farthest_joint(body).filter(|(squared, _)| *squared > radius_m * radius_m);
        reaches.extend(next.map(|(squared, joint)| {
            let along = |from_m: DVec3| {
                let way_m = joint.in_parent_m - from_m;
                (centre - from_m).dot(way_m) / way_m.length_squared()
            };
            let of_origin = centre.dot(joint.in_parent_m) / squared;
            // The origin of a body can be far from the joint above it, for example at the centre of mass.
            let of_joint = bones.joint_above(body).map_or(f64::NAN, |above| along(above.in_child_m));
            let off = |value: f64| (value - MIDDLE_TOWARDS_JOINT).abs();
            let value = if off(of_joint) < off(of_origin) { of_joint } else { of_origin };
            let most = if joint.is_weld { f64::INFINITY } else { LARGEST_TOWARDS_JOINT };
            reach(id, value, joint.name.clone(), ReachMeasure::TowardsJoint, LEAST_TOWARDS_JOINT..=most)
        }));
        let as_hind_part = |body: &str| bones.standard_foot(body).map(|foot| (body.to_owned(), foot));
        let as_toes = || {
            let joint = bones.joint_above(body)?;
            let (hind, foot) = as_hind_part(&joint.parent)?;
            Some((hind, foot, joint.in_parent_m - joint.in_child_m))
        };
        let foot = as_hind_part(body).map(|(hind, foot)| (hind, foot, DVec3::ZERO)).or_else(as_toes);
        if let Some((hind, foot, origin)) = foot {
            let StandardFoot { heel, tip, longest_tip, ankle_to_sole, half_width } = foot;
            let (place, ankle) = (origin + centre, bones.ankle_and_forward(&hind));
            let ankle_y = ankle.map_or(f64::NAN, |(ankle, _)| ankle[1]);
            let below = (ankle_y - place[1] + radius_m) / ankle_to_sole;
            let most = USUAL_ALONG_FOOT.end() * (longest_tip - heel) / (tip - heel);
            let value = DVec3::new((place[0] - heel) / (tip - heel), below, place[2].abs() / half_width);
            feet.entry(hind).or_insert((most, Vec::new())).1.push((id, value));
        }
    }
    for (hind, (most, spheres)) in feet {
        // Each measure is the axis of the sphere for which `order` gives the least number.
        let mut add = |measure, axis: usize, order: fn(f64) -> f64, usual| {
            let values = spheres.iter().map(|(id, value)| (*id, value[axis]));
            let least = values.min_by(|a, b| order(a.1).total_cmp(&order(b.1)));
            reaches.extend(least.map(|(id, value)| reach(id, value, hind.clone(), measure, usual)));
        };
        add(ReachMeasure::AlongFoot, 0, |along| -along, *USUAL_ALONG_FOOT.start()..=most);
        add(ReachMeasure::FromHeel, 0, |along| along, USUAL_FROM_HEEL);
        add(ReachMeasure::BelowAnkle, 1, |below| (below - MIDDLE_BELOW_ANKLE).abs(), USUAL_BELOW_ANKLE);
        add(ReachMeasure::BesideFoot, 2, |beside| beside, USUAL_BESIDE_FOOT);
    }
    reaches
}

// The bones of a foot: their meshes, their sizes, and their next joints.

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
    /// For each body, the next joint that is farthest from the body's origin: the square of the distance, m², and the index of the joint.
    farthest: HashMap<String, (f64, usize)>,
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
struct StandardFoot {
    heel: f64,
    /// The tip of the bones that the model has.
    tip: f64,
    /// The tip of a foot with toes. It differs from `tip` only in a model without toes.
    longest_tip: f64,
    /// The height of the ankle over the sole of the bones, m.
    ankle_to_sole: f64,
    /// Half the width of the bones, m.
    half_width: f64,
}

impl BodyBones {
    /// The bones of `model`; `None` if the radius or place of a sphere cannot be read.
    pub(crate) fn of(model: &Model) -> Option<&Self> {
        let mut spheres = model.spheres().iter();
        let are_read = spheres.all(|sphere| sphere.radius_m().is_ok() && model.rotation_of(sphere).is_ok());
        are_read.then(|| model.derived_from_bodies(Self::read))
    }

    /// Reads the bones from bodies, meshes and joints of `model`.
    fn read(model: &Model) -> Self {
        let anatomy = Anatomy::bones_of(model);
        let mut farthest: HashMap<String, (f64, usize)> = HashMap::new();
        for (at, joint) in anatomy.joints.iter().enumerate() {
            let squared = joint.in_parent_m.length_squared();
            let most = farthest.entry(joint.parent.clone()).or_insert((squared, at));
            if squared.total_cmp(&most.0).is_ge() {
                *most = (squared, at);
            }
        }
        let bodies = anatomy.bodies.iter().map(|body| (body.clone(), OnceLock::new())).collect();
        let components = model.components();
        let all = components.tree.iter().map(|(id, _)| id).filter(|&id| components.tag(id) == "Body");
        let moved = all.filter(|&id| has_moved_foot(components, id));
        let moved = moved.map(|id| components.name(id).into_owned()).collect();
        Self { anatomy, bodies, farthest, moved }
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

    /// The length of `body` over the length of OpenSim's calcaneus, as the joint to the toes shows it.
    pub(crate) fn length_by_toe_joint(&self, body: &str) -> Option<f64> {
        if !body.to_lowercase().contains("calc") {
            return None;
        }
        let mut below = self.anatomy.joints_below(body);
        let toes = below.find(|joint| joint.child.to_lowercase().contains("toe"))?;
        Some(toes.in_parent_m[0] / TOES_BEGIN_X_M).filter(|factor| PLAUSIBLE_FACTORS.contains(factor))
    }

    /// How far `place_m`, in the frame of the calcaneus `body`, is ahead of the ankle, m.
    pub(crate) fn ahead_of_ankle_m(&self, body: &str, place_m: DVec3) -> Option<f64> {
        let (ankle_m, forward) = self.ankle_and_forward(body)?;
        Some((place_m - ankle_m).dot(forward))
    }

    /// The place of the ankle in the calcaneus `body`, m, and the direction in which the foot points, both in the frame of `body`.
    fn ankle_and_forward(&self, body: &str) -> Option<(DVec3, DVec3)> {
        if !body.to_lowercase().contains("calc") {
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
            Some((_, joint)) => joint.in_parent_m - ankle_m,
            None => self.standard_foot(body).map(|_| DVec3::X)?,
        };
        Some((ankle_m, forward.try_normalize()?))
    }

    /// Whether any body of the model belongs to a foot.
    pub(crate) fn has_feet(&self) -> bool {
        self.bodies.keys().any(|body| self.is_foot(body))
    }

    /// The next joint of `body` that is farthest from the origin of `body`, and the square of the distance, m².
    fn farthest_joint(&self, body: &str) -> Option<(f64, &AnatomyJoint)> {
        let (squared, at) = self.farthest.get(body)?;
        Some((*squared, self.anatomy.joints.get(*at)?))
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
    fn standard_foot(&self, body: &str) -> Option<StandardFoot> {
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
    !body.to_lowercase().contains("hand") && names.chain([body]).any(is_named_after_foot)
}

/// Whether the name of a body or of a mesh has a word for a foot.
pub(crate) fn is_named_after_foot(name: &str) -> bool {
    let name = name.to_lowercase();
    FOOT_WORDS.iter().any(|word| name.contains(word))
}

/// The scale factors of the mesh of OpenSim's bone `bone`, if `body` has this mesh.
fn factors_of_opensim_bone(anatomy: &Anatomy, body: &str, bone: &str) -> Option<[f64; 3]> {
    let meshes = anatomy.meshes.get(body)?;
    // A file of another kind, or in another unit, is not that of OpenSim.
    let is_standard = |(file, [x, ..]): &(&String, &[f64; 3])| {
        file.to_lowercase().contains(".vtp") && bone_of_mesh(file) == bone && PLAUSIBLE_FACTORS.contains(x)
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

    /// The largest reach towards a joint, the least and largest reach along the foot, the most usual one below the ankle, the rearmost one,
    /// and the one nearest to the middle of the foot, in the model of the corpus with these file names.
    fn measured_reaches(names: &[&str]) -> Option<[f64; 6]> {
        use osim_model::files::{CompanionPaths, InMemory, ModelFiles};
        let folder = std::env::var_os("OSIM_CORPUS").map(std::path::PathBuf::from)?;
        let read = |name: &str| std::fs::read(folder.join(name)).unwrap();
        let mut files = InMemory::default();
        names.iter().for_each(|name| files.add(name, read(name)));
        let beside = match names {
            [_, geometry, model] => {
                CompanionPaths { geometry: Some(geometry.as_ref()), model: Some(model.as_ref()) }
            }
            _ => CompanionPaths::default(),
        };
        let opened =
            ModelFiles::read(names[0].as_ref(), read(names[0]), beside, &files).unwrap().open().unwrap();
        let bones = BodyBones::of(&opened.model).unwrap();
        let reaches = reaches(&opened.model, bones);
        let values = |measure| reaches.iter().filter(move |one| one.measure == measure).map(|one| one.value);
        Some([
            values(ReachMeasure::TowardsJoint).fold(f64::NAN, f64::max),
            values(ReachMeasure::AlongFoot).fold(f64::NAN, f64::min),
            values(ReachMeasure::AlongFoot).fold(f64::NAN, f64::max),
            values(ReachMeasure::BelowAnkle).fold(f64::NAN, f64::max),
            values(ReachMeasure::FromHeel).fold(f64::NAN, f64::max),
            values(ReachMeasure::BesideFoot).fold(f64::NAN, f64::max),
        ])
    }

    const FALISSE: &str = include_str!("../../../fixtures/check/known_contacts.osim");

    /// The reach of the heel of the right foot of `text` towards the toes.
    fn heel_towards_joint(text: &str) -> Reach {
        let model = Model::parse(text).unwrap();
        let mut all = reaches(&model, BodyBones::of(&model).unwrap()).into_iter();
        let is_heel = |id| model.sphere(id).unwrap().name == "s1_r";
        all.find(|one| one.measure == ReachMeasure::TowardsJoint && is_heel(one.sphere)).unwrap()
    }

    #[test]
    fn the_origin_of_a_foot_may_be_elsewhere() {
        let heel = heel_towards_joint(FALISSE);
        // The origin is at the centre of mass, 90 mm ahead.
        let frame = "<frames><PhysicalOffsetFrame name=\"heel\"><socket_parent>/bodyset/calcn_r</socket_parent>\
             <translation>-0.09 0 0</translation></PhysicalOffsetFrame>";
        let moved = FALISSE
            .replace("<socket_child_frame>/bodyset/calcn_r<", "<socket_child_frame>heel<")
            .replacen("<frames>", frame, 1)
            .replace("0.16341 -0.00183 0.00099", "0.07341 -0.00183 0.00099")
            .replace("0.00190115 -0.01 -0.0038263", "-0.08809885 -0.01 -0.0038263");
        let of_moved = heel_towards_joint(&moved);
        assert!((of_moved.value - heel.value).abs() < 1e-9 && !of_moved.is_odd(), "{of_moved:?}");
        // The origin is at the ankle, and the heel is 65 mm behind it: (-0.065 0.125 + 0.045 0.04)/(0.125^2 + 0.04^2).
        let at_ankle = FALISSE
            .replace("0.16341 -0.00183 0.00099", "0.125 -0.04 0")
            .replace("0.00190115 -0.01 -0.0038263", "-0.065 -0.045 0");
        let at_ankle = heel_towards_joint(&at_ankle);
        assert!((at_ankle.value + 0.3672).abs() < 5e-5 && !at_ankle.is_odd(), "{at_ankle:?}");
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

    /// Expected values were computed with NumPy from OpenSim 4.6's frames and the meshes' extents, with four digits.
    #[test]
    fn published_models_reach_as_far_as_measured() {
        let moco = [
            "v40600_moco_3d_walking_ContactForceSet.xml",
            "v40600_moco_3d_walking_ContactGeometrySet.xml",
            "v40600_moco_3d_walking_model_without_contacts.osim",
        ];
        let none = f64::NAN;
        for (names, expected) in [
            (&["v40000_toy_landing.osim"][..], [0.0551, 0.6915, 0.6915, 1.1962, 0.0746, 0.1178]),
            (&["v40000_scone_h0914m.osim"], [none, 1.0061, 1.0061, 1.0997, 0.1281, 0.0]),
            (&["v30000_scone_h0914m.osim"], [none, 1.0061, 1.0061, 1.0997, 0.1281, 0.0]),
            (&["v40000_moco_2d_gait.osim"], [1.0868, 0.7680, 0.7680, 1.4577, 0.1659, 0.0]),
            (&["v40000_falisse_2022_human.osim"], [0.9075, 0.9576, 0.9576, 1.7360, 0.0447, 0.0987]),
            (&["v30000_osim_rl_gait9dof18musc_crlf.osim"], [0.1653, 0.8233, 0.8233, 1.0417, 0.1499, 0.0]),
            (&["v20302_dynamic_jumper.osim"], [1.0325, 0.9777, 0.9777, 1.0041, 0.0369, 0.3535]),
            (&["v40000_dhondt_2024_3seg_human.osim"], [1.0249, none, none, none, none, none]),
            (&moco, [1.1374, 0.9551, 0.9551, 1.6126, 0.0938, 0.2217]),
        ] {
            let Some(found) = measured_reaches(names) else {
                eprintln!(
                    "skipped: reach of published models: OSIM_CORPUS is not set to the folder of real models"
                );
                return;
            };
            for (value, expected) in found.into_iter().zip(expected) {
                let both_absent = value.is_nan() && expected.is_nan();
                assert!(
                    both_absent || (value - expected).abs() < 6e-5,
                    "{names:?}: {value}, expected {expected}"
                );
            }
        }
    }
}
