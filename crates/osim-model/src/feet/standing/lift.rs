//! Finds the coordinate that lifts spheres from their floor, and the part of the joint tree that this coordinate moves;
//! and joint trees whose root cannot move along gravity, and what holds it.

use foldhash::{HashMap, HashMapExt, HashSet, HashSetExt};
use glam::DVec3;

use crate::feet::default_pose::{DefaultPose, JointStep, joints_from_ground};
use crate::feet::movements::{CoordinateState, CoordinateStates, CoordinateValues, Couplers, is_enforced};
use crate::model::{ComponentId, JointCoordinate, Model, ModelJoint, Placement, Side};

/// Two displacements are equal if they differ by at most this, per metre of the coordinate.
const SAME_MOVEMENT: f64 = 1e-9;
/// A coordinate lifts spheres if its change by 1 m raises them by at least this, m, along the floor's normal: the value for a floor of 60
/// degrees.
const LEAST_RISE: f64 = 0.5;

/// A line is level if it rises by at most this part of its length.
const MOST_RISE_OF_LEVEL_LINE: f64 = 0.01;

/// The free coordinate that moves all spheres of a joint tree equally along the normal of their floor.
#[derive(Debug, Clone, PartialEq)]
pub struct LiftingCoordinate {
    /// Name of the coordinate, such as `pelvis_ty`.
    pub coordinate: String,
    pub joint: String,
    /// Value of the coordinate at the default pose, m.
    pub default_m: f64,
    /// The rise of the spheres along the normal for 1 m of the coordinate, m: usually 1, less on a slope.
    pub rise: f64,
}

/// Why no coordinate lifts the spheres of a joint tree from their floor.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum NotLifted {
    #[error("it is welded to the body that carries its floor")]
    Welded,
    /// The coordinates between the joint tree and ground only rotate.
    #[error("it can only rotate about the body that carries its floor")]
    Pinned,
    /// The coordinates between the joint tree and ground move only along the floor.
    #[error("it can only slide along its floor")]
    Slides,
    #[error("{coordinate}, which would lift it, is locked")]
    Locked { coordinate: String },
    /// A coordinate could lift the joint tree, but a function or another coordinate determines its value.
    #[error("{coordinate}, which would lift it, is set by a function")]
    Driven { coordinate: String },
    #[error("its floors have several directions")]
    SeveralFloors,
}

/// How a change of a coordinate moves the spheres below its joint.
enum CoordinateEffect {
    Lifts(f64),
    Slides,
    Other,
}

/// A model at its default pose, in which the lifting coordinate is searched.
pub(super) struct LiftingCoordinateSearch<'m> {
    model: &'m Model,
    pose: &'m DefaultPose,
    known: &'m CoordinateValues,
    pub(super) states: CoordinateStates<'m>,
}

impl<'m> LiftingCoordinateSearch<'m> {
    /// A model at its default pose, ready to search coordinates.
    pub(super) fn of(model: &'m Model, pose: &'m DefaultPose) -> Self {
        Self {
            model,
            pose,
            known: CoordinateValues::at_default_pose(model),
            states: CoordinateStates::of(model),
        }
    }

    /// Finds the coordinate of the joints on `path` that lifts most along `normal`. Also returns the index of its joint on the path.
    pub(super) fn find(
        &self,
        path: &[ParentJoint<'_>],
        normal: DVec3,
    ) -> Result<(usize, LiftingCoordinate), NotLifted> {
        let mut best: Option<(usize, LiftingCoordinate)> = None;
        let mut not = NotLifted::Welded;
        for (place, parent_joint) in path.iter().enumerate() {
            for (index, coordinate) in parent_joint.joint.coordinates.iter().enumerate() {
                let name = || coordinate.name.clone();
                let moves =
                    self.effect_of_coordinate(parent_joint, index, normal).unwrap_or(CoordinateEffect::Other);
                let found = match (moves, self.states.state_of(parent_joint.joint, coordinate)) {
                    (CoordinateEffect::Lifts(rise), CoordinateState::Free) => {
                        let more = best
                            .as_ref()
                            .is_none_or(|(_, known)| rise.abs() > known.rise.abs() + SAME_MOVEMENT);
                        let default_m = self.known.values.get(&coordinate.name).copied().filter(|_| more);
                        let joint = parent_joint.joint.name.clone();
                        let lift = |default_m| {
                            (place, LiftingCoordinate { coordinate: name(), joint, default_m, rise })
                        };
                        best = default_m.map(lift).or(best);
                        continue;
                    }
                    (CoordinateEffect::Lifts(_), CoordinateState::Locked) => {
                        NotLifted::Locked { coordinate: name() }
                    }
                    (CoordinateEffect::Lifts(_), CoordinateState::Driven) => {
                        NotLifted::Driven { coordinate: name() }
                    }
                    (CoordinateEffect::Slides, CoordinateState::Free) => NotLifted::Slides,
                    (CoordinateEffect::Other, CoordinateState::Free) => NotLifted::Pinned,
                    _ => continue,
                };
                not = more_useful_reason(not, found);
            }
        }
        best.ok_or(not)
    }

    fn effect_of_coordinate(
        &self,
        parent_joint: &ParentJoint<'_>,
        index: usize,
        normal: DVec3,
    ) -> Option<CoordinateEffect> {
        let moved = self.displacements_of_bodies(parent_joint, index, [1.0, 0.5, -1.0])?;
        let turned = |moved: &Placement| moved.rotation.inverse().to_body(normal);
        let unturned = moved.iter().all(|moved| turned(moved).abs_diff_eq(normal, SAME_MOVEMENT));
        let [rise, half, back] = moved.map(|moved| moved.translation_m.dot(normal));
        let is_even = (half - 0.5 * rise).abs() <= SAME_MOVEMENT && (back + rise).abs() <= SAME_MOVEMENT;
        let moves =
            moved.iter().any(|moved| moved.translation_m.abs().cmpgt(DVec3::splat(SAME_MOVEMENT)).any());
        Some(match unturned {
            true if is_even && rise.abs() >= LEAST_RISE => CoordinateEffect::Lifts(rise),
            true if is_even && moves => CoordinateEffect::Slides,
            _ => CoordinateEffect::Other,
        })
    }

    /// The displacements in ground of the bodies below the joint, if its coordinate number `index` grows by each of `metres`.
    fn displacements_of_bodies(
        &self,
        parent_joint: &ParentJoint<'_>,
        index: usize,
        metres: [f64; 3],
    ) -> Option<[Placement; 3]> {
        let joint = parent_joint.joint;
        let value = |coordinate: &JointCoordinate| self.known.values.get(&coordinate.name).copied();
        let mut values: Vec<f64> = joint.coordinates.iter().map(value).collect::<Option<_>>()?;
        let at_rest = *values.get(index)?;
        let parent = match parent_joint.parent {
            Some(body) => *self.pose.placement(body).ok()?,
            None => Placement::IDENTITY,
        };
        let placed = |values: &[f64]| {
            let placement = joint.placement(self.model, values)?;
            Some(parent.then(&if parent_joint.forward { placement } else { placement.inverse() }))
        };
        let back = placed(&values)?.inverse();
        let mut displacements = [Placement::IDENTITY; 3];
        for (displacement, metres) in displacements.iter_mut().zip(metres) {
            *values.get_mut(index)? = at_rest + metres;
            *displacement = placed(&values)?.then(&back);
        }
        Some(displacements)
    }
}

/// The reason that says more to the user.
fn more_useful_reason(one: NotLifted, other: NotLifted) -> NotLifted {
    let rank = |reason: &NotLifted| match reason {
        NotLifted::Welded => 0,
        NotLifted::Pinned => 1,
        NotLifted::Slides => 2,
        _ => 3,
    };
    if rank(&other) > rank(&one) { other } else { one }
}

// Joints as a tree from ground: the joint above a body, and the bodies below a joint.

/// The joint between a body and its parent, which is ground or another body.
#[derive(Debug, Clone, Copy)]
pub(super) struct ParentJoint<'j> {
    pub(super) joint: &'j ModelJoint,
    pub(super) body: &'j str,
    /// The body above the joint; `None` is ground.
    pub(super) parent: Option<&'j str>,
    /// Whether the joint's parent, in the file, is the upper body.
    pub(super) forward: bool,
}

/// The bodies of a model as a tree from ground. A joint that closes a loop is left out.
pub(super) struct JointTree<'j> {
    above: HashMap<&'j str, ParentJoint<'j>>,
    below: HashMap<&'j str, Vec<&'j str>>,
    /// For each body, the topmost body of its tree, which is joined to ground.
    tops: HashMap<&'j str, &'j str>,
}

impl<'j> JointTree<'j> {
    /// The tree of bodies that `joints` connect with ground.
    pub(super) fn of(joints: &'j [ModelJoint]) -> Self {
        let count = joints.len();
        let (above, tops) = (HashMap::with_capacity(count), HashMap::with_capacity(count));
        let mut tree = Self { above, below: HashMap::with_capacity(count), tops };
        for JointStep { joint, from, to, forward, closes } in joints_from_ground(joints) {
            let Some(body) = to.filter(|_| !closes) else { continue };
            // What is above a body is walked to before it.
            let top = from.and_then(|above| tree.tops.get(above).copied()).unwrap_or(body);
            tree.tops.insert(body, top);
            tree.above.insert(body, ParentJoint { joint, body, parent: from, forward });
            tree.below.entry(from.unwrap_or_default()).or_default().push(body);
        }
        tree
    }

    pub(super) fn path_to_ground(&self, body: &str) -> Vec<ParentJoint<'j>> {
        let next = |at: &&ParentJoint<'j>| self.above.get(at.parent?);
        std::iter::successors(self.above.get(body), next).copied().collect()
    }

    /// The topmost body in the tree of `body`, which is joined to ground.
    pub(super) fn top(&self, body: &str) -> Option<&'j str> {
        self.tops.get(body).copied()
    }

    /// The joints above all of `bodies`, from the lowest joint to ground. Each body is visited once.
    pub(super) fn common_path_to_ground(&self, bodies: &[&str]) -> Vec<ParentJoint<'j>> {
        let Some(first) = bodies.first() else { return Vec::new() };
        let path = self.path_to_ground(first);
        // Where on the first way the ways of other bodies end.
        let mut joins: HashMap<&str, usize> =
            path.iter().enumerate().map(|(place, parent_joint)| (parent_joint.body, place)).collect();
        let mut common = 0;
        for body in bodies {
            let mut passed = Vec::new();
            let mut at = self.above.get(body);
            while let Some(parent_joint) = at.filter(|parent_joint| !joins.contains_key(parent_joint.body)) {
                passed.push(parent_joint.body);
                at = parent_joint.parent.and_then(|parent| self.above.get(parent));
            }
            let place =
                at.and_then(|parent_joint| joins.get(parent_joint.body).copied()).unwrap_or(path.len());
            joins.extend(passed.into_iter().map(|body| (body, place)));
            common = common.max(place);
        }
        path.into_iter().skip(common).collect()
    }

    pub(super) fn with_all_below(&self, body: &'j str) -> HashSet<&'j str> {
        let mut bodies = HashSet::from_iter([body]);
        let mut waiting = vec![body];
        while let Some(above) = waiting.pop() {
            let below = self.below.get(above).into_iter().flatten().copied();
            waiting.extend(below.filter(|body| bodies.insert(body)));
        }
        bodies
    }
}

/// The joint trees of `bodies` that cannot move along gravity: the topmost body of each, and what holds it in words.
pub fn held_roots<'b>(model: &Model, bodies: impl Iterator<Item = &'b str>) -> Vec<(String, String)> {
    let (tree, pose) = (JointTree::of(model.joints()), DefaultPose::of(model));
    let search = LiftingCoordinateSearch::of(model, &pose);
    let components = model.components();
    let constraints = model.constraints_to_ground().into_iter();
    let holds = |id: ComponentId| {
        let (document, element) = (components.document_of(id), components.element(id));
        // A point on a line that is not level can fall along it. Bodies stand upright, so that a line of theirs is as if in ground.
        let line = document.triple(element, "line_direction_vec").unwrap_or_default();
        let rise = DVec3::from(line).normalize_or_zero().dot(model.up()).abs();
        is_enforced(document, element) && rise <= MOST_RISE_OF_LEVEL_LINE
    };
    let holding = constraints.filter(|(id, _)| holds(*id));
    let constraints: Vec<_> = holding.map(|(id, body)| (body, components.name(id))).collect();
    let mut tops = HashSet::new();
    let first_of_tree =
        bodies.filter_map(|body| Some((tree.top(body).filter(|top| tops.insert(*top))?, body)));
    let held = first_of_tree.filter_map(|(top, body)| {
        let mut path = tree.path_to_ground(body);
        let is_of_leg = |above: &&ParentJoint<'_>| above.body != top && Side::of_name(above.body).is_some();
        let trunk = path.split_off(path.iter().take_while(is_of_leg).count());
        let below = tree.with_all_below(top);
        let is_trunk = |held: &str| {
            trunk.iter().any(|above| above.body == held)
                || (below.contains(held) && Side::of_name(held).is_none())
        };
        let constraint = constraints.iter().find(|(held, _)| is_trunk(held));
        let fixed = constraint.map(|(held, name)| format!("{name} fixes {held} to ground"));
        Some((top.to_owned(), fixed.or_else(|| what_holds_root(model, &search, &trunk))?))
    });
    held.collect()
}

/// What keeps the bodies below `path` from moving along gravity; `None` if a coordinate is free to.
fn what_holds_root(
    model: &Model,
    search: &LiftingCoordinateSearch<'_>,
    path: &[ParentJoint<'_>],
) -> Option<String> {
    match search.find(path, model.up()).err()? {
        NotLifted::Locked { coordinate } => Some(format!("{coordinate} is locked")),
        NotLifted::Driven { coordinate } => {
            let coupler = Couplers::of(model).couplers.iter().find(|coupler| coupler.dependent == coordinate);
            // What follows another coordinate moves with it.
            let is_constant =
                coupler.and_then(|one| one.value_and_slope(0.0)).is_none_or(|(_, slope)| slope == 0.0);
            is_constant.then(|| format!("a function sets {coordinate}"))
        }
        _ => {
            let root = path.last()?.joint;
            let is_free = |coordinate| search.states.state_of(root, coordinate) == CoordinateState::Free;
            let is_fixed = !root.coordinates.iter().any(is_free)
                && (!root.coordinates.is_empty() || root.class == "WeldJoint");
            is_fixed.then(|| format!("{} ({}) cannot move", root.name, root.class))
        }
    }
}
