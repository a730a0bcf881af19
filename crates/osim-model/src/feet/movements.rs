//! How bodies can move against each other, by the free coordinates of joints.

use std::sync::Arc;

use foldhash::{HashMap, HashMapExt};
use glam::DVec3;

use super::couplers::{CoordinateState, CoordinateStates, CoordinateValues};
use crate::model::{Model, ModelJoint, Placement};

/// The change of a coordinate, rad or m, that tests how the coordinate moves bodies.
const TRIAL_COORDINATE_STEP: f64 = 0.1;
/// Two rotations or translations are equal if their components differ by at most this.
const EQUAL_MOVEMENT_TOLERANCE: f64 = 1e-9;
/// The largest number of bodies on a path to ground.
const MOST_JOINTS: usize = 64;

/// The relative movements that joints allow between two bodies.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Mobility {
    /// Whether a coordinate turns one of the bodies against the other.
    pub turns: bool,
    /// Whether a coordinate shifts one of the bodies against the other without turning it.
    pub slides: bool,
}

/// The joint above a body: its parent body, and the movements that it allows.
#[derive(Debug, Clone)]
struct JointAbove {
    /// The parent body of the joint; `None` is ground.
    parent: Option<String>,
    mobility: Mobility,
}

/// The possible movements of the bodies of a model. Locked and prescribed coordinates, and those that a coupler constraint determines, are
/// not free. A joint that is not supported counts as free in all directions.
#[derive(Debug, Clone)]
pub struct Movements(Arc<PathsToGround>);

/// The chains of joints from bodies to ground.
#[derive(Debug, Clone)]
struct PathsToGround {
    above: HashMap<String, JointAbove>,
    ends: HashMap<String, PathEnd>,
}

/// The last body on the path from a body to ground, and whether a joint on the path can move.
#[derive(Debug, Clone)]
struct PathEnd {
    /// The last body on the path, which is joined to ground or has no joint above.
    top: String,
    /// Whether a joint on the path can move.
    moves: bool,
}

impl Mobility {
    /// Rotations and translations.
    const ALL: Self = Self { turns: true, slides: true };

    /// Whether any movement is possible.
    pub const fn is_any(self) -> bool {
        self.turns || self.slides
    }

    /// The movements that one or the other allows.
    fn or(self, other: Self) -> Self {
        Self { turns: self.turns || other.turns, slides: self.slides || other.slides }
    }
}

impl Movements {
    /// The movements of the bodies of `model`, which are computed once for each model.
    pub fn of(model: &Model) -> Self {
        Self(Arc::clone(model.derived_from_bodies(|model| Arc::new(PathsToGround::of(model)))))
    }

    /// Whether `body` can move relative to ground.
    pub fn can_move(&self, body: &str) -> bool {
        // A body without a parent moves freely.
        self.0.ends.get(body).is_none_or(|end| end.moves)
    }

    /// The topmost body above `body`; `body` itself if no body is above it.
    pub fn top<'b>(&'b self, body: &'b str) -> &'b str {
        self.0.ends.get(body).map_or(body, |end| end.top.as_str())
    }

    /// The free relative movements of two bodies; `None` if only ground connects them.
    pub fn between(&self, one: &str, other: &str) -> Option<Mobility> {
        let (one, other) = (self.0.path(one), self.0.path(other));
        let (mut here, mut there) = (one.len(), other.len());
        // From the top down, as long as both ways are one.
        while here > 0
            && there > 0
            && one.get(here - 1).map(|path| path.0) == other.get(there - 1).map(|path| path.0)
        {
            here -= 1;
            there -= 1;
        }
        let steps = one.iter().take(here).chain(other.iter().take(there));
        (here < one.len()).then(|| steps.fold(Mobility::default(), |all, (_, mobility)| all.or(*mobility)))
    }
}

impl PathsToGround {
    /// Finds the joint above each body of `model`.
    fn of(model: &Model) -> Self {
        let coordinates = Coordinates {
            model,
            known: CoordinateValues::at_default_pose(model),
            states: CoordinateStates::of(model),
        };
        let mut above = HashMap::new();
        for joint in model.joints() {
            let (body, parent) = match (&joint.child, &joint.parent) {
                (Some(child), parent) => (child, parent.clone()),
                // A joint written the other way round, from the body to ground.
                (None, Some(body)) => (body, None),
                (None, None) => continue,
            };
            above
                .entry(body.clone())
                .or_insert_with(|| JointAbove { parent, mobility: coordinates.mobility_of(joint) });
        }
        Self { ends: path_ends(&above), above }
    }

    /// `body` and the bodies above it, each with the mobility of the joint above it.
    fn path<'b>(&'b self, body: &'b str) -> Vec<(&'b str, Mobility)> {
        let mut path = Vec::new();
        let mut at = Some(body);
        while let Some(body) = at.filter(|_| path.len() < MOST_JOINTS) {
            let above = self.above.get(body);
            path.push((body, above.map_or(Mobility::ALL, |above| above.mobility)));
            at = above.and_then(|above| above.parent.as_deref());
        }
        path
    }
}

/// The path ends of all joined bodies. Each joint is visited once.
fn path_ends(above: &HashMap<String, JointAbove>) -> HashMap<String, PathEnd> {
    let mut ends: HashMap<String, PathEnd> = HashMap::new();
    for body in above.keys() {
        let (mut path, mut at) = (Vec::new(), Some(body.as_str()));
        // Joints in a circle end where they have all been passed.
        while let Some((name, joint)) = at.and_then(|name| Some((name, above.get(name)?))) {
            if ends.contains_key(name) || path.len() > above.len() {
                break;
            }
            path.push((name, joint.mobility));
            at = joint.parent.as_deref();
        }
        let known = at.and_then(|name| ends.get(name).cloned());
        let last = at.or(path.last().map(|(name, _)| *name)).unwrap_or(body);
        let alone = || PathEnd { top: last.to_owned(), moves: at.is_some() };
        let mut end = known.unwrap_or_else(alone);
        for (name, mobility) in path.into_iter().rev() {
            end.moves |= mobility.is_any();
            ends.insert(name.to_owned(), end.clone());
        }
    }
    ends
}

/// The coordinates of a model, with their values at the default pose.
struct Coordinates<'m> {
    model: &'m Model,
    known: &'m CoordinateValues,
    states: CoordinateStates<'m>,
}

impl Coordinates<'_> {
    /// The movements that the free coordinates of a joint allow.
    fn mobility_of(&self, joint: &ModelJoint) -> Mobility {
        if joint.coordinates.is_empty() {
            return mobility_of_class(&joint.class);
        }
        let own = joint.coordinates.iter().map(|coordinate| self.known.values.get(&coordinate.name).copied());
        let Some(values) = own.collect::<Option<Vec<f64>>>() else { return Mobility::ALL };
        let Some(here) = joint.placement(self.model, &values) else { return Mobility::ALL };
        let is_free = |coordinate| self.states.state_of(joint, coordinate) == CoordinateState::Free;
        let free = joint.coordinates.iter().enumerate().filter(|(_, coordinate)| is_free(coordinate));
        free.fold(Mobility::default(), |all, (index, _)| {
            let mut moved = values.clone();
            moved.iter_mut().skip(index).take(1).for_each(|value| *value += TRIAL_COORDINATE_STEP);
            all.or(joint
                .placement(self.model, &moved)
                .map_or(Mobility::ALL, |there| mobility_between(&here, &there)))
        })
    }
}

/// The mobility of a joint whose coordinates are not in the file, by the joint's class.
fn mobility_of_class(class: &str) -> Mobility {
    match class {
        "WeldJoint" | "CustomJoint" => Mobility::default(),
        "PinJoint" | "UniversalJoint" | "BallJoint" | "GimbalJoint" => {
            Mobility { turns: true, slides: false }
        }
        _ => Mobility::ALL,
    }
}

/// The movements by which two placements differ.
fn mobility_between(here: &Placement, there: &Placement) -> Mobility {
    let differ = |a: DVec3, b: DVec3| (a - b).abs().cmpgt(DVec3::splat(EQUAL_MOVEMENT_TOLERANCE)).any();
    let turned = |axis| differ(here.rotation.to_body(axis), there.rotation.to_body(axis));
    let turns = DVec3::AXES.into_iter().any(turned);
    Mobility { turns, slides: !turns && differ(here.translation_m, there.translation_m) }
}
