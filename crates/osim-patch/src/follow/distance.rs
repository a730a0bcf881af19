//! How far a joint is from the origin of a body, in two models.

use osim_model::Anatomy;

use super::body_factors::length;

/// A joint nearer to the body's origin than this says nothing about its size, m.
const SHORTEST_DISTANCE_M: f64 = 0.02;

/// Where a joint below a body is in both models, seen from the origin of the body at the default pose.
#[derive(Debug)]
pub(super) struct Distance<'a> {
    pub(super) joint: &'a str,
    /// In the reference, m.
    pub(super) old_m: [f64; 3],
    new_m: [f64; 3],
}

impl<'a> Distance<'a> {
    /// The farthest joint of one name in both models that lies below `body` and is on it in one of them.
    pub(super) fn of(scaled: &'a Anatomy, reference: &Anatomy, body: &str) -> Option<Self> {
        let places = scaled.joints.iter().filter_map(|joint| {
            let there = reference.joints.iter().find(|other| other.name == joint.name)?;
            if joint.parent != body && there.parent != body {
                return None;
            }
            let old_m = reference.place_below(body, there)?;
            let new_m = scaled.place_below(body, joint)?;
            Some(Self { joint: &joint.name, old_m, new_m })
        });
        let long = |m: [f64; 3]| length(m) >= SHORTEST_DISTANCE_M;
        places
            .filter(|place| long(place.old_m) && long(place.new_m))
            .max_by(|a, b| length(a.old_m).total_cmp(&length(b.old_m)))
    }

    /// New over old.
    pub(super) fn ratio(&self) -> f64 {
        length(self.new_m) / length(self.old_m)
    }
}
