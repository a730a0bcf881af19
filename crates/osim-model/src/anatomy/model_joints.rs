//! What a model says of its joints.

use super::joints::ModelJoint;
use crate::model::Model;
use crate::reference_frame::Placement;

impl Model {
    /// All joints whose frames lead to bodies or to ground, in file order, without those that OpenSim ignores. Frames of joints in
    /// bodies are as OpenSim converts them, with six digits.
    #[must_use]
    pub fn joints(&self) -> &[ModelJoint] {
        self.body_facts.joints.converted(self.components(), &self.skeleton().ignored_joints)
    }
}

impl ModelJoint {
    /// The child's frame in the parent's where the coordinates have these `values` (rad, m; 0 where there are fewer); `None`
    /// where a function of the joint, or the joint itself, is not understood.
    #[must_use]
    pub fn placement(&self, model: &Model, values: &[f64]) -> Option<Placement> {
        self.placed(model.components(), values)
    }
}
