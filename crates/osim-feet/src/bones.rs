//! The bones of a model's bodies.

use std::path::PathBuf;

use osim_model::files::Files;
use osim_model::{AttachedMesh, Model};

use crate::bone::Bone;
use crate::fault::FeetFault;
use crate::folders::MeshFolders;
use crate::mesh::{is_length, mesh_points};

/// All meshes that are attached to `bodies`, in the order of the bodies and in that of the file: their points in the bodies'
/// frames, with the model's scale factors and frames.
///
/// # Errors
/// A body that is not there or shows no mesh, a mesh that is missing or broken: each with the body, the mesh, and where it was
/// looked for.
pub fn bones(
    model: &Model,
    bodies: &[&str],
    folders: &MeshFolders,
    files: &dyn Files,
) -> Result<Vec<Bone>, FeetFault> {
    let attached = model.attached_meshes();
    let mut bones = Vec::new();
    for &body in bodies {
        if !model.bodies().iter().any(|known| known.name == body) {
            let bodies = model.bodies().iter().map(|known| known.name.clone()).collect();
            return Err(FeetFault::NoBody { body: body.to_owned(), bodies });
        }
        let before = bones.len();
        for mesh in attached.iter().filter(|mesh| mesh.body == body) {
            bones.push(bone(mesh, folders, files)?);
        }
        if bones.len() == before {
            return Err(FeetFault::NoMesh { body: body.to_owned() });
        }
    }
    Ok(bones)
}

/// The bone that one mesh shows.
pub(crate) fn bone(
    attached: &AttachedMesh,
    folders: &MeshFolders,
    files: &dyn Files,
) -> Result<Bone, FeetFault> {
    let (body, mesh, factors) = (attached.body.clone(), attached.file.clone(), attached.factors);
    if factors.iter().any(|factor| !is_length(*factor) || *factor == 0.0) {
        return Err(FeetFault::Factors { body, mesh, factors });
    }
    let Some((file, mirrored)) = folders.find(&mesh, files) else {
        let folders = folders.iter().map(PathBuf::from).collect();
        return Err(FeetFault::MeshMissing { body, mesh, folders });
    };
    let bytes = match files.read_included(&file) {
        Ok(bytes) => bytes,
        Err(fault) => return Err(FeetFault::Unreadable { body, mesh, file, fault }),
    };
    let side = if mirrored { -1.0 } else { 1.0 };
    match mesh_points(&file.to_string_lossy(), &bytes) {
        Ok(points) => {
            let points = points.into_iter().map(|[x, y, z]| attached.on_body([x, y, side * z])).collect();
            Ok(Bone { file, mirrored, ..Bone::new(body, mesh, points) })
        }
        Err(fault) => Err(FeetFault::Mesh { body, mesh, file, fault }),
    }
}
