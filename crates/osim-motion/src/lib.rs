//! OpenSim models along a recorded motion: where their contact spheres are, and the forces there.
//!
//! A [`Table`] is a `.mot` or `.sto` file; a [`Recording`] has the values and speeds of a model's coordinates in each of its frames;
//! [`ContactStates`] are the spheres and forces that follow. All numbers are in SI units and seen from ground.
//!
//! # What it will not do
//!
//! It opens no file and changes nothing. It enforces no constraints but couplers.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod assigned;
mod comparison;
mod coordinates;
mod fault;
mod feet;
pub mod fit;
mod pair;
mod plates;
mod recording;
mod skeleton;
mod sole;
mod states;
mod summary;
mod table;
mod wrench;

pub use assigned::{AssignedBy, Measured, PlateUse};
pub use comparison::{ComparedOn, Comparison, LeftOut};
pub use coordinates::{CoordinateKind, ModelCoordinate};
pub use fault::MotionFault;
pub use feet::{Foot, ON_BW, Stance, strides};
pub use pair::{ContactPair, Touched};
pub use plates::{ExternalLoads, Load, Plate};
pub use recording::{Recording, RecordingFacts, RecordingOptions};
pub use skeleton::Poses;
pub use sole::OnSole;
pub use states::{Belt, ContactState, ContactStates, StatesError};
pub use summary::{FootSummary, SphereSummary, StanceSummary, Summary, TouchDown};
pub use table::{AngleUnit, Column, Gap, Table};
pub use wrench::{CentreOfPressure, Wrench};

/// The example of the README compiles.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
