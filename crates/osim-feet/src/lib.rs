//! What a model's feet look like: bones from meshes, where they stand, and spheres below them.
//!
//! [`bones`] reads the meshes that are attached to bodies, through [`Files`](osim_model::files::Files); [`DefaultPose`] says where
//! the bodies are in ground; [`soles`] lays spheres under the feet.
//!
//! # What it will not do
//!
//! It changes nothing and opens no file by itself. It poses nothing but the default pose, and knows no constraints but couplers.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod bone;
mod bones;
mod contact_plane;
mod couplers;
mod default_pose;
mod fault;
mod folders;
mod held;
mod joint_walk;
mod mesh;
mod movements;
mod odd_mesh;
mod pose_fault;
mod posed_unlike;
mod scene;
mod sole;
mod sphere_pairs;
mod standing;
mod tilted;
mod vector;
mod welds;

pub use bone::Bone;
pub use bones::{AttachedBones, attached_surface, bones};
pub use contact_plane::{ContactPlane, PlaneSurface, STEEPEST_RAD};
pub use couplers::{Coupler, Couplers, prescribed_function};
pub use default_pose::DefaultPose;
pub use fault::FeetFault;
pub use folders::MeshFolders;
pub use joint_walk::{Crossing, joint_walk};
pub use mesh::{MeshFault, Surface, mesh_points, mesh_surface};
pub use movements::{Freedom, Movements};
pub use odd_mesh::{OddMesh, odd_meshes, odd_size};
pub use pose_fault::PoseFault;
pub use scene::{
    FloorPlace, Foot, FootBodies, FootBone, FootFrame, FootJoint, FootSphere, ViewAxes, silhouette,
};
pub use sole::{Footprint, Sole, SoleRequest, SoleSphere, soles};
pub use sphere_pairs::{SpherePair, sphere_pairs};
pub use standing::{
    ByLaw, LEANING_RAD, LevelledSphere, Lift, NotLevelled, NotLifted, OverFloor, Rest, RestingSphere,
    Standing, levelled,
};
pub use tilted::Tilting;
pub use vector::{angle, dot};

/// The example of the README compiles.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
