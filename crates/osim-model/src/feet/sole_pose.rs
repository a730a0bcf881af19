//! How feet are posed by default: whether their soles lie flat, and whether left and right are posed alike.

use glam::DVec3;

use super::couplers::CoordinateValues;
use super::default_pose::DefaultPose;
use super::sole::Sole;
use crate::messages::{readable, shown};
use crate::model::angle_between;
use crate::model::{Model, ModelJoint, Placement, without_side};

/// A coordinate that tilts a foot by less than this is ignored, rad: 0.3 degrees.
const LEAST_TILT_RAD: f64 = 0.005;
/// The largest number of coordinates that a message names.
const MOST_COORDINATES_NAMED: usize = 4;
/// The largest number of joints on the path from a body to ground.
const MOST_JOINTS: usize = 64;

/// A coordinate whose default value tilts a foot against the ground.
#[derive(Debug, Clone, PartialEq)]
pub struct TiltingCoordinate {
    /// Name of the coordinate, such as `ankle_angle_r`.
    pub name: String,
    /// Value of the coordinate at the default pose, rad.
    pub value: f64,
}

impl Sole {
    /// The coordinates of `model` whose default values tilt the foot or a part of it, beginning at the foot.
    pub fn tilting_coordinates(&self, model: &Model) -> Vec<TiltingCoordinate> {
        let joints = model.joints();
        let coordinates = CoordinateValues::at_default_pose(model);
        let pose = DefaultPose::of(model);
        let mut tilting: Vec<TiltingCoordinate> = Vec::new();
        for joint in self.joints_above(joints) {
            let values: Option<Vec<f64>> =
                joint.coordinates.iter().map(|one| coordinates.values.get(&one.name).copied()).collect();
            let Some(values) = values else { continue };
            let parent = match &joint.parent {
                Some(body) => pose.placement(body).copied().unwrap_or(Placement::IDENTITY),
                None => Placement::IDENTITY,
            };
            let up = |values: &[f64]| {
                let placed = parent.then(&joint.placement(model, values)?);
                Some(placed.rotation.inverse().to_body(self.up))
            };
            for (index, coordinate) in joint.coordinates.iter().enumerate() {
                let mut without = values.clone();
                let Some(value) = without.get_mut(index).map(std::mem::take) else { continue };
                let tilts =
                    up(&values).zip(up(&without)).is_some_and(|(a, b)| a.distance(b) > LEAST_TILT_RAD);
                if tilts && !tilting.iter().any(|known| known.name == coordinate.name) {
                    tilting.push(TiltingCoordinate { name: coordinate.name.clone(), value });
                }
            }
        }
        tilting
    }

    /// Describes the tilt of a foot that does not lie flat at the default pose; `None` for a flat foot.
    pub fn describe_tilt(&self) -> Option<String> {
        let print = &self.footprint;
        if print.is_flat() {
            return None;
        }
        let tilt = |what: &str, tilt: f64| {
            let degrees = format!("{:.1} degrees", tilt.abs().to_degrees());
            format!("its {what} is {degrees} {}", if tilt < 0.0 { "down" } else { "up" })
        };
        let tilt = match print.pitch_rad.abs() >= print.roll_rad.abs() {
            true => tilt("front", print.pitch_rad),
            false => tilt("outer side", print.roll_rad),
        };
        let percent = |share: f64| format!("{:.0} %", 100.0 * share);
        let bodies: Vec<String> = self.bodies.iter().map(|body| shown(body).to_string()).collect();
        Some(format!(
            "the foot of {} does not lie flat at the default pose: {tilt}, and bones near the ground cover {} of its length and {} \
             of its width, expected at most 10 degrees, and 80 % or more",
            bodies.join(", "),
            percent(print.share_of_length),
            percent(print.share_of_width),
        ))
    }

    /// The joints of the foot's bodies, then the joints above them.
    fn joints_above<'j>(&self, joints: &'j [ModelJoint]) -> Vec<&'j ModelJoint> {
        let above = |body: &str| joints.iter().find(|joint| joint.child.as_deref() == Some(body));
        let mut upwards: Vec<&ModelJoint> = self.bodies.iter().filter_map(|body| above(body)).collect();
        for start in upwards.clone() {
            let mut at = start;
            while let Some(next) = at.parent.as_deref().and_then(above)
                && !upwards.iter().any(|known| std::ptr::eq(*known, next))
                && upwards.len() <= MOST_JOINTS
            {
                upwards.push(next);
                at = next;
            }
        }
        upwards
    }
}

impl TiltingCoordinate {
    /// The names and values of coordinates for a sentence: `ankle_angle_r = 0.2 rad`. Only the first of many are named.
    pub fn listed(all: &[Self]) -> String {
        let one = |own: &Self| format!("{} = {} rad", shown(&own.name), readable(own.value));
        let mut named: Vec<String> = all.iter().take(MOST_COORDINATES_NAMED).map(one).collect();
        if all.len() > MOST_COORDINATES_NAMED {
            named.push(format!("{} more", all.len() - MOST_COORDINATES_NAMED));
        }
        named.join(", ")
    }
}

// Whether two feet are posed as mirror images of each other.

/// The axis of mirroring, one of x, y and z: the frame of a left body is the mirror image of the right body's frame along one of its axes,
/// nearly always z.
const MIRROR_FACTORS: [DVec3; 3] =
    [DVec3::new(1.0, 1.0, -1.0), DVec3::new(1.0, -1.0, 1.0), DVec3::new(-1.0, 1.0, 1.0)];

impl Sole {
    /// The angle by which the pose of this foot differs from the mirror image of the `other` foot at the default pose of `model`, rad. In
    /// the frames of the feet, two directions are compared: up, and towards the other foot. The larger angle counts. `None` if a pose is
    /// not known.
    pub fn pose_asymmetry(&self, other: &Self, model: &Model) -> Option<f64> {
        (self.side? != other.side?).then_some(())?;
        let pose = DefaultPose::of(model);
        let pair = |body: &String| {
            let counterpart = other.bodies.iter().find(|other| without_side(other) == without_side(body))?;
            Some((pose.placement(body).ok()?, pose.placement(counterpart).ok()?))
        };
        let seen = |own: &Placement, there: &Placement, direction: DVec3, mirrored: DVec3| {
            (own.rotation.inverse().to_body(direction), there.rotation.inverse().to_body(mirrored))
        };
        let pairs: Vec<_> = self.bodies.iter().filter_map(pair).collect();
        let up = pairs.iter().map(|(own, there)| seen(own, there, self.up, other.up));
        // One way from foot to foot is enough: where a foot is turned, its foremost body is elsewhere, too.
        let across = pairs.first().map(|(own, there)| {
            let outwards = own.translation_m - there.translation_m;
            seen(own, there, outwards, -outwards)
        });
        let seen: Vec<_> = up.chain(across).collect();
        let apart = |mirror: DVec3| {
            seen.iter().map(|(own, there)| angle_between(*own, mirror * *there)).fold(0.0, f64::max)
        };
        (!seen.is_empty()).then(|| MIRROR_FACTORS.into_iter().map(apart).fold(f64::INFINITY, f64::min))
    }
}
