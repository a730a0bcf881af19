//! What a model says of its joints.

use std::collections::HashSet;

use super::joints::ModelJoint;
use crate::components::ComponentId;
use crate::model::Model;
use crate::reference_frame::Placement;

impl Model {
    /// All joints whose frames lead to bodies or to ground, in file order, without those that OpenSim ignores. Frames of joints in
    /// bodies are as OpenSim converts them, with six digits.
    #[must_use]
    pub fn joints(&self) -> Vec<ModelJoint> {
        let ignored: HashSet<&ComponentId> = self.skeleton().ignored_joints.iter().collect();
        let found = self.joints.read(self.components()).iter().filter(|(id, _)| !ignored.contains(id));
        found.map(|(_, joint)| joint.clone().converted()).collect()
    }
}

impl ModelJoint {
    /// The child's frame in the parent's where the coordinates have these `values` (rad, m; 0 where there are fewer); `None`
    /// where a function of the joint, or the joint itself, is not understood.
    #[must_use]
    pub fn placement(&self, model: &Model, values: &[f64]) -> Option<Placement> {
        self.placed(model.file(self.file), values)
    }
}
