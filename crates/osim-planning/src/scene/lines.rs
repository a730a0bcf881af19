//! Lines from joint to joint.

use osim_model::{Anatomy, Model};
use serde::Serialize;

/// A line on a body, from the joint above it to one below it, in the frame of the body, m.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct BodyLine {
    /// The body.
    pub body: String,
    /// Where the joint above is.
    pub from_m: [f64; 3],
    /// Where the joint below is.
    pub to_m: [f64; 3],
}

/// The lines of all bodies; none where the bodies cannot be read.
pub(super) fn lines(model: &Model) -> Vec<BodyLine> {
    let Ok(anatomy) = Anatomy::of(model) else { return Vec::new() };
    let line = |below: &osim_model::AnatomyJoint| {
        let above = anatomy.joint_above(&below.parent)?;
        let line = BodyLine { body: below.parent.clone(), from_m: above.in_child_m, to_m: below.in_parent_m };
        let is_finite = line.from_m.iter().chain(&line.to_m).all(|value| value.is_finite());
        (is_finite && line.from_m != line.to_m).then_some(line)
    };
    anatomy.joints.iter().filter_map(line).collect()
}
