//! The meshes and shapes of bodies, and whether the sizes of bodies changed after the note was written.

use std::collections::{BTreeMap, BTreeSet};

use foldhash::{HashMap, HashMapExt};
use glam::DVec3;

use crate::model::anatomy::bone_sizes::{FIRST_VERSION_WITH_GEOMETRY_SETS, mesh_file, mesh_scale};
use crate::model::anatomy::joints::placement_on_base;
use crate::model::placement::{Placement, six_digits};
use crate::model::{BodySize, ComponentId, Components, Document, Model, Note, Sphere, moving_spheres};
use crate::xml::{ElementId, opensim_text};

/// The first document version with `<attached_geometry>`. Older documents have a `<VisibleObject>`, whose numbers OpenSim rounds when it
/// converts them.
const FIRST_VERSION_WITH_ATTACHED_GEOMETRY: u32 = 30502;
/// The last document version in which OpenSim also reads the list `<geometry>`.
const LAST_WITH_GEOMETRY_LIST: u32 = 30505;

/// A mesh file that is attached to a body, with its scale factors and placement.
#[derive(Debug, Clone, PartialEq)]
pub struct AttachedMesh {
    pub body: String,
    pub file: String,
    /// Scale factors along x, y and z of the mesh; NaN if they are not numbers.
    pub factors: [f64; 3],
    /// The placement of the scaled mesh on the body.
    pub placement: Placement,
}

impl AttachedMesh {
    /// Converts a point of the mesh file to a scaled point on the body, m.
    pub fn on_body(&self, point: [f64; 3]) -> DVec3 {
        self.placement.point(DVec3::from(self.factors) * DVec3::from(point))
    }
}

impl Model {
    /// The mesh files that are attached to bodies or to frames on bodies, in file order. Meshes on ground and shapes without a file are
    /// left out.
    pub fn attached_meshes(&self) -> Vec<AttachedMesh> {
        let components = self.components();
        let frames = components.tree.iter().filter(|(id, _)| {
            let tag = components.tag(*id);
            tag == "Body" || tag == "PhysicalOffsetFrame"
        });
        let meshes_of_frame = |(id, _)| {
            let (body, placement) = placement_on_base(components, Some(id))?;
            let body = components.name(body?).into_owned();
            let attached = attached_meshes(components, id).into_iter().filter(|(file, ..)| !file.is_empty());
            Some(attached.map(move |(file, factors, inner)| AttachedMesh {
                body: body.clone(),
                file,
                factors,
                placement: placement.then(&inner),
            }))
        };
        frames.filter_map(meshes_of_frame).flatten().collect()
    }
}

type FileFactorsPlacement = (String, [f64; 3], Placement);

/// The mesh files that are attached to one frame, with their scale factors and their placements in the frame.
fn attached_meshes(components: &Components, frame: ComponentId) -> Vec<FileFactorsPlacement> {
    let document = components.document_of(frame);
    let element = components.element(frame);
    match document.version() {
        version if version < FIRST_VERSION_WITH_GEOMETRY_SETS => meshes_of_file_list(document, element),
        version if version < FIRST_VERSION_WITH_ATTACHED_GEOMETRY => {
            meshes_of_geometry_set(document, element)
        }
        _ => meshes_of_attached_geometry(document, element),
    }
}

fn meshes_of_attached_geometry(document: &Document, frame: ElementId) -> Vec<FileFactorsPlacement> {
    let tree = document.tree();
    let early =
        || (document.version() <= LAST_WITH_GEOMETRY_LIST).then(|| tree.child(frame, "geometry")).flatten();
    let list = tree.child(frame, "attached_geometry").or_else(early);
    let meshes = list.into_iter().flat_map(|list| tree.children(list));
    let meshes = meshes.filter(|&mesh| tree.name(mesh) == "Mesh");
    meshes
        .map(|mesh| (mesh_file(document, mesh, "mesh_file"), mesh_scale(document, mesh), Placement::IDENTITY))
        .collect()
}

fn meshes_of_geometry_set(document: &Document, body: ElementId) -> Vec<FileFactorsPlacement> {
    let tree = document.tree();
    let Some(visible) = tree.child(body, "VisibleObject") else { return Vec::new() };
    let set = tree.child(visible, "GeometrySet").and_then(|set| tree.child(set, "objects"));
    let geometries = set.into_iter().flat_map(|set| tree.children(set));
    let common = (mesh_scale(document, visible), mesh_placement(document, visible));
    geometries
        .filter(|&geometry| tree.name(geometry) == "DisplayGeometry")
        .map(|geometry| {
            let factors = DVec3::from(common.0) * DVec3::from(mesh_scale(document, geometry));
            let placement = common.1.then(&mesh_placement(document, geometry)).in_six_digits();
            (mesh_file(document, geometry, "geometry_file"), factors.to_array().map(six_digits), placement)
        })
        .collect()
}

/// The mesh files in `<geometry_files>`. OpenSim ignores the `<transform>` for these.
fn meshes_of_file_list(document: &Document, body: ElementId) -> Vec<FileFactorsPlacement> {
    let tree = document.tree();
    let Some(visible) = tree.child(body, "VisibleObject") else { return Vec::new() };
    let names = mesh_file(document, visible, "geometry_files");
    let factors = mesh_scale(document, visible).map(six_digits);
    opensim_text::list_words(&names).map(|name| (name.to_owned(), factors, Placement::IDENTITY)).collect()
}

/// The placement that `<transform>` gives: body-fixed angles about x, y and z (rad), and a translation (m).
fn mesh_placement(document: &Document, element: ElementId) -> Placement {
    let tree = document.tree();
    let text = tree.child(element, "transform").map(|child| tree.text_of(child)).unwrap_or_default();
    match opensim_text::numbers(&text).as_deref() {
        Some([a, b, c, x, y, z]) => Placement::from_triples([*a, *b, *c], [*x, *y, *z]),
        _ => Placement::IDENTITY,
    }
}

/// How far a body reaches: where its mass and its joints are. Meshes have no part in it.
#[derive(Debug, Clone, Default)]
pub struct BodyShape {
    /// The centre of mass of the body, m.
    pub centre_m: DVec3,
    /// The root mean square distance of the body's mass from its centre of mass, m: √(½ trace(I)/m). `None` if mass or inertia is not above
    /// 0.
    pub gyration_m: Option<f64>,
    /// The inertia about the centre of mass, kg m²: Ixx, Iyy, Izz, and Ixy, Ixz, Iyz, which are 0 where the file has none; `None` if it
    /// cannot be read.
    pub inertia_kg_m2: Option<[f64; 6]>,
    /// The places of the body's joints, including joints to ground, m.
    pub joints_m: Vec<DVec3>,
}

impl Model {
    /// Where the mass and the joints of each body are, by the name of the body.
    pub fn body_shapes(&self) -> &HashMap<String, BodyShape> {
        self.derived_from_bodies(BodyShape::all)
    }
}

impl BodyShape {
    /// The shapes of all bodies of `model`, by name.
    fn all(model: &Model) -> HashMap<String, Self> {
        let components = model.components();
        let mut shapes: HashMap<String, Self> = HashMap::new();
        for (id, _) in components.tree.iter().filter(|(id, _)| components.tag(*id) == "Body") {
            shapes.entry(components.name(id).into_owned()).or_insert_with(|| shape_of(components, id));
        }
        for (body, place_m) in model.body_facts.joints.places_on_bodies(components) {
            if let Some(shape) = shapes.get_mut(body) {
                shape.joints_m.push(place_m);
            }
        }
        shapes
    }
}

fn shape_of(components: &Components, body: ComponentId) -> BodyShape {
    let centre_m = components.document_of(body).triple(components.element(body), "mass_center");
    let inertia_kg_m2 = inertia_kg_m2(components, body);
    let gyration_m = number_of_element(components, body, "mass")
        .zip(inertia_kg_m2)
        .map(|(mass, [xx, yy, zz, ..])| ((xx + yy + zz) / 2.0 / mass).sqrt());
    let gyration_m = gyration_m.filter(|radius| radius.is_finite() && *radius > 0.0);
    BodyShape {
        centre_m: centre_m.unwrap_or_default().into(),
        gyration_m,
        inertia_kg_m2,
        joints_m: Vec::new(),
    }
}

/// The inertia of a body as [`BodyShape`] has it. Documents before version 4 have its numbers in separate elements.
pub(crate) fn inertia_kg_m2(components: &Components, body: ComponentId) -> Option<[f64; 6]> {
    let numbers = numbers_of_element(components, body, "inertia").filter(|numbers| numbers.len() >= 3);
    let number = |(place, tag): (usize, &str)| match &numbers {
        Some(numbers) => numbers.get(place).copied(),
        None => number_of_element(components, body, tag),
    };
    let [xx, yy, zz] = [(0, "inertia_xx"), (1, "inertia_yy"), (2, "inertia_zz")].map(number);
    let [xy, xz, yz] = [(3, "inertia_xy"), (4, "inertia_xz"), (5, "inertia_yz")].map(number);
    Some([xx?, yy?, zz?, xy.unwrap_or(0.0), xz.unwrap_or(0.0), yz.unwrap_or(0.0)])
}

fn number_of_element(components: &Components, body: ComponentId, tag: &str) -> Option<f64> {
    numbers_of_element(components, body, tag)?.first().copied()
}

fn numbers_of_element(components: &Components, body: ComponentId, tag: &str) -> Option<Vec<f64>> {
    let tree = components.document_of(body).tree();
    opensim_text::numbers(&tree.text_of(tree.child(components.element(body), tag)?))
}

// How large the bones are: mesh scale factors of the bodies that carry contact spheres.

/// Two places are equal if they differ by at most this, m.
const SAME_PLACE_M: f64 = 1e-9;
/// Two scale factors are equal if they differ by at most this (relative).
const EQUAL_FACTORS_TOLERANCE: f64 = 1e-6;

impl BodySize {
    pub(crate) fn is_as_large_as(&self, other: &Self) -> bool {
        let close = |(a, b): (f64, f64)| (a - b).abs() <= EQUAL_FACTORS_TOLERANCE * b.abs();
        self.factors.into_iter().zip(other.factors).all(close)
    }
}

/// The change of body sizes after the note was written, while the spheres stayed at their places: from [`Model::scaled_since_note`].
#[derive(Debug, Clone, PartialEq)]
pub struct ScaledSinceNote {
    /// The present mesh factors over those in the note, along x, y and z, by body. Exactly 1 if they are equal.
    pub factors: BTreeMap<String, [f64; 3]>,
    /// Whether a body with a sphere changed its size, so that the sphere is now at a wrong place.
    pub spheres_left_behind: bool,
}

impl ScaledSinceNote {
    /// Whether the factors of every body that carries spheres of `model` are known.
    pub fn has_all_carriers(&self, model: &Model) -> bool {
        let carriers = model.loaded_spheres(&model.force_ids());
        let mut bodies = carriers.iter().filter_map(|&id| model.sphere(id)?.body.as_ref());
        bodies.all(|body| self.factors.contains_key(body))
    }
}

impl Model {
    /// How OpenSim scaled the bodies with spheres after the note was written. Only the note is needed for this. `None` if the note has no
    /// sizes, or spheres were moved later.
    pub fn scaled_since_note(&self) -> Option<ScaledSinceNote> {
        let note = self.note.as_ref().filter(|note| !note.sizes.is_empty())?;
        if self.has_places_of(note) != Some(true) {
            return None;
        }
        let now = self.body_sizes();
        let now: BTreeMap<&str, &BodySize> = now.iter().map(|size| (size.body.as_str(), size)).collect();
        let ratios = note.sizes.iter().filter_map(|then| {
            let now = now.get(then.body.as_str())?;
            let ratio = std::array::from_fn(|axis| now.factors[axis] / then.factors[axis]);
            let factors = if now.is_as_large_as(then) { [1.0; 3] } else { ratio };
            Some((now.body.clone(), factors))
        });
        let factors: BTreeMap<String, [f64; 3]> = ratios.collect();
        let spheres_left_behind = moving_spheres(self, &self.force_ids()).into_iter().any(|id| {
            let Some(sphere) = self.sphere(id) else { return false };
            let factors = sphere.body.as_ref().and_then(|body| factors.get(body));
            factors.is_some_and(|factors| self.belongs_elsewhere(sphere, *factors))
        });
        Some(ScaledSinceNote { factors, spheres_left_behind })
    }

    /// Whether the mesh factors of a body with spheres differ from those in `note`.
    pub(crate) fn bodies_have_other_sizes(&self, note: &Note) -> bool {
        let now = self.body_sizes();
        let same_body = |then: &BodySize| now.iter().find(|size| size.body == then.body);
        note.sizes.iter().any(|then| same_body(then).is_some_and(|now| !now.is_as_large_as(then)))
    }

    /// Whether scaling by `factors` of the body changes the right place of the sphere.
    fn belongs_elsewhere(&self, sphere: &Sphere, factors: [f64; 3]) -> bool {
        let Ok(rotation) = self.rotation_of(sphere) else { return false };
        let there = rotation.scaled_in_frame(factors, sphere.location_m);
        there.into_iter().zip(sphere.location_m).any(|(there, here)| (there - here).abs() > SAME_PLACE_M)
    }

    /// Mesh scale factors of the bodies that carry moving contact spheres, by name. Bodies without meshes, or with a name that a note
    /// cannot hold, are left out. If a body has several meshes, the first name in alphabetical order counts.
    pub fn body_sizes(&self) -> Vec<BodySize> {
        let spheres = moving_spheres(self, &self.force_ids()).into_iter();
        let carrying: BTreeSet<&str> = spheres
            .filter_map(|sphere| self.sphere(sphere)?.body.as_deref())
            .filter(|name| BodySize::can_name(name))
            .collect();
        let meshes = self.body_facts.mesh_factors(self.components());
        let size = |body: &str| {
            let factors = *meshes.get(body)?.values().next()?;
            factors
                .iter()
                .all(|factor| factor.is_finite() && *factor > 0.0)
                .then(|| BodySize { body: body.to_owned(), factors })
        };
        carrying.into_iter().filter_map(size).collect()
    }
}
