//! The joints of a body to those that hang on it, and where they are in it.

use crate::components::Base;
use crate::model::Model;

/// A joint between two bodies.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct JointOffset {
    /// Name of the joint.
    pub name: String,
    /// Name of the body that carries the other one.
    pub parent: String,
    /// Name of the body that hangs on it.
    pub child: String,
    /// Where the joint is in the parent's frame, m.
    pub in_parent_m: [f64; 3],
    /// Where it is in the child's frame, m.
    pub in_child_m: [f64; 3],
}

impl Model {
    /// The joints between bodies, in file order, in the spelling of every document version. One whose frames lead nowhere
    /// is left out.
    ///
    /// ```
    /// # let text = include_str!("../tests/data/one_foot.osim");
    /// let model = osim_model::Model::parse(text)?;
    /// // Its only joint is to the ground.
    /// assert!(model.joint_offsets().is_empty());
    /// # Ok::<(), osim_model::Fault>(())
    /// ```
    #[must_use]
    pub fn joint_offsets(&self) -> Vec<JointOffset> {
        let components = self.components();
        let joints = components.tree.iter().filter(|(id, _)| components.tag(*id).ends_with("Joint"));
        joints
            .filter_map(|(joint, component)| {
                let frame = |socket: &str, legacy: &str| {
                    let connectee = components.connectee(joint, socket, &[legacy])?;
                    components.frame(joint, &connectee)?.component
                };
                // Documents of version 3 have the joint inside the child, and both places in the joint.
                let own = |tag| components.doc(joint).triple(components.element(joint), tag);
                let parent = frame("parent_frame", "parent_body").or_else(|| frame("parent_body", ""))?;
                let owner = component.parent.filter(|&id| components.tag(id) == "Body");
                let child =
                    frame("child_frame", "child_body").or_else(|| frame("child_body", "")).or(owner)?;
                let body = |frame| match components.base(Some(frame)) {
                    Ok(Base::Body(body)) => Some(components.name(body)),
                    _ => None,
                };
                let at = |frame, tag| components.in_body(Some(frame), own(tag).unwrap_or([0.0; 3]));
                Some(JointOffset {
                    name: components.name(joint),
                    parent: body(parent)?,
                    child: body(child)?,
                    in_parent_m: at(parent, "location_in_parent")?,
                    in_child_m: at(child, "location")?,
                })
            })
            .collect()
    }
}
