//! What a model's bones say about its size: mesh scale factors, joint offsets, and where its contact spheres are.

use std::collections::BTreeMap;

use super::LevelAxis;
use crate::document::Document;
use crate::error::Fault;
use crate::model::{Base, Files, MAX_FRAME_CHAIN, Model, ObjectId};
use crate::xml::ElementId;

/// Rotation of a frame in its body, row by row.
pub(crate) type Rotation = [[f64; 3]; 3];

const IDENTITY: Rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The part of a model that scaling changes (or should have changed), by body name.
#[derive(Debug, Clone, PartialEq)]
pub struct Anatomy {
    /// Names of the bodies, in file order.
    pub bodies: Vec<String>,
    /// Per body: mesh file (numbered where it repeats) and its scale factors.
    pub(super) meshes: BTreeMap<String, BTreeMap<String, [f64; 3]>>,
    /// Per body: translations of frames that are fixed to it, m, by the name of the joint or frame.
    pub(super) offsets: BTreeMap<String, BTreeMap<String, [f64; 3]>>,
    /// Contact spheres.
    pub spheres: Vec<AnatomySphere>,
}

/// A contact sphere and where it is.
#[derive(Debug, Clone, PartialEq)]
pub struct AnatomySphere {
    /// Name as in the file.
    pub name: String,
    /// Body that carries it; `None` is ground.
    pub body: Option<String>,
    /// Location of its centre in its frame, m.
    pub location_m: [f64; 3],
    /// Radius, m.
    pub radius_m: f64,
    /// Rotation of its frame in the body.
    pub(super) rotation: Rotation,
}

impl Anatomy {
    /// Reads the anatomy of `model`.
    ///
    /// # Errors
    /// A frame that leads nowhere, or a radius that cannot be scaled.
    pub fn of(model: &Model<'_, '_>) -> Result<Self, Fault> {
        let files = model.files();
        let bodies = model.bodies().iter().map(|body| body.name.clone()).collect();
        let mut anatomy =
            Self { bodies, meshes: BTreeMap::new(), offsets: BTreeMap::new(), spheres: Vec::new() };
        for (id, _) in files.objects.iter() {
            let tag = files.tag(id);
            if tag == "Body" {
                anatomy.read_meshes(files, id);
            } else if tag == "PhysicalOffsetFrame" {
                anatomy.read_frame(files, id);
            } else if tag.ends_with("Joint") {
                anatomy.read_joint(files, id);
                anatomy.read_old_joint(files, id);
            }
        }
        for sphere in &model.spheres {
            let radius_m = sphere
                .radius
                .checked()
                .map_err(|fault| fault.of(sphere.path.clone()).in_file(sphere.file))?;
            anatomy.spheres.push(AnatomySphere {
                name: sphere.name.clone(),
                body: sphere.body.clone(),
                location_m: sphere.location_m,
                radius_m,
                rotation: rotation_of(files, sphere.frame_object)?,
            });
        }
        Ok(anatomy)
    }

    fn read_meshes(&mut self, files: &Files<'_, '_>, body: ObjectId) {
        let document = files.doc(body);
        let tree = document.tree();
        let element = files.element(body);
        let name = files.name(body);
        let mut found = Vec::new();
        if let Some(attached) = tree.child(element, "attached_geometry") {
            for mesh in tree.children(attached).filter(|&mesh| tree.name(mesh) == "Mesh") {
                found.push((file_of(document, mesh, "mesh_file"), scale(document, mesh)));
            }
        }
        // Documents of version 3: every display geometry has its own factors, and the whole has some too.
        if let Some(visible) = tree.child(element, "VisibleObject") {
            let whole = scale(document, visible);
            let set = tree.child(visible, "GeometrySet").and_then(|set| tree.child(set, "objects"));
            for geometry in set.into_iter().flat_map(|set| tree.children(set)) {
                let own = scale(document, geometry);
                found.push((file_of(document, geometry, "geometry_file"), times(whole, own)));
            }
        }
        let meshes = self.meshes.entry(name).or_default();
        for (file, factors) in found {
            let mut key = file.clone();
            let mut count = 2;
            while meshes.contains_key(&key) {
                key = format!("{file} #{count}");
                count += 1;
            }
            meshes.insert(key, factors);
        }
    }

    /// An offset frame that is fixed to a body directly: OpenSim scales its translation by that body's factors.
    fn read_frame(&mut self, files: &Files<'_, '_>, frame: ObjectId) {
        let Some((body, translation)) = offset_on_body(files, frame) else { return };
        self.offsets.entry(body).or_default().insert(files.objects.path(frame), translation);
    }

    /// The same offsets under the joint's name, which a document of version 3 has too.
    fn read_joint(&mut self, files: &Files<'_, '_>, joint: ObjectId) {
        for end in ["parent", "child"] {
            let frame = files
                .connectee(joint, &format!("{end}_frame"), &[])
                .and_then(|frame| files.frame(joint, &frame))
                .and_then(|found| found.object)
                .filter(|&frame| files.tag(frame) == "PhysicalOffsetFrame");
            if let Some((body, translation)) = frame.and_then(|frame| offset_on_body(files, frame)) {
                let key = format!("{} {end}", files.name(joint));
                self.offsets.entry(body).or_default().insert(key, translation);
            }
        }
    }

    /// Documents of version 3: the joint inside the child body holds both translations.
    fn read_old_joint(&mut self, files: &Files<'_, '_>, joint: ObjectId) {
        let document = files.doc(joint);
        let element = files.element(joint);
        let owner = files.objects.get(joint).and_then(|object| object.parent);
        let Some(child) = owner.filter(|&id| files.tag(id) == "Body") else { return };
        let name = files.name(joint);
        if let Some(own) = document.triple(element, "location") {
            self.offsets.entry(files.name(child)).or_default().insert(format!("{name} child"), own);
        }
        let parent = files.connectee(joint, "parent_frame", &["parent_body"]);
        let parent = parent.and_then(|parent| files.frame(joint, &parent)).and_then(|found| found.object);
        if let (Some(parent), Some(there)) = (parent, document.triple(element, "location_in_parent")) {
            self.offsets.entry(files.name(parent)).or_default().insert(format!("{name} parent"), there);
        }
    }

    pub(super) fn sphere(&self, name: &str) -> Option<&AnatomySphere> {
        self.spheres.iter().find(|sphere| sphere.name == name)
    }
}

fn file_of(document: &Document<'_>, element: ElementId, tag: &str) -> String {
    let tree = document.tree();
    tree.child(element, tag).map(|file| tree.text_of(file)).unwrap_or_default()
}

/// Factors that are written but are no numbers stay visible as NaN: they must not pass for 1.
fn scale(document: &Document<'_>, element: ElementId) -> [f64; 3] {
    let missing = document.tree().child(element, "scale_factors").is_none();
    document.triple(element, "scale_factors").unwrap_or([if missing { 1.0 } else { f64::NAN }; 3])
}

/// The body an offset frame is fixed to directly, and where it is there.
fn offset_on_body(files: &Files<'_, '_>, frame: ObjectId) -> Option<(String, [f64; 3])> {
    let parent = files.connectee(frame, "parent", &["parent_frame"])?;
    let body = files.frame(frame, &parent)?.object.filter(|&found| files.tag(found) == "Body")?;
    let translation = files.doc(frame).triple(files.element(frame), "translation").unwrap_or([0.0; 3]);
    Some((files.name(body), translation))
}

fn times(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

/// Rotation of a frame in the body that carries it: the product along its chain of offset frames.
///
/// # Errors
/// A frame that leads nowhere.
pub(crate) fn rotation_of(files: &Files<'_, '_>, frame: Option<ObjectId>) -> Result<Rotation, Fault> {
    let mut rotation = IDENTITY;
    let mut at = frame;
    while let Some(id) = at {
        if !matches!(files.base(Some(id))?, Base::Body(_)) || files.tag(id) == "Body" {
            break;
        }
        let angles = files.doc(id).triple(files.element(id), "orientation").unwrap_or([0.0; 3]);
        rotation = product(body_fixed_xyz(angles), rotation);
        at = files
            .connectee(id, "parent", &["parent_frame"])
            .and_then(|parent| files.frame(id, &parent))
            .and_then(|found| found.object);
    }
    Ok(rotation)
}

impl Model<'_, '_> {
    /// The lowest point of sphere number `sphere` in the frame of the body that carries it (or of ground), m: its centre, less
    /// the radius along the body's axis that is nearest to −gravity, as when the body is not turned.
    ///
    /// `None` where the frame is in a file that was not given, a number is not finite or the radius not above 0.
    #[must_use]
    pub fn lowest_point_m(&self, sphere: usize) -> Option<[f64; 3]> {
        let sphere = self.spheres.get(sphere)?;
        if matches!(sphere.base, Base::Unknown) || !sphere.radius.property.allows(sphere.radius.number) {
            return None;
        }
        let mut point = self.in_body(sphere.frame_object, sphere.location_m)?;
        let up = LevelAxis::of_gravity(self.gravity_m_s2);
        point[up.axis] += if up.down { sphere.radius.number } else { -sphere.radius.number };
        point.iter().all(|value| value.is_finite()).then_some(point)
    }

    /// A point of a frame, seen from the body at the end of its chain of offset frames.
    fn in_body(&self, frame: Option<ObjectId>, point: [f64; 3]) -> Option<[f64; 3]> {
        let files = self.files();
        let (mut point, mut at) = (point, frame);
        // Chains that close on themselves were refused when the model was read.
        for _ in 0..=MAX_FRAME_CHAIN {
            let Some(id) = at.filter(|&id| files.tag(id) != "Body" && files.tag(id) != "Ground") else {
                return Some(point);
            };
            let of = |tag| files.doc(id).triple(files.element(id), tag).unwrap_or([0.0; 3]);
            let rotation = body_fixed_xyz(of("orientation"));
            let translation = of("translation");
            point = std::array::from_fn(|i| {
                translation[i] + (0..3).map(|k| rotation[i][k] * point[k]).sum::<f64>()
            });
            at = files
                .connectee(id, "parent", &["parent_frame"])
                .and_then(|parent| files.frame(id, &parent))
                .and_then(|found| found.object);
        }
        None
    }
}

/// OpenSim's `orientation`: body-fixed X, then Y, then Z angles, rad.
fn body_fixed_xyz([x, y, z]: [f64; 3]) -> Rotation {
    let (sx, cx) = (libm::sin(x), libm::cos(x));
    let (sy, cy) = (libm::sin(y), libm::cos(y));
    let (sz, cz) = (libm::sin(z), libm::cos(z));
    [
        [cy * cz, -cy * sz, sy],
        [cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -sx * cy],
        [sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy],
    ]
}

fn product(a: Rotation, b: Rotation) -> Rotation {
    let cell = |i: usize, j: usize| (0..3).map(|k| a[i][k] * b[k][j]).sum();
    std::array::from_fn(|i| std::array::from_fn(|j| cell(i, j)))
}

/// RᵀSR v: a scaling along the body's axes, seen from a frame turned by R.
pub(super) fn scaled_in_frame(rotation: &Rotation, factors: [f64; 3], vector: [f64; 3]) -> [f64; 3] {
    if *rotation == IDENTITY {
        return times(factors, vector);
    }
    let in_body: [f64; 3] = std::array::from_fn(|i| (0..3).map(|k| rotation[i][k] * vector[k]).sum());
    let scaled = times(factors, in_body);
    std::array::from_fn(|i| (0..3).map(|k| rotation[k][i] * scaled[k]).sum())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scaling_turns_with_the_frame() {
        // A quarter turn about z: the frame's x is the body's y.
        let quarter = body_fixed_xyz([0.0, 0.0, std::f64::consts::FRAC_PI_2]);
        let [x, y, z] = scaled_in_frame(&quarter, [2.0, 3.0, 5.0], [1.0, 1.0, 1.0]);
        assert!((x - 3.0).abs() < 1e-12 && (y - 2.0).abs() < 1e-12 && (z - 5.0).abs() < 1e-12);
        assert_eq!(scaled_in_frame(&IDENTITY, [2.0, 3.0, 5.0], [0.1, 1.0, 1.0]), [0.2, 3.0, 5.0]);
    }

    #[test]
    fn body_fixed_angles_follow_the_order_x_y_z() {
        // Rx(a) Ry(b) applied to the z axis: (sin b, -sin a cos b, cos a cos b).
        let (a, b) = (0.3_f64, 0.7_f64);
        let turned = body_fixed_xyz([a, b, 0.0]);
        for (i, expected) in [b.sin(), -a.sin() * b.cos(), a.cos() * b.cos()].into_iter().enumerate() {
            assert!((turned[i][2] - expected).abs() < 1e-15);
        }
    }
}
