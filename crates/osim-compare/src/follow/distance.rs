//! How far a joint is from the origin of a body, in two models.

use std::collections::HashMap;

use osim_model::{Anatomy, AnatomyJoint};

use super::body_factors::length;

/// A joint nearer to the body's origin than this does not show its size, m.
const SHORTEST_DISTANCE_M: f64 = 0.02;

/// Where a joint below a body is in both models, seen from the origin of the body at the default pose.
#[derive(Debug)]
pub(super) struct Distance<'a> {
    pub(super) joint: &'a str,
    /// In the reference, m.
    pub(super) old_m: [f64; 3],
    new_m: [f64; 3],
}

/// The joints of one name in both models, by the bodies on which they are in one of them.
pub(super) struct Distances<'a> {
    scaled: &'a Anatomy,
    reference: &'a Anatomy,
    on_body: HashMap<&'a str, Vec<[&'a AnatomyJoint; 2]>>,
}

impl<'a> Distances<'a> {
    pub(super) fn of(scaled: &'a Anatomy, reference: &'a Anatomy) -> Self {
        let mut on_body: HashMap<&str, Vec<[&AnatomyJoint; 2]>> = HashMap::new();
        for joint in &scaled.joints {
            let Some(there) = reference.joint(&joint.name) else { continue };
            on_body.entry(&joint.parent).or_default().push([joint, there]);
            if there.parent != joint.parent {
                on_body.entry(&there.parent).or_default().push([joint, there]);
            }
        }
        Self { scaled, reference, on_body }
    }

    /// The farthest joint of one name in both models that lies below `body` and is on it in one of them.
    pub(super) fn farthest(&self, body: &str) -> Option<Distance<'a>> {
        let places = self.on_body.get(body).into_iter().flatten().filter_map(|[joint, there]| {
            let old_m = self.reference.place_below(body, there)?;
            let new_m = self.scaled.place_below(body, joint)?;
            Some(Distance { joint: &joint.name, old_m, new_m })
        });
        let long = |m: [f64; 3]| length(m) >= SHORTEST_DISTANCE_M;
        places
            .filter(|place| long(place.old_m) && long(place.new_m))
            .max_by(|a, b| length(a.old_m).total_cmp(&length(b.old_m)))
    }
}

impl Distance<'_> {
    /// New over old.
    pub(super) fn ratio(&self) -> f64 {
        length(self.new_m) / length(self.old_m)
    }
}
