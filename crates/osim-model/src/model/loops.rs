//! Loops of joints, and joints that OpenSim ignores: where a body has more than one.

use foldhash::{HashMap, HashMapExt};

use crate::model::components::{Base, ComponentId};

/// A joint between two bodies, or a body and ground.
#[derive(Debug, Clone, Copy)]
pub(crate) struct JointLink {
    pub joint: ComponentId,
    pub ends: [Base; 2],
    /// Whether it is a WeldJoint.
    pub weld: bool,
    /// Whether it is a WeldJoint or a FreeJoint: with one of these in a loop, OpenSim counts a body twice.
    pub counts_twice: bool,
    /// Whether what it joins moves away from each other, as an animal from the ground that it walks on.
    pub moves_away: bool,
}

impl JointLink {
    fn is_between_bodies(&self) -> bool {
        self.ends.iter().all(|end| matches!(end, Base::Body(_)))
    }
}

/// What OpenSim does not take as a tree.
#[derive(Debug, Default)]
pub(crate) struct Loops {
    /// Joints of loops, or between two of them, in file order.
    pub joints: Vec<ComponentId>,
    /// Whether the masses of the bodies are not what OpenSim sums.
    pub mass_is_in_doubt: bool,
}

impl Loops {
    /// Bodies at which only one joint is left are taken away, one after the other: what stays hangs together in loops.
    pub(crate) fn of(links: &[JointLink]) -> Self {
        let mut at: HashMap<Base, Vec<usize>> = HashMap::new();
        for (index, link) in links.iter().enumerate() {
            for end in link.ends {
                at.entry(end).or_default().push(index);
            }
        }
        let mut left: Vec<bool> = vec![true; links.len()];
        let mut count: HashMap<Base, usize> = at.iter().map(|(&end, links)| (end, links.len())).collect();
        let mut ends: Vec<Base> =
            count.iter().filter(|(_, count)| **count == 1).map(|(end, _)| *end).collect();
        while let Some(end) = ends.pop() {
            for &index in at.get(&end).into_iter().flatten() {
                let (Some(link), Some(slot)) = (links.get(index), left.get_mut(index)) else { continue };
                if !std::mem::take(slot) {
                    continue;
                }
                for other in link.ends {
                    let count = count.entry(other).or_default();
                    *count = count.saturating_sub(1);
                    if *count == 1 {
                        ends.push(other);
                    }
                }
            }
        }
        let in_loop = || links.iter().zip(&left).filter(|(_, left)| **left).map(|(link, _)| link);
        Self {
            joints: in_loop().map(|link| link.joint).collect(),
            mass_is_in_doubt: in_loop().any(|link| link.counts_twice && link.is_between_bodies()),
        }
    }
}
