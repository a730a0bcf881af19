//! Contact parameters and the height of the floor that make the forces of a model those that plates measured.
//!
//! The unknowns are a factor of all stiffnesses, the dissipation, and for each trial how far the floor moves up; instead of the first
//! floor, all spheres may go down in their bodies. Errors are those of the force along the normal of each foot, over body weight. With the
//! height and the dissipation given, the force is proportional to the stiffness; the rest is Levenberg–Marquardt from the best of some
//! heights.

mod problem;
mod search;
mod solve;
mod trial;

pub use problem::{FitErrors, FitWanted, FittedHeight, FittedParameter, HeldOut, MotionFit};
pub use search::{FitBounds, FitError};
pub use solve::fit_motion;
pub use trial::{FitTrial, FootForces};
