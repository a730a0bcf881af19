//! Finds the bodies that form each foot, by the joint tree.

use foldhash::{HashMap, HashMapExt, HashSet, HashSetExt};
use indexmap::IndexMap;

use crate::feet::default_pose::DefaultPose;
use crate::model::{Anatomy, ForceId, Model, Side, SphereId, has_word, least_and_most};

/// A body belongs to a foot if its origin is at most this part of the model's height above the lowest origin.
const NEAR_GROUND_SHARE: f64 = 0.12;
/// Usual names of foot bodies, for models without a known default pose.
const FOOT_NAMES: [&str; 10] =
    ["calcn", "calcan", "foot", "toe", "talus", "hoof", "paw", "hallux", "phalan", "metatars"];

/// The bodies of one foot, which joints connect, and the spheres on them.
#[derive(Debug, Clone, PartialEq)]
pub struct FootBodies {
    /// Bodies of the foot, those nearest to the trunk first.
    pub bodies: Vec<String>,
    /// The side of the body on which the foot is, left or right; `None` if its names do not say it.
    pub side: Option<Side>,
    /// Spheres of the foot, in file order.
    pub spheres: Vec<SphereId>,
}

impl FootBodies {
    /// Finds the feet of a model. With chosen spheres, each limb with spheres has one foot, and other bodies with spheres are feet of their
    /// own. Without chosen spheres, feet are bodies near the ground at the default pose with a side in their names.
    pub fn find(
        model: &Model,
        anatomy: &Anatomy,
        spheres: &[SphereId],
        forces: &[ForceId],
        pose: &DefaultPose,
    ) -> Vec<Self> {
        if spheres.is_empty() {
            let up = model.up();
            let height_m = |body: &str| Some(up.dot(pose.placement(body).ok()?.translation_m));
            return feet_near_ground(anatomy, &height_m);
        }
        let mut groups = groups_by_limb(model, spheres, forces);
        groups.extend(groups_by_body(anatomy, model, &spheres_outside_groups(spheres, &groups)));
        let carriers: HashSet<&str> = spheres.iter().filter_map(|&id| name_of_carrier(model, id)).collect();
        groups.into_iter().flat_map(|group| feet_of_group(anatomy, model, group, &carriers)).collect()
    }

    /// The body of the foot that is nearest to the trunk.
    pub fn top(&self) -> &str {
        self.bodies.first().map_or("", String::as_str)
    }
}

/// The spheres of one limb, or of one body that belongs to no limb.
struct SphereGroup {
    side: Option<Side>,
    spheres: Vec<SphereId>,
}

fn groups_by_limb(model: &Model, spheres: &[SphereId], forces: &[ForceId]) -> Vec<SphereGroup> {
    let limbs = model.limbs(forces);
    let chosen: HashSet<SphereId> = spheres.iter().copied().collect();
    let limbs = limbs.if_known().unwrap_or_default().iter().map(|limb| SphereGroup {
        side: Some(limb.side),
        spheres: limb.spheres.iter().copied().filter(|id| chosen.contains(id)).collect(),
    });
    limbs.filter(|group| !group.spheres.is_empty()).collect()
}

fn spheres_outside_groups(spheres: &[SphereId], groups: &[SphereGroup]) -> Vec<SphereId> {
    let grouped: HashSet<SphereId> = groups.iter().flat_map(|group| group.spheres.iter().copied()).collect();
    spheres.iter().copied().filter(|id| !grouped.contains(id)).collect()
}

/// The name of the body that carries `sphere`; empty for ground.
fn name_of_carrier(model: &Model, sphere: SphereId) -> Option<&str> {
    Some(model.sphere(sphere)?.body.as_deref().unwrap_or_default())
}

/// The spheres of each body, in the order of the first sphere on each body.
fn spheres_by_body<'m>(model: &'m Model, spheres: &[SphereId]) -> IndexMap<&'m str, Vec<SphereId>> {
    let mut by_body: IndexMap<&str, Vec<SphereId>> = IndexMap::new();
    for &id in spheres {
        let Some(body) = name_of_carrier(model, id) else { continue };
        by_body.entry(body).or_default().push(id);
    }
    by_body
}

/// Groups the spheres that are in no limb: one group for each body, or for several joined bodies of one side.
fn groups_by_body(anatomy: &Anatomy, model: &Model, spheres: &[SphereId]) -> Vec<SphereGroup> {
    let on = spheres_by_body(model, spheres);
    let bodies: Vec<&str> = on.keys().copied().collect();
    let groups = anatomy.groups_of_connected_bodies(&bodies).into_iter().map(|group| SphereGroup {
        side: group.first().and_then(|body| Side::of_name(body)),
        spheres: group.iter().flat_map(|body| on.get(body).cloned().unwrap_or_default()).collect(),
    });
    groups.collect()
}

/// The foot of a group of spheres: the bodies with these spheres, the bodies between them, and the bodies below them on the same side.
/// Bodies that only ground connects become separate feet.
fn feet_of_group(
    anatomy: &Anatomy,
    model: &Model,
    group: SphereGroup,
    carriers: &HashSet<&str>,
) -> Vec<FootBodies> {
    let carriers_of_group = spheres_by_body(model, &group.spheres);
    let names: Vec<&str> = carriers_of_group.keys().copied().collect();
    let Some(joined) = anatomy.with_connecting_bodies(&names) else {
        let alone = carriers_of_group.into_iter().map(|(body, spheres)| FootBodies {
            bodies: vec![body.to_owned()],
            side: group.side,
            spheres,
        });
        return alone.collect();
    };
    let bodies =
        anatomy.with_bodies_below(joined, group.side, carriers).into_iter().map(str::to_owned).collect();
    vec![FootBodies { bodies, side: group.side, spheres: group.spheres }]
}

/// The feet of a model without spheres: bodies near the ground.
fn feet_near_ground(anatomy: &Anatomy, height_m: &dyn Fn(&str) -> Option<f64>) -> Vec<FootBodies> {
    let names: Vec<&str> = anatomy.bodies.iter().map(String::as_str).collect();
    let sided = |name: &&str| Side::of_name(name).is_some();
    let heights: Vec<(&str, f64)> = names.iter().filter_map(|&name| Some((name, height_m(name)?))).collect();
    let (low, high) = least_and_most(heights.iter().map(|(_, height)| *height));
    let near = |height: f64| high > low && height <= low + NEAR_GROUND_SHARE * (high - low);
    let mut feet: Vec<&str> =
        heights.iter().filter(|(_, height)| near(*height)).map(|(name, _)| *name).filter(sided).collect();
    if heights.len() < names.len() {
        let called = |name: &&str| FOOT_NAMES.iter().any(|known| has_word(name, known));
        feet = names.iter().copied().filter(sided).filter(called).collect();
    }
    let foot = |bodies: Vec<&str>| FootBodies {
        side: bodies.first().and_then(|body| Side::of_name(body)),
        bodies: anatomy.top_first(bodies).into_iter().map(str::to_owned).collect(),
        spheres: Vec::new(),
    };
    anatomy.groups_of_connected_bodies(&feet).into_iter().map(foot).collect()
}

// Bodies as a tree of joints: which of them are joined to each other. Each body is visited once, however long a chain is.

impl Anatomy {
    fn parent_of_body(&self, body: &str) -> Option<&str> {
        self.joint_above(body).map(|joint| joint.parent.as_str())
    }

    /// Walks from `body` up the joint tree until a body that is in `seen`. Returns the bodies passed, and the body in `seen`. Adds the
    /// passed bodies to `seen`.
    fn walk_up<'b>(&'b self, body: &'b str, seen: &mut HashSet<&'b str>) -> (Vec<&'b str>, Option<&'b str>) {
        let (mut walked, mut next) = (Vec::new(), Some(body));
        while let Some(at) = next {
            if !seen.insert(at) {
                return (walked, Some(at));
            }
            walked.push(at);
            next = self.parent_of_body(at);
        }
        (walked, None)
    }

    /// Groups `bodies` of one side that joints connect. Groups are in the order of their first body, and bodies keep their given order.
    fn groups_of_connected_bodies<'b>(&'b self, bodies: &[&'b str]) -> Vec<Vec<&'b str>> {
        let allowed: HashSet<&str> = bodies.iter().copied().collect();
        let above = |body: &'b str| {
            let parent = self.parent_of_body(body).filter(|parent| allowed.contains(parent))?;
            (Side::of_name(parent) == Side::of_name(body)).then_some(parent)
        };
        let mut group_of: HashMap<&str, usize> = HashMap::new();
        let mut groups = 0;
        for &body in bodies {
            let (mut walked, mut next, mut group) = (Vec::new(), Some(body), groups);
            while let Some(at) = next {
                if let Some(&known) = group_of.get(at) {
                    group = known;
                    break;
                }
                group_of.insert(at, groups);
                walked.push(at);
                next = above(at);
            }
            groups += usize::from(group == groups && !walked.is_empty());
            group_of.extend(walked.into_iter().map(|at| (at, group)));
        }
        let mut connected = vec![Vec::new(); groups];
        for body in bodies {
            if let Some(group) = group_of.get(body).and_then(|&group| connected.get_mut(group)) {
                group.push(*body);
            }
        }
        connected
    }

    /// `bodies` and all bodies between them in the joint tree, those nearest to the trunk first; `None` if no body is above all of them.
    fn with_connecting_bodies<'b>(&'b self, bodies: &[&'b str]) -> Option<Vec<&'b str>> {
        let mut seen = HashSet::new();
        let (first, _) = self.walk_up(bodies.first()?, &mut seen);
        let steps: HashMap<&str, usize> =
            first.iter().enumerate().map(|(steps, &body)| (body, steps)).collect();
        let mut top = 0;
        for body in bodies.iter().skip(1) {
            let (_, met) = self.walk_up(body, &mut seen);
            // A walk that meets an earlier one meets the first walk where the earlier one did.
            top = top.max(met.map(|met| steps.get(met).copied().unwrap_or(0))?);
        }
        let top = *first.get(top)?;
        let (mut joined, mut seen) = (vec![top], HashSet::from_iter([top]));
        for body in bodies {
            let (walked, _) = self.walk_up(body, &mut seen);
            joined.extend(walked.into_iter().rev());
        }
        Some(joined)
    }

    /// `bodies` and the bodies below them that are of the same side and carry no sphere.
    fn with_bodies_below<'b>(
        &'b self,
        mut bodies: Vec<&'b str>,
        side: Option<Side>,
        carriers: &HashSet<&str>,
    ) -> Vec<&'b str> {
        let mut known: HashSet<&str> = bodies.iter().copied().collect();
        let mut at = 0;
        while let Some(body) = bodies.get(at).copied() {
            at += 1;
            for child in self.joints_below(body).map(|joint| joint.child.as_str()) {
                let same = side.is_some() && Side::of_name(child) == side;
                if same && !carriers.contains(child) && known.insert(child) {
                    bodies.push(child);
                }
            }
        }
        bodies
    }

    /// Sorts bodies by the number of joints above them, the fewest first.
    fn top_first<'b>(&'b self, mut bodies: Vec<&'b str>) -> Vec<&'b str> {
        let mut depths: HashMap<&str, usize> = HashMap::new();
        for &body in &bodies {
            let (mut walked, mut next) = (Vec::new(), Some(body));
            while let Some(at) = next.filter(|at| !depths.contains_key(at)) {
                // Until its depth is known, so that a circle of joints, which OpenSim refuses, has an end.
                depths.insert(at, 0);
                walked.push(at);
                next = self.parent_of_body(at);
            }
            let above = next.and_then(|known| depths.get(known)).map_or(0, |depth| depth + 1);
            depths.extend(walked.into_iter().rev().zip(above..));
        }
        bodies.sort_by_key(|body| depths.get(body).copied().unwrap_or(0));
        bodies
    }
}
