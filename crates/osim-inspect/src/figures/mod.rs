//! What a model's contacts do under its weight, figure by figure.

mod answer;
mod bottoms;
mod compute;
mod data;
mod limb;
mod on_floor;
mod register;
mod shown;
mod sphere_loads;

pub use data::{Figures, LimbFigures, LimitCheck, SphereFigures};
pub use register::Figure;
pub use shown::Shown;
