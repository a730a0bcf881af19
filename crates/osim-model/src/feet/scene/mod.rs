//! What stands where in a foot: joints, bones, spheres and the floor, as a picture of it needs them.
//!
//! [`FootBodies::find`] says which bodies make feet, [`Foot::all`] where everything on them is at the default pose.

mod axes;
mod bodies;
mod floor;
mod foot;
mod silhouette;
mod tree;

pub use axes::ViewAxes;
pub use bodies::FootBodies;
pub use floor::FloorPlace;
pub use foot::{Foot, FootBone, FootFrame, FootJoint, FootSphere};
pub use silhouette::silhouette;
