//! Meshes of bones.

use osim_model::feet::mesh_points;

/// Bytes as each kind of mesh: its points are finite and not too many, or there is a reason that can be printed.
pub fn mesh(bytes: &[u8]) {
    for name in ["bone.vtp", "bone.stl", "bone.obj"] {
        match mesh_points(name, bytes) {
            Ok(points) => {
                assert!((4..=6_000_000).contains(&points.len()));
                assert!(points.iter().flatten().all(|value| value.is_finite()));
            }
            Err(fault) => assert!(!fault.to_string().is_empty()),
        }
    }
}
