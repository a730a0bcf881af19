//! The places of bodies in ground at the default pose, where all coordinates have their default values.

use std::collections::VecDeque;
use std::f64::consts::FRAC_PI_4;
use std::sync::Arc;

use foldhash::{HashMap, HashMapExt, HashSet};
use glam::DVec3;

use super::fault::PoseFault;
use super::movements::CoordinateValues;
use crate::model::angle_between;
use crate::model::{Model, ModelJoint, Placement};

/// Two chains of joints to one body agree if they lead to places at most this far apart, m.
const SAME_PLACE_M: f64 = 1e-9;

/// The place of each body in ground at the default pose, as OpenSim's `initSystem` leaves it. Coordinates have their `default_value`, also
/// locked and clamped ones; prescribed coordinates have the value of their function at time 0; a `CoordinateCouplerConstraint` sets its
/// dependent coordinate. Other constraints, functions of several coordinates and joints of plugins are not supported.
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

/// The placements of all bodies in ground at the default pose.
#[derive(Debug, Clone, PartialEq)]
struct Placements {
    placements: HashMap<String, Result<Placement, PoseFault>>,
    /// The reason why all placements are uncertain, such as a constraint that is not supported.
    doubt: Option<PoseFault>,
}

/// The pose with all coordinates at 0, and the name of the heaviest body.
struct AtZero {
    pose: DefaultPose,
    heaviest: Option<String>,
}

impl AtZero {
    /// Computed once for each model.
    fn of(model: &Model) -> &Self {
        model.derived_from_bodies(|model| {
            let names = model.joints().iter().flat_map(|joint| &joint.coordinates);
            let values = names.map(|coordinate| (coordinate.name.clone(), 0.0)).collect();
            let masses = model.bodies().iter().filter_map(|body| Some((body.mass_kg().ok()?, &body.name)));
            Self {
                pose: DefaultPose(Arc::new(Placements::at(model, &CoordinateValues { values, doubt: None }))),
                heaviest: masses.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, name)| name.clone()),
            }
        })
    }
}

impl DefaultPose {
    /// The default pose of `model`, which is computed once for each model.
    pub fn of(model: &Model) -> Self {
        let place = |model: &Model| Arc::new(Placements::at(model, CoordinateValues::at_default_pose(model)));
        Self(Arc::clone(model.derived_from_bodies(place)))
    }

    /// The pose with all coordinates at 0.
    pub(super) fn at_zero(model: &Model) -> &Self {
        &AtZero::of(model).pose
    }

    /// The pose with all coordinates at 0, if the heaviest body is turned against it by more than 45 degrees under `up`: at the default
    /// pose the model lies.
    pub(super) fn before_lying<'m>(&self, model: &'m Model, up: DVec3) -> Option<&'m Self> {
        let AtZero { pose: at_zero, heaviest } = AtZero::of(model);
        let up_in_heaviest = |pose: &Self| pose.direction_in(heaviest.as_ref()?, up).ok();
        let turned_rad = angle_between(up_in_heaviest(self)?, up_in_heaviest(at_zero)?);
        (turned_rad > FRAC_PI_4).then_some(at_zero)
    }

    /// `direction`, a vector in ground, in the frame of `body`.
    pub(super) fn direction_in(&self, body: &str, direction: DVec3) -> Result<DVec3, PoseFault> {
        Ok(self.placement(body)?.rotation.inverse().to_body(direction))
    }

    /// Placement of the frame of `body` in ground. The error says why it is not known.
    pub fn placement(&self, body: &str) -> Result<&Placement, PoseFault> {
        if let Some(doubt) = &self.0.doubt {
            return Err(doubt.clone());
        }
        let not_joined = || PoseFault::NotJoined { body: body.to_owned() };
        self.0.placements.get(body).ok_or_else(not_joined)?.as_ref().map_err(Clone::clone)
    }
}

impl Placements {
    /// Places all bodies at these values of the coordinates, beginning at ground. It is in doubt if a joint closes a loop of joints and the
    /// two chains lead to different places.
    fn at(model: &Model, coordinates: &CoordinateValues) -> Self {
        let placements = HashMap::with_capacity(model.bodies().len());
        let mut pose = Self { placements, doubt: coordinates.doubt.clone() };
        for JointStep { joint, from, to, forward, closes } in joints_from_ground(model.joints()) {
            let in_parent = joint_placement(model, &coordinates.values, joint);
            let placement = pose.placement_beyond(in_parent, from, forward);
            let earlier = match to {
                None => Some(Ok(Placement::IDENTITY)),
                Some(body) => pose.placements.get(body).cloned(),
            };
            match (earlier, to) {
                (Some(known), _) if closes && !are_equal_placements(&known, &placement) => {
                    pose.doubt.get_or_insert(PoseFault::Loop { joint: joint.name.clone() });
                }
                (None, Some(body)) => {
                    pose.placements.insert(body.to_owned(), placement);
                }
                _ => {}
            }
        }
        pose
    }

    /// The placement of the body at the far end of a joint that is placed `in_parent`, seen from the body `here`.
    fn placement_beyond(
        &self,
        in_parent: Result<Placement, PoseFault>,
        here: Option<&str>,
        forward: bool,
    ) -> Result<Placement, PoseFault> {
        let placement = in_parent?;
        let placement = if forward { placement } else { placement.inverse() };
        match here.and_then(|body| self.placements.get(body)) {
            Some(here) => Ok(here.clone()?.then(&placement)),
            None => Ok(placement),
        }
    }
}

/// Placement of the joint's child body in its parent body at the default pose; `None` if it is not known.
pub fn placement_at_default_pose(model: &Model, joint: &ModelJoint) -> Option<Placement> {
    joint_placement(model, &CoordinateValues::at_default_pose(model).values, joint).ok()
}

/// Placement of the joint's child body in its parent body, at these values of its coordinates.
fn joint_placement(
    model: &Model,
    known: &HashMap<String, f64>,
    joint: &ModelJoint,
) -> Result<Placement, PoseFault> {
    let mut values = Vec::new();
    for coordinate in &joint.coordinates {
        let missing =
            || PoseFault::Coordinate { coordinate: coordinate.name.clone(), joint: joint.name.clone() };
        values.push(*known.get(&coordinate.name).ok_or_else(missing)?);
    }
    let unknown = || PoseFault::Joint { joint: joint.name.clone(), class: joint.class.clone() };
    let placement = joint.placement(model, &values).ok_or_else(unknown)?;
    if placement.point(DVec3::ONE).is_finite() { Ok(placement) } else { Err(unknown()) }
}

/// Whether two placements are equal. Also true if one of them is not known.
fn are_equal_placements(known: &Result<Placement, PoseFault>, other: &Result<Placement, PoseFault>) -> bool {
    let (Ok(known), Ok(other)) = (known, other) else { return true };
    let places = [DVec3::ZERO, DVec3::X, DVec3::Y];
    places.into_iter().all(|point| known.point(point).abs_diff_eq(other.point(point), SAME_PLACE_M))
}

// All joints in the order in which they are reached from ground.

/// A joint on a chain of joints from ground.
#[derive(Debug, Clone, Copy)]
pub struct JointStep<'j> {
    pub joint: &'j ModelJoint,
    /// The body before the joint, nearer to ground; `None` is ground.
    pub from: Option<&'j str>,
    /// The body after the joint; `None` is ground.
    pub to: Option<&'j str>,
    /// Whether the chain crosses the joint from its parent to its child.
    pub forward: bool,
    /// Whether other joints reached the body `to` before: the joint closes a loop.
    pub closes: bool,
}

/// The joints that are connected to ground, each once. A joint comes after the joints that lead to its body `from`.
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
    let mut at: HashMap<Option<&str>, Vec<usize>> = HashMap::with_capacity(joints.len() + 1);
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

/// Groups of bodies that WeldJoints connect, directly or through other bodies.
pub(crate) struct WeldedGroups<'j> {
    /// For each body, another body of its welded group, closer to the group's first body. The first body has none. `None` is ground.
    representatives: HashMap<Option<&'j str>, Option<&'j str>>,
}

impl<'j> WeldedGroups<'j> {
    /// Groups the bodies that WeldJoints among `joints` connect.
    pub(crate) fn of(joints: &'j [ModelJoint]) -> Self {
        let mut welds = Self { representatives: HashMap::new() };
        for joint in joints.iter().filter(|joint| joint.class == "WeldJoint") {
            let parent = welds.representative(joint.parent.as_deref());
            let child = welds.representative(joint.child.as_deref());
            if parent != child {
                welds.representatives.insert(child, parent);
            }
        }
        welds
    }

    /// Whether two bodies are the same, or welded to each other; `None` is ground.
    pub(crate) fn are_welded(&self, one: Option<&'j str>, other: Option<&'j str>) -> bool {
        self.representative(one) == self.representative(other)
    }

    /// One body for all bodies that are welded to `body`; `None` is ground.
    fn representative(&self, body: Option<&'j str>) -> Option<&'j str> {
        std::iter::successors(Some(body), |at| self.representatives.get(at).copied()).last().unwrap_or(body)
    }
}
