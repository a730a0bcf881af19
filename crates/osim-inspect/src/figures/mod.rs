//! What a model's contacts do under its weight, figure by figure.

mod answer;
mod compute;
mod data;
mod figure;
mod limb;
mod on_floor;
mod register;
mod sphere_loads;

pub use data::{Figures, LimbFigures, LimitCheck, SphereFigures};
pub use figure::{FigureInfo, Shown};
pub use register::Figure;
