//! Joints as a tree from ground: what a body hangs on, and what hangs on a joint.

use crate::model::ModelJoint;
use foldhash::{HashMap, HashMapExt, HashSet};

use crate::feet::joint_walk::{Crossing, joint_walk};

/// The joint over which a body hangs on ground or on another body.
#[derive(Debug, Clone, Copy)]
pub(super) struct Hanging<'j> {
    pub(super) joint: &'j ModelJoint,
    /// The body that hangs on the joint.
    pub(super) body: &'j str,
    /// The body above it; `None` is ground.
    pub(super) parent: Option<&'j str>,
    /// Whether the joint leads from what is above to the body, and not the other way round.
    pub(super) forward: bool,
}

/// The bodies of a model by the joints over which ground is reached first. A joint that closes a loop is left out.
pub(super) struct JointTree<'j> {
    above: HashMap<&'j str, Hanging<'j>>,
    below: HashMap<&'j str, Vec<&'j str>>,
    /// Of each body the one on top of its tree: that which hangs on ground.
    tops: HashMap<&'j str, &'j str>,
}

impl<'j> JointTree<'j> {
    pub(super) fn of(joints: &'j [ModelJoint]) -> Self {
        let mut tree = Self { above: HashMap::new(), below: HashMap::new(), tops: HashMap::new() };
        for Crossing { joint, from, to, forward, closes } in joint_walk(joints) {
            let Some(body) = to.filter(|_| !closes) else { continue };
            // What is above a body is walked to before it.
            let top = from.and_then(|above| tree.tops.get(above).copied()).unwrap_or(body);
            tree.tops.insert(body, top);
            tree.above.insert(body, Hanging { joint, body, parent: from, forward });
            tree.below.entry(from.unwrap_or_default()).or_default().push(body);
        }
        tree
    }

    /// The joints from `body` to ground.
    pub(super) fn way(&self, body: &str) -> Vec<Hanging<'j>> {
        let mut way = Vec::new();
        let mut at = self.above.get(body);
        while let Some(hanging) = at {
            way.push(*hanging);
            at = hanging.parent.and_then(|parent| self.above.get(parent));
        }
        way
    }

    /// The body on top of the tree in which `body` is: the one that hangs on ground.
    pub(super) fn top(&self, body: &str) -> Option<&'j str> {
        self.tops.get(body).copied()
    }

    /// The joints above all of `bodies`, from the lowest to ground. Each body is looked at once.
    pub(super) fn way_of_all(&self, bodies: &[&str]) -> Vec<Hanging<'j>> {
        let Some(first) = bodies.first() else { return Vec::new() };
        let way = self.way(first);
        // Where on the first way the ways of other bodies end.
        let mut joins: HashMap<&str, usize> =
            way.iter().enumerate().map(|(place, hanging)| (hanging.body, place)).collect();
        let mut common = 0;
        for body in bodies {
            let mut passed = Vec::new();
            let mut at = self.above.get(body);
            while let Some(hanging) = at.filter(|hanging| !joins.contains_key(hanging.body)) {
                passed.push(hanging.body);
                at = hanging.parent.and_then(|parent| self.above.get(parent));
            }
            let place = at.and_then(|hanging| joins.get(hanging.body).copied()).unwrap_or(way.len());
            joins.extend(passed.into_iter().map(|body| (body, place)));
            common = common.max(place);
        }
        way.into_iter().skip(common).collect()
    }

    /// `body` and all bodies below it.
    pub(super) fn with_all_below(&self, body: &'j str) -> HashSet<&'j str> {
        let mut found = HashSet::from_iter([body]);
        let mut waiting = vec![body];
        while let Some(above) = waiting.pop() {
            let below = self.below.get(above).into_iter().flatten().copied();
            waiting.extend(below.filter(|body| found.insert(body)));
        }
        found
    }
}
