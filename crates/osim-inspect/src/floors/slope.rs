//! Slopes: how steep a floor may be, and which part of the weight presses spheres on it.

use osim_model::feet::{ContactPlane, DefaultPose, STEEPEST_RAD};
use osim_model::{ForceId, Model, Orientation};

/// A floor that leans by no more than this, degrees, is level: 180 of 204 planes under spheres in published models are.
const LEVEL_DEGREES: f64 = 1.0;

/// How a plane lies in the field of gravity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Lie {
    /// Level, within a degree.
    Level,
    /// A slope of so many degrees.
    Slope(f64),
    /// Something stands or rolls on it by no means: it leans by so many degrees.
    Steep(f64),
}

impl Lie {
    /// That of `plane`; `None` where it is not known: a number cannot be read or is in another unit, or up is not known.
    pub(crate) fn of(model: &Model, plane: &ContactPlane) -> Option<Self> {
        let known = model.gravity().is_some_and(|size| size > 0.0 && size.is_finite());
        let in_degrees = plane.orientations.iter().any(Orientation::is_in_degrees);
        let surface = plane.surface.filter(|_| known && !in_degrees)?;
        Some(match surface.tilt_rad.to_degrees() {
            degrees if degrees <= LEVEL_DEGREES => Self::Level,
            degrees if surface.tilt_rad <= STEEPEST_RAD => Self::Slope(degrees),
            degrees => Self::Steep(degrees),
        })
    }
}

/// The part of the weight that presses the spheres of `forces` on their floor: the cosine of the angle of a slope, else 1. Where
/// they press on several floors, that of the least steep. On a plane that is not a floor nothing presses; once it is turned as it
/// should be, all of the weight does.
#[must_use]
pub fn weight_share(model: &Model, forces: &[ForceId]) -> f64 {
    weight_share_at(model, forces, &DefaultPose::of(model))
}

/// The same where the default pose is known.
pub(crate) fn weight_share_at(model: &Model, forces: &[ForceId], pose: &DefaultPose) -> f64 {
    let share = |plane: &ContactPlane| match Lie::of(model, plane) {
        Some(Lie::Slope(degrees)) => degrees.to_radians().cos(),
        _ => 1.0,
    };
    ContactPlane::all(model, forces, pose).iter().map(share).reduce(f64::max).unwrap_or(1.0)
}
