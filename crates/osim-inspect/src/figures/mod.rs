//! Computes what the contacts of a model do under its weight, such as indentation and stiffness. Each of these numbers is a figure in a
//! register.

mod compute;
mod register;
mod sphere_on_floor;

pub use register::{Figure, FigureVisibility, Figures, LimbFigures, LimitCheck, SphereFigures};
