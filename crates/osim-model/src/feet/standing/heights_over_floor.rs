//! The heights of sphere bottoms above floors, and the depths to which loaded spheres sink into them.

use std::collections::BTreeSet;

use contact_scaling::equilibrium::{RaisedSpheres, hertz_indentation_of_lowest, indentation_of_lowest};
use contact_scaling::{DomainError, Law, Spheres};
use foldhash::{HashMap, HashMapExt};
use glam::DVec3;

use crate::feet::contact_planes::{ContactPlane, PlaneSurface, STEEPEST_FLOOR_RAD};
use crate::feet::default_pose::DefaultPose;
use crate::feet::fault::PoseFault;
use crate::model::angle_between;
use crate::model::{ForceId, LoadedSphere, Model, SphereId};

/// The height of a sphere over its floor at the default pose.
#[derive(Debug, Clone, PartialEq)]
pub struct SphereOverFloor {
    pub sphere: SphereId,
    /// Height of the sphere's bottom above the floor along the floor's normal, m; below 0 if the sphere is in the floor. With several
    /// floors, the least height.
    pub gap_m: f64,
    /// The tilt of the sphere's body, rad: the angle between the floor's normal and the nearest axis of the body, or the axis that is up
    /// with all coordinates at 0 if the model lies. 0 if the body is upright.
    pub tilt_rad: f64,
    /// The centre of the sphere in ground, m.
    pub centre_m: DVec3,
    /// Height of the sphere's bottom with all coordinates at 0, from the origin of ground along its axis nearest to the normal, m: there
    /// feet are level on a level floor. `None` if that pose is not known.
    pub height_at_zero_m: Option<f64>,
}

/// A contact of one sphere with one plane: the contact law of the force, and the gap to the plane.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FloorContact {
    pub(super) contact: LoadedSphere,
    pub(super) gap_m: f64,
}

/// The floors of a model at the default pose, with the spheres that press on each.
pub(super) struct SphereFloors {
    planes: Vec<(ContactPlane, PlaneSurface)>,
    by_sphere: HashMap<SphereId, Vec<usize>>,
}

impl SphereFloors {
    /// The floors among the planes of `forces`. Walls are left out.
    pub(super) fn of(model: &Model, forces: &[ForceId], pose: &DefaultPose) -> Self {
        let planes = ContactPlane::all(model, forces, pose).into_iter();
        let floor = |plane: ContactPlane| {
            let surface = plane.surface.filter(|surface| surface.tilt_rad <= STEEPEST_FLOOR_RAD)?;
            Some((plane, surface))
        };
        let planes: Vec<(ContactPlane, PlaneSurface)> = planes.filter_map(floor).collect();
        let mut by_sphere: HashMap<SphereId, Vec<usize>> = HashMap::new();
        for (index, (plane, _)) in planes.iter().enumerate() {
            for &sphere in &plane.spheres {
                by_sphere.entry(sphere).or_default().push(index);
            }
        }
        Self { planes, by_sphere }
    }

    /// The spheres that press on floors, in file order.
    pub(super) fn spheres(&self) -> Vec<SphereId> {
        self.by_sphere.keys().copied().collect::<BTreeSet<_>>().into_iter().collect()
    }

    /// The floors on which `spheres` press, each once.
    pub(super) fn floors_under(&self, spheres: &[SphereId]) -> Vec<&(ContactPlane, PlaneSurface)> {
        let of_spheres = spheres.iter().filter_map(|sphere| self.by_sphere.get(sphere)).flatten();
        let places: BTreeSet<usize> = of_spheres.copied().collect();
        places.into_iter().filter_map(|place| self.planes.get(place)).collect()
    }

    /// The gap between `sphere` and each of its floors, m.
    pub(super) fn heights_over_floors(
        &self,
        model: &Model,
        sphere: SphereId,
        pose: &DefaultPose,
    ) -> Result<Vec<(&ContactPlane, f64)>, PoseFault> {
        let Some((bottom, radius)) = centre_and_radius(model, sphere, pose)? else { return Ok(Vec::new()) };
        let gap = |surface: &PlaneSurface| (bottom - surface.point_m).dot(surface.normal) - radius;
        let places = self.by_sphere.get(&sphere).into_iter().flatten();
        let planes = places.filter_map(|&place| self.planes.get(place));
        Ok(planes.map(|(plane, surface)| (plane, gap(surface))).filter(|(_, gap)| gap.is_finite()).collect())
    }
}

/// The angle between `normal` and the axis of `body` that is up where the foot is flat, rad: the nearest axis; if the model lies, the
/// nearest one in the pose `before_lying`.
pub(super) fn tilt(
    (pose, before_lying): (&DefaultPose, Option<&DefaultPose>),
    body: &str,
    normal: DVec3,
) -> Result<f64, PoseFault> {
    let up = pose.direction_in(body, normal)?;
    let flat = before_lying.and_then(|pose| pose.direction_in(body, normal).ok()).unwrap_or(up);
    Ok(angle_between(nearest_axis(flat), up))
}

/// The axis that is nearest to `direction`.
pub(super) fn nearest_axis(direction: DVec3) -> DVec3 {
    let nearest = direction.to_array().map(f64::abs).into_iter().fold(0.0, f64::max);
    DVec3::from(direction.to_array().map(|part| if part.abs() == nearest { part.signum() } else { 0.0 }))
}

/// The centre of a sphere in ground, and its radius; `None` if one of these numbers cannot be read.
pub(super) fn centre_and_radius(
    model: &Model,
    sphere: SphereId,
    pose: &DefaultPose,
) -> Result<Option<(DVec3, f64)>, PoseFault> {
    let readable = model.sphere(sphere).zip(model.centre_m(sphere)).zip(model.round_radius_m(sphere).ok());
    let Some(((sphere, centre), radius)) = readable else { return Ok(None) };
    let Some(body) = sphere.body.as_deref() else { return Ok(None) };
    Ok(Some((pose.placement(body)?.point(centre), radius)))
}

// How deep spheres are where they carry a load.

/// The contact law with which the equilibrium of a body on its floor is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RestLaw {
    /// Hertz' law (1), without the smoothing of the force's class.
    Hertz,
    /// The contact law of the force's class, as OpenSim computes it.
    OfFile,
}

/// The equilibrium of a joint tree on some of its spheres under a load.
#[derive(Debug, Clone, PartialEq)]
pub struct RestOnFloor {
    /// The distance that the spheres move down along the normal from the default pose to the equilibrium, m; below 0 if they move up.
    pub down_m: f64,
    /// The load that the spheres carry along the normal, N.
    pub load_n: f64,
    /// The spheres with their depths and forces, in file order.
    pub spheres: Vec<RestingSphere>,
}

/// A sphere of a joint tree in equilibrium on its floor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RestingSphere {
    pub sphere: SphereId,
    /// Depth of the sphere in the floor over its radius: x/R; 0 or below if the sphere does not touch.
    pub relative_indentation: f64,
    /// Load of the sphere along the normal, N.
    pub force_n: f64,
}

impl RestLaw {
    /// Force of the sphere at speed 0, N.
    fn force(self, law: &Law, indentation_m: f64) -> f64 {
        match self {
            Self::Hertz => law.hertz().force(indentation_m),
            Self::OfFile => law.rest_force(indentation_m),
        }
    }
}

impl RestingSphere {
    /// Whether the sphere touches the floor. A smoothed law has a small force already before the touch, which does not count.
    pub fn touches(&self) -> bool {
        self.relative_indentation > 0.0
    }
}

impl RestOnFloor {
    /// The sphere with the largest depth relative to its radius.
    pub fn deepest(&self) -> Option<&RestingSphere> {
        let deeper = |a: &RestingSphere, b: &RestingSphere| {
            a.relative_indentation.total_cmp(&b.relative_indentation).then(b.sphere.cmp(&a.sphere))
        };
        self.spheres.iter().max_by(|a, b| deeper(a, b))
    }

    /// Whether each sphere carries its load at a depth less than its radius. The contact laws do not hold for deeper spheres.
    pub fn is_carried(&self) -> bool {
        self.deepest().is_some_and(|deepest| deepest.relative_indentation < 1.0)
    }

    /// The equilibrium at which `floor_contacts` together carry `load_n`. The contacts are in the order of their spheres; the lowest sphere
    /// is deepest.
    pub(super) fn of(
        floor_contacts: &[&FloorContact],
        load_n: f64,
        by: RestLaw,
    ) -> Result<Self, DomainError> {
        let lowest_m = floor_contacts.iter().map(|one| one.gap_m).fold(f64::INFINITY, f64::min);
        let mut raised = Vec::with_capacity(floor_contacts.len());
        for one in floor_contacts {
            let law = Law::of(&one.contact.contact, one.contact.radius_m)?;
            raised.push(RaisedSpheres::new(Spheres::new(law, 1.0)?, one.gap_m - lowest_m)?);
        }
        let deepest_m = match by {
            RestLaw::Hertz => hertz_indentation_of_lowest(&raised, load_n),
            RestLaw::OfFile => indentation_of_lowest(&raised, load_n),
        }?;
        let mut spheres: Vec<RestingSphere> = Vec::with_capacity(floor_contacts.len());
        for (one, raised) in floor_contacts.iter().zip(&raised) {
            let x = deepest_m - raised.height_m;
            let (sphere, force_n) = (one.contact.sphere, by.force(raised.spheres.law(), x));
            let relative_indentation = x / one.contact.radius_m;
            match spheres.last_mut().filter(|last| last.sphere == sphere) {
                Some(last) => {
                    last.force_n += force_n;
                    last.relative_indentation = last.relative_indentation.max(relative_indentation);
                }
                None => spheres.push(RestingSphere { sphere, relative_indentation, force_n }),
            }
        }
        Ok(Self { down_m: lowest_m + deepest_m, load_n, spheres })
    }
}
