//! The planes on which contact forces press spheres, with their places and their tilt against gravity at the default pose; also pairs of
//! spheres that could touch each other.

use std::collections::BTreeSet;
use std::ops::Deref;
use std::sync::Arc;

use foldhash::HashMap;
use glam::DVec3;
use indexmap::IndexMap;

use super::default_pose::{DefaultPose, WeldedGroups};
use crate::model::{
    ElementId, FileId, Force, ForceId, HalfSpace, Model, Placement, Sphere, SphereId, angle_between,
};

/// A plane that leans by more than this angle is a wall, rad: 45 degrees. The steepest published slope has 20.5 degrees; upright planes
/// have 90 degrees.
pub const STEEPEST_FLOOR_RAD: f64 = std::f64::consts::FRAC_PI_4;

/// A half-space on which moving spheres press: a floor or a wall. It dereferences to its [`HalfSpace`].
///
/// ```
/// use osim_model::feet::{ContactPlane, DefaultPose};
/// use osim_model::Model;
///
/// # let bytes: &[u8] = include_bytes!("../../tests/data/one_foot.osim");
/// let model = Model::parse(bytes)?;
/// let planes = ContactPlane::all(&model, &model.force_ids(), &DefaultPose::of(&model));
/// // heel_r presses on the floor, which is on ground.
/// assert_eq!((planes.len(), planes[0].spheres.len(), planes[0].body.as_deref()), (1, 1, None));
/// let surface = planes[0].surface.as_ref().expect("all numbers can be read");
/// assert!(surface.tilt_rad < 1e-8);
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ContactPlane {
    /// The half-space, with its name, path, line and body.
    pub plane: Arc<HalfSpace>,
    /// The spheres that press on the half-space, each once, in file order.
    pub spheres: Vec<SphereId>,
    /// The surface of the plane in ground; `None` if a number cannot be read or the place of the plane's body is not known.
    pub surface: Option<PlaneSurface>,
}

/// A point and the normal of a plane in ground at the default pose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlaneSurface {
    /// Outward normal of the plane, of length 1.
    pub normal: DVec3,
    /// A point on the surface of the plane, m.
    pub point_m: DVec3,
    /// The angle between the plane's normal and the direction opposite to gravity, rad: 0 for a level floor, π for a floor upside down.
    pub tilt_rad: f64,
    /// The half-space's own orientation, rad, at which the plane would be level.
    pub level_orientation: [f64; 3],
}

impl ContactPlane {
    /// The planes on which switched-on forces among `forces` press moving spheres, in the order of the forces. A force presses its spheres
    /// on each of its planes, except planes on the sphere's own body or on a body welded to it.
    pub fn all(model: &Model, forces: &[ForceId], pose: &DefaultPose) -> Vec<Self> {
        let welds = WeldedGroups::of(model.joints());
        let mut planes: IndexMap<(FileId, ElementId), (Arc<HalfSpace>, BTreeSet<SphereId>)> = IndexMap::new();
        for force in forces.iter().filter_map(|&id| model.force(id)).filter(|force| force.applies) {
            let spheres: Vec<&Sphere> = force.spheres().iter().filter_map(|&id| model.sphere(id)).collect();
            for plane in model.planes_of(force) {
                let is_welded_to_plane = |body: &str| welds.are_welded(Some(body), plane.body.as_deref());
                let presses = |sphere: &&&Sphere| {
                    !sphere.fixed && !sphere.body.as_deref().is_some_and(is_welded_to_plane)
                };
                let mut pressed = spheres.iter().filter(presses).map(|sphere| sphere.id).peekable();
                if pressed.peek().is_some() {
                    let new = || (Arc::clone(&plane), BTreeSet::new());
                    planes.entry((plane.file, plane.element)).or_insert_with(new).1.extend(pressed);
                }
            }
        }
        let contact_planes = planes.into_values().map(|(plane, spheres)| Self {
            surface: PlaneSurface::of(model, &plane, pose),
            plane,
            spheres: spheres.into_iter().collect(),
        });
        contact_planes.collect()
    }
}

impl Deref for ContactPlane {
    type Target = HalfSpace;

    fn deref(&self) -> &HalfSpace {
        &self.plane
    }
}

impl PlaneSurface {
    /// The surface of `plane` in ground at the default pose; `None` if its place is not known.
    fn of(model: &Model, plane: &HalfSpace, pose: &DefaultPose) -> Option<Self> {
        let (normal, point_m) = plane.normal.zip(plane.point_m)?;
        let carrier = match &plane.body {
            Some(body) => *pose.placement(body).ok()?,
            None if plane.on_ground => Placement::IDENTITY,
            None => return None,
        };
        let (normal, point_m) = (carrier.rotation.to_body(normal), carrier.point(point_m));
        let level_orientation = plane.orientation_facing(carrier.rotation.inverse().to_body(model.up()))?;
        point_m.is_finite().then(|| Self {
            normal,
            point_m,
            tilt_rad: angle_between(normal, model.up()),
            level_orientation,
        })
    }
}

// Spheres of one force that could touch each other.

/// The pairs of spheres on different bodies between which one force acts.
#[derive(Debug, Clone, PartialEq)]
pub struct PairsOfForce {
    pub count: usize,
    /// The first pairs, in the order in which the force names the spheres.
    pub first: Vec<[SphereId; 2]>,
    /// A pair that touches each other at the default pose, or of which is not known whether it does, and why.
    pub not_apart: Option<([SphereId; 2], Option<String>)>,
}

impl PairsOfForce {
    /// The pairs of `force` at the default `pose`, the first `listed` of them listed. A force with one sphere has no pairs.
    pub fn find(model: &Model, pose: &DefaultPose, force: &Force, listed: usize) -> Self {
        let spheres: Vec<&Sphere> = force.spheres().iter().filter_map(|&id| model.sphere(id)).collect();
        let mut on_body: HashMap<Option<&str>, usize> = HashMap::default();
        let count = spheres.iter().enumerate().map(|(before, sphere)| {
            let same = on_body.entry(sphere.body.as_deref()).or_default();
            *same += 1;
            before + 1 - *same
        });
        let count = count.sum();
        let first = spheres.iter().enumerate().filter(|_| count > 0).flat_map(|(index, &one)| {
            let others = spheres.iter().skip(index + 1).filter(move |other| other.body != one.body);
            others.map(move |other| [one.id, other.id])
        });
        let first = first.take(listed).collect();
        let not_apart = if count == 0 { None } else { find_not_apart(model, pose, &spheres) };
        Self { count, first, not_apart }
    }
}

/// Two of `spheres` on different bodies that touch each other, or one of unknown place or radius with another, and what is not known.
fn find_not_apart(
    model: &Model,
    pose: &DefaultPose,
    spheres: &[&Sphere],
) -> Option<([SphereId; 2], Option<String>)> {
    let mut balls = Vec::with_capacity(spheres.len());
    let pair = |one: usize, other: usize| {
        let id = |index: usize| spheres.get(index).map(|sphere| sphere.id);
        Some([id(one.min(other))?, id(one.max(other))?])
    };
    for (index, &sphere) in spheres.iter().enumerate() {
        let radius_m = sphere.round_radius_m().map_err(|fault| fault.to_string());
        match centre_m(model, pose, sphere)
            .and_then(|centre_m| Ok((centre_m, radius_m?, index, &sphere.body)))
        {
            Ok(ball) => balls.push(ball),
            Err(why) => {
                let other = spheres.iter().position(|other| other.body != sphere.body)?;
                return Some((pair(index, other)?, Some(why)));
            }
        }
    }
    // Along the axis on which they are farthest apart, only near ones are compared.
    let span = balls.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(least, most), (at, ..)| {
        (least.min(*at), most.max(*at))
    });
    let axis = (span.1 - span.0).max_position();
    let start = |(at, radius_m, ..): &(DVec3, f64, usize, &Option<String>)| at[axis] - radius_m;
    balls.sort_by(|one, other| start(one).total_cmp(&start(other)));
    balls.iter().enumerate().find_map(|(place, (at, radius_m, index, body))| {
        let near = balls.iter().skip(place + 1).take_while(|other| start(other) <= at[axis] + radius_m);
        let mut near = near.filter(|(.., other)| other != body);
        let (.., other, _) =
            near.find(|(other_at, other_m, ..)| at.distance(*other_at) <= radius_m + other_m)?;
        Some((pair(*index, *other)?, None))
    })
}

fn centre_m(model: &Model, pose: &DefaultPose, sphere: &Sphere) -> Result<DVec3, String> {
    let unread = || format!("the place of {} cannot be read", sphere.path);
    let place = model.centre_m(sphere.id).ok_or_else(unread)?;
    let place = match &sphere.body {
        None => place,
        Some(body) => pose.placement(body).map_err(|fault| fault.to_string())?.point(place),
    };
    place.is_finite().then_some(place).ok_or_else(unread)
}
