//! Computes the places of the joints, bones and spheres of a foot and of the floor, for a picture.
//!
//! [`FootBodies::find`] finds the bodies of the feet, [`Foot::all`] computes the places of everything on these bodies at the default pose.

mod bodies;
mod view;

use foldhash::{HashMap, HashMapExt, HashSet};
use glam::DVec3;

use super::bones::Bone;
use super::default_pose::DefaultPose;
use super::fault::PoseFault;
use crate::model::{Anatomy, AnatomyJoint, Model, ModelJoint, Side, least_and_most};
pub use bodies::FootBodies;
pub use view::{ViewAxes, silhouette};

/// A joint above a foot belongs to the foot's picture if its distance is at most this part of the foot's length.
const ANKLE_DISTANCE: f64 = 0.5;
/// Bones of bodies without spheres are drawn up to this height above the foot's lowest point, as a part of the foot's length.
const DRAWN_HEIGHT_OF_BONES: f64 = 0.8;

/// The frame in which a foot is drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FootFrame {
    /// Ground. The bodies are at the default pose.
    Ground,
    /// The frame of a body of the foot, because the place of that body in ground is not known, for the reason `fault`.
    Body { name: String, fault: PoseFault },
}

/// A joint in the picture of a foot.
#[derive(Debug, Clone, PartialEq)]
pub struct FootJoint {
    pub name: String,
    /// Place of the joint on its parent body, in the frame of the foot, m.
    pub at_m: DVec3,
}

/// A contact sphere of a foot, with its place in three dimensions, for pictures of the foot.
#[derive(Debug, Clone, PartialEq)]
pub struct FootSphere {
    pub name: String,
    /// Name of the body that carries the sphere; empty for ground.
    pub body: String,
    /// Centre of the sphere in the frame that [`Foot::frame`] names, m.
    pub centre_m: DVec3,
    /// Radius of the sphere, m.
    pub radius_m: f64,
    /// Whether the sphere is in a wrong place. Callers set it after they have compared models.
    pub misplaced: bool,
}

/// A bone in the picture of a foot.
#[derive(Debug, Clone, PartialEq)]
pub struct FootBone {
    pub body: String,
    /// Name of the mesh file, as the model writes it.
    pub mesh: String,
    /// Points of the bone in the frame of the foot, m.
    pub points_m: Vec<DVec3>,
}

/// One foot with everything that a picture needs.
#[derive(Debug, Clone, PartialEq)]
pub struct Foot {
    /// Name of the body of the foot that is nearest to the trunk.
    pub name: String,
    /// The side of the body on which the foot is, left or right; `None` if its names do not say it.
    pub side: Option<Side>,
    /// The frame in which all places of the foot are given.
    pub frame: FootFrame,
    /// Origin of the foot's topmost body, m.
    pub origin_m: DVec3,
    /// The directions for the views of the picture.
    pub axes: ViewAxes,
    pub joints: Vec<FootJoint>,
    /// Spheres of the foot, in file order.
    pub spheres: Vec<FootSphere>,
    /// Bones of the foot whose mesh files could be read.
    pub bones: Vec<FootBone>,
    pub floor: FloorPlace,
    /// Names of bodies that are not drawn, because a joint between them and the foot is not supported.
    pub unplaced: Vec<String>,
}

impl Foot {
    /// Makes each of the `feet` ready for a picture: in ground if the default pose is known, else in the frame of the foot's topmost body.
    pub fn all(model: &Model, anatomy: &Anatomy, feet: &[FootBodies], pose: &DefaultPose) -> Vec<Self> {
        let context = ModelContext::of(model);
        feet.iter().map(|bodies| Self::of(&context, anatomy, bodies, pose)).collect()
    }

    /// One foot with its joints and spheres, and without bones.
    fn of(context: &ModelContext<'_>, anatomy: &Anatomy, bodies: &FootBodies, pose: &DefaultPose) -> Self {
        let places = FootPlaces::of(anatomy, bodies, pose);
        let (frame, floor) = match &places.fault {
            None => (FootFrame::Ground, context.floor.clone()),
            Some(fault) => {
                let frame = FootFrame::Body { name: bodies.top().to_owned(), fault: fault.clone() };
                (frame, FloorPlace::NotInGround)
            }
        };
        let is_unplaced = |body: &&String| places.point(body, DVec3::ZERO).is_none();
        let mut foot = Self {
            name: bodies.top().to_owned(),
            side: bodies.side,
            frame,
            origin_m: places.point(bodies.top(), DVec3::ZERO).unwrap_or_default(),
            axes: context.axes,
            joints: Vec::new(),
            spheres: foot_spheres(context.model, bodies, &places),
            bones: Vec::new(),
            floor,
            unplaced: bodies.bodies.iter().filter(is_unplaced).cloned().collect(),
        };
        foot.add_joints(anatomy, bodies, &places, context);
        foot
    }

    /// The bodies whose bones the picture contains: those of the foot, and those whose joint above is near the foot.
    pub fn bodies_with_bones(&self, anatomy: &Anatomy, bodies: &FootBodies) -> Vec<String> {
        let mut with_bones = bodies.bodies.clone();
        let above = anatomy.joint_above(bodies.top());
        let near = above.and_then(|joint| anatomy.joint_above(&joint.parent));
        if let (Some(joint), Some(near)) = (above, near)
            && self.joints.iter().any(|known| known.name == near.name)
        {
            with_bones.push(joint.parent.clone());
        }
        with_bones
    }

    /// Adds `bones` to the foot. Of bodies without spheres, points high above the foot are left out.
    pub fn add_bones(&mut self, anatomy: &Anatomy, bodies: &FootBodies, bones: &[Bone], pose: &DefaultPose) {
        let places = FootPlaces::of(anatomy, bodies, pose);
        let top = self.lowest_m().map(|lowest| lowest + DRAWN_HEIGHT_OF_BONES * self.length_m());
        let carriers: HashSet<&str> = self.spheres.iter().map(|sphere| sphere.body.as_str()).collect();
        let mut shown_bones = Vec::new();
        for bone in bones {
            let limit = if carriers.contains(bone.body.as_str()) { None } else { top };
            let shown = |point: &DVec3| limit.is_none_or(|top| self.axes.up.dot(*point) <= top);
            let points = bone.points_m.iter().filter_map(|&point| places.point(&bone.body, point.into()));
            let points_m: Vec<DVec3> = points.filter(shown).collect();
            if !points_m.is_empty() {
                shown_bones.push(FootBone { body: bone.body.clone(), mesh: bone.mesh.clone(), points_m });
            }
        }
        self.bones.extend(shown_bones);
    }

    /// The height of the lowest point of the spheres, m; without spheres, of the bones; without bones, of the joints.
    pub fn lowest_m(&self) -> Option<f64> {
        let up = |point: DVec3| self.axes.up.dot(point);
        let spheres =
            self.spheres.iter().map(|sphere| up(sphere.centre_m) - sphere.radius_m).reduce(f64::min);
        let bones = || self.bones.iter().flat_map(|bone| &bone.points_m).map(|&point| up(point));
        let joints = || self.joints.iter().map(|joint| up(joint.at_m));
        spheres.or_else(|| bones().reduce(f64::min)).or_else(|| joints().reduce(f64::min))
    }

    /// The extent of the foot in the forward direction, m.
    pub fn length_m(&self) -> f64 {
        let along = |point: DVec3| self.axes.forward.dot(point);
        let spheres = self.spheres.iter().flat_map(|sphere| {
            [along(sphere.centre_m) - sphere.radius_m, along(sphere.centre_m) + sphere.radius_m]
        });
        let bones = self.bones.iter().flat_map(|bone| &bone.points_m).map(|&point| along(point));
        let joints = self.joints.iter().map(|joint| along(joint.at_m));
        let (low, high) = least_and_most(spheres.chain(bones).chain(joints));
        (high - low).max(0.0)
    }

    /// Whether `height_m` is at most one foot length away from the foot's lowest point.
    pub fn is_near_height(&self, height_m: f64) -> bool {
        self.lowest_m().is_some_and(|lowest| (height_m - lowest).abs() <= self.length_m())
    }

    /// The positions of the rearmost and the foremost sphere centre along the bones: 0 is the heel, 1 the tip of the toes. `None` without
    /// bones.
    pub fn sphere_extent(&self) -> Option<(f64, f64)> {
        let along = |point: DVec3| self.axes.forward.dot(point);
        let carriers: HashSet<&str> = self.spheres.iter().map(|sphere| sphere.body.as_str()).collect();
        let of_carriers = self.bones.iter().filter(|bone| carriers.contains(bone.body.as_str()));
        let points = of_carriers.flat_map(|bone| &bone.points_m);
        let (heel, toe) = least_and_most(points.map(|&point| along(point)));
        let centres = self.spheres.iter().map(|sphere| (along(sphere.centre_m) - heel) / (toe - heel));
        let ends = centres.fold(None, |ends: Option<(f64, f64)>, share| {
            Some(ends.map_or((share, share), |(low, high)| (low.min(share), high.max(share))))
        });
        ends.filter(|_| toe > heel)
    }

    fn add_joints(
        &mut self,
        anatomy: &Anatomy,
        bodies: &FootBodies,
        places: &FootPlaces<'_>,
        context: &ModelContext<'_>,
    ) {
        let place = |joint: &AnatomyJoint| places.joint(joint, context);
        for body in &bodies.bodies {
            self.joints.extend(anatomy.joint_above(body).and_then(place));
        }
        // The ankle is above the subtalar joint; a knee would be far away.
        let above = anatomy.joint_above(bodies.top());
        let next = above.and_then(|joint| anatomy.joint_above(&joint.parent));
        let (Some(above), Some(next)) = (above, next) else { return };
        if let (Some(first), Some(second)) = (place(above), place(next))
            && first.at_m.distance(second.at_m) <= ANKLE_DISTANCE * self.length_m()
        {
            self.joints.push(second);
        }
    }
}

fn foot_spheres(model: &Model, bodies: &FootBodies, places: &FootPlaces<'_>) -> Vec<FootSphere> {
    let sphere = |&id| {
        let sphere = model.sphere(id)?;
        let body = sphere.body.clone().unwrap_or_default();
        let centre_m = places.point(&body, model.centre_m(id)?)?;
        let radius_m = sphere.round_radius_m().ok()?;
        Some(FootSphere { name: sphere.name.clone(), body, centre_m, radius_m, misplaced: false })
    };
    bodies.spheres.iter().filter_map(sphere).collect()
}

/// Data of the model that all feet need.
struct ModelContext<'m> {
    model: &'m Model,
    axes: ViewAxes,
    floor: FloorPlace,
    /// Joints by their own name and the name of their child; of equal ones the first counts.
    joints: HashMap<(&'m str, &'m str), &'m ModelJoint>,
}

impl<'m> ModelContext<'m> {
    /// What the pictures of all feet of `model` have in common.
    fn of(model: &'m Model) -> Self {
        let mut joints = HashMap::new();
        for joint in model.joints() {
            if let Some(child) = joint.child.as_deref() {
                joints.entry((joint.name.as_str(), child)).or_insert(joint);
            }
        }
        Self { model, axes: ViewAxes::of(model), floor: FloorPlace::of(model), joints }
    }
}

/// Computes places of bodies in the frame of a foot.
struct FootPlaces<'p> {
    anatomy: &'p Anatomy,
    top: &'p str,
    /// Why the topmost body cannot be placed in ground; `None` if it can.
    fault: Option<PoseFault>,
    pose: &'p DefaultPose,
}

impl<'p> FootPlaces<'p> {
    /// Places in the frame of a foot: ground, or its topmost body if the pose is not known.
    fn of(anatomy: &'p Anatomy, bodies: &'p FootBodies, pose: &'p DefaultPose) -> Self {
        let top = bodies.top();
        // An empty name is ground.
        let fault = pose.placement(top).err().filter(|_| !top.is_empty());
        Self { anatomy, top, fault, pose }
    }

    /// A point of a body, seen from ground; if the place in ground is not known, seen from the foot's topmost body. m.
    fn point(&self, body: &str, point_m: DVec3) -> Option<DVec3> {
        match (body, &self.fault) {
            ("", None) => Some(point_m),
            (_, None) => Some(self.pose.placement(body).ok()?.point(point_m)),
            (_, Some(_)) => self.point_in_top(body, point_m),
        }
    }

    /// A point of a body, seen from the foot's topmost body, m: through the joints between the two bodies.
    fn point_in_top(&self, body: &str, point_m: DVec3) -> Option<DVec3> {
        let (mut at, mut point) = (body, point_m);
        for _ in 0..=self.anatomy.bodies.len() {
            if at == self.top {
                return Some(point);
            }
            let above = self.anatomy.joint_above(at)?;
            point = above.point_in_parent(point)?;
            at = &above.parent;
        }
        None
    }

    /// A joint at its place on its parent, as OpenSim reads the file. If the parent is not in the picture, the place on its child.
    fn joint(&self, joint: &AnatomyJoint, context: &ModelContext<'_>) -> Option<FootJoint> {
        let read = context.joints.get(&(joint.name.as_str(), joint.child.as_str()));
        let in_parent_m = read.map_or(joint.in_parent_m, |read| read.in_parent_m());
        let at_m =
            self.point(&joint.parent, in_parent_m).or_else(|| self.point(&joint.child, joint.in_child_m))?;
        Some(FootJoint { name: joint.name.clone(), at_m })
    }
}

/// Two floors count as one if their heights differ by at most this, m.
const SAME_HEIGHT_M: f64 = 1e-9;

/// The height of the floor in the picture of a foot.
#[derive(Debug, Clone, PartialEq)]
pub enum FloorPlace {
    /// The model has no level half-space that is fixed to ground.
    None,
    /// All floors are at this height above the origin of ground, m.
    At(f64),
    /// The floors have these different heights above the origin of ground, m, the lowest first.
    Several(Vec<f64>),
    /// The foot is not drawn in the frame of ground, so no floor can be drawn.
    NotInGround,
}

impl FloorPlace {
    /// Finds the heights of the floors of `model`.
    pub fn of(model: &Model) -> Self {
        let up = model.up();
        let mut heights: Vec<f64> = model.floors().iter().map(|plane| plane.point_m.dot(up)).collect();
        heights.sort_by(f64::total_cmp);
        heights.dedup_by(|a, b| (*a - *b).abs() <= SAME_HEIGHT_M);
        match heights.as_slice() {
            [] => Self::None,
            [height] => Self::At(*height),
            _ => Self::Several(heights),
        }
    }
}
