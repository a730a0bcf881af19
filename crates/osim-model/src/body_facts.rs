//! What a model says of its bodies and joints: read when somebody first asks for it, and the same after a change of its contacts alone.

use std::sync::OnceLock;

use crate::anatomy::bone_sizes::{BoneSizes, bone_sizes};
use crate::anatomy::joints::Joints;
use crate::components::Components;
use crate::joint_distances::JointDistances;

/// What several who check or plan a change ask for.
#[derive(Debug, Default)]
pub(crate) struct BodyFacts {
    pub(crate) joints: Joints,
    bone_sizes: OnceLock<BoneSizes>,
    distances: OnceLock<JointDistances>,
}

impl BodyFacts {
    /// Factors of meshes and translations of frames.
    pub(crate) fn bone_sizes(&self, components: &Components) -> &BoneSizes {
        self.bone_sizes.get_or_init(|| bone_sizes(components))
    }

    /// How far apart the joints of each body are.
    pub(crate) fn joint_distances(&self, components: &Components) -> &JointDistances {
        self.distances.get_or_init(|| JointDistances::of_joints(self.joints.between_bodies(components)))
    }
}
