//! Factors of meshes and translations of frames: what scaling changes of a body.

use std::collections::BTreeMap;

use crate::xml::opensim_text;
use foldhash::{HashMap, HashMapExt};

use super::mesh_elements::{GEOMETRY_SETS, file_of, scale};
use crate::model::components::{ComponentId, Components};
use crate::model::reference_frame::times;

/// By body: three numbers for each of its meshes or frames, as in [`Anatomy`](super::Anatomy).
pub(crate) type ByBody = BTreeMap<String, BTreeMap<String, [f64; 3]>>;

/// The factors of the meshes of all bodies.
pub(crate) fn mesh_factors(components: &Components) -> ByBody {
    let mut found = ByBody::new();
    for (id, _) in components.tree.iter().filter(|(id, _)| components.tag(*id) == "Body") {
        found.entry(components.name(id).into_owned()).or_default().extend(meshes(components, id));
    }
    found
}

/// The translations of all frames and joints.
pub(crate) fn frame_offsets(components: &Components) -> ByBody {
    let mut found = Offsets::default();
    for (id, _) in components.tree.iter() {
        let tag = components.tag(id);
        if tag == "PhysicalOffsetFrame" {
            found.read_frame(components, id);
        } else if tag.ends_with("Joint") {
            found.read_joint(components, id);
            found.read_old_joint(components, id);
        }
    }
    found.offsets
}

#[derive(Default)]
struct Offsets {
    offsets: ByBody,
}

impl Offsets {
    /// An offset frame that is fixed to a body directly: OpenSim scales its translation by that body's factors.
    fn read_frame(&mut self, components: &Components, frame: ComponentId) {
        let Some((body, translation)) = offset_on_body(components, frame) else { return };
        self.offsets.entry(body).or_default().insert(components.tree.path(frame), translation);
    }

    /// The same offsets under the joint's name, which a document of version 3 has too.
    fn read_joint(&mut self, components: &Components, joint: ComponentId) {
        for end in ["parent", "child"] {
            let frame = components
                .connectee(joint, &format!("{end}_frame"), &[])
                .and_then(|frame| components.frame(joint, &frame))
                .and_then(|found| found.component)
                .filter(|&frame| components.tag(frame) == "PhysicalOffsetFrame");
            if let Some((body, translation)) = frame.and_then(|frame| offset_on_body(components, frame)) {
                let key = format!("{} {end}", components.name(joint));
                self.offsets.entry(body).or_default().insert(key, translation);
            }
        }
    }

    /// Documents of version 3: the joint inside the child body holds both translations.
    fn read_old_joint(&mut self, components: &Components, joint: ComponentId) {
        let document = components.doc(joint);
        let element = components.element(joint);
        let owner = components.tree.get(joint).and_then(|object| object.parent);
        let Some(child) = owner.filter(|&id| components.tag(id) == "Body") else { return };
        let name = components.name(joint);
        if let Some(own) = document.triple(element, "location") {
            self.offsets
                .entry(components.name(child).into_owned())
                .or_default()
                .insert(format!("{name} child"), own);
        }
        let parent = components.connectee(joint, "parent_frame", &["parent_body"]);
        let parent =
            parent.and_then(|parent| components.frame(joint, &parent)).and_then(|found| found.component);
        if let (Some(parent), Some(there)) = (parent, document.triple(element, "location_in_parent")) {
            self.offsets
                .entry(components.name(parent).into_owned())
                .or_default()
                .insert(format!("{name} parent"), there);
        }
    }
}

/// The meshes of `body`: file (numbered where it repeats) and scale factors along x, y and z.
fn meshes(components: &Components, body: ComponentId) -> BTreeMap<String, [f64; 3]> {
    let document = components.doc(body);
    let tree = document.tree();
    let element = components.element(body);
    let mut found = Vec::new();
    if let Some(attached) = tree.child(element, "attached_geometry") {
        for mesh in tree.children(attached).filter(|&mesh| tree.name(mesh) == "Mesh") {
            found.push((file_of(document, mesh, "mesh_file"), scale(document, mesh)));
        }
    }
    // Documents of version 1 list names; those of version 2 and 3: every display geometry has its own factors, and the whole has some too.
    if let Some(visible) = tree.child(element, "VisibleObject") {
        let whole = scale(document, visible);
        if document.version() < GEOMETRY_SETS {
            let names = file_of(document, visible, "geometry_files");
            found.extend(opensim_text::list(&names).map(|name| (name.to_owned(), whole)));
        }
        let set = tree.child(visible, "GeometrySet").and_then(|set| tree.child(set, "objects"));
        for geometry in set.into_iter().flat_map(|set| tree.children(set)) {
            let own = scale(document, geometry);
            found.push((file_of(document, geometry, "geometry_file"), times(whole, own)));
        }
    }
    let mut meshes = BTreeMap::new();
    let mut counts: HashMap<String, usize> = HashMap::new();
    for (file, factors) in found {
        let mut key = file.clone();
        let count = counts.entry(file.clone()).or_insert(2);
        while meshes.contains_key(&key) {
            key = format!("{file} #{count}");
            *count += 1;
        }
        meshes.insert(key, factors);
    }
    meshes
}

/// The body an offset frame is fixed to directly, and where it is there.
fn offset_on_body(components: &Components, frame: ComponentId) -> Option<(String, [f64; 3])> {
    let parent = components.connectee(frame, "parent", &["parent_frame"])?;
    let body =
        components.frame(frame, &parent)?.component.filter(|&found| components.tag(found) == "Body")?;
    let translation =
        components.doc(frame).triple(components.element(frame), "translation").unwrap_or([0.0; 3]);
    Some((components.name(body).into_owned(), translation))
}
