//! Whether two feet are posed as mirror images of each other.

use crate::model::{Model, Placement, without_side};

use crate::feet::default_pose::DefaultPose;
use crate::feet::sole::Sole;
use crate::feet::vector::angle;

/// Frames of left bodies are mirror images of those of right ones along one of their axes: nearly always z.
const MIRRORS: [[f64; 3]; 3] = [[1.0, 1.0, -1.0], [1.0, -1.0, 1.0], [-1.0, 1.0, 1.0]];

impl Sole {
    /// By how much the poses of this foot and `other` differ from mirror images of each other at the default pose of `model`, rad: the
    /// largest angle between where one's body sees up, or the way to the other foot, and the mirror image of where the other's body
    /// sees it. `None` unless they are the feet of both sides and have a body in common.
    #[must_use]
    pub fn posed_unlike(&self, other: &Self, model: &Model) -> Option<f64> {
        (self.side? != other.side?).then_some(())?;
        let pose = DefaultPose::of(model);
        let pair = |body: &String| {
            let counterpart = other.bodies.iter().find(|other| without_side(other) == without_side(body))?;
            Some((pose.placement(body).ok()?, pose.placement(counterpart).ok()?))
        };
        let seen = |own: &Placement, there: &Placement, direction: [f64; 3], mirrored: [f64; 3]| {
            (own.rotation.inverse().to_body(direction), there.rotation.inverse().to_body(mirrored))
        };
        let pairs: Vec<_> = self.bodies.iter().filter_map(pair).collect();
        let up = pairs.iter().map(|(own, there)| seen(own, there, self.up, other.up));
        // One way from foot to foot is enough: where a foot is turned, its foremost body is elsewhere, too.
        let across = pairs.first().map(|(own, there)| {
            let outwards: [f64; 3] = std::array::from_fn(|i| own.translation_m[i] - there.translation_m[i]);
            seen(own, there, outwards, outwards.map(|value| -value))
        });
        let seen: Vec<_> = up.chain(across).collect();
        let apart = |mirror: [f64; 3]| {
            let mirrored = |there: [f64; 3]| std::array::from_fn(|i| mirror[i] * there[i]);
            seen.iter().map(|(own, there)| angle(*own, mirrored(*there))).fold(0.0, f64::max)
        };
        (!seen.is_empty()).then(|| MIRRORS.into_iter().map(apart).fold(f64::INFINITY, f64::min))
    }
}
