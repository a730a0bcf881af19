//! The planes that spheres press on, by the forces that apply, and where they are at the default pose.

use std::ops::Deref;
use std::sync::Arc;

use crate::model::{ElementId, FileId, ForceId, HalfSpace, Model, Placement, Sphere, SphereId};
use foldhash::{HashMap, HashSet};

use crate::feet::default_pose::DefaultPose;
use crate::feet::vector::angle;
use crate::feet::welds::Welds;

/// A plane that leans by more than this is a wall, rad: 45 degrees. The steepest published slope has 20.5 degrees, and between that and
/// upright planes (90 degrees) there is none.
pub const STEEPEST_RAD: f64 = std::f64::consts::FRAC_PI_4;

/// A half-space that moving spheres press on: a floor, or a wall. It reads like its [`HalfSpace`].
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
#[non_exhaustive]
pub struct ContactPlane {
    /// The half-space: its name, path, line and body.
    pub plane: Arc<HalfSpace>,
    /// The spheres that press on it, each once, in file order.
    pub spheres: Vec<SphereId>,
    /// Where it is in ground; `None` where a number cannot be read, or where it is not known where its body is.
    pub surface: Option<PlaneSurface>,
}

/// Where a plane is in ground at the default pose.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct PlaneSurface {
    /// Its outward normal, of length 1.
    pub normal: [f64; 3],
    /// A point of it, m.
    pub point_m: [f64; 3],
    /// The angle between its normal and up, which is against gravity, rad: 0 for a level floor, π upside down.
    pub tilt_rad: f64,
    /// The half-space's own orientation, rad, with which it would be level.
    pub level_orientation: [f64; 3],
}

impl ContactPlane {
    /// The planes that moving spheres press on through an applied force among `forces`, in the order of the forces. A sphere presses
    /// on every plane of its forces, but for those of its own body and of bodies that are welded to it.
    #[must_use]
    pub fn all(model: &Model, forces: &[ForceId], pose: &DefaultPose) -> Vec<Self> {
        let welds = Welds::of(model.joints());
        let mut pairing = Pairing::default();
        for force in forces.iter().filter_map(|&id| model.force(id)).filter(|force| force.applies) {
            let spheres: Vec<&Sphere> =
                force.spheres().into_iter().filter_map(|id| model.sphere(id)).collect();
            for plane in model.planes_of(force) {
                let held = |body: &str| welds.hold(Some(body), plane.body.as_deref());
                let presses = |sphere: &&&Sphere| !sphere.fixed && !sphere.body.as_deref().is_some_and(held);
                let pressing = spheres.iter().filter(presses).map(|sphere| sphere.id).collect();
                pairing.add(plane, pressing);
            }
        }
        // Sorted once: after each force, it would be work that grows with their square.
        let sorted = pairing.planes.into_iter().map(|(plane, mut spheres)| {
            spheres.sort_unstable();
            (plane, spheres)
        });
        sorted.map(|(plane, spheres)| Self::new(model, plane, spheres, pose)).collect()
    }

    fn new(model: &Model, plane: Arc<HalfSpace>, spheres: Vec<SphereId>, pose: &DefaultPose) -> Self {
        let surface = PlaneSurface::of(model, &plane, pose);
        Self { plane, spheres, surface }
    }
}

impl Deref for ContactPlane {
    type Target = HalfSpace;

    fn deref(&self) -> &HalfSpace {
        &self.plane
    }
}

impl PlaneSurface {
    fn of(model: &Model, plane: &HalfSpace, pose: &DefaultPose) -> Option<Self> {
        let (normal, point_m) = plane.normal.zip(plane.point_m)?;
        let carrier = match &plane.body {
            Some(body) => *pose.placement(body).ok()?,
            None if plane.on_ground => Placement::IDENTITY,
            None => return None,
        };
        let (normal, point_m) = (carrier.rotation.to_body(normal), carrier.point(point_m));
        let level_orientation = plane.orientation_facing(carrier.rotation.inverse().to_body(model.up()))?;
        let finite = point_m.iter().all(|value| value.is_finite());
        finite.then(|| Self { normal, point_m, tilt_rad: angle(normal, model.up()), level_orientation })
    }
}

/// Planes with their spheres, as they are found.
#[derive(Default)]
struct Pairing {
    planes: Vec<(Arc<HalfSpace>, Vec<SphereId>)>,
    index: HashMap<(FileId, ElementId), usize>,
    known: HashSet<(usize, SphereId)>,
}

impl Pairing {
    fn add(&mut self, plane: Arc<HalfSpace>, spheres: Vec<SphereId>) {
        if spheres.is_empty() {
            return;
        }
        let key = (plane.file, plane.element);
        let index = *self.index.entry(key).or_insert(self.planes.len());
        if index == self.planes.len() {
            self.planes.push((plane, Vec::new()));
        }
        let Some((_, pressing)) = self.planes.get_mut(index) else { return };
        pressing.extend(spheres.into_iter().filter(|&sphere| self.known.insert((index, sphere))));
    }
}
