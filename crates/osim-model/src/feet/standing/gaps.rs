//! How high the bottoms of spheres are over their floors, how deep they are where they carry a load, and where the spheres of a foot
//! have to be for their bottoms to be level.

use std::collections::BTreeSet;

use contact_scaling::equilibrium::{RaisedSpheres, hertz_indentation_of_lowest, indentation_of_lowest};
use contact_scaling::{DomainError, Law, Spheres};
use foldhash::{HashMap, HashMapExt, HashSet};
use glam::DVec3;

use crate::feet::contact_planes::{ContactPlane, PlaneSurface, STEEPEST_FLOOR_RAD};
use crate::feet::default_pose::DefaultPose;
use crate::feet::fault::PoseFault;
use crate::messages::{readable, shown};
use crate::model::{Fault, ForceId, Limb, LoadedSphere, Model, Placement, SphereId};

#[derive(Debug, Clone, PartialEq)]
pub struct SphereOverFloor {
    pub sphere: SphereId,
    /// Height of its bottom over its floor along the floor's normal, m; below 0 if it is in the floor. Of several floors the
    /// least.
    pub gap_m: f64,
    /// The angle between the floor's normal and the axis of the sphere's body that is nearest to it, rad: 0 if the body is upright.
    pub tilt_rad: f64,
}

/// A contact of a sphere with one plane: the law that a force gives it, and the gap to the plane.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FloorContact {
    pub(super) contact: LoadedSphere,
    pub(super) gap_m: f64,
}

/// Floors with the spheres that press on them, at the default pose.
pub(super) struct Floors {
    planes: Vec<(ContactPlane, PlaneSurface)>,
    by_sphere: HashMap<SphereId, Vec<usize>>,
}

impl Floors {
    /// The planes of the forces, without walls.
    pub(super) fn of(model: &Model, forces: &[ForceId], pose: &DefaultPose) -> Self {
        let planes = ContactPlane::all(model, forces, pose).into_iter();
        let planes: Vec<(ContactPlane, PlaneSurface)> = planes
            .filter_map(|plane| {
                Some((plane.surface.filter(|surface| surface.tilt_rad <= STEEPEST_FLOOR_RAD)?, plane))
            })
            .map(|(surface, plane)| (plane, surface))
            .collect();
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

    /// The floors of `spheres`, each once.
    pub(super) fn floors_under(&self, spheres: &[SphereId]) -> Vec<&(ContactPlane, PlaneSurface)> {
        let of_spheres = spheres.iter().filter_map(|sphere| self.by_sphere.get(sphere)).flatten();
        let places: BTreeSet<usize> = of_spheres.copied().collect();
        places.into_iter().filter_map(|place| self.planes.get(place)).collect()
    }

    /// How high `sphere` is over each of its floors.
    pub(super) fn gaps(
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

    /// The contacts of `loaded`, one with each floor among the `own` planes of its force, by their paths.
    pub(super) fn floor_contacts(
        loaded: &LoadedSphere,
        gaps: &[(&ContactPlane, f64)],
        own: &HashSet<String>,
    ) -> Vec<FloorContact> {
        let floor_contacts = |gap_m| FloorContact { contact: loaded.clone(), gap_m };
        gaps.iter()
            .filter(|(plane, _)| own.contains(&plane.path))
            .map(|(_, gap)| floor_contacts(*gap))
            .collect()
    }
}

/// The angle between `normal` and the axis of `body` that is nearest to it, rad.
pub(super) fn tilt(body: &Placement, normal: DVec3) -> f64 {
    let squares = body.rotation.inverse().to_body(normal).to_array().map(|part| part * part);
    let largest = squares.iter().copied().fold(0.0, f64::max);
    libm::atan2((squares.iter().sum::<f64>() - largest).max(0.0).sqrt(), largest.sqrt())
}

/// The centre of a sphere in ground, and its radius; `None` where a number of them cannot be read.
fn centre_and_radius(
    model: &Model,
    sphere: SphereId,
    pose: &DefaultPose,
) -> Result<Option<(DVec3, f64)>, PoseFault> {
    let readable = model.sphere(sphere).zip(model.centre_m(sphere)).zip(model.radius_m(sphere).ok());
    let Some(((sphere, centre), radius)) = readable else { return Ok(None) };
    let Some(body) = sphere.body.as_deref() else { return Ok(None) };
    Ok(Some((pose.placement(body)?.point(centre), radius)))
}

// How deep spheres are where they carry a load.

/// The law by which spheres rest.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[expect(clippy::exhaustive_enums, reason = "Hertz' law is under each law that a file can have")]
pub enum RestLaw {
    /// Hertz' law (1), without the smoothing of the class.
    Hertz,
    /// The law of the force's class, as OpenSim computes it.
    OfFile,
}

/// A joint tree at rest on some of its spheres.
#[derive(Debug, Clone, PartialEq)]
pub struct RestOnFloor {
    /// How far the spheres move down along the normal from the default pose to this rest, m; below 0 if they move up.
    pub down_m: f64,
    /// The load that they carry, along the normal, N.
    pub load_n: f64,
    /// Each sphere, in file order.
    pub spheres: Vec<RestingSphere>,
}

/// A sphere of a joint tree at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RestingSphere {
    pub sphere: SphereId,
    /// How deep it is in its floor, in its radius: x/R; not above 0 if it does not touch.
    pub relative_indentation: f64,
    /// What it carries along the normal, N.
    pub force_n: f64,
}

impl RestLaw {
    fn force(self, law: &Law, indentation_m: f64) -> f64 {
        match self {
            Self::Hertz => law.hertz().force(indentation_m),
            Self::OfFile => law.rest_force(indentation_m),
        }
    }
}

impl RestingSphere {
    /// Whether it touches the floor: what a smoothed law does before that is not counted.
    pub fn touches(&self) -> bool {
        self.relative_indentation > 0.0
    }
}

impl RestOnFloor {
    /// The sphere that is deepest, in its radius.
    pub fn deepest(&self) -> Option<&RestingSphere> {
        let deeper = |a: &RestingSphere, b: &RestingSphere| {
            a.relative_indentation.total_cmp(&b.relative_indentation).then(b.sphere.cmp(&a.sphere))
        };
        self.spheres.iter().max_by(|a, b| deeper(a, b))
    }

    /// Whether the spheres carry the load with each of them less deep than its radius: beyond that no law knows the sphere.
    pub fn is_carried(&self) -> bool {
        self.deepest().is_some_and(|deepest| deepest.relative_indentation < 1.0)
    }

    /// Where the contacts `floor_contacts`, in the order of their spheres, carry `load_n`: the lowest of them is deepest.
    pub(super) fn of(
        floor_contacts: &[&FloorContact],
        load_n: f64,
        by: RestLaw,
    ) -> Result<Self, DomainError> {
        let lowest_m = floor_contacts.iter().map(|one| one.gap_m).fold(f64::INFINITY, f64::min);
        let mut raised = Vec::new();
        for one in floor_contacts {
            let law = Law::of(&one.contact.contact, one.contact.radius_m)?;
            raised.push(RaisedSpheres::new(Spheres::new(law, 1.0)?, one.gap_m - lowest_m)?);
        }
        let deepest_m = match by {
            RestLaw::Hertz => hertz_indentation_of_lowest(&raised, load_n),
            RestLaw::OfFile => indentation_of_lowest(&raised, load_n),
        }?;
        let mut spheres: Vec<RestingSphere> = Vec::new();
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

/// Bodies that lean by more than this are posed so, rad: the pose moves their spheres, and not the foot.
pub const MOST_LEAN_RAD: f64 = 3.0 * std::f64::consts::PI / 180.0;
/// Bottoms this close are level, m: heights have rounding errors.
const ROUNDING_M: f64 = 1e-12;

/// A sphere that has to move for the bottoms of its foot to be level.
#[derive(Debug, Clone, PartialEq)]
pub struct LevelledSphere {
    pub sphere: SphereId,
    /// Its new centre in its own frame, m.
    pub location_m: [f64; 3],
}

/// Why the bottoms of feet cannot be made level.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NotLevelled {
    /// Which spheres are one foot's.
    #[error("the bottoms of a foot cannot be made level, because limbs are not known: {why}")]
    NoLimbs { why: String },
    /// No floor is under any of the spheres.
    #[error(
        "the bottoms of a foot cannot be made level, because no sphere presses on a floor that leans by less than 45 degrees"
    )]
    NoFloor,
    /// The foot does not lie flat.
    #[error(
        "the foot of limb {} leans by {} degrees at the default pose ({}): there the pose decides which of its spheres is low, and not \
         the foot; expected at most 3 degrees: set default values of its joints at which it lies flat",
        shown(limb), readable((degrees * 10.0).round() / 10.0), shown(sphere)
    )]
    Leans {
        limb: String,
        /// The sphere whose body leans most.
        sphere: String,
        degrees: f64,
    },
    /// Where bodies are at the default pose.
    #[error("the bottoms of a foot cannot be made level: {0}")]
    Pose(#[from] PoseFault),
    /// A frame that cannot be read.
    #[error("{0}")]
    Frame(Box<Fault>),
}

/// A sphere over its lowest floor.
struct OverLowestFloor {
    sphere: SphereId,
    gap_m: f64,
    normal: DVec3,
    tilt_rad: f64,
}

/// The spheres of `forces` that have to move for the bottoms of each limb to be as low as its lowest one at the default pose: along the
/// normal of its floor. Spheres that are level already are left out.
///
/// # Errors
/// Limbs, floors or the pose are not known, or a foot that would change leans by more than [`MOST_LEAN_RAD`].
pub fn levelled_spheres(model: &Model, forces: &[ForceId]) -> Result<Vec<LevelledSphere>, NotLevelled> {
    let limbs = model.limbs(forces);
    let limbs = limbs.if_known().ok_or_else(|| NotLevelled::NoLimbs {
        why: limbs.why_unknown().map(ToString::to_string).unwrap_or_default(),
    })?;
    let pose = DefaultPose::of(model);
    let floors = Floors::of(model, forces, &pose);
    if floors.spheres().is_empty() {
        return Err(NotLevelled::NoFloor);
    }
    let feet = LevelledFeet { model, floors: &floors, pose: &pose };
    let mut moved = Vec::new();
    for limb in limbs {
        moved.extend(feet.levelled_spheres(limb)?);
    }
    Ok(moved)
}

/// A model whose feet are made level.
struct LevelledFeet<'f> {
    model: &'f Model,
    floors: &'f Floors,
    pose: &'f DefaultPose,
}

impl LevelledFeet<'_> {
    fn levelled_spheres(&self, limb: &Limb) -> Result<Vec<LevelledSphere>, NotLevelled> {
        let spheres = limb.spheres.iter().filter_map(|&sphere| self.over(sphere).transpose());
        let spheres = spheres.collect::<Result<Vec<OverLowestFloor>, PoseFault>>()?;
        let lowest_m = spheres.iter().map(|over| over.gap_m).fold(f64::INFINITY, f64::min);
        let high: Vec<&OverLowestFloor> =
            spheres.iter().filter(|over| over.gap_m - lowest_m > ROUNDING_M).collect();
        if !high.is_empty() {
            self.refuse_leaning(limb, &spheres)?;
        }
        high.into_iter().map(|over| self.lowered(over, over.gap_m - lowest_m)).collect()
    }

    /// How a sphere is over the lowest of its floors; `None` if it is on none.
    fn over(&self, sphere: SphereId) -> Result<Option<OverLowestFloor>, PoseFault> {
        let gaps = self.floors.gaps(self.model, sphere, self.pose)?;
        let lowest = gaps.into_iter().reduce(|a, b| if b.1 < a.1 { b } else { a });
        let Some((normal, gap_m)) = lowest.and_then(|(plane, gap)| Some((plane.surface?.normal, gap))) else {
            return Ok(None);
        };
        let Some(body) = self.body(sphere) else { return Ok(None) };
        let tilt_rad = tilt(self.pose.placement(body)?, normal);
        Ok(Some(OverLowestFloor { sphere, gap_m, normal, tilt_rad }))
    }

    fn body(&self, sphere: SphereId) -> Option<&str> {
        self.model.sphere(sphere)?.body.as_deref()
    }

    fn refuse_leaning(&self, limb: &Limb, spheres: &[OverLowestFloor]) -> Result<(), NotLevelled> {
        let most = spheres.iter().reduce(|a, b| if b.tilt_rad > a.tilt_rad { b } else { a });
        match most.filter(|most| most.tilt_rad > MOST_LEAN_RAD) {
            None => Ok(()),
            Some(most) => Err(NotLevelled::Leans {
                limb: limb.name.clone(),
                sphere: self.model.sphere(most.sphere).map(|sphere| sphere.name.clone()).unwrap_or_default(),
                degrees: most.tilt_rad.to_degrees(),
            }),
        }
    }

    /// A sphere with its centre lower by `down_m` along the normal of its floor.
    fn lowered(&self, over: &OverLowestFloor, down_m: f64) -> Result<LevelledSphere, NotLevelled> {
        let sphere = over.sphere;
        let (model_sphere, body) =
            self.model.sphere(sphere).zip(self.body(sphere)).ok_or(NotLevelled::NoFloor)?;
        let frame =
            self.model.rotation_of(model_sphere).map_err(|fault| NotLevelled::Frame(Box::new(fault)))?;
        let in_body = self.pose.placement(body)?.rotation.inverse().to_body(over.normal);
        let normal = frame.inverse().to_body(in_body);
        let location_m = DVec3::from(model_sphere.location_m) - down_m * normal;
        Ok(LevelledSphere { sphere, location_m: location_m.to_array() })
    }
}
