//! The floor below a foot.

use crate::model::Model;

use crate::feet::vector::dot;

/// Floors that are this close are one.
const SAME_M: f64 = 1e-9;

/// Where the floor is.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum FloorPlace {
    /// The model has no level half-space on ground.
    None,
    /// All floors are at this height over the origin of ground, m.
    At(f64),
    /// There are floors at several heights over the origin of ground, m, the lowest first.
    Several(Vec<f64>),
    /// What is drawn is not in ground.
    NotInGround,
}

impl FloorPlace {
    /// The floor of a model.
    #[must_use]
    pub fn of(model: &Model) -> Self {
        let up = model.up();
        let mut heights: Vec<f64> = model.floors().iter().map(|plane| dot(plane.point_m, up)).collect();
        heights.sort_by(f64::total_cmp);
        heights.dedup_by(|a, b| (*a - *b).abs() <= SAME_M);
        match heights.as_slice() {
            [] => Self::None,
            [height] => Self::At(*height),
            _ => Self::Several(heights),
        }
    }
}
