//! Which bodies cannot move against each other.

use crate::model::ModelJoint;
use foldhash::{HashMap, HashMapExt};

/// Bodies that WeldJoints hold together, directly or through others.
pub(crate) struct Welds<'j> {
    /// From each body to another one of its group; the first of a group has none. `None` is ground.
    leaders: HashMap<Option<&'j str>, Option<&'j str>>,
}

impl<'j> Welds<'j> {
    pub(crate) fn of(joints: &'j [ModelJoint]) -> Self {
        let mut welds = Self { leaders: HashMap::new() };
        for joint in joints.iter().filter(|joint| joint.class == "WeldJoint") {
            let parent = welds.leader(joint.parent.as_deref());
            let child = welds.leader(joint.child.as_deref());
            if parent != child {
                welds.leaders.insert(child, parent);
            }
        }
        welds
    }

    /// Whether two bodies are one, or welded to each other; `None` is ground.
    pub(crate) fn hold(&self, one: Option<&'j str>, other: Option<&'j str>) -> bool {
        self.leader(one) == self.leader(other)
    }

    fn leader(&self, body: Option<&'j str>) -> Option<&'j str> {
        let mut at = body;
        while let Some(&next) = self.leaders.get(&at) {
            at = next;
        }
        at
    }
}
