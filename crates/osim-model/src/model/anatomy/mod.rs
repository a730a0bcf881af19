//! The parts of a model that OpenSim's scaling changes or should change: scale factors of meshes, offsets of joints, and contact spheres.

pub(crate) mod bone_sizes;
mod coordinate_function;
mod joint_motion;
pub(crate) mod joints;

use std::collections::{self, BTreeMap};

use foldhash::{HashMap, HashSet};
use glam::DVec3;

use crate::model::components::{Carrier, ComponentId, MOST_FRAMES_IN_CHAIN};
use crate::model::{Model, MovingPlacement, Placement, Result, Rotation};
pub use coordinate_function::CoordinateFunction;
pub use joint_motion::Speeds;
pub use joints::{AnatomyJoint, JointCoordinate, ModelJoint};

/// The parts of a model that scaling changes or should change, by the names of the bodies.
#[derive(Debug, Clone, PartialEq)]
pub struct Anatomy {
    /// Names of the bodies, in file order.
    pub bodies: Vec<String>,
    /// For each body, its mesh files (numbered if they repeat) with scale factors along x, y and z; NaN if they are not numbers.
    pub meshes: BTreeMap<String, BTreeMap<String, [f64; 3]>>,
    /// For each body, the translations, m, of frames that are fixed to it, by the name of the joint or frame.
    pub offsets: BTreeMap<String, BTreeMap<String, [f64; 3]>>,
    pub spheres: Vec<AnatomySphere>,
    /// Joints between two bodies, in file order. Joints to ground are left out.
    pub joints: Vec<AnatomyJoint>,
    /// Whether the model is only a part of a larger model: it has too few bodies to recognise scaled copies of the larger model.
    pub is_fragment: bool,
    index: AnatomyIndex,
}

/// Indices of bodies, spheres and joints by name. Of several with one name, the first counts.
#[derive(Debug, Clone, Default, PartialEq)]
struct AnatomyIndex {
    bodies: HashSet<String>,
    spheres: HashMap<String, usize>,
    /// Names that more than one sphere has.
    repeated_spheres: HashSet<String>,
    joints: HashMap<String, usize>,
    joints_by_child: HashMap<String, usize>,
    joints_by_parent: HashMap<String, Vec<usize>>,
}

impl AnatomyIndex {
    /// Sorts the bodies, spheres and joints of `anatomy` by name.
    fn new(anatomy: &Anatomy) -> Self {
        let mut index = Self { bodies: anatomy.bodies.iter().cloned().collect(), ..Self::default() };
        for (at, sphere) in anatomy.spheres.iter().enumerate() {
            if *index.spheres.entry(sphere.name.clone()).or_insert(at) != at {
                index.repeated_spheres.insert(sphere.name.clone());
            }
        }
        for (at, joint) in anatomy.joints.iter().enumerate() {
            index.joints.entry(joint.name.clone()).or_insert(at);
            index.joints_by_child.entry(joint.child.clone()).or_insert(at);
            index.joints_by_parent.entry(joint.parent.clone()).or_default().push(at);
        }
        index
    }
}

/// A contact sphere with its body, place and radius, as two models are compared.
#[derive(Debug, Clone, PartialEq)]
pub struct AnatomySphere {
    pub name: String,
    /// Body that carries the sphere; `None` is ground.
    pub body: Option<String>,
    /// Location of the sphere's centre in its frame, m.
    pub location_m: [f64; 3],
    pub radius_m: f64,
    pub rotation: Rotation,
    /// The largest error of `location_m` from rounding in the file, m: places that differ by no more are equal.
    pub(crate) rounding_m: f64,
}

impl AnatomySphere {
    /// A sphere with its centre and radius, m. Its frame is turned by `rotation` in `body`.
    pub fn new(
        name: String,
        body: Option<String>,
        (location_m, radius_m): ([f64; 3], f64),
        rotation: Rotation,
    ) -> Self {
        Self { name, body, location_m, radius_m, rotation, rounding_m: 0.0 }
    }
}

/// Numbers of decimals, or of significant digits, that indicate rounded places, to 1 mm or 0.01 mm. With more of them rounding does not
/// matter; with fewer, a place is probably meant as a round number.
const DIGITS_OF_ROUNDED_PLACES: std::ops::RangeInclusive<usize> = 3..=5;

/// Half a unit of the last decimal of the places, or of the last digit of the largest one, m; 0 if neither number indicates rounding.
pub fn rounding_of_places_m(places: impl Iterator<Item = [f64; 3]>) -> f64 {
    let (mut decimals, mut digits, mut largest_m) = (0, 0, 0.0_f64);
    for value in places.flatten().map(f64::abs) {
        let text = value.to_string();
        decimals = decimals.max(text.split_once('.').map_or(0, |(_, decimals)| decimals.len()));
        let letters = text.trim_start_matches(['0', '.']);
        digits = digits.max(letters.len() - usize::from(letters.contains('.')));
        largest_m = largest_m.max(value);
    }
    let of_decimals = (decimals, -(decimals as f64));
    let of_digits = (digits, largest_m.log10().floor() + 1.0 - digits as f64);
    let rounded = [of_decimals, of_digits].into_iter();
    let rounded = rounded.filter(|(digits, _)| DIGITS_OF_ROUNDED_PLACES.contains(digits));
    rounded.map(|(_, exponent)| 0.500_001 * 10_f64.powf(exponent)).fold(0.0, f64::max)
}

impl Anatomy {
    pub fn with_spheres(mut self, spheres: Vec<AnatomySphere>) -> Self {
        self.spheres = spheres;
        self.index = AnatomyIndex::new(&self);
        self
    }

    /// The bodies of `model`, their meshes and the joints between them, without spheres and frames.
    pub fn bones_of(model: &Model) -> Self {
        let mut anatomy = Self::without_index(model);
        anatomy.index = AnatomyIndex::new(&anatomy);
        anatomy
    }

    fn without_index(model: &Model) -> Self {
        let components = model.components();
        Self {
            bodies: model.bodies().iter().map(|body| body.name.clone()).collect(),
            meshes: model.body_facts.mesh_factors(components).clone(),
            offsets: BTreeMap::new(),
            spheres: Vec::new(),
            joints: model.body_facts.joints.between_bodies(components).to_vec(),
            is_fragment: false,
            index: AnatomyIndex::default(),
        }
    }

    /// Reads the anatomy of `model`.
    ///
    /// # Errors
    /// A frame refers to no body, or a radius cannot be scaled.
    pub fn of(model: &Model) -> Result<Self> {
        let mut anatomy = Self {
            offsets: model.body_facts.frame_offsets(model.components()).clone(),
            ..Self::without_index(model)
        };
        let places = model.spheres().iter().map(|sphere| sphere.location_m);
        let rounding_m = rounding_of_places_m(places);
        for sphere in model.spheres() {
            let radius_m = sphere.radius_m()?;
            anatomy.spheres.push(AnatomySphere {
                name: sphere.name.clone(),
                body: sphere.body.clone(),
                location_m: sphere.location_m,
                radius_m,
                rotation: model.rotation_of(sphere)?,
                rounding_m,
            });
        }
        anatomy.index = AnatomyIndex::new(&anatomy);
        Ok(anatomy)
    }

    pub fn joint_above(&self, body: &str) -> Option<&AnatomyJoint> {
        self.joints.get(*self.index.joints_by_child.get(body)?)
    }

    /// The joints whose parent is `body`, in file order.
    pub fn joints_below(&self, body: &str) -> impl Iterator<Item = &AnatomyJoint> {
        let below = self.index.joints_by_parent.get(body).into_iter().flatten();
        below.filter_map(|&at| self.joints.get(at))
    }

    /// The first joint called `name`.
    pub fn joint(&self, name: &str) -> Option<&AnatomyJoint> {
        self.joints.get(*self.index.joints.get(name)?)
    }

    pub fn has_body(&self, name: &str) -> bool {
        self.index.bodies.contains(name)
    }

    /// The place of `joint`, seen from the origin of `body` at the default pose, m. `None` unless the joint is below the body with at most
    /// 64 joints between: the limit avoids long walks along a chain.
    pub(crate) fn joint_place_seen_from(&self, body: &str, joint: &AnatomyJoint) -> Option<DVec3> {
        self.point_seen_from(body, &joint.parent, joint.in_parent_m)
    }

    /// A point of the body `from`, seen from the body `above` at the default pose, m. `None` unless `from` is below `above` in the joint
    /// tree, with at most 64 joints between.
    pub fn point_seen_from(&self, above: &str, from: &str, point_m: impl Into<DVec3>) -> Option<DVec3> {
        let (mut at, mut point) = (from, point_m.into());
        for _ in 0..=MOST_FRAMES_IN_CHAIN {
            if at == above {
                return Some(point);
            }
            let joint = self.joint_above(at)?;
            point = joint.point_in_parent(point)?;
            at = &joint.parent;
        }
        None
    }

    pub fn with_renamed_body(mut self, body: &str, name: &str) -> Self {
        let rename = |current: &mut String| {
            if current == body {
                name.clone_into(current);
            }
        };
        self.bodies.iter_mut().for_each(rename);
        for joint in &mut self.joints {
            rename(&mut joint.parent);
            rename(&mut joint.child);
        }
        self.spheres.iter_mut().filter_map(|sphere| sphere.body.as_mut()).for_each(rename);
        for by_body in [&mut self.meshes, &mut self.offsets] {
            if let Some(triples) = by_body.remove(body) {
                by_body.insert(name.to_owned(), triples);
            }
        }
        self.index = AnatomyIndex::new(&self);
        self
    }

    /// The first sphere called `name`.
    pub fn sphere(&self, name: &str) -> Option<&AnatomySphere> {
        self.spheres.get(*self.index.spheres.get(name)?)
    }

    /// Whether more than one sphere is called `name`.
    pub(crate) fn has_several_spheres(&self, name: &str) -> bool {
        self.index.repeated_spheres.contains(name)
    }
}

impl Model {
    /// All joints whose frames refer to bodies or to ground, in file order, without joints that OpenSim ignores. Joints inside bodies have
    /// frames with six digits, as OpenSim converts them.
    pub fn joints(&self) -> &[ModelJoint] {
        self.body_facts.joints.converted(self.components(), &self.skeleton().ignored_joints)
    }

    /// Whether each coordinate, by name, is an angle; `false` for a length, `None` if it is neither. Of several with one name, the first
    /// counts.
    pub(crate) fn coordinates_are_angles(&self) -> collections::HashMap<&str, Option<bool>> {
        let mut are_angles = collections::HashMap::new();
        for joint in self.joints() {
            let motion = joint.motion(self.components());
            for (index, coordinate) in joint.coordinates.iter().enumerate() {
                let is_angle = || motion.and_then(|motion| motion.is_angle(index));
                are_angles.entry(coordinate.name.as_str()).or_insert_with(is_angle);
            }
        }
        are_angles
    }

    /// The constraints that hold a point of a body to a point or a line of ground, each with the name of the body.
    pub(crate) fn constraints_to_ground(&self) -> Vec<(ComponentId, String)> {
        let components = self.components();
        let base = |id: ComponentId, socket: &str, others: &[&str]| {
            components.base(components.frame_at(id, socket, others)?.component).ok()
        };
        let ids = components.tree.iter().map(|(id, _)| id);
        let ends = |id| {
            let [(one, of_one), (two, of_two)]: [(&str, &[&str]); 2] = match components.tag(id) {
                "WeldConstraint" | "PointConstraint" => {
                    [("frame1", &["socket_body_1", "body_1"]), ("frame2", &["socket_body_2", "body_2"])]
                }
                "PointOnLineConstraint" => {
                    [("line_body", &["line_body"]), ("follower_body", &["follower_body"])]
                }
                _ => return None,
            };
            Some((base(id, one, of_one)?, base(id, two, of_two)?))
        };
        let body = |id| match ends(id)? {
            (Carrier::Ground, Carrier::Body(body)) | (Carrier::Body(body), Carrier::Ground) => {
                Some((id, components.name(body).into_owned()))
            }
            _ => None,
        };
        ids.filter_map(body).collect()
    }
}

impl ModelJoint {
    /// The placement of the child frame in the parent frame if the coordinates have these `values` (rad, m; missing values count as 0);
    /// `None` if the joint or one of its functions is not supported.
    pub fn placement(&self, model: &Model, values: &[f64]) -> Option<Placement> {
        self.placement_at(model.components(), values)
    }

    /// As [`placement`](Self::placement), with the velocity of the child frame while the coordinates change with these `speeds`.
    pub fn placement_and_velocity(
        &self,
        model: &Model,
        values: &[f64],
        speeds: Speeds<'_>,
    ) -> Option<MovingPlacement> {
        self.placement_and_velocity_at(model.components(), values, speeds)
    }

    /// Whether coordinate number `index` of a CustomJoint is the angle of a rotation about an axis; `false` if it is a distance along an
    /// axis, `None` if it is neither.
    pub fn is_pure_rotation(&self, model: &Model, index: usize) -> Option<bool> {
        self.motion(model.components())?.is_pure_rotation(index)
    }
}
