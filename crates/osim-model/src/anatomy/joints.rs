//! Joints between bodies: where they are on both, and how the bodies stand to each other at the default pose.

use super::pose::{Placement, at_default};
use crate::components::{ComponentId, Components, MAX_FRAME_CHAIN};
use crate::rotation::Rotation;

/// A joint between two bodies.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct AnatomyJoint {
    /// Its name.
    pub name: String,
    /// The body it hangs on.
    pub parent: String,
    /// The body that hangs on it.
    pub child: String,
    /// Where it is on its parent, m.
    pub in_parent_m: [f64; 3],
    /// Where it is on its child, m.
    pub in_child_m: [f64; 3],
    /// The child's frame in the parent's at the default pose; `None` where a function of the joint is not understood.
    placement: Option<Placement>,
}

impl AnatomyJoint {
    /// A point of the child, seen from the parent at the default pose, m.
    #[must_use]
    pub fn in_parent(&self, point_m: [f64; 3]) -> Option<[f64; 3]> {
        Some(self.placement?.of(point_m))
    }
}

/// All joints between bodies of the files. One whose frames lead nowhere is left out: its limb says nothing then.
pub(super) fn read(components: &Components) -> Vec<AnatomyJoint> {
    let joints = components.tree.iter().filter(|(id, _)| components.tag(*id).ends_with("Joint"));
    joints.filter_map(|(id, _)| read_one(components, id)).collect()
}

fn read_one(components: &Components, joint: ComponentId) -> Option<AnatomyJoint> {
    let old = components.tree.get(joint)?.parent.filter(|&id| components.tag(id) == "Body");
    let (parent, child) = match old {
        // A document of version 3: the joint is in its child and holds both places.
        Some(child) => {
            let (body, on_body) = end(components, joint, "parent_frame", &["parent_body"])?;
            let there = own(components, joint, "location_in_parent", "orientation_in_parent");
            let here = own(components, joint, "location", "orientation");
            ((body, on_body.then(&there)), (components.name(child), here))
        }
        None => (
            end(components, joint, "parent_frame", &["parent_body"])?,
            end(components, joint, "child_frame", &["child_body"])?,
        ),
    };
    let motion = at_default(components, joint);
    Some(AnatomyJoint {
        name: components.name(joint),
        placement: motion.map(|motion| parent.1.then(&motion).then(&child.1.inverse())),
        in_parent_m: parent.1.translation,
        in_child_m: child.1.translation,
        parent: parent.0,
        child: child.0,
    })
}

/// The body at one end of a joint, and the joint's frame on it.
fn end(
    components: &Components,
    joint: ComponentId,
    socket: &str,
    legacy: &[&str],
) -> Option<(String, Placement)> {
    let connectee = components.connectee(joint, socket, legacy)?;
    let mut at = components.frame(joint, &connectee)?.component;
    let mut placement = Placement::NONE;
    for _ in 0..=MAX_FRAME_CHAIN {
        let frame = at?;
        match components.tag(frame) {
            "Body" => {
                let name = components.name(frame);
                return (name != "ground").then_some((name, placement));
            }
            "Ground" => return None,
            _ => {}
        }
        placement = own(components, frame, "translation", "orientation").then(&placement);
        let parent = components.connectee(frame, "parent", &["parent_frame"])?;
        at = components.frame(frame, &parent)?.component;
    }
    None
}

fn own(components: &Components, owner: ComponentId, translation: &str, orientation: &str) -> Placement {
    let triple = |tag| components.doc(owner).triple(components.element(owner), tag).unwrap_or([0.0; 3]);
    Placement { rotation: Rotation::body_fixed_xyz(triple(orientation)), translation: triple(translation) }
}
