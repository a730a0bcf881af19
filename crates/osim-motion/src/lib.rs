//! OpenSim models along a recorded motion: where their contact spheres are, and the forces there.
//!
//! A [`Table`] is a `.mot` or `.sto` file. A [`Recording`] has the values and speeds of a model's coordinates in each frame.
//! [`ContactStates`] are the places and forces of the spheres. All numbers are in SI units, and vectors are in ground.
//!
//! # What it will not do
//!
//! It opens no file and changes nothing. It enforces no constraints but couplers.
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod body_motions;
mod coordinates;
pub mod correct;
mod feet;
pub mod fit;
mod fit_data;
mod pair;
mod plate_assignment;
mod plate_comparison;
mod plates;
mod recording;
mod sole;
mod states;
mod summary;
mod table;

pub use crate::body_motions::Poses;
pub use crate::coordinates::{CoordinateKind, ModelCoordinate};
pub use crate::feet::{Foot, StancePhase, TOUCH_DOWN_BW, strides};
pub use crate::pair::{ContactPair, TouchedSurface};
pub use crate::plate_assignment::{AssignedBy, MeasuredForces, PlateAssignment};
pub use crate::plate_comparison::{Comparison, ComparisonPlane, LeftOutForces};
pub use crate::plates::{ExternalLoad, ExternalLoads, LONGEST_BRIDGED_GAP_S, Plate};
pub use crate::recording::{Recording, RecordingFacts, RecordingOptions};
pub use crate::sole::PressureOnSole;
pub use crate::states::{Belt, CentreOfPressure, ContactState, ContactStates, StatesError, Wrench};
pub use crate::summary::{FootSummary, SphereSummary, StanceSummary, Summary, TouchDown};
pub use crate::table::{AngleUnit, CORRECTED_HEADER_LINE, Column, Gap, MotionFault, Table, gaps};

/// The example of the README, which must compile.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
