//! Computes the places and motions of bodies from values and speeds of coordinates.

use std::collections::{HashMap, HashSet};

use osim_model::feet::{JointStep, PoseFault, joints_from_ground};
use osim_model::{Model, ModelJoint, MovingPlacement, Placement, Speeds};

use crate::recording::Recording;

/// A joint on the path from ground to a body.
struct PathStep<'m> {
    joint: &'m ModelJoint,
    forward: bool,
    /// The index of the body on the ground side of the joint; `None` for ground.
    from: Option<usize>,
    /// Index of the joint's first coordinate among all coordinates of the model.
    first: usize,
    /// Index of the joint in the model.
    number: usize,
}

/// The joints on the paths from ground to some bodies, in the order in which the bodies are placed.
pub(crate) struct JointPaths<'m> {
    model: &'m Model,
    /// The joints in order; the joint with index n places the body with index n.
    steps: Vec<PathStep<'m>>,
    bodies: HashMap<&'m str, usize>,
    /// Names of joints that close a loop. This program does not keep the loops closed.
    pub(crate) loops: Vec<String>,
}

impl<'m> JointPaths<'m> {
    /// The paths to `bodies`.
    ///
    /// # Errors
    /// A body that no path leads to, or a joint on a path that is not understood.
    pub(crate) fn of(model: &'m Model, bodies: &HashSet<&str>) -> Result<Self, PoseFault> {
        let joints = model.joints();
        let (mut first, mut places) = (0, HashMap::new());
        for (number, joint) in joints.iter().enumerate() {
            places.insert(std::ptr::from_ref(joint), (number, first));
            first += joint.coordinates.len();
        }
        let walk = joints_from_ground(joints);
        let wanted = with_ancestors(&walk, bodies);
        let mut paths = Self { model, steps: Vec::new(), bodies: HashMap::new(), loops: Vec::new() };
        for JointStep { joint, from, to, forward, closes, .. } in walk {
            let touches = [from, to].into_iter().flatten().any(|body| wanted.contains(body));
            if closes && touches {
                paths.loops.push(joint.name.clone());
            }
            let Some(body) = to.filter(|body| !closes && wanted.contains(body)) else { continue };
            let Some(&(number, first)) = places.get(&std::ptr::from_ref(joint)) else { continue };
            if joint.placement(model, &vec![0.0; joint.coordinates.len()]).is_none() {
                return Err(PoseFault::Joint { joint: joint.name.clone(), class: joint.class.clone() });
            }
            let from = from.and_then(|body| paths.bodies.get(body).copied());
            paths.bodies.insert(body, paths.steps.len());
            paths.steps.push(PathStep { joint, forward, from, first, number });
        }
        match bodies.iter().find(|&&body| !paths.bodies.contains_key(body)) {
            Some(&body) => Err(PoseFault::NotJoined { body: body.to_owned() }),
            None => Ok(paths),
        }
    }

    /// The index of a body in the results of [`place_bodies`](Self::place_bodies).
    pub(crate) fn body(&self, name: &str) -> Option<usize> {
        self.bodies.get(name).copied()
    }

    /// The joints on the paths; each with the range of its coordinates among all coordinates of the model.
    pub(crate) fn coordinates(&self) -> impl Iterator<Item = (&'m ModelJoint, std::ops::Range<usize>)> + '_ {
        self.steps.iter().map(|step| (step.joint, step.range()))
    }

    /// Writes the places and velocities of all bodies in ground into `places`, for a frame of a recording. Joints whose coordinates are
    /// as in `known` are not computed again.
    pub(crate) fn place_bodies(
        &self,
        recording: &Recording,
        known: Option<&JointMotions<'_>>,
        frame: usize,
        places: &mut Vec<MovingPlacement>,
    ) {
        places.clear();
        for (number, step) in self.steps.iter().enumerate() {
            let is_same = |known: &&JointMotions<'_>| {
                let (other, range) = (known.recording, step.range());
                recording.values(frame).get(range.clone()) == other.values(frame).get(range.clone())
                    && recording.speeds(frame).get(range.clone()) == other.speeds(frame).get(range)
            };
            let motion = known
                .filter(is_same)
                .and_then(|known| known.motions.get(frame * self.steps.len() + number).copied())
                .unwrap_or_else(|| self.motion_of_joint(step, recording, frame));
            let there = step.from.and_then(|body| places.get(body)).map(|above| above.then(&motion));
            places.push(there.unwrap_or(motion));
        }
    }

    /// The motions of all joints on the paths.
    pub(crate) fn motions_of_joints<'r>(&self, recording: &'r Recording) -> JointMotions<'r> {
        let in_frame =
            |frame| self.steps.iter().map(move |step| self.motion_of_joint(step, recording, frame));
        JointMotions { recording, motions: (0..recording.frames()).flat_map(in_frame).collect() }
    }

    /// The placement and velocity of the body after a joint in the body before it, in a frame of a recording.
    fn motion_of_joint(&self, step: &PathStep<'_>, recording: &Recording, frame: usize) -> MovingPlacement {
        let values = recording.values(frame).get(step.range()).unwrap_or_default();
        let speeds = recording.speeds(frame).get(step.range()).unwrap_or_default();
        let speeds = match recording.has_opensim_speeds.get(step.number) {
            Some(true) => Speeds::Generalized(speeds),
            _ => Speeds::Rates(speeds),
        };
        let moving = step.joint.placement_and_velocity(self.model, values, speeds);
        let moving = moving.unwrap_or(MovingPlacement::at_rest(Placement::IDENTITY));
        if step.forward { moving } else { moving.inverse() }
    }
}

/// The placements and velocities of the bodies after all joints in the bodies before them, in all frames of a recording.
pub(crate) struct JointMotions<'r> {
    recording: &'r Recording,
    /// All joints in the first frame, then in the next.
    motions: Vec<MovingPlacement>,
}

impl PathStep<'_> {
    /// The joint's coordinates among all coordinates of the model.
    fn range(&self) -> std::ops::Range<usize> {
        self.first..self.first + self.joint.coordinates.len()
    }
}

/// `bodies` and all bodies between them and ground.
fn with_ancestors<'m>(walk: &[JointStep<'m>], bodies: &HashSet<&str>) -> HashSet<&'m str> {
    let mut wanted: HashSet<&str> = HashSet::new();
    // The walk reaches a body before those below it. So, from its end, each body comes before its parent.
    for step in walk.iter().rev().filter(|step| !step.closes) {
        let Some(body) = step.to else { continue };
        if bodies.contains(body) || wanted.contains(body) {
            wanted.insert(body);
            wanted.extend(step.from);
        }
    }
    wanted
}

/// Places of bodies in ground, in some frames of a recording.
#[derive(Debug, Clone, PartialEq)]
pub struct Poses {
    /// Names of the bodies whose place is known.
    pub bodies: Vec<String>,
    /// The places of all bodies in the first frame, then in the next.
    placements: Vec<Placement>,
}

impl Poses {
    /// Places of all bodies of `model` in each of `frames`, except bodies after a joint that is not understood.
    pub fn of(model: &Model, recording: &Recording, frames: &[usize]) -> Self {
        let names = model.bodies().iter().map(|body| body.name.as_str());
        let known: Vec<&str> =
            names.filter(|&name| JointPaths::of(model, &HashSet::from([name])).is_ok()).collect();
        let mut poses =
            Self { bodies: known.iter().map(|&name| name.to_owned()).collect(), placements: Vec::new() };
        let Ok(paths) = JointPaths::of(model, &known.iter().copied().collect()) else { return poses };
        let numbers: Vec<usize> = known.iter().filter_map(|name| paths.body(name)).collect();
        let mut places = Vec::new();
        for &frame in frames {
            paths.place_bodies(recording, None, frame, &mut places);
            let placed = |&number| {
                places.get(number).map_or(Placement::IDENTITY, |moving: &MovingPlacement| moving.at)
            };
            poses.placements.extend(numbers.iter().map(placed));
        }
        poses
    }

    /// The places of all bodies in one of the chosen frames; `number` is its index among them.
    pub fn frame(&self, number: usize) -> &[Placement] {
        let start = number * self.bodies.len();
        self.placements.get(start..start + self.bodies.len()).unwrap_or_default()
    }
}
