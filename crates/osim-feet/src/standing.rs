//! Whether the spheres of a model are near its floor at the default pose.

use osim_model::{Model, ModelJoint};

use crate::default_pose::DefaultPose;
use crate::pose_fault::PoseFault;
use crate::scene::FloorPlace;

/// A movement that is this close to straight up, and no turn, is one along the vertical (per metre).
const STRAIGHT: f64 = 1e-9;

/// A sphere on a body.
#[derive(Debug, Clone, PartialEq)]
pub struct PlacedSphere<'s> {
    /// Its name.
    pub name: &'s str,
    /// The body that carries it.
    pub body: &'s str,
    /// Its centre in the frame of that body, m.
    pub centre_m: [f64; 3],
    /// Its radius, m.
    pub radius_m: f64,
}

/// The coordinate that lifts the whole model.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct VerticalCoordinate {
    /// Its name, such as `pelvis_ty`.
    pub name: String,
    /// Its value at the default pose, m.
    pub default_m: f64,
    /// Its value at which the lowest sphere just touches the floor, m.
    pub touching_m: f64,
}

/// How far the spheres of a model are from its floor at the default pose, along the vertical.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Standing {
    /// The sphere whose bottom is lowest.
    pub lowest: String,
    /// Height of that bottom above the floor, m; below 0 where it is in the floor.
    pub gap_m: f64,
    /// How much higher the highest bottom is, m.
    pub spread_m: f64,
    /// The coordinate that puts it on the floor; `None` where no single one lifts the whole model.
    pub coordinate: Option<VerticalCoordinate>,
}

impl Standing {
    /// The distance of the `spheres` of `model`; `None` if there is no sphere, or not exactly one floor.
    ///
    /// # Errors
    /// It is not known where a body is at the default pose.
    pub fn of(model: &Model, spheres: &[PlacedSphere<'_>]) -> Result<Option<Self>, PoseFault> {
        let FloorPlace::At(floor_m) = FloorPlace::of(model) else { return Ok(None) };
        let up = model.up();
        let joints = model.joints();
        let pose = DefaultPose::of_joints(model, &joints);
        let mut bottoms = Vec::new();
        for sphere in spheres {
            let centre = pose.placement(sphere.body)?.point(sphere.centre_m);
            bottoms.push((along(centre, up) - sphere.radius_m - floor_m, sphere));
        }
        bottoms.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        let (Some(&(gap_m, lowest)), Some(&(highest_m, _))) = (bottoms.first(), bottoms.last()) else {
            return Ok(None);
        };
        let mut coordinate = vertical(model, &joints, up);
        if let Some(found) = &mut coordinate {
            found.touching_m = found.default_m - gap_m;
        }
        Ok(Some(Self { lowest: lowest.name.to_owned(), gap_m, spread_m: highest_m - gap_m, coordinate }))
    }
}

fn along(point: [f64; 3], up: [f64; 3]) -> f64 {
    point.iter().zip(up).map(|(a, b)| a * b).sum()
}

/// The coordinate of the only joint to ground that moves its body straight up, as much as the coordinate.
fn vertical(model: &Model, joints: &[ModelJoint], up: [f64; 3]) -> Option<VerticalCoordinate> {
    let mut to_ground = joints.iter().filter(|joint| joint.parent.is_none() || joint.child.is_none());
    let joint = to_ground.next().filter(|joint| joint.parent.is_none())?;
    if to_ground.next().is_some() {
        return None;
    }
    let values: Vec<f64> =
        joint.coordinates.iter().map(|coordinate| coordinate.default).collect::<Option<_>>()?;
    let found =
        joint.coordinates.iter().enumerate().find(|(index, _)| lifts(model, joint, &values, *index, up))?;
    let (index, coordinate) = found;
    let default_m = *values.get(index)?;
    Some(VerticalCoordinate { name: coordinate.name.clone(), default_m, touching_m: default_m })
}

/// Whether a metre more of the coordinate at `index` is a metre up for every point of the body.
fn lifts(model: &Model, joint: &ModelJoint, values: &[f64], index: usize, up: [f64; 3]) -> bool {
    let mut lifted = values.to_vec();
    let Some(value) = lifted.get_mut(index) else { return false };
    *value += 1.0;
    let (Some(here), Some(there)) = (joint.placement(model, values), joint.placement(model, &lifted)) else {
        return false;
    };
    [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].into_iter().all(|point| {
        let (from, to) = (here.point(point), there.point(point));
        (0..3).all(|axis| (to[axis] - from[axis] - up[axis]).abs() <= STRAIGHT)
    })
}
