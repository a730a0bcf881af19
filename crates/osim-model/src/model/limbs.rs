//! Finds the limbs of a model: contact spheres are grouped along the joint tree, which is split at bodies with both left and right bodies
//! below them.

use std::collections::BTreeMap;

use foldhash::{HashMap, HashMapExt, HashSet, HashSetExt};

use crate::messages::Phrase;
use crate::model::components::{Carrier, ComponentId};
use crate::model::{Force, ForceId, Model, Side, Skeleton, Sphere, SphereId};

/// A limb with contact spheres, from [`Model::limbs`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Limb {
    /// Name of the first body of the limb, below the point where left and right separate.
    pub name: String,
    pub side: Side,
    /// Spheres of the limb, in file order.
    pub spheres: Vec<SphereId>,
}

/// The limbs of a model, or why they are not known.
///
/// ```
/// use osim_model::{Model, Selection, Side};
///
/// # let bytes: &[u8] = include_bytes!("../../tests/data/one_foot.osim");
/// // One sphere, heel_r, on the body foot_r.
/// let model = Model::parse(bytes)?;
/// let selected = Selection::default().apply(&model)?;
/// let limbs = model.limbs(&selected.forces);
/// let [limb] = limbs.if_known().unwrap_or_default() else { panic!("not one limb") };
/// assert_eq!((limb.name.as_str(), limb.side), ("foot_r", Side::Right));
/// assert_eq!(limbs.spheres_per_limb(), Ok(1));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Limbs {
    /// The limbs. Every sphere belongs to exactly one of them.
    Known(Vec<Limb>),
    /// Why the limbs are not known. The caller is then asked.
    Unknown(Phrase),
}

impl Limbs {
    pub fn if_known(&self) -> Option<&[Limb]> {
        if let Self::Known(limbs) = self { Some(limbs) } else { None }
    }

    /// Why the limbs are not known; `None` if they are.
    pub fn why_unknown(&self) -> Option<&Phrase> {
        if let Self::Unknown(why) = self { Some(why) } else { None }
    }

    /// The number of spheres of each limb, if all limbs have the same number.
    ///
    /// # Errors
    /// The limbs are not known, or have different numbers of spheres.
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
    /// Groups the spheres that switched-on forces among `forces` press on a half-space, by limb.
    pub fn limbs(&self, forces: &[ForceId]) -> Limbs {
        let limbs = self.sphere_carriers(forces).and_then(|carriers| self.limbs_of_carriers(&carriers));
        limbs.map_or_else(|why| Limbs::Unknown(why.into()), Limbs::Known)
    }

    /// Moving spheres that a switched-on force among `forces` presses on a half-space, each once.
    pub fn loaded_spheres(&self, forces: &[ForceId]) -> Vec<SphereId> {
        let mut seen = HashSet::with_capacity(self.spheres().len());
        let mut spheres: Vec<SphereId> = Vec::with_capacity(self.spheres().len());
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

    /// The forces whose moving spheres are below the same topmost bodies of the joint tree as those of `forces`. For example, a ball is
    /// joined to its player only through ground, so its forces are not among the player's.
    pub fn forces_of_same_body(&self, forces: &[ForceId]) -> Vec<ForceId> {
        let requested: HashSet<ForceId> = forces.iter().copied().collect();
        let tops = |id: ForceId| -> HashSet<ComponentId> {
            let spheres = self.force(id).map(Force::spheres).unwrap_or_default();
            let moving = spheres.iter().filter_map(|&id| self.sphere(id)).filter(|sphere| !sphere.fixed);
            let top = |sphere: &Sphere| {
                if let Carrier::Body(body) = sphere.base { Some(self.skeleton().top(body)) } else { None }
            };
            moving.filter_map(top).collect()
        };
        let chosen: HashSet<ComponentId> = forces.iter().flat_map(|&id| tops(id)).collect();
        let same = |id: &ForceId| requested.contains(id) || !tops(*id).is_disjoint(&chosen);
        self.force_ids().into_iter().filter(same).collect()
    }

    /// Whether `force` can press a moving sphere on a half-space on another body.
    pub fn meets_half_space(&self, force: &Force) -> bool {
        let spheres = force.sets.iter().flat_map(|set| &set.spheres);
        spheres.filter_map(|&id| self.sphere(id)).any(|sphere| {
            !sphere.fixed
                && force.half_space_bases().any(|plane| plane != sphere.base || plane == Carrier::Unknown)
        })
    }

    fn sphere_carriers(&self, forces: &[ForceId]) -> Result<Vec<SphereCarrier>, String> {
        let loaded = self.loaded_spheres(forces);
        if loaded.is_empty() {
            return Err("no moving sphere meets a half-space through a force that applies".to_owned());
        }
        let mut bodies: BTreeMap<ComponentId, Vec<SphereId>> = BTreeMap::new();
        for index in loaded {
            let Some(sphere) = self.sphere(index) else { continue };
            let Carrier::Body(body) = sphere.base else {
                return Err(format!("the body of sphere {} is not in the files given", sphere.name));
            };
            bodies.entry(body).or_default().push(index);
        }
        let carrier = |(body, spheres): (ComponentId, Vec<SphereId>)| {
            let side = self.side_of(body, &spheres);
            SphereCarrier { body, side, spheres }
        };
        Ok(bodies.into_iter().map(carrier).collect())
    }

    /// The side of a body: from its own name, else from the names of its spheres if they agree.
    fn side_of(&self, body: ComponentId, spheres: &[SphereId]) -> Option<Side> {
        Side::of_name(&self.components().name(body)).or_else(|| {
            let mut sides = spheres.iter().filter_map(|&s| self.sphere(s)).map(|s| Side::of_name(&s.name));
            let first = sides.next()??;
            sides.all(|side| side == Some(first)).then_some(first)
        })
    }

    /// Splits the bodies with spheres, from the top of the joint tree downwards, until no group has both sides.
    fn limbs_of_carriers(&self, carriers: &[SphereCarrier]) -> Result<Vec<Limb>, String> {
        let tree = CarrierTree::new(carriers, self.skeleton());
        let has = |side: &Side| carriers.iter().any(|carrier| carrier.side == Some(*side));
        if !Side::ALL.iter().all(has) {
            let top = carriers.first().map(|carrier| self.skeleton().top(carrier.body));
            return Ok(vec![self.limb(&carriers.iter().collect::<Vec<_>>(), top)?]);
        }
        let [top] = tree.tops[..] else {
            return Err("spheres are on bodies that are joined only through ground".to_owned());
        };
        let (mut limbs, mut groups) = (Vec::new(), vec![top]);
        while let Some(body) = groups.pop() {
            if tree.sides(body).contains(&false) {
                limbs.push(self.limb(&tree.below(body), Some(body))?);
                continue;
            }
            let mut at = body;
            while let (false, [only]) = (tree.carries(at), tree.children(at)) {
                at = *only;
            }
            if tree.carries(at) {
                return Err("spheres are on a body to which both left and right limbs are joined".to_owned());
            }
            groups.extend(tree.children(at));
        }
        limbs.sort_by_key(|limb| limb.spheres.first().copied());
        Ok(limbs)
    }

    /// The limb of a `group` of bodies, with the name of its topmost body.
    fn limb(&self, group: &[&SphereCarrier], top: Option<ComponentId>) -> Result<Limb, String> {
        let mut spheres: Vec<SphereId> =
            group.iter().flat_map(|carrier| carrier.spheres.iter().copied()).collect();
        spheres.sort_unstable();
        let name = top.map(|id| self.components().name(id)).unwrap_or_default();
        let side = group.first().and_then(|carrier| carrier.side);
        match side {
            Some(side) if group.iter().all(|carrier| carrier.side == Some(side)) => {
                Ok(Limb { name: name.into_owned(), side, spheres })
            }
            _ => {
                let unknown = group.iter().find(|carrier| carrier.side.is_none());
                let body = unknown.map(|carrier| self.components().name(carrier.body)).unwrap_or(name);
                Err(format!("whether body {body} is left or right cannot be determined from its name"))
            }
        }
    }
}

// The joint tree above the bodies on which a model stands, each body visited once.

/// A body that carries spheres under load.
struct SphereCarrier {
    pub body: ComponentId,
    pub side: Option<Side>,
    pub spheres: Vec<SphereId>,
}

/// A body in the tree, with its spheres and its child bodies.
#[derive(Default)]
struct CarrierNode {
    carrier: Option<usize>,
    /// Whether there are bodies with spheres of the right and of the left side, from this body downwards.
    sides: [bool; 2],
    children: Vec<ComponentId>,
}

/// The bodies that carry spheres, and all bodies above them in the joint tree.
struct CarrierTree<'f> {
    carriers: &'f [SphereCarrier],
    nodes: HashMap<ComponentId, CarrierNode>,
    tops: Vec<ComponentId>,
}

impl<'f> CarrierTree<'f> {
    /// The tree of `carriers` (in file order) and all bodies above them.
    fn new(carriers: &'f [SphereCarrier], skeleton: &Skeleton) -> Self {
        let mut tree = Self { carriers, nodes: HashMap::new(), tops: Vec::new() };
        // Each body after the one above it.
        let mut order = Vec::new();
        for (index, carrier) in carriers.iter().enumerate() {
            let mut path = Vec::new();
            let mut at = Some(carrier.body);
            while let Some(body) = at.filter(|body| !tree.nodes.contains_key(body)) {
                tree.nodes.insert(body, CarrierNode::default());
                path.push(body);
                at = skeleton.parent(body);
            }
            order.extend(path.into_iter().rev());
            if let Some(node) = tree.nodes.get_mut(&carrier.body) {
                node.carrier = Some(index);
                node.sides = [Side::Right, Side::Left].map(|side| carrier.side == Some(side));
            }
        }
        for &body in order.iter().rev() {
            let sides = tree.sides(body);
            match skeleton.parent(body) {
                None => tree.tops.push(body),
                Some(parent) => {
                    if let Some(node) = tree.nodes.get_mut(&parent) {
                        node.sides = [node.sides[0] || sides[0], node.sides[1] || sides[1]];
                        node.children.push(body);
                    }
                }
            }
        }
        tree.nodes.values_mut().for_each(|node| node.children.sort_unstable());
        tree
    }

    /// Whether there are bodies with spheres of the right and of the left side, from `body` downwards.
    fn sides(&self, body: ComponentId) -> [bool; 2] {
        self.nodes.get(&body).map(|node| node.sides).unwrap_or_default()
    }

    /// Whether `body` itself carries spheres.
    fn carries(&self, body: ComponentId) -> bool {
        self.nodes.get(&body).is_some_and(|node| node.carrier.is_some())
    }

    /// The child bodies of `body`, in file order.
    fn children(&self, body: ComponentId) -> &[ComponentId] {
        self.nodes.get(&body).map(|node| node.children.as_slice()).unwrap_or_default()
    }

    /// The bodies with spheres, from `body` downwards, in file order.
    fn below(&self, body: ComponentId) -> Vec<&'f SphereCarrier> {
        let mut below = BTreeMap::new();
        let mut waiting = vec![body];
        while let Some(node) = waiting.pop().and_then(|body| self.nodes.get(&body)) {
            below.extend(node.carrier.and_then(|index| Some((index, self.carriers.get(index)?))));
            waiting.extend(&node.children);
        }
        below.into_values().collect()
    }
}
