//! What a model says of its joints.

use std::collections::HashMap;

use super::joints::ModelJoint;
use super::speeds::Speeds;
use crate::model::reference_frame::{MovingPlacement, Placement};
use crate::model::typed_model::Model;

impl Model {
    /// All joints whose frames lead to bodies or to ground, in file order, without those that OpenSim ignores. Frames of joints in
    /// bodies are as OpenSim converts them, with six digits.
    #[must_use]
    pub fn joints(&self) -> &[ModelJoint] {
        self.body_facts.joints.converted(self.components(), self.skeleton().ignored_joints())
    }

    /// For the name of each coordinate, whether it is an angle (else it is a length); `None` where it is neither. Of several of one
    /// name the first counts.
    #[must_use]
    pub fn turning_coordinates(&self) -> HashMap<&str, Option<bool>> {
        let mut found = HashMap::new();
        for joint in self.joints() {
            let motion = joint.motion(self.components());
            for (index, coordinate) in joint.coordinates.iter().enumerate() {
                let turns = || motion.and_then(|motion| motion.turns(index));
                found.entry(coordinate.name.as_str()).or_insert_with(turns);
            }
        }
        found
    }
}

impl ModelJoint {
    /// The child's frame in the parent's where the coordinates have these `values` (rad, m; 0 where there are fewer); `None`
    /// where a function of the joint, or the joint itself, is not understood.
    #[must_use]
    pub fn placement(&self, model: &Model, values: &[f64]) -> Option<Placement> {
        self.placed(model.components(), values)
    }

    /// The same while its coordinates change with these `speeds`.
    #[must_use]
    pub fn moving(&self, model: &Model, values: &[f64], speeds: Speeds<'_>) -> Option<MovingPlacement> {
        self.moved(model.components(), values, speeds)
    }

    /// Whether the coordinate number `index` of a CustomJoint turns about an axis by its own value (else it shifts along one); `None`
    /// where it is neither an angle nor a length.
    #[must_use]
    pub fn pure_axis(&self, model: &Model, index: usize) -> Option<bool> {
        self.motion(model.components())?.pure_axis(index)
    }
}
