//! The feet of a model: bones from mesh files, the default pose, and contact spheres under the soles.
//!
//! [`bones`] reads the meshes that are attached to bodies, through [`Files`](crate::model::files::Files). [`DefaultPose`] gives the places
//! of the bodies in ground. [`soles`] places spheres under the feet.
//!
//! ```
//! use std::path::Path;
//! use osim_model::feet::{MeshFolders, SoleRequest, bones, soles};
//! use osim_model::Model;
//! use osim_model::files::InMemory;
//!
//! fn main() -> Result<(), osim_model::feet::FeetFault> {
//!     let model = r#"<OpenSimDocument Version="40000"><Model><gravity>0 -9.81 0</gravity><BodySet><objects><Body name="foot">
//!         <mass>1</mass><attached_geometry><Mesh><mesh_file>foot.obj</mesh_file></Mesh></attached_geometry></Body></objects></BodySet>
//!         <JointSet><objects><WeldJoint name="j"><socket_parent_frame>/ground</socket_parent_frame>
//!         <socket_child_frame>/bodyset/foot</socket_child_frame></WeldJoint></objects></JointSet></Model></OpenSimDocument>"#;
//!     let mesh = "v 0 0 0\nv 0.2 0 0.05\nv 0.2 0 -0.05\nv 0 0.1 0\n";
//!
//!     let model = Model::parse(model)?;
//!     let files = InMemory::from_iter([("Geometry/foot.obj", mesh)]);
//!     let bones = bones(&model, &["foot"], &MeshFolders::of_model(Path::new("walker.osim")), &files)?;
//!     let soles = soles(&model, &bones, &SoleRequest { count: 3, radius_m: 0.03, pad_m: 0.01 })?;
//!     // 1 cm below the bone, which is at 0.
//!     assert_eq!(soles[0].height_m, -0.01);
//!     assert!(soles[0].spheres.iter().all(|sphere| (sphere.centre_m[1] - 0.02).abs() < 1e-12));
//!     Ok(())
//! }
//! ```
//!
//! # What it will not do
//!
//! This module changes nothing and opens no file by itself. It computes the default pose only, and supports no constraints except couplers.

mod bones;
mod contact_planes;
mod convex_hull;
mod default_pose;
mod fault;
mod foot;
mod mesh;
mod movements;
mod sole;
mod standing;

pub use crate::model::angle_between;
pub use bones::{AttachedBones, Bone, MeshFolders, OddMesh, attached_surface, bones, odd_meshes, odd_size};
pub use contact_planes::{ContactPlane, PairsOfForce, PlaneSurface, STEEPEST_FLOOR_RAD};
pub use default_pose::{DefaultPose, JointStep, joints_from_ground, placement_at_default_pose};
pub use fault::{FeetFault, PoseFault};
pub use foot::{
    FloorPlace, Foot, FootBodies, FootBone, FootFrame, FootJoint, FootSphere, ViewAxes, silhouette,
};
pub use mesh::{MeshFault, MeshSurface, mesh_points, mesh_surface};
pub use movements::{Coupler, Couplers, Mobility, Movements, prescribed_function};
pub use sole::{Footprint, Sole, SoleRequest, SoleSphere, TiltingCoordinate, soles};
pub use standing::{
    LevelledSphere, LiftingCoordinate, MOST_LEAN_RAD, NotLevelled, NotLifted, RestLaw, RestOnFloor,
    RestingSphere, SphereOverFloor, Standing, held_roots, levelled_spheres,
};
