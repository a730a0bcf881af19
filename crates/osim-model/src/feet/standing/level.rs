//! `--level`: moves the spheres of a foot so that all bottoms are as low as the lowest one.

use glam::DVec3;

use super::heights_over_floor::{SphereFloors, tilt};
use crate::feet::default_pose::DefaultPose;
use crate::feet::fault::PoseFault;
use crate::messages::{readable, shown};
use crate::model::{Fault, ForceId, Limb, Model, SphereId};

/// A foot that leans by more than this, rad, is not made level: its pose, not its spheres, makes some bottoms higher.
pub const MOST_LEAN_RAD: f64 = 3.0 * std::f64::consts::PI / 180.0;
/// Bottoms whose heights differ by at most this, m, are level: heights have rounding errors.
const LEVEL_TOLERANCE_M: f64 = 1e-12;

/// A sphere that is moved to make the bottoms of its foot level.
#[derive(Debug, Clone, PartialEq)]
pub struct LevelledSphere {
    pub sphere: SphereId,
    /// New centre of the sphere in its own frame, m.
    pub location_m: [f64; 3],
}

/// Why the bottoms of feet cannot be made level.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NotLevelled {
    /// It is not known which spheres belong to one foot.
    #[error("the spheres of a foot cannot be made level, because limbs are not known: {why}")]
    NoLimbs { why: String },
    /// None of the spheres presses on a floor.
    #[error(
        "the spheres of a foot cannot be made level, because no sphere presses on a floor that is tilted by less than 45 degrees"
    )]
    NoFloor,
    /// The foot leans at the default pose.
    #[error(
        "the foot of limb {} is tilted by {} degrees at the default pose ({}): there the lowest sphere depends on the pose, not on the shape of the foot; expected at most 3 degrees: set default values of its joints at which it lies flat",
        shown(limb), readable((degrees * 10.0).round() / 10.0), shown(sphere)
    )]
    Leans { limb: String, sphere: String, degrees: f64 },
    /// The places of bodies at the default pose are not known.
    #[error("the spheres of a foot cannot be made level: {0}")]
    Pose(#[from] PoseFault),
    #[error("{0}")]
    Frame(Box<Fault>),
}

/// A sphere and its gap to the lowest of its floors, with the normal of this floor.
struct SphereOverLowestFloor {
    sphere: SphereId,
    gap_m: f64,
    normal: DVec3,
    tilt_rad: f64,
}

/// The spheres of `forces` that have to move, with their new places. In each limb, the bottoms become as low as the lowest one at the
/// default pose; spheres move along the normal of their floor. Spheres that are level already are left out.
///
/// # Errors
/// Limbs, floors or the pose are not known, or a foot that is not level leans by more than [`MOST_LEAN_RAD`].
pub fn levelled_spheres(model: &Model, forces: &[ForceId]) -> Result<Vec<LevelledSphere>, NotLevelled> {
    let limbs = model.limbs(forces);
    let limbs = limbs.if_known().ok_or_else(|| NotLevelled::NoLimbs {
        why: limbs.why_unknown().map(ToString::to_string).unwrap_or_default(),
    })?;
    let pose = DefaultPose::of(model);
    let floors = SphereFloors::of(model, forces, &pose);
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

/// A model with its floors and pose, for making feet level.
struct LevelledFeet<'f> {
    model: &'f Model,
    floors: &'f SphereFloors,
    pose: &'f DefaultPose,
}

impl LevelledFeet<'_> {
    fn levelled_spheres(&self, limb: &Limb) -> Result<Vec<LevelledSphere>, NotLevelled> {
        let spheres = limb.spheres.iter().filter_map(|&sphere| self.over_lowest_floor(sphere).transpose());
        let spheres = spheres.collect::<Result<Vec<SphereOverLowestFloor>, PoseFault>>()?;
        let lowest_m = spheres.iter().map(|over| over.gap_m).fold(f64::INFINITY, f64::min);
        let high: Vec<&SphereOverLowestFloor> =
            spheres.iter().filter(|over| over.gap_m - lowest_m > LEVEL_TOLERANCE_M).collect();
        if !high.is_empty() {
            self.refuse_leaning(limb, &spheres)?;
        }
        high.into_iter().map(|over| self.lowered_sphere(over, over.gap_m - lowest_m)).collect()
    }

    /// The height of a sphere above the lowest of its floors; `None` for a sphere without a floor.
    fn over_lowest_floor(&self, sphere: SphereId) -> Result<Option<SphereOverLowestFloor>, PoseFault> {
        let gaps = self.floors.heights_over_floors(self.model, sphere, self.pose)?;
        let lowest = gaps.into_iter().reduce(|a, b| if b.1 < a.1 { b } else { a });
        let Some((normal, gap_m)) = lowest.and_then(|(plane, gap)| Some((plane.surface?.normal, gap))) else {
            return Ok(None);
        };
        let Some(body) = self.body(sphere) else { return Ok(None) };
        let before_lying = self.pose.before_lying(self.model, normal);
        let tilt_rad = tilt((self.pose, before_lying), body, normal)?;
        Ok(Some(SphereOverLowestFloor { sphere, gap_m, normal, tilt_rad }))
    }

    fn body(&self, sphere: SphereId) -> Option<&str> {
        self.model.sphere(sphere)?.body.as_deref()
    }

    fn refuse_leaning(&self, limb: &Limb, spheres: &[SphereOverLowestFloor]) -> Result<(), NotLevelled> {
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

    /// Moves the centre of a sphere down by `down_m` along the normal of its floor.
    fn lowered_sphere(
        &self,
        over: &SphereOverLowestFloor,
        down_m: f64,
    ) -> Result<LevelledSphere, NotLevelled> {
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
