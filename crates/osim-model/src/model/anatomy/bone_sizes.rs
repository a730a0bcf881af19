//! The sizes of bones: scale factors of meshes, translations of frames, and distances between joints.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

use foldhash::{HashMap, HashMapExt};
use glam::DVec3;

use crate::model::{AnatomyJoint, ComponentId, Components, Document, Side, Sphere, Suspicion};
use crate::xml::{ElementId, opensim_text};

/// Three numbers along x, y and z for each mesh or frame of each body, as in [`Anatomy`](crate::model::anatomy::Anatomy).
pub type TriplesByBody = BTreeMap<String, BTreeMap<String, [f64; 3]>>;

pub(crate) fn mesh_factors(components: &Components) -> TriplesByBody {
    let mut factors = TriplesByBody::new();
    for (id, _) in components.tree.iter().filter(|(id, _)| components.tag(*id) == "Body") {
        factors.entry(components.name(id).into_owned()).or_default().extend(meshes(components, id));
    }
    factors
}

/// The translations, m, of the offset frames and joint frames on each body.
pub(crate) fn frame_offsets(components: &Components) -> TriplesByBody {
    let mut offsets = TriplesByBody::new();
    for (id, _) in components.tree.iter() {
        let tag = components.tag(id);
        if tag == "PhysicalOffsetFrame" {
            read_frame(&mut offsets, components, id);
        } else if tag.ends_with("Joint") {
            read_joint(&mut offsets, components, id);
            read_old_joint(&mut offsets, components, id);
        }
    }
    offsets
}

/// Adds the translation of an offset frame that is fixed directly to a body. OpenSim scales it by the factors of the body.
fn read_frame(offsets: &mut TriplesByBody, components: &Components, frame: ComponentId) {
    let Some((body, translation)) = offset_on_body(components, frame) else { return };
    offsets.entry(body).or_default().insert(components.tree.path(frame), translation);
}

/// Adds the translations of a joint's frames under the name of the joint. Documents of versions 3 and 4 then have the same keys.
fn read_joint(offsets: &mut TriplesByBody, components: &Components, joint: ComponentId) {
    for end in ["parent", "child"] {
        let frame = components
            .frame_at(joint, &format!("{end}_frame"), &[])
            .and_then(|found| found.component)
            .filter(|&frame| components.tag(frame) == "PhysicalOffsetFrame");
        if let Some((body, translation)) = frame.and_then(|frame| offset_on_body(components, frame)) {
            let key = format!("{} {end}", components.name(joint));
            offsets.entry(body).or_default().insert(key, translation);
        }
    }
}

/// Adds the translations of a joint in a document of version 3, where the joint is inside its child body.
fn read_old_joint(offsets: &mut TriplesByBody, components: &Components, joint: ComponentId) {
    let document = components.document_of(joint);
    let element = components.element(joint);
    let owner = components.tree.get(joint).and_then(|object| object.parent);
    let Some(child) = owner.filter(|&id| components.tag(id) == "Body") else { return };
    let name = components.name(joint);
    let parent = components.frame_at(joint, "parent_frame", &["parent_body"]);
    let ends = [
        ("child", Some(child), "location"),
        ("parent", parent.and_then(|found| found.component), "location_in_parent"),
    ];
    for (end, body, tag) in ends {
        if let (Some(body), Some(place)) = (body, document.triple(element, tag)) {
            let of_body = offsets.entry(components.name(body).into_owned()).or_default();
            of_body.insert(format!("{name} {end}"), place);
        }
    }
}

/// The first document version with a `<GeometrySet>`. Older documents list only the file names of meshes.
pub(crate) const FIRST_VERSION_WITH_GEOMETRY_SETS: u32 = 20101;

pub(crate) fn mesh_file(document: &Document, element: ElementId, tag: &str) -> String {
    let tree = document.tree();
    tree.child(element, tag).map(|file| tree.text_of(file).into_owned()).unwrap_or_default()
}

/// The scale factors of a mesh along x, y and z: 1 if the file has none, NaN if they are not numbers.
pub(crate) fn mesh_scale(document: &Document, element: ElementId) -> [f64; 3] {
    let missing = document.tree().child(element, "scale_factors").is_none();
    document.triple(element, "scale_factors").unwrap_or([if missing { 1.0 } else { f64::NAN }; 3])
}

/// The meshes of `body` by file name (numbered if it repeats), each with its scale factors along x, y and z.
fn meshes(components: &Components, body: ComponentId) -> BTreeMap<String, [f64; 3]> {
    let document = components.document_of(body);
    let tree = document.tree();
    let element = components.element(body);
    let mut mesh_list = Vec::new();
    if let Some(attached) = tree.child(element, "attached_geometry") {
        for mesh in tree.children(attached).filter(|&mesh| tree.name(mesh) == "Mesh") {
            mesh_list.push((mesh_file(document, mesh, "mesh_file"), mesh_scale(document, mesh)));
        }
    }
    // Version 1 lists file names. In versions 2 and 3 each display geometry has its own factors, and all share those of <VisibleObject>.
    if let Some(visible) = tree.child(element, "VisibleObject") {
        let common_factors = mesh_scale(document, visible);
        if document.version() < FIRST_VERSION_WITH_GEOMETRY_SETS {
            let names = mesh_file(document, visible, "geometry_files");
            mesh_list.extend(opensim_text::list_words(&names).map(|name| (name.to_owned(), common_factors)));
        }
        let set = tree.child(visible, "GeometrySet").and_then(|set| tree.child(set, "objects"));
        for geometry in set.into_iter().flat_map(|set| tree.children(set)) {
            let own_factors = mesh_scale(document, geometry);
            let factors = DVec3::from(common_factors) * DVec3::from(own_factors);
            mesh_list.push((mesh_file(document, geometry, "geometry_file"), factors.to_array()));
        }
    }
    let mut meshes = BTreeMap::new();
    let mut counts: HashMap<String, usize> = HashMap::new();
    for (file, factors) in mesh_list {
        let mut key = file;
        if meshes.contains_key(&key) {
            let file = key.clone();
            let count = counts.entry(key.clone()).or_insert(2);
            while meshes.contains_key(&key) {
                key = format!("{file} #{count}");
                *count += 1;
            }
        }
        // A mesh is only drawn: one that is mirrored shows a bone of the same size.
        meshes.insert(key, factors.map(f64::abs));
    }
    meshes
}

/// The body to which an offset frame is fixed directly, and the frame's translation on it.
fn offset_on_body(components: &Components, frame: ComponentId) -> Option<(String, [f64; 3])> {
    let parent = components.frame_at(frame, "parent", &["parent_frame"])?.component;
    let body = parent.filter(|&found| components.tag(found) == "Body")?;
    let translation =
        components.document_of(frame).triple(components.element(frame), "translation").unwrap_or([0.0; 3]);
    Some((components.name(body).into_owned(), translation))
}

// Distances between the joints of a body, and spheres that are larger than these.

/// The number of outermost joints of a body whose distances from all others are compared: more than real bodies have.
const MOST_OUTERMOST_JOINTS: usize = 32;
/// The usual length of a long bone over the radius of a contact sphere: a shank of 0.43 m, a radius of 0.032 m. Used for spheres without an
/// old radius.
const BONE_LENGTH_IN_RADII: f64 = 13.0;

/// The distances between the joints of each body, a measure of the size of bones: from
/// [`Model::joint_distances`](crate::model::Model::joint_distances).
#[derive(Debug, Clone, Default, PartialEq)]
pub struct BoneLengths {
    /// The longest distance between two joints on one body, m: on the named body or a body that is joined to it.
    around_m: BTreeMap<String, f64>,
    /// The longest distance between two joints of the named body alone, m.
    by_body_m: BTreeMap<String, f64>,
    /// The longest distance between two joints on one body, m: on the named body or a body above it on its limb.
    by_limb_m: HashMap<String, Option<f64>>,
    longest_of_all_m: Option<f64>,
}

impl BoneLengths {
    /// The distances between `joints`, such as [`Anatomy::joints`](crate::model::Anatomy::joints).
    pub(crate) fn from_joints(joints: &[AnatomyJoint]) -> Self {
        let mut neighbours: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
        let mut places: BTreeMap<&str, Vec<DVec3>> = BTreeMap::new();
        for joint in joints {
            let (parent, child) = (joint.parent.as_str(), joint.child.as_str());
            places.entry(parent).or_default().push(joint.in_parent_m);
            places.entry(child).or_default().push(joint.in_child_m);
            neighbours.entry(parent).or_default().insert(child);
            neighbours.entry(child).or_default().insert(parent);
        }
        let longest =
            |(body, places): (&str, Vec<DVec3>)| Some((body.to_owned(), longest_distance_m(&places)?));
        let longest_m: BTreeMap<String, f64> = places.into_iter().filter_map(longest).collect();
        let around = |(body, next_to): (&str, BTreeSet<&str>)| {
            let near = next_to.into_iter().chain([body]).filter_map(|body| longest_m.get(body));
            Some((body.to_owned(), near.copied().reduce(f64::max)?))
        };
        Self {
            around_m: neighbours.into_iter().filter_map(around).collect(),
            by_limb_m: longest_by_limb(joints, &longest_m),
            longest_of_all_m: longest_m.values().copied().reduce(f64::max),
            by_body_m: longest_m,
        }
    }

    /// The longest distance between two joints of `body`, m; `None` if it has no two joints at different places.
    pub fn longest_in_body(&self, body: &str) -> Option<f64> {
        self.by_body_m.get(body).copied()
    }

    /// The ratio of these distances to those of `other`, over all bodies that both have, and the number of these bodies. The distances are
    /// summed, so that long bones count most.
    pub fn ratio_to(&self, other: &Self) -> Option<(f64, usize)> {
        let both =
            self.by_body_m.iter().filter_map(|(body, own_m)| Some((own_m, other.by_body_m.get(body)?)));
        let (own_m, other_m): (Vec<f64>, Vec<f64>) = both.unzip();
        let ratio = own_m.iter().sum::<f64>() / other_m.iter().sum::<f64>();
        (ratio.is_finite() && ratio > 0.0).then_some((ratio, own_m.len()))
    }

    /// The longest bone of the limb, m: the longest distance between two joints of `body` or of a body above it, up to the trunk. `None` if
    /// none of these bodies has two joints at different places.
    pub fn longest_in_limb(&self, body: &str) -> Option<f64> {
        self.by_limb_m.get(body).copied().flatten()
    }

    pub fn longest_around_body(&self, body: &str) -> Option<f64> {
        self.around_m.get(body).copied().or(self.longest_of_all_m)
    }

    /// A question to the caller if `radius_m` makes `sphere` larger than the bones around it. `is_given_length`: the caller gave the radius
    /// as a length, perhaps in another unit.
    pub fn implausible_radius(
        &self,
        sphere: &Sphere,
        radius_m: f64,
        is_given_length: bool,
    ) -> Option<Suspicion> {
        let longest_m = self.longest_around_body(sphere.body.as_ref()?)?;
        // A sphere that is new has the radius that the caller gave.
        let usual_m = if sphere.radius.number == radius_m {
            longest_m / BONE_LENGTH_IN_RADII
        } else {
            sphere.radius.number
        };
        let usual_m = is_given_length.then_some(usual_m);
        let sphere = sphere.name.clone();
        (radius_m > longest_m).then_some(Suspicion::Radius { sphere, radius_m, longest_m, usual_m })
    }
}

/// The longest bone of the limb of each joined body. Each joint is visited once. A limb ends below the first body without a side in its
/// name, or of the other side.
fn longest_by_limb(
    joints: &[AnatomyJoint],
    by_body_m: &BTreeMap<String, f64>,
) -> HashMap<String, Option<f64>> {
    let mut above: HashMap<&str, &str> = HashMap::new();
    for joint in joints {
        above.entry(&joint.child).or_insert(&joint.parent);
    }
    let mut by_limb_m: HashMap<&str, Option<f64>> = HashMap::new();
    for body in joints.iter().flat_map(|joint| [joint.child.as_str(), joint.parent.as_str()]) {
        let (mut passed, mut at) = (Vec::new(), Some(body));
        while let Some(body) = at.filter(|&body| !by_limb_m.contains_key(body)) {
            // A loop of joints ends here, too.
            by_limb_m.insert(body, None);
            passed.push(body);
            let side = Side::of_name(body);
            at = above.get(body).copied().filter(|up| side.is_none() || Side::of_name(up) == side);
        }
        let mut longest_m = at.and_then(|body| by_limb_m.get(body).copied().flatten());
        for body in passed.into_iter().rev() {
            longest_m = [longest_m, by_body_m.get(body).copied()].into_iter().flatten().reduce(f64::max);
            by_limb_m.insert(body, longest_m);
        }
    }
    by_limb_m.into_iter().map(|(body, longest_m)| (body.to_owned(), longest_m)).collect()
}

/// The longest distance between two of `places`. If very many places are about equally far from their middle (joints on a circle), only
/// pairs with one of the [`MOST_OUTERMOST_JOINTS`] are compared. The result is then at least 0.57 (1/√3) of the longest distance: the
/// outermost place is as far out along some axis as 1/√3 of half the longest, and on the other side of the middle there is a place as far
/// out.
fn longest_distance_m(places: &[DVec3]) -> Option<f64> {
    let mut places: Vec<DVec3> = places.iter().copied().filter(|place| place.is_finite()).collect();
    places.sort_unstable_by(|a, b| {
        let (a, b) = (a.to_array(), b.to_array());
        a.iter().zip(&b).map(|(a, b)| a.total_cmp(b)).fold(Ordering::Equal, Ordering::then)
    });
    places.dedup();
    let all = || places.iter().copied();
    let middle =
        all().fold(DVec3::INFINITY, DVec3::min) / 2.0 + all().fold(DVec3::NEG_INFINITY, DVec3::max) / 2.0;
    // From the outermost one inwards: two places are no farther apart than both are from the middle together.
    let mut by_distance: Vec<(f64, DVec3)> =
        places.into_iter().map(|place| (place.distance(middle), place)).collect();
    by_distance.sort_unstable_by(|a, b| b.0.total_cmp(&a.0));
    let mut longest: Option<f64> = None;
    for (at, (far, a)) in by_distance.iter().enumerate().take(MOST_OUTERMOST_JOINTS) {
        for (near, b) in by_distance.iter().skip(at + 1) {
            // Far enough above rounding to lose no pair.
            if longest.is_some_and(|longest| (far + near) * (1.0 + 1e-9) < longest) {
                break;
            }
            let apart = a.distance(*b);
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
