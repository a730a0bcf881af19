//! How high the bottoms of spheres are over their floors.

use std::collections::BTreeSet;

use crate::model::{ForceId, LoadedSphere, Model, Placement, SphereId};
use foldhash::{HashMap, HashMapExt, HashSet};

use crate::feet::contact_plane::{ContactPlane, PlaneSurface, STEEPEST_RAD};
use crate::feet::default_pose::DefaultPose;
use crate::feet::pose_fault::PoseFault;
use crate::feet::vector::dot;

/// A sphere over a floor.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct OverFloor {
    /// The sphere.
    pub sphere: SphereId,
    /// Height of its bottom over its floor along the floor's normal, m; below 0 if it is in the floor. Of several floors the
    /// least.
    pub gap_m: f64,
    /// The angle between the floor's normal and the axis of the sphere's body that is nearest to it, rad: 0 if the body is upright.
    pub tilt_rad: f64,
}

/// A contact of a sphere with one plane: the law that a force gives it, and the gap to the plane.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Pressing {
    pub(super) contact: LoadedSphere,
    pub(super) gap_m: f64,
}

/// Floors with the spheres that press on them, at the default pose.
pub(super) struct Floors {
    planes: Vec<(ContactPlane, PlaneSurface)>,
    of_sphere: HashMap<SphereId, Vec<usize>>,
}

impl Floors {
    /// The planes of the forces, without walls.
    pub(super) fn of(model: &Model, forces: &[ForceId], pose: &DefaultPose) -> Self {
        let planes = ContactPlane::all(model, forces, pose).into_iter();
        let planes: Vec<(ContactPlane, PlaneSurface)> = planes
            .filter_map(|plane| {
                Some((plane.surface.filter(|surface| surface.tilt_rad <= STEEPEST_RAD)?, plane))
            })
            .map(|(surface, plane)| (plane, surface))
            .collect();
        let mut of_sphere: HashMap<SphereId, Vec<usize>> = HashMap::new();
        for (index, (plane, _)) in planes.iter().enumerate() {
            for &sphere in &plane.spheres {
                of_sphere.entry(sphere).or_default().push(index);
            }
        }
        Self { planes, of_sphere }
    }

    /// The spheres that press on floors, in file order.
    pub(super) fn spheres(&self) -> Vec<SphereId> {
        self.of_sphere.keys().copied().collect::<BTreeSet<_>>().into_iter().collect()
    }

    /// The floors of `spheres`, each once.
    pub(super) fn under(&self, spheres: &[SphereId]) -> Vec<&(ContactPlane, PlaneSurface)> {
        let of_spheres = spheres.iter().filter_map(|sphere| self.of_sphere.get(sphere)).flatten();
        let places: BTreeSet<usize> = of_spheres.copied().collect();
        places.into_iter().filter_map(|place| self.planes.get(place)).collect()
    }

    /// How high `sphere` is over each of its floors.
    ///
    /// # Errors
    /// It is not known where its body is.
    pub(super) fn gaps(
        &self,
        model: &Model,
        sphere: SphereId,
        pose: &DefaultPose,
    ) -> Result<Vec<(&ContactPlane, f64)>, PoseFault> {
        let Some((bottom, radius)) = centre(model, sphere, pose)? else { return Ok(Vec::new()) };
        let gap = |surface: &PlaneSurface| {
            let from_plane: [f64; 3] = std::array::from_fn(|axis| bottom[axis] - surface.point_m[axis]);
            dot(from_plane, surface.normal) - radius
        };
        let places = self.of_sphere.get(&sphere).into_iter().flatten();
        let planes = places.filter_map(|&place| self.planes.get(place));
        Ok(planes.map(|(plane, surface)| (plane, gap(surface))).filter(|(_, gap)| gap.is_finite()).collect())
    }

    /// The contacts of `loaded`, one with each floor among the `own` planes of its force, by their paths.
    pub(super) fn pressing(
        loaded: &LoadedSphere,
        gaps: &[(&ContactPlane, f64)],
        own: &HashSet<String>,
    ) -> Vec<Pressing> {
        let pressing = |gap_m| Pressing { contact: loaded.clone(), gap_m };
        gaps.iter().filter(|(plane, _)| own.contains(&plane.path)).map(|(_, gap)| pressing(*gap)).collect()
    }
}

/// The angle between `normal` and the axis of `body` that is nearest to it, rad.
pub(super) fn tilt(body: &Placement, normal: [f64; 3]) -> f64 {
    let squares = body.rotation.inverse().to_body(normal).map(|part| part * part);
    let largest = squares.iter().copied().fold(0.0, f64::max);
    libm::atan2((squares.iter().sum::<f64>() - largest).max(0.0).sqrt(), largest.sqrt())
}

/// The centre of a sphere in ground, and its radius; `None` where a number of them cannot be read.
fn centre(model: &Model, sphere: SphereId, pose: &DefaultPose) -> Result<Option<([f64; 3], f64)>, PoseFault> {
    let known = model.sphere(sphere).zip(model.centre_m(sphere)).zip(model.radius_m(sphere).ok());
    let Some(((sphere, centre), radius)) = known else { return Ok(None) };
    let Some(body) = sphere.body.as_deref() else { return Ok(None) };
    Ok(Some((pose.placement(body)?.point(centre), radius)))
}
