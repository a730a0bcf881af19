//! Contact parameters from a measured indentation and force.

mod measured;
mod run;

pub use run::{FitResult, run_fit};
