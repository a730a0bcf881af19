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

pub use crate::assigned::{AssignedBy, Measured, PlateUse};
pub use crate::comparison::{ComparedOn, Comparison, LeftOut};
pub use crate::coordinates::{CoordinateKind, ModelCoordinate};
pub use crate::feet::{Foot, ON_BW, Stance, strides};
pub use crate::pair::{ContactPair, Touched};
pub use crate::plates::{ExternalLoads, Load, Plate};
pub use crate::recording::{Recording, RecordingFacts, RecordingOptions};
pub use crate::skeleton::Poses;
pub use crate::sole::OnSole;
pub use crate::states::{Belt, ContactState, ContactStates, StatesError};
pub use crate::summary::{FootSummary, SphereSummary, StanceSummary, Summary, TouchDown};
pub use crate::table::{AngleUnit, Column, Gap, MotionFault, Table};
pub use crate::wrench::{CentreOfPressure, Wrench};

/// The example of the README compiles.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
