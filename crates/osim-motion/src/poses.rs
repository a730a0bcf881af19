//! Where bodies are along a recording, for those who look at it.

use std::collections::HashSet;

use osim_model::{Model, MovingPlacement, Placement};

use crate::recording::Recording;
use crate::skeleton::Skeleton;

/// Where bodies are in each frame of a recording, in ground.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Poses {
    /// The bodies whose place is known.
    pub bodies: Vec<String>,
    /// The place of each body in the first frame, then in the next.
    placements: Vec<Placement>,
}

impl Poses {
    /// All bodies of `model`, but for those on a joint that is not understood, in each of `frames`.
    #[must_use]
    pub fn of(model: &Model, recording: &Recording, frames: &[usize]) -> Self {
        let names = model.bodies().iter().map(|body| body.name.as_str());
        let known: Vec<&str> =
            names.filter(|&name| Skeleton::of(model, &HashSet::from([name])).is_ok()).collect();
        let mut poses =
            Self { bodies: known.iter().map(|&name| name.to_owned()).collect(), placements: Vec::new() };
        let Ok(skeleton) = Skeleton::of(model, &known.iter().copied().collect()) else { return poses };
        let numbers: Vec<usize> = known.iter().filter_map(|name| skeleton.body(name)).collect();
        let mut places = Vec::new();
        for &frame in frames {
            skeleton.place(
                recording.values(frame),
                recording.speeds(frame),
                &recording.of_opensim,
                &mut places,
            );
            let placed = |&number| {
                places.get(number).map_or(Placement::IDENTITY, |moving: &MovingPlacement| moving.at)
            };
            poses.placements.extend(numbers.iter().map(placed));
        }
        poses
    }

    /// The places of all bodies in a frame, by its number among those that were asked for.
    #[must_use]
    pub fn frame(&self, number: usize) -> &[Placement] {
        let start = number * self.bodies.len();
        self.placements.get(start..start + self.bodies.len()).unwrap_or_default()
    }
}
