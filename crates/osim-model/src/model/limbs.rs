//! Limbs: contact spheres grouped along the joint tree, split where left and right both hang below.

use std::collections::BTreeMap;

use foldhash::{HashMap, HashMapExt, HashSet, HashSetExt};

use crate::messages::Phrase;
use crate::model::components::{Base, ComponentId};
use crate::model::contacts::{Force, ForceId, Sphere, SphereId};
use crate::model::names::Side;
use crate::model::skeleton::Skeleton;
use crate::model::typed_model::Model;

/// One limb that stands on the ground, from [`Model::limbs`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Limb {
    /// First body below the place where left and right separate.
    pub name: String,
    pub side: Side,
    /// Its spheres, in file order.
    pub spheres: Vec<SphereId>,
}

/// The limbs, or why they are not known: a match on it is complete.
///
/// ```
/// use osim_model::{Model, Selection, Side};
///
/// # let bytes: &[u8] = include_bytes!("../../tests/data/one_foot.osim");
/// // One sphere, heel_r, on the body foot_r.
/// let model = Model::parse(bytes)?;
/// let selected = Selection::default().apply(&model)?;
/// let limbs = model.limbs(&selected.forces);
/// let [limb] = limbs.known().unwrap_or_default() else { panic!("not one limb") };
/// assert_eq!((limb.name.as_str(), limb.side), ("foot_r", Side::Right));
/// assert_eq!(limbs.spheres_per_limb(), Ok(1));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Limbs {
    /// Every sphere belongs to exactly one of these.
    Known(Vec<Limb>),
    /// What is not known; the user is asked instead.
    Unknown(Phrase),
}

impl Limbs {
    pub fn known(&self) -> Option<&[Limb]> {
        match self {
            Self::Known(limbs) => Some(limbs),
            Self::Unknown(_) => None,
        }
    }

    /// Why they are not known, where they are not.
    pub fn unknown(&self) -> Option<&Phrase> {
        match self {
            Self::Known(_) => None,
            Self::Unknown(why) => Some(why),
        }
    }

    /// How many spheres each limb has, if all have equally many.
    ///
    /// # Errors
    /// Why there is no such number: the limbs are not known, or differ.
    pub fn spheres_per_limb(&self) -> Result<usize, Phrase> {
        let limbs = match self {
            Self::Known(limbs) => limbs,
            Self::Unknown(why) => return Err(why.clone()),
        };
        let first = limbs.first().map_or(0, |limb| limb.spheres.len());
        if limbs.iter().all(|limb| limb.spheres.len() == first) && first > 0 {
            return Ok(first);
        }
        let counts: Vec<_> =
            limbs.iter().map(|limb| format!("{} has {}", limb.name, limb.spheres.len())).collect();
        Err(format!("the limbs have different numbers of spheres ({})", counts.join(", ")).into())
    }
}

impl Model {
    /// Groups the moving spheres of the applied forces among `forces` that meet a half-space.
    pub fn limbs(&self, forces: &[ForceId]) -> Limbs {
        let footings = match self.footings(forces) {
            Ok(footings) => footings,
            Err(why) => return Limbs::Unknown(why.into()),
        };
        let mut limbs = Vec::new();
        match self.split(&footings, &mut limbs) {
            Ok(()) => Limbs::Known(limbs),
            Err(why) => Limbs::Unknown(why.into()),
        }
    }

    /// Moving spheres that touch a half-space through an applied force among `forces`, each once.
    pub fn loaded_spheres(&self, forces: &[ForceId]) -> Vec<SphereId> {
        let mut seen = HashSet::new();
        let mut spheres: Vec<SphereId> = Vec::new();
        let applied = forces.iter().filter_map(|&id| self.force(id)).filter(|force| force.applies);
        for force in applied.filter(|force| self.meets_half_space(force)) {
            for &sphere in force.sets.iter().flat_map(|set| &set.spheres) {
                if self.sphere(sphere).is_some_and(|sphere| !sphere.fixed) && seen.insert(sphere) {
                    spheres.push(sphere);
                }
            }
        }
        spheres
    }

    /// The forces whose moving spheres hang on the same body on top of the joint tree as those of `forces`: a ball is joined
    /// to its player only through ground.
    pub fn forces_of_same_body(&self, forces: &[ForceId]) -> Vec<ForceId> {
        let own: HashSet<ForceId> = forces.iter().copied().collect();
        let tops = |id: ForceId| -> HashSet<ComponentId> {
            let spheres = self.force(id).map(Force::spheres).unwrap_or_default();
            let moving = spheres.into_iter().filter_map(|id| self.sphere(id)).filter(|sphere| !sphere.fixed);
            let top = |sphere: &Sphere| match sphere.base {
                Base::Body(body) => Some(self.skeleton().top(body)),
                _ => None,
            };
            moving.filter_map(top).collect()
        };
        let chosen: HashSet<ComponentId> = forces.iter().flat_map(|&id| tops(id)).collect();
        let same = |id: &ForceId| own.contains(id) || !tops(*id).is_disjoint(&chosen);
        self.force_ids().into_iter().filter(same).collect()
    }

    /// Whether a moving sphere of `force` can touch a half-space on another body.
    pub fn meets_half_space(&self, force: &Force) -> bool {
        let spheres = force.sets.iter().flat_map(|set| &set.spheres);
        spheres.filter_map(|&id| self.sphere(id)).any(|sphere| {
            !sphere.fixed
                && force.half_space_bases().any(|plane| plane != sphere.base || plane == Base::Unknown)
        })
    }

    fn footings(&self, forces: &[ForceId]) -> Result<Vec<Footing>, String> {
        let loaded = self.loaded_spheres(forces);
        if loaded.is_empty() {
            return Err("no moving sphere meets a half-space through a force that applies".to_owned());
        }
        let mut bodies: BTreeMap<ComponentId, Vec<SphereId>> = BTreeMap::new();
        for index in loaded {
            let Some(sphere) = self.sphere(index) else { continue };
            let Base::Body(body) = sphere.base else {
                return Err(format!("the body of sphere {} is not in the files given", sphere.name));
            };
            bodies.entry(body).or_default().push(index);
        }
        let footing = |(body, spheres): (ComponentId, Vec<SphereId>)| {
            let side = self.side_of(body, &spheres);
            Footing { body, side, spheres }
        };
        Ok(bodies.into_iter().map(footing).collect())
    }

    /// The side of a body from its own name, else from the names of its spheres if they agree.
    fn side_of(&self, body: ComponentId, spheres: &[SphereId]) -> Option<Side> {
        Side::of_name(&self.components().name(body)).or_else(|| {
            let mut sides = spheres.iter().filter_map(|&s| self.sphere(s)).map(|s| Side::of_name(&s.name));
            let first = sides.next()??;
            sides.all(|side| side == Some(first)).then_some(first)
        })
    }

    /// Splits the footings from the top down until no group holds both sides.
    fn split(&self, footings: &[Footing], limbs: &mut Vec<Limb>) -> Result<(), String> {
        let tree = FootingTree::new(footings, self.skeleton());
        if !tree.all_sides().are_both() {
            let top = footings.first().map(|footing| self.skeleton().top(footing.body));
            limbs.push(self.limb(&footings.iter().collect::<Vec<_>>(), top)?);
            return Ok(());
        }
        let [top] = tree.tops() else {
            return Err("spheres stand on bodies that are joined only through ground".to_owned());
        };
        let mut groups = vec![*top];
        while let Some(body) = groups.pop() {
            if !tree.sides(body).are_both() {
                limbs.push(self.limb(&tree.below(body), Some(body))?);
                continue;
            }
            let mut at = body;
            while let (false, [only]) = (tree.carries(at), tree.children(at)) {
                at = *only;
            }
            if tree.carries(at) {
                return Err("spheres stand on a body to which left and right limbs are joined".to_owned());
            }
            groups.extend(tree.children(at));
        }
        limbs.sort_by_key(|limb| limb.spheres.first().copied());
        Ok(())
    }

    /// The limb of a `group`, called after the body on its top.
    fn limb(&self, group: &[&Footing], top: Option<ComponentId>) -> Result<Limb, String> {
        let mut spheres: Vec<SphereId> =
            group.iter().flat_map(|footing| footing.spheres.iter().copied()).collect();
        spheres.sort_unstable();
        let name = top.map(|id| self.components().name(id)).unwrap_or_default();
        let side = group.first().and_then(|footing| footing.side);
        match side {
            Some(side) if group.iter().all(|footing| footing.side == Some(side)) => {
                Ok(Limb { name: name.into_owned(), side, spheres })
            }
            _ => {
                let unknown = group.iter().find(|footing| footing.side.is_none());
                let body = unknown.map(|footing| self.components().name(footing.body)).unwrap_or(name);
                Err(format!("whether body {body} is left or right cannot be determined from its name"))
            }
        }
    }
}

// The joint tree above the bodies on which a model stands, each body of it looked at once.

/// Spheres on one body.
struct Footing {
    pub body: ComponentId,
    pub side: Option<Side>,
    pub spheres: Vec<SphereId>,
}

/// Whether there is a right and a left one.
#[derive(Debug, Clone, Copy, Default)]
struct Sides {
    right: bool,
    left: bool,
}

impl Sides {
    fn are_both(self) -> bool {
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
struct FootingTree<'f> {
    footings: &'f [Footing],
    nodes: HashMap<ComponentId, Node>,
    tops: Vec<ComponentId>,
}

impl<'f> FootingTree<'f> {
    /// `footings` in the order of their bodies.
    fn new(footings: &'f [Footing], skeleton: &Skeleton) -> Self {
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
    fn tops(&self) -> &[ComponentId] {
        &self.tops
    }

    /// The sides of what `body` and those below it carry.
    fn sides(&self, body: ComponentId) -> Sides {
        self.nodes.get(&body).map(|node| node.sides).unwrap_or_default()
    }

    fn all_sides(&self) -> Sides {
        let mut all = Sides::default();
        self.tops.iter().for_each(|&top| all.add(self.sides(top)));
        all
    }

    /// Whether spheres are on `body` itself.
    fn carries(&self, body: ComponentId) -> bool {
        self.nodes.get(&body).is_some_and(|node| node.footing.is_some())
    }

    /// The bodies that hang on `body`, in file order.
    fn children(&self, body: ComponentId) -> &[ComponentId] {
        self.nodes.get(&body).map(|node| node.children.as_slice()).unwrap_or_default()
    }

    /// The footings on `body` and below it, in file order.
    fn below(&self, body: ComponentId) -> Vec<&'f Footing> {
        let mut found = BTreeMap::new();
        let mut waiting = vec![body];
        while let Some(node) = waiting.pop().and_then(|body| self.nodes.get(&body)) {
            found.extend(node.footing.and_then(|index| Some((index, self.footings.get(index)?))));
            waiting.extend(&node.children);
        }
        found.into_values().collect()
    }
}
