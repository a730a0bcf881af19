//! Spheres of one force that could touch each other.

use crate::model::{Force, Model, Sphere, SphereId};

use crate::feet::default_pose::DefaultPose;

/// Two spheres on different bodies that one force lets touch each other.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct SpherePair {
    /// The first in the force's order.
    pub one: SphereId,
    /// The other.
    pub other: SphereId,
    /// The gap between them at the default pose, m, not above 0 where they touch; or why it is not known.
    pub gap_m: Result<f64, String>,
}

/// The pairs of `force`, with their gaps at the default `pose` of `model`. Forces of one sphere have none.
///
/// ```
/// use osim_model::feet::{DefaultPose, sphere_pairs};
/// use osim_model::Model;
///
/// # let bytes: &[u8] = include_bytes!("../../tests/data/one_foot.osim");
/// let model = Model::parse(bytes)?;
/// // One foot, one sphere.
/// assert!(sphere_pairs(&model, &DefaultPose::of(&model), &model.forces()[0]).is_empty());
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[must_use]
pub fn sphere_pairs(model: &Model, pose: &DefaultPose, force: &Force) -> Vec<SpherePair> {
    let spheres: Vec<&Sphere> = force.spheres().into_iter().filter_map(|id| model.sphere(id)).collect();
    let mut pairs = Vec::new();
    if spheres.windows(2).all(|two| matches!(two, [one, other] if one.body == other.body)) {
        return pairs;
    }
    for (index, one) in spheres.iter().enumerate() {
        let others = spheres.iter().skip(index + 1).filter(|other| other.body != one.body);
        pairs.extend(others.map(|other| SpherePair {
            one: one.id,
            other: other.id,
            gap_m: gap_m(model, pose, one, other),
        }));
    }
    pairs
}

fn gap_m(model: &Model, pose: &DefaultPose, one: &Sphere, other: &Sphere) -> Result<f64, String> {
    let (a, b) = (centre_m(model, pose, one)?, centre_m(model, pose, other)?);
    let distance = a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    let radius = |sphere: &Sphere| sphere.radius_m().map_err(|fault| fault.to_string());
    Ok(distance - radius(one)? - radius(other)?)
}

/// The centre of `sphere` in ground.
fn centre_m(model: &Model, pose: &DefaultPose, sphere: &Sphere) -> Result<[f64; 3], String> {
    let unread = || format!("the place of {} cannot be read", sphere.path);
    let place = model.centre_m(sphere.id).ok_or_else(unread)?;
    match &sphere.body {
        None => Ok(place),
        Some(body) => Ok(pose.placement(body).map_err(|fault| fault.to_string())?.point(place)),
    }
}
