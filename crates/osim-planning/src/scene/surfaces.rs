//! The bones of all bodies, as surfaces.

use std::collections::HashSet;
use std::path::Path;

use osim_model::Model;
use osim_model::feet::{FeetFault, MeshFolders, attached_surface};
use osim_model::files::Files;
use serde::Serialize;

use super::rounded::rounded;

/// Triangles of all bones together: more is too slow to turn.
const MOST_TRIANGLES: usize = 600_000;

/// The bones of a model whose meshes are there.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Bones {
    /// Those that could be read.
    pub surfaces: Vec<BoneSurface>,
    /// Meshes that are not there, as the model spells them, each once.
    pub missing: Vec<String>,
    /// What is wrong with others.
    pub broken: Vec<String>,
}

/// The surface of a bone.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct BoneSurface {
    /// The body.
    pub body: String,
    /// The mesh, as the model spells it.
    pub mesh: String,
    /// x, y and z of one point after the other in the frame of the body, in hundredths of a millimetre.
    pub points: Vec<i32>,
    /// Three places among the points for each triangle.
    pub triangles: Vec<u32>,
}

impl Bones {
    /// The bones of `model`, which was read from `path`.
    #[must_use]
    pub fn of(model: &Model, path: &Path, files: &dyn Files) -> Self {
        let folders = MeshFolders::of_model(path);
        let mut bones = Self::default();
        let (mut count, mut known) = (0, HashSet::new());
        for attached in model.attached_meshes() {
            let (body, mesh) = (attached.body.clone(), attached.file.clone());
            match attached_surface(&attached, &folders, files) {
                Err(FeetFault::MeshMissing { .. }) => {
                    if known.insert(mesh.clone()) {
                        bones.missing.push(mesh);
                    }
                }
                Err(fault) => bones.broken.push(fault.phrase().to_string()),
                Ok(surface) => {
                    count += surface.triangles.len();
                    if count > MOST_TRIANGLES {
                        bones.broken.push(format!("{mesh}: left out, there are too many triangles to turn"));
                        continue;
                    }
                    let points = surface.points.iter().flatten().map(|&value| rounded(value)).collect();
                    let triangles = surface.triangles.concat();
                    bones.surfaces.push(BoneSurface { body, mesh, points, triangles });
                }
            }
        }
        bones
    }
}
