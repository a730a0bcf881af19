//! What a model's contacts do under its weight.

mod compute;
mod data;
mod limb;
mod limit_check;
mod limits;
mod sphere_loads;

pub use data::{Figures, LimbFigures, LoadFigures, SphereFigures};
pub use limit_check::{Figure, LimitCheck};
