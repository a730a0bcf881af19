//! What a model says of its bodies and joints: read when somebody first asks for it, and the same after a change of its contacts alone.

use std::sync::OnceLock;

use crate::model::anatomy::bone_sizes::{ByBody, frame_offsets, mesh_factors};
use crate::model::anatomy::joints::Joints;
use crate::model::components::Components;
use crate::model::joint_distances::JointDistances;
use crate::model::made::Made;

/// What several who check or plan a change ask for.
#[derive(Debug, Default)]
pub(crate) struct BodyFacts {
    pub(crate) joints: Joints,
    mesh_factors: OnceLock<ByBody>,
    frame_offsets: OnceLock<ByBody>,
    distances: OnceLock<JointDistances>,
    /// What others made of them.
    pub(crate) made: Made,
}

impl BodyFacts {
    /// Factors of meshes.
    pub(crate) fn mesh_factors(&self, components: &Components) -> &ByBody {
        self.mesh_factors.get_or_init(|| mesh_factors(components))
    }

    /// Translations of frames.
    pub(crate) fn frame_offsets(&self, components: &Components) -> &ByBody {
        self.frame_offsets.get_or_init(|| frame_offsets(components))
    }

    /// How far apart the joints of each body are.
    pub(crate) fn joint_distances(&self, components: &Components) -> &JointDistances {
        self.distances.get_or_init(|| JointDistances::of_joints(self.joints.between_bodies(components)))
    }
}
