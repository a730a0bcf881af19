//! Bodies and the joints between them, in all document versions; and loops of joints.

use foldhash::{HashMap, HashMapExt, HashSet, HashSetExt};
use glam::DVec3;

use crate::model::components::{Carrier, ComponentId, Components};
use crate::model::{
    Class, Fault, FileId, Force, MissingFact, Property, Side, Sphere, SphereId, Value, ValueOrigin,
};

/// A body of the model. Ground is not a body.
#[derive(Debug, Clone)]
pub struct Body {
    pub name: String,
    pub path: String,
    /// `mass` in kg; NaN if the file gives none. [`Body::mass_kg`] checks it.
    pub mass: Value,
    pub file: FileId,
    /// Whether only WeldJoints connect the body to ground. Spheres on such a body are left out of all calculations.
    pub fixed: bool,
    /// Whether the body is left out of the mass of the model. This is so for a fixed body without child bodies, such as a platform; a body
    /// that can move away from it, by its joint, is not a child in this sense. It is also so for the bodies of a plate that carries a
    /// floor.
    pub excluded_from_mass: bool,
    /// Centre of mass in the frame of the body, m.
    pub centre_of_mass_m: DVec3,
}

impl Body {
    /// The mass of the body, kg, if its text is one plain number of at least 0.
    pub fn mass_kg(&self) -> Result<f64, Fault> {
        let missing = self.mass.origin == ValueOrigin::ClassDefault && self.mass.fault.is_none();
        let fault = if missing {
            Fault::at(MissingFact::BodyMass { body: self.name.clone() }, self.mass.offset)
        } else {
            match self.mass.checked() {
                Ok(mass) => return Ok(mass),
                Err(fault) => fault,
            }
        };
        Err(fault.at_element(self.path.clone()).in_file(self.file))
    }
}

/// The joint tree: the bodies, the parent of each body, and other facts that follow from the joints.
#[derive(Debug, Default)]
pub struct Skeleton {
    pub(crate) bodies: Vec<Body>,
    parents: HashMap<ComponentId, Carrier>,
    pub loops: Loops,
    /// Joints that OpenSim ignores: in documents with joints inside bodies, all but the first joint of a body.
    pub ignored_joints: Vec<ComponentId>,
    /// Bodies at the end of no joint, with which OpenSim refuses a model; empty if a joint could not be read, or if there is no joint.
    pub without_joint: Vec<ComponentId>,
    /// For each joined body, the topmost body of its joint tree.
    tops: HashMap<ComponentId, ComponentId>,
    /// Bodies that are welded to ground, directly or through other bodies.
    welded: HashSet<ComponentId>,
    /// Bodies that are welded to ground and have no child body.
    excluded_from_mass: HashSet<ComponentId>,
}

/// Joints by which a body can move away from another body.
const SEPARATING_JOINTS: [&str; 3] = ["FreeJoint", "PlanarJoint", "SliderJoint"];

impl Skeleton {
    /// Reads all bodies and joints. A joint whose frames refer to no body is left out: only limbs need it, and a body without a joint to a
    /// parent counts as standing on ground.
    pub(crate) fn read(components: &Components) -> Self {
        let mut skeleton = Self::read_joints(components);
        let bodies = components.tree.iter().filter(|(id, _)| components.tag(*id) == "Body");
        let bodies = bodies.filter(|(id, _)| !components.is_ground(*id)).map(|(id, component)| {
            let document = components.document(component.file);
            let mass = document.value(component.element, Class::Body, Property::Mass, "mass");
            let (name, path) = (components.name(id).into_owned(), components.tree.path(id));
            let (fixed, excluded_from_mass) =
                (skeleton.welded.contains(&id), skeleton.excluded_from_mass.contains(&id));
            let centre_of_mass_m =
                document.triple(component.element, "mass_center").unwrap_or_default().into();
            Body { name, path, mass, file: component.file, fixed, excluded_from_mass, centre_of_mass_m }
        });
        skeleton.bodies = bodies.collect();
        skeleton
    }

    /// Leaves the bodies of plates out of the mass of the model. A plate is a joint tree without left and right that carries the floor of
    /// moving spheres, and no such sphere.
    pub(crate) fn exclude_plates(&mut self, components: &Components, forces: &[Force], spheres: &[Sphere]) {
        let moving = |id: &SphereId| spheres.get(id.index()).filter(|sphere| !sphere.fixed);
        let top = |base: &Carrier| if let Carrier::Body(body) = base { Some(self.top(*body)) } else { None };
        let on_floors = forces.iter().filter(|force| force.spheres().iter().any(|id| moving(id).is_some()));
        let floors = on_floors.flat_map(Force::half_space_bases);
        let mut plates: HashSet<ComponentId> = floors.filter_map(|base| top(&base)).collect();
        let moving = forces.iter().flat_map(Force::spheres).filter_map(moving);
        moving.filter_map(|sphere| top(&sphere.base)).for_each(|top| {
            plates.remove(&top);
        });
        if plates.is_empty() {
            return;
        }
        let bodies = components.tree.iter().map(|(id, _)| id).filter(|id| components.tag(*id) == "Body");
        let bodies = bodies.filter(|id| !components.is_ground(*id));
        let tops: Vec<ComponentId> = bodies.map(|id| self.top(id)).collect();
        let has_side = |top: ComponentId| {
            let mut of_tree = tops.iter().zip(&self.bodies).filter(|(other, _)| **other == top);
            of_tree.any(|(_, body)| Side::of_name(&body.name).is_some())
        };
        plates.retain(|top| !has_side(*top));
        for (top, body) in tops.iter().zip(&mut self.bodies) {
            body.excluded_from_mass |= plates.contains(top);
        }
    }

    pub(crate) fn parent(&self, body: ComponentId) -> Option<ComponentId> {
        if let Carrier::Body(parent) = self.parents.get(&body)? { Some(*parent) } else { None }
    }

    /// The topmost body of the joint tree of `body`, which is joined to ground; `body` itself if no other body is above it.
    pub(crate) fn top(&self, body: ComponentId) -> ComponentId {
        self.tops.get(&body).copied().unwrap_or(body)
    }

    /// Whether `base` is ground or a body that is welded to ground.
    pub(crate) fn is_fixed(&self, base: Carrier) -> bool {
        match base {
            Carrier::Ground => true,
            Carrier::Unknown => false,
            Carrier::Body(body) => self.welded.contains(&body),
        }
    }

    /// Reads the joints, and finds the parent and the topmost body of each body.
    fn read_joints(components: &Components) -> Self {
        let mut joined = Self::default();
        let mut links = Vec::new();
        let (mut last_joined, mut are_read) = (None, true);
        for (id, component) in components.tree.iter() {
            let tag = components.tag(id);
            if tag.ends_with("Joint") {
                let inside = component.parent.filter(|&owner| components.tag(owner) == "Body");
                if inside.is_some() && std::mem::replace(&mut last_joined, inside) == inside {
                    joined.ignored_joints.push(id);
                } else {
                    let link = joined.add_joint(components, id, tag == "WeldJoint");
                    are_read &= link.is_some();
                    links.extend(link);
                }
            }
        }
        if are_read && !links.is_empty() {
            let ends: HashSet<Carrier> = links.iter().flat_map(|link| link.ends).collect();
            let bodies = components.tree.iter().map(|(id, _)| id).filter(|&id| components.tag(id) == "Body");
            // A joint inside of a body is that of the first body of the name.
            let is_copy = |id| {
                let has_joint =
                    components.document_of(id).tree().child(components.element(id), "Joint").is_some();
                has_joint && components.tree.get(id).is_some_and(|body| body.unnumbered_name.is_some())
            };
            let is_loose = |id| is_copy(id) || !ends.contains(&Carrier::Body(id));
            let bodies = bodies.filter(|&id| !components.is_ground(id) && is_loose(id));
            joined.without_joint = bodies.collect();
        }
        joined.loops = Loops::of(&links);
        joined.find_tops();
        joined.welded = welded_to(vec![Carrier::Ground], &links);
        joined.excluded_from_mass = excluded_from_mass(&joined.welded, &links);
        joined
    }

    /// Finds the topmost body of each joint tree. Each body is visited once. A loop of joints is cut above its body that comes first in the
    /// files.
    fn find_tops(&mut self) {
        let mut joined: Vec<ComponentId> = self.parents.keys().copied().collect();
        joined.sort_unstable();
        for body in joined {
            // Up to a body whose top is known, or to a top.
            let mut path = vec![body];
            let mut on_path = HashSet::from_iter([body]);
            let top = loop {
                let Some(&last) = path.last() else { break body };
                if let Some(&top) = self.tops.get(&last) {
                    break top;
                }
                let Some(parent) = self.parent(last) else { break last };
                if !on_path.insert(parent) {
                    break self.cut_loop(parent);
                }
                path.push(parent);
            };
            self.tops.extend(path.into_iter().map(|id| (id, top)));
        }
    }

    /// Cuts the loop of joints that contains `body`. Returns the new topmost body.
    fn cut_loop(&mut self, body: ComponentId) -> ComponentId {
        let (mut top, mut at) = (body, self.parent(body));
        while let Some(id) = at.filter(|&id| id != body) {
            top = top.min(id);
            at = self.parent(id);
        }
        self.parents.remove(&top);
        top
    }

    fn add_joint(&mut self, components: &Components, joint: ComponentId, weld: bool) -> Option<JointLink> {
        let end = |socket: &str, legacy: &[&str]| -> Option<Carrier> {
            components.base(components.frame_at(joint, socket, legacy)?.component).ok()
        };
        let parent = end("parent_frame", &["parent_body"]).or_else(|| end("parent_body", &[]));
        let owner = components.tree.get(joint).and_then(|component| component.parent);
        let inside = owner.filter(|&id| components.tag(id) == "Body").map(Carrier::Body);
        let child = end("child_frame", &["child_body"]).or_else(|| end("child_body", &[])).or(inside);
        let if_known = |end: Option<Carrier>| end.filter(|end| *end != Carrier::Unknown);
        let ends = [if_known(parent)?, if_known(child)?];
        match (parent, child) {
            (Some(parent), Some(Carrier::Body(child))) => {
                self.parents.entry(child).or_insert(parent);
            }
            // A joint written the other way round, from the body to ground.
            (Some(Carrier::Body(body)), Some(Carrier::Ground)) => {
                self.parents.entry(body).or_insert(Carrier::Ground);
            }
            _ => {}
        }
        let tag = components.tag(joint);
        let (counts_twice, moves_away) = (weld || tag == "FreeJoint", SEPARATING_JOINTS.contains(&tag));
        Some(JointLink { joint, ends, weld, counts_twice, moves_away })
    }
}

/// The bodies that WeldJoints connect with a member of `from`, directly or through other bodies, whatever the direction of each joint.
fn welded_to(from: Vec<Carrier>, links: &[JointLink]) -> HashSet<ComponentId> {
    let mut at: HashMap<Carrier, Vec<Carrier>> = HashMap::new();
    for [one, other] in links.iter().filter(|link| link.weld).map(|link| link.ends) {
        at.entry(one).or_default().push(other);
        at.entry(other).or_default().push(one);
    }
    let (mut welded, mut next) = (HashSet::new(), from);
    while let Some(from) = next.pop() {
        for &to in at.get(&from).into_iter().flatten() {
            if let Carrier::Body(body) = to
                && welded.insert(body)
            {
                next.push(to);
            }
        }
    }
    welded
}

/// The bodies welded to ground without a child body, direct or indirect. A fixed body that carries others is part of the animal, such as a
/// pelvis that is welded to ground.
fn excluded_from_mass(welded: &HashSet<ComponentId>, links: &[JointLink]) -> HashSet<ComponentId> {
    let is_fixed = |end: &Carrier| matches!(end, Carrier::Body(body) if welded.contains(body));
    let is_free = |end: &Carrier| matches!(end, Carrier::Body(body) if !welded.contains(body));
    let holds = |link: &&JointLink| !link.moves_away && link.ends.iter().any(is_free);
    let holding: Vec<Carrier> =
        links.iter().filter(holds).flat_map(|link| link.ends).filter(|end| is_fixed(end)).collect();
    let mut hangs = welded_to(holding.clone(), links);
    hangs.extend(
        holding.into_iter().filter_map(|end| if let Carrier::Body(body) = end { Some(body) } else { None }),
    );
    welded.difference(&hangs).copied().collect()
}

// Loops of joints, and joints that OpenSim ignores: where a body has more than one.

/// A joint between two bodies, or between a body and ground.
#[derive(Debug, Clone, Copy)]
struct JointLink {
    pub joint: ComponentId,
    pub ends: [Carrier; 2],
    pub weld: bool,
    /// Whether the joint is a WeldJoint or a FreeJoint. If a loop contains such a joint, OpenSim counts a body twice.
    pub counts_twice: bool,
    /// Whether the joint lets its bodies move away from each other, as an animal moves over the ground.
    pub moves_away: bool,
}

/// Loops of joints. OpenSim has to break them, because it needs a tree.
#[derive(Debug, Default)]
pub struct Loops {
    /// Joints in loops, or between two loops, in file order.
    pub joints: Vec<ComponentId>,
    /// Whether OpenSim sums other masses than those of the bodies.
    pub mass_is_in_doubt: bool,
}

impl Loops {
    /// Finds the joints in loops: bodies with only one remaining joint are removed again and again; the remaining bodies are joined in
    /// loops.
    fn of(links: &[JointLink]) -> Self {
        let mut at: HashMap<Carrier, Vec<usize>> = HashMap::new();
        for (index, link) in links.iter().enumerate() {
            for end in link.ends {
                at.entry(end).or_default().push(index);
            }
        }
        let mut left: Vec<bool> = vec![true; links.len()];
        let mut count: HashMap<Carrier, usize> = at.iter().map(|(&end, links)| (end, links.len())).collect();
        let mut ends: Vec<Carrier> =
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
            mass_is_in_doubt: in_loop()
                .any(|link| link.counts_twice && link.ends.iter().all(|end| matches!(end, Carrier::Body(_)))),
        }
    }
}
