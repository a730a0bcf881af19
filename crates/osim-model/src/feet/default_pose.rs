//! Where bodies are in ground while all coordinates have their default values, over all joints.

use std::collections::VecDeque;
use std::sync::Arc;

use foldhash::{HashMap, HashMapExt, HashSet};
use glam::DVec3;

use super::couplers::CoordinateValues;
use super::fault::PoseFault;
use crate::model::{Model, ModelJoint, Placement};

/// If two ways over joints lead to places as close as this, they lead to one place, m.
const SAME_PLACE_M: f64 = 1e-9;

/// Where each body is in ground at the default pose, as OpenSim's `initSystem` leaves it: coordinates at `default_value`, locked
/// and clamped ones too; prescribed ones where their function is at time 0; those that a CoordinateCouplerConstraint makes
/// depend on another where it puts them. Other constraints, functions of several coordinates and joints of plugins are not
/// understood.
///
/// ```
/// use osim_model::DVec3;
/// use osim_model::feet::DefaultPose;
///
/// let text = r#"<OpenSimDocument Version="40000"><Model><BodySet><objects><Body name="foot"><mass>1</mass></Body></objects>
/// </BodySet><JointSet><objects><SliderJoint name="j"><socket_parent_frame>/ground</socket_parent_frame>
/// <socket_child_frame>/bodyset/foot</socket_child_frame><coordinates><Coordinate name="x"><default_value>0.5</default_value>
/// </Coordinate></coordinates></SliderJoint></objects></JointSet></Model></OpenSimDocument>"#;
/// let model = osim_model::Model::parse(text)?;
/// assert_eq!(DefaultPose::of(&model).placement("foot").map(|there| there.translation_m), Ok(0.5 * DVec3::X));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct DefaultPose(Arc<Placements>);

#[derive(Debug, Clone, PartialEq)]
struct Placements {
    placements: HashMap<String, Result<Placement, PoseFault>>,
    /// Why none of the placements is certain.
    doubt: Option<PoseFault>,
}

impl DefaultPose {
    pub fn of(model: &Model) -> Self {
        Self(Arc::clone(model.derived_from_bodies(|model| Arc::new(Placements::of(model)))))
    }

    /// Placement of the frame of `body` in ground.
    pub fn placement(&self, body: &str) -> Result<&Placement, PoseFault> {
        if let Some(doubt) = &self.0.doubt {
            return Err(doubt.clone());
        }
        let not_joined = || PoseFault::NotJoined { body: body.to_owned() };
        self.0.placements.get(body).ok_or_else(not_joined)?.as_ref().map_err(Clone::clone)
    }
}

impl Placements {
    fn of(model: &Model) -> Self {
        let joints = model.joints();
        let coordinates = CoordinateValues::at_default_pose(model);
        let places = JointPlacements { model, values: &coordinates.values };
        let mut pose = Self { placements: HashMap::new(), doubt: coordinates.doubt.clone() };
        let open = pose.place_all(joints, &places);
        pose.doubt = pose.doubt.or(open);
        pose
    }

    /// Places all bodies, from ground on. Returns a fault if a joint closes a loop, but not at the place to which the other way leads.
    fn place_all(&mut self, joints: &[ModelJoint], places: &JointPlacements<'_>) -> Option<PoseFault> {
        let mut open = None;
        for JointStep { joint, from, to, forward, closes } in joints_from_ground(joints) {
            let placement = self.placement_beyond(joint, from, forward, places);
            let earlier = match to {
                None => Some(Ok(Placement::IDENTITY)),
                Some(body) => self.placements.get(body).cloned(),
            };
            match (earlier, to) {
                (Some(known), _) if closes && !are_equal_placements(&known, &placement) => {
                    open = open.or(Some(PoseFault::Loop { joint: joint.name.clone() }));
                }
                (None, Some(body)) => {
                    self.placements.insert(body.to_owned(), placement);
                }
                _ => {}
            }
        }
        open
    }

    /// The placement of the body at the other end of `joint`.
    fn placement_beyond(
        &self,
        joint: &ModelJoint,
        here: Option<&str>,
        forward: bool,
        places: &JointPlacements<'_>,
    ) -> Result<Placement, PoseFault> {
        let placement = places.placement(joint)?;
        let placement = if forward { placement } else { placement.inverse() };
        match here.and_then(|body| self.placements.get(body)) {
            Some(here) => Ok(here.clone()?.then(&placement)),
            None => Ok(placement),
        }
    }
}

/// Computes where the child of a joint is in its parent at the default pose.
struct JointPlacements<'m> {
    model: &'m Model,
    values: &'m HashMap<String, f64>,
}

impl JointPlacements<'_> {
    /// Placement of the joint's child frame in its parent frame.
    fn placement(&self, joint: &ModelJoint) -> Result<Placement, PoseFault> {
        let mut values = Vec::new();
        for coordinate in &joint.coordinates {
            let missing =
                || PoseFault::Coordinate { coordinate: coordinate.name.clone(), joint: joint.name.clone() };
            values.push(*self.values.get(&coordinate.name).ok_or_else(missing)?);
        }
        let unknown = || PoseFault::Joint { joint: joint.name.clone(), class: joint.class.clone() };
        let placement = joint.placement(self.model, &values).ok_or_else(unknown)?;
        if placement.point(DVec3::ONE).is_finite() { Ok(placement) } else { Err(unknown()) }
    }
}

/// Whether two placements are one; also if one of them is not known.
fn are_equal_placements(known: &Result<Placement, PoseFault>, other: &Result<Placement, PoseFault>) -> bool {
    let (Ok(known), Ok(other)) = (known, other) else { return true };
    let places = [DVec3::ZERO, DVec3::X, DVec3::Y];
    places.into_iter().all(|point| known.point(point).abs_diff_eq(other.point(point), SAME_PLACE_M))
}

// All joints in the order in which they are reached from ground.

/// A joint that is reached from ground over other joints.
#[derive(Debug, Clone, Copy)]
pub struct JointStep<'j> {
    pub joint: &'j ModelJoint,
    /// The body at which it is reached; `None` is ground.
    pub from: Option<&'j str>,
    /// The body at the end of the path.
    pub to: Option<&'j str>,
    /// Whether the step leads from the joint's parent to its child.
    pub forward: bool,
    /// Whether `to` was reached over other joints before: the joint closes a loop.
    pub closes: bool,
}

/// The joints that are connected to ground, each once, in an order in which the body `from` of each is reached before it.
///
/// ```
/// use osim_model::feet::joints_from_ground;
///
/// # let bytes: &[u8] = include_bytes!("../../tests/data/one_foot.osim");
/// let model = osim_model::Model::parse(bytes)?;
/// let reached: Vec<Option<&str>> = joints_from_ground(model.joints()).iter().map(|crossing| crossing.to).collect();
/// assert!(joints_from_ground(model.joints()).first().is_none_or(|first| first.from.is_none()), "{reached:?}");
/// # Ok::<(), osim_model::Fault>(())
/// ```
pub fn joints_from_ground(joints: &[ModelJoint]) -> Vec<JointStep<'_>> {
    let mut at: HashMap<Option<&str>, Vec<usize>> = HashMap::new();
    for (index, joint) in joints.iter().enumerate() {
        at.entry(joint.parent.as_deref()).or_default().push(index);
        at.entry(joint.child.as_deref()).or_default().push(index);
    }
    let mut used = vec![false; joints.len()];
    let mut reached: HashSet<Option<&str>> = HashSet::from_iter([None]);
    let mut waiting: VecDeque<Option<&str>> = VecDeque::from([None]);
    let mut walk = Vec::with_capacity(joints.len());
    while let Some(from) = waiting.pop_front() {
        for &index in at.get(&from).into_iter().flatten() {
            let (Some(joint), Some(used)) = (joints.get(index), used.get_mut(index)) else { continue };
            if std::mem::replace(used, true) {
                continue;
            }
            let forward = joint.parent.as_deref() == from;
            let to = if forward { joint.child.as_deref() } else { joint.parent.as_deref() };
            let closes = !reached.insert(to);
            if !closes {
                waiting.push_back(to);
            }
            walk.push(JointStep { joint, from, to, forward, closes });
        }
    }
    walk
}

/// Bodies that WeldJoints hold together, directly or through others.
pub(crate) struct Welds<'j> {
    /// For each body another one of its group; the first of a group has none. `None` is ground.
    leaders: HashMap<Option<&'j str>, Option<&'j str>>,
}

impl<'j> Welds<'j> {
    pub(crate) fn of(joints: &'j [ModelJoint]) -> Self {
        let mut welds = Self { leaders: HashMap::new() };
        for joint in joints.iter().filter(|joint| joint.class == "WeldJoint") {
            let parent = welds.leader(joint.parent.as_deref());
            let child = welds.leader(joint.child.as_deref());
            if parent != child {
                welds.leaders.insert(child, parent);
            }
        }
        welds
    }

    /// Whether two bodies are one, or welded to each other; `None` is ground.
    pub(crate) fn are_welded(&self, one: Option<&'j str>, other: Option<&'j str>) -> bool {
        self.leader(one) == self.leader(other)
    }

    fn leader(&self, body: Option<&'j str>) -> Option<&'j str> {
        let mut at = body;
        while let Some(&next) = self.leaders.get(&at) {
            at = next;
        }
        at
    }
}
