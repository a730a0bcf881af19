//! Contact parameters and the height of the floor that make the forces of a model those that plates measured.
//!
//! The unknowns are a factor of all stiffnesses, the dissipation, and for each trial how far the floor moves up; instead of the first
//! floor, all spheres may go down in their bodies. Errors are those of the force along the normal of each foot, over body weight. With the
//! height and the dissipation given, the force is proportional to the stiffness; the rest is Levenberg–Marquardt from the best of some
//! heights.

mod data;
mod held_out;
mod lowered;
mod problem;
mod ranges;
mod result;
mod search;
mod solve;

pub use data::{FitTrial, FootForces};
pub use problem::{FitWanted, FittedHeight};
pub use result::{FitErrors, FittedParameter, HeldOut, MotionFit};
pub use search::{FitBounds, FitError};
pub use solve::fit_motion;
