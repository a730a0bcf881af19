//! Mesh files and where they are on their bodies, in the spelling of every document version.

use crate::xml::{ElementId, opensim_text};

use super::joints::on_base;
use super::mesh_elements::{GEOMETRY_SETS, file_of, scale};
use crate::model::components::{ComponentId, Components};
use crate::model::document::Document;
use crate::model::reference_frame::{Placement, six_digits, times};
use crate::model::typed_model::Model;

/// Documents before this version have a `<VisibleObject>`; OpenSim rounds its numbers as it converts them.
const GEOMETRY: u32 = 30502;
/// From then on, OpenSim reads no list of this name.
const LAST_GEOMETRY: u32 = 30505;

/// A mesh file that is attached to a body.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct AttachedMesh {
    /// Name of the body.
    pub body: String,
    /// The file, as the model spells it.
    pub file: String,
    /// Scale factors of its points along their own x, y and z; NaN where they are not numbers.
    pub factors: [f64; 3],
    /// The frame of its scaled points, on the body.
    pub placement: Placement,
}

impl AttachedMesh {
    /// A point of the file on the body, m.
    #[must_use]
    pub fn on_body(&self, point: [f64; 3]) -> [f64; 3] {
        self.placement.point(times(self.factors, point))
    }
}

impl Model {
    /// Mesh files that are attached to bodies or to frames on them, in file order; those on ground are left out, and geometry
    /// that has no file.
    #[must_use]
    pub fn attached_meshes(&self) -> Vec<AttachedMesh> {
        let components = self.components();
        let frames = components.tree.iter().filter(|(id, _)| {
            let tag = components.tag(*id);
            tag == "Body" || tag == "PhysicalOffsetFrame"
        });
        let of_frame = |(id, _)| {
            let (body, placement) = on_base(components, Some(id))?;
            let body = components.name(body?).into_owned();
            let attached = read(components, id).into_iter().filter(|(file, ..)| !file.is_empty());
            Some(attached.map(move |(file, factors, inner)| AttachedMesh {
                body: body.clone(),
                file,
                factors,
                placement: placement.then(&inner),
            }))
        };
        frames.filter_map(of_frame).flatten().collect()
    }
}

type Attached = (String, [f64; 3], Placement);

/// Files that are attached to one frame, with factors and where they are in it.
fn read(components: &Components, frame: ComponentId) -> Vec<Attached> {
    let document = components.doc(frame);
    let element = components.element(frame);
    match document.version() {
        version if version < GEOMETRY_SETS => of_list(document, element),
        version if version < GEOMETRY => of_set(document, element),
        _ => of_meshes(document, element),
    }
}

fn of_meshes(document: &Document, frame: ElementId) -> Vec<Attached> {
    let tree = document.tree();
    let early = || (document.version() <= LAST_GEOMETRY).then(|| tree.child(frame, "geometry")).flatten();
    let list = tree.child(frame, "attached_geometry").or_else(early);
    let meshes = list.into_iter().flat_map(|list| tree.children(list));
    let meshes = meshes.filter(|&mesh| tree.name(mesh) == "Mesh");
    meshes
        .map(|mesh| (file_of(document, mesh, "mesh_file"), scale(document, mesh), Placement::IDENTITY))
        .collect()
}

fn of_set(document: &Document, body: ElementId) -> Vec<Attached> {
    let tree = document.tree();
    let Some(visible) = tree.child(body, "VisibleObject") else { return Vec::new() };
    let set = tree.child(visible, "GeometrySet").and_then(|set| tree.child(set, "objects"));
    let geometries = set.into_iter().flat_map(|set| tree.children(set));
    let whole = (scale(document, visible), transform(document, visible));
    geometries
        .filter(|&geometry| tree.name(geometry) == "DisplayGeometry")
        .map(|geometry| {
            let factors = times(whole.0, scale(document, geometry)).map(six_digits);
            let placement = whole.1.then(&transform(document, geometry)).in_six_digits();
            (file_of(document, geometry, "geometry_file"), factors, placement)
        })
        .collect()
}

/// A list of names; the transform does not count there.
fn of_list(document: &Document, body: ElementId) -> Vec<Attached> {
    let tree = document.tree();
    let Some(visible) = tree.child(body, "VisibleObject") else { return Vec::new() };
    let names = file_of(document, visible, "geometry_files");
    let factors = scale(document, visible).map(six_digits);
    opensim_text::list(&names).map(|name| (name.to_owned(), factors, Placement::IDENTITY)).collect()
}

/// Six numbers: body-fixed angles about x, y and z (rad), and a translation (m).
fn transform(document: &Document, element: ElementId) -> Placement {
    let tree = document.tree();
    let text = tree.child(element, "transform").map(|child| tree.text_of(child)).unwrap_or_default();
    match opensim_text::numbers(&text).as_deref() {
        Some([a, b, c, x, y, z]) => Placement::of_triples([*a, *b, *c], [*x, *y, *z]),
        _ => Placement::IDENTITY,
    }
}
