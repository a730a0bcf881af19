//! What a model's contacts do under its weight, figure by figure.

mod compute;
mod on_floor;
mod register;

pub use register::{Figure, FigureVisibility, Figures, LimbFigures, LimitCheck, SphereFigures};
