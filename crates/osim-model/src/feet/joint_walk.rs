//! The way from ground over all joints.

use std::collections::VecDeque;

use crate::model::ModelJoint;
use foldhash::{HashMap, HashMapExt, HashSet};

/// A joint on the way from ground.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub struct Crossing<'j> {
    /// The joint.
    pub joint: &'j ModelJoint,
    /// The body at which it is reached; `None` is ground.
    pub from: Option<&'j str>,
    /// The body that it leads to.
    pub to: Option<&'j str>,
    /// Whether it leads from its parent to its child.
    pub forward: bool,
    /// Whether another way has reached the body before: the joint closes a loop.
    pub closes: bool,
}

/// The joints that hang on ground, each once, in an order in which the body that one is reached at is reached before it.
///
/// ```
/// use osim_model::feet::joint_walk;
///
/// # let bytes: &[u8] = include_bytes!("../../tests/data/one_foot.osim");
/// let model = osim_model::Model::parse(bytes)?;
/// let reached: Vec<Option<&str>> = joint_walk(model.joints()).iter().map(|crossing| crossing.to).collect();
/// assert!(joint_walk(model.joints()).first().is_none_or(|first| first.from.is_none()), "{reached:?}");
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[must_use]
pub fn joint_walk(joints: &[ModelJoint]) -> Vec<Crossing<'_>> {
    let mut at: HashMap<Option<&str>, Vec<usize>> = HashMap::new();
    for (index, joint) in joints.iter().enumerate() {
        at.entry(joint.parent.as_deref()).or_default().push(index);
        at.entry(joint.child.as_deref()).or_default().push(index);
    }
    let mut used = vec![false; joints.len()];
    let mut reached: HashSet<Option<&str>> = HashSet::from_iter([None]);
    let mut waiting: VecDeque<Option<&str>> = VecDeque::from([None]);
    let mut walk = Vec::with_capacity(joints.len());
    while let Some(from) = waiting.pop_front() {
        for &index in at.get(&from).into_iter().flatten() {
            let (Some(joint), Some(used)) = (joints.get(index), used.get_mut(index)) else { continue };
            if std::mem::replace(used, true) {
                continue;
            }
            let forward = joint.parent.as_deref() == from;
            let to = if forward { joint.child.as_deref() } else { joint.parent.as_deref() };
            let closes = !reached.insert(to);
            if !closes {
                waiting.push_back(to);
            }
            walk.push(Crossing { joint, from, to, forward, closes });
        }
    }
    walk
}
