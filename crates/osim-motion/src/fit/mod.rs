//! Fits contact parameters and the height of the floor, so that the forces of a model are like those that plates measured.
//!
//! The unknowns are a factor for all stiffnesses, the dissipation, and for each trial the distance by which the floor moves up.
//! Instead of the floor of the first trial, all spheres may move down in their bodies. The fit makes the differences between
//! model and plates small: in the force along the normal of each foot, divided by body weight. At a given height and dissipation,
//! the force is proportional to the stiffness. The search tries some heights, and then runs Levenberg–Marquardt from the best of
//! them.

mod problem;
mod search;
mod solve;
mod trial;

pub use problem::{FitErrors, FitWanted, FittedHeight, FittedParameter, HeldOut, MotionFit};
pub use search::{FitBounds, FitError};
pub use solve::fit_motion;
pub use trial::{FitTrial, FootForces};
