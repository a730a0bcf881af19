//! Which way is down for a sphere in its body, and which way is forward along the floor.

use osim_model::feet::{DefaultPose, PoseFault, ViewAxes, dot};
use osim_model::{Model, Side, cross};

use crate::pair::Touched;
use crate::states::ContactStates;

/// Limbs closer than this do not say what is right and left, m.
const APART_M: f64 = 1e-3;

/// Down for the sphere of each pair of `states`, as bodies stand at the default pose: a direction of length 1 in its body, into the floor.
///
/// # Errors
/// It is not known where a body is at the default pose.
pub(crate) fn down_at_default_pose(
    model: &Model,
    states: &ContactStates,
) -> Result<Vec<[f64; 3]>, PoseFault> {
    let pose = DefaultPose::of(model);
    let each = states.pairs.iter().map(|pair| {
        let normal = match pair.touched {
            Touched::Plane(plane) => states.planes.get(plane).and_then(|plane| plane.normal),
            Touched::Sphere(_) => None,
        };
        let up = normal.unwrap_or(model.up());
        Ok(pose.placement(&pair.body)?.rotation.inverse().to_body(up.map(|part| -part)))
    });
    each.collect()
}

/// From the middle of the left spheres to that of the right ones at the default pose, m; not finite where a side has none.
///
/// # Errors
/// It is not known where a body is at the default pose.
pub(crate) fn across(states: &ContactStates, pose: &DefaultPose) -> Result<[f64; 3], PoseFault> {
    let (mut sums, mut counts) = ([[0.0; 3]; 2], [0.0; 2]);
    for pair in &states.pairs {
        let Some(side) = Side::of_name(&pair.body) else { continue };
        let at_m = pose.placement(&pair.body)?.point(pair.centre_m);
        let place = usize::from(side == Side::Left);
        if let Some((sum, count)) = sums.get_mut(place).zip(counts.get_mut(place)) {
            *count += 1.0;
            sum.iter_mut().zip(at_m).for_each(|(sum, part)| *sum += part);
        }
    }
    let [right, left] = sums;
    Ok(std::array::from_fn(|i| right[i] / counts[0] - left[i] / counts[1]))
}

/// Forward along the floor at the default pose, of what is [`across`]: with the right spheres on the right of the left ones; x where nothing
/// says what is right.
pub(crate) fn forward(across: [f64; 3], up: [f64; 3]) -> [f64; 3] {
    let rises = dot(across, up);
    let flat: [f64; 3] = std::array::from_fn(|i| across[i] - rises * up[i]);
    let length = libm::sqrt(dot(flat, flat));
    // Also false where a side has no spheres.
    let is_known = length > APART_M;
    if is_known { cross(up, flat.map(|part| part / length)) } else { ViewAxes::with_up(up).forward }
}

/// The part of a direction along a floor, with length 1; the direction itself where it is upright.
pub(crate) fn level(direction: [f64; 3], up: [f64; 3]) -> [f64; 3] {
    let rises = dot(direction, up);
    let flat: [f64; 3] = std::array::from_fn(|i| direction[i] - rises * up[i]);
    let length = libm::sqrt(dot(flat, flat));
    if length > 1e-6 { flat.map(|part| part / length) } else { direction }
}
