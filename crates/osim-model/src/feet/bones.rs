//! The bones of a model's bodies.

use std::path::PathBuf;

use crate::model::files::Files;
use crate::model::{AttachedMesh, Model};
use foldhash::HashMap;

use crate::feet::bone::Bone;
use crate::feet::fault::FeetFault;
use crate::feet::folders::MeshFolders;
use crate::feet::mesh::{Surface, is_length, mesh_points, mesh_surface};

/// The meshes that are attached to the bodies of a model, by body: read once for all of them.
pub struct AttachedBones<'m> {
    model: &'m Model,
    attached: HashMap<&'m str, Vec<AttachedMesh>>,
}

impl<'m> AttachedBones<'m> {
    /// Those of `model`.
    #[must_use]
    pub fn of(model: &'m Model) -> Self {
        let bodies = model.bodies().iter().map(|body| (body.name.as_str(), Vec::new()));
        let mut attached: HashMap<&str, Vec<AttachedMesh>> = bodies.collect();
        for mesh in model.attached_meshes() {
            if let Some(of_body) = attached.get_mut(mesh.body.as_str()) {
                of_body.push(mesh);
            }
        }
        Self { model, attached }
    }

    /// The bones of `body` in the order of the file: their points in its frame, with the model's scale factors and frames.
    ///
    /// # Errors
    /// A body that is not there or shows no mesh, a mesh that is missing or broken: each with the body, the mesh, and where it was
    /// looked for.
    pub fn bones(
        &self,
        body: &str,
        folders: &MeshFolders,
        files: &dyn Files,
    ) -> Result<Vec<Bone>, FeetFault> {
        let Some(meshes) = self.attached.get(body) else {
            let bodies = self.model.bodies().iter().map(|known| known.name.clone()).collect();
            return Err(FeetFault::NoBody { body: body.to_owned(), bodies });
        };
        if meshes.is_empty() {
            return Err(FeetFault::NoMesh { body: body.to_owned() });
        }
        meshes.iter().map(|mesh| bone(mesh, folders, files)).collect()
    }
}

/// The same of several bodies, in their order.
///
/// # Errors
/// Those of [`AttachedBones::bones`].
pub fn bones(
    model: &Model,
    bodies: &[&str],
    folders: &MeshFolders,
    files: &dyn Files,
) -> Result<Vec<Bone>, FeetFault> {
    let attached = AttachedBones::of(model);
    let mut all = Vec::new();
    for body in bodies {
        all.extend(attached.bones(body, folders, files)?);
    }
    Ok(all)
}

/// The bone that one mesh shows.
pub(crate) fn bone(
    attached: &AttachedMesh,
    folders: &MeshFolders,
    files: &dyn Files,
) -> Result<Bone, FeetFault> {
    let (body, mesh) = (attached.body.clone(), attached.file.clone());
    let MeshFile { file, mirrored, bytes } = mesh_file(attached, folders, files)?;
    match mesh_points(&file.to_string_lossy(), &bytes) {
        Ok(points) => {
            let points = points.into_iter().map(|point| on_body(attached, mirrored, point)).collect();
            Ok(Bone { file, mirrored, ..Bone::new(body, mesh, points) })
        }
        Err(fault) => Err(FeetFault::Mesh { body, mesh, file, fault }),
    }
}

/// The surface that one mesh shows, its points on the body, m.
///
/// # Errors
/// Those of [`AttachedBones::bones`], but for what only outlines need.
pub fn attached_surface(
    attached: &AttachedMesh,
    folders: &MeshFolders,
    files: &dyn Files,
) -> Result<Surface, FeetFault> {
    let MeshFile { file, mirrored, bytes } = mesh_file(attached, folders, files)?;
    let fault = |fault| FeetFault::Mesh {
        body: attached.body.clone(),
        mesh: attached.file.clone(),
        file: file.clone(),
        fault,
    };
    let mut surface = mesh_surface(&file.to_string_lossy(), &bytes).map_err(fault)?;
    surface.points.iter_mut().for_each(|point| *point = on_body(attached, mirrored, *point));
    Ok(surface)
}

fn on_body(attached: &AttachedMesh, mirrored: bool, [x, y, z]: [f64; 3]) -> [f64; 3] {
    attached.on_body([x, y, if mirrored { -z } else { z }])
}

/// The file of a mesh.
struct MeshFile {
    file: PathBuf,
    mirrored: bool,
    bytes: Vec<u8>,
}

fn mesh_file(
    attached: &AttachedMesh,
    folders: &MeshFolders,
    files: &dyn Files,
) -> Result<MeshFile, FeetFault> {
    let (body, mesh, factors) = (attached.body.clone(), attached.file.clone(), attached.factors);
    if factors.iter().any(|factor| !is_length(*factor) || *factor == 0.0) {
        return Err(FeetFault::Factors { body, mesh, factors });
    }
    let Some((file, mirrored)) = folders.find(&mesh, files) else {
        let folders = folders.iter().map(PathBuf::from).collect();
        return Err(FeetFault::MeshMissing { body, mesh, folders });
    };
    match files.read_included(&file) {
        Ok(bytes) => Ok(MeshFile { file, mirrored, bytes }),
        Err(fault) => Err(FeetFault::Unreadable { body, mesh, file, fault }),
    }
}
