//! Contact parameters and the height of the floor that make the forces of a model those that plates measured.
//!
//! The unknowns are a factor of all stiffnesses, the dissipation, and for each trial how far the floor moves up. Errors are those of
//! the force along the normal of each foot, over body weight. With the height and the dissipation given, the force is proportional to
//! the stiffness; the rest is Levenberg–Marquardt from the best of some heights.

mod answers;
mod data;
mod held_out;
mod problem;
mod ranges;
mod refine;
mod result;
mod search;
mod solve;

pub use data::{FitTrial, FootForces};
pub use problem::FitWanted;
pub use result::{FitErrors, FittedParameter, HeldOut, MotionFit, MovedSphere, SlackUsed};
pub use search::{FitBounds, FitError};
pub use solve::fit_motion;
