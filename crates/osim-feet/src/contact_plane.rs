//! The planes that spheres press on, by the forces that apply, and where they are at the default pose.

use std::collections::{HashMap, HashSet};

use osim_model::{ElementId, FileId, ForceId, HalfSpace, Model, Sphere, SphereId};

use crate::default_pose::DefaultPose;
use crate::vector::angle;
use crate::welds::Welds;

/// A half-space that moving spheres press on: a floor, or a wall.
///
/// ```
/// use osim_feet::{ContactPlane, DefaultPose};
/// use osim_model::Model;
///
/// # let bytes: &[u8] = include_bytes!("../../osim-model/tests/data/one_foot.osim");
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
    /// Its name; in Moco 0.1 to 0.3 the name of the force that it is in.
    pub name: String,
    /// Component path.
    pub path: String,
    /// The file it is in.
    pub file: FileId,
    /// Line of its element, from 1.
    pub line: usize,
    /// The body that carries it; `None` is ground or a body in a file that was not given.
    pub body: Option<String>,
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
}

impl ContactPlane {
    /// The planes that moving spheres press on through an applied force among `forces`, in the order of the forces. A sphere presses
    /// on every plane of its forces, but for those of its own body and of bodies that are welded to it.
    #[must_use]
    pub fn all(model: &Model, forces: &[ForceId], pose: &DefaultPose) -> Vec<Self> {
        let joints = model.joints();
        let welds = Welds::of(&joints);
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
        pairing.planes.into_iter().map(|(plane, spheres)| Self::new(model, plane, spheres, pose)).collect()
    }

    fn new(model: &Model, plane: HalfSpace, spheres: Vec<SphereId>, pose: &DefaultPose) -> Self {
        let surface = PlaneSurface::of(model, &plane, pose);
        let HalfSpace { name, path, file, line, body, .. } = plane;
        Self { name, path, file, line, body, spheres, surface }
    }
}

impl PlaneSurface {
    fn of(model: &Model, plane: &HalfSpace, pose: &DefaultPose) -> Option<Self> {
        let (normal, point_m) = plane.normal.zip(plane.point_m)?;
        let (normal, point_m) = match &plane.body {
            Some(body) => {
                let there = pose.placement(body).ok()?;
                (there.rotation.to_body(normal), there.point(point_m))
            }
            None if plane.on_ground => (normal, point_m),
            None => return None,
        };
        let finite = point_m.iter().all(|value| value.is_finite());
        finite.then(|| Self { normal, point_m, tilt_rad: angle(normal, model.up()) })
    }
}

/// Planes with their spheres, as they are found.
#[derive(Default)]
struct Pairing {
    planes: Vec<(HalfSpace, Vec<SphereId>)>,
    index: HashMap<(FileId, ElementId), usize>,
    known: HashSet<(usize, SphereId)>,
}

impl Pairing {
    fn add(&mut self, plane: HalfSpace, spheres: Vec<SphereId>) {
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
        pressing.sort_unstable();
    }
}
