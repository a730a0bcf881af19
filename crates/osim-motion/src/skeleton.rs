//! Where bodies are, and how they move, at any values and speeds of coordinates.

use std::collections::{HashMap, HashSet};

use osim_model::feet::{JointStep, PoseFault, joints_from_ground};
use osim_model::{Model, ModelJoint, MovingPlacement, Placement, Speeds};

use crate::recording::Recording;

/// One joint on the way from ground, with its coordinates among all.
struct Step<'m> {
    joint: &'m ModelJoint,
    forward: bool,
    /// The body that it is reached from; `None` is ground.
    from: Option<usize>,
    /// The first of its coordinates.
    first: usize,
    /// Its place among the joints of the model.
    number: usize,
}

/// The joints that lead from ground to some bodies.
pub(crate) struct Skeleton<'m> {
    model: &'m Model,
    /// The step number n places body number n.
    steps: Vec<Step<'m>>,
    bodies: HashMap<&'m str, usize>,
    /// Joints among them that close a loop, which nothing keeps closed here.
    pub(crate) loops: Vec<String>,
}

impl<'m> Skeleton<'m> {
    /// That of `model`, as far as it carries `bodies`.
    ///
    /// # Errors
    /// A body on no way from ground, or a joint on the way to one that is not understood.
    pub(crate) fn of(model: &'m Model, bodies: &HashSet<&str>) -> Result<Self, PoseFault> {
        let joints = model.joints();
        let (mut first, mut places) = (0, HashMap::new());
        for (number, joint) in joints.iter().enumerate() {
            places.insert(std::ptr::from_ref(joint), (number, first));
            first += joint.coordinates.len();
        }
        let walk = joints_from_ground(joints);
        let wanted = above(&walk, bodies);
        let mut skeleton = Self { model, steps: Vec::new(), bodies: HashMap::new(), loops: Vec::new() };
        for JointStep { joint, from, to, forward, closes, .. } in walk {
            let touches = [from, to].into_iter().flatten().any(|body| wanted.contains(body));
            if closes && touches {
                skeleton.loops.push(joint.name.clone());
            }
            let Some(body) = to.filter(|body| !closes && wanted.contains(body)) else { continue };
            let Some(&(number, first)) = places.get(&std::ptr::from_ref(joint)) else { continue };
            if joint.placement(model, &vec![0.0; joint.coordinates.len()]).is_none() {
                return Err(PoseFault::Joint { joint: joint.name.clone(), class: joint.class.clone() });
            }
            let from = from.and_then(|body| skeleton.bodies.get(body).copied());
            skeleton.bodies.insert(body, skeleton.steps.len());
            skeleton.steps.push(Step { joint, forward, from, first, number });
        }
        let lost = bodies.iter().find(|&&body| !skeleton.bodies.contains_key(body));
        match lost {
            Some(&body) => Err(PoseFault::NotJoined { body: body.to_owned() }),
            None => Ok(skeleton),
        }
    }

    /// The number of a body among those of [`place`](Self::place).
    pub(crate) fn body(&self, name: &str) -> Option<usize> {
        self.bodies.get(name).copied()
    }

    /// The names of the joints that place them, each with its coordinates among all.
    pub(crate) fn coordinates(&self) -> impl Iterator<Item = (&'m ModelJoint, std::ops::Range<usize>)> + '_ {
        self.steps.iter().map(|step| (step.joint, step.first..step.first + step.joint.coordinates.len()))
    }

    /// Puts into `places` where all bodies are in ground where the coordinates have these values and speeds. `of_opensim` says of each
    /// joint whether its speeds are OpenSim's.
    pub(crate) fn place(
        &self,
        values: &[f64],
        speeds: &[f64],
        of_opensim: &[bool],
        places: &mut Vec<MovingPlacement>,
    ) {
        places.clear();
        for step in &self.steps {
            let range = step.first..step.first + step.joint.coordinates.len();
            let speeds = speeds.get(range.clone()).unwrap_or_default();
            let speeds = match of_opensim.get(step.number) {
                Some(true) => Speeds::Generalized(speeds),
                _ => Speeds::Rates(speeds),
            };
            let moving =
                step.joint.moving_placement(self.model, values.get(range).unwrap_or_default(), speeds);
            let moving = moving.unwrap_or(MovingPlacement::still(Placement::IDENTITY));
            let moving = if step.forward { moving } else { moving.inverse() };
            let there = step.from.and_then(|body| places.get(body)).map(|above| above.then(&moving));
            places.push(there.unwrap_or(moving));
        }
    }
}

/// `bodies` and all that they hang on.
fn above<'m>(walk: &[JointStep<'m>], bodies: &HashSet<&str>) -> HashSet<&'m str> {
    let mut wanted: HashSet<&str> = HashSet::new();
    // A body is reached before those below it: from the end, each is known before the one that it hangs on.
    for crossing in walk.iter().rev().filter(|crossing| !crossing.closes) {
        let Some(body) = crossing.to else { continue };
        if bodies.contains(body) || wanted.contains(body) {
            wanted.insert(body);
            wanted.extend(crossing.from);
        }
    }
    wanted
}

/// Where bodies are in each frame of a recording, in ground.
#[derive(Debug, Clone, PartialEq)]
pub struct Poses {
    /// The bodies whose place is known.
    pub bodies: Vec<String>,
    /// The place of each body in the first frame, then in the next.
    placements: Vec<Placement>,
}

impl Poses {
    /// All bodies of `model`, but for those on a joint that is not understood, in each of `frames`.
    pub fn of(model: &Model, recording: &Recording, frames: &[usize]) -> Self {
        let names = model.bodies().iter().map(|body| body.name.as_str());
        let known: Vec<&str> =
            names.filter(|&name| Skeleton::of(model, &HashSet::from([name])).is_ok()).collect();
        let mut poses =
            Self { bodies: known.iter().map(|&name| name.to_owned()).collect(), placements: Vec::new() };
        let Ok(skeleton) = Skeleton::of(model, &known.iter().copied().collect()) else { return poses };
        let numbers: Vec<usize> = known.iter().filter_map(|name| skeleton.body(name)).collect();
        let mut places = Vec::new();
        for &frame in frames {
            skeleton.place(
                recording.values(frame),
                recording.speeds(frame),
                &recording.of_opensim,
                &mut places,
            );
            let placed = |&number| {
                places.get(number).map_or(Placement::IDENTITY, |moving: &MovingPlacement| moving.at)
            };
            poses.placements.extend(numbers.iter().map(placed));
        }
        poses
    }

    /// The places of all bodies in a frame, by its number among those that were asked for.
    pub fn frame(&self, number: usize) -> &[Placement] {
        let start = number * self.bodies.len();
        self.placements.get(start..start + self.bodies.len()).unwrap_or_default()
    }
}
