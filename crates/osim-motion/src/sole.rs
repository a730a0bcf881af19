//! Which way is down and ahead for the spheres of a foot, in their own bodies.

use osim_feet::{DefaultPose, PoseFault, ViewAxes, dot};
use osim_model::{Model, Rotation};

use crate::pair::Touched;
use crate::states::ContactStates;

/// Directions of length 1 in the body of a sphere: as the body stands at the default pose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SoleAxes {
    /// Into the floor.
    pub down: [f64; 3],
    /// Along the floor, forward.
    pub ahead: [f64; 3],
}

impl SoleAxes {
    /// Those of each pair of `states`.
    ///
    /// # Errors
    /// It is not known where a body is at the default pose.
    pub fn of(model: &Model, states: &ContactStates) -> Result<Vec<Self>, PoseFault> {
        let pose = DefaultPose::of(model);
        let up = model.up();
        let each = states.pairs.iter().map(|pair| {
            let up = match pair.touched {
                Touched::Plane(plane) => {
                    states.planes.get(plane).and_then(|plane| plane.normal).unwrap_or(up)
                }
                Touched::Sphere(_) => up,
            };
            let to_body: Rotation = pose.placement(&pair.body)?.rotation.inverse();
            let down = to_body.to_body(up.map(|part| -part));
            Ok(Self { down, ahead: to_body.to_body(level(ViewAxes::of(model).forward, up)) })
        });
        each.collect()
    }
}

/// The part of a direction along a floor, with length 1; the direction itself where it is upright.
pub(crate) fn level(direction: [f64; 3], up: [f64; 3]) -> [f64; 3] {
    let rises = dot(direction, up);
    let flat: [f64; 3] = std::array::from_fn(|i| direction[i] - rises * up[i]);
    let length = libm::sqrt(dot(flat, flat));
    if length > 1e-6 { flat.map(|part| part / length) } else { direction }
}
