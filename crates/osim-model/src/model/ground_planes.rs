//! Half-spaces on ground: which of them is the floor.

use crate::model::typed_model::Model;

/// How far the normal of a floor may be from up (length of the difference of unit vectors).
const LEVEL: f64 = 1e-6;

/// A half-space that is fixed to ground.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct GroundPlane {
    /// Its name; in Moco 0.1 to 0.3 the name of the force that it is in.
    pub name: String,
    /// A point of its surface in ground, m.
    pub point_m: [f64; 3],
    /// Its normal in ground, out of what is solid: −x of its own frame.
    pub normal: [f64; 3],
}

impl Model {
    /// The half-spaces on ground, in file order.
    #[must_use]
    pub fn ground_planes(&self) -> Vec<GroundPlane> {
        let all = self.half_spaces().into_iter().chain(self.half_spaces_inside());
        let planes = all.filter(|plane| plane.on_ground);
        planes
            .filter_map(|plane| {
                Some(GroundPlane { name: plane.name, point_m: plane.point_m?, normal: plane.normal? })
            })
            .collect()
    }

    /// The planes whose normal is up, against gravity: floors.
    #[must_use]
    pub fn floors(&self) -> Vec<GroundPlane> {
        let up = self.up();
        let off = |plane: &GroundPlane| (0..3).map(|i| (plane.normal[i] - up[i]).powi(2)).sum::<f64>();
        self.ground_planes().into_iter().filter(|plane| off(plane) <= LEVEL * LEVEL).collect()
    }

    /// The direction against gravity in ground, of length 1; y without gravity.
    #[must_use]
    pub fn up(&self) -> [f64; 3] {
        let gravity = self.gravity_m_s2.unwrap_or_default();
        match self.gravity().filter(|&gravity| gravity > 0.0) {
            Some(length) => gravity.map(|value| -value / length),
            None => [0.0, 1.0, 0.0],
        }
    }
}
