//! Which bodies make a foot.

use foldhash::{HashMap, HashMapExt, HashSet, HashSetExt};
use osim_model::{Anatomy, ForceId, Model, Side, SphereId};

use crate::default_pose::DefaultPose;
use crate::vector::dot;

/// Bodies whose origins are within this share of the model's height above the lowest one are feet.
const NEAR_GROUND: f64 = 0.12;
/// What bodies of feet are called, where the default pose does not say which they are.
const NAMES: [&str; 10] =
    ["calcn", "calcan", "foot", "toe", "talus", "hoof", "paw", "hallux", "phalan", "metatars"];
/// A chain of joints is followed no further up.
const LONGEST_CHAIN: usize = 64;

/// A foot: bodies that hang on each other, and the spheres on them.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct FootBodies {
    /// Its bodies, the one on which the others hang first.
    pub bodies: Vec<String>,
    /// Right or left, if known.
    pub side: Option<Side>,
    /// Its spheres, in file order.
    pub spheres: Vec<SphereId>,
}

impl FootBodies {
    /// The feet of a model: where its spheres are, limb by limb; spheres on other bodies are a foot for each body.
    /// A model without chosen spheres has its feet where bodies with a side in their names are near the ground at the
    /// default pose.
    #[must_use]
    pub fn find(
        model: &Model,
        anatomy: &Anatomy,
        spheres: &[SphereId],
        forces: &[ForceId],
        pose: &DefaultPose,
    ) -> Vec<Self> {
        let tree = Tree { anatomy };
        if spheres.is_empty() {
            let up = model.up();
            let height_m = |body: &str| Some(dot(up, pose.placement(body).ok()?.translation_m));
            return tree.near_ground(&height_m);
        }
        let mut groups = limbs(model, spheres, forces);
        groups.extend(tree.by_body(model, rest(spheres, &groups)));
        let carriers: HashSet<String> = spheres.iter().filter_map(|&id| body_of(model, id)).collect();
        groups.into_iter().flat_map(|group| tree.feet(model, group, &carriers)).collect()
    }

    /// The body on which the others hang.
    #[must_use]
    pub fn top(&self) -> &str {
        self.bodies.first().map_or("", String::as_str)
    }
}

/// Spheres of one limb, or of one body.
struct Group {
    side: Option<Side>,
    spheres: Vec<SphereId>,
}

fn limbs(model: &Model, spheres: &[SphereId], forces: &[ForceId]) -> Vec<Group> {
    let limbs = model.limbs(forces);
    let chosen: HashSet<SphereId> = spheres.iter().copied().collect();
    let limbs = limbs.known().unwrap_or_default().iter().map(|limb| Group {
        side: Some(limb.side),
        spheres: limb.spheres.iter().copied().filter(|id| chosen.contains(id)).collect(),
    });
    limbs.filter(|group| !group.spheres.is_empty()).collect()
}

fn rest(spheres: &[SphereId], groups: &[Group]) -> Vec<SphereId> {
    let known: HashSet<SphereId> = groups.iter().flat_map(|group| group.spheres.iter().copied()).collect();
    spheres.iter().copied().filter(|id| !known.contains(id)).collect()
}

/// Ground has an empty name.
fn body_of(model: &Model, sphere: SphereId) -> Option<String> {
    Some(model.sphere(sphere)?.body.clone().unwrap_or_default())
}

struct Tree<'t> {
    anatomy: &'t Anatomy,
}

impl Tree<'_> {
    /// A body and those above it.
    fn chain(&self, body: &str) -> Vec<String> {
        let mut chain = vec![body.to_owned()];
        while let Some(joint) = chain.last().and_then(|last| self.anatomy.joint_above(last)) {
            if chain.len() > LONGEST_CHAIN || chain.contains(&joint.parent) {
                break;
            }
            chain.push(joint.parent.clone());
        }
        chain
    }

    fn parent(&self, body: &str) -> Option<&str> {
        self.anatomy.joint_above(body).map(|joint| joint.parent.as_str())
    }

    /// Spheres without a limb: body by body, and bodies of one side that hang on each other together.
    fn by_body(&self, model: &Model, spheres: Vec<SphereId>) -> Vec<Group> {
        let mut order: Vec<String> = Vec::new();
        let mut by_body: HashMap<String, Vec<SphereId>> = HashMap::new();
        for id in spheres {
            let Some(body) = body_of(model, id) else { continue };
            if !by_body.contains_key(&body) {
                order.push(body.clone());
            }
            by_body.entry(body).or_default().push(id);
        }
        let bodies: Vec<&str> = order.iter().map(String::as_str).collect();
        let groups = self.connected(&bodies).into_iter().map(|group| Group {
            side: group.first().and_then(|body| Side::of_name(body)),
            spheres: group.iter().flat_map(|&body| by_body.get(body).cloned().unwrap_or_default()).collect(),
        });
        groups.collect()
    }

    /// Bodies of one side that hang on each other, each group in the order given.
    fn connected<'b>(&self, bodies: &[&'b str]) -> Vec<Vec<&'b str>> {
        let mut groups: Vec<Vec<&'b str>> = Vec::new();
        for &body in bodies {
            let joined = |other: &&str| {
                let one_above = self.parent(other) == Some(body) || self.parent(body) == Some(*other);
                one_above && Side::of_name(other) == Side::of_name(body)
            };
            let (mine, others): (Vec<_>, Vec<_>) =
                groups.into_iter().partition(|group: &Vec<&str>| group.iter().any(joined));
            groups = others;
            let mut merged: Vec<&str> = mine.into_iter().flatten().collect();
            merged.push(body);
            groups.push(merged);
        }
        groups
    }

    /// The foot of a group: bodies with its spheres, those between them, and those of the same side below. Bodies that are joined
    /// only through ground are feet of their own.
    fn feet(&self, model: &Model, group: Group, carriers: &HashSet<String>) -> Vec<FootBodies> {
        let mut own: Vec<String> = Vec::new();
        for body in group.spheres.iter().filter_map(|&id| body_of(model, id)) {
            if !own.contains(&body) {
                own.push(body);
            }
        }
        let chains: Vec<Vec<String>> = own.iter().map(|body| self.chain(body)).collect();
        let first = chains.first().into_iter().flatten();
        let top = first.into_iter().find(|body| chains.iter().all(|chain| chain.contains(*body)));
        let Some(top) = top else {
            let alone = |body: &String| FootBodies {
                bodies: vec![body.clone()],
                side: group.side,
                spheres: on(model, &group.spheres, body),
            };
            return own.iter().map(alone).collect();
        };
        let mut bodies: Vec<String> = Vec::new();
        for chain in &chains {
            let upto = chain.iter().position(|body| body == top).unwrap_or(0);
            bodies.extend(chain.iter().take(upto + 1).rev().cloned());
        }
        self.add_below(&mut bodies, group.side, carriers);
        vec![FootBodies { bodies: once(bodies), side: group.side, spheres: group.spheres }]
    }

    fn add_below(&self, bodies: &mut Vec<String>, side: Option<Side>, carriers: &HashSet<String>) {
        let mut at = 0;
        while let Some(body) = bodies.get(at).cloned() {
            at += 1;
            let below = self.anatomy.joints_below(&body).map(|joint| &joint.child);
            let same = |child: &&String| side.is_some() && Side::of_name(child) == side;
            let new: Vec<String> = below
                .filter(same)
                .filter(|child| !carriers.contains(*child) && !bodies.contains(child))
                .cloned()
                .collect();
            bodies.extend(new);
        }
    }

    /// Feet of a model without spheres.
    fn near_ground(&self, height_m: &dyn Fn(&str) -> Option<f64>) -> Vec<FootBodies> {
        let names: Vec<&str> = self.anatomy.bodies.iter().map(String::as_str).collect();
        let sided = |name: &&str| Side::of_name(name).is_some();
        let heights: Vec<(&str, f64)> =
            names.iter().filter_map(|&name| Some((name, height_m(name)?))).collect();
        let low = heights.iter().map(|(_, height)| *height).fold(f64::INFINITY, f64::min);
        let high = heights.iter().map(|(_, height)| *height).fold(f64::NEG_INFINITY, f64::max);
        let near = |height: f64| high > low && height <= low + NEAR_GROUND * (high - low);
        let mut feet: Vec<&str> =
            heights.iter().filter(|(_, height)| near(*height)).map(|(name, _)| *name).filter(sided).collect();
        if heights.len() < names.len() {
            let called = |name: &&str| NAMES.iter().any(|known| name.to_lowercase().contains(known));
            feet = names.iter().copied().filter(sided).filter(called).collect();
        }
        let foot = |bodies: Vec<&str>| {
            let mut bodies: Vec<String> = bodies.into_iter().map(str::to_owned).collect();
            bodies.sort_by_key(|body| self.chain(body).len());
            let side = bodies.first().and_then(|body| Side::of_name(body));
            FootBodies { bodies, side, spheres: Vec::new() }
        };
        self.connected(&feet).into_iter().map(foot).collect()
    }
}

fn on(model: &Model, spheres: &[SphereId], body: &str) -> Vec<SphereId> {
    spheres.iter().copied().filter(|&id| body_of(model, id).as_deref() == Some(body)).collect()
}

fn once(names: Vec<String>) -> Vec<String> {
    let mut seen = HashSet::new();
    names.into_iter().filter(|name| seen.insert(name.clone())).collect()
}
