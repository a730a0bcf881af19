//! The joint tree above the bodies on which a model stands, each body of it looked at once.

use std::collections::BTreeMap;

use foldhash::{HashMap, HashMapExt};

use crate::model::components::ComponentId;
use crate::model::contacts::SphereId;
use crate::model::side::Side;
use crate::model::skeleton::Skeleton;

/// Spheres on one body.
pub(crate) struct Footing {
    pub body: ComponentId,
    pub side: Option<Side>,
    pub spheres: Vec<SphereId>,
}

/// Whether there is a right and a left one.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sides {
    right: bool,
    left: bool,
}

impl Sides {
    pub(crate) fn are_both(self) -> bool {
        self.right && self.left
    }

    fn add(&mut self, other: Self) {
        self.right |= other.right;
        self.left |= other.left;
    }
}

impl From<Option<Side>> for Sides {
    fn from(side: Option<Side>) -> Self {
        Self { right: side == Some(Side::Right), left: side == Some(Side::Left) }
    }
}

/// One body: what it carries and what hangs on it.
#[derive(Default)]
struct Node {
    footing: Option<usize>,
    /// Of its footing and all below.
    sides: Sides,
    children: Vec<ComponentId>,
}

/// The bodies from those with footings up to the tops.
pub(crate) struct FootingTree<'f> {
    footings: &'f [Footing],
    nodes: HashMap<ComponentId, Node>,
    tops: Vec<ComponentId>,
}

impl<'f> FootingTree<'f> {
    /// `footings` in the order of their bodies.
    pub(crate) fn new(footings: &'f [Footing], skeleton: &Skeleton) -> Self {
        let mut tree = Self { footings, nodes: HashMap::new(), tops: Vec::new() };
        // Each body after the one above it.
        let mut order = Vec::new();
        for (index, footing) in footings.iter().enumerate() {
            let mut way = Vec::new();
            let mut at = Some(footing.body);
            while let Some(body) = at.filter(|body| !tree.nodes.contains_key(body)) {
                tree.nodes.insert(body, Node::default());
                way.push(body);
                at = skeleton.parent(body);
            }
            order.extend(way.into_iter().rev());
            if let Some(node) = tree.nodes.get_mut(&footing.body) {
                node.footing = Some(index);
                node.sides = footing.side.into();
            }
        }
        for &body in order.iter().rev() {
            let sides = tree.sides(body);
            match skeleton.parent(body) {
                None => tree.tops.push(body),
                Some(parent) => {
                    if let Some(node) = tree.nodes.get_mut(&parent) {
                        node.sides.add(sides);
                        node.children.push(body);
                    }
                }
            }
        }
        tree.nodes.values_mut().for_each(|node| node.children.sort_unstable());
        tree
    }

    /// Bodies that hang on no other one.
    pub(crate) fn tops(&self) -> &[ComponentId] {
        &self.tops
    }

    /// The sides of what `body` and those below it carry.
    pub(crate) fn sides(&self, body: ComponentId) -> Sides {
        self.nodes.get(&body).map(|node| node.sides).unwrap_or_default()
    }

    /// The sides of all footings.
    pub(crate) fn all_sides(&self) -> Sides {
        let mut all = Sides::default();
        self.tops.iter().for_each(|&top| all.add(self.sides(top)));
        all
    }

    /// Whether spheres are on `body` itself.
    pub(crate) fn carries(&self, body: ComponentId) -> bool {
        self.nodes.get(&body).is_some_and(|node| node.footing.is_some())
    }

    /// The bodies that hang on `body`, in file order.
    pub(crate) fn children(&self, body: ComponentId) -> &[ComponentId] {
        self.nodes.get(&body).map(|node| node.children.as_slice()).unwrap_or_default()
    }

    /// The footings on `body` and below it, in file order.
    pub(crate) fn below(&self, body: ComponentId) -> Vec<&'f Footing> {
        let mut found = BTreeMap::new();
        let mut waiting = vec![body];
        while let Some(node) = waiting.pop().and_then(|body| self.nodes.get(&body)) {
            found.extend(node.footing.and_then(|index| Some((index, self.footings.get(index)?))));
            waiting.extend(&node.children);
        }
        found.into_values().collect()
    }
}
